// SPDX-License-Identifier: MIT
/* Sums against exact ones. */
#include "suite.h"
#include "sum.h"
#include <float.h>
#include <gsl/gsl_rng.h>
#include <mpfr.h>

enum {
    TERMS = 1000,
    EXACT = 2200, // bits from 2^-1074 to 2^1024 and some: sums here are exact
};

/** The sum of `terms` is within 1 ulp + n^2 2^-106 sum |terms| of the exact
 *  one. */
static void check(const brink_sum *sum, const double *x, const double *y, int n)
{
    mpfr_t exact, product, size;
    mpfr_inits2(EXACT, exact, product, size, (mpfr_ptr)0);
    mpfr_set_zero(exact, 1);
    mpfr_set_zero(size, 1);
    for (int k = 0; k < n; k++) {
        mpfr_set_d(product, x[k], MPFR_RNDN);
        mpfr_mul_d(product, product, y[k], MPFR_RNDN);
        mpfr_add(exact, exact, product, MPFR_RNDN);
        mpfr_abs(product, product, MPFR_RNDN);
        mpfr_add(size, size, product, MPFR_RNDN);
    }
    const double ulp = fabs(mpfr_get_d(exact, MPFR_RNDN)) * DBL_EPSILON;
    const double bound =
        ulp + (double)n * n * 0x1p-106 * mpfr_get_d(size, MPFR_RNDU);
    mpfr_sub_d(exact, exact, brink_sum_value(sum), MPFR_RNDN);
    const double off = fabs(mpfr_get_d(exact, MPFR_RNDN));
    ck_assert_msg(off <= bound, "%d terms: off by %a, not %a", n, off, bound);
    mpfr_clears(exact, product, size, (mpfr_ptr)0);
}

/** Terms of all sizes from 2^-60 to 2^60, either sign, the second half taking
 *  the first away again but for a rounding: plain summation has not a digit
 *  right. */
static void cancelling(double x[TERMS], gsl_rng *rng)
{
    for (int k = 0; k < TERMS / 2; k++) {
        const double size = ldexp(1, (int)gsl_rng_uniform_int(rng, 121) - 60);
        x[k] = size * (2 * gsl_rng_uniform(rng) - 1);
        x[TERMS - 1 - k] = -x[k] * (1 + DBL_EPSILON);
    }
}

START_TEST(sums_that_cancel_keep_their_digits)
{
    double x[TERMS], one[TERMS], plain = 0;
    brink_sum sum = {0, 0};
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
    cancelling(x, rng);
    for (int k = 0; k < TERMS; k++) {
        one[k] = 1;
        plain += x[k];
        brink_sum_add(&sum, x[k]);
    }
    check(&sum, x, one, TERMS);
    ck_assert_double_ne(plain, brink_sum_value(&sum));
    gsl_rng_free(rng);
}
END_TEST

START_TEST(sums_of_products_that_cancel_keep_their_digits)
{
    double x[TERMS], y[TERMS];
    brink_sum sum = {0, 0};
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
    cancelling(x, rng);
    for (int k = 0; k < TERMS; k++) {
        y[k] = k < TERMS / 2 ? 1 + gsl_rng_uniform(rng) : y[TERMS - 1 - k];
        brink_sum_product(&sum, x[k], y[k]);
    }
    check(&sum, x, y, TERMS);
    gsl_rng_free(rng);
}
END_TEST

START_TEST(what_a_large_term_hides_comes_back_when_it_is_taken_away)
{
    brink_sum sum = {0, 0};
    brink_sum_add(&sum, 1);
    brink_sum_add(&sum, 0x1p100);
    brink_sum_add(&sum, 0x1p-40);
    brink_sum_add(&sum, -0x1p100);
    ck_assert_double_eq(brink_sum_value(&sum), 1 + 0x1p-40);
}
END_TEST

int main(void)
{
    return RUN_SUITE("sum", 60, sums_that_cancel_keep_their_digits,
                     sums_of_products_that_cancel_keep_their_digits,
                     what_a_large_term_hides_comes_back_when_it_is_taken_away);
}
