// SPDX-License-Identifier: MIT
#include "conventional_method.h"
#include "folder.h"
#include "study.h"
#include "suite.h"
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

static const char tiny[] =
    "title: wells <& others>\n"
    "box: {number_density: 0.3}\n"
    "species: {A: {count: 108}}\n"
    "potentials:\n"
    "  - {between: [A, A], steps: [[1.5, -1], [1, .inf]]}\n"
    "run: {events_per_particle: 20}\n";

// Writes the text as a scene of that name and studies it into the same folder.
static int study(const char *folder, const char *name, const char *text)
{
    write_file(folder, name, text);
    const char *const scenes[] = {in_folder(folder, name)};
    return brink_study(folder, 1, scenes);
}

START_TEST(a_tiny_study_leaves_a_page_and_samples_of_every_method)
{
    const char *folder = new_folder();
    ck_assert_int_eq(study(folder, "tiny.yaml", tiny), 0);
    char *page = whole_file(folder, "index.html");
    ck_assert_ptr_nonnull(strstr(page, "wells &lt;&amp; others&gt;"));
    ck_assert_ptr_nonnull(strstr(page, "did all 2\u202f160 events"));
    ck_assert_ptr_nonnull(strstr(page, "<svg"));
    ck_assert_ptr_nonnull(strstr(page, "seed 1"));
    for (int k = 0; k < BRINK_METHODS; k++) {
        const char *name = brink_method_rule((enum brink_method)k)->name;
        char file[200] = "tiny-";
        for (size_t n = 0; n <= strlen(name); n++)
            file[5 + n] = (char)(name[n] == ' ' ? '-' : name[n]);
        strcat(file, ".dat");
        char *samples = whole_file(folder, file);
        ck_assert_ptr_nonnull(strstr(samples, name));
        ck_assert_ptr_nonnull(strstr(samples, "\n1\t"));
        ck_assert_ptr_nonnull(strstr(page, name));
        free(samples);
    }
    free(page);
}
END_TEST

START_TEST(two_scenes_of_one_name_do_not_share_files)
{
    const char *folder = new_folder();
    ck_assert_int_eq(mkdir(in_folder(folder, "sub"), 0777), 0);
    write_file(folder, "tiny.yaml", tiny);
    write_file(folder, "sub/tiny.yaml", tiny);
    char *first = strdup(in_folder(folder, "tiny.yaml"));
    const char *const scenes[] = {first, in_folder(folder, "sub/tiny.yaml")};
    ck_assert_int_eq(brink_study(folder, 2, scenes), 0);
    free(whole_file(folder, "tiny-logical-states.dat"));
    free(first);
    free(whole_file(folder, "tiny-2-logical-states.dat"));
}
END_TEST

START_TEST(a_word_is_a_scene_that_comes_with_the_program)
{
    const char *const scenes[] = {"there-is-no-such-scene"};
    ck_assert_int_eq(access(SCENES "/square-well.yaml", R_OK), 0);
    ck_assert_int_eq(brink_study(new_folder(), 1, scenes), 2);
}
END_TEST

START_TEST(a_bad_scene_is_refused)
{
    const char *folder = new_folder();
    ck_assert_int_eq(study(folder, "bad.yaml", "title: nothing else\n"), 2);
    ck_assert_int_ne(access(in_folder(folder, "index.html"), F_OK), 0);
}
END_TEST

START_TEST(a_scene_that_runs_for_a_time_is_refused)
{
    const char *folder = new_folder();
    char text[sizeof tiny];
    strcpy(text, tiny);
    strcpy(strstr(text, "run:"), "run: {time: 5}\n");
    ck_assert_int_eq(study(folder, "time.yaml", text), 2);
}
END_TEST

START_TEST(a_folder_that_cannot_be_made_is_refused)
{
    const char *folder = new_folder();
    write_file(folder, "tiny.yaml", tiny);
    const char *const scenes[] = {in_folder(folder, "tiny.yaml")};
    ck_assert_int_eq(brink_study("/there/is/no/such", 1, scenes), 2);
}
END_TEST

// A folder where the samples of one trial should go: that one cannot be done, and
// the page says so beside the others.
START_TEST(a_trial_that_cannot_be_done_is_reported_not_swallowed)
{
    const char *folder = new_folder();
    ck_assert_int_eq(mkdir(in_folder(folder, "tiny-nudged-time.dat"), 0777), 0);
    ck_assert_int_eq(study(folder, "tiny.yaml", tiny), 3);
    char *page = whole_file(folder, "index.html");
    ck_assert_ptr_nonnull(strstr(page, "nudged time (crashed)"));
    ck_assert_ptr_nonnull(strstr(page, "did all 2\u202f160 events"));
    free(page);
}
END_TEST

// A second of the processor for each process, and more to do than that: workers
// that would come through are ended by a signal.
START_TEST(a_worker_that_is_killed_is_reported_not_swallowed)
{
    const char *folder = new_folder();
    char text[sizeof tiny + 20];
    strcpy(text, tiny);
    strcpy(strstr(text, "run:"), "run: {events: 1000000000}\n");
    const struct rlimit second = {1, 2};
    ck_assert_int_eq(setrlimit(RLIMIT_CPU, &second), 0);
    ck_assert_int_eq(study(folder, "tiny.yaml", text), 3);
    char *page = whole_file(folder, "index.html");
    ck_assert_ptr_nonnull(strstr(page, "With logical states the run crashed"));
    ck_assert_ptr_nonnull(strstr(page, "nudged position (crashed)"));
    ck_assert_ptr_nonnull(
        strstr(page, "algorithm 2 as printed (stood still after"));
    free(page);
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "study", 300, a_tiny_study_leaves_a_page_and_samples_of_every_method,
        two_scenes_of_one_name_do_not_share_files,
        a_word_is_a_scene_that_comes_with_the_program, a_bad_scene_is_refused,
        a_scene_that_runs_for_a_time_is_refused,
        a_folder_that_cannot_be_made_is_refused,
        a_trial_that_cannot_be_done_is_reported_not_swallowed,
        a_worker_that_is_killed_is_reported_not_swallowed);
}
