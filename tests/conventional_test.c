// SPDX-License-Identifier: MIT
#include "conventional.h"
#include "suite.h"
#include "systems.h"
#include <inttypes.h>
#include <math.h>

static void make_conventional(brink_conventional *c, const char *scene,
                              enum brink_method method)
{
    brink_system system;
    make_system(&system, scene);
    ck_assert_int_eq(
        brink_conventional_create(c, &system, brink_method_rule(method)), 0);
}

// The control: with logical states this loop does what the run does, event by
// event and bit by bit; so whatever else the methods do is due to their rule.
static void compare_with_run(const char *scene, uint64_t events)
{
    brink_run run;
    brink_conventional c;
    make_run(&run, scene);
    make_conventional(&c, scene, BRINK_METHOD_LOGICAL);
    for (uint64_t n = 1; n <= events; n++) {
        advance(&run, n);
        ck_assert_int_eq(brink_conventional_advance(&c, n), BRINK_RUN_REACHED);
        const brink_happening *a = &run.last, *b = &c.house.last;
        ck_assert_msg(a->kind == b->kind && a->i == b->i && a->j == b->j &&
                          a->level_before == b->level_before &&
                          a->level_after == b->level_after &&
                          brink_instant_compare(a->when, b->when) == 0,
                      "event %" PRIu64 ": %d of %" PRIu32 "-%" PRIu32
                      " at %a, not %d of %" PRIu32 "-%" PRIu32 " at %a",
                      n, a->kind, a->i, a->j, a->when.offset, b->kind, b->i, b->j,
                      b->when.offset);
    }
    brink_run_destroy(&run);
    brink_conventional_destroy(&c);
}

START_TEST(with_logical_states_the_loop_is_the_run)
{
    static const char *const scenes[] = {
        hard_spheres, square_well, square_shoulder, three_steps,
        mixture,      discs_well,  small_box};
    compare_with_run(scenes[_i], 3000);
}
END_TEST

// How far the energy is off, in steps of the potential: each state told wrongly
// costs a whole one.  What rounding can do in 20 000 events stays far below: each
// rounds six components of velocities below 8, together 6 * 8 * 2^-50 * 8 at the
// worst.
static double energy_off(const brink_conventional *c, double begin)
{
    return fabs(brink_energy_by_position(&c->house) - begin);
}

static uint64_t events_of(const brink_conventional *c)
{
    return brink_tally_events(&c->house.tally);
}

// Runs until time stands still or the energy is off by one |epsilon| a particle.
static enum brink_run_status run_to_failure(brink_conventional *c,
                                            const char *scene,
                                            enum brink_method method,
                                            uint64_t events)
{
    make_conventional(c, scene, method);
    const double begin = brink_energy_by_position(&c->house);
    enum brink_run_status status = BRINK_RUN_REACHED;
    while (status == BRINK_RUN_REACHED && events_of(c) < events &&
           energy_off(c, begin) <= c->house.system.count)
        status = brink_conventional_advance(c, events_of(c) + 50);
    return status;
}

static void fails_within(const char *scene, enum brink_method method,
                         uint64_t events)
{
    brink_conventional c;
    const enum brink_run_status status =
        run_to_failure(&c, scene, method, events);
    ck_assert_msg(status == BRINK_RUN_STUCK || events_of(&c) < events,
                  "status %d after %" PRIu64 " events", status, events_of(&c));
    brink_conventional_destroy(&c);
}

START_TEST(state_from_position_fails)
{
    fails_within(square_well, BRINK_METHOD_POSITION, 2000);
    fails_within(square_shoulder, BRINK_METHOD_POSITION, 2000);
}
END_TEST

START_TEST(the_stored_separation_fails)
{
    fails_within(square_well, BRINK_METHOD_STORED, 2000);
    fails_within(square_shoulder, BRINK_METHOD_STORED, 2000);
}
END_TEST

// [S16] section 5: "becomes stuck and repeatedly executes identical release
// events", and "the kinetic energy increases with each event".
START_TEST(the_stored_separation_releases_the_same_pair_over_and_over)
{
    brink_conventional c;
    make_conventional(&c, square_shoulder, BRINK_METHOD_STORED);
    uint64_t before = 0;
    while (c.still < 20 && events_of(&c) < 2000)
        ck_assert_int_eq(
            brink_conventional_advance(&c, before = events_of(&c) + 1),
            BRINK_RUN_REACHED);
    ck_assert_uint_eq(c.still, 20);
    const double kinetic = brink_system_kinetic_energy(&c.house.system);
    ck_assert_int_eq(c.house.last.kind, BRINK_RELEASE);
    ck_assert_int_eq(brink_conventional_advance(&c, before + 1),
                     BRINK_RUN_REACHED);
    ck_assert_int_eq(c.house.last.kind, BRINK_RELEASE);
    // One epsilon more, to within the rounding of energies of some hundreds.
    ck_assert_double_eq_tol(
        brink_system_kinetic_energy(&c.house.system) - kinetic, 1, 1e-9);
    brink_conventional_destroy(&c);
}
END_TEST

START_TEST(as_printed_time_stands_still_and_energy_is_kept)
{
    static const char *const scenes[] = {square_well, square_shoulder};
    for (int k = 0; k < 2; k++) {
        brink_conventional c;
        make_conventional(&c, scenes[k], BRINK_METHOD_PRINTED);
        const double begin = brink_energy_by_position(&c.house);
        ck_assert_int_eq(brink_conventional_advance(&c, 20000), BRINK_RUN_STUCK);
        ck_assert_uint_eq(c.still, BRINK_STANDSTILL + 1);
        ck_assert_double_lt(energy_off(&c, begin), 0.5);
        brink_conventional_destroy(&c);
    }
}
END_TEST

static void comes_through(const char *scene, enum brink_method method)
{
    brink_conventional c;
    ck_assert_int_eq(run_to_failure(&c, scene, method, 20000), BRINK_RUN_REACHED);
    ck_assert_uint_eq(events_of(&c), 20000);
    brink_conventional_destroy(&c);
    make_conventional(&c, scene, method);
    const double begin = brink_energy_by_position(&c.house);
    ck_assert_int_eq(brink_conventional_advance(&c, 20000), BRINK_RUN_REACHED);
    ck_assert_double_lt(energy_off(&c, begin), 0.5);
    brink_conventional_destroy(&c);
}

START_TEST(logical_states_come_through)
{
    comes_through(square_well, BRINK_METHOD_LOGICAL);
    comes_through(square_shoulder, BRINK_METHOD_LOGICAL);
}
END_TEST

START_TEST(nudged_methods_come_through_this_time)
{
    comes_through(square_well, BRINK_METHOD_NUDGED_TIME);
    comes_through(square_shoulder, BRINK_METHOD_NUDGED_TIME);
    comes_through(square_well, BRINK_METHOD_NUDGED_PLACE);
    comes_through(square_shoulder, BRINK_METHOD_NUDGED_PLACE);
}
END_TEST

// Right after an event |r| is off the step by the nudge, on the side the pair is
// to be on, and by nothing like as much without one.
START_TEST(a_nudged_pair_lies_clear_of_the_step_on_its_new_side)
{
    brink_conventional c;
    make_conventional(&c, square_well, BRINK_METHOD_NUDGED_PLACE);
    int seen = 0;
    for (uint64_t n = 1; n <= 2000; n++) {
        double r[3];
        ck_assert_int_eq(brink_conventional_advance(&c, n), BRINK_RUN_REACHED);
        const brink_happening *last = &c.house.last;
        if (last->kind == BRINK_CORE)
            continue;
        brink_separation_now(&c.house, last->i, last->j, r);
        const double off =
            sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]) / last->distance - 1;
        const double side = last->level_after == 0 ? 1 : -1;
        // Both are moved; the rest is rounding, here of numbers near 1.
        ck_assert_double_eq_tol(off * side, 2 * BRINK_PLACE_NUDGE, 1e-14);
        seen++;
    }
    ck_assert_int_gt(seen, 500);
    brink_conventional_destroy(&c);
}
END_TEST

// The naive reference: every pair, and no cells.
static double energy_of_all_pairs(const brink_run *run)
{
    const brink_system *s = &run->system;
    double energy = brink_system_kinetic_energy(s);
    for (uint32_t i = 0; i < s->count; i++)
        for (uint32_t j = i + 1; j < s->count; j++) {
            double r[3];
            brink_separation_now(run, i, j, r);
            const brink_potential *p = brink_system_potential(s, i, j);
            const int last = i == run->last.i && j == run->last.j;
            energy += brink_potential_energy(
                p, last ? run->last.level_after : brink_level_by_position(p, r));
        }
    return energy;
}

START_TEST(the_energy_by_position_is_that_of_all_pairs_and_of_the_books)
{
    static const char *const scenes[] = {square_well, three_steps, mixture,
                                         small_box};
    for (int k = 0; k < 4; k++) {
        brink_run run;
        make_run(&run, scenes[k]);
        for (uint64_t n = 0; n < 300; n += 7) {
            advance(&run, n);
            const double energy = brink_energy_by_position(&run);
            // Sums of up to 256 + 256 * 12 terms below 100, in doubles.
            ck_assert_double_eq_tol(energy, energy_of_all_pairs(&run), 1e-9);
            ck_assert_double_eq_tol(energy, brink_run_energy(&run), 1e-9);
        }
        brink_run_destroy(&run);
    }
}
END_TEST

START_TEST(the_same_start_fails_in_the_same_way)
{
    brink_conventional a, b;
    run_to_failure(&a, square_well, BRINK_METHOD_POSITION, 2000);
    run_to_failure(&b, square_well, BRINK_METHOD_POSITION, 2000);
    ck_assert_int_eq(same_state(&a.house, &b.house), 1);
    brink_conventional_destroy(&a);
    brink_conventional_destroy(&b);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("conventional");
    TCase *control = tcase_create("control"), *methods = tcase_create("methods");
    tcase_set_timeout(control, 300);
    tcase_set_timeout(methods, 300);
    tcase_add_loop_test(control, with_logical_states_the_loop_is_the_run, 0, 7);
    tcase_add_test(methods, state_from_position_fails);
    tcase_add_test(methods, the_stored_separation_fails);
    tcase_add_test(methods,
                   the_stored_separation_releases_the_same_pair_over_and_over);
    tcase_add_test(methods, as_printed_time_stands_still_and_energy_is_kept);
    tcase_add_test(methods, logical_states_come_through);
    tcase_add_test(methods, nudged_methods_come_through_this_time);
    tcase_add_test(methods, a_nudged_pair_lies_clear_of_the_step_on_its_new_side);
    tcase_add_test(methods,
                   the_energy_by_position_is_that_of_all_pairs_and_of_the_books);
    tcase_add_test(methods, the_same_start_fails_in_the_same_way);
    suite_add_tcase(suite, control);
    suite_add_tcase(suite, methods);
    return run_whole_suite(suite);
}
