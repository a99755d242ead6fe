// SPDX-License-Identifier: MIT
#include "run_batch.h"
#include <brink/event_time.h>

// The correctly rounded times have no batches: one after the other.
#define BATCH_OF(name)                                                           \
    static void each_##name(size_t n, const double *rx, const double *ry,        \
                            const double *rz, const double *vx,                  \
                            const double *vy, const double *vz,                  \
                            const double *sigma, double *t)                      \
    {                                                                            \
        for (size_t k = 0; k < n; k++) {                                         \
            const double r[3] = {rx[k], ry[k], rz[k]};                           \
            const double v[3] = {vx[k], vy[k], vz[k]};                           \
            t[k] = brink_##name(r, v, sigma[k]);                                 \
        }                                                                        \
    }

BATCH_OF(intersection_time_cr)
BATCH_OF(disjoint_time_cr)

const struct brink_batch_tier brink_batch_tiers[] = {
    [BRINK_TIER_FAST] = {brink_intersection_times_fast,
                         brink_disjoint_times_fast},
    [BRINK_TIER_PLAIN] = {brink_intersection_times, brink_disjoint_times},
    [BRINK_TIER_CR] = {each_intersection_time_cr, each_disjoint_time_cr},
};
