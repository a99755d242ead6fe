// SPDX-License-Identifier: MIT
#ifndef TESTS_BENCH_TABLES_H
#define TESTS_BENCH_TABLES_H
/** The tables of the bench's page. */
#include "report.h"
#include "standing.h"

/** Cost, errors, and what was wrong, a line a way; instructions from the file
 * `counts` of instructions.sh, or NULL. */
void bench_write_summary(brink_report *r, const contest *c, const char *counts);

/** Wrong answers, a line a family. */
void bench_write_families(brink_report *r, const contest *c);

/** What the ways are. */
void bench_write_ways(brink_report *r, const problem *p);

/** What was asked of the kernels' speed, measured for so many seconds a line. */
void bench_write_speed(brink_report *r, uint64_t seed, double seconds);
#endif
