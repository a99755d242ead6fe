// SPDX-License-Identifier: MIT
/**
 * The kernels: speed against error.  The simulator: speed beside a plain one.
 *
 *   bench [OPTION VALUE]...   writes the kernels' page
 *         --out FOLDER            into FOLDER
 *         --cases N               from N cases of each family
 *         --seconds S             with S seconds for the costs of a problem
 *         --seed N                of other random inputs
 *         --instructions FILE     with the counts that instructions.sh wrote
 *   bench simulator [OPTION VALUE]...   writes the simulator's page
 *         --out FOLDER            into FOLDER
 *         --seconds S             with pieces of S seconds, or one event each
 *         --particles N           in systems of at most N particles
 *         --instructions FILE     with the counts that simulator_counts.sh wrote
 *   bench speed [PART]        prints what was asked of the kernels' speed, and
 *                             what is measured, of kernels whose name holds PART
 *   bench count               calls everything, for instructions.sh to count
 */
#include "bench_count.h"
#include "bench_page.h"
#include "bench_simulator.h"
#include "bench_speed.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DONE = 0, FAILED = 1, USAGE = 2 };

static int usage(void)
{
    fputs("usage: bench [--out FOLDER] [--cases N] [--seconds S] [--seed N] "
          "[--instructions FILE]\n"
          "       bench simulator [--out FOLDER] [--seconds S] [--particles N] "
          "[--instructions FILE]\n"
          "       bench speed [PART]\n"
          "       bench count\n",
          stderr);
    return USAGE;
}

static int print_speeds(const char *part)
{
    printf("%-32s %-12s %-18s %8s %6s %6s\n", "kernel", "inputs", "beside", "ns",
           "ratio", "asked");
    for (int k = 0; k < bench_speed_lines(); k++) {
        speed s;
        if (strstr(bench_speed_kernel(k), part) == NULL)
            continue;
        if (bench_speed_measure(k, 1, 0.4, &s) != 0)
            return FAILED;
        printf("%-32s %-12s %-18s ", s.kernel, s.family, s.baseline);
        if (s.verdict != SPEED_NOT_HERE)
            printf("%8.2f %6.2f ", s.ns, s.ratio);
        if (s.at_most > 0)
            printf("%6.2f ", s.at_most);
        printf("%s\n", speed_words[s.verdict]);
        fflush(stdout);
    }
    return DONE;
}

/** A positive number, or 0. */
static double number(const char *text)
{
    char *end;
    const double x = strtod(text, &end);
    return *end == '\0' && x > 0 && x < 1e9 ? x : 0;
}

typedef struct option { // --NAME VALUE, of words or of a number
    const char *name;
    const char **words;
    double *number;
    double least;
} option;

/** Options until one of no name; 0, or -1 where there is something else. */
static int parse(char **argv, const option *options)
{
    for (; argv[0] != NULL; argv += 2) {
        const option *o = options;
        while (o->name != NULL && strcmp(o->name, argv[0]) != 0)
            o++;
        if (o->name == NULL || argv[1] == NULL)
            return -1;
        if (o->words != NULL)
            *o->words = argv[1];
        else if ((*o->number = number(argv[1])) < o->least || *o->number == 0)
            return -1;
    }
    return 0;
}

static int make_kernels(char **argv, const char *command)
{
    bench_settings s = {.out = "report", .command = command};
    double cases = 50000, seconds = 2, seed = 1;
    const option options[] = {{"--out", &s.out, NULL, 0},
                              {"--instructions", &s.instructions, NULL, 0},
                              {"--cases", NULL, &cases, 1},
                              {"--seconds", NULL, &seconds, 0},
                              {"--seed", NULL, &seed, 1},
                              {NULL, NULL, NULL, 0}};
    if (parse(argv, options) != 0)
        return usage();
    s.cases = (int)cases;
    s.seconds = seconds;
    s.seed = (uint64_t)seed;
    if (bench_page(&s) != 0)
        return FAILED;
    printf("%s/kernels.html\n", s.out);
    return DONE;
}

static int make_simulator(char **argv, const char *command)
{
    bench_simulator_settings s = {.out = "report", .command = command};
    double particles = 1e9 - 1, seconds = 0.1;
    const option options[] = {{"--out", &s.out, NULL, 0},
                              {"--instructions", &s.counts, NULL, 0},
                              {"--particles", NULL, &particles, 1},
                              {"--seconds", NULL, &seconds, 0},
                              {NULL, NULL, NULL, 0}};
    if (parse(argv, options) != 0)
        return usage();
    s.particles = (uint32_t)particles;
    s.seconds = seconds;
    if (bench_simulator(&s) != 0)
        return FAILED;
    printf("%s/simulator.html\n", s.out);
    return DONE;
}

int main(int argc, char **argv)
{
    char command[1000] = "bench";
    size_t at = strlen(command);
    for (int k = 1; k < argc && at < sizeof command; k++)
        at += (size_t)snprintf(command + at, sizeof command - at, " %s", argv[k]);
    if (argc > 1 && strcmp(argv[1], "simulator") == 0)
        return make_simulator(argv + 2, command);
    if (argc > 1 && argc < 4 && strcmp(argv[1], "speed") == 0)
        return print_speeds(argc > 2 ? argv[2] : "");
    if (argc == 2 && strcmp(argv[1], "count") == 0)
        return bench_count_all(1) == 0 ? DONE : FAILED;
    return make_kernels(argv + 1, command);
}
