// SPDX-License-Identifier: MIT
#include "study_findings.h"
#include "suite.h"
#include <stdlib.h>
#include <string.h>

#define NARROW "\u202f"

// A case of which every method has done its 5000 events without an error.
static brink_case perfect(void)
{
    brink_case c = {.path = "a.yaml", .name = "a", .events = 5000};
    for (int k = 0; k < BRINK_METHODS; k++)
        c.trial[k] = (brink_trial){.method = (enum brink_method)k,
                                   .outcome = BRINK_OUTCOME_DONE,
                                   .events = 5000};
    return c;
}

static void ends(brink_case *c, enum brink_method method,
                 enum brink_outcome outcome, uint64_t events)
{
    c->trial[method].outcome = outcome;
    c->trial[method].events = events;
}

static void says(const brink_case *c, const char *expected)
{
    char *text = brink_findings_sentences(c);
    ck_assert_str_eq(text, expected);
    free(text);
}

START_TEST(all_came_through)
{
    const brink_case c = perfect();
    says(&c,
         "With logical states the run did all 5" NARROW
         "000 events, and at every sample point its energy was exactly what it "
         "was "
         "at the start. From the same start so did state from position, stored "
         "separation, nudged time, nudged position and algorithm 2 as printed.");
}
END_TEST

START_TEST(some_failed)
{
    brink_case c = perfect();
    c.trial[BRINK_METHOD_LOGICAL].energy_worst = 2.2e-16;
    ends(&c, BRINK_METHOD_POSITION, BRINK_OUTCOME_STANDS_STILL, 1003);
    ends(&c, BRINK_METHOD_STORED, BRINK_OUTCOME_ENERGY_OFF, 900);
    ends(&c, BRINK_METHOD_PRINTED, BRINK_OUTCOME_NONE, 0);
    says(&c, "With logical states the run did all 5" NARROW
             "000 events, and at every sample point its energy was within "
             "2.2\u00a0×\u00a010⁻¹⁶ of "
             "what it was at the start. From the same start 3 of the 5 other "
             "ways failed: "
             "state from position (stood still after 1" NARROW
             "003 events), stored separation (had a false energy after 900 "
             "events) and "
             "algorithm 2 as printed (crashed); while nudged time and nudged "
             "position came "
             "through.");
}
END_TEST

START_TEST(one_failed)
{
    brink_case c = perfect();
    ends(&c, BRINK_METHOD_PRINTED, BRINK_OUTCOME_STANDS_STILL, 7);
    says(&c,
         "With logical states the run did all 5" NARROW
         "000 events, and at every sample point its energy was exactly what it "
         "was "
         "at the start. From the same start 1 of the 5 other ways failed: "
         "algorithm "
         "2 as printed (stood still after 7 events); while state from position, "
         "stored separation, nudged time and nudged position came through.");
}
END_TEST

START_TEST(who_came_through_at_a_price_says_so)
{
    brink_case c = perfect();
    brink_trial *t = &c.trial[BRINK_METHOD_NUDGED_PLACE];
    t->epsilon = 0.5;
    t->energy_begin = 48000;
    t->energy_end = 47999 + 0x1p-40;
    char *text = brink_findings_sentences(&c);
    ck_assert_ptr_nonnull(
        strstr(text, "nudged time, nudged position (its energy off by 2 |ε|) and "
                     "algorithm 2"));
    ck_assert_ptr_null(strstr(text, "nudged time (")); // no step, no price
    free(text);
}
END_TEST

START_TEST(all_others_failed)
{
    brink_case c = perfect();
    for (int k = BRINK_METHOD_LOGICAL + 1; k < BRINK_METHODS; k++)
        ends(&c, (enum brink_method)k, BRINK_OUTCOME_STANDS_STILL, 9);
    char *text = brink_findings_sentences(&c);
    ck_assert_ptr_nonnull(strstr(text, "5 of the 5 other ways failed"));
    ck_assert_ptr_null(strstr(text, "came through"));
    ck_assert_int_eq(text[strlen(text) - 1], '.');
    free(text);
}
END_TEST

START_TEST(logical_states_that_failed_are_told_as_well)
{
    brink_case c = perfect();
    ends(&c, BRINK_METHOD_LOGICAL, BRINK_OUTCOME_REFUSED, 12);
    char *text = brink_findings_sentences(&c);
    ck_assert_ptr_nonnull(strstr(
        text, "With logical states the run was refused an event after 12"));
    free(text);
}
END_TEST

START_TEST(every_outcome_has_its_words)
{
    for (int k = BRINK_OUTCOME_NONE; k <= BRINK_OUTCOME_NO_MEMORY; k++) {
        const brink_trial t = {.outcome = (enum brink_outcome)k,
                               .events = UINT64_MAX};
        const brink_words words = brink_findings_outcome(&t);
        ck_assert_uint_gt(strlen(words.text), 0);
        for (int other = 0; other < k; other++) {
            const brink_trial u = {.outcome = (enum brink_outcome)other,
                                   .events = UINT64_MAX};
            ck_assert_str_ne(words.text, brink_findings_outcome(&u).text);
        }
    }
}
END_TEST

START_TEST(files_are_named_after_scene_and_method)
{
    const brink_case c = perfect();
    char name[100];
    brink_findings_file(&c, BRINK_METHOD_PRINTED, ".dat", name, sizeof name);
    ck_assert_str_eq(name, "a-algorithm-2-as-printed.dat");
}
END_TEST

int main(void)
{
    return RUN_SUITE("findings", 60, all_came_through, some_failed, one_failed,
                     who_came_through_at_a_price_says_so, all_others_failed,
                     logical_states_that_failed_are_told_as_well,
                     every_outcome_has_its_words,
                     files_are_named_after_scene_and_method);
}
