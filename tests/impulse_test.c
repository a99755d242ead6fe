// SPDX-License-Identifier: MIT
#include "cases.h"
#include "impacts.h"
#include <float.h>

/** Each velocity is the exact one rounded once. */
static void keep_velocities(int i, const impact *p, const oracle_turn *turn,
                            const double v1[3], const double v2[3])
{
    const oracle_pair before = {p->m1, p->m2, p->v1, p->v2};
    const oracle_pair after = {p->m1, p->m2, v1, v2};
    if (!oracle_turned(turn, p->r, &before, &after))
        stop("velocities", i, p, v1, v2);
}

static void keep(int i, const impact *p)
{
    double v1[3], v2[3], virial;
    memcpy(v1, p->v1, sizeof v1);
    memcpy(v2, p->v2, sizeof v2);
    int crossed =
        brink_step_impulse(p->r, p->m1, p->m2, p->rise, p->way, v1, v2, &virial);
    const oracle_pair before = {p->m1, p->m2, p->v1, p->v2};
    oracle_turn turn;
    oracle_turn_make(&turn, p->r, p->rise, (int)p->way, &before);
    if (crossed != turn.crosses)
        stop(crossed ? "crossed" : "reflected", i, p, v1, v2);
    keep_velocities(i, p, &turn, v1, v2);
    keep_what_is_conserved(i, p, crossed ? p->rise : 0, v1, v2);
    const double right = oracle_virial(&turn, &before);
    const oracle_pair after = {p->m1, p->m2, v1, v2};
    const double unit =
        oracle_size(p->r) * oracle_largest_momentum(&before, &after);
    if (!(fabs(virial - right) <= 0x1p-52 * fabs(right) + 0x1p-90 * unit))
        stop("virial", i, p, v1, v2);
    oracle_turn_clear(&turn);
}

START_TEST(energy_momentum_and_decision_are_right)
{
    stream s = stream_of_seed(SEED);
    for (int i = 0; i < (int)suite_share(IMPACTS); i++) {
        impact p;
        random_impact(&s, &p);
        keep(i, &p);
        p.way = p.way == BRINK_INWARD ? BRINK_OUTWARD : BRINK_INWARD;
        keep(i, &p); // b has the wrong sign, by far more than rounding can
    }
}
END_TEST

START_TEST(hard_cases_are_right)
{
    FILE *in = cases_open("impulse");
    double x[13];
    for (int i = 0; cases_next(in, 13, x); i++) {
        impact p = {.m1 = x[3],
                    .m2 = x[4],
                    .rise = x[11],
                    .way = x[12] < 0 ? BRINK_INWARD : BRINK_OUTWARD};
        memcpy(p.r, x, sizeof p.r);
        memcpy(p.v1, x + 5, sizeof p.v1);
        memcpy(p.v2, x + 8, sizeof p.v2);
        keep(i, &p);
    }
    fclose(in);
}
END_TEST

START_TEST(scaling_by_powers_of_two_changes_nothing_else)
{
    stream s = stream_of_seed(SEED);
    for (int i = 0; i < (int)suite_share(IMPACTS); i++) {
        impact p;
        random_impact(&s, &p);
        int er = stream_int(&s, -900, 900), ev = stream_int(&s, -300, 300);
        int em = stream_int(&s, -300, 300);
        impact q = p;
        for (int k = 0; k < 3; k++) {
            q.r[k] = ldexp(p.r[k], er);
            q.v1[k] = ldexp(p.v1[k], ev);
            q.v2[k] = ldexp(p.v2[k], ev);
        }
        q.m1 = ldexp(p.m1, em);
        q.m2 = ldexp(p.m2, em);
        q.rise = ldexp(p.rise, em + 2 * ev);
        double w1, w2;
        int one =
            brink_step_impulse(p.r, p.m1, p.m2, p.rise, p.way, p.v1, p.v2, &w1);
        int two =
            brink_step_impulse(q.r, q.m1, q.m2, q.rise, q.way, q.v1, q.v2, &w2);
        ck_assert_int_eq(one, two);
        for (int k = 0; k < 3; k++) {
            ck_assert(ldexp(p.v1[k], ev) == q.v1[k]);
            ck_assert(ldexp(p.v2[k], ev) == q.v2[k]);
        }
        ck_assert(ldexp(w1, er + ev + em) == w2);
    }
}
END_TEST

START_TEST(extreme_rises_do_as_they_must)
{
    const double r[3] = {1, 0, 0};
    double v1[3] = {-1, 0, 0}, v2[3] = {0, 0, 0}, virial;
    ck_assert_int_eq(
        brink_step_impulse(r, 1, 1, DBL_MAX, BRINK_INWARD, v1, v2, &virial), 0);
    ck_assert(v1[0] == 0 && v2[0] == -1 && virial == 1);
    ck_assert_int_eq(
        brink_step_impulse(r, 1, 1, -0x1p1000, BRINK_OUTWARD, v1, v2, &virial),
        1);
    ck_assert(v1[0] == 0x1p500 && v2[0] == -0x1p500);
    ck_assert_int_eq(
        brink_step_impulse(r, 1, 1, -0x1p-1074, BRINK_OUTWARD, v1, v2, &virial),
        1);
    ck_assert(v1[0] == 0x1p500 && v2[0] == -0x1p500);
    double w1[3] = {0x1p-400, 0, 0}, w2[3] = {0, 0, 0};
    ck_assert_int_eq(
        brink_step_impulse(r, 1, 1, -0x1p700, BRINK_OUTWARD, w1, w2, &virial), 1);
    ck_assert(w1[0] == 0x1p350 && w2[0] == -0x1p350);
}
END_TEST

START_TEST(cores_reflect_elastically)
{
    stream s = stream_of_seed(SEED);
    for (int i = 0; i < (int)suite_share(IMPACTS); i++) {
        impact p;
        random_impact(&s, &p);
        double v1[3], v2[3];
        memcpy(v1, p.v1, sizeof v1);
        memcpy(v2, p.v2, sizeof v2);
        double virial = brink_core_impulse(p.r, p.m1, p.m2, v1, v2);
        keep_what_is_conserved(i, &p, 0, v1, v2);
        if (p.way == BRINK_OUTWARD) { // going apart already: nothing to do
            ck_assert_double_eq(virial, 0);
            ck_assert(memcmp(v1, p.v1, sizeof v1) == 0 &&
                      memcmp(v2, p.v2, sizeof v2) == 0);
            continue;
        }
        const oracle_pair before = {p.m1, p.m2, p.v1, p.v2};
        oracle_turn turn;
        oracle_turn_make(&turn, p.r, DBL_MAX, BRINK_INWARD, &before);
        keep_velocities(i, &p, &turn, v1, v2);
        ck_assert_double_gt(virial, 0);
        oracle_turn_clear(&turn);
    }
}
END_TEST

START_TEST(pairs_at_relative_rest_stay_so)
{
    const double r[3] = {1, 0, 0};
    double v1[3] = {1, 2, 3}, v2[3] = {1, 2, 3};
    ck_assert_double_eq(brink_core_impulse(r, 1, 2, v1, v2), 0);
    ck_assert(v1[0] == 1 && v1[1] == 2 && v1[2] == 3);
}
END_TEST

START_TEST(pairs_at_one_place_have_no_line_of_centres)
{
    const double r[3] = {0, -0.0, 0};
    double v1[3] = {1, 2, 3}, v2[3] = {-1, 0, 0}, virial;
    ck_assert_double_eq(brink_core_impulse(r, 1, 2, v1, v2), 0);
    ck_assert_int_eq(
        brink_step_impulse(r, 1, 2, 1, BRINK_INWARD, v1, v2, &virial), 0);
    ck_assert_double_eq(virial, 0);
    ck_assert(v1[0] == 1 && v1[1] == 2 && v1[2] == 3);
    ck_assert(v2[0] == -1 && v2[1] == 0 && v2[2] == 0);
}
END_TEST

START_TEST(slow_pairs_keep_their_digits_at_a_rise_beyond_them)
{
    const double r[3] = {1, 1, 0}; // little masses and a great rise: 2^1000
    double v1[3] = {-0x1.8p-20, 0, 0}, v2[3] = {0, 0, 0}, virial;
    ck_assert_int_eq(brink_step_impulse(r, 0x1p-1000, 0x1p-1000, 0x1p1000,
                                        BRINK_INWARD, v1, v2, &virial),
                     0);
    ck_assert(v1[0] == -0x1.8p-21 && v1[1] == 0x1.8p-21 && v1[2] == 0);
    ck_assert(v2[0] == -0x1.8p-21 && v2[1] == -0x1.8p-21 && v2[2] == 0);
}
END_TEST

int main(void)
{
    return RUN_SUITE("impulse", 600, energy_momentum_and_decision_are_right,
                     hard_cases_are_right,
                     scaling_by_powers_of_two_changes_nothing_else,
                     extreme_rises_do_as_they_must, cores_reflect_elastically,
                     pairs_at_relative_rest_stay_so,
                     pairs_at_one_place_have_no_line_of_centres,
                     slow_pairs_keep_their_digits_at_a_rise_beyond_them);
}
