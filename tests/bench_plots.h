// SPDX-License-Identifier: MIT
#ifndef TESTS_BENCH_PLOTS_H
#define TESTS_BENCH_PLOTS_H
/** The bench's figures: gnuplot scripts for brink_report_figure, to be freed;
 * NULL if memory is out. */
#include "standing.h"

/** Cost against error by a measure: a line from each way's median to its largest
 * error, or into the column of those that were wrong.  bench_scatter.c */
char *bench_scatter(const contest *c, int measure);

/** The part of the answers whose error is above x, of each way.
 * bench_distribution.c */
char *bench_distribution(const contest *c, int measure);
#endif
