// SPDX-License-Identifier: MIT
#ifndef BRINK_EVENT_TIME_MEETING_H
#define BRINK_EVENT_TIME_MEETING_H
/**
 * When a pair meets, for the intersection times; not installed.
 *
 * Of pairs that are remote nearly all part or pass by, which a filter tells; all
 * others go one way without a branch, as nobody can foresee which of them
 * approach and which of these meet.  Names and bounds as in event_time_sums.h.
 */
#include "event_time_sums.h"

/** Whether a pair is remote and certain never to meet. */
BRINK_INLINE int is_certain_to_miss(const double r[3], const double v[3],
                                    double sigma)
{
    double a = dot_rounded(v, v), b = dot_rounded(r, v);
    double rr = dot_rounded(r, r), c = rr - sigma * sigma;
    return passes(a, b, c) & are_in_range(a, rr) & (sigma >= 0);
}

/** More than two diameters apart: far, and with few that meet. */
BRINK_INLINE int is_remote(const double r[3], double sigma)
{
    return dot_rounded(r, r) > 4 * (sigma * sigma);
}

/** A verdict on a pair, each part of it 1 only where it is certain. */
typedef struct meeting {
    double b, c, d;
    int never, now, later;
} meeting;

/**
 * b is off by 7u^2 P and P^2 <= Q: where b^2 > 2^-200 Q its sign is certain.  If
 * d < -2^-90 Q the pair passes by, wherever it comes from; if d is certain and c
 * known it comes from outside, and meets if b < 0.
 */
BRINK_INLINE meeting meeting_of(const sums *m)
{
    discriminant d = discriminant_of(m);
    double b = sum_of(m->b), c = sum_of(m->c), q = m->a.hi * m->size;
    int is_b_certain = b * b > fma(0x1p-200, q, 0x1p-900);
    int passes_by = (m->a.hi > 0x1p-900) & (d.d < -fma(0x1p-90, q, 0x1p-900));
    int never = passes_by + ((b > 0) & is_b_certain);
    int now = (b < 0) & is_b_certain & (c < -2 * m->c_error);
    int later = (b < 0) & d.certain & is_known(c, m->c_error);
    return (meeting){b, c, d.d, never, now, later};
}

/**
 * The same of a pair that is no more than two diameters apart, with less: d = b^2
 * - a c, as it is, is off by 7u b^2 + 5u |d|, and a c_error.  a may be off by 3u,
 * c by 1u + k, b by 1u; b^2, d, its root, the sum and the quotient are rounded.
 * With w = sqrt(d) / (sqrt(d) - b), which is at most 1/2, the time is off by
 *
 *     [1 + k + 3 (1 - 2w) + (1 - w)^2 + 2 (1 - w)] / 2w  +  w / 2 + w + 2
 *
 * in u, for c, a, b^2, b, d, its root, and the last two roundings:
 *
 *     d > b^2 / 3, w > 0.366, k < 0.36:    at most 7.8
 *     d > 0.95 b^2, w > 0.493, k < 2.85:   at most 7.97
 *
 * What b is off by, 7u^2 P, is less than 2^-25 u of it there, as b^2 > a c.
 */
BRINK_INLINE meeting meeting_near(const near_sums *m, double a)
{
    double b = m->b, c = m->c, bb = b * b, d = fma(-a, c, bb);
    int is_b_certain = bb > 0x1p-200 * a * m->size;
    int passes_by = d < -fma(0x1p-48, bb, 2 * a * m->c_error);
    int never = passes_by + ((b > 0) & is_b_certain);
    int now = (b < 0) & is_b_certain & (c < -2 * m->c_error);
    int slanting = (3 * d > bb) & is_known(c, 8 * m->c_error);
    int head_on = (d > 0.95 * bb) & is_known(c, m->c_error);
    int later = (b < 0) & (slanting + head_on != 0);
    return (meeting){b, c, d, never, now, later};
}

/** The time of one that meets later, within 8 ulp.  By meeting_of: c is off by 1u
 *  + 2.85u; sqrt(d), at most half of the sum, by 1.2u + 1u, and b by 1u; sum and
 *  quotient are rounded: 3.85u + (2.2u + 1u) / 2 + 2u < 8u, and 8u are at most 8
 *  ulp. */
BRINK_INLINE double time_of_meeting(const meeting *m)
{
    return m->c / (sqrt(fabs(m->d)) - m->b);
}

/** Whether it is; `|` would be branches. */
BRINK_INLINE int is_certain(const meeting *m)
{
    return m->never + m->now + m->later != 0;
}
#endif
