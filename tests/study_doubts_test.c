// SPDX-License-Identifier: MIT
#include "conventional_method.h"
#include "study_doubts.h"
#include "suite.h"
#include "systems.h"
#include <math.h>
#include <mpfr.h>
#include <stdlib.h>
#include <string.h>

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

// Two particles on their way to a step at 1.5, all in dyadic numbers: the box
// has 16, so positions are exact, and they are there at time 1.5.
static const char two[] =
    "box: {size: [16, 16, 16]}\n"
    "species: {A: {count: 2}}\n"
    "start: {random: true}\n"
    "potentials:\n"
    "  - {between: [A, A], steps: [[1.5, -1], [1, .inf]]}\n";

static void make_two(brink_run *run, double aside, double core)
{
    brink_system system;
    make_system(&system, two);
    for (int k = 0; k < 2; k++) {
        brink_particle *p = &system.particle[k];
        memset(p->v, 0, sizeof p->v);
        for (int a = 0; a < 3; a++)
            p->x[a] = brink_system_fraction(&system, a, 8.25);
    }
    system.particle[0].x[0] = brink_system_fraction(&system, 0, 5.25);
    system.particle[0].x[1] = brink_system_fraction(&system, 1, 8.25 + aside);
    system.particle[0].v[0] = 1;
    if (core > 0) { // the tables are the system's own
        double *distance = (double *)system.potential[0].distance;
        distance[1] = core;
    }
    ck_assert_int_eq(brink_run_create(run, &system, BRINK_TIER_PLAIN), 0);
}

// Shortly before the event: 2^-10 to go.  Crossings of cells are behind them.
static void approach(brink_run *run)
{
    const brink_instant until = brink_instant_at(run->system.year, 1.5 - 0x1p-10);
    ck_assert_int_eq(brink_run_advance(run, 1, until), BRINK_RUN_REACHED);
    ck_assert_uint_eq(brink_tally_events(&run->tally), 0);
    brink_system_turn(&run->system, run->now.epoch);
}

static void shift(brink_run *run, double towards)
{
    run->system.particle[0].x[0] += (uint64_t)(int64_t)(towards * 0x1p60);
}

// What counts it, of the four kinds that look at the event itself.
static void expect(const brink_doubter *d, int executed, int stored, int moved,
                   int after)
{
    const brink_doubt *of = d->seen.of;
    ck_assert_uint_eq(of[BRINK_DOUBT_EXECUTED].wrong, (uint64_t)executed);
    ck_assert_uint_eq(of[BRINK_DOUBT_STORED].wrong, (uint64_t)stored);
    ck_assert_uint_eq(of[BRINK_DOUBT_MOVED].wrong, (uint64_t)moved);
    ck_assert_uint_eq(of[BRINK_DOUBT_AFTER].wrong, (uint64_t)after);
}

START_TEST(each_look_at_an_event_counts_what_is_wrong_there_alone)
{
    // Shifted before the prediction is remembered and after it, and what counts.
    static const struct {
        double before, since;
        int executed, stored, moved, after;
    } cases[] = {{0, 0, 0, 0, 0, 1}, // on the step, which is not inside
                 {0, 0x1p-20, 1, 0, 0, 0},     {0, -0x1p-20, 0, 0, 0, 1},
                 {0x1p-11, 0, 1, 0, 1, 0},     {0x1p-9, 0, 1, 1, 1, 0},
                 {0x1p-9, -0x1p-8, 0, 1, 1, 1}};
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        brink_run run;
        brink_doubter d;
        make_two(&run, 0, 0);
        approach(&run);
        shift(&run, cases[k].before);
        ck_assert_int_eq(brink_doubter_create(&d, &run), 0);
        shift(&run, cases[k].since);
        ck_assert_int_eq(brink_doubter_advance(&d, &run, 1), BRINK_RUN_REACHED);
        expect(&d, cases[k].executed, cases[k].stored, cases[k].moved,
               cases[k].after);
        brink_doubter_destroy(&d);
        brink_run_destroy(&run);
    }
}
END_TEST

// 2^-20 of 1.5 is 2^-20.58 of the step: at least 2^-21, less than 2^-20.
START_TEST(a_tolerance_counts_what_is_beyond_it_and_what_is_within)
{
    brink_run run;
    brink_doubter d;
    make_two(&run, 0, 0);
    approach(&run);
    ck_assert_int_eq(brink_doubter_create(&d, &run), 0);
    shift(&run, 0x1p-20);
    ck_assert_int_eq(brink_doubter_advance(&d, &run, 1), BRINK_RUN_REACHED);
    const brink_doubt *executed = &d.seen.of[BRINK_DOUBT_EXECUTED];
    const brink_doubt *after = &d.seen.of[BRINK_DOUBT_AFTER];
    ck_assert_uint_eq(brink_doubt_beyond(executed, 21), 1);
    ck_assert_uint_eq(brink_doubt_beyond(executed, 20), 0);
    ck_assert_uint_eq(brink_doubt_within(executed, 20), 1);
    ck_assert_uint_eq(brink_doubt_within(executed, 21), 0);
    ck_assert_uint_eq(brink_doubt_beyond(after, BRINK_GAPS - 1), 0);
    ck_assert_uint_eq(brink_doubt_within(after, 20), 1); // rightly so
    brink_doubter_destroy(&d);
    brink_run_destroy(&run);
}
END_TEST

// FACTS of the printed algorithm: c = 0 and b < 0 give 0/0, which is "now".
START_TEST(printed_algorithm_2_of_a_pair_on_the_rim_is_counted)
{
    brink_run run;
    brink_doubter d;
    make_two(&run, 0, 0);
    ck_assert_int_eq(brink_doubter_create(&d, &run), 0);
    ck_assert_int_eq(brink_doubter_advance(&d, &run, 1), BRINK_RUN_REACHED);
    const brink_answers *a = d.seen.answers;
    for (int k = 0; k < BRINK_FORMULAS; k++) {
        ck_assert_uint_eq(a[k].asked, 1);
        ck_assert_uint_eq(a[k].other, k == BRINK_FORMULA_PRINTED);
        ck_assert_uint_eq(a[k].astray, 0);
    }
    brink_doubter_destroy(&d);
    brink_run_destroy(&run);
}
END_TEST

// A hair inside instead: the cancelling form has lost the time's digits.
START_TEST(printed_algorithm_2_of_a_pair_at_the_rim_is_astray)
{
    brink_run run;
    brink_doubter d;
    make_two(&run, 0, 0);
    approach(&run);
    ck_assert_int_eq(brink_doubter_create(&d, &run), 0);
    shift(&run, 0x1p-45);
    ck_assert_int_eq(brink_doubter_advance(&d, &run, 1), BRINK_RUN_REACHED);
    ck_assert_uint_eq(d.seen.answers[BRINK_FORMULA_PRINTED].other, 0);
    ck_assert_uint_eq(d.seen.answers[BRINK_FORMULA_PRINTED].astray, 1);
    ck_assert_uint_eq(d.seen.answers[BRINK_FORMULA_OUTWARD].astray, 0);
    brink_doubter_destroy(&d);
    brink_run_destroy(&run);
}
END_TEST

// The closest that a captured pair would come: |r x v| / |v|.
static double miss_of(const brink_run *run)
{
    const double *v0 = run->system.particle[0].v, *v1 = run->system.particle[1].v;
    double r[3];
    brink_separation_now(run, 0, 1, r);
    const double vx = v0[0] - v1[0], vy = v0[1] - v1[1];
    return fabs(r[0] * vy - r[1] * vx) / sqrt(vx * vx + vy * vy);
}

// A core that just touches or misses: there algorithm 1 in plain doubles tells
// never from later by what it has rounded.
START_TEST(algorithm_1_of_a_grazing_pair_is_counted)
{
    uint64_t other = 0;
    for (int k = 1; k <= 100; k++) {
        brink_run run;
        brink_doubter d;
        make_two(&run, 0.007 * k, 0);
        advance(&run, 1);
        const double core = miss_of(&run);
        brink_run_destroy(&run);
        make_two(&run, 0.007 * k, core);
        ck_assert_int_eq(brink_doubter_create(&d, &run), 0);
        ck_assert_int_eq(brink_doubter_advance(&d, &run, 1), BRINK_RUN_REACHED);
        other += d.seen.answers[BRINK_FORMULA_INWARD].other;
        brink_doubter_destroy(&d);
        brink_run_destroy(&run);
    }
    ck_assert_uint_gt(other, 0);
    ck_assert_uint_lt(other, 100);
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
    tcase_add_test(tcase, each_look_at_an_event_counts_what_is_wrong_there_alone);
    tcase_add_test(tcase,
                   a_tolerance_counts_what_is_beyond_it_and_what_is_within);
    tcase_add_test(tcase, printed_algorithm_2_of_a_pair_on_the_rim_is_counted);
    tcase_add_test(tcase, printed_algorithm_2_of_a_pair_at_the_rim_is_astray);
    tcase_add_test(tcase, algorithm_1_of_a_grazing_pair_is_counted);
    suite_add_tcase(suite, tcase);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    const int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
