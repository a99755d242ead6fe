// SPDX-License-Identifier: MIT
#ifndef TESTS_BENCH_SPEED_H
#define TESTS_BENCH_SPEED_H
/** What was asked of the kernels' speed, each as a ratio to a named baseline, and
 * what is measured. */
#include <stdint.h>

typedef struct speed {
    const char *kernel, *family, *baseline;
    double at_most; // 0: nothing was asked
    double ns, baseline_ns;
} speed;

int bench_speed_lines(void);
const char *bench_speed_kernel(int which);

/** Measures a line for so many seconds.  1, or 0 where this machine has not got
 * the instructions, or -1 if memory is out. */
int bench_speed_measure(int which, uint64_t seed, double seconds, speed *s);
#endif
