// SPDX-License-Identifier: MIT
#include "event_time.h"
#include "exact.h"
#include "path.h"

#ifdef BRINK_DISPATCH
#define A_PAIR   (const double r[3], const double v[3], double sigma)
#define THE_PAIR (r, v, sigma)

BRINK_CHOOSE(double, brink_intersection_time, A_PAIR, THE_PAIR)
BRINK_CHOOSE(double, brink_intersection_time_fast, A_PAIR, THE_PAIR)
BRINK_CHOOSE(double, brink_intersection_time_cr, A_PAIR, THE_PAIR)
BRINK_CHOOSE(double, brink_disjoint_time, A_PAIR, THE_PAIR)
BRINK_CHOOSE(double, brink_disjoint_time_fast, A_PAIR, THE_PAIR)
BRINK_CHOOSE(double, brink_disjoint_time_cr, A_PAIR, THE_PAIR)
BRINK_CHOOSE(double, brink_halfspace_time,
             (const double r[3], const double v[3], const double n[3],
              const double c[3]),
             (r, v, n, c))

#define MANY_PAIRS                                                               \
    (size_t n, const double *rx, const double *ry, const double *rz,             \
     const double *vx, const double *vy, const double *vz, const double *sigma,  \
     double *t)
#define THE_PAIRS (n, rx, ry, rz, vx, vy, vz, sigma, t)

BRINK_CHOOSE_BATCH(brink_intersection_times, MANY_PAIRS, THE_PAIRS)
BRINK_CHOOSE_BATCH(brink_intersection_times_fast, MANY_PAIRS, THE_PAIRS)
BRINK_CHOOSE_BATCH(brink_disjoint_times, MANY_PAIRS, THE_PAIRS)
BRINK_CHOOSE_BATCH(brink_disjoint_times_fast, MANY_PAIRS, THE_PAIRS)
#endif
