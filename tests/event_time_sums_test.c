// SPDX-License-Identifier: MIT
// The sums that the event times are made of: in lanes they are what they are one
// by one, and what c may be off by is what proofs/event_time_sums.v has.
#include "pairs.h"
#include "suite.h"
#include <brink/event_time_lanes.h>
#include <brink/event_time_parting.h>

enum { CASES_A_FAMILY = 300, SEED = 1 };

static const double uu = 0x1p-106; // u^2

/** ck_assert, and which pair it is. */
static void check(int holds, const char *what, const char *family,
                  const pair_case *p)
{
    ck_assert_msg(holds, "%s, %s (seed %d): %a %a %a  %a %a %a  %a", what, family,
                  SEED, p->r[0], p->r[1], p->r[2], p->v[0], p->v[1], p->v[2],
                  p->sigma);
}

static int is_same(double x, double y)
{
    return x == y || (isnan(x) && isnan(y));
}

static int is_same_dd(dd x, dd y)
{
    return is_same(x.hi, y.hi) && is_same(x.lo, y.lo);
}

START_TEST(sums_in_lanes_are_the_sums)
{
    const pair_family *family = &pair_families[_i];
    stream s = stream_of_seed(SEED);
    pair_case p;
    for (int i = 0; i < CASES_A_FAMILY; i++) {
        family->make(&s, &p);
        const sums one = sums_of(p.r, p.v, p.sigma),
                   all = sums_in_lanes(p.r, p.v, p.sigma);
        check(is_same_dd(one.a, all.a), "a", family->name, &p);
        check(is_same_dd(one.b, all.b), "b", family->name, &p);
        check(is_same_dd(one.c, all.c), "c", family->name, &p);
        check(is_same(one.size, all.size), "R", family->name, &p);
        check(is_same(one.c_error, all.c_error), "error", family->name, &p);
        const two_dots dots = dots_in_lanes(p.r, p.v);
        check(is_same_dd(dots.rv, dot_of(p.r, p.v)), "r.v", family->name, &p);
        check(is_same_dd(dots.rr, dot_of(p.r, p.r)), "r.r", family->name, &p);
    }
}
END_TEST

/** Whether R is r.r + sigma^2, but for some roundings. */
static int is_size(double size, const pair_case *p)
{
    const double direct = dot_rounded(p->r, p->r) + p->sigma * p->sigma;
    return fabs(size - direct) <= 8 * 0x1p-53 * direct;
}

START_TEST(what_c_may_be_off_by_is_what_is_proved)
{
    stream s = stream_of_seed(SEED);
    pair_case p;
    for (int i = 0; i < CASES_A_FAMILY; i++) {
        family_neighbours(&s, &p);
        p.sigma *= stream_real(&s, 0.1, 4);
        sums m = sums_of(p.r, p.v, p.sigma);
        check(is_size(m.size, &p), "R", "neighbours", &p);
        check(m.c_error == 6 * uu * m.size, "6u^2 R", "neighbours", &p);
        look_closer(&m, p.r, p.sigma);
        check(m.c_error == 0x1p-150 * m.size, "2^-150 R", "neighbours", &p);

        near_sums n = near_sums_of(dots_in_lanes(p.r, p.v), p.sigma);
        check(is_size(n.size, &p), "R near", "neighbours", &p);
        check(n.c_error == 7 * uu * n.size, "7u^2 R", "neighbours", &p);
        look_closer_near(&n, p.r, p.sigma);
        check(n.c_error == 0x1p-140 * n.size, "2^-140 R", "neighbours", &p);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("event_time_sums");
    TCase *all = tcase_create("all");
    tcase_add_loop_test(all, sums_in_lanes_are_the_sums, 0, PAIR_FAMILIES);
    tcase_add_test(all, what_c_may_be_off_by_is_what_is_proved);
    suite_add_tcase(suite, all);
    return run_whole_suite(suite);
}
