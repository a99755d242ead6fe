// SPDX-License-Identifier: MIT
#ifndef TESTS_BENCH_SPEED_H
#define TESTS_BENCH_SPEED_H
/** What was asked of the kernels' speed, each as a ratio to a named baseline, and
 * what is measured. */
#include <stdint.h>

enum speed_verdict { SPEED_NOT_HERE, SPEED_NOT_ASKED, SPEED_KEPT, SPEED_OVER };

typedef struct speed {
    const char *kernel, *family, *baseline;
    double ns, ratio, at_most; // at_most 0: nothing was asked
    enum speed_verdict verdict;
} speed;

/** What there is to be said of a verdict: "kept", "over"... */
extern const char *const speed_words[];

int bench_speed_lines(void);
const char *bench_speed_kernel(int which);

/** Measures a line for so many seconds, if this machine has got the instructions.
 * 0, or -1 if memory is out. */
int bench_speed_measure(int which, uint64_t seed, double seconds, speed *s);
#endif
