// SPDX-License-Identifier: MIT
#include "calendar.h"
#include "suite.h"
#include <gsl/gsl_rng.h>
#include <stdio.h>
#include <stdlib.h>

enum { SLOTS = 300 };
#define YEAR 8.0

static void expect_valid(const brink_calendar *c)
{
    const char *fault = brink_calendar_is_valid(c);
    ck_assert_msg(!fault, "%s", fault);
}

static void set(brink_calendar *c, uint32_t slot, int64_t epoch, double offset,
                enum brink_entry_kind kind, uint32_t i, uint32_t j)
{
    const brink_entry e = {
        .when = {epoch, offset}, .i = i, .j = j, .kind = (uint16_t)kind};
    brink_calendar_set(c, slot, &e);
}

static void clear(brink_calendar *c, uint32_t slot)
{
    brink_calendar_set(c, slot, &(brink_entry){.when = BRINK_NEVER});
}

START_TEST(an_empty_calendar_has_no_next)
{
    brink_calendar c;
    ck_assert_int_eq(brink_calendar_create(&c, SLOTS, YEAR, 16), 0);
    ck_assert_uint_eq(brink_calendar_next(&c), SLOTS);
    set(&c, 5, 3, 1.0, BRINK_ENTRY_CELL, 5, 0);
    ck_assert_uint_eq(brink_calendar_next(&c), 5);
    clear(&c, 5);
    ck_assert_uint_eq(brink_calendar_next(&c), SLOTS);
    expect_valid(&c);
    brink_calendar_destroy(&c);
}
END_TEST

START_TEST(simultaneous_events_come_by_kind_then_by_particles)
{
    brink_calendar c;
    ck_assert_int_eq(brink_calendar_create(&c, SLOTS, YEAR, 16), 0);
    set(&c, 0, 1, 2.0, BRINK_ENTRY_CELL, 0, 0);
    set(&c, 1, 1, 2.0, BRINK_ENTRY_OUTWARD, 1, 2);
    set(&c, 2, 1, 2.0, BRINK_ENTRY_INWARD, 4, 9);
    set(&c, 3, 1, 2.0, BRINK_ENTRY_INWARD, 4, 8);
    set(&c, 4, 1, 2.0, BRINK_ENTRY_INWARD, 3, 9);
    const uint32_t order[] = {4, 3, 2, 1, 0};
    for (int k = 0; k < 5; k++) {
        ck_assert_uint_eq(brink_calendar_next(&c), order[k]);
        clear(&c, order[k]);
    }
    brink_calendar_destroy(&c);
}
END_TEST

START_TEST(years_without_events_are_passed_over)
{
    brink_calendar c;
    ck_assert_int_eq(brink_calendar_create(&c, SLOTS, YEAR, 16), 0);
    set(&c, 7, INT64_C(1) << 60, 1.0, BRINK_ENTRY_CELL, 7, 0);
    set(&c, 8, INT64_C(1) << 40, 1.0, BRINK_ENTRY_CELL, 8, 0);
    ck_assert_uint_eq(brink_calendar_next(&c), 8);
    clear(&c, 8);
    expect_valid(&c);
    ck_assert_uint_eq(brink_calendar_next(&c), 7);
    brink_calendar_destroy(&c);
}
END_TEST

START_TEST(an_event_before_today_is_next_at_once)
{
    brink_calendar c;
    ck_assert_int_eq(brink_calendar_create(&c, SLOTS, YEAR, 16), 0);
    set(&c, 1, 2, 7.9, BRINK_ENTRY_CELL, 1, 0);
    ck_assert_uint_eq(brink_calendar_next(&c), 1);
    set(&c, 2, 2, 0.1, BRINK_ENTRY_CELL, 2, 0);
    set(&c, 3, 1, 0.1, BRINK_ENTRY_CELL, 3, 0);
    ck_assert_uint_eq(brink_calendar_next(&c), 3);
    expect_valid(&c);
    brink_calendar_destroy(&c);
}
END_TEST

static uint32_t earliest(const brink_calendar *c)
{
    uint32_t best = SLOTS;
    for (uint32_t s = 0; s < SLOTS; s++)
        if (c->entry[s].when.epoch != INT64_MAX &&
            (best == SLOTS ||
             brink_entry_compare(&c->entry[s], &c->entry[best]) < 0))
            best = s;
    return best;
}

// Against a look through all slots: a random log of takings, settings and
// clearings, with ties (times are multiples of 1/8) and gaps of many years.
START_TEST(what_comes_next_is_what_a_look_through_all_finds)
{
    const unsigned long seed = 20260102;
    printf("seed %lu\n", seed);
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(rng, seed);
    brink_calendar c;
    ck_assert_int_eq(brink_calendar_create(&c, SLOTS, YEAR, 37), 0);
    ck_assert_uint_eq(c.days, 64);
    brink_instant now = {0, 0.0};
    for (int step = 0; step < (int)suite_share(200000); step++) {
        const uint32_t slot = brink_calendar_next(&c);
        ck_assert_msg(slot == earliest(&c), "step %d", step);
        if (slot < SLOTS) {
            now = c.entry[slot].when;
            clear(&c, slot);
        }
        for (unsigned long n = gsl_rng_uniform_int(rng, 3); n > 0; n--) {
            const double reach = gsl_rng_uniform_int(rng, 50) ? 16 : 4000;
            const double dt =
                (double)gsl_rng_uniform_int(rng, (unsigned long)(8 * reach)) /
                8.0;
            const brink_instant t = brink_instant_after(YEAR, now, dt);
            set(&c, (uint32_t)gsl_rng_uniform_int(rng, SLOTS), t.epoch, t.offset,
                (enum brink_entry_kind)gsl_rng_uniform_int(rng, 3),
                (uint32_t)gsl_rng_uniform_int(rng, 4),
                (uint32_t)gsl_rng_uniform_int(rng, SLOTS));
        }
        if (step % 1000 == 0)
            expect_valid(&c);
    }
    brink_calendar_destroy(&c);
    gsl_rng_free(rng);
}
END_TEST

START_TEST(the_check_sees_what_is_out_of_order)
{
    brink_calendar c;
    ck_assert_int_eq(brink_calendar_create(&c, SLOTS, YEAR, 16), 0);
    for (uint32_t s = 0; s < 50; s++)
        set(&c, s, s % 3, s * 0.15, BRINK_ENTRY_CELL, s, 0);
    brink_calendar_next(&c);
    expect_valid(&c);
    c.entry[c.heap[0]].when.offset = 7.5;
    ck_assert_ptr_nonnull(brink_calendar_is_valid(&c));
    brink_calendar_destroy(&c);
}
END_TEST

int main(void)
{
    return RUN_SUITE("calendar", 120, an_empty_calendar_has_no_next,
                     simultaneous_events_come_by_kind_then_by_particles,
                     years_without_events_are_passed_over,
                     an_event_before_today_is_next_at_once,
                     what_comes_next_is_what_a_look_through_all_finds,
                     the_check_sees_what_is_out_of_order);
}
