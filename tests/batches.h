// SPDX-License-Identifier: MIT
#ifndef TESTS_BATCHES_H
#define TESTS_BATCHES_H
/** The batches of the event times beside their scalar kernels: as they are
 * called, and on each path by its name. */
#include "paths.h"
#include <brink/event_time.h>

typedef void batch(size_t n, const double *rx, const double *ry, const double *rz,
                   const double *vx, const double *vy, const double *vz,
                   const double *sigma, double *t);
typedef double scalar(const double r[3], const double v[3], double sigma);

PATHS_OF(batch, brink_intersection_times)
PATHS_OF(batch, brink_intersection_times_fast)
PATHS_OF(batch, brink_disjoint_times)
PATHS_OF(batch, brink_disjoint_times_fast)

/** Ways to call one: way 0 as it is called, then the paths. */
enum { WAYS = 1 + PATHS_IN_ALL };

static const struct tier {
    const char *name;
    batch *as_called, *many[PATHS_IN_ALL];
    scalar *one;
} tiers[] = {
    {"intersection", brink_intersection_times, PATHS(brink_intersection_times),
     brink_intersection_time},
    {"intersection_fast", brink_intersection_times_fast,
     PATHS(brink_intersection_times_fast), brink_intersection_time_fast},
    {"disjoint", brink_disjoint_times, PATHS(brink_disjoint_times),
     brink_disjoint_time},
    {"disjoint_fast", brink_disjoint_times_fast, PATHS(brink_disjoint_times_fast),
     brink_disjoint_time_fast},
};
enum { TIERS = sizeof tiers / sizeof *tiers };

static inline int has_way(int way)
{
    return way == 0 || can_try(way - 1);
}

static inline batch *batch_of(const struct tier *tier, int way)
{
    return way == 0 ? tier->as_called : tier->many[way - 1];
}
#endif
