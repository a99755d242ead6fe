// SPDX-License-Identifier: MIT
#ifndef BRINK_CONVENTIONAL_METHOD_H
#define BRINK_CONVENTIONAL_METHOD_H
/**
 * The ways in which event-driven programs have told on which side of a step a
 * pair is, before and beside logical states [S16 section 2]: what each of them
 * answers at the three places where they differ.  To be compared with, not to be
 * used.
 */
#include "run.h"

enum brink_method {
    BRINK_METHOD_LOGICAL,      // the control: logical states
    BRINK_METHOD_POSITION,     // from position, at detection and at execution
    BRINK_METHOD_STORED,       // from position at detection, kept till execution
    BRINK_METHOD_NUDGED_TIME,  // the same, and the time moved clear of the step
    BRINK_METHOD_NUDGED_PLACE, // from motion at execution; then moved off the
                               // step
    BRINK_METHOD_PRINTED,      // logical; disjoint time as printed [S16 alg. 2]
    BRINK_METHODS
};

/**
 * How far events are moved, in parts of the step's distance (for a time: of what
 * the pair takes to fly it).  Such values are found by trial: large against the
 * rounding of a separation and small against everything else.  1e-10 is what
 * etomica moves each particle by [S16 ref. 9]; 1e-12 to 1e-10 are usual for
 * times.
 *
 * Tried here, 40 000 events of 1372 square wells or shoulders: at 1e-14 and less
 * the energy is off, by some 1e-3 to 1e-1 of itself; from 1e-6 on single events
 * are missed, at 1e-6 one.  A miss being as likely as the nudge is long, 1e-10
 * has one in some 10^8 events.
 */
#define BRINK_PLACE_NUDGE 1e-10
#define BRINK_TIME_NUDGE  1e-11

/** A pair that has come to a step of its potential. */
typedef struct brink_meeting {
    uint32_t i, j;
    const brink_potential *potential;
    int step;        // 0: the outermost
    int seen_inside; // of this step, when the meeting was predicted
    double r[3], v[3];
} brink_meeting;

typedef struct brink_rule {
    const char *name; // a few words
    const char *idea; // a sentence

    /** The level that a pair is seen at when its next event is looked for. */
    int (*level)(const brink_run *, uint32_t i, uint32_t j, const double r[3]);

    /** When a captured pair gets to the rim; and how far every event's time is
     * moved, later for a transfer, earlier for a reflection. */
    double (*disjoint_time)(const double r[3], const double v[3], double sigma);
    double time_nudge;

    /** Whether the pair comes to the step from inside of it; and how far it is
     * moved along its separation afterwards, to the side it is to be on. */
    int (*is_inside)(const brink_run *, const brink_meeting *);
    double place_nudge;
} brink_rule;

const brink_rule *brink_method_rule(enum brink_method method);

/** Nearest-image separation of i and j at the run's present instant. */
void brink_separation_now(const brink_run *run, uint32_t i, uint32_t j,
                          double r[3]);

/** The largest |energy| of a finite step, over all potentials: what it costs to
 *  tell a state wrongly; +inf where there is none. */
double brink_largest_step(const brink_system *system);

/** The level that position shows, no pair being ever inside a hard core. */
int brink_level_by_position(const brink_potential *p, const double r[3]);

/** [S16] algorithm 1 as printed, in plain doubles. */
double brink_intersection_time_as_printed(const double r[3], const double v[3],
                                          double sigma);

/** [S16] algorithm 2, in plain doubles, its branches put right. */
double brink_disjoint_time_put_right(const double r[3], const double v[3],
                                     double sigma);

/** [S16] algorithm 2 as printed: each of its two branches has the form that
 * cancels there, and the clamp at zero takes the NaN of -0/0 for "now". */
double brink_disjoint_time_as_printed(const double r[3], const double v[3],
                                      double sigma);
#endif
