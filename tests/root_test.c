// SPDX-License-Identifier: MIT
// Correctly rounded roots against what rounds correctly by itself: the hardware's
// quotient and square root, and polynomials made from the roots they have.
#include "suite.h"
#include <brink/root.h>
#include <gsl/gsl_rng.h>
#include <math.h>
#include <stdio.h>

static gsl_rng *seeded(unsigned long seed)
{
    printf("seed %lu\n", seed);
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(rng, seed);
    return rng;
}

// Any finite double but 0, all exponents alike.
static double any(gsl_rng *rng)
{
    for (;;) {
        const uint64_t bits = (uint64_t)gsl_rng_get(rng) << 32 | gsl_rng_get(rng);
        const double x = double_of(bits);
        if (isfinite(x) && x != 0)
            return x;
    }
}

START_TEST(a_quotient_is_the_hardware_s_over_and_underflow_included)
{
    gsl_rng *rng = seeded(1);
    for (int k = 0; k < 100000; k++) {
        const double x = any(rng), y = any(rng);
        brink_dyadic dx, dy;
        brink_dyadic_double(&dx, x);
        brink_dyadic_double(&dy, y);
        const double q = brink_dyadic_quotient(&dx, &dy);
        ck_assert_msg(q == x / y, "%a / %a is %a, not %a", x, y, x / y, q);
    }
    gsl_rng_free(rng);
}
END_TEST

// x^2 - s: b = 0, c = -s, d = s; the roots are -sqrt(s) and sqrt(s).
START_TEST(a_square_root_is_the_hardware_s)
{
    gsl_rng *rng = seeded(2);
    for (int k = 0; k < 100000; k++) {
        const double s = fabs(any(rng));
        brink_dyadic a, b, c, d;
        brink_dyadic_integer(&a, 1, 0);
        brink_dyadic_integer(&b, 0, 0);
        brink_dyadic_double(&c, -s);
        brink_dyadic_double(&d, s);
        const double low = brink_dyadic_root(&a, &b, &c, &d, BRINK_LOWER);
        const double high = brink_dyadic_root(&a, &b, &c, &d, BRINK_UPPER);
        ck_assert_msg(low == -sqrt(s) && high == sqrt(s), "s = %a: %a, %a", s,
                      low, high);
    }
    gsl_rng_free(rng);
}
END_TEST

// (2 x - (p + q))^2 - (q - p)^2 over 4 has the roots p and q, here of up to 62
// bits: each rounds to (double)p, ties to even included, as a conversion does.
START_TEST(an_exact_root_of_many_bits_is_rounded_to_nearest_even)
{
    gsl_rng *rng = seeded(3);
    for (int k = 0; k < 100000; k++) {
        // p a tie between two doubles every other time: 54 bits, the last of them
        // set
        const int64_t left = (int64_t)gsl_rng_get(rng);
        const int64_t right = (int64_t)gsl_rng_get(rng);
        const int64_t p =
            k % 2 ? INT64_C(1) << 53 | left << 1 | 1 : left << 29 | right;
        const int64_t q = p + 1 + (int64_t)gsl_rng_get(rng);
        brink_dyadic a, b, c, d, dp, dq, sum, half, gap;
        brink_dyadic_integer(&a, 1, 0);
        brink_dyadic_integer(&dp, p, 0);
        brink_dyadic_integer(&dq, q, 0);
        brink_dyadic_integer(&half, -1, -1);
        brink_dyadic_add(&sum, &dp, &dq);
        brink_dyadic_mul(&b, &half, &sum); // -(p + q) / 2
        brink_dyadic_mul(&c, &dp, &dq);
        brink_dyadic_sub(&sum, &dp, &dq);
        brink_dyadic_mul(&gap, &half, &sum);
        brink_dyadic_mul(&d, &gap, &gap); // ((q - p) / 2)^2
        const double low = brink_dyadic_root(&a, &b, &c, &d, BRINK_LOWER);
        const double high = brink_dyadic_root(&a, &b, &c, &d, BRINK_UPPER);
        ck_assert_msg(low == (double)p && high == (double)q,
                      "%jd and %jd: %a, %a", (intmax_t)p, (intmax_t)q, low, high);
    }
    gsl_rng_free(rng);
}
END_TEST

int main(void)
{
    return RUN_SUITE("root", 120,
                     a_quotient_is_the_hardware_s_over_and_underflow_included,
                     a_square_root_is_the_hardware_s,
                     an_exact_root_of_many_bits_is_rounded_to_nearest_even);
}
