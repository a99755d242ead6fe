// SPDX-License-Identifier: MIT
/*
 * Pressure and energy of square wells, lambda = 1.5: dilute ones against their
 * virial coefficients, which are exact, fluids against a published equation of
 * state.
 */
#include "square_well.h"
#include "suite.h"
#include "systems.h"
#include "thermo.h"
#include <gsl/gsl_integration.h>
#include <gsl/gsl_math.h>
#include <math.h>
#include <stdio.h>

static const double lambda = 1.5;

// --- The third virial coefficient once more, from its definition ---------------

typedef struct span {
    double from, to;
} span;

/** The volume that balls of radii b >= c share, r apart. */
static double lens(double b, double c, double r)
{
    if (r <= b - c)
        return 4 * M_PI / 3 * c * c * c;
    return M_PI * gsl_pow_2(b + c - r) *
           (r * r + 2 * r * (b + c) - 3 * gsl_pow_2(b - c)) / (12 * r);
}

/** The integral over the places of particles 2 and 3 of "r12 < a, r13 < b, r23 <
 *  c", b >= c: over r12 of 4 pi r12^2 lens, of degree 5 in each stretch, which
 *  three points of Gauss's integrate exactly. */
static double triangle(double a, double b, double c)
{
    gsl_integration_glfixed_table *gauss = gsl_integration_glfixed_table_alloc(3);
    const double inside = fmin(a, b - c), outside = fmin(a, b + c);
    const span spans[] = {{0, inside}, {inside, outside}};
    double sum = 0;
    for (int k = 0; k < 2; k++)
        for (size_t n = 0; n < 3; n++) {
            double r, weight;
            gsl_integration_glfixed_point(spans[k].from, spans[k].to, n, &r,
                                          &weight, gauss);
            sum += weight * 4 * M_PI * r * r * lens(b, c, r);
        }
    gsl_integration_glfixed_table_free(gauss);
    return sum;
}

START_TEST(the_third_virial_coefficient_is_kiharas)
{
    // f = x (r < lambda) - (1 + x) (r < 1); B_3 is -1/3 of the integral of
    // f(r12) f(r13) f(r23).
    for (double kt = 0.5; kt <= 8; kt *= 2) {
        const double x = exp(1 / kt) - 1, y = -(1 + x), l = lambda;
        const double terms[] = {
            x * x * x * triangle(l, l, l), 3 * x * x * y * triangle(l, l, 1),
            3 * x * y * y * triangle(l, 1, 1), y * y * y * triangle(1, 1, 1)};
        double third = 0, size = 0;
        for (int k = 0; k < 4; k++) {
            third -= terms[k] / 3;
            size += fabs(terms[k]) / 3;
        }
        // A triangle is six terms of ten roundings, up to 16 of the sum's 2^-53;
        // Kihara's polynomials have terms ten times their values, which is 64.
        ck_assert_double_le(fabs(third - square_well_third(l, kt)),
                            80 * 0x1p-53 * size);
    }
    const double cores = 5 * M_PI * M_PI / 18; // where it is too hot for wells
    ck_assert_double_le(fabs(square_well_third(lambda, 0x1p60) - cores),
                        0x1p-50 * cores);
}
END_TEST

START_TEST(the_equation_of_state_is_as_others_have_it)
{
    // Its entropy at a point near its critical one, as the library teqp of NIST
    // computes it (a test in its models' tests): s = u / T - a, where a is what
    // Z - 1 over the density adds up to.
    const double kt = 1.3144366466267958, density = 0.2862336473147125;
    gsl_integration_glfixed_table *gauss =
        gsl_integration_glfixed_table_alloc(20);
    double a = 0;
    for (size_t n = 0; n < 20; n++) {
        double at, weight;
        gsl_integration_glfixed_point(0, density, n, &at, &weight, gauss);
        a += weight * (square_well_fluid(lambda, kt, at).z - 1) / at;
    }
    gsl_integration_glfixed_table_free(gauss);
    // Central differences are good to some 2^-26 here.
    const double energy = square_well_fluid(lambda, kt, density).energy;
    ck_assert_msg(fabs(a - -0.8061758248466638) <= 0x1p-22, "a = %.17g", a);
    ck_assert_msg(fabs(a - energy / kt - 1.0031288550954747) <= 0x1p-22,
                  "-s = %.17g", a - energy / kt);
}
END_TEST

// --- Runs ----------------------------------------------------------------------

enum { COUNT = 864 };

static thermo run_wells(double density, double temperature, uint64_t settling)
{
    char scene[300];
    brink_run run;
    snprintf(scene, sizeof scene,
             "box: {number_density: %g}\n"
             "species: {A: {count: %d}}\n"
             "start: {random: true}\n"
             "temperature: %g\n"
             "potentials:\n"
             "  - {between: [A, A], steps: [[%g, -1], [1, .inf]]}\n",
             density, COUNT, temperature, lambda);
    make_run(&run, scene);
    const thermo t = thermo_measure(&run, settling, suite_share(1000000));
    brink_run_destroy(&run);
    return t;
}

static void compare(double density, const thermo *t, square_well_state expected,
                    square_well_state besides, double blunt)
{
    char what[100];
    snprintf(what, sizeof what, "Z of wells, density %g, kT %.4f", density,
             t->temperature);
    thermo_expect(what, t->z, expected.z, besides.z, blunt);
    snprintf(what, sizeof what, "energy of wells, density %g, kT %.4f", density,
             t->temperature);
    thermo_expect(what, t->energy, expected.energy, besides.energy, blunt);
}

START_TEST(dilute_wells_have_their_virial_coefficients)
{
    // What is left out goes with density^3, for Z times less than 6 and for the
    // energy than 12, as runs at density 0.1 show.  And N particles differ from
    // infinitely many by about what one more would make.
    const double states[][2] = {{0.01, 1.5}, {0.05, 3}, {0.05, 2}};
    for (int k = 0; k < 3; k++) {
        const double density = states[k][0];
        const thermo t = run_wells(density, states[k][1], 60000);
        const square_well_state expected =
            square_well_dilute(lambda, t.temperature, density);
        const double cube = gsl_pow_3(density);
        const square_well_state besides = {
            6 * cube + fabs(expected.z - 1) / COUNT,
            12 * cube + fabs(expected.energy) / COUNT};
        compare(density, &t, expected, besides, 0.002);
    }
}
END_TEST

START_TEST(fluids_of_wells_have_the_published_pressure_and_energy)
{
    // How far [E09] is from its own simulations is not known here; 2 % of what
    // the wells do is allowed, and Carnahan and Starling are good to 0.3 %.
    const double states[][2] = {{0.3, 2}, {0.5, 3}};
    for (int k = 0; k < 2; k++) {
        const double density = states[k][0];
        const thermo t = run_wells(density, states[k][1], 100000);
        const square_well_state expected =
            square_well_fluid(lambda, t.temperature, density);
        const double cores = square_well_fluid(lambda, 0x1p60, density).z;
        const square_well_state besides = {
            0.02 * (cores - expected.z) + 0.003 * cores, 0.02 * -expected.energy};
        compare(density, &t, expected, besides, 0.008);
    }
}
END_TEST

int main(void)
{
    return RUN_SUITE("square well", 600, the_third_virial_coefficient_is_kiharas,
                     the_equation_of_state_is_as_others_have_it,
                     dilute_wells_have_their_virial_coefficients,
                     fluids_of_wells_have_the_published_pressure_and_energy);
}
