// SPDX-License-Identifier: MIT
#ifndef BRINK_EVENT_TIME_MEETING_H
#define BRINK_EVENT_TIME_MEETING_H
/**
 * When a pair meets, for the intersection times; not installed.
 *
 * Most pairs part or pass by, which a filter tells.  The others go one way
 * without a branch, as nobody can foresee which of them meet.  Names and bounds
 * as in event_time_sums.h.
 */
#include "event_time_sums.h"

/** Whether a pair is certain never to meet: it parts, or is far and passes.  b is
 *  off by 3u P, and P^2 <= a r.r. */
BRINK_INLINE int is_certain_to_miss(const double r[3], const double v[3],
                                    double sigma)
{
    double a = dot_rounded(v, v), b = dot_rounded(r, v);
    double rr = dot_rounded(r, r), ss = sigma * sigma;
    int parts = (b > 0) & (b * b > 0x1p-100 * (a * rr));
    int misses = parts | (is_far(rr, ss) & passes(a, b, rr - ss));
    return misses & are_in_range(a, rr) & is_radius(sigma);
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

/** The time of one that meets later, within 8 ulp: c is off by 1u + 2.85u;
 *  sqrt(d), at most half of the sum, by 1.2u + 1u, and b by 1u; sum and quotient
 *  are rounded: 3.85u + (2.2u + 1u) / 2 + 2u < 8u, and 8u are at most 8 ulp. */
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
