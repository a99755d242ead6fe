// SPDX-License-Identifier: MIT
/*
 * No allocation may be taken for granted: each one, by turns, is refused, and
 * whatever was being done says so and leaves nothing behind (under sanitizers a
 * leak, or a write to what there is not, ends the test).
 */
#include "explain.h"
#include "folder.h"
#include "observe_record.h"
#include "rationed.h"
#include "scene.h"
#include "session.h"
#include "snapshot.h"
#include "start.h"
#include "suite.h"
#include "systems.h"
#include <fcntl.h>
#include <unistd.h>

// --- What is attempted ---------------------------------------------------------

static FILE *nowhere; // for complaints
static const char *text;

static int attempt_scene(void)
{
    brink_scene scene;
    const int errors =
        brink_scene_parse(text, strlen(text), "scene", "", &scene, nowhere);
    brink_scene_destroy(&scene);
    return errors != 0;
}

static brink_scene scene; // read beforehand

static int attempt_start(void)
{
    brink_system system;
    if (brink_start_make(&scene, "scene", &system, nowhere))
        return 1;
    brink_system_destroy(&system);
    return 0;
}

static int begin(brink_run *run)
{
    brink_system system;
    if (brink_start_make(&scene, "scene", &system, nowhere))
        return 1;
    if (brink_run_create(run, &system, BRINK_TIER_PLAIN)) {
        brink_system_destroy(&system);
        return 1;
    }
    return 0;
}

static int attempt_begin(void)
{
    brink_run run;
    if (begin(&run))
        return 1;
    brink_run_destroy(&run);
    return 0;
}

static int attempt_run(void)
{
    brink_run run;
    if (begin(&run))
        return 1;
    const enum brink_run_status status =
        brink_run_advance(&run, 300, BRINK_NEVER);
    brink_run_destroy(&run);
    return status == BRINK_RUN_NO_MEMORY;
}

static brink_run original; // of which snapshots are made
static FILE *snapshot;

static int attempt_load(void)
{
    brink_run run;
    brink_plan plan;
    rewind(snapshot);
    if (brink_snapshot_read(snapshot, &run, &plan))
        return 1;
    brink_run_destroy(&run);
    brink_plan_destroy(&plan);
    return 0;
}

static int attempt_record(void)
{
    const brink_wish wish = {.every = 0.1,
                             .distance_most = 1,
                             .distance_bins = 10,
                             .lags = 3,
                             .speeds = 1};
    brink_record record;
    if (brink_record_create(&record, &wish, &original))
        return 1;
    brink_record_destroy(&record);
    return 0;
}

static char path[100];

static int attempt_explanation(void)
{
    const brink_explain_orders orders = {.event = 5, .tier = BRINK_TIER_PLAIN};
    return brink_explain(nowhere, path, &orders) != BRINK_EXIT_DONE;
}

/** Refuses the first allocation, the second, ... until one that never comes: each
 * time the attempt fails, and without it succeeds.  How many there are. */
static int refuse_each(int attempt(void), const char *what)
{
    for (int n = 0;; n++) {
        int refused;
        const int failed = with_ration(attempt, n, &refused);
        ck_assert_msg(failed == refused, "%s: allocation %d was %s, and it %s",
                      what, n, refused ? "refused" : "there",
                      failed ? "failed" : "went well");
        if (!refused)
            return n;
    }
}

/** Refuses every seventh, where there are many.  A list that becomes shorter may
 * keep the memory it has; so not all are missed.  How many are. */
static int refuse_some(int attempt(void), const char *what)
{
    int missed = 0;
    for (int n = 0;; n += 7) {
        int refused;
        const int failed = with_ration(attempt, n, &refused);
        ck_assert_msg(refused || !failed, "%s: failed, with all %d allocations",
                      what, n);
        if (!refused)
            return missed;
        missed += failed;
    }
}

static void read_scene(const char *of)
{
    brink_scene_destroy(&scene); // the one before, or nothing
    text = of;
    ck_assert_int_eq(
        brink_scene_parse(text, strlen(text), "scene", "", &scene, stderr), 0);
}

// Few particles: every one may have a list of its own.
static const char few_crowded[] =
    "box: {size: [12, 12, 12]}\n"
    "species: {A: {count: 60, mass: 1}, B: {count: 12, mass: 3}}\n"
    "start: {random: true}\n"
    "potentials:\n"
    "  - {between: [A, A], steps: [[1.5, -1], [1, .inf]]}\n"
    "  - {between: [B, B], steps: [[1.8, -0.5], [1.2, .inf]]}\n";
static const char few_in_rows[] = "title: in rows\n"
                                  "box: {number_density: 0.4}\n"
                                  "species: {A: {count: 32, diameter: 1}}\n"
                                  "observe: {every: 1, speeds: true}\n";

START_TEST(a_scene_without_memory_is_an_error)
{
    read_scene(few_crowded);
    ck_assert_int_gt(refuse_each(attempt_scene, "mixture"), 10);
    read_scene(few_in_rows);
    ck_assert_int_gt(refuse_each(attempt_scene, "spheres"), 10);
    brink_scene_destroy(&scene);
}
END_TEST

START_TEST(a_start_without_memory_is_an_error)
{
    read_scene(few_crowded);
    ck_assert_int_gt(refuse_each(attempt_start, "at random"), 3);
    read_scene(few_in_rows);
    ck_assert_int_gt(refuse_each(attempt_start, "on a lattice"), 3);
    brink_scene_destroy(&scene);
}
END_TEST

START_TEST(a_run_is_not_begun_without_memory)
{
    read_scene(few_crowded); // inside each other's wells: levels are found
    ck_assert_int_gt(refuse_each(attempt_begin, "a well"), 20);
    brink_scene_destroy(&scene);
}
END_TEST

START_TEST(a_run_without_memory_stops)
{
    read_scene(few_in_rows);
    ck_assert_int_gt(refuse_each(attempt_run, "cells"), 10);
    read_scene(few_crowded);
    ck_assert_int_gt(refuse_some(attempt_run, "a well"), 10);
    read_scene(crowded_spheres);
    ck_assert_int_gt(refuse_some(attempt_run, "lists"), 10);
    brink_scene_destroy(&scene);
}
END_TEST

START_TEST(a_snapshot_without_memory_is_refused)
{
    const brink_plan plan = {
        .events = 10, .scene = (char[]){"x"}, .scene_size = 1};
    make_run(&original, few_crowded);
    brink_run_advance(&original, 100, BRINK_NEVER);
    snapshot = tmpfile();
    ck_assert_ptr_null(brink_snapshot_write(snapshot, &original, &plan));
    ck_assert_int_gt(refuse_each(attempt_load, "snapshot"), 10);
    fclose(snapshot);
    brink_run_destroy(&original);
}
END_TEST

START_TEST(observations_without_memory_are_an_error)
{
    make_run(&original, few_crowded);
    ck_assert_int_gt(refuse_each(attempt_record, "record"), 3);
    brink_run_destroy(&original);
}
END_TEST

START_TEST(an_explanation_without_memory_is_an_error)
{
    const char *folder = new_quick_folder();
    const int before = dup(STDERR_FILENO), to = open("/dev/null", O_WRONLY);
    write_file(folder, "scene.yaml", few_in_rows);
    snprintf(path, sizeof path, "%s/scene.yaml", folder);
    dup2(to, STDERR_FILENO);
    const int count = refuse_each(attempt_explanation, "explanation");
    dup2(before, STDERR_FILENO);
    ck_assert_int_gt(count, 20);
}
END_TEST

int main(void)
{
    nowhere = fopen("/dev/null", "w");
    return RUN_SUITE(
        "memory", 300, a_scene_without_memory_is_an_error,
        a_start_without_memory_is_an_error, a_run_is_not_begun_without_memory,
        a_run_without_memory_stops, a_snapshot_without_memory_is_refused,
        observations_without_memory_are_an_error,
        an_explanation_without_memory_is_an_error);
}
