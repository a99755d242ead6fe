// SPDX-License-Identifier: MIT
#include "impacts.h"

/** Sine of the angle that the relative velocity makes with the tangent,
 *  outward > 0. */
static double angle(const impact *p, const double v1[3], const double v2[3])
{
    double b = 0, v[3];
    for (int k = 0; k < 3; k++) {
        v[k] = v1[k] - v2[k];
        b += p->r[k] * v[k];
    }
    return b / (length_of(p->r) * length_of(v));
}

START_TEST(pairs_on_the_rim_are_turned_inward)
{
    stream s = stream_of_seed(SEED);
    for (int i = 0; i < (int)suite_share(IMPACTS); i++) {
        impact p;
        pair_case rim;
        random_impact(&s, &p);
        family_rim(&s, &rim);
        double before = stream_scaled(&s, -60, -20) * length_of(rim.v);
        memcpy(p.r, rim.r, sizeof p.r);
        for (int k = 0; k < 3; k++)
            p.v1[k] = p.v2[k] + rim.v[k] + before * rim.r[k];
        double v1[3], v2[3];
        memcpy(v1, p.v1, sizeof v1);
        memcpy(v2, p.v2, sizeof v2);
        double sine = angle(&p, v1, v2);
        int turned = brink_rim_impulse(p.r, p.m1, p.m2, v1, v2);
        // The sine above is off by some ulp of the velocities.
        double slack = 0x1p-50 * (1 + length_of(p.v2) / length_of(rim.v));
        if (turned != (fabs(sine) < BRINK_RIM_ANGLE) &&
            fabs(fabs(sine) - BRINK_RIM_ANGLE) > slack)
            stop("rim", i, &p, v1, v2);
        if (!turned) {
            ck_assert(memcmp(v1, p.v1, sizeof v1) == 0 &&
                      memcmp(v2, p.v2, sizeof v2) == 0);
            continue;
        }
        keep_what_is_conserved(i, &p, 0, v1, v2);
        slack =
            0x1p-50 * (1 + (length_of(v1) + length_of(v2)) / length_of(rim.v));
        if (fabs(angle(&p, v1, v2) + BRINK_RIM_ANGLE) > slack)
            stop("rim angle", i, &p, v1, v2);
    }
}
END_TEST

START_TEST(pairs_at_relative_rest_are_not_turned)
{
    const double r[3] = {1, 0, 0};
    double v1[3] = {1, 2, 3}, v2[3] = {1, 2, 3};
    ck_assert_int_eq(brink_rim_impulse(r, 1, 2, v1, v2), 0);
    ck_assert(v1[0] == 1 && v1[1] == 2 && v1[2] == 3);
}
END_TEST

int main(void)
{
    return RUN_SUITE("impulse_rim", 600, pairs_on_the_rim_are_turned_inward,
                     pairs_at_relative_rest_are_not_turned);
}
