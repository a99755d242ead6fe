// SPDX-License-Identifier: MIT
/**
 * Many pairs at once: what can be said of all of them in the same way is said in
 * loops that the compiler makes vectors of, the doubtful are gathered and looked
 * at again, and what then is left goes through the scalar kernel, one by one.
 * All of it is built of the scalar kernels' parts, so the answers are theirs bit
 * for bit.
 */
#include "path.h"

#include "event_time.h"
#include "event_time_fast.h"
#include "event_time_meeting.h"

enum { BLOCK = 128, GROUP = 8 };

/** Pairs from a structure of arrays. */
typedef struct many {
    const double *rx, *ry, *rz, *vx, *vy, *vz, *sigma;
} many;

#define GET_PAIR(p, i)                                                           \
    const double r[3] = {p->rx[i], p->ry[i], p->rz[i]};                          \
    const double v[3] = {p->vx[i], p->vy[i], p->vz[i]};                          \
    const double sigma = p->sigma[i]

typedef double scalar(const double r[3], const double v[3], double sigma);

/** A block's times, or -1 for those to be looked at again. */
typedef void glance(int n, const many *p, double *t);

/** Which times are -1; the number of them.  Groups without one are passed over
 *  at a look: t has BLOCK places, those from n on are written to. */
static int find_open(int n, double *t, int *open)
{
    int count = 0;
    for (int i = n; i % GROUP != 0; i++)
        t[i] = 0;
    for (int at = 0; at < n; at += GROUP) {
        uint64_t signs = 0;
        for (int k = 0; k < GROUP; k++)
            signs |= bits_of(t[at + k]);
        if (signs >> 63 == 0)
            continue;
        for (int i = at; i < at + GROUP; i++) {
            open[count] = i;
            count += t[i] < 0;
        }
    }
    return count;
}

/** Looks once more at those still open, gathered so that they lie together. */
static void look_again(int count, const int *open, const many *p, double *t,
                       glance *look)
{
    double of[7][BLOCK], again[BLOCK];
    for (int k = 0; k < count; k++) {
        int i = open[k];
        of[0][k] = p->rx[i];
        of[1][k] = p->ry[i];
        of[2][k] = p->rz[i];
        of[3][k] = p->vx[i];
        of[4][k] = p->vy[i];
        of[5][k] = p->vz[i];
        of[6][k] = p->sigma[i];
    }
    look(count, &(many){of[0], of[1], of[2], of[3], of[4], of[5], of[6]}, again);
    for (int k = 0; k < count; k++)
        t[open[k]] = again[k];
}

// --- What is seen at a glance --------------------------------------------------

static void miss(int n, const many *p, double *t)
{
    for (int i = 0; i < n; i++) {
        GET_PAIR(p, i);
        t[i] = is_certain_to_miss(r, v, sigma) ? (double)INFINITY : -1;
    }
}

/** The time that a verdict means, or -1. */
BRINK_INLINE double time_if_certain(const meeting *m)
{
    double t = m->later ? time_of_meeting(m) : -1;
    t = m->now ? 0 : t;
    return m->never ? (double)INFINITY : t;
}

static void meet(int n, const many *p, double *t)
{
    for (int i = 0; i < n; i++) {
        GET_PAIR(p, i);
        sums m = sums_of(r, v, sigma);
        meeting told = meeting_of(&m);
        double time = time_if_certain(&told);
        t[i] = sigma_in_range(sigma) ? time : -1;
    }
}

static void meet_fast(int n, const many *p, double *t)
{
    for (int i = 0; i < n; i++) {
        GET_PAIR(p, i);
        outline o = outline_of(r, v, sigma);
        double sum = o.b + sqrt(fabs(o.minus_d));
        double time = fabs(sum < 0 ? sum : 0) / o.a;
        int never = (bits_of(o.b) & bits_of(o.minus_d)) >> 63 == 0;
        time = never ? (double)INFINITY : time;
        t[i] = is_in_range_fast(&o, sigma) ? time : -1;
    }
}

static void pass(int n, const many *p, double *t)
{
    for (int i = 0; i < n; i++) {
        GET_PAIR(p, i);
        double rr = dot_rounded(r, r), ss = sigma * sigma;
        double a = dot_rounded(v, v), b = dot_closely(r, v), c = rr - ss;
        int certain = is_far(rr, ss) & passes(a, b, c) &
                      is_passing_known(a, b, c) & (sigma > 0x1p-450);
        t[i] = certain ? passing_time(a, b) : -1;
    }
}

/** What is chosen is chosen one by one: so GCC makes vectors of it. */
static void part(int n, const many *p, double *t)
{
    for (int i = 0; i < n; i++) {
        GET_PAIR(p, i);
        double a = dot_rounded(v, v), ss = sigma * sigma;
        sums m = sums_of(r, v, sigma);
        near_sums k = near_sums_of((two_dots){m.b, dot_of(r, r)}, sigma);
        discriminant far = discriminant_of(&m);
        discriminant near = discriminant_near(&k, a);
        int far_certain = far.certain & sigma_in_range(sigma);
        int near_certain = near.certain & are_in_range(a, ss) & (sigma > 0);
        int is_it_far = is_far(dot_rounded(r, r), ss);
        int certain = is_it_far ? far_certain : near_certain;
        double d = is_it_far ? far.d : near.d;
        double time = later_root(a, k.b, k.c, sqrt(fabs(d)));
        t[i] = certain ? time : -1;
    }
}

static void pass_fast(int n, const many *p, double *t)
{
    for (int i = 0; i < n; i++) {
        GET_PAIR(p, i);
        double a = dot_rounded(v, v), b = dot_rounded(r, v);
        double rr = dot_rounded(r, r), ss = sigma * sigma;
        int certain = are_in_range(a, rr + ss) & (sigma >= 0) & is_far(rr, ss) &
                      passes(a, b, rr - ss);
        t[i] = certain ? passing_time(a, b) : -1;
    }
}

/** Passes over those that pass_fast knows, although it would tell the same time:
 *  so as to come second where they are many. */
static void part_fast(int n, const many *p, double *t)
{
    for (int i = 0; i < n; i++) {
        GET_PAIR(p, i);
        double a = dot_rounded(v, v), b = dot_rounded(r, v);
        double rr = dot_rounded(r, r), ss = sigma * sigma, c = rr - ss;
        int far = is_far(rr, ss);
        int certain =
            are_in_range(a, rr + ss) & (sigma >= 0) & !(far & passes(a, b, c));
        double minus_d = outline_of(r, v, sigma).minus_d;
        double d = far ? -minus_d : fma(b, b, -a * c);
        double time = later_root(a, b, c, root_of_chord(d));
        t[i] = certain ? time : -1;
    }
}

// --- The batches ---------------------------------------------------------------

/** One block after the other; the answers are written when a block has been
 *  read.  That glance comes first which had more to say of the block before. */
static void in_blocks(size_t n, const many *all, double *t, glance *first,
                      glance *second, scalar *kernel)
{
    for (size_t at = 0; at < n; at += BLOCK) {
        int size = n - at < BLOCK ? (int)(n - at) : BLOCK, open[BLOCK + 1];
        const many block = {all->rx + at,   all->ry + at, all->rz + at,
                            all->vx + at,   all->vy + at, all->vz + at,
                            all->sigma + at};
        const many *p = &block;
        double found[BLOCK];
        first(size, p, found);
        int count = find_open(size, found, open);
        if (second && count > 0)
            look_again(count, open, p, found, second);
        for (int k = 0; k < count; k++)
            if (found[open[k]] < 0) {
                GET_PAIR(p, open[k]);
                found[open[k]] = kernel(r, v, sigma);
            }
        memcpy(t + at, found, (size_t)size * sizeof *found);
        if (second && 2 * count > size) {
            glance *better = second;
            second = first;
            first = better;
        }
    }
}

void brink_intersection_times(size_t n, const double *rx, const double *ry,
                              const double *rz, const double *vx,
                              const double *vy, const double *vz,
                              const double *sigma, double *t)
{
    const many all = {rx, ry, rz, vx, vy, vz, sigma};
    in_blocks(n, &all, t, miss, meet, brink_intersection_time);
}

void brink_intersection_times_fast(size_t n, const double *rx, const double *ry,
                                   const double *rz, const double *vx,
                                   const double *vy, const double *vz,
                                   const double *sigma, double *t)
{
    const many all = {rx, ry, rz, vx, vy, vz, sigma};
    in_blocks(n, &all, t, meet_fast, NULL, brink_intersection_time_fast);
}

void brink_disjoint_times(size_t n, const double *rx, const double *ry,
                          const double *rz, const double *vx, const double *vy,
                          const double *vz, const double *sigma, double *t)
{
    const many all = {rx, ry, rz, vx, vy, vz, sigma};
    in_blocks(n, &all, t, pass, part, brink_disjoint_time);
}

void brink_disjoint_times_fast(size_t n, const double *rx, const double *ry,
                               const double *rz, const double *vx,
                               const double *vy, const double *vz,
                               const double *sigma, double *t)
{
    const many all = {rx, ry, rz, vx, vy, vz, sigma};
    in_blocks(n, &all, t, pass_fast, part_fast, brink_disjoint_time_fast);
}
