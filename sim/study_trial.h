// SPDX-License-Identifier: MIT
#ifndef BRINK_STUDY_TRIAL_H
#define BRINK_STUDY_TRIAL_H
/**
 * One method on one start: run until it has done its events or has provably
 * failed, its energy taken from the positions at sample points spaced evenly in
 * the logarithm of the number of events.
 */
#include "conventional_method.h"
#include "study_doubts.h"
#include <stdio.h>

enum brink_outcome {
    BRINK_OUTCOME_NONE, // it has not come to an end: what a crash leaves
    BRINK_OUTCOME_DONE,
    BRINK_OUTCOME_AT_REST, // nothing moves any more
    BRINK_OUTCOME_STANDS_STILL,
    BRINK_OUTCOME_ENERGY_OFF, // by more than one |epsilon| a particle
    BRINK_OUTCOME_REFUSED,    // by the state machine
    BRINK_OUTCOME_NO_MEMORY
};

typedef struct brink_trial {
    enum brink_method method;
    enum brink_outcome outcome;
    uint32_t particles;
    uint64_t events;
    double time;         // simulated
    double seconds;      // of the processor, for the events alone
    double energy_begin; // as the positions show it
    double energy_end;
    double energy_error; // of that, >= 0; relative unless the energy was 0
    double energy_worst; // of all samples
    double epsilon;      // the largest |energy| of a finite step, or +inf
    brink_tally tally;
    brink_happening last; // the event at which it ended
    brink_doubts doubts;  // BRINK_METHOD_LOGICAL alone; without its table
} brink_trial;

/**
 * Runs a method from a start, which is taken over, for so many events.  The
 * method BRINK_METHOD_LOGICAL is brink_run itself, looked at after each event for
 * doubts. Samples are written to `samples` as they are taken, a line each:
 * events, time, relative energy error, energy.
 */
void brink_trial_run(brink_system *start, enum brink_method method,
                     uint64_t events, FILE *samples, brink_trial *trial);

/** The next sample point after `events`: 20 to a decade where there are so many.
 */
uint64_t brink_trial_next_sample(uint64_t events);
#endif
