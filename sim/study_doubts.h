// SPDX-License-Identifier: MIT
#ifndef BRINK_STUDY_DOUBTS_H
#define BRINK_STUDY_DOUBTS_H
/**
 * How often position would have told a pair's state wrongly, counted beside a run
 * that goes by logical states and is looked at after everything that happens.
 *
 * [S16] section 5 gives 1.4e-7 (square well) and 2.6e-7 (square shoulder) an
 * event for "inconsistencies during event processing", "in the logical and
 * physical state", and does not say what is counted.  These are the definitions
 * that can be meant, each by itself.
 *
 * Particles i and j have an event at time t, at the step sigma of their
 * potential; it takes the pair's level from l to l'.  r is their separation, v
 * the rate of it, and
 *
 *     s(r) = number of finite steps with |r| < distance    what position shows
 *     g(r) = (|r| - sigma) / sigma                         how far off the step
 *
 * with both signs exact for the doubles that r is in.  No pair is ever taken to
 * be inside a hard core: there is no other state to mistake its state for.
 */
#include "run.h"

enum brink_doubt_kind {
    /** s(r(t1)) != level at t1 > t, when the pair is next tested after the test
     * that its event itself brings: at the next event or the next crossing of a
     * cell's wall of i or j, whichever is first. */
    BRINK_DOUBT_TESTED,
    /** s(r(t2)) != level at t2 > t, the next event of i or j with a third. */
    BRINK_DOUBT_NEXT,
    /** s(r(t3)) != level at t3 > t, the next event of any other pair at all, if
     * that comes before this one's. */
    BRINK_DOUBT_SYSTEM,
    /** s(r(t)) != l: at execution, positions advanced, before the impulse. */
    BRINK_DOUBT_EXECUTED,
    /** s(r(t0)) != l: the event was predicted at t0 < t, from a separation that
     * is kept, and decides at t (Alder and Wainwright). */
    BRINK_DOUBT_STORED,
    /** s(r(t0) + v (t - t0)) != l: that separation brought to the event. */
    BRINK_DOUBT_MOVED,
    /** s(r(t)) != l': right after the impulse, where the pair is tested at once.
     * (A transfer is in doubt on either side of it: exactly one of EXECUTED and
     * AFTER counts it.) */
    BRINK_DOUBT_AFTER,
    BRINK_DOUBTS
};

/** Gaps |g| are counted by their binary exponent: in place k those from 2^-k up
 * to twice that; in the first all that are larger, in the last all smaller. */
#define BRINK_GAPS 64

typedef struct brink_doubt {
    uint64_t looks;
    uint64_t wrong;                // position shows another level
    uint64_t wrong_by[BRINK_GAPS]; // of these, those so far on the wrong side
    uint64_t within[BRINK_GAPS];   // of all looks after or at finite steps
} brink_doubt;

/** Formulas that are asked when a pair could next meet a step, right after its
 * event: its separation and rate as the doubles they are. */
enum brink_formula {
    BRINK_FORMULA_INWARD,  // [S16] algorithm 1, in plain doubles
    BRINK_FORMULA_OUTWARD, // algorithm 2 with its branches put right
    BRINK_FORMULA_PRINTED, // algorithm 2 as printed
    BRINK_FORMULAS
};

typedef struct brink_answers {
    uint64_t asked;
    uint64_t other; // another of never, now, later than the kernel's exact answer
    uint64_t astray; // later, as it should be, but over 2^-20 of the time off
} brink_answers;

typedef struct brink_doubts { // figures alone
    uint64_t events;          // pair events looked at
    brink_doubt of[BRINK_DOUBTS];
    brink_answers answers[BRINK_FORMULAS];
    /** The spheres of a hard core overlap by a rounding when they collide.  There
     * is no other state to be mistaken for, so none of the above counts it. */
    uint64_t overlaps;
} brink_doubts;

/** What is remembered of a particle. */
typedef struct brink_memory {
    double r[3], v[3];  // of the pair whose event it waits for, i < j,
    brink_instant when; // as it was predicted then; NEVER: it waits for none
    double distance;    // of the step it last had an event at
    uint32_t met;       // with whom, unless there was an event of either since
    uint32_t untested;  // and unless the pair was tested since
} brink_memory;

typedef struct brink_doubter {
    brink_doubts seen;
    brink_memory *memory; // per particle
    uint32_t particles;
} brink_doubter;

/** Begins to look at a run, before its first event or right after one.  0, -1 no
 * memory. */
int brink_doubter_create(brink_doubter *d, const brink_run *run);
void brink_doubter_destroy(brink_doubter *d);

/** As brink_run_advance, without a limit in time, and looks at all that happens.
 *  The run does not notice. */
enum brink_run_status brink_doubter_advance(brink_doubter *d, brink_run *run,
                                            uint64_t events);

/** Looks at which position was wrong by 2^-exponent or more. */
uint64_t brink_doubt_beyond(const brink_doubt *d, int exponent);

/** Looks at which the pair was less than 2^-exponent off the step. */
uint64_t brink_doubt_within(const brink_doubt *d, int exponent);
#endif
