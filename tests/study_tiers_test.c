// SPDX-License-Identifier: MIT
#include "folder.h"
#include "start.h"
#include "study_tiers.h"
#include "suite.h"
#include "systems.h"
#include <float.h>
#include <math.h>

static void try_tiers(brink_tier_trial trial[BRINK_TIERS], const char *text,
                      uint64_t events)
{
    brink_scene scene;
    ck_assert_int_eq(
        brink_scene_parse(text, strlen(text), "scene", "", &scene, stderr), 0);
    ck_assert_int_eq(brink_tiers_try(&scene, "scene", events, trial), 0);
    brink_scene_destroy(&scene);
}

START_TEST(each_tier_is_that_run)
{
    enum { EVENTS = 4321 }; // which neither turns nor looks divide
    brink_tier_trial trial[BRINK_TIERS];
    try_tiers(trial, square_well, EVENTS);
    for (int k = 0; k < BRINK_TIERS; k++) {
        brink_system system;
        brink_run run;
        make_system(&system, square_well);
        ck_assert_int_eq(brink_run_create(&run, &system, (enum brink_tier)k), 0);
        advance(&run, EVENTS);
        ck_assert_int_eq(trial[k].status, BRINK_RUN_REACHED);
        ck_assert_mem_eq(&trial[k].tally, &run.tally, sizeof run.tally);
        const double error = fabs(brink_run_energy(&run) - run.energy_begin);
        ck_assert(trial[k].energy_error == error / fabs(run.energy_begin));
        ck_assert_double_gt(trial[k].seconds, 0);
        // The largest is a root of a rounded sum of squares, the rms is of exact
        // overlaps: 4 roundings.
        ck_assert_double_gt(trial[k].contact_rms, 0);
        ck_assert_double_le(trial[k].contact_rms,
                            trial[k].tally.contact_error_max + 4 * DBL_EPSILON);
        brink_run_destroy(&run);
    }
}
END_TEST

START_TEST(the_tiers_times_differ)
{
    // After some events a particle chaos has made of the last bits other runs.
    brink_tier_trial trial[BRINK_TIERS];
    try_tiers(trial, square_well, 30000);
    ck_assert(trial[0].contact_rms != trial[1].contact_rms);
    ck_assert(trial[1].contact_rms != trial[2].contact_rms);
}
END_TEST

START_TEST(a_tier_that_stops_is_said_to)
{
    // Nobody moves, and there is no event to look at.
    brink_tier_trial trial[BRINK_TIERS] = {0};
    brink_report r;
    const char *folder = new_folder();
    trial[0].seconds = 2;
    trial[1].seconds = 3;
    trial[1].tally.core = 12345;
    trial[1].tally.clamped = 678;
    trial[1].contact_rms = 1.25e-16;
    trial[2].status = BRINK_RUN_STUCK;
    brink_report_open(&r, folder, "tiers");
    brink_tiers_tell(&r, trial);
    ck_assert_int_eq(brink_report_close(&r, stderr), 0);
    char *page = whole_file(folder, "index.html");
    ck_assert_ptr_nonnull(strstr(page, "for 12\u202f345 events"));
    ck_assert_ptr_nonnull(strstr(page, "1.50"));
    ck_assert_ptr_nonnull(strstr(page, ">678<"));
    ck_assert_ptr_nonnull(strstr(page, "cr (stopped)"));
    ck_assert_ptr_null(strstr(page, "fast (stopped)"));
    free(page);
}
END_TEST

START_TEST(a_start_that_cannot_be_made_is_refused)
{
    static const char text[] = "box: {size: [4, 4, 4]}\n"
                               "species: {A: {count: 2, diameter: 1}}\n"
                               "start: {file: no-such-file.xyz}\n";
    brink_scene scene;
    brink_tier_trial trial[BRINK_TIERS];
    ck_assert_int_eq(
        brink_scene_parse(text, strlen(text), "scene", "", &scene, stderr), 0);
    ck_assert_int_eq(brink_tiers_try(&scene, "scene", 1, trial), -1);
    brink_scene_destroy(&scene);
}
END_TEST

int main(void)
{
    return RUN_SUITE("study, tiers", 300, each_tier_is_that_run,
                     the_tiers_times_differ, a_tier_that_stops_is_said_to,
                     a_start_that_cannot_be_made_is_refused);
}
