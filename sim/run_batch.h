// SPDX-License-Identifier: MIT
#ifndef BRINK_RUN_BATCH_H
#define BRINK_RUN_BATCH_H
/**
 * Pairs and the steps they could meet, laid out as the kernels' batches want
 * them, and those batches by tier.
 */
#include "run.h"

#define BRINK_BATCH BRINK_HANDFUL

typedef struct brink_batch {
    int count;
    uint32_t who[BRINK_BATCH]; // the other one of the pair
    double r[3][BRINK_BATCH], v[3][BRINK_BATCH];
    double step[BRINK_BATCH]; // its distance
} brink_batch;

/** Adds a pair to a batch that is not full; whether it is now. */
static inline int brink_batch_add(brink_batch *b, uint32_t who, const double r[3],
                                  const double v[3], double step)
{
    const int n = b->count++;
    b->who[n] = who;
    for (int a = 0; a < 3; a++) {
        b->r[a][n] = r[a];
        b->v[a][n] = v[a];
    }
    b->step[n] = step;
    return b->count == BRINK_BATCH;
}

typedef void brink_batch_times(size_t n, const double *rx, const double *ry,
                               const double *rz, const double *vx,
                               const double *vy, const double *vz,
                               const double *sigma, double *t);

/** By enum brink_tier. */
extern const struct brink_batch_tier {
    brink_batch_times *intersection, *disjoint;
} brink_batch_tiers[];
#endif
