// SPDX-License-Identifier: MIT
// What Coq is told exact.h does is what it does.
#include "transcribed/exact_dd_add_v.h"
#include "transcribed/exact_dd_products_v.h"
#include "transcribed/exact_dd_v.h"
#include "transcribed/exact_v.h"
#include "transcribed/impulse_dd_v.h"
#include <brink/lanes.h>

/** Another for a sum with x: -x or nearly, or up to 2^60 larger or smaller. */
static double beside(stream *s, double x)
{
    if (stream_int(s, 0, 3) == 0)
        return stream_near(s, -x, 4);
    return x * stream_scaled(s, -60, 60);
}

START_TEST(sums_are_those_of_the_proof)
{
    EACH_INPUT(s)
    {
        const double a = stream_scaled(&s, -900, 900), b = beside(&s, a);
        SAME_DD(exact_v_two_sum(a, b), two_sum(a, b), a, b);
        SAME_DD(exact_v_fast_two_sum(a, b), fast_two_sum(a, b), a, b);
        const dd x = {a, a * stream_scaled(&s, -60, -53)};
        SAME_DD(exact_dd_v_dd_add_d(x, b), dd_add_d(x, b), x.hi, x.lo, b);
        const dd y = {b, beside(&s, x.lo) * stream_scaled(&s, -8, 0)};
        SAME_DD(exact_dd_add_v_dd_add(x, y), dd_add(x, y), x.hi, x.lo, y.hi,
                y.lo);
        // Where fast_two_sum has to leave nothing behind: of parts as they are
        // kept, the lower one at most half an ulp.
        const dd v = two_sum(a, x.lo);
        const dd w = two_sum(b, b * stream_scaled(&s, -60, -53));
        SAME_DD(impulse_dd_v_dd_add_d(v, b), dd_add_d(v, b), v.hi, v.lo, b);
        SAME_DD(impulse_dd_v_dd_add(v, w), dd_add(v, w), v.hi, v.lo, w.hi, w.lo);
    }
}
END_TEST

START_TEST(products_are_those_of_the_proof)
{
    EACH_INPUT(s)
    {
        const double a = stream_scaled(&s, -480, 500);
        const double b = stream_scaled(&s, -480, 500);
        SAME_DD(exact_v_two_prod(a, b), two_prod(a, b), a, b);
        const dd x = {a, a * stream_scaled(&s, -60, -53)};
        SAME_DD(exact_v_dd_mul_d(x, b), dd_mul_d(x, b), x.hi, x.lo, b);
        const dd y = {b, b * stream_scaled(&s, -60, -53)}, root = {fabs(a), x.lo};
        SAME_DD(exact_dd_products_v_dd_mul(x, y), dd_mul(x, y), a, x.lo, b, y.lo);
        SAME_DD(exact_dd_products_v_dd_div(x, y), dd_div(x, y), a, x.lo, b, y.lo);
        SAME_DD(exact_dd_products_v_dd_sqrt(root), dd_sqrt(root), a, x.lo);
        SAME_DD(impulse_dd_v_dd_mul_d(x, b), dd_mul_d(x, b), a, x.lo, b);
    }
}
END_TEST

/** As told as not: lo is within 2^-14 of half an ulp, or of a quarter. */
START_TEST(told_is_what_the_proof_calls_so)
{
    EACH_INPUT(s)
    {
        const double hi = stream_scaled(&s, -900, 900);
        const double ulp = nextafter(fabs(hi), (double)INFINITY) - fabs(hi);
        const double part = stream_int(&s, 0, 1) ? 0.5 : 0.25;
        const double lo = stream_sign(&s) * part * ulp *
                          (1 + stream_real(&s, -0x1p-14, 0x1p-14));
        const dd x = {hi, lo};
        SAME(exact_v_is_told(x), is_told(x), hi, lo);
    }
}
END_TEST

/** The same, within 2^-19. */
START_TEST(told_in_a_lane_is_what_the_proof_calls_so)
{
    EACH_INPUT(s)
    {
        const double x = stream_scaled(&s, -900, 900);
        const double ulp = nextafter(fabs(x), (double)INFINITY) - fabs(x);
        const double part = stream_int(&s, 0, 1) ? 0.5 : 0.25;
        const double y = stream_sign(&s) * part * ulp *
                         (1 + stream_real(&s, -0x1p-19, 0x1p-19));
        two_lanes nearest;
        SAME(exact_v_is_told_in_lane(x, y),
             lanes_are_told((two_lanes){x, 1}, (two_lanes){y, 0}, &nearest), x,
             y);
        SAME(exact_v_plus(x, y), nearest[0], x, y);
    }
}
END_TEST

int main(void)
{
    return RUN_SUITE("exact, transcribed", 120, sums_are_those_of_the_proof,
                     products_are_those_of_the_proof,
                     told_is_what_the_proof_calls_so,
                     told_in_a_lane_is_what_the_proof_calls_so);
}
