// SPDX-License-Identifier: MIT
/* Pairs are scaled before anything is computed: by whichever component, mass or
 * fall is the largest, and by nothing else.  Answers of scaled pairs are scaled,
 * bit by bit. */
#include "impacts.h"

enum { FAR = 700 }; // far beyond it: squares of 2^700 overflow

typedef struct velocities {
    double v1[3], v2[3];
} velocities;

static velocities scaled_by(velocities v, int e)
{
    for (int k = 0; k < 3; k++) {
        v.v1[k] = ldexp(v.v1[k], e);
        v.v2[k] = ldexp(v.v2[k], e);
    }
    return v;
}

static velocities after_core(const double r[3], double m1, double m2,
                             velocities v)
{
    brink_core_impulse(r, m1, m2, v.v1, v.v2);
    return v;
}

static velocities after_step(const double r[3], double mass, double rise,
                             velocities v, int crosses)
{
    double virial;
    ck_assert_int_eq(brink_step_impulse(r, mass, mass, rise, BRINK_INWARD, v.v1,
                                        v.v2, &virial),
                     crosses);
    return v;
}

static void are_same(const char *what, int i, velocities got, velocities right)
{
    for (int k = 0; k < 3; k++)
        ck_assert_msg(got.v1[k] == right.v1[k] && got.v2[k] == right.v2[k],
                      "%s, case %d: got %a and %a, right are %a and %a", what, i,
                      got.v1[k], got.v2[k], right.v1[k], right.v2[k]);
}

static const double diagonal[3] = {1, 1.5, 1.25};
static const velocities slow = {{-0x1.23456789abcdfp0, 0.3, -0.7},
                                {0.1, -0.9, 0x1.fedcba987654p-1}};

START_TEST(one_component_may_be_all_there_is)
{
    for (int k = 0; k < 6; k++) {
        velocities v = {{0, 0, 0}, {0, 0, 0}};
        if (k < 3)
            v.v1[k] = -1.1;
        else
            v.v2[k - 3] = 1.1;
        const velocities right = scaled_by(after_core(diagonal, 1, 1, v), FAR);
        are_same("alone", k, after_core(diagonal, 1, 1, scaled_by(v, FAR)),
                 right);
    }
}
END_TEST

START_TEST(a_light_one_bounces_off_what_is_too_heavy_to_be_moved)
{
    const double r[3] = {1, 0, 0}, light = ldexp(1, -600), heavy = ldexp(1, 600);
    const velocities v = {{-1, 2, 0}, {0, 0, 0}}, right = {{1, 2, 0}, {0, 0, 0}};
    are_same("light, heavy", 0, after_core(r, light, heavy, v), right);
}
END_TEST

START_TEST(the_least_of_velocities_are_exchanged)
{
    static const double speed[] = {0x1p-1074, 0x5p-1074, 0x1.8p-1022, 0x1p-1021};
    const double r[3] = {1, 0, 0};
    for (int i = 0; i < (int)(sizeof speed / sizeof *speed); i++) {
        const velocities v = {{-speed[i], 0, 0}, {0, 0, 0}},
                         right = {{0, 0, 0}, {-speed[i], 0, 0}};
        are_same("least", i, after_core(r, 1, 1, v), right);
    }
}
END_TEST

/** What falls so far that its speed before is nothing to it; 2^2020 and 2^-1010
 *  of the unit are beyond what doubles can square. */
START_TEST(a_fall_may_be_far_more_than_there_was)
{
    const double fall = -0x1.23456789abcdfp0;
    const velocities right =
        after_step(diagonal, 1, fall, scaled_by(slow, -1010), 1);
    const velocities got =
        after_step(diagonal, 0x1p-1000, ldexp(fall, 1020), slow, 1);
    are_same("fall", 0, got, scaled_by(right, 1010));
}
END_TEST

/** To who bounces a rise is as good as a core, whatever there is between it and
 *  the energy. */
START_TEST(a_rise_beyond_reach_is_a_core)
{
    static const struct {
        double mass, rise;
        int speed;
    } c[] = {{0x1p-1000, 0x1p1000, -60}, {0x1p-1000, 0.75, -600}};
    for (int i = 0; i < (int)(sizeof c / sizeof *c); i++) {
        const velocities v = scaled_by(slow, c[i].speed);
        are_same("rise", i, after_step(diagonal, c[i].mass, c[i].rise, v, 0),
                 after_core(diagonal, c[i].mass, c[i].mass, v));
    }
}
END_TEST

START_TEST(a_rise_of_nothing_changes_nothing)
{
    const velocities v = scaled_by(slow, -1000);
    are_same("no rise", 0, after_step(diagonal, 0x1p-1000, 0, v, 1), v);
}
END_TEST

/** Whose energy is so much that of a debt of 1 next to nothing would be seen, and
 *  so would be paid. */
START_TEST(who_has_no_account_owes_nothing)
{
    const velocities right = after_core(diagonal, 1, 1, slow);
    for (int e = 0; e <= 40; e++)
        are_same("core", e, after_core(diagonal, 1, 1, scaled_by(slow, e)),
                 scaled_by(right, e));
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "impulse_scale", 60, one_component_may_be_all_there_is,
        a_light_one_bounces_off_what_is_too_heavy_to_be_moved,
        the_least_of_velocities_are_exchanged,
        a_fall_may_be_far_more_than_there_was, a_rise_beyond_reach_is_a_core,
        a_rise_of_nothing_changes_nothing, who_has_no_account_owes_nothing);
}
