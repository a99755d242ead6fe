// SPDX-License-Identifier: MIT
#ifndef TESTS_BENCH_CURVES_H
#define TESTS_BENCH_CURVES_H
/** What an event costs either simulator, against something. */
#include "bench_race.h"

/** A gnuplot script for brink_report_figure, to be freed; NULL if memory is out.
 * Both axes are logarithmic; `axis` has the commands for that of x. */
char *bench_curves(const char *axis, int count, const double *x,
                   const race_result *const results[]);
#endif
