// SPDX-License-Identifier: MIT
/*
 * Known physics, each figure with its error bar and a stated term for what the
 * theory leaves out.
 */
#include "suite.h"
#include "systems.h"
#include "thermo.h"
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_randist.h>
#include <math.h>
#include <stdio.h>

// Equations of state, and the coefficient each has for eta^m.

static double carnahan_starling(double eta)
{
    return (1 + eta + eta * eta - eta * eta * eta) / pow(1 - eta, 3);
}

static double carnahan_starling_coefficient(int m)
{
    return m * (m + 3);
}

static double henderson(double eta)
{
    return (1 + eta * eta / 8) / ((1 - eta) * (1 - eta));
}

static double henderson_coefficient(int m)
{
    return m + 1 + (m - 1) / 8.0;
}

typedef struct equation {
    double (*z)(double eta);
    double (*coefficient)(int m);
    double second;   // B_2 in units of a particle's volume
    double known[8]; // B_n / B_2^(n-1), n = 3 to 10: Clisby, McCoy 2006,
                     // J. Stat. Phys. 122, 15, table 1
} equation;

static const equation spheres = {carnahan_starling,
                                 carnahan_starling_coefficient,
                                 4,
                                 {0.625, 0.2869495, 0.110252, 0.03888198,
                                  0.01302354, 0.0041832, 0.0013094, 0.0004035}};
static const equation discs = {henderson,
                               henderson_coefficient,
                               2,
                               {0.78200444, 0.5322318, 0.33355604, 0.1988425,
                                0.1148728, 0.064993, 0.0362193, 0.0199537}};

/** The equation of state is itself an approximation, off by up to 0.3 % here.
 *  With the ten virial coefficients that are known put in place of its own it
 *  is off by less than the last correction going on as a geometric series,
 *  which is *remainder. */
static double corrected(const equation *e, double eta, double *remainder)
{
    double z = e->z(eta), term = 0;
    for (int m = 2; m <= 9; m++) {
        term = (e->known[m - 2] * pow(e->second, m) - e->coefficient(m)) *
               pow(eta, m);
        z += term;
    }
    *remainder = fabs(term) * eta / (1 - eta);
    return z;
}

static void hard(const equation *e, const char *scene, double eta,
                 uint64_t settling)
{
    char what[100];
    brink_run run;
    double remainder;
    make_run(&run, scene);
    const double n = run.system.count;
    const thermo t = thermo_measure(&run, settling, suite_share(1000000));
    const double expected = corrected(e, eta, &remainder);
    // N particles differ from infinitely many by about what one more would make.
    const double one_more = e->z(eta * (1 + 1 / n)) - e->z(eta);
    snprintf(what, sizeof what, "Z of %g %s at packing %g (uncorrected %.5f)", n,
             e == &spheres ? "spheres" : "discs", eta, e->z(eta));
    thermo_expect(what, t.z, expected, remainder + one_more, 0.01 * expected);
    brink_run_destroy(&run);
}

START_TEST(hard_spheres_have_the_pressure_of_carnahan_and_starling)
{
    hard(&spheres,
         "box: {packing_fraction: 0.1}\n"
         "species: {A: {count: 500, diameter: 1}}\n",
         0.1, 50000);
    hard(&spheres,
         "box: {packing_fraction: 0.25}\n"
         "species: {A: {count: 500, diameter: 1}}\n",
         0.25, 50000);
}
END_TEST

START_TEST(dense_hard_spheres_melt_and_have_it_too)
{
    hard(&spheres,
         "box: {packing_fraction: 0.45}\n"
         "species: {A: {count: 1372, diameter: 1}}\n",
         0.45, 400000);
}
END_TEST

START_TEST(hard_discs_have_the_pressure_of_henderson)
{
    hard(&discs,
         "dimensions: 2\n"
         "box: {packing_fraction: 0.3}\n"
         "species: {A: {count: 504, diameter: 1}}\n",
         0.3, 50000);
    hard(&discs,
         "dimensions: 2\n"
         "box: {packing_fraction: 0.5}\n"
         "species: {A: {count: 504, diameter: 1}}\n",
         0.5, 100000);
}
END_TEST

// How probable a worse fit to Maxwell-Boltzmann would be, for `bins` bins that it
// makes equally probable: m v^2 / 2 kT is gamma distributed, of shape 3/2.

enum { BINS = 40, SNAPSHOTS = 20 };

static void fill(const brink_run *run, double bins[BINS])
{
    const double kt = brink_system_temperature(&run->system);
    for (uint32_t i = 0; i < run->system.count; i++) {
        const double *v = run->system.particle[i].v;
        const double energy = 0.5 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        bins[(int)(gsl_cdf_gamma_P(energy / kt, 1.5, 1) * BINS)]++;
    }
}

static double fit(const double bins[BINS])
{
    double total = 0, chi2 = 0;
    for (int k = 0; k < BINS; k++)
        total += bins[k];
    for (int k = 0; k < BINS; k++)
        chi2 += pow(bins[k] - total / BINS, 2) / (total / BINS);
    return gsl_cdf_chisq_Q(chi2, BINS - 1);
}

START_TEST(speeds_that_begin_all_equal_become_maxwells)
{
    double begin[BINS] = {0}, end[BINS] = {0};
    brink_system system;
    brink_run run;
    make_system(&system, "box: {packing_fraction: 0.25}\n"
                         "species: {A: {count: 1372, diameter: 1}}\n");
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
    for (uint32_t i = 0; i < system.count; i += 2) {
        double *v = system.particle[i].v, *w = system.particle[i + 1].v;
        gsl_ran_dir_3d(rng, &v[0], &v[1], &v[2]);
        for (int k = 0; k < 3; k++)
            w[k] = -v[k];
    }
    gsl_rng_free(rng);
    ck_assert_int_eq(brink_run_create(&run, &system, BRINK_TIER_PLAIN), 0);
    fill(&run, begin);
    // Ten events a particle between snapshots: as good as independent ones.
    for (uint64_t snapshot = 0; snapshot < SNAPSHOTS; snapshot++) {
        advance(&run, (20 + 10 * snapshot) * 1372 / 2 * 2);
        fill(&run, end);
    }
    const double p = fit(end);
    printf(
        "speeds: p = %g at the start, %.3f after 20 and more events a particle\n",
        fit(begin), p);
    ck_assert_double_eq(fit(begin), 0);
    ck_assert_double_gt(p, 0.001);
    brink_run_destroy(&run);
}
END_TEST

int main(void)
{
    return RUN_SUITE("physics", 600,
                     hard_spheres_have_the_pressure_of_carnahan_and_starling,
                     dense_hard_spheres_melt_and_have_it_too,
                     hard_discs_have_the_pressure_of_henderson,
                     speeds_that_begin_all_equal_become_maxwells);
}
