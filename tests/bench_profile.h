// SPDX-License-Identifier: MIT
#ifndef TESTS_BENCH_PROFILE_H
#define TESTS_BENCH_PROFILE_H
/** What an event takes, as simulator_counts.sh has counted it. */
#include "bench_courses.h"

enum { COSTS = 5 };

typedef struct bench_cost { // a function's own instructions
    double percent;
    char function[100], file[100];
} bench_cost;

typedef struct bench_profile { // of one course; NaN where not known
    double instructions[RACERS], pairs[RACERS];
    bench_cost cost[COSTS]; // brink's
    int costs;
} bench_profile;

/** Those of the course of that key in a file; NULL stands for no file. */
void bench_profile_read(const char *file, const char *key, bench_profile *p);
#endif
