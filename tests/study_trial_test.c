// SPDX-License-Identifier: MIT
#include "study_trial.h"
#include "suite.h"
#include "systems.h"
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

// A trial in pieces of so many events.
static void try_in_pieces(const char *scene, enum brink_method method,
                          uint64_t events, uint64_t piece, brink_trial *trial)
{
    brink_system start;
    brink_attempt a;
    make_system(&start, scene);
    brink_attempt_create(&a, &start, method, events);
    while (a.trial.outcome == BRINK_OUTCOME_NONE)
        brink_attempt_advance(&a, piece);
    *trial = a.trial;
    brink_attempt_destroy(&a);
}

static void try_method(const char *scene, enum brink_method method,
                       uint64_t events, brink_trial *trial)
{
    try_in_pieces(scene, method, events, 1000, trial);
}

START_TEST(sample_points_increase_and_thin_out_to_twenty_a_decade)
{
    uint64_t n = 0, in_decade = 0;
    for (uint64_t next; n < 10000000; n = next) {
        next = brink_trial_next_sample(n);
        ck_assert_uint_gt(next, n);
        in_decade += next > 1000000 && next <= 10000000;
    }
    ck_assert_uint_ge(in_decade, 19);
    ck_assert_uint_le(in_decade, 21);
    ck_assert_uint_eq(brink_trial_next_sample(0), 1);
    ck_assert_uint_eq(brink_trial_next_sample(1), 2);
}
END_TEST

START_TEST(logical_states_do_their_events_and_are_watched)
{
    brink_trial t;
    try_method(square_well, BRINK_METHOD_LOGICAL, 3000, &t);
    ck_assert_int_eq(t.outcome, BRINK_OUTCOME_DONE);
    ck_assert_uint_eq(t.events, 3000);
    ck_assert_uint_eq(t.doubts.events, 3000);
    ck_assert_uint_eq(t.particles, 256);
    ck_assert_double_eq(t.epsilon, 1);
    ck_assert_double_gt(t.time, 0);
    // One state told wrongly would cost an epsilon of 1.
    ck_assert_double_lt(t.energy_worst * fabs(t.energy_begin), 0.5);
}
END_TEST

// 256 particles: energy is off by 256 before a pair has had 1000 events at once.
START_TEST(every_way_to_fail_is_told)
{
    static const struct {
        enum brink_method method;
        enum brink_outcome outcome;
    } failing[] = {{BRINK_METHOD_POSITION, BRINK_OUTCOME_ENERGY_OFF},
                   {BRINK_METHOD_STORED, BRINK_OUTCOME_ENERGY_OFF},
                   {BRINK_METHOD_PRINTED, BRINK_OUTCOME_STANDS_STILL}};
    for (int k = 0; k < 3; k++) {
        brink_trial t;
        try_method(square_well, failing[k].method, 5000, &t);
        ck_assert_msg(t.outcome == failing[k].outcome,
                      "%s: outcome %d after %" PRIu64 " events",
                      brink_method_rule(failing[k].method)->name, t.outcome,
                      t.events);
        ck_assert_uint_lt(t.events, 5000);
        if (t.outcome == BRINK_OUTCOME_ENERGY_OFF)
            ck_assert_double_gt(fabs(t.energy_end - t.energy_begin), t.particles);
        else
            ck_assert_uint_ge(t.tally.repeated, 1000);
    }
}
END_TEST

START_TEST(samples_lie_at_their_points_and_the_last_is_the_end)
{
    brink_trial t;
    try_method(square_shoulder, BRINK_METHOD_NUDGED_TIME, 500, &t);
    uint64_t events = 0;
    for (int k = 0; k < t.samples; k++) {
        const uint64_t next = brink_trial_next_sample(events);
        events = t.sample[k].events;
        ck_assert_uint_eq(events, next < 500 ? next : 500);
    }
    ck_assert_uint_eq(events, 500);
    ck_assert_double_eq(t.sample[t.samples - 1].energy, t.energy_end);
}
END_TEST

START_TEST(there_is_room_for_the_samples_of_any_trial)
{
    int samples = 0;
    for (uint64_t n = 0; n < UINT64_MAX / 2; samples++)
        n = brink_trial_next_sample(n);
    ck_assert_int_lt(samples + 20, BRINK_SAMPLES); // one more factor of 2: 7
}
END_TEST

// What energy the states have is what a run says it has, but for its rounding.
START_TEST(energy_kept_is_that_of_the_run)
{
    static const char *const scenes[] = {square_well, mixture};
    for (int k = 0; k < 2; k++) {
        brink_run run;
        brink_trial t;
        make_run(&run, scenes[k]);
        const double begin = brink_run_energy(&run);
        advance(&run, 2000);
        try_method(scenes[k], BRINK_METHOD_LOGICAL, 2000, &t);
        const double gain = (brink_run_energy(&run) - begin) / fabs(begin);
        // Three roundings: of either energy, and of their quotient.
        ck_assert_double_eq_tol(t.sample[t.samples - 1].kept, gain, 3 * 0x1p-52);
        ck_assert_double_ne(t.sample[t.samples - 1].kept, 0);
        brink_run_destroy(&run);
    }
}
END_TEST

START_TEST(in_whatever_pieces_the_samples_are_the_same)
{
    for (int k = 0; k < BRINK_METHODS; k++) {
        brink_trial a, b;
        try_in_pieces(square_well, (enum brink_method)k, 1500, 1000, &a);
        try_in_pieces(square_well, (enum brink_method)k, 1500, 7, &b);
        ck_assert_int_eq(a.outcome, b.outcome);
        ck_assert_int_eq(a.samples, b.samples);
        ck_assert_mem_eq(a.sample, b.sample, sizeof a.sample);
        ck_assert_mem_eq(&a.doubts, &b.doubts, sizeof a.doubts);
    }
}
END_TEST

START_TEST(hard_spheres_have_no_epsilon_to_be_off_by)
{
    brink_trial t;
    try_method(hard_spheres, BRINK_METHOD_POSITION, 500, &t);
    ck_assert_int_eq(t.outcome, BRINK_OUTCOME_DONE);
    ck_assert_double_eq(t.epsilon, (double)INFINITY);
}
END_TEST

START_TEST(where_nothing_moves_nothing_happens)
{
    brink_system start;
    brink_attempt a;
    make_system(&start, hard_spheres);
    for (uint32_t i = 0; i < start.count; i++)
        memset(start.particle[i].v, 0, sizeof start.particle[i].v);
    brink_attempt_create(&a, &start, BRINK_METHOD_STORED, 100);
    brink_attempt_advance(&a, 1000);
    ck_assert_int_eq(a.trial.outcome, BRINK_OUTCOME_AT_REST);
    ck_assert_uint_eq(a.trial.events, 0);
    ck_assert_double_eq(a.trial.energy_error, 0);
    brink_attempt_destroy(&a);
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "trial", 300, sample_points_increase_and_thin_out_to_twenty_a_decade,
        logical_states_do_their_events_and_are_watched, every_way_to_fail_is_told,
        samples_lie_at_their_points_and_the_last_is_the_end,
        there_is_room_for_the_samples_of_any_trial,
        energy_kept_is_that_of_the_run,
        in_whatever_pieces_the_samples_are_the_same,
        hard_spheres_have_no_epsilon_to_be_off_by,
        where_nothing_moves_nothing_happens);
}
