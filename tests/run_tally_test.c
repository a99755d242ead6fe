// SPDX-License-Identifier: MIT
// What a run has counted, counted again by who looks on, entry by entry.
#include "run.h"
#include "suite.h"
#include "systems.h"
#include <math.h>

// What the next entry will do to the tally: a crossing, a prediction made anew,
// or an event, of which the rest is told afterwards.
static void foretell(brink_run *run, brink_tally *t)
{
    const uint32_t slot = brink_calendar_next(&run->calendar);
    const brink_entry *entry = &run->calendar.entry[slot];
    if (entry->kind == BRINK_ENTRY_CELL)
        t->cell++;
    else if (!brink_run_is_event(run, slot))
        t->stale++;
    else
        t->clamped += entry->at_once;
}

// They met at one of their steps, the nearest to where they are.  An event costs
// less than 64 roundings of 2^-53 of the quantities at hand (sequence_test.c), of
// which the box is the largest.
static void is_at_its_step(const brink_run *run, double distance)
{
    const brink_system *s = &run->system;
    const brink_happening *e = &run->last;
    const brink_potential *p = brink_system_potential(s, e->i, e->j);
    const double box = fmax(s->length[0], fmax(s->length[1], s->length[2]));
    ck_assert_msg(fabs(distance - e->distance) <= 64 * 0x1p-53 * box,
                  "%a from each other, not %a", distance, e->distance);
    for (int k = 0; k < p->count; k++)
        ck_assert(fabs(distance - p->distance[k]) >=
                  fabs(distance - e->distance));
}

// And the event that was executed; `before` is the one before it.
static void count(const brink_run *run, const brink_happening *before,
                  brink_tally *t)
{
    const brink_happening *e = &run->last;
    const int again = brink_tally_events(t) > 0 &&
                      e->when.epoch == before->when.epoch &&
                      e->when.offset == before->when.offset;
    double r[3];
    t->core += e->kind == BRINK_CORE;
    t->capture += e->kind == BRINK_CAPTURE;
    t->release += e->kind == BRINK_RELEASE;
    t->bounce += e->kind == BRINK_BOUNCE;
    t->zero_time += (uint64_t)again;
    t->repeated += again && e->i == before->i && e->j == before->j;
    // They are where they met: velocities have changed since, positions have not.
    brink_system_separation(&run->system, e->i, e->j, e->when.offset, r);
    const double distance = sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
    is_at_its_step(run, distance);
    t->contact_error_max =
        fmax(t->contact_error_max, fabs(distance - e->distance) / e->distance);
}

static void expect(const brink_tally *is, const brink_tally *should)
{
    ck_assert_uint_eq(is->core, should->core);
    ck_assert_uint_eq(is->capture, should->capture);
    ck_assert_uint_eq(is->release, should->release);
    ck_assert_uint_eq(is->bounce, should->bounce);
    ck_assert_uint_eq(is->cell, should->cell);
    ck_assert_uint_eq(is->stale, should->stale);
    ck_assert_uint_eq(is->clamped, should->clamped);
    ck_assert_uint_eq(is->zero_time, should->zero_time);
    ck_assert_uint_eq(is->repeated, should->repeated);
    ck_assert_uint_eq(is->refused, 0);
    ck_assert_msg(is->contact_error_max == should->contact_error_max,
                  "%a, not %a", is->contact_error_max, should->contact_error_max);
}

START_TEST(a_run_counts_what_it_executes)
{
    static const char *const scenes[] = {
        hard_spheres, square_well, square_shoulder, three_steps, crowded_mixture};
    for (size_t k = 0; k < sizeof scenes / sizeof *scenes; k++) {
        brink_run run;
        brink_tally tally = {0};
        make_run(&run, scenes[k]);
        while (brink_tally_events(&run.tally) < 5000) {
            const uint64_t events = brink_tally_events(&run.tally);
            const brink_happening before = run.last;
            foretell(&run, &tally);
            ck_assert_int_eq(brink_run_step(&run), BRINK_RUN_REACHED);
            if (brink_tally_events(&run.tally) > events)
                count(&run, &before, &tally);
        }
        expect(&run.tally, &tally);
        brink_run_destroy(&run);
    }
}
END_TEST

// A run's event after the nth, as if that had been `nth`, and so many before it
// at its instant.
static enum brink_run_status go_on_from(brink_run *run, uint64_t n,
                                        brink_happening nth, uint32_t idle)
{
    make_run(run, hard_spheres);
    advance(run, n);
    run->last = nth;
    run->idle = idle;
    return brink_run_advance(run, n + 1, BRINK_NEVER);
}

START_TEST(an_event_at_the_instant_of_the_one_before_is_counted)
{
    brink_run ahead, run;
    make_run(&ahead, hard_spheres);
    advance(&ahead, 11);
    const brink_happening eleventh = ahead.last;
    for (int k = 0; k < 6; k++) {
        brink_happening tenth = eleventh;
        tenth.i += k == 1 ? 1 : k == 2 ? -1U : 0;
        tenth.j += k == 3 ? 1 : k == 4 ? -1U : 0;
        tenth.when.epoch -= k == 5;
        ck_assert_int_eq(go_on_from(&run, 10, tenth, 0), BRINK_RUN_REACHED);
        ck_assert_uint_eq(run.tally.zero_time, k < 5);
        ck_assert_uint_eq(run.tally.repeated, k == 0);
        ck_assert_uint_eq(run.idle, k < 5);
        brink_run_destroy(&run);
    }
    brink_run_destroy(&ahead);
}
END_TEST

// One more than 1000 and 16 a particle, and it has stopped.
START_TEST(a_run_whose_clock_stands_still_is_stuck)
{
    brink_run ahead, run;
    make_run(&ahead, hard_spheres);
    advance(&ahead, 11);
    const uint32_t most = 1000 + 16 * ahead.system.count;
    ck_assert_int_eq(go_on_from(&run, 10, ahead.last, most - 1),
                     BRINK_RUN_REACHED);
    brink_run_destroy(&run);
    ck_assert_int_eq(go_on_from(&run, 10, ahead.last, most), BRINK_RUN_STUCK);
    brink_run_destroy(&run);
    brink_run_destroy(&ahead);
}
END_TEST

// Of a first event there is none before it, though the clock begins at 0; of a
// second there is.
START_TEST(the_first_event_is_at_nobodys_instant)
{
    for (uint64_t n = 0; n < 2; n++) {
        brink_run ahead, run;
        make_run(&ahead, hard_spheres);
        advance(&ahead, n + 1);
        ck_assert_int_eq(go_on_from(&run, n, ahead.last, 0), BRINK_RUN_REACHED);
        ck_assert_uint_eq(run.tally.zero_time, n);
        brink_run_destroy(&run);
        brink_run_destroy(&ahead);
    }
}
END_TEST

START_TEST(a_target_that_is_behind_is_reached)
{
    brink_run run;
    make_run(&run, hard_spheres);
    advance(&run, 10);
    const brink_instant now = run.now;
    ck_assert_int_eq(brink_run_advance(&run, 9, BRINK_NEVER), BRINK_RUN_REACHED);
    ck_assert_uint_eq(brink_tally_events(&run.tally), 10);
    ck_assert_int_eq(brink_instant_compare(run.now, now), 0);
    brink_run_destroy(&run);
}
END_TEST

START_TEST(an_event_that_was_due_when_predicted_is_counted)
{
    brink_run run;
    make_run(&run, hard_spheres);
    uint32_t slot = brink_calendar_next(&run.calendar);
    while (!brink_run_is_event(&run, slot)) {
        ck_assert_int_eq(brink_run_step(&run), BRINK_RUN_REACHED);
        slot = brink_calendar_next(&run.calendar);
    }
    ck_assert_uint_eq(run.tally.clamped, 0);
    run.calendar.entry[slot].at_once = 1;
    ck_assert_int_eq(brink_run_step(&run), BRINK_RUN_REACHED);
    ck_assert_uint_eq(run.tally.clamped, 1);
    brink_run_destroy(&run);
}
END_TEST

int main(void)
{
    return RUN_SUITE("run_tally", 120, a_run_counts_what_it_executes,
                     an_event_at_the_instant_of_the_one_before_is_counted,
                     a_run_whose_clock_stands_still_is_stuck,
                     the_first_event_is_at_nobodys_instant,
                     a_target_that_is_behind_is_reached,
                     an_event_that_was_due_when_predicted_is_counted);
}
