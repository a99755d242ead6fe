// SPDX-License-Identifier: MIT
#ifndef TESTS_BENCH_COURSES_H
#define TESTS_BENCH_COURSES_H
/** The systems over which the simulators race. */
#include "bench_race.h"

/** One that was asked for by name, and what is said of it elsewhere: events a CPU
 * second, of other programs on another machine. */
typedef struct bench_course {
    const char *key; // in the file of counts
    const char *name;
    race_course course;
    double asked;               // of brink, on that machine
    double dynamo, smallenburg; // 0: not known
    int is_profiled;
} bench_course;

enum {
    COURSES = 6,
    COUNTED = 5, // the first of them: those that callgrind goes through in time
    SIZES = 7,
    DENSITIES = 9
};
extern const bench_course bench_courses[COURSES];

/** Hard spheres at packing 0.45, in ever larger boxes. */
race_course bench_size(int k);

/** Hard spheres ever denser. */
race_course bench_density(int k);

/** Hard spheres, and a square well in which a particle has about 12 partners. */
extern const race_course bench_well_12;
#endif
