// SPDX-License-Identifier: MIT
#include "study.h"
#include "session.h"
#include "start.h"
#include "study_findings.h"
#include "study_question.h"
#include "study_tiers.h"
#include "study_words.h"
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

typedef struct result { // what a worker hands back
    brink_trial trial;
    double nudge_off[BRINK_NUDGES];
} result;

typedef struct study {
    const char *out;
    int count; // of scenes
    brink_case *cases;
    // one a case; every worker has a copy of its own of each
    brink_system *starts;
    FILE *results; // a result a job, in the order of jobs
} study;

// Trial `job` is of this case and method: the scenes take turns, and the ways in
// the order in which the methods are numbered.
static brink_case *case_of(const study *s, int job)
{
    return &s->cases[job % s->count];
}

static enum brink_method method_of(const study *s, int job)
{
    return (enum brink_method)(job / s->count);
}

static FILE *open_samples(const study *s, const brink_case *c,
                          enum brink_method method)
{
    char name[200], path[4200];
    brink_findings_file(c, method, name, sizeof name);
    const int length = snprintf(path, sizeof path, "%s/%s", s->out, name);
    FILE *samples = length < (int)sizeof path ? fopen(path, "w") : NULL;
    if (samples == NULL) {
        fprintf(stderr, "brink study: cannot write %s: %s\n", path,
                strerror(errno));
        return NULL;
    }
    fprintf(samples,
            "# brink " BRINK_VERSION ", stability study: %s, seed %" PRIu64
            ", %s\n"
            "# energies as the positions show them; the error is relative to the "
            "start\n"
            "# events\ttime\terror\tenergy\n",
            c->name, c->scene.seed, brink_method_rule(method)->name);
    fflush(samples); // before a worker inherits it
    return samples;
}

// In the worker: what other nudges would have done, each from the same start.
static int try_nudges(const brink_case *c, enum brink_method method,
                      double off[BRINK_NUDGES])
{
    for (int k = 0; k < BRINK_NUDGES; k++) {
        brink_system start;
        if (brink_start_make(&c->scene, c->path, &start, stderr) != 0)
            return -1;
        off[k] =
            brink_nudge_try(&start, method, brink_nudge_size(k), c->nudge_events);
    }
    return 0;
}

// In the worker: 0 if the trial came to an end, of whatever kind, and is on file.
static int work(const study *s, int job, FILE *samples)
{
    const brink_case *c = case_of(s, job);
    const enum brink_method method = method_of(s, job);
    result done = {0};
    brink_trial_run(&s->starts[job % s->count], method, c->events, samples,
                    &done.trial);
    if (fclose(samples) != 0 || (brink_nudge_is_used(method) &&
                                 try_nudges(c, method, done.nudge_off) != 0))
        return -1;
    const ssize_t size = (ssize_t)sizeof done;
    return pwrite(fileno(s->results), &done, sizeof done, (off_t)(job * size)) !=
           size;
}

static pid_t start_worker(const study *s, int job)
{
    FILE *samples = open_samples(s, case_of(s, job), method_of(s, job));
    if (samples == NULL)
        return -1;
    const pid_t worker = fork();
    if (worker == 0)
        _exit(work(s, job, samples));
    fclose(samples);
    return worker;
}

// A worker that handed nothing back has crashed.
static void take_result(const study *s, int job, int handed_back)
{
    brink_case *c = case_of(s, job);
    const enum brink_method method = method_of(s, job);
    result done;
    const ssize_t size = (ssize_t)sizeof done;
    if (!handed_back || pread(fileno(s->results), &done, sizeof done,
                              (off_t)(job * size)) != size)
        done = (result){.trial = {.method = method, .particles = c->scene.count}};
    c->trial[method] = done.trial;
    memcpy(c->nudge_off[method], done.nudge_off, sizeof done.nudge_off);
    fprintf(stderr, "brink study: %s, %s: %s\n", c->name,
            brink_method_rule(method)->name,
            brink_findings_outcome(&done.trial).text);
}

static int find(const pid_t *worker, int started, pid_t who)
{
    int job = 0;
    while (job < started && worker[job] != who)
        job++;
    return job;
}

// Every trial in a process of its own, no more of them at a time than cores.
static int run_trials(const study *s)
{
    const int jobs = s->count * BRINK_METHODS;
    const long cores = sysconf(_SC_NPROCESSORS_ONLN);
    pid_t *worker = calloc((size_t)jobs, sizeof *worker);
    int started = 0, running = 0;
    if (worker == NULL)
        return -1;
    while (started < jobs || running > 0) {
        if (started < jobs && running < (cores > 1 ? cores : 1)) {
            worker[started] = start_worker(s, started);
            if (worker[started] > 0)
                running++;
            else
                take_result(s, started, 0);
            started++;
            continue;
        }
        int status;
        const pid_t who = waitpid(-1, &status, 0);
        const int job = find(worker, started, who);
        if (who > 0 && job < started) {
            if (WIFSIGNALED(status))
                fprintf(stderr,
                        "brink study: a worker was ended by signal %d (%s)\n",
                        WTERMSIG(status), strsignal(WTERMSIG(status)));
            take_result(s, job, status == 0);
            running--;
        }
    }
    free(worker);
    return 0;
}

// A word is a scene that comes with the program: in the source tree, or
// installed.
static void find_scene(const char *scene, char *path, size_t size)
{
    snprintf(path, size, "%s", scene);
    if (strpbrk(scene, "/.") != NULL)
        return;
    snprintf(path, size, "%s/%s.yaml", BRINK_SCENES, scene);
    if (access(path, R_OK) != 0)
        snprintf(path, size, "%s/%s.yaml", BRINK_SCENES_INSTALLED, scene);
}

// Names for files, different ones for different scenes.
static void name_case(const study *s, int k)
{
    const char *path = s->cases[k].path, *slash = strrchr(path, '/');
    brink_words name = brink_words_slug(slash == NULL ? path : slash + 1);
    char *ending = strstr(name.text, "-yaml");
    if (ending != NULL)
        *ending = '\0';
    snprintf(s->cases[k].name, sizeof s->cases[k].name, "%.48s", name.text);
    for (int other = 0; other < k; other++)
        if (strcmp(s->cases[other].name, s->cases[k].name) == 0)
            snprintf(s->cases[k].name, sizeof s->cases[k].name, "%.48s-%d",
                     name.text, k + 1);
}

static int read_case(const study *s, int k)
{
    brink_case *c = &s->cases[k];
    char path[4200];
    find_scene(c->path, path, sizeof path);
    if (brink_scene_read(path, &c->scene, stderr) != 0)
        return -1;
    c->events = brink_scene_events(&c->scene);
    const uint64_t some = 30 * (uint64_t)c->scene.count; // shows what goes wrong
    c->nudge_events = c->events < some ? c->events : some;
    if (c->events == UINT64_MAX) {
        fprintf(stderr,
                "%s: error: the study compares by events, and this scene runs "
                "for a time\n"
                "  give it run: {events_per_particle: n}\n",
                path);
        return -1;
    }
    name_case(s, k);
    return brink_start_make(&c->scene, path, &s->starts[k], stderr);
}

static void write_origin(brink_report *r, const study *s)
{
    char command[2000] = "";
    size_t at = 0;
    for (int k = 0; k < s->count && at < sizeof command; k++)
        at += (size_t)snprintf(command + at, sizeof command - at, "%s%s",
                               k > 0 ? " " : "", s->cases[k].path);
    brink_report_heading(r, 2, "How this page was made");
    brink_report_verbatim(r,
                          "brink study %s --out %s\n\nbrink %s, compiled by %s",
                          command, s->out, BRINK_VERSION, BRINK_COMPILER);
    for (int k = 0; k < s->count; k++)
        brink_report_paragraph(
            r, "%s: seed %" PRIu64 ", %" PRIu64 " events asked for.",
            s->cases[k].name, s->cases[k].scene.seed, s->cases[k].events);
    brink_report_paragraph(r, "The samples lie beside this page, a file a scene "
                              "and way, with the scripts that "
                              "draw the figures; `gnuplot NAME.gnuplot > "
                              "NAME.svg` draws one again. [S16] is S. "
                              "Strobl, M. N. Bannerman and T. Pöschel, Stable "
                              "algorithm for event detection in "
                              "event-driven particle dynamics: logical states, "
                              "Computational Particle Mechanics "
                              "3 (2016).");
}

// After the trials, when the machine has nothing else to do.
static void compare_tiers(brink_report *r, const brink_case *c)
{
    const uint64_t enough = 2000000; // for a figure or two, in some seconds
    brink_tier_trial trial[BRINK_TIERS];
    if (brink_tiers_try(&c->scene, c->path,
                        c->events < enough ? c->events : enough, trial) == 0)
        brink_tiers_tell(r, trial);
    else
        fprintf(stderr, "brink study: %s: the tiers were not compared\n",
                c->name);
}

static int write_page(const study *s)
{
    brink_report r;
    brink_report_open(&r, s->out, "Which side of the step?");
    brink_report_heading(&r, 1, "Which side of the step?");
    brink_question_pose(&r);
    for (int k = 0; k < s->count; k++) {
        brink_findings_tell(&r, &s->cases[k]);
        compare_tiers(&r, &s->cases[k]);
    }
    write_origin(&r, s);
    return brink_report_close(&r, stderr);
}

// 3 where a trial crashed or the logical states failed: the program's own fault.
static int verdict(const study *s)
{
    for (int k = 0; k < s->count; k++)
        for (int m = 0; m < BRINK_METHODS; m++) {
            const enum brink_outcome outcome = s->cases[k].trial[m].outcome;
            if (outcome == BRINK_OUTCOME_NONE ||
                outcome == BRINK_OUTCOME_NO_MEMORY)
                return BRINK_EXIT_WRONG;
            if (m == BRINK_METHOD_LOGICAL && outcome != BRINK_OUTCOME_DONE &&
                outcome != BRINK_OUTCOME_AT_REST)
                return BRINK_EXIT_WRONG;
        }
    return BRINK_EXIT_DONE;
}

static int run_study(study *s)
{
    int good = 1;
    for (int k = 0; k < s->count; k++)
        good &= read_case(s, k) == 0;
    if (!good)
        return BRINK_EXIT_USAGE;
    if (mkdir(s->out, 0777) != 0 && errno != EEXIST) {
        fprintf(stderr, "brink study: cannot make %s: %s\n", s->out,
                strerror(errno));
        return BRINK_EXIT_USAGE;
    }
    if (run_trials(s) != 0)
        return BRINK_EXIT_WRONG;
    if (write_page(s) != 0)
        return BRINK_EXIT_USAGE;
    printf("%s/index.html\n", s->out);
    return verdict(s);
}

int brink_study(const char *out, int count, const char *const scenes[])
{
    static const char *const usual[] = {"square-well", "square-shoulder"};
    study s = {.out = out, .count = count > 0 ? count : 2, .results = tmpfile()};
    s.cases = calloc((size_t)s.count, sizeof *s.cases);
    s.starts = calloc((size_t)s.count, sizeof *s.starts);
    int code = BRINK_EXIT_WRONG;
    if (s.cases != NULL && s.starts != NULL && s.results != NULL) {
        for (int k = 0; k < s.count; k++)
            s.cases[k].path = count > 0 ? scenes[k] : usual[k];
        code = run_study(&s);
        for (int k = 0; k < s.count; k++) {
            brink_scene_destroy(&s.cases[k].scene);
            brink_system_destroy(&s.starts[k]);
        }
    } else {
        fprintf(stderr,
                "brink study: no memory, or no room for a temporary file\n");
    }
    free(s.cases);
    free(s.starts);
    if (s.results != NULL)
        fclose(s.results);
    return code;
}
