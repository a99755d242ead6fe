// SPDX-License-Identifier: MIT
#include "clock.h"
#include "suite.h"
#include <gsl/gsl_rng.h>
#include <math.h>
#include <mpfr.h>
#include <stdio.h>

#define YEAR 0.25

START_TEST(a_sum_within_the_year_stays_in_it)
{
    const brink_instant t =
        brink_instant_after(YEAR, (brink_instant){7, 0.125}, 0.0625);
    ck_assert(t.epoch == 7 && t.offset == 0.1875);
}
END_TEST

START_TEST(a_sum_that_is_the_year_begins_the_next)
{
    const brink_instant t =
        brink_instant_after(YEAR, (brink_instant){7, 0.125}, 0.125);
    ck_assert(t.epoch == 8 && t.offset == 0.0);
}
END_TEST

START_TEST(waiting_for_ever_is_never)
{
    const brink_instant t = {7, 0.125};
    ck_assert(brink_instant_after(YEAR, t, (double)INFINITY).epoch == INT64_MAX);
    ck_assert(brink_instant_after(YEAR, t, 1e300).epoch == INT64_MAX);
    ck_assert(brink_instant_after(YEAR, BRINK_NEVER, 1.0).epoch == INT64_MAX);
    ck_assert(isinf(brink_instant_since(YEAR, BRINK_NEVER, t)));
    ck_assert(brink_instant_compare(t, BRINK_NEVER) < 0);
}
END_TEST

// t + dt against MPFR: the one rounding allowed is of offset + dt to a double.
START_TEST(a_sum_is_rounded_once_from_its_own_year)
{
    const unsigned long seed = 20260101;
    printf("seed %lu\n", seed);
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(rng, seed);
    mpfr_t exact, got;
    mpfr_inits2(300, exact, got, (mpfr_ptr)0);
    for (int k = 0; k < 100000; k++) {
        const brink_instant t = {(int64_t)gsl_rng_get(rng) << 20,
                                 YEAR * gsl_rng_uniform(rng)};
        const double dt = exp2(60 * gsl_rng_uniform(rng) - 40);
        const brink_instant sum = brink_instant_after(YEAR, t, dt);
        mpfr_set_d(exact, t.offset + dt, MPFR_RNDN); // the rounding
        mpfr_set_sj(got, sum.epoch - t.epoch, MPFR_RNDN);
        mpfr_mul_d(got, got, YEAR, MPFR_RNDN);
        mpfr_add_d(got, got, sum.offset, MPFR_RNDN);
        ck_assert_msg(mpfr_equal_p(got, exact) && sum.offset >= 0 &&
                          sum.offset < YEAR,
                      "offset %a, dt %a", t.offset, dt);
    }
    mpfr_clears(exact, got, (mpfr_ptr)0);
    gsl_rng_free(rng);
}
END_TEST

START_TEST(an_instant_late_in_a_long_run_is_as_fine_as_an_early_one)
{
    const int64_t late = INT64_C(1) << 60;
    const brink_instant t = {late, 0.125};
    const brink_instant next = brink_instant_after(YEAR, t, 0x1p-55);
    ck_assert(next.epoch == late && next.offset == 0.125 + 0x1p-55);
    ck_assert(brink_instant_since(YEAR, next, t) == 0x1p-55);
    ck_assert(brink_instant_compare(t, next) < 0);
}
END_TEST

START_TEST(a_time_as_one_double_goes_there_and_back)
{
    for (double time = 0; time < 100; time += 0.7) {
        const brink_instant t = brink_instant_at(YEAR, time);
        ck_assert(brink_instant_time(YEAR, t) == time);
        ck_assert(t.offset >= 0 && t.offset < YEAR);
    }
}
END_TEST

int main(void)
{
    return RUN_SUITE("clock", 60, a_sum_within_the_year_stays_in_it,
                     a_sum_that_is_the_year_begins_the_next,
                     waiting_for_ever_is_never,
                     a_sum_is_rounded_once_from_its_own_year,
                     an_instant_late_in_a_long_run_is_as_fine_as_an_early_one,
                     a_time_as_one_double_goes_there_and_back);
}
