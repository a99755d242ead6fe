// SPDX-License-Identifier: MIT
#ifndef FUZZ_WITNESS_H
#define FUZZ_WITNESS_H
/**
 * Who watches a run event by event, with a table of levels and a handful of
 * closed forms of its own, and knows none of the run's rooms:
 *
 *     time      does not run back
 *     level     an event is legal for the level that the log of events says, and
 *               the run's levels are the log's, for every pair
 *     contact   an event's pair is at its step, and was on its way to it
 *     path      between two events no pair, in no image, crosses a step: it stays
 *               in the shell that its level says
 *     parting   who is turned back goes the other way, on the rim at an angle
 *     progress  a pair has no more events at one instant than a way in or out of
 *               its steps has
 *     energy    with what is owed it is what it was
 *     momentum  is what it was
 *     tallies   are the log's
 */
#include "run.h"

typedef struct witness {
    const brink_run *run;
    brink_system begin, before; // at first; after the event before this one
    brink_instant since;        // when that was
    int *level;                 // the log's: [i * count + j], i < j
    brink_tally counted;        // from the log
    brink_happening last;       // the event before
    long double energy;         // at first
    double momentum[3];
    int repeats; // events of one pair, at one instant, one after another
    double speed, energy_most, momentum_most; // the largest so far
    double energies; // sum of |energy| over all pairs and finite steps
} witness;

/** Before the run's first event. */
void witness_begin(witness *w, const brink_run *run);
void witness_end(witness *w);

/** After one event, or after a time without one. */
void witness_look(witness *w, int event);

/** Whether the two move together so fast, 2^24 times their relative speed, that
 *  roundings hide what turns them away from each other: then a run may be held
 *  up, and says so. */
int witness_is_hidden(const witness *w, uint32_t i, uint32_t j);

/** Says that a law is broken, and by which system. */
_Noreturn void witness_break(const witness *w, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
#endif
