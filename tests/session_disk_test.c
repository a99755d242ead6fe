// SPDX-License-Identifier: MIT
/*
 * A folder that cannot be written to, in all the ways it may happen to a run: it
 * stops with what, where and what to do; what was saved is whole, and when things
 * are put right it goes on to the same bits as a run that nothing happened to.
 */
#include "checkpoint.h"
#include "sessions.h"
#include "suite.h"
#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <time.h>

static const char scene[] = "seed: 19\n"
                            "box: {size: [4.5, 5, 16]}\n"
                            "species: {A: {count: 30}}\n"
                            "start: {random: true}\n"
                            "potentials:\n"
                            "  - {between: [A, A], steps: [[2, -1], [1, .inf]]}\n"
                            "run: {time: 30}\n"
                            "output: {trajectory: 1, checkpoint: 1.0e-9}\n";

static const char *folder;
static char path[100], whole[100], dir[100];

static pid_t begin(const char *scene_path, const char *out, double max_wall)
{
    const pid_t child = fork();
    ck_assert_int_ge(child, 0);
    if (child == 0)
        play(folder, scene_path, out, max_wall);
    return child;
}

static void prepare(void)
{
    folder = new_quick_folder();
    write_file(folder, "scene.yaml", scene);
    snprintf(path, sizeof path, "%s/scene.yaml", folder);
    snprintf(whole, sizeof whole, "%s/whole", folder);
    snprintf(dir, sizeof dir, "%s/dir", folder);
    ck_assert_int_eq(exit_of(begin(path, whole, (double)INFINITY)), 0);
    // and a run stopped half way, of which there is a checkpoint
    ck_assert_int_eq(exit_of(begin(path, dir, 1e-3)), BRINK_EXIT_STOPPED);
}

static void expect_said(const char *words)
{
    char *said = whole_file(folder, "said");
    ck_assert_msg(strstr(said, words), "'%s' was not said, but: %s", words, said);
    free(said);
}

static void expect_goes_on(const char *what)
{
    ck_assert_msg(brink_checkpoint_count(dir) >= 1, "%s: no checkpoint", what);
    ck_assert_int_eq(exit_of(begin(NULL, dir, (double)INFINITY)), 0);
    expect_same_end(whole, dir, what);
}

// Files may not be longer than this, as where a quota ends.
static pid_t begin_within(rlim_t bytes)
{
    const pid_t child = fork();
    ck_assert_int_ge(child, 0);
    if (child == 0) {
        setrlimit(RLIMIT_FSIZE, &(struct rlimit){bytes, bytes});
        play(folder, NULL, dir, (double)INFINITY);
    }
    return child;
}

START_TEST(files_that_may_not_grow_stop_it_with_a_reason)
{
    prepare();
    ck_assert_int_eq(exit_of(begin_within(2000)), BRINK_EXIT_USAGE);
    expect_said("it cannot be written: File too large\n  make room there, then "
                "`brink resume ");
    expect_goes_on("no trajectory");
}
END_TEST

START_TEST(a_checkpoint_that_may_not_grow_stops_it_with_a_reason)
{
    static const char *const name = "scene-without-trajectory.yaml";
    char quiet[sizeof scene], other[100];
    strcpy(quiet, scene);
    strcpy(strstr(quiet, "trajectory: 1, "), "checkpoint: 1.0e-9}\n");
    prepare();
    write_file(folder, name, quiet);
    snprintf(path, sizeof path, "%s/%s", folder, name);
    snprintf(other, sizeof other, "%s/other", folder);
    snprintf(dir, sizeof dir, "%s/quiet", folder);
    ck_assert_int_eq(exit_of(begin(path, other, (double)INFINITY)), 0);
    ck_assert_int_eq(exit_of(begin(path, dir, 1e-3)), BRINK_EXIT_STOPPED);
    ck_assert_int_eq(exit_of(begin_within(2000)), BRINK_EXIT_USAGE);
    expect_said("the checkpoint could not be written: File too large\n"
                "  earlier ones are untouched: make room there and ");
    ck_assert_int_eq(exit_of(begin(NULL, dir, (double)INFINITY)), 0);
    char *one = whole_file(other, "final.xyz"),
         *two = whole_file(dir, "final.xyz");
    ck_assert_str_eq(one, two);
    free(one);
    free(two);
}
END_TEST

// A disk of 512 KiB, the real thing, where the test may mount one.
START_TEST(a_full_disk_stops_it_with_a_reason)
{
    char disk[80], filler[100];
    prepare();
    snprintf(disk, sizeof disk, "%s/disk", folder);
    snprintf(filler, sizeof filler, "%s/filler", disk);
    ck_assert_int_eq(mkdir(disk, 0777), 0);
    if (mount("tmpfs", disk, "tmpfs", 0, "size=512k")) {
        printf("no disk could be mounted: not tested\n");
        return;
    }
    snprintf(dir, sizeof dir, "%s/run", disk);
    const int first = exit_of(begin(path, dir, 1e-3));
    FILE *file = fopen(filler, "w"); // whatever is left of the disk
    while (file && fputc('x', file) != EOF && fflush(file) == 0) {
    }
    if (file)
        fclose(file);
    const int full = exit_of(begin(NULL, dir, (double)INFINITY));
    char *said = whole_file(folder, "said");
    const int kept = brink_checkpoint_count(dir);
    unlink(filler);
    const int freed = exit_of(begin(NULL, dir, (double)INFINITY));
    char *one = whole_file(whole, "final.xyz"),
         *two = freed == 0 ? whole_file(dir, "final.xyz") : strdup("nothing");
    umount(disk);
    ck_assert_int_eq(first, BRINK_EXIT_STOPPED);
    ck_assert_int_eq(full, BRINK_EXIT_USAGE);
    ck_assert_msg(strstr(said, "No space left on device") &&
                      strstr(said, "make room there"),
                  "said: %s", said);
    ck_assert_int_ge(kept, 1);
    ck_assert_int_eq(freed, 0);
    ck_assert_str_eq(one, two);
    free(one);
    free(two);
    free(said);
}
END_TEST

// As a user whom permissions bind.
static int resume_as_nobody(void)
{
    const pid_t child = fork();
    ck_assert_int_ge(child, 0);
    if (child == 0) {
        if (geteuid() == 0 && setuid(65534))
            _exit(99);
        play(folder, NULL, dir, (double)INFINITY);
    }
    return exit_of(child);
}

START_TEST(a_folder_that_is_read_only_is_said_to_be)
{
    prepare();
    char *said = NULL;
    ck_assert_int_eq(chmod(folder, 0777), 0);
    unlink(in_folder(folder, "said"));
    ck_assert_int_eq(chmod(dir, 0555), 0);
    ck_assert_int_eq(resume_as_nobody(), BRINK_EXIT_USAGE);
    said = whole_file(folder, "said");
    ck_assert_msg(strstr(said, "it cannot be written: Permission denied\n"
                               "  make the folder writable, then `brink resume "),
                  "said: %s", said);
    free(said);
    ck_assert_int_eq(chmod(dir, 0777), 0);
    unlink(in_folder(folder, "said"));
    expect_goes_on("read-only");
}
END_TEST

// Moved away while the run is under way, and put back.
START_TEST(a_folder_that_vanishes_is_missed)
{
    char away[110];
    prepare();
    snprintf(away, sizeof away, "%s-away", dir);
    unlink(in_folder(folder, "said"));
    const pid_t child = begin(NULL, dir, (double)INFINITY);
    char *said = NULL;
    for (int k = 0; k < 10000; k++) { // until it has begun
        said = access(in_folder(folder, "said"), F_OK) == 0
                   ? whole_file(folder, "said")
                   : strdup("");
        if (strstr(said, "going on"))
            break;
        free(said);
        nanosleep(&(struct timespec){0, 100000}, NULL);
    }
    kill(child, SIGSTOP);
    const int moved = rename(dir, away);
    kill(child, SIGCONT);
    const int code = exit_of(child);
    free(said);
    ck_assert_int_eq(moved, 0);
    ck_assert_int_eq(code, BRINK_EXIT_USAGE);
    expect_said("written: No such file or directory\n");
    expect_said("the folder is gone: put it back");
    ck_assert_int_eq(rename(away, dir), 0);
    expect_goes_on("moved away");
}
END_TEST

START_TEST(a_trajectory_that_was_cut_is_not_filled_with_nothing)
{
    prepare();
    const char *film = in_folder(dir, "trajectory.xyz");
    char *kept = whole_file(dir, "trajectory.xyz");
    ck_assert_int_eq(truncate(film, 100), 0);
    ck_assert_int_eq(exit_of(begin(NULL, dir, (double)INFINITY)),
                     BRINK_EXIT_USAGE);
    expect_said("trajectory.xyz: it is shorter than when the checkpoint");
    write_file(dir, "trajectory.xyz", kept);
    free(kept);
    expect_goes_on("put back");
}
END_TEST

static void stop_by(int number)
{
    prepare();
    remove_all(dir);
    const pid_t child = begin(path, dir, (double)INFINITY);
    for (int k = 0; k < 100000 && brink_checkpoint_count(dir) < 2; k++)
        nanosleep(&(struct timespec){0, 20000}, NULL);
    kill(child, number);
    const int code = exit_of(child);
    ck_assert_int_eq(code, BRINK_EXIT_STOPPED);
    expect_said("stopped early (signal); `brink resume");
    char *summary = whole_file(dir, "summary.json");
    ck_assert_ptr_nonnull(strstr(summary, "\"stopped\": \"signal\""));
    free(summary);
    expect_goes_on("stopped");
}

START_TEST(sigterm_and_sigint_lose_nothing)
{
    stop_by(SIGTERM);
    remove_the_folder();
    stop_by(SIGINT);
}
END_TEST

int main(void)
{
    return RUN_SUITE("session, disk", 300,
                     files_that_may_not_grow_stop_it_with_a_reason,
                     a_checkpoint_that_may_not_grow_stops_it_with_a_reason,
                     a_full_disk_stops_it_with_a_reason,
                     a_folder_that_is_read_only_is_said_to_be,
                     a_folder_that_vanishes_is_missed,
                     a_trajectory_that_was_cut_is_not_filled_with_nothing,
                     sigterm_and_sigint_lose_nothing);
}
