// SPDX-License-Identifier: MIT
#include "study_jobs.h"
#include "session.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

typedef struct crew {
    const brink_job *jobs;
    int count;
    pid_t *worker; // a job's, while it is at work
    int started, running;
    int stopped; // nobody is started any more
    brink_watch watch;
} crew;

static void start_next(crew *c)
{
    const brink_job *job = &c->jobs[c->started];
    brink_watch watch = c->watch;
    watch.parent = getpid();
    const pid_t worker = fork();
    if (worker == 0)
        _exit(brink_job_work(job, &watch));
    if (worker > 0) {
        c->worker[c->started] = worker;
        c->running++;
    } else {
        fprintf(stderr, "brink study: no process: %s\n", strerror(errno));
        brink_job_take(job, 0);
    }
    c->started++;
}

static void stop(crew *c)
{
    for (int k = 0; k < c->started; k++)
        if (c->worker[k] > 0)
            kill(c->worker[k], SIGTERM);
    c->stopped = 1;
}

static void end_worker(crew *c, int job, int status)
{
    c->worker[job] = 0;
    c->running--;
    if (WIFSIGNALED(status))
        fprintf(stderr, "brink study: a worker was ended by signal %d (%s)\n",
                WTERMSIG(status), strsignal(WTERMSIG(status)));
    if (WIFEXITED(status) && WEXITSTATUS(status) == BRINK_EXIT_STOPPED)
        c->stopped = 1; // by a signal of its own, or with all of us
    else
        brink_job_take(&c->jobs[job], status == 0);
}

// Whoever has come to an end since; not waiting for anybody.
static void end_workers(crew *c)
{
    int status;
    for (pid_t who; (who = waitpid(-1, &status, WNOHANG)) > 0;)
        for (int k = 0; k < c->started; k++)
            if (c->worker[k] == who)
                end_worker(c, k, status);
}

static void work_through(crew *c)
{
    const long cores = sysconf(_SC_NPROCESSORS_ONLN);
    while (c->running > 0 || (c->started < c->count && !c->stopped)) {
        if (c->started < c->count && !c->stopped &&
            c->running < (cores > 1 ? cores : 1)) {
            start_next(c);
            continue;
        }
        if (brink_watch_wait(&c->watch, 0.02))
            stop(c);
        end_workers(c);
    }
}

int brink_jobs_run(const brink_job *jobs, int count)
{
    crew c = {.jobs = jobs, .count = count};
    c.worker = calloc((size_t)count, sizeof *c.worker);
    if (c.worker == NULL)
        return BRINK_EXIT_WRONG;
    brink_watch_begin(&c.watch);
    work_through(&c);
    brink_watch_end(&c.watch);
    free(c.worker);
    return c.stopped ? BRINK_EXIT_STOPPED : BRINK_EXIT_DONE;
}
