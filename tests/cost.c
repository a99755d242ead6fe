// SPDX-License-Identifier: MIT
#include "cost.h"
#include <stdlib.h>
#include <time.h>

/** Seconds that a turn should not exceed: short beside a scheduler's, so that
 * some go by undisturbed. */
static const double TURN = 5e-4;

/** The parts of the inputs, and the fewest of one that are still a sample. */
enum { PARTS = 8, FEWEST = 16 };

typedef struct runner {
    loop *loop;
    int n; // inputs a turn
    double best[PARTS];
} runner;

static double seconds_of(loop *l, const inputs *in, answers *out)
{
    struct timespec from, to;
    clock_gettime(CLOCK_MONOTONIC, &from);
    l(in, out);
    clock_gettime(CLOCK_MONOTONIC, &to);
    return (double)(to.tv_sec - from.tv_sec) +
           1e-9 * (double)(to.tv_nsec - from.tv_nsec);
}

/** The first n inputs of a part. */
static inputs part_of(const inputs *in, int part, int n)
{
    const size_t begin = (size_t)part * (size_t)(in->n / PARTS);
    inputs few = *in;
    few.n = n;
    few.rows += begin * (size_t)in->width;
    for (int k = 0; k < in->width; k++)
        few.columns[k] += begin;
    return few;
}

static runner runner_make(loop *l, const inputs *in, answers *out)
{
    runner r = {.loop = l};
    const inputs few = part_of(in, 0, FEWEST);
    l(&few, out); // what is done once only
    const double one = seconds_of(l, &few, out) / FEWEST;
    const int part_size = in->n / PARTS;
    r.n = (int)fmax(FEWEST, fmin(part_size, TURN / one));
    for (int part = 0; part < PARTS; part++)
        r.best[part] = (double)INFINITY;
    return r;
}

int cost_compare(int count, loop *const loops[], const inputs *in, answers *out,
                 double seconds, double *ns)
{
    runner *runners = malloc((size_t)count * sizeof *runners);
    if (runners == NULL)
        return -1;
    for (int k = 0; k < count; k++)
        runners[k] = runner_make(loops[k], in, out);
    double spent = 0;
    for (int turn = 0; turn < PARTS * count || spent < seconds; turn++)
        for (int i = 0; i < count; i++) {
            // Each is first in its turn, and then finds the inputs out of cache.
            const int part = turn % PARTS, k = (i + turn / PARTS) % count;
            const inputs few = part_of(in, part, runners[k].n);
            const double took = seconds_of(loops[k], &few, out);
            runners[k].best[part] = fmin(runners[k].best[part], took);
            spent += took;
        }
    for (int k = 0; k < count; k++) {
        ns[k] = 0;
        for (int part = 0; part < PARTS; part++)
            ns[k] += 1e9 * runners[k].best[part] / (PARTS * runners[k].n);
    }
    free(runners);
    return 0;
}
