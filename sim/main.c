// SPDX-License-Identifier: MIT
// The command line, nothing else.
#include "explain.h"
#include "scene.h"
#include "session.h"
#include "study.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char help[] =
    "brink: event-driven simulation of particles with stepped potentials\n"
    "\n"
    "  brink run SCENE [--out DIR] [--events-per-particle N | --events N | "
    "--time T]\n"
    "                  [--seed S] [--tier fast|plain|cr] [--max-wall SECONDS]\n"
    "  brink resume DIR [--max-wall SECONDS]\n"
    "  brink check SCENE\n"
    "  brink study [SCENE...] [--out DIR]\n"
    "  brink explain SCENE --event N [--pair I,J] [--seed S] [--tier "
    "fast|plain|cr]\n"
    "  brink explain DIR --event N [--pair I,J]\n"
    "  brink --help | --version\n"
    "\n"
    "run     simulates a scene into DIR (its name without the ending): "
    "checkpoints,\n"
    "        summary.json, final.xyz, and trajectory.xyz if the scene asks for "
    "one.\n"
    "        The target and the seed are the scene's unless given here.\n"
    "resume  goes on from the newest whole checkpoint, to the same target.\n"
    "check   reads a scene, sets it up and says what it is, without running it.\n"
    "study   runs scenes with logical states and with the conventional methods "
    "beside\n"
    "        them, and writes DIR/index.html (report/index.html).  Stopped or "
    "killed, it\n"
    "        goes on when the same command is given again.\n"
    "explain replays a run to one event, from a scene or from a run's folder, "
    "and "
    "prints\n"
    "        how it was predicted, the pair, its surfaces and the decision, in "
    "decimal\n"
    "        and hex.  Events are numbered from 1, as `events` in summary.json "
    "counts\n"
    "        them; particles from 0.  With --pair, that pair at that moment.\n"
    "\n"
    "tiers   how event times are computed: fast (bounded distance from the "
    "surface),\n"
    "        plain (the default: whether and which side exact, time within 8 "
    "ulp),\n"
    "        cr (correctly rounded).\n"
    "\n"
    "exit codes: 0 done, 2 usage or bad input, 3 the run found itself wrong,\n"
    "75 stopped early (SIGTERM, SIGINT, --max-wall) with a checkpoint to resume "
    "from\n";

typedef struct command_line {
    const char *file[64]; // what is not an option
    int files;
    brink_orders orders;
    brink_explain_orders explain;
} command_line;

static int wrong(const char *what, const char *which)
{
    fprintf(stderr, "brink: %s%s\n  `brink --help` shows the commands\n", what,
            which);
    return -1;
}

static int parse_number(const char *option, const char *text, double *value)
{
    char *end;
    *value = strtod(text, &end);
    if (end == text || *end || !isfinite(*value) || !(*value > 0))
        return wrong(option, " takes a positive number");
    return 0;
}

static int parse_count(const char *option, const char *text, uint64_t *value)
{
    char *end;
    errno = 0;
    *value = strtoull(text, &end, 10);
    if (strspn(text, "0123456789") != strlen(text) || end == text || *end ||
        errno)
        return wrong(option, " takes a whole number, in plain digits");
    return 0;
}

static int parse_target(const char *option, const char *text, brink_orders *o)
{
    if (o->has_target)
        return wrong(option, ": a run has one target");
    o->has_target = 1;
    o->events = UINT64_MAX;
    o->until = (double)INFINITY;
    if (strcmp(option, "--events") == 0)
        return parse_count(option, text, &o->events);
    return parse_number(option, text,
                        strcmp(option, "--time") == 0 ? &o->until
                                                      : &o->events_per_particle);
}

static int parse_tier(const char *text, enum brink_tier *tier)
{
    static const char *const names[] = {"fast", "plain", "cr"};
    for (int k = 0; k < 3; k++)
        if (strcmp(text, names[k]) == 0) {
            *tier = (enum brink_tier)k;
            return 0;
        }
    return wrong("--tier is fast, plain or cr, not ", text);
}

static int parse_event(const char *text, uint64_t *event)
{
    if (parse_count("--event", text, event))
        return -1;
    return *event > 0 ? 0 : wrong("--event counts from 1, not ", text);
}

static int parse_pair(const char *text, brink_explain_orders *o)
{
    const char *comma = strchr(text, ',');
    char first[24];
    uint64_t i, j;
    const size_t length = comma ? (size_t)(comma - text) : sizeof first;
    if (length >= sizeof first)
        return wrong("--pair takes two particles, as 3,14, not ", text);
    memcpy(first, text, length);
    first[length] = '\0';
    if (parse_count("--pair", first, &i) || parse_count("--pair", comma + 1, &j))
        return -1;
    if (i == j || i > UINT32_MAX || j > UINT32_MAX)
        return wrong("--pair takes two particles, as 3,14, not ", text);
    o->has_pair = 1;
    o->pair[0] = (uint32_t)i;
    o->pair[1] = (uint32_t)j;
    return 0;
}

static int parse_option(const char *option, const char *text, command_line *line)
{
    brink_orders *o = &line->orders;
    if (strcmp(option, "--event") == 0)
        return parse_event(text, &line->explain.event);
    if (strcmp(option, "--pair") == 0)
        return parse_pair(text, &line->explain);
    if (strcmp(option, "--out") == 0) {
        o->out = text;
        return 0;
    }
    if (strcmp(option, "--seed") == 0) {
        o->has_seed = 1;
        if (parse_count(option, text, &o->seed))
            return -1;
        return o->seed <= BRINK_SEED_MOST
                   ? 0
                   : wrong("--seed is below 2^32, not ", text);
    }
    if (strcmp(option, "--tier") == 0) {
        line->explain.has_tier = 1;
        return parse_tier(text, &o->tier);
    }
    if (strcmp(option, "--max-wall") == 0)
        return parse_number(option, text, &o->max_wall);
    if (strcmp(option, "--events") == 0 || strcmp(option, "--time") == 0 ||
        strcmp(option, "--events-per-particle") == 0)
        return parse_target(option, text, o);
    return wrong("there is no option ", option);
}

// `allowed`: the options of the command, each between spaces.
static int parse(int argc, char **argv, const char *allowed, command_line *line)
{
    *line = (command_line){
        .orders = {.tier = BRINK_TIER_PLAIN, .max_wall = (double)INFINITY}};
    for (int k = 2; k < argc; k++) {
        if (strncmp(argv[k], "--", 2) != 0) {
            if (line->files == 64)
                return wrong("too many files, from ", argv[k]);
            line->file[line->files++] = argv[k];
            continue;
        }
        const size_t length = strlen(argv[k]);
        const char *at = strstr(allowed, argv[k]);
        if (!at || at[length] != ' ')
            return wrong("this command has no option ", argv[k]);
        if (k + 1 == argc)
            return wrong(argv[k], " needs a value");
        if (parse_option(argv[k], argv[k + 1], line))
            return -1;
        k++;
    }
    return 0;
}

static int one_file(const command_line *line, const char *what)
{
    return line->files == 1 ? 0 : wrong("this command takes one ", what);
}

static int explain(command_line *line)
{
    brink_explain_orders *o = &line->explain;
    if (o->event == 0)
        return wrong("explain needs --event N", ""), BRINK_EXIT_USAGE;
    o->has_seed = line->orders.has_seed;
    o->seed = line->orders.seed;
    o->tier = line->orders.tier;
    return brink_explain(stdout, line->file[0], o);
}

int main(int argc, char **argv)
{
    const char *command = argc > 1 ? argv[1] : "";
    command_line line;
    if (strcmp(command, "--help") == 0 || strcmp(command, "-h") == 0) {
        fputs(help, stdout);
        return BRINK_EXIT_DONE;
    }
    if (strcmp(command, "--version") == 0) {
        puts("brink " BRINK_VERSION);
        return BRINK_EXIT_DONE;
    }
    if (strcmp(command, "run") == 0)
        return parse(argc, argv,
                     "--out --events --time --events-per-particle --seed --tier "
                     "--max-wall ",
                     &line) ||
                       one_file(&line, "scene")
                   ? BRINK_EXIT_USAGE
                   : brink_session_run(line.file[0], &line.orders);
    if (strcmp(command, "resume") == 0)
        return parse(argc, argv, "--max-wall ", &line) ||
                       one_file(&line, "folder")
                   ? BRINK_EXIT_USAGE
                   : brink_session_resume(line.file[0], line.orders.max_wall);
    if (strcmp(command, "check") == 0)
        return parse(argc, argv, "", &line) || one_file(&line, "scene")
                   ? BRINK_EXIT_USAGE
                   : brink_session_check(line.file[0]);
    if (strcmp(command, "study") == 0)
        return parse(argc, argv, "--out ", &line)
                   ? BRINK_EXIT_USAGE
                   : brink_study(line.orders.out ? line.orders.out : "report",
                                 line.files, line.file);
    if (strcmp(command, "explain") == 0)
        return parse(argc, argv, "--event --pair --seed --tier ", &line) ||
                       one_file(&line, "scene or folder")
                   ? BRINK_EXIT_USAGE
                   : explain(&line);
    wrong(*command ? "there is no command " : "a command is needed", command);
    return BRINK_EXIT_USAGE;
}
