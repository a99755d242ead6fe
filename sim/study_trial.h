// SPDX-License-Identifier: MIT
#ifndef BRINK_STUDY_TRIAL_H
#define BRINK_STUDY_TRIAL_H
/**
 * One method on one start: run until it has done its events or has provably
 * failed, its energy taken at sample points spaced evenly in the logarithm of the
 * number of events.
 *
 * A trial is advanced piece by piece; what comes out does not depend on how it
 * was cut into pieces, but for the seconds.
 */
#include "conventional.h"
#include "study_doubts.h"

enum brink_outcome {
    BRINK_OUTCOME_NONE, // it has not come to an end: what a crash leaves
    BRINK_OUTCOME_DONE,
    BRINK_OUTCOME_AT_REST, // nothing moves any more
    BRINK_OUTCOME_STANDS_STILL,
    BRINK_OUTCOME_ENERGY_OFF, // by more than one |epsilon| a particle
    BRINK_OUTCOME_REFUSED,    // by the state machine
    BRINK_OUTCOME_NO_MEMORY
};

typedef struct brink_sample {
    uint64_t events;
    double time;   // simulated
    double energy; // as the positions show it
    double error;  // of that, >= 0; relative unless the energy was 0 at the start
    double kept;   // the same of kinetic energy and levels as the states have
                   // them, with its sign, and to some 30 digits of the energy
} brink_sample;

/** Sample points are 20 to a decade, or one an event where those are fewer:
 * fewer than 20 in each of the 20 decades that 64 bits have. */
#define BRINK_SAMPLES 400

typedef struct brink_trial { // figures alone
    enum brink_method method;
    enum brink_outcome outcome;
    uint32_t particles;
    uint64_t events;
    double time;         // simulated
    double seconds;      // of the processor, for the events alone
    double wall;         // seconds on the wall, for everything
    double energy_begin; // as the positions show it
    double energy_end;
    double energy_error;  // of that, >= 0; relative unless the energy was 0
    double energy_worst;  // of all samples
    brink_sum kept_begin; // energy as the states have it
    double epsilon;       // the largest |energy| of a finite step, or +inf
    brink_tally tally;
    brink_happening last; // the event at which it ended
    brink_doubts doubts;  // BRINK_METHOD_LOGICAL alone
    int samples;
    brink_sample sample[BRINK_SAMPLES];
} brink_trial;

/** A trial under way: of what is advanced and looked at, one. */
typedef struct brink_attempt {
    brink_trial trial; // complete once its outcome is not BRINK_OUTCOME_NONE
    uint64_t events;   // asked for
    brink_run run;     // BRINK_METHOD_LOGICAL: a run as any other, looked at
    brink_doubter doubter;
    brink_conventional conventional;
} brink_attempt;

/** From a start, which is taken over, by a method, for so many events.  Where
 * memory is out, that is the outcome. */
void brink_attempt_create(brink_attempt *a, brink_system *start,
                          enum brink_method method, uint64_t events);
void brink_attempt_destroy(brink_attempt *a);

/** Goes on by so many events at most, and not past the next sample point, or to
 *  the trial's end.  Not to be called after that. */
void brink_attempt_advance(brink_attempt *a, uint64_t events);

/** What is advanced. */
const brink_run *brink_attempt_run(const brink_attempt *a);

/** The next sample point after `events`. */
uint64_t brink_trial_next_sample(uint64_t events);
#endif
