// SPDX-License-Identifier: MIT
#ifndef SESSIONS_H
#define SESSIONS_H
/**
 * `brink run` and `brink resume` as processes of their own, which a test may kill
 * or take something away from: a child calls what the program calls.
 */
#include "folder.h"
#include "session.h"
#include <fcntl.h>
#include <math.h>
#include <sys/wait.h>
#include <unistd.h>

/** In the child: runs path into dir, or resumes dir, for so many seconds at most;
 * what it says to standard error is left in FOLDER/said. */
static inline _Noreturn void play(const char *folder, const char *path,
                                  const char *dir, double max_wall)
{
    char said[200];
    snprintf(said, sizeof said, "%s/said", folder);
    const int out = open("/dev/null", O_WRONLY);
    const int err = open(said, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    dup2(out, STDOUT_FILENO);
    dup2(err, STDERR_FILENO);
    const brink_orders orders = {
        .out = dir, .tier = BRINK_TIER_PLAIN, .max_wall = max_wall};
    _exit(path ? brink_session_run(path, &orders)
               : brink_session_resume(dir, max_wall));
}

/** The exit code of a child; -1 where it was killed. */
static inline int exit_of(pid_t child)
{
    int status;
    ck_assert_int_eq(waitpid(child, &status, 0), child);
    return WIFSIGNALED(status) ? -1 : WEXITSTATUS(status);
}

// The summary without what the clock on the wall has to do with.
static inline void make_timeless(char *summary)
{
    static const char *const keys[] = {"\"wall_seconds\"",
                                       "\"events_per_second\""};
    for (int k = 0; k < 2; k++) {
        char *at = strstr(summary, keys[k]);
        ck_assert_ptr_nonnull(at);
        const size_t length = strcspn(at, "\n");
        memmove(at, at + length, strlen(at + length) + 1);
    }
}

/** The results in two folders are the same, bit for bit. */
static inline void expect_same_end(const char *a, const char *b, const char *what)
{
    static const char *const names[] = {"final.xyz", "trajectory.xyz",
                                        "summary.json"};
    for (int k = 0; k < 3; k++) {
        char *one = whole_file(a, names[k]), *other = whole_file(b, names[k]);
        if (k == 2) {
            make_timeless(one);
            make_timeless(other);
        }
        ck_assert_msg(strcmp(one, other) == 0, "%s: %s differs", what, names[k]);
        free(one);
        free(other);
    }
}
#endif
