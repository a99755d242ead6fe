// SPDX-License-Identifier: MIT
#include "measure.h"
#include <stdlib.h>
#include <string.h>

static int ascending(const void *a, const void *b)
{
    const double *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

/** Wrong answers are worse than any error in ulp. */
static double badness(const verdict *v, int by)
{
    return v->wrong != WRONG_NOT && by == 0 ? (double)INFINITY : v->error[by];
}

/** Keeps `worst` in order, bad[k] being how bad worst[k] is. */
static void rank_case(int i, double how, int *worst, double *bad)
{
    int k = MEASURE_WORST;
    while (k > 0 && (worst[k - 1] < 0 || how > bad[k - 1]))
        k--;
    if (k == MEASURE_WORST || how <= 0)
        return;
    const size_t after = (size_t)(MEASURE_WORST - 1 - k);
    memmove(worst + k + 1, worst + k, after * sizeof *worst);
    memmove(bad + k + 1, bad + k, after * sizeof *bad);
    worst[k] = i;
    bad[k] = how;
}

static int sample_make(sample *s, int n)
{
    *s = (sample){.n = n};
    for (int k = 0; k < MEASURE_WORST; k++)
        s->worst[k] = -1;
    s->error[0] = malloc(MEASURES * (size_t)n * sizeof(double));
    if (s->error[0] == NULL)
        return -1;
    for (int k = 1; k < MEASURES; k++)
        s->error[k] = s->error[0] + (size_t)k * (size_t)n;
    return 0;
}

void measure_free(sample *s)
{
    free(s->error[0]);
    memset(s->error, 0, sizeof s->error);
}

static void judge_all(const problem *p, const method *m, const inputs *in,
                      const truth *truths, const answers *out, sample *s)
{
    judge_of *const judge = rank_is_sign(m->rank) ? p->judge_sign : p->judge;
    const int by = m->bound_measure; // the worst are found by what is promised
    double bad[MEASURE_WORST] = {0};
    for (int i = 0; i < in->n; i++) {
        double y[PROBLEM_OUTPUTS];
        for (int k = 0; k < p->outputs; k++)
            y[k] = out->x[k][i];
        const verdict v = judge(in->rows + (size_t)i * (size_t)in->width,
                                &truths[i], out->n[i], y);
        s->wrong[v.wrong]++;
        for (int k = 0; k < MEASURES; k++)
            if (v.error[k] >= 0)
                s->error[k][s->count[k]++] = badness(&v, k);
        rank_case(i, badness(&v, by), s->worst, bad);
    }
    for (int k = 0; k < MEASURES; k++)
        qsort(s->error[k], (size_t)s->count[k], sizeof(double), ascending);
}

int measure(const problem *p, int first, int methods, int family, int n,
            uint64_t seed, sample *samples)
{
    int failed = 0;
    inputs *in = inputs_make(p, family, n, seed);
    answers *out = answers_make(n);
    truth *truths = malloc((size_t)n * sizeof *truths);
    for (int k = 0; k < methods; k++)
        failed |= sample_make(&samples[k], n);
    failed |= in == NULL || out == NULL || truths == NULL ? -1 : 0;
    if (!failed) {
        for (int i = 0; i < n; i++)
            p->solve(in->rows + (size_t)i * (size_t)in->width, &truths[i]);
        for (int k = 0; k < methods; k++) {
            p->method[first + k].loop(in, out);
            judge_all(p, &p->method[first + k], in, truths, out, &samples[k]);
        }
    }
    free(truths);
    answers_free(out);
    inputs_free(in);
    return failed;
}

int measure_pool(sample *all, int count, const sample *samples)
{
    int n = 0;
    for (int i = 0; i < count; i++)
        n += samples[i].n;
    if (sample_make(all, n) != 0)
        return -1;
    for (int i = 0; i < count; i++) {
        const sample *s = &samples[i];
        for (int k = 0; k < WRONG_KINDS; k++)
            all->wrong[k] += s->wrong[k];
        for (int k = 0; k < MEASURES; k++) {
            memcpy(all->error[k] + all->count[k], s->error[k],
                   (size_t)s->count[k] * sizeof(double));
            all->count[k] += s->count[k];
        }
    }
    for (int k = 0; k < MEASURES; k++)
        qsort(all->error[k], (size_t)all->count[k], sizeof(double), ascending);
    return 0;
}

double measure_quantile(const sample *s, int measure, double q)
{
    const int k = (int)ceil(q * s->count[measure]) - 1;
    return s->count[measure] > 0 ? s->error[measure][k < 0 ? 0 : k] : 0;
}

int measure_wrong(const sample *s)
{
    return s->n - s->wrong[WRONG_NOT];
}
