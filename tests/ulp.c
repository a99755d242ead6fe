// SPDX-License-Identifier: MIT
/**
 * How good one kernel is on one family of inputs:
 *
 *     ulp KERNEL [FAMILY] [COUNT] [SEED]
 *
 * Every family where none is named.  The worst inputs are printed as hard cases,
 * to be pasted into tests/NAME.wc.  Status: 0, 1 where the kernel did not keep
 * what it promises, 2 for a question that cannot be answered.
 */
#include "measure.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

enum { KEPT, BROKEN, USAGE };

static void list(FILE *out)
{
    fprintf(out, "usage: ulp KERNEL [FAMILY] [COUNT] [SEED]\n");
    for (int i = 0; i < PROBLEMS; i++) {
        const problem *p = problems[i];
        fprintf(out, "\n%s\n", p->title);
        for (int k = 0; k < p->methods; k++)
            fprintf(out, "  %-24s %s\n", p->method[k].name, p->method[k].about);
        fprintf(out, "  on");
        for (int k = 0; k < p->families; k++)
            fprintf(out, " %s", p->family(k));
        fprintf(out, "\n");
    }
}

static void print_wrong(const sample *s)
{
    printf("  wrong %d", measure_wrong(s));
    const char *before = ": ";
    for (int k = WRONG_NOT + 1; k < WRONG_KINDS; k++)
        if (s->wrong[k] > 0) {
            printf("%s%s %d", before, problem_wrong_names[k], s->wrong[k]);
            before = ", ";
        }
    printf("\n");
}

/** The worst cases again: a comment and the numbers, as in a .wc file. */
static void print_worst(const problem *p, const method *m, int family,
                        uint64_t seed, const sample *s)
{
    int last = -1;
    for (int k = 0; k < MEASURE_WORST; k++)
        last = s->worst[k] > last ? s->worst[k] : last;
    inputs *in = inputs_make(p, family, last + 1, seed);
    for (int k = 0; in != NULL && k < MEASURE_WORST && s->worst[k] >= 0; k++) {
        const double *x = in->rows + (size_t)s->worst[k] * (size_t)p->width;
        printf("# %s, %s %d of seed %" PRIu64 "\n", m->name, p->family(family),
               s->worst[k], seed);
        for (int i = 0; i < (p->paste != NULL ? p->pasted : p->width); i++) {
            const int from = p->paste != NULL ? p->paste[i] : i;
            printf("%s%a", i > 0 ? " " : "", from < 0 ? 0 : x[from]);
        }
        printf("\n");
    }
    inputs_free(in);
}

/** Whether its promise was kept. */
static int tell(const problem *p, const method *m, int family, uint64_t seed,
                const sample *s)
{
    printf("%s, %s: %d cases of seed %" PRIu64 "\n", m->name, p->family(family),
           s->n, seed);
    printf("  %d of them with something to measure\n", s->count[0]);
    for (int k = 0; k < MEASURES && p->measure[k] != NULL; k++) {
        printf("  max %.4g   99.9 %% %.4g   median %.4g",
               measure_quantile(s, k, 1), measure_quantile(s, k, 0.999),
               measure_quantile(s, k, 0.5));
        if (m->bound > 0 && m->bound_measure == k)
            printf("   promised %g", m->bound);
        printf("   %s\n", p->measure[k]);
    }
    print_wrong(s);
    print_worst(p, m, family, seed, s);
    return m->bound == 0 || measure_quantile(s, m->bound_measure, 1) <= m->bound;
}

/** A whole number of at least `least`; anything else ends the program. */
static uint64_t number(const char *text, const char *what, uint64_t least)
{
    char *end;
    const unsigned long long x = strtoull(text, &end, 10);
    if (*text < '0' || *text > '9' || *end != '\0' || x < least ||
        (what[0] == 'c' && x > 100000000)) {
        fprintf(stderr, "ulp: this is no %s: %s\n", what, text);
        exit(USAGE);
    }
    return x;
}

int main(int argc, char **argv)
{
    int way = 0, only = -1, status = KEPT;
    if (argc == 1) {
        list(stdout);
        return KEPT;
    }
    if (argc > 5) {
        list(stderr);
        return USAGE;
    }
    const problem *p = problem_of(argv[1], &way);
    if (p == NULL) {
        fprintf(stderr, "ulp: there is no kernel %s; ulp alone lists them\n",
                argv[1]);
        return USAGE;
    }
    if (argc > 2 && (only = problem_family(p, argv[2])) < 0) {
        fprintf(stderr,
                "ulp: there is no family %s of inputs of %s; ulp alone lists "
                "them\n",
                argv[2], argv[1]);
        return USAGE;
    }
    const int count = argc > 3 ? (int)number(argv[3], "count", 1) : 10000;
    const uint64_t seed = argc > 4 ? number(argv[4], "seed", 0) : 1;
    for (int family = 0; family < p->families; family++) {
        sample s;
        if (only >= 0 && only != family)
            continue;
        if (measure(p, way, 1, family, count, seed, &s) != 0) {
            fprintf(stderr, "ulp: no memory for %d cases\n", count);
            return USAGE;
        }
        if (!tell(p, &p->method[way], family, seed, &s))
            status = BROKEN;
        measure_free(&s);
    }
    return status;
}
