// SPDX-License-Identifier: MIT
#include "run.h"
#include "run_predict.h"
#include "suite.h"
#include "systems.h"
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const scenes[] = {
    hard_spheres, square_well, square_shoulder, three_steps,    mixture,
    discs_well,   small_box,   crowded_spheres, crowded_mixture};
enum { ALL = sizeof scenes / sizeof *scenes };

static void expect_valid(const brink_run *run)
{
    const char *fault = brink_run_is_valid(run);
    ck_assert_msg(!fault, "%s", fault);
}

START_TEST(every_room_stays_valid)
{
    for (int k = 0; k < ALL; k++) {
        brink_run run;
        make_run(&run, scenes[k]);
        for (uint64_t events = 0; events <= 20000; events += 1000) {
            advance(&run, events);
            expect_valid(&run);
        }
        ck_assert_uint_eq(run.tally.refused, 0);
        brink_run_destroy(&run);
    }
}
END_TEST

START_TEST(a_run_is_the_same_in_one_piece_or_in_many)
{
    for (int k = 0; k < ALL; k++) {
        brink_run one, many;
        make_run(&one, scenes[k]);
        make_run(&many, scenes[k]);
        advance(&one, 10000);
        // Odd pieces by events, others by time, and in between a look at every
        // position.
        for (uint64_t events = 17; events < 10000; events += events / 3) {
            double x[3];
            advance(&many, events);
            const brink_instant later =
                brink_instant_after(many.system.year, many.now, 1e-3);
            ck_assert_int_eq(brink_run_advance(&many, 10000, later),
                             BRINK_RUN_REACHED);
            for (uint32_t i = 0; i < many.system.count; i++)
                brink_run_position(&many, i, x);
        }
        advance(&many, 10000);
        ck_assert_msg(same_state(&one, &many), "scene %d", k);
        brink_run_destroy(&one);
        brink_run_destroy(&many);
    }
}
END_TEST

// The distance of a pair and the level this shows; a pair that shows another
// level than its own is as near to a step as events are executed: within
// contact_error_max.
START_TEST(levels_and_positions_differ_by_a_rounding_at_most)
{
    for (int k = 0; k < ALL; k++) {
        brink_run run;
        make_run(&run, scenes[k]);
        advance(&run, 20000);
        const brink_system *s = &run.system;
        brink_system_turn(&run.system, s->epoch + (run.now.epoch > s->epoch));
        for (uint32_t i = 0; i < s->count; i++)
            brink_system_advance(&run.system, i, run.now.offset);
        for (uint32_t i = 0; i < s->count; i++)
            for (uint32_t j = i + 1; j < s->count; j++) {
                const brink_potential *p = brink_system_potential(s, i, j);
                const int level = brink_states_level(&run.states, i, j);
                double r[3];
                brink_system_separation(s, i, j, run.now.offset, r);
                const int seen = brink_step_level_at(p, r);
                if (seen == level)
                    continue;
                const double step = p->distance[seen > level ? level : level - 1];
                const double off =
                    fabs(hypot(hypot(r[0], r[1]), r[2]) / step - 1);
                // The comparison itself rounds three times: hypot twice, and the
                // quotient.
                ck_assert_msg(abs(seen - level) == 1 &&
                                  off <= run.tally.contact_error_max +
                                             3 * DBL_EPSILON,
                              "scene %d, pair %u %u: level %d, seen %d, off %a",
                              k, i, j, level, seen, off);
            }
        brink_run_destroy(&run);
    }
}
END_TEST

static const brink_potential well = {2, (const double[]){2, 1},
                                     (const double[]){-1, (double)INFINITY}};

START_TEST(a_pair_goes_through_the_well_as_the_textbook_says)
{
    // Head-on from 4 with relative speed 2: capture at 2 after time 1; radial
    // speed squared 4 + 2 * 1 / mu = 8; core at 1, and out again at 2 with speed
    // 2.
    brink_run run;
    make_pair(&run, &well, (double[]){4, 0, 0}, (double[]){-2, 0, 0});
    const enum brink_event_kind kinds[] = {BRINK_CAPTURE, BRINK_CORE,
                                           BRINK_RELEASE};
    const double times[] = {1, 1 + 1 / sqrt(8), 1 + 2 / sqrt(8)};
    for (int k = 0; k < 3; k++) {
        advance(&run, (uint64_t)k + 1);
        ck_assert_int_eq(run.last.kind, kinds[k]);
        // Times 1 and 1/sqrt(8) through r and v with some five roundings each.
        ck_assert(fabs(brink_run_time(&run) - times[k]) <= 10 * DBL_EPSILON);
    }
    const double v = run.system.particle[0].v[0] - run.system.particle[1].v[0];
    ck_assert(fabs(v - 2) <= 10 * DBL_EPSILON);
    ck_assert_int_eq(brink_states_level(&run.states, 0, 1), 0);
    brink_run_destroy(&run);
}
END_TEST

START_TEST(who_only_touches_or_is_too_far_has_no_event)
{
    brink_run run;
    make_pair(&run, &well, (double[]){4, 2, 0},
              (double[]){-1, 0, 0}); // an exact tangent
    ck_assert_int_eq(brink_run_advance(&run, 1, (brink_instant){60, 0.0}),
                     BRINK_RUN_REACHED);
    ck_assert_uint_eq(brink_tally_events(&run.tally), 0);
    ck_assert(run.now.epoch == 60);
    brink_run_destroy(&run);
}
END_TEST

START_TEST(a_pair_meets_its_image_round_the_box)
{
    brink_run run;
    make_pair(&run, &well, (double[]){30, 0, 0}, (double[]){-1, 0, 0});
    ck_assert_int_eq(brink_run_advance(&run, 1, BRINK_NEVER), BRINK_RUN_REACHED);
    ck_assert(brink_run_time(&run) == 28);
    brink_run_destroy(&run);
    make_pair(&run, &well, (double[]){30, 0, 0},
              (double[]){1, 0, 0}); // the other way round
    ck_assert_int_eq(brink_run_advance(&run, 1, BRINK_NEVER), BRINK_RUN_REACHED);
    ck_assert(brink_run_time(&run) == 32);
    brink_run_destroy(&run);
}
END_TEST

START_TEST(nothing_that_moves_is_at_rest)
{
    brink_run run;
    make_pair(&run, &well, (double[]){4, 0, 0}, (double[]){0, 0, 0});
    ck_assert_int_eq(brink_run_advance(&run, 1, (brink_instant){60, 0.0}),
                     BRINK_RUN_AT_REST);
    ck_assert(brink_run_time(&run) == 60);
    brink_run_destroy(&run);
}
END_TEST

START_TEST(who_never_meets_does_not_fly_on_unheard)
{
    brink_run run; // side by side, beyond each other's reach
    make_pair(&run, &well, (double[]){4, 4, 0}, (double[]){0, 0, 0});
    for (uint32_t i = 0; i < 2; i++)
        run.system.particle[i].v[0] = 1;
    for (uint32_t i = 0; i < 2; i++)
        brink_predict(&run, i, 0.0);
    ck_assert_int_eq(brink_run_advance(&run, 1, BRINK_NEVER), BRINK_RUN_QUIET);
    ck_assert_uint_gt(run.tally.cell, BRINK_PATIENCE);
    brink_run_destroy(&run);
}
END_TEST

START_TEST(a_run_whose_clock_stands_still_stops_and_names_the_pair)
{
    // As if endless events had gone by at the instant of the eleventh.
    brink_run run, ahead;
    char why[2000];
    make_run(&run, hard_spheres);
    make_run(&ahead, hard_spheres);
    advance(&run, 10);
    advance(&ahead, 11);
    run.last.when = ahead.now;
    run.idle = UINT32_MAX / 2;
    ck_assert_int_eq(brink_run_advance(&run, 20, BRINK_NEVER), BRINK_RUN_STUCK);
    ck_assert_uint_eq(brink_tally_events(&run.tally), 11);
    brink_run_diagnosis(&run, BRINK_RUN_STUCK, why, sizeof why);
    ck_assert_ptr_nonnull(strstr(why, "the clock does not"));
    ck_assert_ptr_nonnull(strstr(why, "r = {"));
    ck_assert_ptr_nonnull(strstr(why, "0x"));
    brink_run_destroy(&run);
    brink_run_destroy(&ahead);
}
END_TEST

START_TEST(an_event_that_contradicts_the_state_is_refused)
{
    brink_run run;
    make_pair(&run, &well, (double[]){1.5, 0, 0}, (double[]){0.5, 0, 0});
    brink_states_set(&run.states, &run.system, 0, 1, 0); // pulled from under it
    ck_assert_int_eq(brink_run_advance(&run, 1, BRINK_NEVER), BRINK_RUN_REFUSED);
    ck_assert_uint_eq(run.tally.refused, 1);
    brink_run_destroy(&run);
}
END_TEST

START_TEST(pressure_is_that_of_the_virial)
{
    // Hard spheres at a packing of 0.3: Z from Carnahan-Starling is 3.97.  This
    // is no test of physics (physics_test.c), only of factors.
    brink_run run;
    make_run(&run, hard_spheres);
    advance(&run, 50000);
    const double z = brink_run_compressibility(&run);
    ck_assert_msg(z > 3.6 && z < 4.4, "Z = %g", z);
    const double n = run.system.count, v = brink_system_volume(&run.system);
    const double p = z * n * brink_system_temperature(&run.system) / v;
    ck_assert(fabs(brink_run_pressure(&run) - p) <= 4 * DBL_EPSILON * p);
    ck_assert(brink_run_mean_free_time(&run) ==
              n * brink_run_time(&run) / 100000);
    brink_run_destroy(&run);
}
END_TEST

int main(void)
{
    return RUN_SUITE("run", 300, every_room_stays_valid,
                     a_run_is_the_same_in_one_piece_or_in_many,
                     levels_and_positions_differ_by_a_rounding_at_most,
                     a_pair_goes_through_the_well_as_the_textbook_says,
                     who_only_touches_or_is_too_far_has_no_event,
                     a_pair_meets_its_image_round_the_box,
                     nothing_that_moves_is_at_rest,
                     who_never_meets_does_not_fly_on_unheard,
                     a_run_whose_clock_stands_still_stops_and_names_the_pair,
                     an_event_that_contradicts_the_state_is_refused,
                     pressure_is_that_of_the_virial);
}
