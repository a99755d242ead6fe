// SPDX-License-Identifier: MIT
#include "conventional_method.h"
#include "suite.h"
#include "systems.h"
#include <brink/event_time.h>
#include <math.h>
#include <string.h>

static const double distances[] = {3, 1};
static const double energies[] = {-1, (double)INFINITY};
static const brink_potential well = {2, distances, energies};

START_TEST(every_method_has_a_name_of_its_own_and_an_idea)
{
    for (int k = 0; k < BRINK_METHODS; k++) {
        const brink_rule *rule = brink_method_rule((enum brink_method)k);
        ck_assert_uint_gt(strlen(rule->name), 0);
        ck_assert_uint_gt(strlen(rule->idea), 0);
        for (int other = 0; other < k; other++)
            ck_assert_str_ne(rule->name,
                             brink_method_rule((enum brink_method)other)->name);
    }
}
END_TEST

// FACTS of the issue: f = t^2 - 2 t is 0 at 0, where the pair comes in, and at 2.
START_TEST(as_printed_a_pair_that_has_just_come_in_gets_out_at_once)
{
    const double r[3] = {1, 0, 0}, v[3] = {-1, 0, 0};
    ck_assert_double_eq(brink_disjoint_time_as_printed(r, v, 1), 0);
    ck_assert_double_eq(brink_disjoint_time(r, v, 1), 2);
}
END_TEST

// The pair that proofs/event_time_printed.v exhibits: it is out between 2 and
// 2 + 2^-49, and the answer is 3 there as here.
START_TEST(as_printed_a_pair_that_is_out_after_two_gets_out_at_three)
{
    const double r[3] = {-1, 0x1p-26, 0}, v[3] = {1, 0, 0};
    ck_assert_double_eq(brink_disjoint_time_as_printed(r, v, 1 + 0x1p-51), 3);
}
END_TEST

START_TEST(as_printed_the_time_is_right_in_the_middle_of_the_well)
{
    const double r[3] = {0.5, 0, 0}, in[3] = {-1, 0, 0}, out[3] = {1, 0, 0};
    ck_assert_double_eq(brink_disjoint_time_as_printed(r, in, 1), 1.5);
    ck_assert_double_eq(brink_disjoint_time_as_printed(r, out, 1), 0.5);
}
END_TEST

START_TEST(as_printed_a_pair_at_rest_never_gets_out)
{
    const double r[3] = {0.5, 0, 0}, rest[3] = {0, 0, 0};
    ck_assert_double_eq(brink_disjoint_time_as_printed(r, rest, 1),
                        (double)INFINITY);
}
END_TEST

START_TEST(position_shows_the_level_on_either_side_of_a_step)
{
    const double outside[3] = {3, 0, 0}, inside[3] = {0, nextafter(3, 0), 0};
    const double far[3] = {0, 0, 100};
    ck_assert_int_eq(brink_level_by_position(&well, outside), 0);
    ck_assert_int_eq(brink_level_by_position(&well, inside), 1);
    ck_assert_int_eq(brink_level_by_position(&well, far), 0);
}
END_TEST

START_TEST(position_shows_nobody_inside_a_hard_core)
{
    const double overlapping[3] = {nextafter(1, 0), 0, 0};
    ck_assert_int_eq(brink_level_by_position(&well, overlapping), 1);
}
END_TEST

// One meeting at the rim, seen from outside, that rounding has put inside, of a
// pair that comes in and is captured by the books.
START_TEST(the_methods_disagree_about_who_is_inside)
{
    brink_run run;
    make_run(&run, square_well);
    ck_assert_int_eq(brink_states_set(&run.states, &run.system, 3, 7, 1), 0);
    const brink_meeting m = {.i = 3,
                             .j = 7,
                             .potential = &well,
                             .step = 0,
                             .seen_inside = 0,
                             .r = {nextafter(3, 0), 0, 0},
                             .v = {-1, 0, 0}};
    static const int answer[BRINK_METHODS] = {
        [BRINK_METHOD_LOGICAL] = 1,      [BRINK_METHOD_POSITION] = 1,
        [BRINK_METHOD_STORED] = 0,       [BRINK_METHOD_NUDGED_TIME] = 0,
        [BRINK_METHOD_NUDGED_PLACE] = 0, [BRINK_METHOD_PRINTED] = 1};
    for (int k = 0; k < BRINK_METHODS; k++)
        ck_assert_int_eq(
            brink_method_rule((enum brink_method)k)->is_inside(&run, &m),
            answer[k]);
    brink_run_destroy(&run);
}
END_TEST

START_TEST(a_level_is_read_from_the_books_or_from_position)
{
    brink_run run;
    make_run(&run, square_well);
    const double r[3] = {1.2, 0, 0}; // within that scene's well of 1.5
    ck_assert_int_eq(brink_states_set(&run.states, &run.system, 3, 7, 0), 0);
    for (int k = 0; k < BRINK_METHODS; k++) {
        const int books = k == BRINK_METHOD_LOGICAL || k == BRINK_METHOD_PRINTED;
        ck_assert_int_eq(
            brink_method_rule((enum brink_method)k)->level(&run, 3, 7, r),
            books ? 0 : 1);
    }
    brink_run_destroy(&run);
}
END_TEST

// Two that have drifted, between crossings, to opposite ends of the box.
START_TEST(the_separation_is_that_of_the_nearest_image)
{
    brink_run run;
    make_run(&run, small_box);
    const double length = run.system.length[0];
    brink_particle *p = run.system.particle;
    for (uint32_t i = 0; i < 2; i++) {
        memset(p[i].x, 0, sizeof p[i].x);
        memset(p[i].v, 0, sizeof p[i].v);
        p[i].since = 0;
    }
    run.now.offset = run.system.year / 2;
    p[0].v[0] = 0.75 * length / run.now.offset;
    double r[3];
    brink_separation_now(&run, 0, 1, r);
    // The drift is rounded thrice; the length subtracted exactly (Sterbenz).
    ck_assert_double_eq_tol(r[0], -0.25 * length, 3 * 0x1p-53 * length);
    brink_run_destroy(&run);
}
END_TEST

int main(void)
{
    return RUN_SUITE("method", 120,
                     every_method_has_a_name_of_its_own_and_an_idea,
                     as_printed_a_pair_that_has_just_come_in_gets_out_at_once,
                     as_printed_a_pair_that_is_out_after_two_gets_out_at_three,
                     as_printed_the_time_is_right_in_the_middle_of_the_well,
                     as_printed_a_pair_at_rest_never_gets_out,
                     position_shows_the_level_on_either_side_of_a_step,
                     position_shows_nobody_inside_a_hard_core,
                     the_methods_disagree_about_who_is_inside,
                     a_level_is_read_from_the_books_or_from_position,
                     the_separation_is_that_of_the_nearest_image);
}
