// SPDX-License-Identifier: MIT
#ifndef BRINK_CONVENTIONAL_H
#define BRINK_CONVENTIONAL_H
/**
 * A loop for the methods that are only there to be compared with.
 *
 * All of them live in the same house as a run: its system, cells and calendar,
 * the kernels' event times and impulses, and this one loop, which asks the
 * method's rule at three places.  What one sees is due to the rule alone. Nothing
 * but the study and its tests comes here.
 */
#include "conventional_method.h"

/** So many events running, of one pair and at one instant, and time stands still:
 * a pair that is alive needs two or three to get away from a step. */
#define BRINK_STANDSTILL 1000

typedef struct brink_conventional {
    brink_run house; // its `states` hold what the method claims after each event
    const brink_rule *rule;
    int *seen; // per particle: the level its next pair event was predicted for
    uint32_t still; // events running of the same pair at the same instant
} brink_conventional;

/** As brink_run_create: takes over the system.  The rule, brink_method_rule's or
 *  another, must outlive it.  0, -1 no memory. */
int brink_conventional_create(brink_conventional *c, brink_system *system,
                              const brink_rule *rule);
/** The same around a run, which is taken over, without levels told and events
 * predicted: the caller fills seen, still and the calendar in, whose slot i waits
 * for a pair event of particle i and slot count + i for its crossing. */
int brink_conventional_assemble(brink_conventional *c, brink_run *run,
                                const brink_rule *rule);
void brink_conventional_destroy(brink_conventional *c);

/** Goes on until `events` events in all, unless it stops before: AT_REST, STUCK,
 *  NO_MEMORY. */
enum brink_run_status brink_conventional_advance(brink_conventional *c,
                                                 uint64_t events);

/**
 * The energy that the positions show: kinetic, and of each pair its potential at
 * the separation it has now.  For any run, by its cells, in O(N).  The pair of
 * the last event lies on a step to within rounding, where position shows nothing:
 * it counts at the level at which this event has left it.
 */
double brink_energy_by_position(const brink_run *run);
#endif
