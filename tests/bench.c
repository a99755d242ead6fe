// SPDX-License-Identifier: MIT
/**
 * Speed against error.
 *
 *   bench [OPTION VALUE]...   writes a page
 *         --out FOLDER            into FOLDER
 *         --cases N               from N cases of each family
 *         --seconds S             with S seconds for the costs of a problem
 *         --seed N                of other random inputs
 *         --instructions FILE     with the counts that instructions.sh wrote
 *   bench speed [PART]        prints what was asked of the kernels' speed, and
 *                             what is measured, of kernels whose name holds PART
 *   bench count               calls everything, for instructions.sh to count
 */
#include "bench_count.h"
#include "bench_page.h"
#include "bench_speed.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DONE = 0, FAILED = 1, USAGE = 2 };

static int usage(void)
{
    fputs("usage: bench [--out FOLDER] [--cases N] [--seconds S] [--seed N] "
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

static int parse(int argc, char **argv, bench_settings *s)
{
    for (int k = 1; k < argc; k += 2) {
        const char *value = argv[k + 1]; // NULL after the last
        if (value == NULL)
            return -1;
        if (strcmp(argv[k], "--out") == 0)
            s->out = value;
        else if (strcmp(argv[k], "--instructions") == 0)
            s->instructions = value;
        else if (strcmp(argv[k], "--cases") == 0 && number(value) >= 1)
            s->cases = (int)number(value);
        else if (strcmp(argv[k], "--seconds") == 0 && number(value) > 0)
            s->seconds = number(value);
        else if (strcmp(argv[k], "--seed") == 0 && number(value) >= 1)
            s->seed = (uint64_t)number(value);
        else
            return -1;
    }
    return 0;
}

int main(int argc, char **argv)
{
    char command[1000] = "bench";
    bench_settings s = {.out = "report",
                        .command = command,
                        .cases = 50000,
                        .seconds = 2,
                        .seed = 1};
    if (argc > 1 && argc < 4 && strcmp(argv[1], "speed") == 0)
        return print_speeds(argc > 2 ? argv[2] : "");
    if (argc == 2 && strcmp(argv[1], "count") == 0)
        return bench_count_all(s.seed) == 0 ? DONE : FAILED;
    if (parse(argc, argv, &s) != 0)
        return usage();
    size_t at = strlen(command);
    for (int k = 1; k < argc && at < sizeof command; k++)
        at += (size_t)snprintf(command + at, sizeof command - at, " %s", argv[k]);
    if (bench_page(&s) != 0)
        return FAILED;
    printf("%s/kernels.html\n", s.out);
    return DONE;
}
