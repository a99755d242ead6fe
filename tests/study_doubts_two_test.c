// SPDX-License-Identifier: MIT
// Doubts about two particles, whose one event is known to the last bit.
#include "study_doubts.h"
#include "suite.h"
#include "systems.h"
#include <math.h>
#include <string.h>

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
    return RUN_SUITE("doubts of two", 60,
                     each_look_at_an_event_counts_what_is_wrong_there_alone,
                     a_tolerance_counts_what_is_beyond_it_and_what_is_within,
                     printed_algorithm_2_of_a_pair_on_the_rim_is_counted,
                     printed_algorithm_2_of_a_pair_at_the_rim_is_astray,
                     algorithm_1_of_a_grazing_pair_is_counted);
}
