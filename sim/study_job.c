// SPDX-License-Identifier: MIT
#include "study_job.h"
#include "checkpoint.h"
#include "session.h"
#include "start.h"
#include "study_progress.h"
#include "wall.h"
#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define PATH_ROOM 4200

// A job under way.
typedef struct work {
    const brink_job *job;
    const brink_watch *watch;
    char folder[PATH_ROOM], result[PATH_ROOM];
    FILE *samples;
    brink_progress done;
    int written; // samples on file
} work;

static const char *name_of(const brink_job *job)
{
    return brink_method_rule(job->method)->name;
}

__attribute__((format(printf, 2, 3))) static void tell(const brink_job *job,
                                                       const char *format, ...)
{
    // In one piece: others tell of theirs at the same time.
    char what[PATH_ROOM];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    fprintf(stderr, "brink study: %s, %s: %s\n", job->of->name, name_of(job),
            what);
}

static int path_of(const brink_job *job, const char *ending, char *path)
{
    char name[200];
    brink_findings_file(job->of, job->method, ending, name, sizeof name);
    const int length = snprintf(path, PATH_ROOM, "%s/%s", job->out, name);
    return length < PATH_ROOM ? 0 : -1;
}

// Alone at the file from here on.  0, or the exit code.
static int lock(const work *w)
{
    struct flock whole = {.l_type = F_WRLCK, .l_whence = SEEK_SET};
    while (fcntl(fileno(w->samples), F_SETLK, &whole) != 0) {
        if (errno != EACCES && errno != EAGAIN)
            return 0; // not every file system can: there it is up to the user
        if (brink_watch_wait(w->watch, 0.05))
            return BRINK_EXIT_STOPPED;
    }
    return 0;
}

static int open_files(work *w)
{
    char path[PATH_ROOM];
    if (path_of(w->job, "", w->folder) || path_of(w->job, ".result", w->result) ||
        path_of(w->job, ".dat", path))
        errno = ENAMETOOLONG;
    else
        w->samples = fopen(path, "a");
    if (w->samples != NULL)
        return lock(w);
    tell(w->job, "cannot write %s: %s", path, strerror(errno));
    return BRINK_EXIT_USAGE;
}

// Those samples that are not on file yet; nothing is on file before the first.
static void write_samples(work *w)
{
    const brink_trial *t = &w->done.attempt.trial;
    for (; w->written < t->samples; w->written++) {
        const brink_sample *s = &t->sample[w->written];
        fprintf(w->samples, "%" PRIu64 "\t%.10g\t%.6g\t%.17g\t%.6g\n", s->events,
                s->time, s->error, s->energy, s->kept);
    }
    fflush(w->samples); // a crash leaves what there was
}

static int begin_samples(work *w)
{
    const brink_case *c = w->job->of;
    if (ftruncate(fileno(w->samples), 0) != 0)
        return -1;
    fprintf(w->samples,
            "# brink " BRINK_VERSION ", stability study: %s, seed %" PRIu64
            ", %s\n"
            "# energy as the positions show it, its error relative to the start; "
            "and the relative\n"
            "# gain of kinetic energy and levels as the states have them\n"
            "# events\ttime\terror\tenergy\tgain\n",
            c->name, c->scene.seed, name_of(w->job));
    write_samples(w);
    return 0;
}

// A copy of the start, which a trial takes over.
static int copy_start(const brink_job *job, brink_system *start)
{
    return brink_start_make(&job->of->scene, job->of->path, start, stderr);
}

static int begin_trial(work *w)
{
    brink_system start;
    if (copy_start(w->job, &start) != 0)
        return -1;
    brink_attempt_create(&w->done.attempt, &start, w->job->method,
                         w->job->of->events);
    return 0;
}

static int has_result(work *w)
{
    const char *fault = brink_progress_load(&w->done, w->result);
    if (fault == NULL && w->done.attempt.trial.outcome != BRINK_OUTCOME_NO_MEMORY)
        return 1;
    if (access(w->result, F_OK) == 0)
        tell(w->job, "starts over: %s: %s", w->result,
             fault != NULL ? fault : "memory was out");
    unlink(w->result);
    w->done = (brink_progress){.key = w->done.key};
    return 0;
}

// From where it was, or from the beginning.
static int take_up(work *w)
{
    brink_attempt *a = &w->done.attempt;
    a->events = w->job->of->events;
    a->trial.method = w->job->method;
    if (brink_checkpoint_count(w->folder) > 0) {
        if (brink_progress_resume(&w->done, w->folder, stderr) == 0) {
            const uint64_t events =
                brink_tally_events(&brink_attempt_run(a)->tally);
            tell(w->job, "goes on from %s events",
                 brink_words_grouped(events).text);
            return 0;
        }
        tell(w->job, "starts over");
    }
    brink_checkpoint_clear(w->folder);
    return begin_trial(w);
}

// Who looks on wants to see that it moves.
static void show(const work *w)
{
    const brink_attempt *a = &w->done.attempt;
    const uint64_t events = brink_tally_events(&brink_attempt_run(a)->tally);
    if (isatty(STDERR_FILENO))
        tell(w->job, "%s of %s events", brink_words_grouped(events).text,
             brink_words_grouped(a->events).text);
}

// To the trial's end, or to a stop: 0, or the exit code.
static int carry_out(work *w)
{
    brink_trial *t = &w->done.attempt.trial;
    double last = brink_wall_clock(), saved = last;
    while (t->outcome == BRINK_OUTCOME_NONE) {
        brink_attempt_advance(&w->done.attempt, BRINK_WATCH_EVENTS);
        write_samples(w);
        const double now = brink_wall_clock();
        t->wall += now - last;
        last = now;
        if (t->outcome != BRINK_OUTCOME_NONE)
            break;
        const int stopped = brink_watch_stopped(w->watch);
        if (!stopped && now - saved < w->job->of->scene.checkpoint_every)
            continue;
        if (brink_progress_save(&w->done, w->folder, stderr) != 0)
            return BRINK_EXIT_USAGE;
        if (stopped)
            return BRINK_EXIT_STOPPED;
        show(w);
        saved = now;
    }
    return 0;
}

// What other nudges would have done, each from the same start; each that has been
// tried is on file.
static int try_nudges(work *w)
{
    const brink_job *job = w->job;
    brink_progress *p = &w->done;
    if (!brink_nudge_is_used(job->method))
        return 0;
    while (p->nudges < BRINK_NUDGES) {
        brink_system start;
        if (copy_start(job, &start) != 0)
            return BRINK_EXIT_USAGE;
        if (brink_nudge_try(&start, job->method, brink_nudge_size(p->nudges),
                            job->of->nudge_events, w->watch,
                            &p->nudge_off[p->nudges]) != 0)
            return BRINK_EXIT_STOPPED;
        p->nudges++;
        if (brink_progress_store(p, w->result, stderr) != 0)
            return BRINK_EXIT_USAGE;
    }
    return 0;
}

static int do_trial(work *w)
{
    if (take_up(w) != 0 || begin_samples(w) != 0)
        return BRINK_EXIT_USAGE;
    const int code = carry_out(w);
    if (code != 0)
        return code;
    if (brink_progress_store(&w->done, w->result, stderr) != 0)
        return BRINK_EXIT_USAGE;
    brink_checkpoint_clear(w->folder);
    return 0;
}

// The samples are written again: they may have been lost since.
static int work_through(work *w)
{
    int code = open_files(w);
    if (code != 0)
        return code;
    w->done.key =
        brink_progress_key(&w->job->of->scene, w->job->start, w->job->method);
    if (has_result(w)) {
        tell(w->job, "was done before");
        code = begin_samples(w) != 0 ? BRINK_EXIT_USAGE : 0;
    } else {
        code = do_trial(w);
    }
    return code != 0 ? code : try_nudges(w);
}

int brink_job_work(const brink_job *job, const brink_watch *watch)
{
    work *w = calloc(1, sizeof *w);
    if (w == NULL)
        return BRINK_EXIT_WRONG;
    w->job = job;
    w->watch = watch;
    int code = work_through(w);
    if (w->samples != NULL && fclose(w->samples) != 0 && code == 0)
        code = BRINK_EXIT_USAGE;
    brink_attempt_destroy(&w->done.attempt);
    free(w);
    return code;
}

void brink_job_take(const brink_job *job, int left_result)
{
    brink_case *c = job->of;
    char path[PATH_ROOM];
    brink_progress *done = calloc(1, sizeof *done);
    brink_trial *trial = &c->trial[job->method];
    trial->method = job->method;
    trial->particles = c->scene.count;
    if (done != NULL && left_result && path_of(job, ".result", path) == 0) {
        done->key = brink_progress_key(&c->scene, job->start, job->method);
        if (brink_progress_load(done, path) == NULL) {
            *trial = done->attempt.trial;
            memcpy(c->nudge_off[job->method], done->nudge_off,
                   sizeof done->nudge_off);
        }
    }
    free(done);
    tell(job, "%s", brink_findings_outcome(trial).text);
}
