// SPDX-License-Identifier: MIT
#include "oracle_dyadic.h"
#include "suite.h"

enum { BITS = ORACLE_DYADIC_BITS, CASES = 5000, SEED = 1 };
#define N MPFR_RNDN

static void set_dyadic(mpfr_t z, const brink_dyadic *a)
{
    ck_assert(oracle_set_dyadic(z, a));
}

/** A random polynomial of degree 3 in doubles, and what it is: x y z + w. */
static void random_number(stream *s, brink_dyadic *a, mpfr_t exact)
{
    double x[4];
    brink_dyadic xy, z, xyz, w;
    for (int i = 0; i < 4; i++)
        x[i] = oracle_any_double(s);
    brink_dyadic_dot(&xy, 1, &x[0], &x[1]);
    brink_dyadic_double(&z, x[2]);
    brink_dyadic_mul(&xyz, &xy, &z);
    brink_dyadic_double(&w, x[3]);
    brink_dyadic_add(a, &xyz, &w);
    mpfr_set_d(exact, x[0], N);
    mpfr_mul_d(exact, exact, x[1], N);
    mpfr_mul_d(exact, exact, x[2], N);
    mpfr_add_d(exact, exact, x[3], N);
}

START_TEST(sums_differences_and_products_are_exact)
{
    stream s = stream_of_seed(SEED);
    mpfr_t a, b, z, got;
    mpfr_inits2(BITS, a, b, z, got, (mpfr_ptr)0);
    for (int i = 0; i < (int)suite_share(CASES); i++) {
        brink_dyadic x, y, r;
        random_number(&s, &x, a);
        random_number(&s, &y, b);
        brink_dyadic_add(&r, &x, &y);
        set_dyadic(got, &r);
        mpfr_add(z, a, b, N);
        ck_assert_msg(mpfr_equal_p(got, z), "add, case %d, seed %d", i, SEED);
        brink_dyadic_sub(&r, &x, &y);
        set_dyadic(got, &r);
        mpfr_sub(z, a, b, N);
        ck_assert_msg(mpfr_equal_p(got, z), "sub, case %d, seed %d", i, SEED);
        brink_dyadic_mul(&r, &x, &y);
        set_dyadic(got, &r);
        mpfr_mul(z, a, b, N);
        ck_assert_msg(mpfr_equal_p(got, z), "mul, case %d, seed %d", i, SEED);
        brink_dyadic_sub(&r, &x, &x);
        ck_assert_int_eq(r.sign, 0);
    }
    mpfr_clears(a, b, z, got, (mpfr_ptr)0);
}
END_TEST

START_TEST(rounding_is_to_nearest_even_at_any_magnitude)
{
    stream s = stream_of_seed(SEED);
    mpfr_t a;
    mpfr_init2(a, BITS);
    for (int i = 0; i < (int)suite_share(CASES); i++) {
        brink_dyadic x;
        random_number(&s, &x, a);
        double got = brink_dyadic_round(&x), right = mpfr_get_d(a, N);
        ck_assert_msg(got == right, "case %d, seed %d: got %a, exact %a", i, SEED,
                      got, right);
    }
    // Midpoints of two doubles, and their neighbours 2^-60 of an ulp away.
    for (int i = 0; i < (int)suite_share(CASES); i++) {
        int64_t m = (int64_t)(stream_bits(&s) >> 10);
        int e = stream_int(&s, -1130, 975);
        brink_dyadic x, little, y;
        brink_dyadic_integer(&x, 2 * m + 1, e - 1);
        brink_dyadic_integer(&little, stream_int(&s, -1, 1), e - 61);
        brink_dyadic_add(&y, &x, &little);
        set_dyadic(a, &y);
        double got = brink_dyadic_round(&y), right = mpfr_get_d(a, N);
        ck_assert_msg(got == right, "%lld 2^%d: got %a, exact %a", (long long)m,
                      e, got, right);
    }
    mpfr_clear(a);
}
END_TEST

// A midpoint s bits up, with nothing below it but zeros that are kept, or with
// one bit: any of them decides.
START_TEST(any_bit_below_a_midpoint_is_seen)
{
    for (int s = 1; s <= 130; s++)
        for (int m = 1; m <= 7; m += 2)
            for (int bit = -1; bit < s; bit++) {
                brink_dyadic x, one, below, y, z;
                brink_dyadic_integer(&x, (INT64_C(1) << 53) + m, s);
                brink_dyadic_integer(&one, 1, 0);
                brink_dyadic_integer(&below, 1, bit < 0 ? 0 : bit);
                brink_dyadic_add(&y, &x, &one);
                brink_dyadic_sub(&z, &y, &one);
                if (bit >= 0)
                    brink_dyadic_add(&y, &z, &below);
                const int up = bit >= 0 || m % 4 == 3; // a tie: to even
                const double right = ldexp(0x1p53 + (up ? m + 1 : m - 1), s);
                const double got = brink_dyadic_round(bit < 0 ? &z : &y);
                ck_assert_msg(got == right, "%d 2^%d, bit %d: %a, not %a", m, s,
                              bit, got, right);
            }
}
END_TEST

// Those have fewer bits, and are rounded once.
START_TEST(subnormals_are_rounded_at_their_last_bit)
{
    stream s = stream_of_seed(SEED);
    for (int i = 0; i < (int)suite_share(CASES); i++) {
        const int64_t m = (int64_t)(stream_bits(&s) >> stream_int(&s, 11, 63));
        const int side = stream_int(&s, -1, 1);
        brink_dyadic x, little, y;
        brink_dyadic_integer(&x, 2 * m + 1, -1075);
        brink_dyadic_integer(&little, side, -1075 - stream_int(&s, 1, 200));
        brink_dyadic_add(&y, &x, &little);
        const int64_t right = m + (side > 0 || (side == 0 && m % 2 == 1));
        const double got = brink_dyadic_round(&y);
        ck_assert_msg(got == ldexp((double)right, -1074),
                      "%lld + 1/2, side %d: got %a", (long long)m, side, got);
    }
}
END_TEST

START_TEST(leading_parts_are_off_by_less_than_2_uu)
{
    stream s = stream_of_seed(SEED);
    mpfr_t a, z;
    mpfr_inits2(BITS, a, z, (mpfr_ptr)0);
    for (int i = 0; i < (int)suite_share(CASES); i++) {
        brink_dyadic x;
        int e;
        random_number(&s, &x, a);
        dd m = brink_dyadic_leading(&x, &e);
        ck_assert(m.hi == 0 ? x.sign == 0 : fabs(m.hi) >= 0.5 && fabs(m.hi) <= 1);
        mpfr_set_d(z, m.hi, N);
        mpfr_add_d(z, z, m.lo, N);
        mpfr_mul_2si(z, z, e, N);
        mpfr_sub(z, z, a, N);
        if (!mpfr_zero_p(z))
            mpfr_div(z, z, a, N);
        ck_assert_double_lt(fabs(mpfr_get_d(z, N)), 0x1p-105);
    }
    mpfr_clears(a, z, (mpfr_ptr)0);
}
END_TEST

START_TEST(nothing_has_no_leading_part)
{
    brink_dyadic nothing;
    int e = 1;
    brink_dyadic_integer(&nothing, 0, 5);
    const dd m = brink_dyadic_leading(&nothing, &e);
    ck_assert(m.hi == 0 && m.lo == 0 && e == 0);
    ck_assert(brink_dyadic_round(&nothing) == 0);
}
END_TEST

START_TEST(the_largest_and_the_smallest_product_fit_together)
{
    // The worst of brink_step_impulse: degree 6, sums of six terms at both ends.
    const double big[6] = {DBL_MAX, DBL_MAX, DBL_MAX, DBL_MAX, DBL_MAX, DBL_MAX};
    const double tiny[6] = {0x1p-1074, 0, 0, 0, 0, 0};
    brink_dyadic sum[2], square[2], sixth[2], both;
    const double *end[2] = {big, tiny};
    mpfr_t a, z;
    mpfr_inits2(BITS, a, z, (mpfr_ptr)0);
    mpfr_set_zero(z, 1);
    for (int k = 0; k < 2; k++) {
        brink_dyadic_dot(&sum[k], 6, end[k], end[k]);
        brink_dyadic_mul(&square[k], &sum[k], &sum[k]);
        brink_dyadic_mul(&sixth[k], &square[k], &sum[k]);
        mpfr_set_d(a, end[k][0], N);
        mpfr_pow_ui(a, a, 6, N);
        mpfr_mul_ui(a, a, k == 0 ? 6 * 6 * 6 : 1, N);
        mpfr_add(z, z, a, N);
    }
    brink_dyadic_add(&both, &sixth[0], &sixth[1]);
    set_dyadic(a, &both);
    ck_assert(mpfr_equal_p(a, z));
    mpfr_clears(a, z, (mpfr_ptr)0);
}
END_TEST

int main(void)
{
    return RUN_SUITE("dyadic", 300, sums_differences_and_products_are_exact,
                     rounding_is_to_nearest_even_at_any_magnitude,
                     any_bit_below_a_midpoint_is_seen,
                     subnormals_are_rounded_at_their_last_bit,
                     leading_parts_are_off_by_less_than_2_uu,
                     nothing_has_no_leading_part,
                     the_largest_and_the_smallest_product_fit_together);
}
