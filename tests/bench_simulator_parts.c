// SPDX-License-Identifier: MIT
#include "bench_simulator_parts.h"
#include <math.h>

void bench_put_count(brink_report *r, double x)
{
    if (!(x > 0)) {
        brink_report_cell(r, " ");
        return;
    }
    const double unit = pow(10, fmax(0, floor(log10(x)) - 2));
    brink_report_cell(
        r, "%s", brink_words_grouped((uint64_t)(round(x / unit) * unit)).text);
}

void bench_put_ratio(brink_report *r, double x)
{
    brink_report_cell(r, "%s", isnan(x) ? " " : bench_ratio(x).text);
}

void bench_put_pair(brink_report *r, const double x[RACERS])
{
    for (int who = 0; who < RACERS; who++)
        if (isnan(x[who]))
            brink_report_cell(r, " ");
        else
            brink_report_cell(r, x[who] < 10 ? "%.2f" : "%.0f", x[who]);
}

brink_words bench_particles(const race_result *of)
{
    return brink_words_grouped(race_particles(&of->course));
}
