// SPDX-License-Identifier: MIT
#include "study_nudges.h"
#include "suite.h"
#include "systems.h"
#include <math.h>

static double off(const char *scene, enum brink_method method, double nudge,
                  uint64_t events)
{
    brink_system start;
    brink_watch watch;
    double steps;
    brink_watch_begin(&watch);
    make_system(&start, scene);
    ck_assert_int_eq(
        brink_nudge_try(&start, method, nudge, events, &watch, &steps), 0);
    brink_watch_end(&watch);
    return steps;
}

START_TEST(two_methods_nudge)
{
    for (int k = 0; k < BRINK_METHODS; k++)
        ck_assert_int_eq(brink_nudge_is_used((enum brink_method)k),
                         k == BRINK_METHOD_NUDGED_TIME ||
                             k == BRINK_METHOD_NUDGED_PLACE);
}
END_TEST

START_TEST(sizes_go_up_and_pass_those_that_are_used)
{
    for (int k = 1; k < BRINK_NUDGES; k++)
        ck_assert_double_gt(brink_nudge_size(k), brink_nudge_size(k - 1));
    ck_assert_double_lt(brink_nudge_size(0), 0x1p-53); // lost in a rounding
    ck_assert_double_gt(brink_nudge_size(BRINK_NUDGES - 1), BRINK_PLACE_NUDGE);
}
END_TEST

static const enum brink_method nudging[] = {BRINK_METHOD_NUDGED_TIME,
                                            BRINK_METHOD_NUDGED_PLACE};

START_TEST(a_nudge_below_rounding_is_as_good_as_none)
{
    for (int k = 0; k < 2; k++)
        ck_assert_double_gt(off(square_well, nudging[k], 1e-16, 5000), 0.5);
}
END_TEST

START_TEST(a_nudge_that_is_used_keeps_the_energy)
{
    // One state told wrongly would make it 1.
    for (int k = 0; k < 2; k++)
        ck_assert_double_lt(off(square_well, nudging[k], 1e-11, 5000), 0.5);
}
END_TEST

START_TEST(a_nudge_as_long_as_a_step_loses_events)
{
    for (int k = 0; k < 2; k++)
        ck_assert_double_gt(off(square_well, nudging[k], 0.01, 5000), 0.5);
}
END_TEST

START_TEST(time_that_stands_still_is_infinitely_far_off)
{
    const double without =
        off(square_shoulder, BRINK_METHOD_NUDGED_TIME, 1e-30, 20000);
    ck_assert_double_eq(without, (double)INFINITY);
}
END_TEST

START_TEST(energy_is_off_by_whole_steps)
{
    const double steps = off(square_well, BRINK_METHOD_NUDGED_PLACE, 0.01, 2000);
    ck_assert_double_gt(steps, 0);
    // 2000 events, in each six components of a velocity below 8 rounded to 2^-50.
    ck_assert_double_eq_tol(steps, rint(steps), 2000 * 6 * 8 * 0x1p-50);
}
END_TEST

START_TEST(a_stop_is_heard)
{
    brink_system start;
    brink_watch watch;
    double steps;
    brink_watch_begin(&watch);
    ck_assert_int_eq(raise(SIGTERM), 0);
    make_system(&start, square_well);
    ck_assert_int_eq(brink_nudge_try(&start, BRINK_METHOD_NUDGED_TIME, 1e-11,
                                     UINT64_MAX, &watch, &steps),
                     -1);
    ck_assert_int_eq(brink_watch_stopped(&watch), 0); // taken
    brink_watch_end(&watch);
}
END_TEST

int main(void)
{
    return RUN_SUITE("nudges", 300, two_methods_nudge,
                     sizes_go_up_and_pass_those_that_are_used,
                     a_nudge_below_rounding_is_as_good_as_none,
                     a_nudge_that_is_used_keeps_the_energy,
                     a_nudge_as_long_as_a_step_loses_events,
                     time_that_stands_still_is_infinitely_far_off,
                     energy_is_off_by_whole_steps, a_stop_is_heard);
}
