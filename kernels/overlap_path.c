// SPDX-License-Identifier: MIT
#include "exact.h"
#include "overlap.h"
#include "path.h"

#ifdef BRINK_DISPATCH
#define A_PAIR     (const double r[3], const double v[3])
#define THE_PAIR   (r, v)
#define A_SPHERE   (const double r[3], double sigma)
#define THE_SPHERE (r, sigma)
#define A_PLANE    (const double r[3], const double n[3], const double c[3])
#define THE_PLANE  (r, n, c)
#define SPHERE_AT  (const double r[3], const double v[3], double sigma, double t)
#define PAIR_AT    (const double r[3], const double v[3], double t)
#define PLANE_AT                                                                 \
    (const double r[3], const double v[3], const double n[3], const double c[3], \
     double t)

BRINK_CHOOSE(double, brink_ball_overlap, A_SPHERE, THE_SPHERE)
BRINK_CHOOSE(double, brink_ball_overlap_rate, A_PAIR, THE_PAIR)
BRINK_CHOOSE(double, brink_ball_overlap_at, SPHERE_AT, (r, v, sigma, t))
BRINK_CHOOSE(int, brink_ball_overlap_sign_at, SPHERE_AT, (r, v, sigma, t))
BRINK_CHOOSE(double, brink_ball_overlap_rate_at, PAIR_AT, (r, v, t))
BRINK_CHOOSE(int, brink_ball_overlap_rate_sign_at, PAIR_AT, (r, v, t))
BRINK_CHOOSE(double, brink_halfspace_overlap, A_PLANE, THE_PLANE)
BRINK_CHOOSE(double, brink_halfspace_overlap_rate,
             (const double v[3], const double n[3]), (v, n))
BRINK_CHOOSE(double, brink_halfspace_overlap_at, PLANE_AT, (r, v, n, c, t))
BRINK_CHOOSE(int, brink_halfspace_overlap_sign_at, PLANE_AT, (r, v, n, c, t))
#endif
