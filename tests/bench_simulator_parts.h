// SPDX-License-Identifier: MIT
#ifndef TESTS_BENCH_SIMULATOR_PARTS_H
#define TESTS_BENCH_SIMULATOR_PARTS_H
/** Parts of the simulator's page, and cells of their tables. */
#include "bench_races.h"
#include "bench_words.h"
#include "report.h"

/** What was asked for by name; instructions from the file `counts` of
 * simulator_counts.sh, or NULL.  bench_simulator_systems.c */
void bench_write_systems(brink_report *r, const bench_races *races,
                         const char *counts);

/** What it costs to have more of something.  bench_simulator_costs.c */
void bench_write_sizes(brink_report *r, const bench_races *races);
void bench_write_memory(brink_report *r, const bench_races *races);
void bench_write_densities(brink_report *r, const bench_races *races);

/** A count, to three digits; a blank for 0 or NaN. */
void bench_put_count(brink_report *r, double x);

/** Blanks for NaN. */
void bench_put_ratio(brink_report *r, double x);
void bench_put_pair(brink_report *r, const double x[RACERS]);

brink_words bench_particles(const race_result *of);
#endif
