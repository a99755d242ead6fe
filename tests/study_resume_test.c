// SPDX-License-Identifier: MIT
/*
 * A study that is stopped or killed at any moment goes on when it is run again,
 * and ends with the files of one that was left alone, but for the seconds.
 */
#include "folder.h"
#include "random.h"
#include "session.h"
#include "study.h"
#include "suite.h"
#include "wall.h"
#include <fcntl.h>
#include <inttypes.h>
#include <signal.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

// Each of the trials that come through takes some tenth of a second, and has
// several checkpoints.
static const char scene[] =
    "title: some wells\n"
    "box: {number_density: 0.05}\n"
    "species: {A: {count: 32}}\n"
    "potentials:\n"
    "  - {between: [A, A], steps: [[1.5, -1], [1, .inf]]}\n"
    "output: {checkpoint: 0.01}\n"
    "run: {events: 8000}\n";

// In a process group of its own: the study of FOLDER/some.yaml into FOLDER; what
// it says is left in FOLDER/said.
static pid_t begin(const char *folder)
{
    static const char *const scenes[] = {"some.yaml"};
    const pid_t child = fork();
    ck_assert_int_ge(child, 0);
    if (child > 0)
        return child;
    signal(SIGTERM, SIG_DFL); // Check's would end the test
    const int out = open("/dev/null", O_WRONLY);
    if (setpgid(0, 0) != 0 || chdir(folder) != 0)
        _exit(99);
    const int err = open("said", O_WRONLY | O_CREAT | O_TRUNC, 0666);
    dup2(out, STDOUT_FILENO);
    dup2(err, STDERR_FILENO);
    _exit(brink_study(".", 1, scenes));
}

static int end(pid_t child)
{
    int status;
    ck_assert_int_eq(waitpid(child, &status, 0), child);
    return WIFSIGNALED(status) ? -1 : WEXITSTATUS(status);
}

static int said(const char *folder, const char *what)
{
    char *text = whole_file(folder, "said");
    const int found = strstr(text, what) != NULL;
    free(text);
    return found;
}

// The last two cells of each row of a table that ends with rates and seconds, the
// one with such a heading.
static void make_timeless(char *page, const char *heading)
{
    char *row = strstr(page, heading);
    ck_assert_ptr_nonnull(row);
    char *const last = strstr(row, "</table>");
    while ((row = strchr(row, '\n')) != NULL && ++row < last) {
        char *stop = strchr(row, '\n');
        for (int cells = 0; stop > row && cells < 2; stop--)
            cells += strncmp(stop, "<td", 3) == 0;
        for (; *stop != '\n'; stop++)
            *stop = ' ';
    }
}

// Word by word, spaces aside; both texts are cut up.
static void expect_same_words(char *one, char *other, const char *name)
{
    static const char spaces[] = " \n";
    char *in_one, *in_other;
    const char *p = strtok_r(one, spaces, &in_one),
               *q = strtok_r(other, spaces, &in_other);
    for (; p != NULL && q != NULL && strcmp(p, q) == 0;
         p = strtok_r(NULL, spaces, &in_one),
         q = strtok_r(NULL, spaces, &in_other)) {
    }
    ck_assert_msg(p == NULL && q == NULL, "%s: \"%s\" is \"%s\" again", name,
                  p != NULL ? p : "nothing", q != NULL ? q : "nothing");
}

// A file of two folders, but for seconds where it is the page.
static void expect_same(const char *a, const char *b, const char *name)
{
    char *one = whole_file(a, name), *other = whole_file(b, name);
    if (strcmp(name, "index.html") == 0) {
        make_timeless(one, ">events/s<");
        make_timeless(other, ">events/s<");
        make_timeless(one, ">to fast<");
        make_timeless(other, ">to fast<");
    }
    expect_same_words(one, other, name);
    free(one);
    free(other);
}

static void expect_same_end(const char *a, const char *b)
{
    static const char *const names[] = {"some-logical-states.dat",
                                        "some-state-from-position.dat",
                                        "some-stored-separation.dat",
                                        "some-nudged-time.dat",
                                        "some-nudged-position.dat",
                                        "some-algorithm-2-as-printed.dat",
                                        "some-energy.svg",
                                        "index.html"};
    for (size_t k = 0; k < sizeof names / sizeof names[0]; k++)
        expect_same(a, b, names[k]);
}

static char *new_study(const char *folder, const char *name)
{
    char *sub = strdup(in_folder(folder, name));
    ck_assert_int_eq(mkdir(sub, 0777), 0);
    write_file(sub, "some.yaml", scene);
    return sub;
}

static void wait_for(double seconds)
{
    const struct timespec t = {(time_t)seconds, (long)(fmod(seconds, 1) * 1e9)};
    nanosleep(&t, NULL);
}

// Three ways to end it: it is told to, and says that it can go on; with all its
// workers at once; or the process alone that started them, which they notice.
static void interrupt(pid_t child, int way)
{
    kill(way == 1 ? -child : child, way == 0 ? SIGTERM : SIGKILL);
}

START_TEST(stopped_and_killed_it_ends_as_if_left_alone)
{
    const char *folder = new_folder();
    char *whole = new_study(folder, "whole"), *parts = new_study(folder, "parts");
    const uint64_t seed = (uint64_t)time(NULL);
    stream random = stream_of_seed(seed);
    const double begun = brink_wall_clock();
    ck_assert_int_eq(end(begin(whole)), 0);
    const double took = brink_wall_clock() - begun;
    int pieces = 0, code = 1, went_on = 0;
    for (; code != 0; pieces++) {
        // Parts of what the whole takes on this machine, busy as it is.  The more
        // there were the longer they are: it comes to an end.
        const double patience =
            stream_real(&random, 0, took * (0.05 + 0.1 * pieces));
        const pid_t child = begin(parts);
        wait_for(patience);
        interrupt(child, pieces % 3);
        code = end(child);
        // -1: told to before it could listen, or killed.
        ck_assert_msg(code == 0 || code == -1 || (code == 75 && pieces % 3 == 0),
                      "seed %" PRIu64 ", piece %d: exit %d", seed, pieces, code);
        went_on += said(parts, "goes on from");
    }
    ck_assert_msg(went_on > 0, "seed %" PRIu64 ": it never went on", seed);
    expect_same_end(whole, parts);
    free(whole);
    free(parts);
}
END_TEST

START_TEST(what_was_done_is_not_done_again)
{
    const char *folder = new_folder();
    char *sub = new_study(folder, "sub");
    ck_assert_int_eq(end(begin(sub)), 0);
    char *before = whole_file(sub, "index.html");
    ck_assert_int_eq(end(begin(sub)), 0);
    char *after = whole_file(sub, "index.html");
    make_timeless(before, ">to fast<"); // tiers are compared anew
    make_timeless(after, ">to fast<");
    expect_same_words(before, after, "the page, seconds and all");
    ck_assert(said(sub, "nudged time: was done before"));
    free(before);
    free(after);
    free(sub);
}
END_TEST

START_TEST(of_a_changed_scene_it_starts_over_and_says_so)
{
    const char *folder = new_folder();
    char *sub = new_study(folder, "sub");
    const pid_t child = begin(sub);
    struct stat about;
    while (stat(in_folder(sub, "some-logical-states.dat"), &about) != 0)
        wait_for(0.01);
    wait_for(0.05);
    kill(child, SIGTERM);
    ck_assert_int_eq(end(child), 75);
    ck_assert(said(sub, "the same command goes on"));
    char changed[sizeof scene + 20];
    snprintf(changed, sizeof changed, "seed: 7\n%s", scene);
    write_file(sub, "some.yaml", changed);
    ck_assert_int_eq(end(begin(sub)), 0);
    ck_assert(said(sub, "the scene or the program has changed"));
    ck_assert(said(sub, "logical states: starts over"));
    ck_assert(!said(sub, "goes on from"));
    char *alone = new_study(folder, "alone");
    write_file(alone, "some.yaml", changed);
    ck_assert_int_eq(end(begin(alone)), 0);
    expect_same_end(alone, sub);
    // And what was done of it is not taken for the other's.
    write_file(sub, "some.yaml", scene);
    ck_assert_int_eq(end(begin(sub)), 0);
    ck_assert(said(sub, ".result: the scene or the program has changed"));
    free(alone);
    free(sub);
}
END_TEST

int main(void)
{
    return RUN_SUITE("study, resumed", 600,
                     stopped_and_killed_it_ends_as_if_left_alone,
                     what_was_done_is_not_done_again,
                     of_a_changed_scene_it_starts_over_and_says_so);
}
