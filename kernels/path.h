// SPDX-License-Identifier: MIT
#ifndef BRINK_PATH_H
#define BRINK_PATH_H
/**
 * A pair in free flight as a polynomial, for the event times; not installed.
 *
 *     f(t) = |r + v t|^2 - sigma^2 = a t^2 + 2 b t + c
 *     a = v.v   b = r.v   c = r.r - sigma^2   d = b^2 - a c = sigma^2 a - |r x v|^2
 *
 * Three ways to it: filters, which are cheap and know when they are certain; sums that
 * carry their rounding errors along; and in brink_*_time_slow double-double and exact
 * numbers, at any magnitude.
 *
 * u = 2^-53; P = sum |r_i v_i|, R = r.r + sigma^2, Q = a R >= P^2.  Bounds are to first
 * order, and what uses them leaves room for the rest.
 */
#include "lanes.h"

/** The slow ways: any input; correctly rounded; NaN outside the domain. */
double brink_intersection_time_slow(const double r[3], const double v[3],
                                    double sigma);
double brink_disjoint_time_slow(const double r[3], const double v[3],
                                double sigma);

/**
 * Where sigma^2 and its products are far from over- and underflow.  What else could go
 * out of range shows in the sums themselves, and makes no fast path certain: too large,
 * a bound is infinite or not a number, and no comparison with it holds; too small, it
 * is less than the absolute part of the bound.  So nothing else is looked at first.
 */
BRINK_INLINE int sigma_in_range(double sigma)
{
    return sigma > 0x1p-450 && sigma < 0x1p450;
}

// --- Filters -------------------------------------------------------------------------

/** b, whose sign is certain where it is farther than `error` from 0. */
typedef struct rate {
    double value, error;
} rate;

BRINK_INLINE rate rate_of(const double r[3], const double v[3])
{
    double x = r[0] * v[0], y = r[1] * v[1], z = r[2] * v[2];
    double p = fabs(x) + fabs(y) + fabs(z);
    // The products are off by u of themselves, or 2^-1075, and the sums by 2u P.
    return (rate){x + y + z, fma(0x1p-51, p, 0x1p-1000)};
}

BRINK_INLINE int is_positive(rate b)
{
    return b.value > b.error;
}

BRINK_INLINE int is_negative(rate b)
{
    return b.value < -b.error;
}

BRINK_INLINE double dot_rounded(const double x[3], const double y[3])
{
    return fma(x[0], y[0], fma(x[1], y[1], x[2] * y[2])); // 3u sum |x_i y_i|
}

/** d, and the s = sigma^2 a + |r x v|^2 that it is a difference of. */
typedef struct chord {
    double a, d, s;
} chord;

/** Error of d <= 7.5u s + 2^-950, where sigma is in range and a > 2^-900.  sigma^2 a is
 *  off by 1u + 3u; a component of the cross product, by Kahan's way, by 2u, its square
 *  by 4u, their sum by 3u more; and d, at most half of s where it matters, by 1u. */
BRINK_INLINE chord chord_of(const double r[3], const double v[3], double sigma)
{
    double xy = r[1] * v[0], yz = r[1] * v[2], zx = r[0] * v[2];
    double z = fma(r[0], v[1], -xy) - fma(r[1], v[0], -xy);
    double x = fma(r[1], v[2], -yz) - fma(r[2], v[1], -yz);
    double y = fma(r[2], v[0], -zx) - fma(r[0], v[2], -zx);
    double a = dot_rounded(v, v), ss = sigma * sigma;
    double w = fma(x, x, fma(y, y, z * z));
    return (chord){a, fma(ss, a, -w), fma(ss, a, w)};
}

/** Whether c > 0, certainly: r.r is off by 3u, sigma^2 by 1u. */
BRINK_INLINE int is_far_outside(const double r[3], double sigma)
{
    double rr = dot_rounded(r, r), ss = sigma * sigma;
    return rr - ss > 0x1p-51 * (rr + ss);
}

/** Certain to pass the sphere by: d < 0. */
BRINK_INLINE int passes_by(chord k)
{
    return (k.a > 0x1p-900) & (k.d < -fma(0x1p-50, k.s, 0x1p-900));
}

// --- Sums that carry their errors ----------------------------------------------------

/** b and c as unevaluated sums of two doubles, and R. */
typedef struct sums {
    dd b, c;
    double size;
} sums;

BRINK_INLINE double sum_of(dd x)
{
    return x.hi + x.lo;
}

/** Error of b <= 7u^2 P, of c <= 11u^2 R, where 2^-900 < R, so that what underflows does
 *  not count: what the products and the sums are off by is exact, and is added up in few
 *  roundings.  Where |c| < R / 3 the last difference is exact, and the error of c <= 6u^2
 *  R: u^2 R each for the three additions that the products' errors are in, and 4u^2 r.r,
 *  r.r < 2/3 R, for those with the sums'. */
BRINK_INLINE sums sums_of(const double r[3], const double v[3], double sigma)
{
    two_lanes p[4], e[4]; // lane 0: b, lane 1: c
    for (int i = 0; i < 3; i++) {
        two_lanes x = {v[i], r[i]}, y = {r[i], r[i]};
        p[i] = x * y;
        e[i] = lanes_fma(x, y, -p[i]);
    }
    dd ss = two_prod(-sigma, sigma);
    p[3] = (two_lanes){0, ss.hi};
    e[3] = (two_lanes){0, ss.lo};
    two_lanes s = p[0] + p[1], t = s + p[2], w = t + p[3];
    two_lanes rest = lanes_lost(s, p[0], p[1]) + lanes_lost(t, s, p[2]);
    rest = ((e[0] + e[1]) + (e[2] + e[3])) + (rest + lanes_lost(w, t, p[3]));
    return (sums){{w[0], rest[0]}, {w[1], rest[1]}, t[1] - ss.hi};
}

/** x.x, error <= 7u^2 of it. */
BRINK_INLINE dd square_of(const double x[3])
{
    dd p = two_prod(x[0], x[0]), q = two_prod(x[1], x[1]);
    dd r = two_prod(x[2], x[2]);
    dd s = two_sum(p.hi, q.hi), t = two_sum(s.hi, r.hi);
    return (dd){t.hi, (p.lo + q.lo + r.lo) + (s.lo + t.lo)};
}

/** Whether c is farther above 0 than its error. */
BRINK_INLINE int is_outside(const sums *m)
{
    return sum_of(m->c) > 0x1p-102 * m->size;
}

BRINK_INLINE int is_inside(const sums *m)
{
    return sum_of(m->c) < -0x1p-102 * m->size;
}

// --- The times, where they are certain: for sigma in range, or -1 --------------------

/** d where it is larger than 2^-44 Q, otherwise 0; error <= 2.4u d.  The products are
 *  exact; what follows their leading parts is below 18u Q and takes fewer than ten
 *  roundings, which with what a, b, c are off makes 150u^2 Q, or 0.3u of 2^-44 Q. */
BRINK_INLINE double discriminant_of(dd a, const sums *m)
{
    dd p = two_prod(m->b.hi, m->b.hi), q = two_prod(a.hi, m->c.hi);
    double rest = fma(a.hi, m->c.lo, a.lo * m->c.hi);
    rest = fma(2 * m->b.hi, m->b.lo, (p.lo - q.lo) - rest);
    double d = (p.hi - q.hi) + rest; // two roundings
    double least = fma(0x1p-44 * a.hi, m->size, 0x1p-900);
    return a.hi > 0x1p-900 && d > least ? d : 0;
}

/** The intersection time within 8 ulp, of a pair that approaches.  c is off by 1u +
 *  6u^2 R / c <= 4u; sqrt(d), at most half of the sum, by 1.2u + 1u, and b by 1u; sum and
 *  quotient are rounded: 4u + (2.2u + 1u) / 2 + 2u < 8u, and 8u are at most 8 ulp. */
BRINK_INLINE double meeting_time(const double r[3], const double v[3],
                                 double sigma)
{
    sums m = sums_of(r, v, sigma);
    double c = sum_of(m.c), d = discriminant_of(square_of(v), &m);
    double t = c / (sqrt(d) - sum_of(m.b));
    int later = (c > 0x1p-52 * m.size) & (d > 0);
    return later ? t : (is_inside(&m) ? 0 : -1);
}

/**
 * The disjoint time within 8 ulp, of a pair that is inside or only just outside; `rough`
 * is its rate.  d = b^2 - a c loses nothing then: a may be off by 3u, c by 1u + k,
 * k = 6u^2 R / |c| <= 3u where it is divided by, b by 1u; the product a c, d, its root,
 * the sum and the quotient by 1u each.  With w = sqrt(d) / (sqrt(d) + |b|), to first order,
 *
 *     b > 0: (1 + k) / 2w + 3 (2w - 1) / 2w + [(1 - w)^2 / w + (2w - 1) / 2w + w / 2]
 *            + w + (1 - w) + 2    for 1/2 <= w <= 1:  at most 4.8 + k, 7.8u at w = 1/2
 *     b < 0, inside:        3 / 2w in place of the terms of a:  at most 6.8u
 *     b < 0, just outside, d > 3/4 b^2:  3.3 + 1.8 + 0.5 + 2 = 7.6u
 */
BRINK_INLINE double parting_time(const double r[3], const double v[3],
                                 double sigma, rate rough)
{
    sums m = sums_of(r, v, sigma);
    double a = dot_rounded(v, v), b = sum_of(m.b), c = sum_of(m.c);
    double bb = b * b, d = fma(-a, c, bb), root = sqrt(d);
    double t = (b > 0 ? -c : root - b) / (b > 0 ? root + b : a);
    int in_range = (a > 0x1p-900) & (d > 0x1p-900) & (d < 0x1p1000);
    int inside = c < -0x1p-52 * m.size,
        on_the_way = is_negative(rough) & (d > 0.75 * bb);
    int now = is_positive(rough) & is_outside(&m);
    return now ? 0 : (in_range & (inside | on_the_way) ? t : -1);
}

/** The time of the closest approach, b certainly negative, a > 2^-900, within 8 ulp: |b|
 *  is then more than 4u P, so it is off by 1u + 2u, and a by 3u, the quotient by 1u. */
BRINK_INLINE double approach_time(const double r[3], const double v[3])
{
    return -sum_of(sums_of(r, v, 0).b) / dot_rounded(v, v);
}
#endif
