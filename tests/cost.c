// SPDX-License-Identifier: MIT
#include "cost.h"
#include <stdlib.h>
#include <time.h>

/** Seconds that a turn should not exceed: short beside a scheduler's, so that some go
 * by undisturbed. */
static const double TURN = 3e-4;

/** And the fewest inputs that are still a sample. */
enum { FEWEST = 16 };

static double seconds_of(loop *l, const inputs *in, answers *out)
{
    struct timespec from, to;
    clock_gettime(CLOCK_MONOTONIC, &from);
    l(in, out);
    clock_gettime(CLOCK_MONOTONIC, &to);
    return (double)(to.tv_sec - from.tv_sec) +
           1e-9 * (double)(to.tv_nsec - from.tv_nsec);
}

/** So many of the inputs as go into a turn. */
static inputs share_of(loop *l, const inputs *in, answers *out)
{
    inputs few = *in;
    few.n = FEWEST < in->n ? FEWEST : in->n;
    l(&few, out); // what is done once only
    const double one = seconds_of(l, &few, out) / few.n;
    few.n = (int)fmax(few.n, fmin(in->n, TURN / one));
    return few;
}

void cost_compare(int count, loop *const loops[], const inputs *in, answers *out,
                  double seconds, double *ns)
{
    inputs *share = malloc((size_t)count * sizeof *share);
    for (int k = 0; k < count; k++)
        ns[k] = (double)INFINITY;
    if (share == NULL)
        return;
    for (int k = 0; k < count; k++)
        share[k] = share_of(loops[k], in, out);
    for (double spent = 0; spent < seconds;)
        for (int k = 0; k < count; k++) {
            const double turn = seconds_of(loops[k], &share[k], out);
            ns[k] = fmin(ns[k], 1e9 * turn / share[k].n);
            spent += turn;
        }
    free(share);
}
