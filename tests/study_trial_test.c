// SPDX-License-Identifier: MIT
#include "study_trial.h"
#include "suite.h"
#include "systems.h"
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

// The samples of a trial, to be freed.
static char *try_method(const char *scene, enum brink_method method,
                        uint64_t events, brink_trial *trial)
{
    brink_system start;
    char *samples = NULL;
    size_t size;
    make_system(&start, scene);
    FILE *out = open_memstream(&samples, &size);
    brink_trial_run(&start, method, events, out, trial);
    fclose(out);
    return samples;
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
    free(try_method(square_well, BRINK_METHOD_LOGICAL, 3000, &t));
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
        free(try_method(square_well, failing[k].method, 5000, &t));
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

// One line's numbers; the line after it.
static const char *read_sample(const char *line, double number[4])
{
    char *end = NULL;
    for (int k = 0; k < 4; k++) {
        number[k] = strtod(k == 0 ? line : end + 1, &end);
        ck_assert_int_eq(*end, k < 3 ? '\t' : '\n');
    }
    return end + 1;
}

START_TEST(a_sample_is_a_line_of_four_numbers_and_the_last_is_the_end)
{
    brink_trial t;
    char *samples =
        try_method(square_shoulder, BRINK_METHOD_NUDGED_TIME, 500, &t);
    double events = 0, number[4] = {0};
    for (const char *line = samples; *line != '\0';) {
        const double next = (double)brink_trial_next_sample((uint64_t)events);
        line = read_sample(line, number);
        events = number[0];
        ck_assert_double_eq(events, fmin(next, 500));
    }
    ck_assert_double_eq(events, 500);
    ck_assert_double_eq(number[3], t.energy_end); // %.17g: exact
    free(samples);
}
END_TEST

START_TEST(the_same_start_gives_the_same_samples)
{
    for (int k = 0; k < BRINK_METHODS; k++) {
        brink_trial a, b;
        char *first = try_method(square_well, (enum brink_method)k, 1500, &a);
        char *second = try_method(square_well, (enum brink_method)k, 1500, &b);
        ck_assert_str_eq(first, second);
        ck_assert_int_eq(a.outcome, b.outcome);
        free(first);
        free(second);
    }
}
END_TEST

START_TEST(hard_spheres_have_no_epsilon_to_be_off_by)
{
    brink_trial t;
    free(try_method(hard_spheres, BRINK_METHOD_POSITION, 500, &t));
    ck_assert_int_eq(t.outcome, BRINK_OUTCOME_DONE);
    ck_assert_double_eq(t.epsilon, (double)INFINITY);
}
END_TEST

START_TEST(where_nothing_moves_nothing_happens)
{
    brink_system start;
    brink_trial t;
    FILE *out = tmpfile();
    make_system(&start, hard_spheres);
    for (uint32_t i = 0; i < start.count; i++)
        memset(start.particle[i].v, 0, sizeof start.particle[i].v);
    brink_trial_run(&start, BRINK_METHOD_STORED, 100, out, &t);
    ck_assert_int_eq(t.outcome, BRINK_OUTCOME_AT_REST);
    ck_assert_uint_eq(t.events, 0);
    ck_assert_double_eq(t.energy_error, 0);
    fclose(out);
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "trial", 300, sample_points_increase_and_thin_out_to_twenty_a_decade,
        logical_states_do_their_events_and_are_watched, every_way_to_fail_is_told,
        a_sample_is_a_line_of_four_numbers_and_the_last_is_the_end,
        the_same_start_gives_the_same_samples,
        hard_spheres_have_no_epsilon_to_be_off_by,
        where_nothing_moves_nothing_happens);
}
