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
#include "event_time_sums.h"

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
                       glance *second)
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
    second(count, &(many){of[0], of[1], of[2], of[3], of[4], of[5], of[6]},
           again);
    for (int k = 0; k < count; k++)
        t[open[k]] = again[k];
}

// --- What is seen at a glance --------------------------------------------------

static void never_meet(int n, const many *p, double *t)
{
    for (int i = 0; i < n; i++) {
        GET_PAIR(p, i);
        rate b = rate_of(r, v);
        int never =
            is_positive(b) | (is_negative(b) & passes_by(chord_of(r, v, sigma)));
        t[i] = never & sigma_in_range(sigma) ? (double)INFINITY : -1;
    }
}

static void meet(int n, const many *p, double *t)
{
    for (int i = 0; i < n; i++) {
        GET_PAIR(p, i);
        sums m = sums_of(r, v, sigma);
        int approaching = is_negative(rate_of(r, v)) & sigma_in_range(sigma);
        int touching = approaching & is_touching(r, sigma);
        double any = meeting_time(&m, dot_of(v, v), approaching);
        double near = meeting_time_touching(&m, dot_rounded(v, v), touching);
        t[i] = near >= 0 ? near : any;
    }
}

static void meet_fast(int n, const many *p, double *t)
{
    for (int i = 0; i < n; i++) {
        GET_PAIR(p, i);
        outline o = outline_of(r, v, sigma);
        int never = (o.b >= 0) | (o.d <= 0);
        double time = (o.c > 0 ? o.c : 0) / (sqrt(o.d > 0 ? o.d : 0) - o.b);
        time = is_too_late(&o, time) ? -o.b / o.a : time;
        time = never ? (double)INFINITY : time;
        t[i] = is_in_range_fast(&o, sigma) ? time : -1;
    }
}

static void part(int n, const many *p, double *t)
{
    for (int i = 0; i < n; i++) {
        GET_PAIR(p, i);
        rate b = rate_of(r, v);
        sums m = sums_of(r, v, sigma);
        int passing = is_far_outside(r, sigma) & is_negative(b) &
                      passes_by(chord_of(r, v, sigma));
        double time = parting_time(&m, dot_rounded(v, v), b, passing);
        t[i] = sigma_in_range(sigma) ? time : -1;
    }
}

static void part_fast(int n, const many *p, double *t)
{
    for (int i = 0; i < n; i++) {
        GET_PAIR(p, i);
        double a = dot_rounded(v, v), b = dot_rounded(r, v);
        double c = dot_rounded(r, r) - sigma * sigma;
        double time = parting_time_fast(a, b, c, chord_of(r, v, sigma));
        int now = is_in_range(b) & (c >= 0) & (c < 0x1p1000);
        time = now ? 0 : time;
        t[i] = sigma_in_range(sigma) ? time : -1;
    }
}

// --- The batches ---------------------------------------------------------------

/** One block after the other; the answers are written when a block has been
 *  read. */
static void in_blocks(size_t n, const many *all, double *t, glance *first,
                      glance *second, scalar *kernel)
{
    for (size_t at = 0; at < n; at += BLOCK) {
        int size = n - at < BLOCK ? (int)(n - at) : BLOCK, open[BLOCK + 1];
        const many block = {all->rx + at,   all->ry + at, all->rz + at,
                            all->vx + at,   all->vy + at, all->vz + at,
                            all->sigma + at};
        const many *p = &block;
        double answer[BLOCK];
        first(size, p, answer);
        int count = find_open(size, answer, open);
        if (second && count > 0)
            look_again(count, open, p, answer, second);
        for (int k = 0; k < count; k++)
            if (answer[open[k]] < 0) {
                GET_PAIR(p, open[k]);
                answer[open[k]] = kernel(r, v, sigma);
            }
        memcpy(t + at, answer, (size_t)size * sizeof *answer);
    }
}

void brink_intersection_times(size_t n, const double *rx, const double *ry,
                              const double *rz, const double *vx,
                              const double *vy, const double *vz,
                              const double *sigma, double *t)
{
    const many all = {rx, ry, rz, vx, vy, vz, sigma};
    in_blocks(n, &all, t, never_meet, meet, brink_intersection_time);
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
    in_blocks(n, &all, t, part, NULL, brink_disjoint_time);
}

void brink_disjoint_times_fast(size_t n, const double *rx, const double *ry,
                               const double *rz, const double *vx,
                               const double *vy, const double *vz,
                               const double *sigma, double *t)
{
    const many all = {rx, ry, rz, vx, vy, vz, sigma};
    in_blocks(n, &all, t, part_fast, NULL, brink_disjoint_time_fast);
}
