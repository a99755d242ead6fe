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
    uint64_t before, after, later, looks, overlaps;
    pair *waiting;
    size_t count;
} naive;

static int shares_one(pair a, pair b)
{
    const int first = a.i == b.i || a.i == b.j, second = a.j == b.i || a.j == b.j;
    return first != second;
}

static void look_naively(naive *n, const brink_run *run)
{
    const brink_happening *last = &run->last;
    const pair now = {last->i, last->j};
    int overlap, core = last->kind == BRINK_CORE;
    const int level = level_shown(run, now.i, now.j, &overlap);
    n->before += level != last->level_before;
    n->after += level != last->level_after;
    n->overlaps += (uint64_t)(core && overlap);
    size_t kept = 0;
    for (size_t k = 0; k < n->count; k++) {
        const pair p = n->waiting[k];
        if (shares_one(p, now)) {
            n->looks++;
            n->later += level_shown(run, p.i, p.j, &overlap) !=
                        brink_states_level(&run->states, p.i, p.j);
        } else if (p.i != now.i || p.j != now.j) {
            n->waiting[kept++] = p;
        }
    }
    n->waiting[kept++] = now;
    n->count = kept;
}

START_TEST(counts_are_those_of_a_naive_reference)
{
    static const char *const scenes[] = {square_well, square_shoulder,
                                         three_steps, mixture};
    for (int k = 0; k < 4; k++) {
        brink_run run;
        brink_doubts d;
        make_run(&run, scenes[k]);
        naive n = {.waiting = calloc(run.system.count, sizeof(pair))};
        ck_assert_int_eq(brink_doubts_create(&d, run.system.count), 0);
        for (uint64_t e = 1; e <= 3000; e++) {
            advance(&run, e);
            brink_doubts_look(&d, &run);
            look_naively(&n, &run);
        }
        ck_assert_uint_eq(d.events, 3000);
        ck_assert_uint_eq(d.before, n.before);
        ck_assert_uint_eq(d.after, n.after);
        ck_assert_uint_eq(d.later, n.later);
        ck_assert_uint_eq(d.looks_later, n.looks);
        ck_assert_uint_eq(d.overlaps, n.overlaps);
        // None of them is empty, or this would compare nothing with nothing.
        ck_assert_uint_gt(n.before, 0);
        ck_assert_uint_gt(n.after, 0);
        ck_assert_uint_gt(n.looks, 0);
        ck_assert_uint_gt(n.overlaps, 0);
        free(n.waiting);
        brink_doubts_destroy(&d);
        brink_run_destroy(&run);
    }
}
END_TEST

START_TEST(a_transfer_is_in_doubt_on_just_one_side_a_bounce_on_both_or_none)
{
    brink_run run;
    brink_doubts d;
    make_run(&run, square_well);
    ck_assert_int_eq(brink_doubts_create(&d, run.system.count), 0);
    for (uint64_t e = 1; e <= 3000; e++) {
        const brink_doubts then = d;
        advance(&run, e);
        brink_doubts_look(&d, &run);
        const uint64_t before = d.before - then.before,
                       after = d.after - then.after;
        if (run.last.kind == BRINK_CAPTURE || run.last.kind == BRINK_RELEASE)
            ck_assert_uint_eq(before + after, 1);
        else
            ck_assert_uint_eq(before, after);
        if (run.last.kind == BRINK_CORE)
            ck_assert_uint_eq(before, 0);
    }
    brink_doubts_destroy(&d);
    brink_run_destroy(&run);
}
END_TEST

// Books that for the time of one look say the opposite of what positions show.
START_TEST(a_state_that_is_wrong_at_the_next_event_is_counted)
{
    brink_run run;
    brink_doubts d;
    make_run(&run, square_well);
    ck_assert_int_eq(brink_doubts_create(&d, run.system.count), 0);
    uint32_t i = 0, met = BRINK_NOBODY;
    for (uint64_t e = 1; met == BRINK_NOBODY || met == run.last.j; e++) {
        if (e > 1)
            brink_doubts_look(&d, &run);
        advance(&run, e);
        i = run.last.i;
        met = d.partner[i];
    }
    ck_assert_uint_eq(d.later, 0);
    const int level = brink_states_level(&run.states, i, met);
    ck_assert_int_eq(brink_states_set(&run.states, &run.system, i, met, !level),
                     0);
    brink_doubts_look(&d, &run);
    ck_assert_uint_eq(d.later, 1);
    brink_doubts_destroy(&d);
    brink_run_destroy(&run);
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "doubts", 300, counts_are_those_of_a_naive_reference,
        a_transfer_is_in_doubt_on_just_one_side_a_bounce_on_both_or_none,
        a_state_that_is_wrong_at_the_next_event_is_counted);
}
