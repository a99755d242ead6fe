// SPDX-License-Identifier: MIT
// How fast particles are when a configuration is first made.
#include "outcome.h"
#include "start_kinetic.h"
#include "suite.h"
#include <math.h>
#include <string.h>

START_TEST(the_temperature_is_the_one_asked_for)
{
    static const int counts[] = {1, 2, 3, 10, 1000};
    for (size_t k = 0; k < sizeof counts / sizeof *counts; k++)
        for (int seed = 0; seed < 40; seed++) {
            char text[256];
            snprintf(text, sizeof text,
                     "seed: %d\ndimensions: %d\nbox: {number_density: 0.01}\n"
                     "species: {A: {count: %d, mass: 0.7, diameter: 0.1}}\n"
                     "temperature: 1.%d\n",
                     seed, 2 + seed % 2, counts[k], seed);
            outcome o = good_start(text);
            const double t = brink_system_temperature(&o.system);
            ck_assert_msg(fabs(t - o.scene.temperature) <=
                              BRINK_KINETIC_ERROR * o.scene.temperature,
                          "%a, not %a, in\n%s", t, o.scene.temperature, text);
            forget(&o);
        }
}
END_TEST

START_TEST(the_centre_of_mass_is_at_rest)
{
    outcome o = good_start("box: {number_density: 0.1}\nspecies: \n"
                           "  A: {count: 700, diameter: 1, mass: 1}\n"
                           "  B: {count: 300, diameter: 1, mass: 9}\n");
    double p[3], sum = 0;
    brink_system_momentum(&o.system, p);
    for (uint32_t i = 0; i < 1000; i++)
        for (int a = 0; a < 3; a++)
            sum += (i < 700 ? 1 : 9) * fabs(o.system.particle[i].v[a]);
    // What is subtracted is rounded, the difference is rounded, the product is
    // rounded: 3 roundings of 2^-53 |m v| for each particle at the most.
    for (int a = 0; a < 3; a++)
        ck_assert_msg(fabs(p[a]) <= 3 * 0x1p-53 * sum, "%a", p[a]);
    forget(&o);
}
END_TEST

START_TEST(velocities_are_those_of_maxwell_and_boltzmann_in_every_species)
{
    outcome o =
        good_start("box: {number_density: 0.1}\ntemperature: 2.5\nspecies:\n"
                   "  A: {count: 20000, diameter: 1, mass: 1}\n"
                   "  B: {count: 20000, diameter: 1, mass: 16}\n");
    for (int a = 0; a < 2; a++) {
        const int n = 60000;
        double second = 0, fourth = 0;
        for (int k = 0; k < n; k++) {
            const double v = o.system.particle[20000 * a + k / 3].v[k % 3];
            const double u2 = o.scene.species[a].mass / 2.5 * v * v;
            second += u2 / n;
            fourth += u2 * u2 / n;
        }
        // Moments of the normal distribution, 1 and 3, within 5 deviations: those
        // of u^2 and u^4 are sqrt(3 - 1) and sqrt(105 - 9).
        ck_assert_msg(fabs(second - 1) < 5 * sqrt(2.0 / n), "%a", second);
        ck_assert_msg(fabs(fourth - 3) < 5 * sqrt(96.0 / n), "%a", fourth);
    }
    forget(&o);
}
END_TEST

START_TEST(the_year_is_a_power_of_two_near_the_time_to_an_event)
{
    // The mean speed is sqrt(8 / pi) = 1.596.  Dilute square wells: a meeting in
    // 1 / (sqrt(2) 1e-3 pi 9 1.596) = 15.7, a flight of 10 in 6.27; nearest 2^3.
    outcome o =
        good_start("box: {number_density: 1.0e-3}\n"
                   "species: {A: {count: 1372}}\npotentials:\n"
                   "  - {between: [A, A], steps: [[3, -1], [1, .inf]]}\n");
    ck_assert(o.system.year == 8.0);
    forget(&o);
    // Denser ones of reach 1.5: 1 / (sqrt(2) 0.5 pi 2.25 1.596) = 0.125, against
    // 0.789.
    o = good_start(
        "box: {number_density: 0.5}\nspecies: {A: {count: 500}}\npotentials:\n"
        "  - {between: [A, A], steps: [[1.5, -1], [1, .inf]]}\n");
    ck_assert(o.system.year == 0.125);
    forget(&o);
    // Discs: sqrt(pi / 2) = 1.253; 1 / (sqrt(2) 0.35 2 1.253) = 0.806, against
    // 1.35.
    o = good_start("dimensions: 2\nbox: {number_density: 0.35}\n"
                   "species: {A: {count: 500, diameter: 1}}\n");
    ck_assert(o.system.year == 1.0);
    // At rest there is nothing to wait for.
    for (uint32_t i = 0; i < 500; i++)
        memset(o.system.particle[i].v, 0, sizeof o.system.particle[i].v);
    ck_assert(brink_kinetic_year(&o.system) == 1.0);
    forget(&o);
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "kinetic", 120, the_temperature_is_the_one_asked_for,
        the_centre_of_mass_is_at_rest,
        velocities_are_those_of_maxwell_and_boltzmann_in_every_species,
        the_year_is_a_power_of_two_near_the_time_to_an_event);
}
