// SPDX-License-Identifier: MIT
// The page of what was observed: whole, early, doubtful, and without gnuplot.
#include "folder.h"
#include "observe_figures.h"
#include "session_page.h"
#include "suite.h"
#include "systems.h"

static brink_run run;
static brink_record record;
static const char *folder;

static void observe(const brink_wish *wish, uint64_t samples)
{
    folder = new_folder();
    make_run(&run, mixture);
    ck_assert_int_eq(brink_record_create(&record, wish, &run), 0);
    while (record.samples < samples) {
        brink_run_advance(&run, UINT64_MAX, brink_record_due(&record, &run));
        brink_record_sample(&record, &run);
    }
}

static void done(void)
{
    brink_record_destroy(&record);
    brink_run_destroy(&run);
}

// How many times `part` stands in the page.
static int in_page(const char *part)
{
    char *page = whole_file(folder, "observed.html");
    int count = 0;
    for (const char *at = page; (at = strstr(at, part)); at++)
        count++;
    free(page);
    return count;
}

static int exists(const char *name)
{
    struct stat about;
    return stat(in_folder(folder, name), &about) == 0;
}

START_TEST(all_that_was_asked_for_is_drawn)
{
    const brink_wish wish = {.every = 0.05,
                             .distance_most = 3,
                             .distance_bins = 30,
                             .lags = 4,
                             .speeds = 1};
    observe(&wish, 100);
    ck_assert_int_eq(brink_page_write(folder, "of <two> kinds", &record, &run),
                     0);
    ck_assert_int_eq(in_page("<svg"), 3);
    ck_assert_int_gt(in_page("of &lt;two&gt; kinds"), 0);
    ck_assert_int_eq(in_page("diffusion coefficient of"), 2);
    ck_assert_int_eq(in_page("not yet"), 0);
    ck_assert(exists("distances.dat") && exists("displacements.dat") &&
              exists("speeds.dat"));
    char *table = whole_file(folder, "distances.dat");
    ck_assert_ptr_nonnull(strstr(table, "# distance, g and error of A-A, g and "
                                        "error of A-B, g and error of B-B\n"
                                        "0.05 0 0 0 0 0 0\n"));
    free(table);
    done();
}
END_TEST

START_TEST(averages_alone_need_no_plots)
{
    const brink_wish wish = {.every = 0.05};
    observe(&wish, 20);
    ck_assert_int_eq(brink_page_write(folder, "", &record, &run), 0);
    ck_assert_int_eq(in_page("<svg"), 0);
    ck_assert_int_eq(in_page("What was observed"), 2); // title and heading
    ck_assert(!exists("distances.dat") && !exists("displacements.dat") &&
              !exists("speeds.dat"));
    done();
}
END_TEST

START_TEST(what_is_not_known_yet_is_said_to_be)
{
    const brink_wish wish = {.every = 1e-9, .from = 1, .lags = 4};
    observe(&wish, 0);
    ck_assert_int_eq(brink_page_write(folder, "early", &record, &run), 0);
    ck_assert_int_eq(in_page("not yet"), 2 * 6); // mean and error of six figures
    ck_assert_int_eq(in_page("nan"), 0);
    done();
}
END_TEST

// Samples so far apart that particles get round the box between them.
START_TEST(displacements_round_the_box_are_not_answered_for)
{
    const brink_wish wish = {.every = 10, .lags = 2};
    char *json;
    size_t size;
    observe(&wish, 60);
    ck_assert(!brink_displacements_trusted(&record.displacements));
    ck_assert_int_eq(brink_page_write(folder, "far", &record, &run), 0);
    ck_assert_int_eq(in_page("take a shorter `every`"), 1);
    ck_assert_int_eq(in_page("<svg"), 0);
    FILE *out = open_memstream(&json, &size);
    brink_figures_json(out, &record, &run.system);
    fclose(out);
    ck_assert_ptr_nonnull(strstr(json,
                                 "\"diffusion\": {\"A\": {\"mean\": null, "
                                 "\"error\": null}, \"B\": {\"mean\": null"));
    free(json);
    done();
}
END_TEST

START_TEST(without_gnuplot_there_are_the_tables)
{
    const brink_wish wish = {.every = 0.05, .speeds = 1};
    observe(&wish, 20);
    setenv("PATH", "/nowhere", 1);
    ck_assert_int_eq(brink_page_write(folder, "plain", &record, &run), 0);
    ck_assert(exists("speeds.dat"));
    ck_assert(!exists("observed.html"));
    done();
}
END_TEST

START_TEST(a_table_that_cannot_be_written_is_an_error)
{
    const brink_wish wish = {.every = 0.05, .speeds = 1};
    char nowhere[200];
    observe(&wish, 2);
    snprintf(nowhere, sizeof nowhere, "%s/nowhere", folder);
    ck_assert_int_eq(brink_page_write(nowhere, "", &record, &run), -1);
    done();
}
END_TEST

int main(void)
{
    return RUN_SUITE("session, page", 120, all_that_was_asked_for_is_drawn,
                     averages_alone_need_no_plots,
                     what_is_not_known_yet_is_said_to_be,
                     displacements_round_the_box_are_not_answered_for,
                     without_gnuplot_there_are_the_tables,
                     a_table_that_cannot_be_written_is_an_error);
}
