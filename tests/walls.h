// SPDX-License-Identifier: MIT
#ifndef TESTS_WALLS_H
#define TESTS_WALLS_H
/** Families of particles and walls, beside those made of two pairs. */
#include "pair.h"

typedef struct wall_case {
    double r[3], v[3], n[3], c[3];
} wall_case;

/** A vector across n but for 2^-45 to 2^-38 of it, of which sums that carry their
 *  errors know 2^-62 or so: little more than a double's digits. */
static inline void make_across(stream *s, const double n[3], double x[3])
{
    double along = stream_scaled(s, -45, -38), nn = 0;
    fill_normal(s, x, 1);
    for (int i = 0; i < 3; i++)
        nn += n[i] * n[i];
    for (int i = 0; i < 3; i++)
        along -= n[i] * x[i] / nn;
    for (int i = 0; i < 3; i++)
        x[i] += along * n[i];
}

/** Of f = n.(r - c), of its rate n.v, or of both next to nothing is left. */
static inline void wall_slanting(stream *s, wall_case *w)
{
    const int which = stream_int(s, 0, 2);
    fill_normal(s, w->n, 1);
    fill_normal(s, w->c, 1);
    fill_normal(s, w->r, 1);
    fill_normal(s, w->v, 1);
    if (which != 0)
        make_across(s, w->n, w->v);
    if (which != 1)
        make_across(s, w->n, w->r);
    for (int i = 0; i < 3; i++)
        w->r[i] += w->c[i];
}
#endif
