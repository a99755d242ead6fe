// SPDX-License-Identifier: MIT
#include "conventional_method.h"
#include "study_doubts.h"
#include "suite.h"
#include "systems.h"
#include <math.h>
#include <mpfr.h>
#include <stdlib.h>

// Whether |r| < distance, in 300 bits: squares of doubles of one size, and their
// sums, are exact.
static int is_inside(const double r[3], double distance)
{
    mpfr_t sum, square;
    mpfr_inits2(300, sum, square, (mpfr_ptr)0);
    mpfr_set_d(sum, distance, MPFR_RNDN);
    mpfr_sqr(sum, sum, MPFR_RNDN);
    for (int a = 0; a < 3; a++) {
        mpfr_set_d(square, r[a], MPFR_RNDN);
        mpfr_sqr(square, square, MPFR_RNDN);
        mpfr_sub(sum, sum, square, MPFR_RNDN);
    }
    const int sign = mpfr_sgn(sum);
    mpfr_clears(sum, square, (mpfr_ptr)0);
    return sign > 0;
}

static int level_shown(const brink_run *run, uint32_t i, uint32_t j, int *overlap)
{
    const brink_potential *p = brink_system_potential(&run->system, i, j);
    double r[3];
    int level = 0;
    brink_separation_now(run, i, j, r);
    for (int k = 0; k < p->count; k++)
        level += !isinf(p->energy[k]) && is_inside(r, p->distance[k]);
    *overlap =
        isinf(p->energy[p->count - 1]) && is_inside(r, p->distance[p->count - 1]);
    return level;
}

// The naive reference: a list of the pairs that have met and had no event since.
typedef struct pair {
    uint32_t i, j;
} pair;

typedef struct naive {
    uint64_t wrong[BRINK_DOUBTS], looks[BRINK_DOUBTS], overlaps;
    pair *waiting;
    size_t count;
    pair last;
} naive;

static int shares_one(pair a, pair b)
{
    const int first = a.i == b.i || a.i == b.j, second = a.j == b.i || a.j == b.j;
    return first != second;
}

static int is_same(pair a, pair b)
{
    return a.i == b.i && a.j == b.j;
}

static void look(naive *n, enum brink_doubt_kind kind, int wrong)
{
    n->looks[kind]++;
    n->wrong[kind] += (uint64_t)wrong;
}

static int is_wrong(const brink_run *run, pair p)
{
    int overlap;
    return level_shown(run, p.i, p.j, &overlap) !=
           brink_states_level(&run->states, p.i, p.j);
}

static void look_naively(naive *n, const brink_run *run)
{
    const brink_happening *last = &run->last;
    const pair now = {last->i, last->j};
    int overlap, core = last->kind == BRINK_CORE;
    const int level = level_shown(run, now.i, now.j, &overlap);
    look(n, BRINK_DOUBT_EXECUTED, level != last->level_before);
    look(n, BRINK_DOUBT_AFTER, level != last->level_after);
    if (n->looks[BRINK_DOUBT_AFTER] > 1 && !is_same(n->last, now))
        look(n, BRINK_DOUBT_SYSTEM, is_wrong(run, n->last));
    n->overlaps += (uint64_t)(core && overlap);
    size_t kept = 0;
    for (size_t k = 0; k < n->count; k++) {
        const pair p = n->waiting[k];
        if (shares_one(p, now))
            look(n, BRINK_DOUBT_NEXT, is_wrong(run, p));
        else if (!is_same(p, now))
            n->waiting[kept++] = p;
    }
    n->waiting[kept++] = now;
    n->count = kept;
    n->last = now;
}

START_TEST(counts_are_those_of_a_naive_reference)
{
    static const char *const scenes[] = {square_well, square_shoulder,
                                         three_steps, mixture};
    for (int k = 0; k < 4; k++) {
        brink_run run;
        brink_doubter d;
        make_run(&run, scenes[k]);
        naive n = {.waiting = calloc(run.system.count, sizeof(pair))};
        ck_assert_int_eq(brink_doubter_create(&d, &run), 0);
        for (uint64_t e = 1; e <= 3000; e++) {
            ck_assert_int_eq(brink_doubter_advance(&d, &run, e),
                             BRINK_RUN_REACHED);
            look_naively(&n, &run);
        }
        const brink_doubt *of = d.seen.of;
        ck_assert_uint_eq(d.seen.events, 3000);
        for (int m = BRINK_DOUBT_NEXT; m <= BRINK_DOUBT_EXECUTED; m++) {
            ck_assert_uint_eq(of[m].looks, n.looks[m]);
            ck_assert_uint_eq(of[m].wrong, n.wrong[m]);
        }
        ck_assert_uint_eq(of[BRINK_DOUBT_AFTER].wrong,
                          n.wrong[BRINK_DOUBT_AFTER]);
        ck_assert_uint_eq(d.seen.overlaps, n.overlaps);
        // None of them is empty, or this would compare nothing with nothing.
        ck_assert_uint_gt(of[BRINK_DOUBT_EXECUTED].wrong, 0);
        ck_assert_uint_gt(of[BRINK_DOUBT_AFTER].wrong, 0);
        ck_assert_uint_gt(of[BRINK_DOUBT_NEXT].looks, 0);
        ck_assert_uint_gt(of[BRINK_DOUBT_SYSTEM].looks, 0);
        ck_assert_uint_gt(d.seen.overlaps, 0);
        // A pair is tested at its next event at the latest, and some were before:
        // when a cell's wall was crossed, and then met each other again.
        ck_assert_uint_gt(of[BRINK_DOUBT_TESTED].looks,
                          of[BRINK_DOUBT_NEXT].looks);
        ck_assert_uint_eq(of[BRINK_DOUBT_STORED].looks, 3000);
        ck_assert_uint_eq(of[BRINK_DOUBT_MOVED].looks, 3000);
        // What was predicted arrives: to some roundings of a way of some 2^5.
        ck_assert_uint_eq(brink_doubt_beyond(&of[BRINK_DOUBT_MOVED], 40), 0);
        free(n.waiting);
        brink_doubter_destroy(&d);
        brink_run_destroy(&run);
    }
}
END_TEST

START_TEST(the_run_does_not_notice)
{
    brink_run watched, alone;
    brink_doubter d;
    make_run(&watched, square_well);
    make_run(&alone, square_well);
    ck_assert_int_eq(brink_doubter_create(&d, &watched), 0);
    ck_assert_int_eq(brink_doubter_advance(&d, &watched, 5000),
                     BRINK_RUN_REACHED);
    advance(&alone, 5000);
    ck_assert(same_state(&watched, &alone));
    brink_doubter_destroy(&d);
    brink_run_destroy(&watched);
    brink_run_destroy(&alone);
}
END_TEST

START_TEST(a_transfer_is_in_doubt_on_just_one_side_a_bounce_on_both_or_none)
{
    brink_run run;
    brink_doubter d;
    make_run(&run, square_well);
    ck_assert_int_eq(brink_doubter_create(&d, &run), 0);
    for (uint64_t e = 1; e <= 3000; e++) {
        const brink_doubts then = d.seen;
        brink_doubter_advance(&d, &run, e);
        const brink_doubt *now = d.seen.of, *was = then.of;
        const uint64_t before = now[BRINK_DOUBT_EXECUTED].wrong -
                                was[BRINK_DOUBT_EXECUTED].wrong,
                       after = now[BRINK_DOUBT_AFTER].wrong -
                               was[BRINK_DOUBT_AFTER].wrong;
        if (run.last.kind == BRINK_CAPTURE || run.last.kind == BRINK_RELEASE)
            ck_assert_uint_eq(before + after, 1);
        else
            ck_assert_uint_eq(before, after);
        if (run.last.kind == BRINK_CORE)
            ck_assert_uint_eq(before, 0);
    }
    brink_doubter_destroy(&d);
    brink_run_destroy(&run);
}
END_TEST

// Whether a doubter has looked in this way at a pair since its event.
static int has_looked(const brink_doubter *d, const brink_run *run, pair p,
                      enum brink_doubt_kind kind)
{
    const pair last = {run->last.i, run->last.j};
    if (is_same(last, p))
        return 0;
    return kind == BRINK_DOUBT_TESTED ? d->memory[p.i].untested != p.j
           : kind == BRINK_DOUBT_NEXT ? shares_one(last, p)
                                      : 1;
}

// After an event the books say the opposite of what is so, up to the next one.
START_TEST(a_state_that_is_wrong_when_it_is_looked_at_is_counted_once)
{
    const enum brink_doubt_kind kind = (enum brink_doubt_kind)_i;
    brink_run run;
    brink_doubter d;
    make_run(&run, square_well);
    ck_assert_int_eq(brink_doubter_create(&d, &run), 0);
    brink_states *states = &run.states;
    int looked = 0;
    for (uint64_t e = 1; !looked; e += 2) {
        ck_assert_int_eq(brink_doubter_advance(&d, &run, e), BRINK_RUN_REACHED);
        ck_assert_uint_eq(d.seen.of[kind].wrong, 0);
        const pair p = {run.last.i, run.last.j};
        const int level = brink_states_level(states, p.i, p.j);
        brink_states_set(states, &run.system, p.i, p.j, !level);
        ck_assert_int_eq(brink_doubter_advance(&d, &run, e + 1),
                         BRINK_RUN_REACHED);
        looked = has_looked(&d, &run, p, kind);
        ck_assert_uint_eq(d.seen.of[kind].wrong, (uint64_t)looked);
        brink_states_set(states, &run.system, p.i, p.j, level);
    }
    brink_doubter_destroy(&d);
    brink_run_destroy(&run);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("doubts");
    TCase *tcase = tcase_create("doubts");
    tcase_set_timeout(tcase, 300);
    tcase_add_test(tcase, counts_are_those_of_a_naive_reference);
    tcase_add_test(tcase, the_run_does_not_notice);
    tcase_add_test(
        tcase, a_transfer_is_in_doubt_on_just_one_side_a_bounce_on_both_or_none);
    tcase_add_loop_test(
        tcase, a_state_that_is_wrong_when_it_is_looked_at_is_counted_once,
        BRINK_DOUBT_TESTED, BRINK_DOUBT_SYSTEM + 1);
    suite_add_tcase(suite, tcase);
    return run_whole_suite(suite);
}
