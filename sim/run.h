// SPDX-License-Identifier: MIT
#ifndef BRINK_RUN_H
#define BRINK_RUN_H
/**
 * The loop: take the next event, advance its particles, resolve it, predict
 * again.
 *
 * Advanced from above piece by piece and looked at between pieces; a run of n
 * events is the same, bit for bit, in one piece or in many.  It knows of no file
 * and no clock on the wall, and calls nobody back.
 */
#include "calendar.h"
#include "cells.h"
#include "neighbours.h"
#include "states.h"
#include "sum.h"
#include "system.h"

enum brink_tier { BRINK_TIER_FAST, BRINK_TIER_PLAIN, BRINK_TIER_CR };

/** What a run has counted.  An event is one pair's; `cell`, crossings of cells'
 * walls or departures from home, is counted apart. */
typedef struct brink_tally {
    uint64_t core, capture, release, bounce, wall, cell;
    uint64_t stale; // predictions made anew, the partner having changed
    // Anomalies: nothing is silent.
    uint64_t clamped;   // due when predicted, the pair already beyond the surface
    uint64_t zero_time; // at the same instant as the event before
    uint64_t repeated;  // of these, those of the same pair as the event before
    // bounces turned inward, see <brink/impulse.h>; and cores and bounces from
    // outside that a rounding would have left going in, turned outward
    uint64_t rim;
    uint64_t refused;         // refused by the state machine: stops the run
    brink_sum virial;         // of r.dp
    double contact_error_max; // max | |r| - distance | / distance at an event
} brink_tally;

/** Pair and wall events. */
static inline uint64_t brink_tally_events(const brink_tally *t)
{
    return t->core + t->capture + t->release + t->bounce + t->wall;
}

/** The last pair event executed, for those who look at a run event by event. */
typedef struct brink_happening {
    enum brink_event_kind kind;
    uint32_t i, j; // i < j
    int level_before, level_after;
    double distance; // of the step
    brink_instant when;
} brink_happening;

typedef struct brink_run {
    brink_system system;
    brink_states states;
    brink_cells cells;
    brink_neighbours neighbours; // where it is crowded
    brink_calendar calendar;     // slot i: what particle i waits for
    enum brink_tier tier;
    brink_instant now;
    brink_tally tally;
    brink_happening last;
    uint32_t idle; // consecutive events that did not move the clock
    double owed;   // energy that roundings have taken, see <brink/impulse.h>
    double energy_begin;  // kinetic and potential when the run was made
    double kinetic_begin; // the kinetic part of it
    double momentum_begin[3];
    double image[27][3]; // shifts to the images a particle is looked for in
    int images;
    uint32_t looked; // the day for which memory has been asked: see run_ahead.h
    uint8_t *is_partner; // per particle, scratch: of the one being predicted
} brink_run;

enum brink_run_status {
    BRINK_RUN_REACHED, // the target
    BRINK_RUN_AT_REST, // nothing will ever happen again; time targets are reached
    BRINK_RUN_STUCK, // events go on, the clock does not: see brink_run_diagnosis
    BRINK_RUN_QUIET, // BRINK_PATIENCE crossings of cells, and no event: there may
                     // be none; who wants to know goes on
    BRINK_RUN_REFUSED, // the state machine refused an event: see
                       // brink_run_diagnosis
    BRINK_RUN_NO_MEMORY
};

/** Particles that never meet cross cells for ever: after as many crossings as
 * take a second or so, whoever waits is asked whether to go on. */
#define BRINK_PATIENCE (1U << 18)

/** Takes over the system (which is empty afterwards) as a configuration first
 * made: cells and levels from position, everything predicted.  0, -1 no memory.
 */
int brink_run_create(brink_run *run, brink_system *system, enum brink_tier tier);
/** The same without levels and predictions, for those who have them stored: the
 * caller fills states, cells, calendar, tally and clock in. */
int brink_run_assemble(brink_run *run, brink_system *system,
                       enum brink_tier tier);
void brink_run_destroy(brink_run *run);
const char *brink_run_is_valid(const brink_run *run);

/** Goes on until `events` events in all have been executed, or all events up to
 * and at `until` (BRINK_NEVER: no such limit), whichever is first. */
enum brink_run_status brink_run_advance(brink_run *run, uint64_t events,
                                        brink_instant until);

/** One entry of the calendar, for those who look at a run closer than event by
 * event: an event, a crossing or departure, or a prediction made anew.  Which it
 * will be, brink_calendar_next says. */
enum brink_run_status brink_run_step(brink_run *run);
/** Whether a slot holds a pair's event that stands: neither a crossing or
 * departure, nor one that is stale. */
int brink_run_is_event(const brink_run *run, uint32_t slot);

/** One or more lines on why a run stopped: the pair, its level, r and v in hex.
 */
void brink_run_diagnosis(const brink_run *run, enum brink_run_status status,
                         char *text, size_t size);

double brink_run_time(const brink_run *run);
double brink_run_energy(const brink_run *run); // kinetic and potential
/** P = N k_B T / V + virial / (d V t); Z = P V / (N k_B T).  NaN at time 0. */
double brink_run_pressure(const brink_run *run);
double brink_run_compressibility(const brink_run *run);
/** Mean time between events of a particle: N t / (2 events); +inf without events.
 */
double brink_run_mean_free_time(const brink_run *run);
/** Coordinates of particle i now; the run is left as it is. */
void brink_run_position(const brink_run *run, uint32_t i, double x[3]);
#endif
