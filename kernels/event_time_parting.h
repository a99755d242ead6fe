// SPDX-License-Identifier: MIT
#ifndef BRINK_EVENT_TIME_PARTING_H
#define BRINK_EVENT_TIME_PARTING_H
/**
 * When a pair parts, for the disjoint times; not installed.
 *
 * A pair is far or near, which a processor can foresee: of one family pairs are
 * mostly the one or the other.  What it cannot foresee, whether they approach and
 * whether they are inside, is no branch here.
 *
 *     far   most part already or pass by: no more than b is needed of these, and
 *           that c is much.  The others need d as it is known best
 *     near  or inside: d = b^2 - a c loses nothing that matters
 *
 * Names and bounds as in event_time_sums.h.
 */
#include "event_time_sums.h"

/** first ? x : y, never a branch. */
BRINK_INLINE double choose(int first, double x, double y)
{
    uint64_t mask = -(uint64_t)first;
    return double_of((bits_of(x) & mask) | (bits_of(y) & ~mask));
}

/** (root - b) / a for root^2 = b^2 - a c or, where that cancels, its equal -c /
 *  (root + b); 0 where that is past.  a is not 0. */
BRINK_INLINE double later_root(double a, double b, double c, double root)
{
    double sum = root + fabs(b), depth = 0.5 * twice_below(c);
    return choose(b > 0, depth, sum) / choose(b > 0, sum, a);
}

// --- Far -----------------------------------------------------------------------

/** The moment of closest approach, max(0, -b / a). */
BRINK_INLINE double passing_time(double a, double b)
{
    return 0.5 * twice_below(b) / a;
}

/** x.y, error <= 2u |x.y| + 8u^2 sum |x_i y_i|: as dot_of, without what the last
 *  addition of products loses, which is at most u of its result. */
BRINK_INLINE double dot_closely(const double x[3], const double y[3])
{
    dd p = two_prod(x[0], y[0]), q = two_prod(x[1], y[1]);
    dd r = two_prod(x[2], y[2]), s = two_sum(p.hi, q.hi);
    return (s.hi + r.hi) + ((p.lo + q.lo) + (r.lo + s.lo));
}

/**
 * Whether b, from dot_closely, is off by no more than 2.1u and the passing time
 * of a far pair by 2.1u + 3u + 1u: then P < 33 sqrt(a c) < 2^46 |b|, and 8u^2 P
 * < 2^-4 u |b|.  What underflows does not count, if sigma > 2^-450; and what
 * overflows makes a c infinite, and nothing known.
 */
BRINK_INLINE int is_passing_known(double a, double b, double c)
{
    return (b * b > fma(0x1p-80, a * c, 0x1p-900)) & (a > 0x1p-900);
}

// The later root of those who do not pass, from discriminant_of: sqrt(d), at most
// half of the sum as c > 0, is off by 2.2u, b by 1u and a by 3u; sum and quotient
// are rounded.  2.2u / 2 + 1u / 2 + 3u + 2u = 6.6u.

// --- Near ----------------------------------------------------------------------

/** b and c, off by 1u and what they were before they were rounded: 7u^2 P, and
 *  c_error unless c is as large as R / 3, where it is off by 2u in all. */
typedef struct near_sums {
    double b, c, c_error, size;
} near_sums;

/**
 * The error of c <= 7u^2 R where |c| < R / 3, so that r.r < 2/3 R and the
 * difference of the leading parts is exact: what is left over of r.r is off by
 * 7u^2 r.r and less than 3u r.r, so with that of sigma^2 it is off by 7u^2 r.r +
 * u^2 (3 r.r + sigma^2) = u^2 (9 r.r + R).
 */
BRINK_INLINE near_sums near_sums_of(two_dots x, double sigma)
{
    dd ss = two_prod(sigma, sigma);
    double size = x.rr.hi + ss.hi;
    return (near_sums){sum_of(x.rv), (x.rr.hi - ss.hi) + (x.rr.lo - ss.lo),
                       0x1.cp-104 * size, size};
}

/** As look_closer; with c_error larger than it need be, so that d is larger than
 *  2^-90 Q where it is certain. */
BRINK_INLINE void look_closer_near(near_sums *m, const double r[3], double sigma)
{
    m->c = sum_of(fine_c(r, sigma));
    m->c_error = 0x1p-140 * m->size;
}

/**
 * d = b^2 - a c, and whether the later root, with sqrt(|d|), is off by less than
 * 8u and rightly 0 or not.  a may be off by 3u, b by 1u, c by 1u + k, k < 2.85
 * where it is known; b^2, d, its root, the sum and the quotient are rounded.
 * With w = sqrt(d) / (sqrt(d) + |b|) that makes, in u,
 *
 *     b > 0, inside:  [1 + k + 3 (2w - 1) + (1 - w)^2 + 2 (1 - w)] / 2w
 *                     + w / 2 + w + 2, at most 7.9, at w = 1/2;
 *     b < 0, inside:  with (1 + k) (2w - 1) + 3 for the first two, at most 7;
 *     b < 0 and d > 3/4 b^2, more than 2^55 times what c_error puts into it:
 *                     w > 0.464, at most 3.3 + 1.2 + 0.4 + 0.1 + 0.4 + 0.5 + 2
 *                     = 7.9 for a, b, b^2, c, d, its root and the rest;
 *     b > 0, outside: 0.  There P^2 <= Q < 2^200 b^2, and 7u^2 P < b.
 *
 * But for the last of these b may be all but its error: as c is known or d large,
 * d > 2^-90 Q >= 2^-90 P^2, and 7u^2 P < 2^-5 u beside the root.
 */
BRINK_INLINE discriminant discriminant_near(const near_sums *m, double a)
{
    double b = m->b, c = m->c, bb = b * b, d = fma(-a, c, bb);
    int now = (b > 0) & (bb > 0x1p-200 * a * m->size) & (c > 2 * m->c_error);
    int inside = is_known(-c, m->c_error);
    int near = (b < 0) & (d > 0.75 * bb) & (d > 0x1p55 * a * m->c_error);
    return (discriminant){d, now + inside + near != 0}; // `|` would be branches
}
#endif
