// SPDX-License-Identifier: MIT
#include "session.h"
#include "checkpoint.h"
#include "observe.h"
#include "scene.h"
#include "session_files.h"
#include "session_looks.h"
#include "start.h"
#include "wall.h"
#include <inttypes.h>
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static void show_progress(const brink_session *s, double rate)
{
    char line[200];
    if (!isatty(STDERR_FILENO))
        return;
    brink_observe_progress(line, sizeof line, &s->run, &s->plan, rate);
    fprintf(stderr, "\r%s\033[K", line);
}

// Why the run stopped, for the summary; NULL while it goes on.  `arrived`: all
// events up to and at the clock's instant have been executed.
static const char *stop_reason(const brink_session *s,
                               enum brink_run_status status, int arrived,
                               double spent)
{
    const struct timespec at_once = {0, 0};
    switch (status) {
    case BRINK_RUN_STUCK:
        return "stuck";
    case BRINK_RUN_REFUSED:
        return "refused";
    case BRINK_RUN_NO_MEMORY:
        return "no memory";
    case BRINK_RUN_AT_REST:
        return "at rest";
    case BRINK_RUN_REACHED:
    case BRINK_RUN_QUIET: // events may yet come
        break;
    }
    const brink_instant until =
        brink_instant_at(s->run.system.year, s->plan.until);
    if (brink_tally_events(&s->run.tally) >= s->plan.events ||
        (arrived && brink_instant_compare(s->run.now, until) >= 0))
        return "target reached";
    if (sigtimedwait(&s->stops, NULL, &at_once) > 0)
        return "signal";
    return spent >= s->max_wall ? "wall time" : NULL;
}

// Drives the run to its target or to a stop; the reason, or NULL where a file
// could not be written.  A piece is some tenth of a second, so that signals are
// heard, or as long as checkpoints are apart.
static const char *drive(brink_session *s, enum brink_run_status *status)
{
    const double begin = brink_wall_clock(), before = s->plan.wall_seconds;
    const double length = fmin(0.1, s->scene.checkpoint_every);
    const uint64_t events_before = brink_tally_events(&s->run.tally);
    double saved = begin;
    uint64_t piece = 1000;
    for (;;) {
        const uint64_t most = brink_tally_events(&s->run.tally) + piece;
        const uint64_t events = most < s->plan.events ? most : s->plan.events;
        *status = brink_run_advance(&s->run, events, brink_looks_next(s));
        const int arrived = brink_tally_events(&s->run.tally) < events;
        if (arrived && brink_looks_take(s))
            return NULL;
        const double now = brink_wall_clock();
        s->plan.wall_seconds = before + (now - begin);
        const char *reason = stop_reason(s, *status, arrived, now - begin);
        const uint64_t done = brink_tally_events(&s->run.tally) - events_before;
        const double rate =
            (double)done / fmax(now - begin, 1e-9); // s: the clock's tick
        piece = (uint64_t)fmin(fmax(length * rate, 1000), 1e6);
        show_progress(s, rate);
        if (reason)
            return reason;
        if (now - saved >= s->scene.checkpoint_every) {
            if (brink_looks_save(s))
                return NULL;
            saved = now;
        }
    }
}

static int exit_code(const char *reason, enum brink_run_status status)
{
    if (strcmp(reason, "signal") == 0 || strcmp(reason, "wall time") == 0)
        return BRINK_EXIT_STOPPED;
    return status == BRINK_RUN_REACHED || status == BRINK_RUN_AT_REST
               ? BRINK_EXIT_DONE
               : BRINK_EXIT_WRONG;
}

static int finish(brink_session *s, const char *reason,
                  enum brink_run_status status)
{
    const int code = exit_code(reason, status);
    if (isatty(STDERR_FILENO))
        fputc('\n', stderr);
    if (code == BRINK_EXIT_WRONG) {
        char why[2000];
        brink_run_diagnosis(&s->run, status, why, sizeof why);
        fprintf(stderr, "%s: the run cannot go on: %s", s->dir, why);
    }
    if (brink_looks_save(s) || brink_looks_results(s, reason))
        return BRINK_EXIT_USAGE;
    if (code == BRINK_EXIT_STOPPED)
        fprintf(stderr, "%s: stopped early (%s); `brink resume %s` goes on\n",
                s->dir, reason, s->dir);
    printf("%s/summary.json\n", s->dir);
    return code;
}

// The run is set up or loaded: drive it, with the signals held.
static int carry_out(brink_session *s)
{
    enum brink_run_status status = BRINK_RUN_REACHED;
    int code = BRINK_EXIT_USAGE;
    sigset_t before;
    sigemptyset(&s->stops);
    sigaddset(&s->stops, SIGTERM);
    sigaddset(&s->stops, SIGINT);
    sigprocmask(SIG_BLOCK, &s->stops, &before);
    if (brink_looks_open_trajectory(s) == 0) {
        const char *reason = drive(s, &status);
        if (reason)
            code = finish(s, reason, status);
    }
    sigprocmask(SIG_SETMASK, &before, NULL);
    return code;
}

static void destroy(brink_session *s)
{
    if (s->trajectory)
        fclose(s->trajectory);
    brink_record_destroy(&s->record);
    brink_run_destroy(&s->run);
    brink_plan_destroy(&s->plan);
    brink_scene_destroy(&s->scene);
}

static int make_plan(brink_session *s, const brink_orders *o)
{
    brink_plan *p = &s->plan;
    p->events = brink_scene_events(&s->scene);
    p->until = s->scene.target == BRINK_TARGET_TIME ? s->scene.target_value
                                                    : (double)INFINITY;
    if (o->has_target) {
        p->events = o->events;
        p->until = o->until;
        if (o->events_per_particle > 0)
            p->events = (uint64_t)ceil(o->events_per_particle * s->scene.count);
    }
    p->seed = s->scene.seed;
    p->scene_size = s->scene.text_size;
    p->scene = malloc(p->scene_size + 1);
    if (!p->scene) {
        fputs("memory is out\n", stderr);
        return -1;
    }
    memcpy(p->scene, s->scene.text, p->scene_size);
    p->scene[p->scene_size] = '\0';
    return 0;
}

// From a scene's path to a run before its first event.
static int set_up(brink_session *s, const char *scene, const brink_orders *orders)
{
    if (brink_scene_read(scene, &s->scene, stderr))
        return -1;
    if (orders->has_seed)
        s->scene.seed = orders->seed;
    brink_system system;
    if (brink_start_make(&s->scene, scene, &system, stderr))
        return -1;
    if (brink_run_create(&s->run, &system, orders->tier)) {
        brink_system_destroy(&system);
        fprintf(stderr, "%s: memory is out\n", scene);
        return -1;
    }
    return make_plan(s, orders) || brink_looks_begin(s) ? -1 : 0;
}

// A write beyond the limit on a file's size is to fail as one to a full disk
// does, and not to end the program.
static void outlive_limits(void)
{
    signal(SIGXFSZ, SIG_IGN);
}

int brink_session_run(const char *scene, const brink_orders *orders)
{
    outlive_limits();
    brink_session s = {.max_wall = orders->max_wall};
    int code = BRINK_EXIT_USAGE;
    if (set_up(&s, scene, orders) == 0 &&
        brink_files_choose(s.dir, sizeof s.dir, scene, orders->out) == 0 &&
        brink_looks_save(&s) == 0)
        code = carry_out(&s);
    destroy(&s);
    return code;
}

int brink_session_resume(const char *dir, double max_wall)
{
    outlive_limits();
    brink_session s = {.max_wall = max_wall};
    char path[4200];
    int code = BRINK_EXIT_USAGE;
    if (snprintf(s.dir, sizeof s.dir, "%s", dir) >= (int)sizeof s.dir)
        fprintf(stderr, "%.60s...: the folder's name is too long\n", dir);
    else if (brink_checkpoint_resume(dir, &s.run, &s.plan, path, sizeof path,
                                     stderr) == 0 &&
             brink_scene_parse(s.plan.scene, s.plan.scene_size, path, "",
                               &s.scene, stderr) == 0 &&
             brink_looks_resume(&s, path) == 0) {
        fprintf(stderr, "%s: going on from %" PRIu64 " events\n", path,
                brink_tally_events(&s.run.tally));
        code = carry_out(&s);
    }
    destroy(&s);
    return code;
}

int brink_session_check(const char *scene)
{
    brink_session s = {0};
    const brink_orders orders = {.tier = BRINK_TIER_PLAIN};
    const int status = set_up(&s, scene, &orders);
    if (status == 0)
        printf("%s: a good scene: %" PRIu32 " particles in %g x %g x %g, %" PRId64
               " pairs captured, energy %.17g\n",
               scene, s.run.system.count, s.run.system.length[0],
               s.run.system.length[1], s.run.system.length[2],
               (int64_t)(s.run.states.links.used / 2), s.run.energy_begin);
    destroy(&s);
    return status ? BRINK_EXIT_USAGE : BRINK_EXIT_DONE;
}
