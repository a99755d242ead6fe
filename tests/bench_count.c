// SPDX-License-Identifier: MIT
#include "bench_count.h"
#include <stdio.h>
#include <string.h>
#ifdef __has_include
#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#endif
#endif
#ifndef CALLGRIND_TOGGLE_COLLECT // nothing counts without it
#define CALLGRIND_TOGGLE_COLLECT
#define CALLGRIND_DUMP_STATS_AT(name) (void)(name)
#endif

enum { CALLS = 4096, CALLS_OF_SLOW = 32 };

static void count(const method *m, const inputs *in, answers *out)
{
    char name[100];
    const int slow = m->rank == RANK_WIDE || m->rank == RANK_JUDGE;
    inputs few = *in;
    few.n = slow ? CALLS_OF_SLOW : CALLS;
    m->loop(&few, out); // what is done once only
    CALLGRIND_TOGGLE_COLLECT;
    m->loop(&few, out);
    CALLGRIND_TOGGLE_COLLECT;
    snprintf(name, sizeof name, "%s %d", m->name, few.n);
    CALLGRIND_DUMP_STATS_AT(name);
}

int bench_count_all(uint64_t seed)
{
    int failed = 0;
    for (int i = 0; i < PROBLEMS && !failed; i++) {
        const problem *p = problems[i];
        inputs *in = inputs_make(p, problem_family(p, p->usual), CALLS, seed);
        answers *out = answers_make(CALLS);
        failed = in == NULL || out == NULL;
        for (int k = 0; k < p->methods && !failed; k++)
            count(&p->method[k], in, out);
        answers_free(out);
        inputs_free(in);
    }
    return failed ? -1 : 0;
}

void bench_count_read(const char *file, const problem *p, double *instructions)
{
    char name[100];
    double count_of;
    FILE *in = file == NULL ? NULL : fopen(file, "r");
    for (int k = 0; k < p->methods; k++)
        instructions[k] = (double)NAN;
    while (in != NULL && fscanf(in, "%99s %lf", name, &count_of) == 2)
        for (int k = 0; k < p->methods; k++)
            if (strcmp(name, p->method[k].name) == 0)
                instructions[k] = count_of;
    if (in != NULL)
        fclose(in);
}
