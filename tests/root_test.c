// SPDX-License-Identifier: MIT
#include "random.h"
#include "suite.h"
#include <brink/root.h>
#include <mpfr.h>

// Coefficients of up to four doubles' bits, and what their squares need.
enum { BITS = 9000, CASES = 4000, SEED = 1 };
#define N MPFR_RNDN

/** A coefficient m 2^e both ways. */
typedef struct number {
    brink_dyadic d;
    mpfr_t m;
} number;

static void set(number *x, int64_t m, int e)
{
    brink_dyadic_integer(&x->d, m, e);
    mpfr_set_si_2exp(x->m, m, e, N);
}

static int64_t random_integer(stream *s, int bits)
{
    int64_t m = (int64_t)(stream_bits(s) >> (64 - bits));
    return stream_int(s, 0, 1) ? m : -m;
}

/** The lower and the upper root of a x^2 + 2 b x + c, by MPFR: nothing
 *  cancels. */
static void roots_by_mpfr(mpfr_t lower, mpfr_t upper, const number *a,
                          const number *b, const number *c, const mpfr_t d)
{
    mpfr_sqrt(lower, d, N);
    if (mpfr_sgn(b->m) < 0)
        mpfr_neg(lower, lower, N);
    mpfr_add(lower, lower, b->m, N);
    mpfr_neg(lower, lower, N);
    if (mpfr_zero_p(lower))
        mpfr_set_zero(upper, 1);
    else
        mpfr_div(upper, c->m, lower, N);
    mpfr_div(lower, lower, a->m, N);
    if (mpfr_greater_p(lower, upper))
        mpfr_swap(lower, upper);
}

START_TEST(roots_are_correctly_rounded)
{
    stream s = stream_of_seed(SEED);
    number a, b, c;
    brink_dyadic bb, ac, d;
    mpfr_t exact, lower, upper;
    mpfr_inits2(BITS, a.m, b.m, c.m, exact, lower, upper, (mpfr_ptr)0);
    for (int i = 0; i < (int)suite_share(CASES); i++) {
        int bits = stream_int(&s, 3, 62),
            scale = stream_int(&s, 0, 1) ? 2000 : 60;
        set(&a, random_integer(&s, bits), stream_int(&s, -scale, scale));
        set(&b, random_integer(&s, bits), stream_int(&s, -scale, scale));
        set(&c, random_integer(&s, bits), stream_int(&s, -scale, scale));
        if (i % 8 == 0)
            set(&b, 0, 0);
        brink_dyadic_mul(&bb, &b.d, &b.d);
        brink_dyadic_mul(&ac, &a.d, &c.d);
        brink_dyadic_sub(&d, &bb, &ac);
        if (a.d.sign == 0 || d.sign < 0)
            continue;
        mpfr_mul(exact, b.m, b.m, N);
        mpfr_mul(lower, a.m, c.m, N);
        mpfr_sub(exact, exact, lower, N);
        roots_by_mpfr(lower, upper, &a, &b, &c, exact);
        double x0 = brink_dyadic_root(&a.d, &b.d, &c.d, &d, BRINK_LOWER);
        double x1 = brink_dyadic_root(&a.d, &b.d, &c.d, &d, BRINK_UPPER);
        if (x0 != mpfr_get_d(lower, N) || x1 != mpfr_get_d(upper, N))
            ck_abort_msg("case %d (seed %d): got %a and %a, exact %a and %a", i,
                         SEED, x0, x1, mpfr_get_d(lower, N),
                         mpfr_get_d(upper, N));
    }
    mpfr_clears(a.m, b.m, c.m, exact, lower, upper, (mpfr_ptr)0);
}
END_TEST

START_TEST(quotients_are_correctly_rounded)
{
    stream s = stream_of_seed(SEED);
    number x, y;
    mpfr_t exact;
    mpfr_inits2(BITS, x.m, y.m, exact, (mpfr_ptr)0);
    for (int i = 0; i < (int)suite_share(CASES); i++) {
        int bits = stream_int(&s, 3, 62);
        set(&x, random_integer(&s, bits), stream_int(&s, -1200, 1200));
        set(&y, random_integer(&s, bits), stream_int(&s, -1200, 1200));
        if (y.d.sign == 0)
            continue;
        mpfr_div(exact, x.m, y.m, N);
        double got = brink_dyadic_quotient(&x.d, &y.d);
        if (got != mpfr_get_d(exact, N))
            ck_abort_msg("case %d (seed %d): got %a, exact %a", i, SEED, got,
                         mpfr_get_d(exact, N));
    }
    mpfr_clears(x.m, y.m, exact, (mpfr_ptr)0);
}
END_TEST

/** The root m 2^e (1 + nudge 2^-200), m odd and of 54 bits: at a midpoint, or
 *  beside it. */
static double root_near_midpoint(int64_t m, int e, int nudge,
                                 enum brink_which which)
{
    // (x - p)(x - q) = x^2 - (p + q) x + p q: p that root, q far below or above
    brink_dyadic one, p, q, little, sum, half, b, c, bb, d;
    brink_dyadic_integer(&one, 1, 0);
    brink_dyadic_integer(&half, -1, -1);
    brink_dyadic_integer(&little, nudge * m, e - 200);
    brink_dyadic_integer(&sum, m, e);
    brink_dyadic_add(&p, &sum, &little);
    brink_dyadic_integer(&q, which == BRINK_UPPER ? -3 * m : 3 * m, e);
    brink_dyadic_add(&sum, &p, &q);
    brink_dyadic_mul(&b, &half, &sum);
    brink_dyadic_mul(&c, &p, &q);
    brink_dyadic_mul(&bb, &b, &b);
    brink_dyadic_sub(&d, &bb, &c);
    return brink_dyadic_root(&one, &b, &c, &d, m < 0 ? 1 - which : which);
}

START_TEST(midpoints_go_to_even_and_their_neighbours_to_their_side)
{
    stream s = stream_of_seed(SEED);
    for (int i = 0; i < (int)suite_share(CASES); i++) {
        int64_t low = (int64_t)(stream_bits(&s) >> 11 | UINT64_C(1) << 52);
        int e = stream_int(&s, -1074, 970);
        double down = ldexp((double)low, e), up = ldexp((double)(low + 1), e);
        double even = low % 2 == 0 ? down : up;
        for (int which = 0; which < 2; which++)
            for (int sign = -1; sign <= 1; sign += 2) {
                enum brink_which w = (enum brink_which)which;
                int64_t m = sign * (2 * low + 1);
                ck_assert(root_near_midpoint(m, e - 1, 0, w) == sign * even);
                ck_assert(root_near_midpoint(m, e - 1, -1, w) == sign * down);
                ck_assert(root_near_midpoint(m, e - 1, 1, w) == sign * up);
            }
    }
}
END_TEST

START_TEST(a_double_root_halfway_between_two_doubles_goes_to_the_even_one)
{
    stream s = stream_of_seed(SEED);
    for (int i = 0; i < (int)suite_share(CASES); i++) {
        const int64_t low = (int64_t)(stream_bits(&s) >> 11 | UINT64_C(1) << 52);
        const double even = (double)(low + low % 2);
        for (int sign = -1; sign <= 1; sign += 2) { // a (x - m)^2, a = sign
            brink_dyadic a, m, b, c, square, d;
            brink_dyadic_integer(&a, sign, 0);
            brink_dyadic_integer(&m, 2 * low + 1, -1);
            brink_dyadic_integer(&d, 0, 0);
            brink_dyadic_mul(&square, &m, &m);
            brink_dyadic_mul(&c, &a, &square);
            brink_dyadic_integer(&b, -sign * (2 * low + 1), -1);
            ck_assert(brink_dyadic_root(&a, &b, &c, &d, BRINK_LOWER) == even);
            ck_assert(brink_dyadic_root(&a, &b, &c, &d, BRINK_UPPER) == even);
        }
    }
}
END_TEST

/* Two roots 2^-94 apart whose vertex is 2^-90 to this side or that of a midpoint
 * near 1: the polynomial's value at the midpoint is the same for both of them, so
 * it is its slope that tells. */
START_TEST(two_roots_close_to_a_midpoint_go_to_their_side)
{
    stream s = stream_of_seed(SEED);
    for (int i = 0; i < CASES; i++) {
        const int64_t low = (int64_t)(stream_bits(&s) >> 11 | UINT64_C(1) << 52);
        for (int side = -1; side <= 1; side += 2) {
            brink_dyadic one, zero, half, off, vertex, b, square, d, c;
            brink_dyadic_integer(&one, 1, 0);
            brink_dyadic_integer(&zero, 0, 0);
            brink_dyadic_integer(&half, 2 * low + 1, -53);
            brink_dyadic_integer(&off, side, -90);
            brink_dyadic_add(&vertex, &half, &off);
            brink_dyadic_sub(&b, &zero, &vertex); // (x - vertex)^2 - d
            brink_dyadic_integer(&d, 1, -190);
            brink_dyadic_mul(&square, &vertex, &vertex);
            brink_dyadic_sub(&c, &square, &d);
            const double there = ldexp((double)(low + (side > 0)), -52);
            ck_assert(brink_dyadic_root(&one, &b, &c, &d, BRINK_LOWER) == there);
            ck_assert(brink_dyadic_root(&one, &b, &c, &d, BRINK_UPPER) == there);
        }
    }
}
END_TEST

START_TEST(a_root_at_0_is_0)
{
    brink_dyadic one, two, zero;
    brink_dyadic_integer(&zero, 0, 0);
    brink_dyadic_integer(&one, 1, 0);
    brink_dyadic_integer(&two, 2, 0);
    ck_assert(brink_dyadic_quotient(&zero, &two) == 0);
    // x^2 and x^2 + 2 x
    ck_assert(brink_dyadic_root(&two, &zero, &zero, &zero, BRINK_UPPER) == 0);
    ck_assert(brink_dyadic_root(&one, &one, &zero, &one, BRINK_UPPER) == 0);
    ck_assert(brink_dyadic_root(&one, &one, &zero, &one, BRINK_LOWER) == -2);
}
END_TEST

START_TEST(a_discriminant_far_below_1_is_not_lost_beside_a_b_of_0)
{
    brink_dyadic a, zero, c, d; // 2^-1500 (x^2 - 1)
    brink_dyadic_integer(&a, 1, -1500);
    brink_dyadic_integer(&zero, 0, 0);
    brink_dyadic_integer(&c, -1, -1500);
    brink_dyadic_integer(&d, 1, -3000);
    ck_assert(brink_dyadic_root(&a, &zero, &c, &d, BRINK_LOWER) == -1);
    ck_assert(brink_dyadic_root(&a, &zero, &c, &d, BRINK_UPPER) == 1);
}
END_TEST

START_TEST(roots_that_no_double_tells_apart_are_found)
{
    brink_dyadic one, b, bb, d, c; // (x + b)^2 = d
    brink_dyadic_integer(&one, 1, 0);
    brink_dyadic_integer(&d, 1, -1400);
    for (int sign = -1; sign <= 1; sign += 2) {
        brink_dyadic_integer(&b, sign, 600);
        brink_dyadic_mul(&bb, &b, &b);
        brink_dyadic_sub(&c, &bb, &d);
        for (int which = BRINK_LOWER; which <= BRINK_UPPER; which++) {
            const double x =
                brink_dyadic_root(&one, &b, &c, &d, (enum brink_which)which);
            ck_assert_msg(x == -sign * 0x1p600, "sign %d, which %d: %a", sign,
                          which, x);
        }
    }
}
END_TEST

START_TEST(the_edges_of_the_range_round_as_ieee_has_it)
{
    brink_dyadic x, y;
    brink_dyadic_integer(&y, 1, 0);
    brink_dyadic_integer(&x, 1, -1075); // half of the least double: a tie, to 0
    ck_assert(brink_dyadic_quotient(&x, &y) == 0);
    brink_dyadic_integer(&x, 3, -1076);
    ck_assert(brink_dyadic_quotient(&x, &y) == 0x1p-1074);
    brink_dyadic_integer(&x, (INT64_C(1) << 54) - 1, 970); // tie with 2^1024
    ck_assert(isinf(brink_dyadic_quotient(&x, &y)));
    brink_dyadic_integer(&x, (INT64_C(1) << 55) - 3, 969);
    ck_assert(brink_dyadic_quotient(&x, &y) == DBL_MAX);
    brink_dyadic_integer(&x, -5, 4000);
    ck_assert(brink_dyadic_quotient(&x, &y) == -(double)INFINITY);
    brink_dyadic_integer(&x, -5, -4000);
    double zero = brink_dyadic_quotient(&x, &y);
    ck_assert(zero == 0 && signbit(zero));
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "root", 300, roots_are_correctly_rounded, quotients_are_correctly_rounded,
        midpoints_go_to_even_and_their_neighbours_to_their_side,
        a_double_root_halfway_between_two_doubles_goes_to_the_even_one,
        two_roots_close_to_a_midpoint_go_to_their_side, a_root_at_0_is_0,
        a_discriminant_far_below_1_is_not_lost_beside_a_b_of_0,
        roots_that_no_double_tells_apart_are_found,
        the_edges_of_the_range_round_as_ieee_has_it);
}
