// SPDX-License-Identifier: MIT
#include "bench_profile.h"
#include <math.h>
#include <string.h>

/** "WHO WHAT NUMBER", or "WHO PERCENT FUNCTION FILE". */
static void read_fact(bench_profile *p, const char *fact)
{
    char name[10], what[20];
    double number;
    bench_cost c;
    if (sscanf(fact, "%9s %19[a-z] %lf", name, what, &number) == 3) {
        const enum racer who =
            strcmp(name, "brink") == 0 ? RACE_BRINK : RACE_PLAIN;
        *(strcmp(what, "pairs") == 0 ? &p->pairs[who] : &p->instructions[who]) =
            number;
    } else if (p->costs < COSTS && sscanf(fact, "%9s %lf %99s %99s", name,
                                          &c.percent, c.function, c.file) == 4) {
        p->cost[p->costs++] = c;
    }
}

void bench_profile_read(const char *file, const char *key, bench_profile *p)
{
    char line[300];
    const size_t length = strlen(key);
    FILE *in = file == NULL ? NULL : fopen(file, "r");
    p->costs = 0;
    for (int who = 0; who < RACERS; who++)
        p->instructions[who] = p->pairs[who] = (double)NAN;
    while (in != NULL && fgets(line, sizeof line, in) != NULL)
        if (strncmp(line, key, length) == 0 && line[length] == ' ')
            read_fact(p, line + length + 1);
    if (in != NULL)
        fclose(in);
}
