// SPDX-License-Identifier: MIT
#ifndef TESTS_OVERLAP_PATHS_H
#define TESTS_OVERLAP_PATHS_H
/** The overlap functions by the names that they have on each path. */
#include "pairs.h"
#include "paths.h"
#include <brink/overlap.h>

enum { QUANTITIES = 10 };

typedef double of_ball(const double r[3], double sigma);
typedef double of_two(const double r[3], const double v[3]);
typedef double of_path(const double r[3], const double v[3], double sigma,
                       double t);
typedef int sign_of_path(const double r[3], const double v[3], double sigma,
                         double t);
typedef double of_rate(const double r[3], const double v[3], double t);
typedef int sign_of_rate(const double r[3], const double v[3], double t);
typedef double of_plane(const double r[3], const double n[3], const double c[3]);
typedef double of_plane_at(const double r[3], const double v[3],
                           const double n[3], const double c[3], double t);
typedef int sign_of_plane_at(const double r[3], const double v[3],
                             const double n[3], const double c[3], double t);

PATHS_OF(of_ball, brink_ball_overlap)
PATHS_OF(of_two, brink_ball_overlap_rate)
PATHS_OF(of_path, brink_ball_overlap_at)
PATHS_OF(sign_of_path, brink_ball_overlap_sign_at)
PATHS_OF(of_rate, brink_ball_overlap_rate_at)
PATHS_OF(sign_of_rate, brink_ball_overlap_rate_sign_at)
PATHS_OF(of_plane, brink_halfspace_overlap)
PATHS_OF(of_two, brink_halfspace_overlap_rate)
PATHS_OF(of_plane_at, brink_halfspace_overlap_at)
PATHS_OF(sign_of_plane_at, brink_halfspace_overlap_sign_at)

static of_ball *const ball[] = PATHS(brink_ball_overlap);
static of_two *const rate[] = PATHS(brink_ball_overlap_rate);
static of_path *const ball_at[] = PATHS(brink_ball_overlap_at);
static sign_of_path *const sign_at[] = PATHS(brink_ball_overlap_sign_at);
static of_rate *const rate_at[] = PATHS(brink_ball_overlap_rate_at);
static sign_of_rate *const rate_sign_at[] =
    PATHS(brink_ball_overlap_rate_sign_at);
static of_plane *const plane[] = PATHS(brink_halfspace_overlap);
static of_two *const plane_rate[] = PATHS(brink_halfspace_overlap_rate);
static of_plane_at *const plane_at[] = PATHS(brink_halfspace_overlap_at);
static sign_of_plane_at *const plane_sign_at[] =
    PATHS(brink_halfspace_overlap_sign_at);

/** All of them, of a pair p at time t, and of its first at a plane q. */
static inline void quantities(int path, const pair_case *p, const pair_case *q,
                              double t, double y[QUANTITIES])
{
    y[0] = ball[path](p->r, p->sigma);
    y[1] = rate[path](p->r, p->v);
    y[2] = ball_at[path](p->r, p->v, p->sigma, t);
    y[3] = sign_at[path](p->r, p->v, p->sigma, t);
    y[4] = rate_at[path](p->r, p->v, t);
    y[5] = rate_sign_at[path](p->r, p->v, t);
    y[6] = plane[path](p->r, q->v, q->r);
    y[7] = plane_rate[path](p->v, q->v);
    y[8] = plane_at[path](p->r, p->v, q->v, q->r, t);
    y[9] = plane_sign_at[path](p->r, p->v, q->v, q->r, t);
}
#endif
