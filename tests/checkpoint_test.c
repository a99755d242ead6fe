// SPDX-License-Identifier: MIT
#include "checkpoint.h"
#include "suite.h"
#include "systems.h"
#include <dirent.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

static brink_plan plan = {
    .events = 1000, .scene = (char[]){"s"}, .scene_size = 1};

static void make_folder(char folder[64])
{
    strcpy(folder, "/tmp/brink-checkpoint-XXXXXX");
    ck_assert_ptr_nonnull(mkdtemp(folder));
}

static void remove_folder(const char *folder)
{
    DIR *d = opendir(folder);
    for (struct dirent *e; (e = readdir(d));) {
        char path[400];
        snprintf(path, sizeof path, "%s/%s", folder, e->d_name);
        unlink(path);
    }
    closedir(d);
    rmdir(folder);
}

// What a function tells to a stream.
static char *told;
static size_t told_size;

static FILE *listen(void)
{
    return open_memstream(&told, &told_size);
}

static void expect_told(FILE *stream, const char *part)
{
    fclose(stream);
    ck_assert_msg(strstr(told, part) != NULL, "told: %s", told);
    free(told);
}

static void save_at(brink_run *run, uint64_t events, const char *folder)
{
    advance(run, events);
    ck_assert_int_eq(brink_checkpoint_save(folder, run, &plan, stderr), 0);
}

static void damage(const char *path, long at)
{
    FILE *file = fopen(path, "r+b");
    fseek(file, at, SEEK_SET);
    const int byte = fgetc(file);
    fseek(file, at, SEEK_SET);
    fputc(byte ^ 4, file);
    fclose(file);
}

START_TEST(the_last_two_are_kept_and_the_newest_is_resumed)
{
    char folder[64], path[200];
    brink_run run, loaded;
    brink_plan p;
    make_folder(folder);
    make_run(&run, small_box);
    for (uint64_t events = 0; events <= 400; events += 100)
        save_at(&run, events, folder);
    ck_assert_int_eq(brink_checkpoint_count(folder), 2);
    ck_assert_int_eq(
        brink_checkpoint_resume(folder, &loaded, &p, path, sizeof path, stderr),
        0);
    ck_assert_ptr_nonnull(strstr(path, "checkpoint-00000000000000000400.brink"));
    ck_assert(same_state(&run, &loaded));
    brink_plan_destroy(&p);
    brink_run_destroy(&loaded);
    brink_run_destroy(&run);
    remove_folder(folder);
}
END_TEST

START_TEST(a_damaged_one_is_named_and_the_one_before_taken)
{
    char folder[64], path[200];
    brink_run run, loaded;
    brink_plan p;
    make_folder(folder);
    make_run(&run, small_box);
    save_at(&run, 100, folder);
    save_at(&run, 200, folder);
    snprintf(path, sizeof path, "%s/checkpoint-%020d.brink", folder, 200);
    damage(path, 1000);
    FILE *errors = listen();
    ck_assert_int_eq(
        brink_checkpoint_resume(folder, &loaded, &p, path, sizeof path, errors),
        0);
    expect_told(errors, "00200.brink: this checkpoint is refused: its checksum");
    ck_assert_uint_eq(brink_tally_events(&loaded.tally), 100);
    ck_assert_int_eq(brink_checkpoint_count(folder), 2); // and nothing is removed
    brink_plan_destroy(&p);
    brink_run_destroy(&loaded);
    brink_run_destroy(&run);
    remove_folder(folder);
}
END_TEST

/* Found by fuzz/checkpoint_fuzz.c: with the last two damaged a run went on from
 * the one before them, saved itself, kept what looked like the last two, and
 * removed itself and all that was whole. */
START_TEST(damaged_ones_that_are_newer_make_none_superfluous)
{
    char folder[64], path[200];
    brink_run run, loaded;
    brink_plan p;
    make_folder(folder);
    make_run(&run, small_box);
    save_at(&run, 100, folder);
    for (int events = 300; events <= 400; events += 100) {
        snprintf(path, sizeof path, "%s/checkpoint-%020d.brink", folder, events);
        FILE *file = fopen(path, "wb");
        fclose(file);
    }
    save_at(&run, 200, folder);
    FILE *errors = listen();
    ck_assert_int_eq(
        brink_checkpoint_resume(folder, &loaded, &p, path, sizeof path, errors),
        0);
    expect_told(errors, "00300.brink: this checkpoint is refused");
    ck_assert(same_state(&run, &loaded));
    ck_assert_int_eq(brink_checkpoint_count(folder), 4); // 100 to 400
    brink_plan_destroy(&p);
    brink_run_destroy(&loaded);
    brink_run_destroy(&run);
    remove_folder(folder);
}
END_TEST

/* Found by fuzz/checkpoint_fuzz.c: one by another name was taken for as new as
 * that, and for one from before an event that it is not before. */
START_TEST(one_by_the_name_of_another_is_passed_over)
{
    char folder[64], path[200], other[200];
    brink_run run, loaded;
    brink_plan p;
    make_folder(folder);
    make_run(&run, small_box);
    save_at(&run, 100, folder);
    save_at(&run, 200, folder);
    snprintf(path, sizeof path, "%s/checkpoint-%020d.brink", folder, 200);
    snprintf(other, sizeof other, "%s/checkpoint-%020d.brink", folder, 150);
    ck_assert_int_eq(rename(path, other), 0);
    FILE *errors = listen();
    ck_assert_int_eq(brink_checkpoint_before(folder, 180, &loaded, &p, path,
                                             sizeof path, errors),
                     0);
    expect_told(errors,
                "00150.brink: this checkpoint is refused: its name should "
                "be checkpoint-00000000000000000200.brink");
    ck_assert_uint_eq(brink_tally_events(&loaded.tally), 100);
    brink_plan_destroy(&p);
    brink_run_destroy(&loaded);
    brink_run_destroy(&run);
    remove_folder(folder);
}
END_TEST

START_TEST(every_truncated_one_is_refused)
{
    char folder[64], path[200];
    brink_run run, loaded;
    brink_plan p;
    struct stat info;
    make_folder(folder);
    make_run(&run, small_box);
    save_at(&run, 100, folder);
    snprintf(path, sizeof path, "%s/checkpoint-%020d.brink", folder, 100);
    ck_assert_int_eq(stat(path, &info), 0);
    for (off_t size = info.st_size - 1; size >= 0; size -= 1 + size / 50) {
        FILE *errors = listen();
        ck_assert_int_eq(truncate(path, size), 0);
        ck_assert_int_eq(brink_checkpoint_load(path, &loaded, &p, errors), -1);
        expect_told(errors, "refused");
    }
    brink_run_destroy(&run);
    remove_folder(folder);
}
END_TEST

START_TEST(a_folder_without_any_says_so)
{
    char folder[64], path[200];
    brink_run run;
    brink_plan p;
    make_folder(folder);
    FILE *errors = listen();
    ck_assert_int_eq(
        brink_checkpoint_resume(folder, &run, &p, path, sizeof path, errors), -1);
    expect_told(errors, "holds no checkpoint");
    remove_folder(folder);
    errors = listen();
    ck_assert_int_eq(
        brink_checkpoint_resume(folder, &run, &p, path, sizeof path, errors), -1);
    expect_told(errors, "cannot be read: No such file");
}
END_TEST

// A disk that is full from some byte on, by the limit on a file's size.
START_TEST(where_it_does_not_fit_the_earlier_one_is_untouched)
{
    char folder[64], path[200];
    brink_run run, loaded;
    brink_plan p;
    make_folder(folder);
    make_run(&run, small_box);
    save_at(&run, 100, folder);
    advance(&run, 200);
    signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &(struct rlimit){1000, RLIM_INFINITY});
    FILE *errors = listen();
    ck_assert_int_eq(brink_checkpoint_save(folder, &run, &plan, errors), -1);
    setrlimit(RLIMIT_FSIZE, &(struct rlimit){RLIM_INFINITY, RLIM_INFINITY});
    expect_told(errors, "could not be written: File too large");
    ck_assert_int_eq(brink_checkpoint_count(folder), 1);
    ck_assert_int_eq(
        brink_checkpoint_resume(folder, &loaded, &p, path, sizeof path, stderr),
        0);
    ck_assert_uint_eq(brink_tally_events(&loaded.tally), 100);
    brink_plan_destroy(&p);
    brink_run_destroy(&loaded);
    brink_run_destroy(&run);
    remove_folder(folder);
}
END_TEST

START_TEST(a_folder_that_vanished_is_a_clear_error)
{
    char folder[64];
    brink_run run;
    make_folder(folder);
    make_run(&run, small_box);
    remove_folder(folder);
    FILE *errors = listen();
    ck_assert_int_eq(brink_checkpoint_save(folder, &run, &plan, errors), -1);
    expect_told(errors, "could not be written: No such file or directory");
    brink_run_destroy(&run);
}
END_TEST

int main(void)
{
    return RUN_SUITE("checkpoint", 120,
                     the_last_two_are_kept_and_the_newest_is_resumed,
                     a_damaged_one_is_named_and_the_one_before_taken,
                     damaged_ones_that_are_newer_make_none_superfluous,
                     one_by_the_name_of_another_is_passed_over,
                     every_truncated_one_is_refused, a_folder_without_any_says_so,
                     where_it_does_not_fit_the_earlier_one_is_untouched,
                     a_folder_that_vanished_is_a_clear_error);
}
