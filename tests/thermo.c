// SPDX-License-Identifier: MIT
#include "thermo.h"
#include "suite.h"
#include "systems.h"
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdio.h>

enum { BLOCKS = THERMO_BLOCKS, PIECES = 20 }; // looks in a block

static mean mean_of(const double blocks[BLOCKS])
{
    return (mean){gsl_stats_mean(blocks, 1, BLOCKS),
                  gsl_stats_sd(blocks, 1, BLOCKS) / sqrt(BLOCKS)};
}

thermo thermo_measure(brink_run *run, uint64_t settling, uint64_t events)
{
    double z[BLOCKS], energy[BLOCKS] = {0};
    thermo all = {.temperature = 0};
    advance(run, settling);
    const double n = run->system.count, d = run->system.dimensions;
    const double t =
        brink_run_mean_free_time(run) * 2 / n * (double)events / BLOCKS;
    brink_instant at = run->now;
    for (int block = 0; block < BLOCKS; block++) {
        const double virial = brink_sum_value(&run->tally.virial);
        double kt = 0;
        for (int piece = 0; piece < PIECES; piece++) {
            at = brink_instant_after(run->system.year, at, t / PIECES);
            ck_assert_int_eq(brink_run_advance(run, UINT64_MAX, at),
                             BRINK_RUN_REACHED);
            kt += brink_system_temperature(&run->system) / PIECES;
            energy[block] +=
                brink_states_energy(&run->states, &run->system) / n / PIECES;
        }
        z[block] =
            1 + (brink_sum_value(&run->tally.virial) - virial) / (d * n * kt * t);
        all.temperature += kt / BLOCKS;
    }
    all.z = mean_of(z);
    all.energy = mean_of(energy);
    return all;
}

void thermo_expect(const char *what, mean figure, double expected, double besides,
                   double blunt)
{
    printf("%s: %.5f +- %.5f, expected %.5f +- %.5f\n", what, figure.value,
           figure.error, expected, besides);
    fflush(stdout);
    const double share = (double)suite_share(1000000) / 1000000;
    ck_assert_msg(figure.error <= blunt / sqrt(share), "%s: the error is %a",
                  what, figure.error);
    ck_assert_msg(fabs(figure.value - expected) <= 4 * figure.error + besides,
                  "%s", what);
}
