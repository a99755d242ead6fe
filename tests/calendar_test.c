// SPDX-License-Identifier: MIT
#include "calendar.h"
#include "suite.h"
#include <gsl/gsl_rng.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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
    ck_assert_int_eq(c.epoch, INT64_C(1) << 40); // and no further
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

START_TEST(an_event_before_this_year_is_next_at_once_however_late_in_its_own)
{
    brink_calendar c;
    ck_assert_int_eq(brink_calendar_create(&c, SLOTS, YEAR, 16), 0);
    set(&c, 1, 2, 0.1, BRINK_ENTRY_CELL, 1, 0);
    ck_assert_uint_eq(brink_calendar_next(&c), 1);
    set(&c, 2, 1, 7.9, BRINK_ENTRY_CELL, 2, 0);
    ck_assert_uint_eq(brink_calendar_next(&c), 2);
    expect_valid(&c);
    brink_calendar_destroy(&c);
}
END_TEST

// Either way round, and neither before itself.
static void in_this_order(const brink_entry *a, const brink_entry *b)
{
    ck_assert_int_eq(brink_entry_compare(a, b), -1);
    ck_assert_int_eq(brink_entry_compare(b, a), 1);
    ck_assert_int_eq(brink_entry_compare(a, a), 0);
}

START_TEST(what_is_earlier_is_minus_one_what_is_later_one)
{
    const brink_entry e = {.when = {3, 2.0}, .i = 4, .j = 5, .kind = 1};
    brink_entry later[5] = {e, e, e, e, e};
    later[0].when.epoch++;
    later[1].when.offset = 2.5;
    later[2].kind++;
    later[3].i++;
    later[4].j++;
    for (int k = 0; k < 5; k++)
        in_this_order(&e, &later[k]);
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

// All of them in the heap of one day, in an order that is not their own, some of
// them at one time and alike but for the slot; then taken, moved and taken again.
START_TEST(a_day_with_everybody_in_it_is_in_order)
{
    brink_calendar c;
    ck_assert_int_eq(brink_calendar_create(&c, SLOTS, YEAR, 1), 0);
    for (uint32_t n = 0; n < SLOTS; n++) {
        const uint32_t s = n * 7 % SLOTS; // 7 and 300 have no common divisor
        set(&c, s, 0, (s * 11 % 60) / 8.0, BRINK_ENTRY_INWARD, 1, 2);
        expect_valid(&c);
    }
    ck_assert_uint_eq(c.heap_count, SLOTS);
    for (uint32_t s = 0; s < SLOTS; s += 3) { // earlier, later, gone
        set(&c, s, 0, (s * 13 % 60) / 8.0, BRINK_ENTRY_INWARD, 1, 2);
        expect_valid(&c);
        if (s % 2)
            clear(&c, s);
        expect_valid(&c);
    }
    for (uint32_t left = c.heap_count; left > 0; left--) {
        const uint32_t slot = brink_calendar_next(&c);
        ck_assert_uint_eq(slot, earliest(&c)); // of those alike the lowest
        clear(&c, slot);
        expect_valid(&c);
    }
    ck_assert_uint_eq(brink_calendar_next(&c), SLOTS);
    brink_calendar_destroy(&c);
}
END_TEST

// What makes it O(1): only today's events are in the heap, in every year.
START_TEST(other_days_wait_outside_the_heap)
{
    brink_calendar c;
    ck_assert_int_eq(brink_calendar_create(&c, 64, YEAR, 32), 0);
    for (uint32_t s = 0; s < 64; s++) // one a day for two years, from the last on
        set(&c, 63 - s, (63 - s) / 32, (63 - s) % 32 * YEAR / 32,
            BRINK_ENTRY_CELL, s, 0);
    for (uint32_t s = 0; s < 64; s++) {
        ck_assert_uint_eq(brink_calendar_next(&c), s);
        ck_assert_uint_eq(c.heap_count, 1);
        ck_assert_uint_eq(c.today, s % 32);
        ck_assert_int_eq(c.epoch, s / 32);
        expect_valid(&c);
        clear(&c, s);
    }
    brink_calendar_destroy(&c);
    brink_calendar_destroy(&c); // of nothing
}
END_TEST

static void expect_fault(const brink_calendar *c, const char *word)
{
    const char *fault = brink_calendar_is_valid(c);
    ck_assert_ptr_nonnull(fault);
    ck_assert_msg(strstr(fault, word) != NULL, "\"%s\", not \"%s\"", fault, word);
}

#define EXPECT_FAULT_IF(place, wrong, word)                                      \
    do {                                                                         \
        const uint32_t right = place;                                            \
        place = wrong;                                                           \
        expect_fault(&c, word);                                                  \
        place = right;                                                           \
        expect_valid(&c);                                                        \
    } while (0)

// One thing is put wrong at a time, and right again.
START_TEST(the_check_sees_what_is_wrong_and_says_so)
{
    brink_calendar c;
    ck_assert_int_eq(brink_calendar_create(&c, SLOTS, YEAR, 16), 0);
    for (uint32_t s = 0; s < 60; s++) { // 20 a year, in half the days: 0, 2, ...
        const uint32_t unit = s % 20 / 3;
        set(&c, s, s / 20, unit, BRINK_ENTRY_CELL, s, 0);
    }
    clear(&c, brink_calendar_next(&c));
    for (uint32_t p = 0; p < c.heap_count; p++) {
        const uint32_t slot = c.heap[p], places[] = {p + 1, p - 1, SLOTS};
        for (int k = 0; k < 3; k++)
            EXPECT_FAULT_IF(c.filed[slot].place, places[k], "about a place");
    }
    // in a list: of today + 2, and of later years
    const uint32_t lists[] = {c.today + 2, c.days};
    for (int n = 0; n < 2; n++) {
        const uint32_t s = c.first[lists[n]], place = c.filed[s].place;
        EXPECT_FAULT_IF(c.filed[s].place, place - 1, "disagree");
        EXPECT_FAULT_IF(c.filed[s].place, place + 1, "disagree");
        EXPECT_FAULT_IF(c.filed[s].previous, s, "disagree");
        EXPECT_FAULT_IF(c.first[lists[n]], SLOTS + 1, "disagree");
        EXPECT_FAULT_IF(c.filed[c.filed[s].next].previous, SLOTS, "disagree");
        // an event of another year, of this one, of another day
        const brink_instant right = c.entry[s].when;
        for (int year = -1; year < 3; year++)
            if (n == 0 ? year != 0 : year <= 0) {
                c.entry[s].when.epoch = year;
                expect_fault(&c, "of another day");
            }
        c.entry[s].when = right;
        for (int day = 0; day < 16 && n == 0; day++)
            if ((uint32_t)day != lists[n]) {
                c.entry[s].when.offset = day * YEAR / 16;
                expect_fault(&c, "of another day");
            }
        c.entry[s].when = right;
        expect_valid(&c);
    }
    // what is in the list of today, or of a day gone by
    EXPECT_FAULT_IF(c.today, lists[0], "of another day");
    EXPECT_FAULT_IF(c.today, lists[0] + 1, "of another day");
    EXPECT_FAULT_IF(c.first[0], c.first[lists[0]], "disagree");
    EXPECT_FAULT_IF(c.heap[0], SLOTS + 1, "about a place");
    const uint32_t none = c.heap[c.heap_count - 1]; // is no event, and filed
    const brink_instant when = c.entry[none].when;
    c.entry[none].when = BRINK_NEVER;
    expect_fault(&c, "nowhere");
    c.entry[none].when = when;
    c.entry[none].when.epoch = 1; // the next year
    expect_fault(&c, "or year is in the heap");
    c.entry[none].when = when;
    c.entry[none].when.offset = YEAR / 16; // tomorrow
    expect_fault(&c, "of a later day");
    c.entry[none].when = when;
    c.entry[SLOTS - 1].when = (brink_instant){0, 0.0}; // and is filed nowhere
    expect_fault(&c, "nowhere");
    c.entry[SLOTS - 1].when = BRINK_NEVER;
    const double last = c.entry[c.heap[c.heap_count - 1]].when.offset;
    c.entry[c.heap[c.heap_count - 1]].when.offset = -1;
    expect_fault(&c, "out of order");
    c.entry[c.heap[c.heap_count - 1]].when.offset = last;
    expect_valid(&c);
    brink_calendar_destroy(&c);
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "calendar", 120, an_empty_calendar_has_no_next,
        simultaneous_events_come_by_kind_then_by_particles,
        years_without_events_are_passed_over,
        an_event_before_today_is_next_at_once,
        an_event_before_this_year_is_next_at_once_however_late_in_its_own,
        what_is_earlier_is_minus_one_what_is_later_one,
        what_comes_next_is_what_a_look_through_all_finds,
        a_day_with_everybody_in_it_is_in_order, other_days_wait_outside_the_heap,
        the_check_sees_what_is_wrong_and_says_so);
}
