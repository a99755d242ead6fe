// SPDX-License-Identifier: MIT
#ifndef TESTS_BENCH_RACES_H
#define TESTS_BENCH_RACES_H
/** All races that the page tells of, each held once. */
#include "bench_courses.h"

enum { RACES = COURSES + SIZES + DENSITIES + 1 };

typedef struct bench_races {
    double seconds; // of brink's time, for a piece
    uint32_t most;  // particles
    int held;
    race_result result[RACES];
} bench_races;

/** 0, or -1 after a word to stderr. */
int bench_hold_races(bench_races *r);

/** What came of a course, or of what it is within the most particles. */
const race_result *bench_race_over(const bench_races *r, race_course c);

static inline double race_ns(const race_result *r, enum racer who)
{
    return 1e9 / r->rate[who];
}

/** How many times as dear as the cheapest the dearest of all sizes is. */
double bench_size_spread(const bench_races *r, enum racer who);
#endif
