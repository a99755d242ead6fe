// SPDX-License-Identifier: MIT
#ifndef TESTS_BENCH_RACE_H
#define TESTS_BENCH_RACE_H
/**
 * Two simulators side by side over the same systems from the same starts: brink's
 * run, and the plain one of plain_simulator.h.
 */
#include "plain_simulator.h"
#include "run.h"
#include <stdio.h>

enum racer { RACE_BRINK, RACE_PLAIN, RACERS };

/** A system: 4 edge^3 particles, from an fcc lattice. */
typedef struct race_course {
    int edge;
    double density; // number density
    double range;   // of the step around the core; 0: hard spheres
    double energy;  // inside it
} race_course;

uint32_t race_particles(const race_course *c);

/** The same with at most so many particles, but no fewer than 500, of which a box
 * at every density here is large enough for both. */
race_course race_within(const race_course *c, uint32_t most);
double race_packing(const race_course *c);

/** So many events a particle has each of them before anything is measured. */
#define RACE_SETTLING 3

/** And so many events in all go by while instructions are counted. */
#define RACE_COUNTED 20000

/** Both, at the same moment of the same system. */
typedef struct race_pair {
    brink_run brink;
    plain_simulator plain;
    double bytes[RACERS]; // that each holds, NaN where malloc does not tell
} race_pair;

/** 0; or -1 after a word to stderr, and nothing is kept. */
int race_begin(race_pair *p, const race_course *c);
void race_end(race_pair *p);

/** So many events more of one of them; the seconds of CPU time they took.  Ends
 * the program if the run stops: there is nothing to measure then. */
double race_go(race_pair *p, enum racer who, uint64_t events);

/** What a race has shown. */
typedef struct race_result {
    race_course course;
    double rate[RACERS];       // events a CPU second: the median of the pieces
    double ratio, least, most; // brink's to plain's: the median, lowest, highest
    double crossings[RACERS];  // of cells, an event
    double bytes[RACERS];      // a particle
    double captured;           // partners a particle has
} race_result;

/** Lets both settle for some events a particle, then go on in turns, each piece
 * of `seconds` of brink's time, but no shorter than brink's year, which is about
 * as long as each particle takes to have an event, so that what happens once a
 * year is in every piece.  0, or -1 after a word to stderr. */
int race_hold(race_result *result, const race_course *c, double seconds);
#endif
