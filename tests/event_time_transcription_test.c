// SPDX-License-Identifier: MIT
// What Coq, Gappa and cvc5 are told event_time_*.h do is what they do.
#include "transcribed/event_time_bits_smt2.h"
#include "transcribed/event_time_discriminant_v.h"
#include "transcribed/event_time_far_g.h"
#include "transcribed/event_time_fast_v.h"
#include "transcribed/event_time_meeting_g.h"
#include "transcribed/event_time_meeting_smt2.h"
#include "transcribed/event_time_near_v.h"
#include "transcribed/event_time_parting_smt2.h"
#include "transcribed/event_time_sums_v.h"
#include "transcribed/event_time_underflow_v.h"
#include "transcribed/event_time_verdicts_v.h"
#include <brink/event_time_fast.h>
#include <brink/event_time_meeting.h>
#include <brink/event_time_parting.h>

/** Any double, a number or not; often at one end or the other of a range, often
 *  a power of two there, or 0. */
static double any_double(stream *s)
{
    const uint64_t end[] = {0, 511, 767, 1023, 1279, 1535, 2047};
    const uint64_t sign = UINT64_C(1) << 63, field = UINT64_C(0x7ff) << 52;
    const uint64_t bits = stream_bits(s);
    if (stream_int(s, 0, 1))
        return double_of(bits);
    const uint64_t exponent = end[stream_int(s, 0, 6)] - (bits >> 1 & 1);
    const uint64_t rest = bits & 1 ? bits & ~field : bits & sign;
    return double_of(rest | (exponent << 52 & field));
}

static double any_number(stream *s)
{
    const double x = any_double(s);
    return isfinite(x) ? x : 1;
}

// --- Times ---------------------------------------------------------------------

static double meeting_time(double b, double c, double d)
{
    const meeting m = {.b = b, .c = c, .d = d};
    return time_of_meeting(&m);
}

START_TEST(the_time_of_meeting_is_that_of_the_scripts)
{
    EACH_INPUT(s)
    {
        double b = within(&s, event_time_meeting_g_b_range);
        double c = within(&s, event_time_meeting_g_c_range);
        double d = within(&s, event_time_meeting_g_dr_range);
        SAME(event_time_meeting_g_t(c, b, d), meeting_time(b, c, d), b, c, d);
        b = any_number(&s), c = any_number(&s), d = any_double(&s);
        SAME(event_time_meeting_smt2_t(b, c, d), meeting_time(b, c, d), b, c, d);
    }
}
END_TEST

START_TEST(the_time_of_parting_is_that_of_the_scripts)
{
    EACH_INPUT(s)
    {
        double a = within(&s, event_time_far_g_a_range);
        double b = -within(&s, event_time_far_g_b_range);
        double d = within(&s, event_time_far_g_dr_range);
        double c = stream_scaled(&s, -450, 450); // of no matter where b < 0
        SAME(event_time_far_g_t(a, -b, d), later_root(a, b, c, sqrt(d)), a, b, c,
             d);
        b = -within(&s, event_time_far_g_p_range);
        SAME(event_time_far_g_passing(a, -b), passing_time(a, b), a, b);
        a = fabs(any_number(&s)), b = any_number(&s), c = any_number(&s);
        d = any_double(&s);
        SAME(event_time_parting_smt2_t(a, b, c, d),
             later_root(a, b, c, sqrt(fabs(d))), a, b, c, d);
    }
}
END_TEST

// --- Sums ----------------------------------------------------------------------

/** Vectors whose product may cancel, a radius as large as r or all but so. */
typedef struct vectors {
    double r[3], v[3], sigma;
} vectors;

static vectors any_vectors(stream *s)
{
    vectors x;
    for (int k = 0; k < 3; k++) {
        x.r[k] = stream_scaled(s, -20, 20);
        x.v[k] = stream_scaled(s, -20, 20);
    }
    if (stream_int(s, 0, 1))
        x.v[2] = -(x.r[0] * x.v[0] + x.r[1] * x.v[1]) / x.r[2];
    x.sigma = stream_near(s, sqrt(dot_rounded(x.r, x.r)), 50);
    if (stream_int(s, 0, 3) == 0)
        x.sigma *= fabs(stream_scaled(s, -3, 3));
    return x;
}

#define PRODUCTS(x, y)                                                           \
    (product){(x)[0], (y)[0]}, (product){(x)[1], (y)[1]}, (product)              \
    {                                                                            \
        (x)[2], (y)[2]                                                           \
    }
#define NUMBERS(x)                                                               \
    (x).r[0], (x).r[1], (x).r[2], (x).v[0], (x).v[1], (x).v[2], (x).sigma

START_TEST(the_sums_are_those_of_the_proof)
{
    EACH_INPUT(s)
    {
        const vectors x = any_vectors(&s);
        const product ss = {x.sigma, x.sigma};
        SAME(event_time_sums_v_dot_rounded(PRODUCTS(x.r, x.v)),
             dot_rounded(x.r, x.v), NUMBERS(x));
        SAME_DD(event_time_sums_v_dot_of(PRODUCTS(x.r, x.v)), dot_of(x.r, x.v),
                NUMBERS(x));
        SAME_DD(event_time_sums_v_c_of(PRODUCTS(x.r, x.r), ss),
                sums_of(x.r, x.v, x.sigma).c, NUMBERS(x));
        const two_dots dots = {dot_of(x.r, x.v), dot_of(x.r, x.r)};
        SAME(sum_of(event_time_sums_v_near_c(PRODUCTS(x.r, x.r), ss)),
             near_sums_of(dots, x.sigma).c, NUMBERS(x));
    }
}
END_TEST

/** Of numbers as small that their products underflow, some or all. */
START_TEST(sums_that_underflow_are_those_of_the_proof)
{
    EACH_INPUT(s)
    {
        vectors x = any_vectors(&s);
        for (int k = 0; k < 3; k++) {
            x.r[k] = ldexp(x.r[k], -500 - 40 * stream_int(&s, 0, 1));
            x.v[k] = ldexp(x.v[k], -500 - 40 * stream_int(&s, 0, 1));
        }
        x.sigma = ldexp(x.sigma, -520);
        const product ss = {x.sigma, x.sigma};
        SAME(event_time_underflow_v_dot_rounded(PRODUCTS(x.r, x.v)),
             dot_rounded(x.r, x.v), NUMBERS(x));
        const dd dot = event_time_underflow_v_dot_of(PRODUCTS(x.r, x.v));
        const dd our_dot = dot_of(x.r, x.v), our_c = sums_of(x.r, x.v, x.sigma).c;
        const dd c = event_time_underflow_v_c_of(PRODUCTS(x.r, x.r), ss);
        SAME(dot.hi, our_dot.hi, NUMBERS(x));
        SAME(dot.lo + 0, our_dot.lo + 0, NUMBERS(x)); // 0 has no sign there
        SAME(c.hi, our_c.hi, NUMBERS(x));
        SAME(c.lo + 0, our_c.lo + 0, NUMBERS(x));
    }
}
END_TEST

START_TEST(the_discriminant_is_that_of_the_proof)
{
    EACH_INPUT(s)
    {
        const vectors x = any_vectors(&s);
        const sums m = sums_of(x.r, x.v, x.sigma);
        SAME(event_time_discriminant_v_discriminant_of(m.a.hi, m.a.lo, m.b.hi,
                                                       m.b.lo, m.c.hi, m.c.lo),
             discriminant_of(&m).d, NUMBERS(x));
    }
}
END_TEST

/** The numbers that the fast times are made of. */
START_TEST(the_outline_is_that_of_the_proof)
{
    EACH_INPUT(s)
    {
        const vectors x = any_vectors(&s);
        const double *r = x.r, *v = x.v;
        const outline o = outline_of(r, v, x.sigma);
        SAME(event_time_fast_v_a(v[0], v[1], v[2]), o.a, NUMBERS(x));
        SAME(event_time_fast_v_b(r[0], r[1], r[2], v[0], v[1], v[2]), o.b,
             NUMBERS(x));
        SAME(event_time_fast_v_w(r[0], r[1], r[2], v[0], v[1], v[2]), o.w,
             NUMBERS(x));
        SAME(event_time_fast_v_minus_d(r[0], r[1], r[2], v[0], v[1], v[2],
                                       x.sigma),
             o.minus_d, NUMBERS(x));
    }
}
END_TEST

/** Most of them at the margin, where either may be said. */
START_TEST(the_filters_are_those_of_the_proof)
{
    EACH_INPUT(s)
    {
        const double ss = fabs(stream_scaled(&s, -40, 40));
        const double rr = stream_near(&s, (1 + 0x1p-10) * ss, 4);
        SAME(event_time_sums_v_is_far(rr, ss), is_far(rr, ss), rr, ss);
        const double a = fabs(stream_scaled(&s, -40, 40));
        const double c = fabs(stream_scaled(&s, -40, 40));
        const double b = stream_near(&s, -sqrt((1 - 0x1p-38) * (a * c)), 4);
        SAME(event_time_sums_v_passes(a, b, c), passes(a, b, c), a, b, c);
    }
}
END_TEST

// --- Verdicts ------------------------------------------------------------------

/** a, b, c, d at one margin or another of the verdicts: whether b is certain, c
 *  known, d large. */
START_TEST(near_times_and_their_verdicts_are_those_of_the_proof)
{
    EACH_INPUT(s)
    {
        const double a = fabs(stream_scaled(&s, -40, 40));
        const double size = fabs(stream_scaled(&s, -40, 40));
        const double least = sqrt(0x1p-200 * a * size), e = 0x1.cp-104 * size;
        const int which = stream_int(&s, 0, 4);
        double b = stream_scaled(&s, -60, 60), c = stream_scaled(&s, -60, 60);
        if (which < 2)
            b = stream_near(&s, least, 2);
        if (which == 1 || which == 2)
            c = stream_near(&s, which == 1 ? 2 * e : -0x1.68p51 * e, 2);
        if (which == 3)
            c = stream_near(&s, b * b / (4 * a), 2); // d is 3/4 b^2
        if (which == 4)
            c = fabs(c), b = -stream_near(&s, sqrt(a * (0x1p55 * e + c)), 2);
        const near_sums m = {b, c, e, size};
        const discriminant d = discriminant_near(&m, a);
        SAME(event_time_near_v_near_d(a, b, c), d.d, a, b, c);
        const int large = event_time_near_v_is_large(b, d.d) &&
                          event_time_near_v_is_large_beside_c(a, d.d, e);
        const int now = event_time_near_v_is_outside(c, e) &&
                        event_time_near_v_is_leaving(a, b, size);
        SAME(event_time_near_v_is_inside(c, e) || (b < 0 && large) ||
                 (b > 0 && now),
             d.certain, a, b, c, size);
        if (d.d > 0 && (b < 0 || c < 0))
            SAME(event_time_near_v_near_root(a, b, c, d.d),
                 later_root(a, b, c, sqrt(d.d)), a, b, c);
    }
}
END_TEST

START_TEST(verdicts_on_meetings_are_those_of_the_proof)
{
    EACH_INPUT(s)
    {
        const double a = fabs(stream_scaled(&s, -40, 40));
        const double size = fabs(stream_scaled(&s, -40, 40)),
                     e = 0x1.8p-104 * size;
        const double least = sqrt(0x1p-200 * a * size);
        double b = stream_sign(&s) * stream_near(&s, least, 2);
        double c =
            stream_near(&s, stream_int(&s, 0, 1) ? -2 * e : 0x1.68p51 * e, 2);
        if (stream_int(&s, 0, 1))
            b = stream_scaled(&s, -40, 40);
        const sums m = {{a, 0}, {b, 0}, {c, 0}, e, size};
        const discriminant d = discriminant_of(&m);
        const meeting told = meeting_of(&m);
        const int is_b_certain =
            event_time_verdicts_v_is_b_certain(a, b, size, 0x1p-900);
        SAME(b < 0 && is_b_certain && event_time_verdicts_v_is_inside(c, e),
             told.now, a, b, c, size);
        SAME(b < 0 && d.certain && event_time_verdicts_v_is_known(c, e),
             told.later, a, b, c, size);
        if (d.d >= 0) // it does not pass by
            SAME(b > 0 && is_b_certain, told.never, a, b, c, size);
    }
}
END_TEST

START_TEST(pairs_that_part_are_those_of_the_proof)
{
    EACH_INPUT(s)
    {
        const double x = stream_scaled(&s, -40, 40),
                     y = stream_scaled(&s, -40, 40);
        const double r[3] = {x, 0, 0};
        const double v[3] = {stream_near(&s, 0x1p-50 * y, 4), y, 0};
        const double a = dot_rounded(v, v), b = dot_rounded(r, v);
        SAME(b > 0 && event_time_verdicts_v_parts(a, b, dot_rounded(r, r)),
             is_certain_to_miss(r, v, fabs(x)), x, v[0], y);
    }
}
END_TEST

// --- Bits ----------------------------------------------------------------------

START_TEST(bits_mean_what_the_script_says)
{
    EACH_INPUT(s)
    {
        const double a = any_double(&s), b = any_double(&s), c = any_double(&s);
        const uint64_t x = bits_of(a), y = bits_of(b), z = bits_of(c);
        SAME(event_time_bits_smt2_is_radius(x), is_radius(a), a);
        SAME(event_time_bits_smt2_are_in_range(x, y), are_in_range(a, b), a, b);
        SAME(event_time_bits_smt2_are_moderate(x, y, z), are_moderate(a, b, c), a,
             b, c);
        SAME(event_time_bits_smt2_twice_below(x), twice_below(a), a);
        SAME((int64_t)event_time_bits_smt2_sign_of(x), sign_of(a), a);
        const int first = stream_int(&s, 0, 1);
        SAME(double_of(event_time_bits_smt2_choose(x, y, (uint64_t)first)),
             choose(first, a, b), first, a, b);
    }
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "event_time, transcribed", 120,
        the_time_of_meeting_is_that_of_the_scripts,
        the_time_of_parting_is_that_of_the_scripts,
        the_sums_are_those_of_the_proof,
        sums_that_underflow_are_those_of_the_proof,
        the_discriminant_is_that_of_the_proof, the_outline_is_that_of_the_proof,
        the_filters_are_those_of_the_proof,
        near_times_and_their_verdicts_are_those_of_the_proof,
        verdicts_on_meetings_are_those_of_the_proof,
        pairs_that_part_are_those_of_the_proof, bits_mean_what_the_script_says);
}
