// SPDX-License-Identifier: MIT
#include "random.h"
#include "suite.h"
#include <brink/lanes.h>

enum { CASES = 20000, SEED = 1 };

START_TEST(each_lane_is_multiplied_and_added_with_one_rounding)
{
    stream s = stream_of_seed(SEED);
    for (int i = 0; i < (int)suite_share(CASES); i++) {
        double x[3][2];
        for (int k = 0; k < 6; k++)
            x[k / 2][k % 2] = stream_scaled(&s, -600, 500);
        if (i % 2) { // where a second rounding would show
            x[2][0] = -x[0][0] * x[1][0];
            x[2][1] = -x[0][1] * x[1][1];
        }
        two_lanes z = lanes_fma((two_lanes){x[0][0], x[0][1]},
                                (two_lanes){x[1][0], x[1][1]},
                                (two_lanes){x[2][0], x[2][1]});
        for (int k = 0; k < 2; k++) {
            double want = fma(x[0][k], x[1][k], x[2][k]);
            if (z[k] != want)
                ck_abort_msg("lane %d of %a * %a + %a (seed %d): %a, not %a", k,
                             x[0][k], x[1][k], x[2][k], SEED, z[k], want);
        }
    }
}
END_TEST

/** A number at a distance from the midpoint between x and its neighbour, in
 *  units of x, as a sum of two doubles. */
static dd near_midpoint(double x, double side, double distance)
{
    double next = nextafter(x, side * (double)INFINITY);
    return (dd){x, (next - x) / 2 + side * distance * x};
}

static int is_told_in_lane(int lane, dd x, double *nearest)
{
    two_lanes hi = {1, 1}, lo = {0, 0}, to;
    hi[lane] = x.hi;
    lo[lane] = x.lo;
    const int told = lanes_are_told(hi, lo, &to);
    *nearest = to[lane];
    return told;
}

START_TEST(what_is_within_2_to_the_minus_75_of_a_midpoint_is_not_told)
{
    stream s = stream_of_seed(SEED);
    for (int i = 0; i < (int)suite_share(CASES); i++) {
        double side = stream_sign(&s), nearest;
        double x = i % 8 ? stream_real(&s, 1, 2) : 1; // below 1 an ulp is half
        dd y = near_midpoint(x, side, stream_real(&s, -1, 1) * 0x1p-75);
        if (is_told_in_lane(i / 8 % 2, y, &nearest))
            ck_abort_msg("%a + %a (seed %d) is told", y.hi, y.lo, SEED);
    }
}
END_TEST

START_TEST(what_is_2_to_the_minus_72_from_a_midpoint_is_told)
{
    stream s = stream_of_seed(SEED);
    for (int i = 0; i < (int)suite_share(CASES); i++) {
        double side = stream_sign(&s), beyond = stream_sign(&s), nearest;
        double x = i % 8 ? stream_real(&s, 1.5, 1.75) : 1;
        dd y = near_midpoint(x, side, beyond * 0x1p-72);
        double want = beyond < 0 ? x : nextafter(x, side * (double)INFINITY);
        if (!is_told_in_lane(i / 8 % 2, y, &nearest) || nearest != want)
            ck_abort_msg("%a + %a (seed %d): %a, not %a", y.hi, y.lo, SEED,
                         nearest, want);
    }
}
END_TEST

int main(void)
{
    return RUN_SUITE("lanes", 60,
                     each_lane_is_multiplied_and_added_with_one_rounding,
                     what_is_within_2_to_the_minus_75_of_a_midpoint_is_not_told,
                     what_is_2_to_the_minus_72_from_a_midpoint_is_told);
}
