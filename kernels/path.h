// SPDX-License-Identifier: MIT
#ifndef BRINK_PATH_H
#define BRINK_PATH_H
/**
 * A pair in free flight as a polynomial, for the event times; not installed.
 *
 *     f(t) = |r + v t|^2 - sigma^2 = a t^2 + 2 b t + c
 *     a = v.v   b = r.v   c = r.r - sigma^2   d = b^2 - a c = sigma^2 a - |r x
 * v|^2
 *
 * Three ways to it: filters, which are cheap and know when they are certain; sums
 * that carry their rounding errors along; and, in brink_*_time_slow,
 * double-double and exact numbers at any magnitude.
 *
 * u = 2^-53; P = sum |r_i v_i|, R = r.r + sigma^2, Q = a R >= P^2; bounds are to
 * first order, with room for the rest.
 */
#include "exact.h"

/** The slow ways: correctly rounded, any input; NaN outside the domain. */
double brink_intersection_time_slow(const double r[3], const double v[3],
                                    double sigma);
double brink_disjoint_time_slow(const double r[3], const double v[3],
                                double sigma);

/** Where sigma is such that sigma^2 is far from over- and underflow.  What else
 * could go out of range shows in the sums themselves: too large makes a bound
 * infinite or not a number, and no comparison with it holds; too small is under
 * the absolute part. */
BRINK_INLINE int sigma_in_range(double sigma)
{
    return sigma > 0x1p-450 && sigma < 0x1p450;
}

BRINK_INLINE double dot_rounded(const double x[3], const double y[3])
{
    return fma(x[0], y[0],
               fma(x[1], y[1], x[2] * y[2])); // error <= 3u sum |x_i y_i|
}

/** b, certain to be right in its sign where it is more than `error` from 0. */
typedef struct rate {
    double value, error;
} rate;

BRINK_INLINE rate rate_of(const double r[3], const double v[3])
{
    double x = r[0] * v[0], y = r[1] * v[1], z = r[2] * v[2];
    double p = fabs(x) + fabs(y) + fabs(z);
    // Each product is off by u of itself, or 2^-1075, and the sums by 2u P.
    return (rate){x + y + z, fma(0x1p-51, p, 0x1p-1000)};
}

/** d, and the s = sigma^2 a + |r x v|^2 that it is a difference of. */
typedef struct chord {
    double a, d, s;
} chord;

/** Error of d <= 7.5u s + 2^-950, where sigma is in range and a > 2^-900. sigma^2
 * a is off by 1u + 3u; a component of the cross product, by Kahan's way, by 2u,
 * its square by 4u, their sum by 3u more; and d, about half of s where it
 * matters, by 1u. */
BRINK_INLINE chord chord_of(const double r[3], const double v[3], double sigma)
{
    double xy = r[1] * v[0], yz = r[2] * v[1], zx = r[0] * v[2];
    double z = fma(r[0], v[1], -xy) - fma(r[1], v[0], -xy);
    double x = fma(r[1], v[2], -yz) - fma(r[2], v[1], -yz);
    double y = fma(r[2], v[0], -zx) - fma(r[0], v[2], -zx);
    double a = dot_rounded(v, v), ss = sigma * sigma;
    double w = fma(x, x, fma(y, y, z * z));
    return (chord){a, fma(ss, a, -w), fma(ss, a, w)};
}

/** Certain to pass the sphere by: d < 0. */
BRINK_INLINE int passes_by(chord c)
{
    return c.a > 0x1p-900 && c.d < -fma(0x1p-50, c.s, 0x1p-900);
}

/** a, b, c as unevaluated sums of two doubles, |lo| <= 4u of the terms' sizes;
 * and R. */
typedef struct sums {
    dd a, b, c;
    double size;
} sums;

BRINK_INLINE double sum_of(dd x)
{
    return x.hi + x.lo;
}

/** x.y, error <= 8u^2 sum |x_i y_i|: the errors of the products and of the sums
 * are exact; they add up to at most 3u P, in five roundings of their own (7u^2
 * P). */
BRINK_INLINE dd dot_of(const double x[3], const double y[3])
{
    dd p = two_prod(x[0], y[0]), q = two_prod(x[1], y[1]),
       r = two_prod(x[2], y[2]);
    dd s = two_sum(p.hi, q.hi), t = two_sum(s.hi, r.hi);
    return (dd){t.hi, (p.lo + q.lo + r.lo) + (s.lo + t.lo)};
}

/** The same with a fourth product: error of c <= 12u^2 R, of a <= 8u^2 a, of b <=
 * 8u^2 P; where 2^-900 < R, so that what underflows does not count. */
BRINK_INLINE sums sums_of(const double r[3], const double v[3], double sigma)
{
    sums m;
    dd x = two_prod(r[0], r[0]), y = two_prod(r[1], r[1]),
       z = two_prod(r[2], r[2]);
    dd q = two_prod(-sigma, sigma);
    dd s = two_sum(x.hi, y.hi), t = two_sum(s.hi, z.hi), w = two_sum(t.hi, q.hi);
    m.a = dot_of(v, v);
    m.b = dot_of(r, v);
    m.c.hi = w.hi;
    m.c.lo = ((x.lo + y.lo) + (z.lo + q.lo)) + ((s.lo + t.lo) + w.lo);
    m.size = t.hi - q.hi;
    return m;
}

/** The same with |lo| <= u |hi|. */
BRINK_INLINE sums normalised(sums m)
{
    m.a = two_sum(m.a.hi, m.a.lo);
    m.b = two_sum(m.b.hi, m.b.lo);
    m.c = two_sum(m.c.hi, m.c.lo);
    return m;
}
#endif
