// SPDX-License-Identifier: MIT
#include "standing.h"
#include "cost.h"
#include <stdlib.h>

static int by_cost(contest *c, uint64_t seed, double seconds)
{
    const problem *p = c->problem;
    const size_t methods = (size_t)p->methods;
    inputs *in = inputs_make(p, problem_family(p, p->usual), COST_INPUTS, seed);
    answers *out = answers_make(COST_INPUTS);
    double *ns = malloc(methods * sizeof *ns);
    loop **loops = malloc(methods * sizeof *loops);
    int failed = in == NULL || out == NULL || ns == NULL || loops == NULL;
    for (size_t k = 0; !failed && k < methods; k++)
        loops[k] = p->method[k].loop;
    failed = failed || cost_compare(p->methods, loops, in, out, seconds, ns) != 0;
    for (size_t k = 0; !failed && k < methods; k++) {
        c->of[k].ns = ns[k];
        c->of[k].ratio = ns[k] / ns[0];
    }
    free(loops);
    free(ns);
    answers_free(out);
    inputs_free(in);
    return failed ? -1 : 0;
}

static int by_error(contest *c, int cases, uint64_t seed)
{
    const problem *p = c->problem;
    sample *samples = malloc((size_t)p->methods * sizeof *samples);
    int failed = samples == NULL;
    for (int f = 0; !failed && f < p->families; f++) {
        failed = measure(p, 0, p->methods, f, cases, seed, samples) != 0;
        for (int k = 0; !failed && k < p->methods; k++)
            c->of[k].family[f] = samples[k];
    }
    for (int k = 0; !failed && k < p->methods; k++) {
        failed = measure_pool(&c->of[k].all, p->families, c->of[k].family) != 0;
        for (int f = 0; f < p->families; f++) // what is told of them are counts
            measure_free(&c->of[k].family[f]);
    }
    free(samples);
    return failed ? -1 : 0;
}

int contest_hold(contest *c, const problem *p, int cases, uint64_t seed,
                 double seconds)
{
    *c = (contest){p, calloc((size_t)p->methods, sizeof *c->of)};
    for (int k = 0; c->of != NULL && k < p->methods; k++) {
        c->of[k].method = &p->method[k];
        c->of[k].family = calloc((size_t)p->families, sizeof *c->of[k].family);
        if (c->of[k].family == NULL)
            return -1;
    }
    return c->of == NULL || by_error(c, cases, seed) != 0 ||
                   by_cost(c, seed, seconds) != 0
               ? -1
               : 0;
}

void contest_free(contest *c)
{
    for (int k = 0; c->of != NULL && k < c->problem->methods; k++) {
        for (int f = 0; c->of[k].family != NULL && f < c->problem->families; f++)
            measure_free(&c->of[k].family[f]);
        measure_free(&c->of[k].all);
        free(c->of[k].family);
    }
    free(c->of);
}

double standing_wrong(const standing *s)
{
    return (double)measure_wrong(&s->all) / s->all.n;
}

double standing_max(const standing *s, int measure)
{
    return measure_quantile(&s->all, measure, 1);
}

double standing_above(const standing *s, int measure, double x)
{
    const sample *all = &s->all;
    int low = 0, high = all->count[measure]; // those before low are <= x
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (all->error[measure][middle] <= x)
            low = middle + 1;
        else
            high = middle;
    }
    return all->count[measure] == 0
               ? 0
               : (double)(all->count[measure] - low) / all->count[measure];
}
