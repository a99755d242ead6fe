// SPDX-License-Identifier: MIT
/*
 * A run that is killed at any moment loses nothing: it resumes, and ends with the
 * bits of one that was left alone.  SIGKILL ends it as a power cut
 * would, but for what the kernel still writes.
 */
#include "checkpoint.h"
#include "random.h"
#include "sessions.h"
#include "suite.h"
#include "wall.h"
#include <inttypes.h>
#include <signal.h>
#include <time.h>

// A run takes some hundredths of a second, with a checkpoint every few
// thousandths and several frames of the trajectory between two.
static const char scene[] =
    "seed: 18\n"
    "box: {size: [4.5, 5, 16]}\n"
    "species: {A: {count: 30}}\n"
    "start: {random: true}\n"
    "potentials:\n"
    "  - {between: [A, A], steps: [[2, -1], [1, .inf]]}\n"
    "run: {time: 30}\n"
    "observe: {every: 0.7}\n" // averages alone: no time is spent on plots
    "output: {trajectory: 0.5, checkpoint: 0.003}\n";

static const char *folder;
static char path[100], whole[100]; // the scene; the run that is left alone

// The exit code of a session, or -1 where it was killed.  It is given so many
// seconds.
static int session_for(double seconds, const char *scene_path, const char *dir)
{
    const pid_t child = fork();
    ck_assert_int_ge(child, 0);
    if (child == 0)
        play(folder, scene_path, dir, (double)INFINITY);
    if (isfinite(seconds)) {
        nanosleep(&(struct timespec){(time_t)seconds,
                                     (long)(1e9 * (seconds - floor(seconds)))},
                  NULL);
        kill(child, SIGKILL);
    }
    return exit_of(child);
}

static int whole_session(const char *scene_path, const char *dir)
{
    return session_for((double)INFINITY, scene_path, dir);
}

// The run that is left alone; the seconds it takes.
static double run_whole(void)
{
    folder = new_quick_folder();
    write_file(folder, "scene.yaml", scene);
    snprintf(path, sizeof path, "%s/scene.yaml", folder);
    snprintf(whole, sizeof whole, "%s/whole", folder);
    const double begin = brink_wall_clock();
    ck_assert_int_eq(whole_session(path, whole), BRINK_EXIT_DONE);
    return brink_wall_clock() - begin;
}

START_TEST(killed_at_random_moments_a_run_ends_with_the_same_bits)
{
    const uint64_t seed = (uint64_t)time(NULL), wanted = suite_share(200);
    const double length = run_whole();
    char dir[100], what[200];
    stream s = stream_of_seed(seed);
    uint64_t resumed = 0, early = 0, late = 0;
    for (uint64_t n = 0; resumed < wanted; n++) {
        const double moment = stream_real(&s, 0, length);
        snprintf(dir, sizeof dir, "%s/%" PRIu64, folder, n);
        snprintf(what, sizeof what, "seed %" PRIu64 ", kill %" PRIu64 " at %a s",
                 seed, n, moment);
        const int code = session_for(moment, path, dir);
        ck_assert_msg(code <= 0, "%s: exit %d", what, code);
        late += code == 0;
        // Before its first checkpoint a run has nothing to lose: begun again.
        const int fresh = brink_checkpoint_count(dir) == 0;
        const int rest = whole_session(fresh ? path : NULL, dir);
        ck_assert_msg(rest == 0, "%s: then exit %d", what, rest);
        early += (uint64_t)fresh;
        resumed += code < 0 && !fresh;
        expect_same_end(whole, dir, what);
        remove_all(dir);
        ck_assert_msg(n < 20 * wanted + 100, "it was hardly ever hit");
    }
    printf("a run of %.3f s, seed %" PRIu64 ": %" PRIu64
           " times killed and resumed; %" PRIu64
           " before their first checkpoint, "
           "%" PRIu64 " too late\n",
           length, seed, resumed, early, late);
}
END_TEST

// What is resumed is killed as well, until one gets through: each is given a
// little longer, so that one does.
START_TEST(killed_again_and_again_it_gets_there_too)
{
    const uint64_t seed = (uint64_t)time(NULL);
    const double length = run_whole();
    char dir[100];
    snprintf(dir, sizeof dir, "%s/parts", folder);
    stream s = stream_of_seed(seed);
    int code = -1, kills = 0;
    for (; code != 0; kills++) {
        const int fresh = brink_checkpoint_count(dir) == 0;
        code = session_for(stream_real(&s, 0, length * (0.1 + 0.01 * kills)),
                           fresh ? path : NULL, dir);
        ck_assert_msg(code <= 0, "seed %" PRIu64 ", kill %d: exit %d", seed,
                      kills, code);
    }
    ck_assert_int_gt(kills, 3);
    expect_same_end(whole, dir, "in parts");
}
END_TEST

int main(void)
{
    return RUN_SUITE("session, killed", 600,
                     killed_at_random_moments_a_run_ends_with_the_same_bits,
                     killed_again_and_again_it_gets_there_too);
}
