// SPDX-License-Identifier: MIT
#ifndef BRINK_EVENT_TIME_SUMS_H
#define BRINK_EVENT_TIME_SUMS_H
/**
 * A pair in free flight as a polynomial, for the event times; not installed.
 *
 *     f(t) = |r + v t|^2 - sigma^2 = a t^2 + 2 b t + c
 *     a = v.v,  b = r.v,  c = r.r - sigma^2
 *     d = b^2 - a c = sigma^2 a - |r x v|^2
 *
 * Three ways to it: filters, which are cheap and know when they are certain; sums
 * that carry their rounding errors along; and in brink_*_time_slow double-double
 * and exact numbers, at any magnitude.
 *
 * u = 2^-53; P = sum |r_i v_i|, R = r.r + sigma^2, Q = a R >= P^2.  Bounds are to
 * first order, and what uses them leaves room for the rest.
 */
#include "exact.h"

/** The slow ways, for any input: correctly rounded; NaN outside the domain. */
double brink_intersection_time_slow(const double r[3], const double v[3],
                                    double sigma);
double brink_disjoint_time_slow(const double r[3], const double v[3],
                                double sigma);

/**
 * Where sigma^2 and its products are far from over- and underflow.  What else
 * could go out of range shows in the sums themselves, and makes no fast path
 * certain: too large, a bound is infinite or not a number, and no comparison with
 * it holds; too small, it is less than the absolute part of the bound.  So
 * nothing else is looked at first.
 */
BRINK_INLINE int sigma_in_range(double sigma)
{
    return (sigma > 0x1p-450) & (sigma < 0x1p450);
}

BRINK_INLINE int is_in_range(double x)
{
    return (x > 0x1p-900) & (x < 0x1p1000);
}

// --- Filters -------------------------------------------------------------------

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

/** Error of d <= 7.5u s + 2^-950, where sigma is in range and a > 2^-900:
 *  sigma^2 a is off by 1u + 3u; a component of the cross product, by Kahan's
 *  way, by 2u, its square by 4u, their sum by 3u more; and d, less than s / 2
 *  where it matters, by 1u. */
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

// --- Plain: sums that carry their errors ---------------------------------------

/** b and c as unevaluated sums of two doubles, what c may be off by where it
 *  is less than R / 3, and R. */
typedef struct sums {
    dd b, c;
    double c_error, size;
} sums;

BRINK_INLINE double sum_of(dd x)
{
    return x.hi + x.lo;
}

/** x.y, error <= 7u^2 sum |x_i y_i|: what products and sums are off by is
 *  exact, and at most 3u of that sum in all; it is added up with five
 *  roundings. */
BRINK_INLINE dd dot_of(const double x[3], const double y[3])
{
    dd p = two_prod(x[0], y[0]), q = two_prod(x[1], y[1]);
    dd r = two_prod(x[2], y[2]);
    dd s = two_sum(p.hi, q.hi), t = two_sum(s.hi, r.hi);
    return (dd){t.hi, (p.lo + q.lo + r.lo) + (s.lo + t.lo)};
}

/** r.v and r.r. */
typedef struct two_dots {
    dd rv, rr;
} two_dots;

/** The same with a fourth product: error of b <= 7u^2 P, of c <= 11u^2 R,
 *  where R is more than 2^-900, so that what underflows does not count.  Where
 *  |c| < R / 3 the last difference is exact, and the error of c <= 6u^2 R: u^2
 *  R each for the three additions that the products' errors are in, and 4u^2
 *  r.r, r.r < 2/3 R, for those with the sums'. */
BRINK_INLINE sums sums_of(const double r[3], const double v[3], double sigma)
{
    dd x = two_prod(r[0], r[0]), y = two_prod(r[1], r[1]);
    dd z = two_prod(r[2], r[2]), q = two_prod(-sigma, sigma);
    dd s = two_sum(x.hi, y.hi), t = two_sum(s.hi, z.hi), w = two_sum(t.hi, q.hi);
    double rest = ((x.lo + y.lo) + (z.lo + q.lo)) + ((s.lo + t.lo) + w.lo);
    double size = t.hi - q.hi;
    return (sums){dot_of(r, v), {w.hi, rest}, 0x1.8p-104 * size, size};
}

/** c anew, off by 2u^2 of itself and 2^-150 R: the parts left over, which are
 *  u smaller than R, in double-double. */
BRINK_INLINE dd fine_c(const double r[3], double sigma)
{
    dd x = two_prod(r[0], r[0]), y = two_prod(r[1], r[1]);
    dd z = two_prod(r[2], r[2]), q = two_prod(-sigma, sigma);
    dd s = two_sum(x.hi, y.hi), t = two_sum(s.hi, z.hi), w = two_sum(t.hi, q.hi);
    dd rest = two_sum(x.lo, y.lo);
    rest = dd_add_d(dd_add_d(rest, z.lo), q.lo);
    rest = dd_add_d(dd_add_d(rest, s.lo), t.lo);
    return dd_add_d(dd_add_d(rest, w.lo), w.hi);
}

BRINK_INLINE void look_closer(sums *m, const double r[3], double sigma)
{
    m->c = fine_c(r, sigma);
    m->c_error = 0x1p-150 * m->size;
}

/** Whether c is farther above or below 0 than its error. */
BRINK_INLINE int is_outside(const sums *m)
{
    return sum_of(m->c) > 2 * m->c_error;
}

BRINK_INLINE int is_inside(const sums *m)
{
    return sum_of(m->c) < -2 * m->c_error;
}

/** Whether x is off by less than 2.85u of itself, if by `error`. */
BRINK_INLINE int is_known(double x, double error)
{
    return x > 0x1.68p51 * error; // 2^53 / 2.85 = 1.404 2^51
}

/** d, and whether it is larger than 2^-44 Q, where its error <= 2.4u d.  The
 *  products are exact; what follows their leading parts is below 18u Q and
 *  takes fewer than ten roundings, which with what a, b, c are off makes
 *  150u^2 Q, or 0.3u of 2^-44 Q. */
typedef struct discriminant {
    double d;
    int certain;
} discriminant;

BRINK_INLINE discriminant discriminant_of(dd a, const sums *m)
{
    dd p = two_prod(m->b.hi, m->b.hi), q = two_prod(a.hi, m->c.hi);
    double rest = fma(a.hi, m->c.lo, a.lo * m->c.hi);
    rest = fma(2 * m->b.hi, m->b.lo, (p.lo - q.lo) - rest);
    double d = (p.hi - q.hi) + rest; // two roundings
    double least = fma(0x1p-44 * a.hi, m->size, 0x1p-900);
    return (discriminant){d, (a.hi > 0x1p-900) & (d > least)};
}

/** The intersection time within 8 ulp, of a pair that approaches; -1 where it
 *  is not certain.  c is off by 1u + 2.85u; sqrt(d), at most half of the sum,
 *  by 1.2u + 1u, and b by 1u; sum and quotient are rounded: 3.85u + (2.2u +
 *  1u) / 2 + 2u < 8u, and 8u are at most 8 ulp. */
BRINK_INLINE double meeting_time(const sums *m, dd a, int approaching)
{
    discriminant d = discriminant_of(a, m);
    double c = sum_of(m->c), root = sqrt(d.certain ? d.d : 0);
    double t = c / (root - sum_of(m->b));
    int later = approaching & d.certain & is_known(c, m->c_error);
    double otherwise = approaching & is_inside(m) ? 0 : -1;
    return later ? t : otherwise;
}

/** Inside, or so near the surface that most of those which approach will meet. */
BRINK_INLINE int is_touching(const double r[3], double sigma)
{
    return dot_rounded(r, r) < 1.02 * (sigma * sigma);
}

/**
 * The same of a pair that is touching and does not graze: d = b^2 - a c loses
 * little then.  a may be off by 3u, c by 1u + k, b by 1u; b^2, d, its root, the
 * sum and the quotient are rounded.  With w = sqrt(d) / (sqrt(d) - b), which is
 * at most 1/2, the time is off by
 *
 *     [1 + k + 3 (1 - 2w) + (1 - w)^2 + 2 (1 - w)] / 2w  +  w / 2 + w + 2
 *
 * in u, for c, a, b^2, b, d, its root, and the last two roundings:
 *
 *     d > b^2 / 3, w > 0.366, k < 0.36:    at most 7.8
 *     d > 0.95 b^2, w > 0.493, k < 2.85:   at most 7.97
 */
BRINK_INLINE double meeting_time_touching(const sums *m, double a,
                                          int approaching)
{
    double b = sum_of(m->b), c = sum_of(m->c);
    double bb = b * b, d = fma(-a, c, bb);
    int slanting = (3 * d > bb) & is_known(c, 8 * m->c_error);
    int head_on = (d > 0.95 * bb) & is_known(c, m->c_error);
    int in_range = (a > 0x1p-900) & is_in_range(d);
    int later = approaching & in_range & (slanting | head_on);
    double t = c / (sqrt(d > 0 ? d : 0) - b);
    double otherwise = approaching & is_inside(m) ? 0 : -1;
    return later ? t : otherwise;
}
#endif
