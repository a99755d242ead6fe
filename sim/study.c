// SPDX-License-Identifier: MIT
#include "study.h"
#include "session.h"
#include "start.h"
#include "study_findings.h"
#include "study_jobs.h"
#include "study_question.h"
#include "study_tiers.h"
#include "study_words.h"
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct study {
    const char *out;
    int count; // of scenes
    brink_case *cases;
    brink_system *starts; // one a case
} study;

// The logical states of all scenes first, then what fails soon, then what may go
// on for as long as they do.
static const enum brink_method turns[BRINK_METHODS] = {
    BRINK_METHOD_LOGICAL, BRINK_METHOD_POSITION,    BRINK_METHOD_STORED,
    BRINK_METHOD_PRINTED, BRINK_METHOD_NUDGED_TIME, BRINK_METHOD_NUDGED_PLACE};

static int run_trials(const study *s)
{
    const int count = s->count * BRINK_METHODS;
    brink_job *jobs = calloc((size_t)count, sizeof *jobs);
    if (jobs == NULL)
        return BRINK_EXIT_WRONG;
    for (int k = 0; k < count; k++)
        jobs[k] = (brink_job){.out = s->out,
                              .of = &s->cases[k % s->count],
                              .start = &s->starts[k % s->count],
                              .method = turns[k / s->count]};
    const int code = brink_jobs_run(jobs, count);
    if (code == BRINK_EXIT_STOPPED)
        fputs("brink study: stopped early; the same command goes on\n", stderr);
    free(jobs);
    return code;
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
    brink_report_verbatim(
        r, "brink study %s --out %s\n\nbrink %s, compiled by %s", command, s->out,
        BRINK_VERSION BRINK_COMMIT, BRINK_COMPILER);
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
    const int code = run_trials(s);
    if (code != BRINK_EXIT_DONE)
        return code;
    if (write_page(s) != 0)
        return BRINK_EXIT_USAGE;
    printf("%s/index.html\n", s->out);
    return verdict(s);
}

int brink_study(const char *out, int count, const char *const scenes[])
{
    static const char *const usual[] = {"square-well", "square-shoulder"};
    study s = {.out = out, .count = count > 0 ? count : 2};
    s.cases = calloc((size_t)s.count, sizeof *s.cases);
    s.starts = calloc((size_t)s.count, sizeof *s.starts);
    int code = BRINK_EXIT_WRONG;
    if (s.cases != NULL && s.starts != NULL) {
        for (int k = 0; k < s.count; k++)
            s.cases[k].path = count > 0 ? scenes[k] : usual[k];
        code = run_study(&s);
        for (int k = 0; k < s.count; k++) {
            brink_scene_destroy(&s.cases[k].scene);
            brink_system_destroy(&s.starts[k]);
        }
    } else {
        fputs("brink study: memory is out\n", stderr);
    }
    free(s.cases);
    free(s.starts);
    return code;
}
