// SPDX-License-Identifier: MIT
// Whether a step is crossed: exact, so the radial energy that equals the rise to
// the last bit does not suffice, and one ulp more does.
#include "impacts.h"
#include <float.h>

/** All pairs with r from -1 to 1, relative velocity from -2 to 2, masses 1 to 3
 *  and a rise of -4 to 8 quarters, in whole numbers:
 *  m1 m2 b^2 > 2 rise r.r (m1 + m2), and the velocities afterwards keep what is
 *  conserved. */
START_TEST(all_small_whole_impacts_are_decided_right)
{
    for (int n = 0; n < 27 * 125 * 9 * 13; n++) {
        int rest = n, b = 0, rr = 0;
        impact p = {.way = n % 2 ? BRINK_INWARD : BRINK_OUTWARD};
        for (int k = 0; k < 3; k++, rest /= 15) {
            const int x = rest % 3 - 1, v = rest / 3 % 5 - 2;
            p.r[k] = x;
            p.v1[k] = v + 1;
            p.v2[k] = 1;
            b += x * v;
            rr += x * x;
        }
        const int m1 = rest % 3 + 1, m2 = rest / 3 % 3 + 1;
        const int quarters = rest / 9 - 4;
        p.m1 = m1;
        p.m2 = m2;
        p.rise = quarters * 0.25;
        if (rr == 0)
            continue; // no line of centres
        double v1[3], v2[3], virial;
        memcpy(v1, p.v1, sizeof v1);
        memcpy(v2, p.v2, sizeof v2);
        const int crossed =
            brink_step_impulse(p.r, p.m1, p.m2, p.rise, p.way, v1, v2, &virial);
        if (crossed != (2 * m1 * m2 * b * b > quarters * rr * (m1 + m2)))
            stop(crossed ? "crossed" : "reflected", n, &p, v1, v2);
        if (n % 16 == 0) // the oracle is slow
            keep_what_is_conserved(n, &p, crossed ? p.rise : 0, v1, v2);
    }
}
END_TEST

START_TEST(radial_energy_equal_to_the_rise_does_not_suffice)
{
    // mu b^2 / (2 r.r) = 1/2 1 / 2 = 1/4
    const double r[3] = {1, 0, 0};
    for (int ulps = -1; ulps <= 1; ulps++) {
        double v1[3] = {-1, 2, 0}, v2[3] = {0, 0, 0}, virial;
        double rise = ulps < 0   ? nextafter(0.25, 0)
                      : ulps > 0 ? nextafter(0.25, 1)
                                 : 0.25;
        ck_assert_int_eq(
            brink_step_impulse(r, 1, 1, rise, BRINK_INWARD, v1, v2, &virial),
            ulps < 0);
        if (ulps >= 0)
            ck_assert(v1[0] == 0 && v2[0] == -1 && v1[1] == 2);
    }
}
END_TEST

START_TEST(equality_is_decided_where_double_double_cannot)
{
    // m1 = 2 i (i + j), m2 = 2 j (i + j): mu = 2 i j, but not so in
    // double-double, where j / (i + j) comes first.  v = k r, and both move as
    // they like, so mu b^2 / (2 r.r) = i j k^2 r.r.
    stream s = stream_of_seed(SEED);
    for (int c = 0; c < (int)suite_share(IMPACTS); c++) {
        double i = stream_int(&s, 1, 1 << 8), j = stream_int(&s, 1, 1 << 8);
        double m1 = 2 * i * (i + j), m2 = 2 * j * (i + j);
        double k = stream_int(&s, 1, 1 << 8), r[3], both[3], rr = 0, virial;
        for (int axis = 0; axis < 3; axis++) {
            r[axis] = stream_int(&s, 1, 1 << 9);
            both[axis] = stream_int(&s, -(1 << 9), 1 << 9);
            rr += r[axis] * r[axis];
        }
        for (int ulps = -1; ulps <= 1; ulps++) {
            double rise = i * j * k * k * rr, v1[3], v2[3];
            for (int axis = 0; axis < 3; axis++) {
                v2[axis] = both[axis];
                v1[axis] = both[axis] + k * r[axis];
            }
            rise = ulps < 0   ? nextafter(rise, 0)
                   : ulps > 0 ? nextafter(rise, DBL_MAX)
                              : rise;
            ck_assert_int_eq(brink_step_impulse(r, m1, m2, rise, BRINK_OUTWARD,
                                                v1, v2, &virial),
                             ulps < 0);
        }
    }
}
END_TEST

/* The same equality, and a velocity of 2^-200 beside those of 2^17: nothing of it
 * is left in double-double, and it is all there is to decide by. */
START_TEST(what_double_double_cannot_see_decides)
{
    stream s = stream_of_seed(SEED);
    for (int c = 0; c < IMPACTS; c++) {
        double i = stream_int(&s, 1, 1 << 8), j = stream_int(&s, 1, 1 << 8);
        double m1 = 2 * i * (i + j), m2 = 2 * j * (i + j);
        double k = stream_int(&s, 1, 1 << 8), r[3], rr = 0, virial;
        for (int axis = 0; axis < 3; axis++) {
            r[axis] = stream_int(&s, 1, 1 << 9);
            rr += r[axis] * r[axis];
        }
        for (int more = -1; more <= 1; more += 2) {
            double v1[3] = {k * r[0], k * r[1], k * r[2]};
            double v2[3] = {more * -0x1p-200, 0, 0};
            ck_assert_int_eq(brink_step_impulse(r, m1, m2, i * j * k * k * rr,
                                                BRINK_OUTWARD, v1, v2, &virial),
                             more > 0);
            const double b = r[0] * (v1[0] - v2[0]) + r[1] * (v1[1] - v2[1]) +
                             r[2] * (v1[2] - v2[2]);
            ck_assert(more > 0 ? b >= 0 : b < 0);
        }
    }
}
END_TEST

START_TEST(no_radial_motion_does_not_cross_a_step_of_nothing)
{
    const double r[3] = {1, 0, 0};
    double v1[3] = {0, 1, 0}, v2[3] = {0, 0, 0}, virial;
    ck_assert_int_eq(
        brink_step_impulse(r, 1, 1, 0, BRINK_INWARD, v1, v2, &virial), 0);
    ck_assert(v1[0] == 0 && v1[1] == 1 && virial == 0);
}
END_TEST

int main(void)
{
    return RUN_SUITE("impulse_decision", 600,
                     all_small_whole_impacts_are_decided_right,
                     radial_energy_equal_to_the_rise_does_not_suffice,
                     equality_is_decided_where_double_double_cannot,
                     what_double_double_cannot_see_decides,
                     no_radial_motion_does_not_cross_a_step_of_nothing);
}
