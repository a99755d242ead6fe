// SPDX-License-Identifier: MIT
#include "paths.h"

#include "event_time.h"

#define BATCH(name, kernel)                                                      \
    void name(size_t n, const double *rx, const double *ry, const double *rz,    \
              const double *vx, const double *vy, const double *vz,              \
              const double *sigma, double *t)                                    \
    {                                                                            \
        for (size_t i = 0; i < n; i++) {                                         \
            const double r[3] = {rx[i], ry[i], rz[i]},                           \
                         v[3] = {vx[i], vy[i], vz[i]};                           \
            t[i] = kernel(r, v, sigma[i]);                                       \
        }                                                                        \
    }

BATCH(brink_intersection_times, brink_intersection_time)
BATCH(brink_intersection_times_fast, brink_intersection_time_fast)
BATCH(brink_disjoint_times, brink_disjoint_time)
BATCH(brink_disjoint_times_fast, brink_disjoint_time_fast)
