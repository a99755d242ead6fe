// SPDX-License-Identifier: MIT
#include "observe.h"
#include "suite.h"
#include "systems.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static char *summary_of(const brink_run *run, const char *title)
{
    char *text;
    size_t size;
    const brink_plan plan = {.events = 5000,
                             .until = (double)INFINITY,
                             .seed = 12,
                             .wall_seconds = 0.5};
    FILE *out = open_memstream(&text, &size);
    ck_assert_int_eq(
        brink_observe_summary(out, run, &plan, title, "target reached", NULL), 0);
    fclose(out);
    return text;
}

static double number(const char *summary, const char *key)
{
    char quoted[100];
    snprintf(quoted, sizeof quoted, "\"%s\": ", key);
    const char *at = strstr(summary, quoted);
    ck_assert_msg(at != NULL, "%s is missing", key);
    return strtod(at + strlen(quoted), NULL);
}

START_TEST(the_summary_holds_every_key_and_the_run_s_figures)
{
    brink_run run;
    make_run(&run, square_well);
    advance(&run, 5000);
    char *text = summary_of(&run, "a well");
    static const char *const keys[] = {"wall_seconds",
                                       "energy_initial",
                                       "momentum_drift",
                                       "potential_energy_per_particle",
                                       "pressure",
                                       "compressibility_factor",
                                       "contact_error_max",
                                       "clamped",
                                       "zero_time",
                                       "repeated",
                                       "rim",
                                       "refused",
                                       "wall",
                                       "cell"};
    for (size_t k = 0; k < sizeof keys / sizeof *keys; k++)
        number(text, keys[k]);
    ck_assert(number(text, "particles") == 256);
    ck_assert(number(text, "events") == 5000);
    ck_assert(number(text, "core") == (double)run.tally.core);
    ck_assert(number(text, "capture") == (double)run.tally.capture);
    ck_assert(number(text, "release") == (double)run.tally.release);
    ck_assert(number(text, "bounce") == (double)run.tally.bounce);
    ck_assert(number(text, "time") == brink_run_time(&run));
    ck_assert(number(text, "events_per_second") == 10000);
    ck_assert(number(text, "energy_final") == brink_run_energy(&run));
    ck_assert(number(text, "temperature") ==
              brink_system_temperature(&run.system));
    ck_assert(number(text, "mean_free_time") == brink_run_mean_free_time(&run));
    free(text);
    brink_run_destroy(&run);
}
END_TEST

START_TEST(a_figure_that_does_not_exist_yet_is_null)
{
    brink_run run;
    make_run(&run, square_well);
    char *text = summary_of(&run, "");
    ck_assert_ptr_nonnull(strstr(text, "\"pressure\": null"));
    ck_assert_ptr_null(strstr(text, "nan"));
    ck_assert_ptr_null(strstr(text, "inf"));
    free(text);
    brink_run_destroy(&run);
}
END_TEST

START_TEST(a_title_may_hold_anything)
{
    brink_run run;
    make_run(&run, square_well);
    char *text = summary_of(&run, "a \"well\" \\ and\na line");
    ck_assert_ptr_nonnull(strstr(text, "a \\\"well\\\" \\\\ and\\u000aa line"));
    free(text);
    brink_run_destroy(&run);
}
END_TEST

START_TEST(progress_is_the_part_of_the_target_that_is_done)
{
    brink_run run;
    char line[200];
    brink_plan plan = {.events = 5000, .until = (double)INFINITY};
    make_run(&run, square_well);
    ck_assert(brink_observe_done(&run, &plan) == 0);
    advance(&run, 1250);
    ck_assert(brink_observe_done(&run, &plan) == 0.25);
    brink_observe_progress(line, sizeof line, &run, &plan, 250);
    ck_assert_ptr_nonnull(
        strstr(line, "1250 events, 25.0 %, 250 events/s, 15 s left"));
    plan = (brink_plan){.events = UINT64_MAX, .until = 2 * brink_run_time(&run)};
    ck_assert(brink_observe_done(&run, &plan) == 0.5);
    brink_run_destroy(&run);
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "observe", 60, the_summary_holds_every_key_and_the_run_s_figures,
        a_figure_that_does_not_exist_yet_is_null, a_title_may_hold_anything,
        progress_is_the_part_of_the_target_that_is_done);
}
