// SPDX-License-Identifier: MIT
// Memory that is out at any allocation: what asked for it says -1 and keeps
// nothing, or what it had.
#include "rationed.h"
#include "run.h"
#include "suite.h"
#include "systems.h"
#include <string.h>

typedef int make(void); // 0, and nothing of it is left; -1 no memory

/** With the first allocation refused, then the second, and so on, until none is.
 *  How many there are. */
static long all_refused(make *something)
{
    for (long k = 0;; k++) {
        int was_refused;
        const int status = with_ration(something, k, &was_refused);
        ck_assert_msg(status == (was_refused ? -1 : 0), "allocation %ld: %d", k,
                      status);
        if (!was_refused)
            return k;
    }
}

static brink_system sample; // whoever is made is made for it

static int make_states(void)
{
    brink_states s;
    const int status = brink_states_create(&s, &sample);
    if (status == 0)
        brink_states_destroy(&s);
    return status;
}

static int make_lists(void)
{
    brink_lists l;
    const int status = brink_lists_create(&l, 7, 8);
    if (status == 0)
        brink_lists_destroy(&l);
    return status;
}

static int make_calendar(void)
{
    brink_calendar c;
    const int status = brink_calendar_create(&c, 10, 1, 4);
    if (status == 0)
        brink_calendar_destroy(&c);
    return status;
}

static int make_cells(void)
{
    brink_cells c;
    const int status = brink_cells_create(&c, &sample, sample.range);
    if (status == 0)
        brink_cells_destroy(&c);
    return status;
}

START_TEST(who_is_refused_memory_says_so_and_keeps_none)
{
    make_system(&sample, square_well);
    ck_assert_int_eq(all_refused(make_lists), 1);
    ck_assert_int_eq(all_refused(make_states), 2); // counts; lists
    ck_assert_int_eq(all_refused(make_calendar),
                     4);                          // entries, places, heap, days
    ck_assert_int_eq(all_refused(make_cells), 5); // buckets, cells, three walls
    brink_system_destroy(&sample);
}
END_TEST

// A list refused to grow is as it was.
START_TEST(a_list_that_finds_no_memory_is_as_it_was)
{
    brink_lists l;
    ck_assert_int_eq(brink_lists_create(&l, 2, sizeof(int)), 0);
    for (int n = 0; n < 40; n++) {
        ration = 0;
        const int status = brink_lists_make_room(&l, 1, 1);
        const int was_refused = ration < 0;
        ration = -1;
        ck_assert_int_eq(status, was_refused ? -1 : 0);
        for (int k = 0; k < n; k++)
            ck_assert_int_eq(((int *)brink_lists_items(&l, 1))[k], k);
        ck_assert_int_eq(brink_lists_make_room(&l, 1, 1), 0);
        *(int *)brink_lists_add(&l, 1) = n;
    }
    while (l.list[1].count > 1) { // one that may not shrink keeps what it has
        ration = 0;
        brink_lists_remove(&l, 1, l.list[1].count - 1);
        ration = -1;
        ck_assert_uint_ge(l.list[1].room, 40);
    }
    brink_lists_destroy(&l);
    ck_assert_ptr_null(l.list);
    ck_assert_uint_eq(l.lists, 0);
}
END_TEST

START_TEST(a_level_that_finds_no_memory_is_not_set)
{
    brink_states s;
    make_system(&sample, square_well);
    ck_assert_int_eq(brink_states_create(&s, &sample), 0);
    for (long k = 0; k < 2; k++) { // of the one particle, of the other
        ration = k;
        const int status = brink_states_set(&s, &sample, 3, 5, 1);
        ration = -1;
        ck_assert_int_eq(status, -1);
        ck_assert_int_eq(brink_states_level(&s, 3, 5), 0);
        ck_assert_ptr_null(brink_states_is_valid(&s, &sample));
        brink_states_destroy(&s);
        ck_assert_int_eq(brink_states_create(&s, &sample), 0);
    }
    ck_assert_int_eq(brink_states_set(&s, &sample, 3, 5, 1), 0);
    ration = 0; // a level that changes needs none
    const int status = brink_states_set(&s, &sample, 5, 3, 0);
    const long left = ration;
    ration = -1;
    ck_assert_int_eq(status, 0);
    ck_assert_int_eq(left, 0);
    brink_states_destroy(&s);
    brink_system_destroy(&sample);
}
END_TEST

static int make_whole_run(void)
{
    brink_run run;
    brink_system system;
    const long wanted = ration;
    ration = -1; // the system is there
    make_system(&system, square_well);
    ration = wanted;
    const int status = brink_run_create(&run, &system, BRINK_TIER_PLAIN);
    if (status == 0)
        brink_run_destroy(&run);
    return status;
}

// What it is made of is taken apart again, the system with it.
START_TEST(a_run_that_finds_no_memory_is_not_begun)
{
    // Besides what is its own, states, calendar and cells.
    ck_assert_int_gt(all_refused(make_whole_run), 2 + 4 + 5);
}
END_TEST

int main(void)
{
    return RUN_SUITE("memory_rooms", 60,
                     who_is_refused_memory_says_so_and_keeps_none,
                     a_list_that_finds_no_memory_is_as_it_was,
                     a_level_that_finds_no_memory_is_not_set,
                     a_run_that_finds_no_memory_is_not_begun);
}
