// SPDX-License-Identifier: MIT
#ifndef TESTS_BENCH_COUNT_H
#define TESTS_BENCH_COUNT_H
/** Instructions a call, counted by callgrind: steady, where times are not. */
#include "problems.h"

/** Calls every method over its problem's usual inputs, to be counted: for
 * tests/instructions.sh, which runs this under valgrind.  0, or -1 if memory is
 * out. */
int bench_count_all(uint64_t seed);

/** The instructions a call of each method of a problem, NaN where not known, from
 * the file that instructions.sh wrote; NULL stands for no file. */
void bench_count_read(const char *file, const problem *p, double *instructions);
#endif
