// SPDX-License-Identifier: MIT
#include "suite.h"
#include "sum.h"
#include "system.h"
#include <float.h>
#include <gsl/gsl_rng.h>
#include <math.h>
#include <mpfr.h>
#include <stdio.h>

static const brink_potential hard = {1, (const double[]){1},
                                     (const double[]){(double)INFINITY}};
static const double box[3] = {10, 20, 1000};

static void make(brink_system *s, uint32_t count)
{
    const brink_species species = {"A", 2.0, 1.0, count};
    ck_assert_int_eq(
        brink_system_create(s, 3, box, 4.0, count, 1, &species, &hard), 0);
}

START_TEST(a_coordinate_goes_there_and_back_to_the_resolution_of_a_double)
{
    brink_system s;
    make(&s, 1);
    for (int a = 0; a < 3; a++)
        for (double x = 0; x < box[a]; x += 0.37) {
            const double back =
                brink_system_coordinate(&s, a, brink_system_fraction(&s, a, x));
            // x / L and the product with the unit round once each, to 2^-53
            // relative, the fraction to 2^-65 L.
            const double bound = x * DBL_EPSILON + ldexp(box[a], -65);
            ck_assert_msg(fabs(back - x) <= bound, "axis %d: %a, not %a", a, back,
                          x);
        }
    brink_system_destroy(&s);
}
END_TEST

START_TEST(coordinates_beyond_the_box_are_wrapped)
{
    brink_system s;
    make(&s, 1);
    ck_assert(brink_system_fraction(&s, 0, 12.5) ==
              brink_system_fraction(&s, 0, 2.5));
    ck_assert(brink_system_fraction(&s, 0, -7.5) ==
              brink_system_fraction(&s, 0, 2.5));
    ck_assert(brink_system_fraction(&s, 0, 10.0) == 0);
    ck_assert(brink_system_fraction(&s, 0, 5.0) == UINT64_C(1) << 63);
    ck_assert(brink_system_coordinate(&s, 0, UINT64_MAX) < 10.0);
    brink_system_destroy(&s);
}
END_TEST

START_TEST(the_separation_is_that_of_the_nearest_images)
{
    brink_system s;
    double r[3];
    make(&s, 2);
    for (int a = 0; a < 3; a++) {
        s.particle[0].x[a] = brink_system_fraction(&s, a, 0.25);
        s.particle[1].x[a] = brink_system_fraction(&s, a, box[a] - 0.5);
    }
    brink_system_separation(&s, 0, 1, 0.0, r);
    for (int a = 0; a < 3; a++) // 1 - 0.5 / L is rounded to 2^-54, then times L
        ck_assert(fabs(r[a] - 0.75) <= ldexp(box[a], -53));
    brink_system_destroy(&s);
}
END_TEST

// What positions are fractions for: a pair does the same wherever it is.
START_TEST(a_separation_does_not_depend_on_where_the_pair_is)
{
    const unsigned long seed = 20260103;
    printf("seed %lu\n", seed);
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(rng, seed);
    brink_system s;
    make(&s, 2);
    for (int a = 0; a < 3; a++) {
        s.particle[0].v[a] = gsl_rng_uniform(rng) - 0.5;
        s.particle[1].x[a] =
            brink_system_fraction(&s, a, 1 + gsl_rng_uniform(rng));
    }
    double here[3], there[3];
    const brink_particle first = s.particle[0], second = s.particle[1];
    brink_system_advance(&s, 0, 2.75);
    brink_system_separation(&s, 0, 1, 2.75, here);
    for (int k = 0; k < 1000; k++) {
        s.particle[0] = first;
        s.particle[1] = second;
        for (int a = 0; a < 3; a++) {
            const uint64_t shift =
                (uint64_t)gsl_rng_get(rng) << 32 | gsl_rng_get(rng);
            s.particle[0].x[a] += shift;
            s.particle[1].x[a] += shift;
        }
        brink_system_advance(&s, 0, 2.75);
        brink_system_separation(&s, 0, 1, 2.75, there);
        for (int a = 0; a < 3; a++)
            ck_assert(here[a] == there[a]);
    }
    brink_system_destroy(&s);
    gsl_rng_free(rng);
}
END_TEST

START_TEST(a_flight_of_any_length_wraps_round_the_box)
{
    brink_system s;
    make(&s, 1);
    s.particle[0].v[0] = 10.0 * 7 + 2.5; // seven times round and a quarter
    s.particle[0].v[1] = -20.0 * 3;
    brink_system_advance(&s, 0, 1.0);
    ck_assert(s.particle[0].x[0] == UINT64_C(1) << 62);
    ck_assert(s.particle[0].x[1] == 0);
    ck_assert(s.particle[0].since == 1.0);
    brink_system_destroy(&s);
}
END_TEST

START_TEST(turning_the_year_moves_everybody_to_its_first_instant)
{
    brink_system s;
    make(&s, 2);
    double x[3];
    s.particle[0].v[0] = 0.25;
    s.particle[1].v[0] = -0.25;
    brink_system_advance(&s, 1, 3.0);
    brink_system_position(&s, 0, 8.0, x);
    ck_assert(x[0] == 2.0);
    brink_system_turn(&s, 2); // two years of 4
    ck_assert(s.epoch == 2 && s.particle[0].since == 0 &&
              s.particle[1].since == 0);
    ck_assert(brink_system_coordinate(&s, 0, s.particle[0].x[0]) == 2.0);
    ck_assert(brink_system_coordinate(&s, 0, s.particle[1].x[0]) == 8.0);
    brink_system_destroy(&s);
}
END_TEST

START_TEST(sums_are_as_if_in_twice_the_precision)
{
    const unsigned long seed = 20260104;
    printf("seed %lu\n", seed);
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(rng, seed);
    mpfr_t exact, term;
    mpfr_inits2(2000, exact, term, (mpfr_ptr)0);
    mpfr_set_zero(exact, 1);
    brink_sum sum = {0};
    double all = 0;
    const int terms = 10000;
    for (int k = 0; k < terms; k++) {
        const double x =
            ldexp(gsl_rng_uniform(rng) - 0.5, (int)gsl_rng_uniform_int(rng, 90));
        const double y = gsl_rng_uniform(rng);
        brink_sum_product(&sum, x, y);
        mpfr_set_d(term, x, MPFR_RNDN);
        mpfr_mul_d(term, term, y, MPFR_RNDN);
        mpfr_add(exact, exact, term, MPFR_RNDN);
        all += fabs(x * y);
    }
    mpfr_sub_d(term, exact, brink_sum_value(&sum), MPFR_RNDN);
    // The bound of sum.h, for two additions a product.
    const double bound = DBL_EPSILON * fabs(brink_sum_value(&sum)) +
                         4.0 * terms * terms * ldexp(all, -106);
    ck_assert(fabs(mpfr_get_d(term, MPFR_RNDN)) <= bound);
    mpfr_clears(exact, term, (mpfr_ptr)0);
    gsl_rng_free(rng);
}
END_TEST

START_TEST(energy_momentum_and_temperature_are_those_of_the_textbook)
{
    brink_system s;
    double p[3];
    make(&s, 3);
    s.particle[0].v[0] = 3;
    s.particle[1].v[1] = -4;
    brink_system_momentum(&s, p);
    ck_assert(p[0] == 6 && p[1] == -8 && p[2] == 0);
    ck_assert(brink_system_kinetic_energy(&s) == 25);
    ck_assert(brink_system_temperature(&s) == 2 * 25 / 6.0);
    ck_assert(brink_system_volume(&s) == 10.0 * 20 * 1000);
    brink_system_destroy(&s);
}
END_TEST

START_TEST(the_check_sees_what_is_wrong)
{
    brink_system s;
    make(&s, 2);
    ck_assert_ptr_null(brink_system_is_valid(&s));
    s.particle[1].v[2] = (double)NAN;
    ck_assert_ptr_nonnull(brink_system_is_valid(&s));
    s.particle[1].v[2] = 0;
    s.particle[1].since = 4.0; // the year's end is the next year
    ck_assert_ptr_nonnull(brink_system_is_valid(&s));
    s.particle[1].since = 0;
    s.particle[1].species = 1;
    ck_assert_ptr_nonnull(brink_system_is_valid(&s));
    brink_system_destroy(&s);
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "system", 60,
        a_coordinate_goes_there_and_back_to_the_resolution_of_a_double,
        coordinates_beyond_the_box_are_wrapped,
        the_separation_is_that_of_the_nearest_images,
        a_separation_does_not_depend_on_where_the_pair_is,
        a_flight_of_any_length_wraps_round_the_box,
        turning_the_year_moves_everybody_to_its_first_instant,
        sums_are_as_if_in_twice_the_precision,
        energy_momentum_and_temperature_are_those_of_the_textbook,
        the_check_sees_what_is_wrong);
}
