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

// --- Filters -------------------------------------------------------------------

BRINK_INLINE double dot_rounded(const double x[3], const double y[3])
{
    return fma(x[0], y[0], fma(x[1], y[1], x[2] * y[2])); // 3u sum |x_i y_i|
}

/** Finite and not negative. */
BRINK_INLINE int is_radius(double sigma)
{
    const uint64_t infinite = 2047; // and larger with a sign
    return bits_of(sigma) >> 52 < infinite;
}

/** Whether v.v and R, or what stands for it, are within 2^-256 and 2^256, with
 *  all that is made of them well within range: by their exponents. */
BRINK_INLINE int are_in_range(double a, double size)
{
    const uint64_t least = 1023 - 256, exponents = 512;
    uint64_t x = (bits_of(a) >> 52) - least, y = (bits_of(size) >> 52) - least;
    return (x | y) < exponents;
}

/** Whether c > 2^-10 sigma^2, so that rr < 1025 c.  rr is off by 3u, ss by 1u: c
 *  is off by less than 4200u of itself. */
BRINK_INLINE int is_far(double rr, double ss)
{
    return rr > (1 + 0x1p-10) * ss;
}

/** 2 max(0, -x), exactly. */
BRINK_INLINE double twice_below(double x)
{
    return fabs(x) - x;
}

/**
 * Whether a far pair parts already or is certain to pass by, a c > b^2.  Their
 * ratio is off by less than 5000u < 2^-40: 4200u are c's, 3u a's, a few those of
 * the roundings, and no more than 200u b's.  That is for b off by 3u P:
 * P^2 <= a rr < 33^2 a c, so 6u |b| P < 200u a c where b^2 < a c.
 */
BRINK_INLINE int passes(double a, double b, double c)
{
    double twice = twice_below(b);
    return (4 - 0x1p-36) * (a * c) > twice * twice;
}

// --- Sums that carry their errors ----------------------------------------------

/** a, b and c as unevaluated sums of two doubles, what c may be off by where it
 *  is less than R / 3, and R. */
typedef struct sums {
    dd a, b, c;
    double c_error, size;
} sums;

/** r.v and r.r. */
typedef struct two_dots {
    dd rv, rr;
} two_dots;

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
    return (sums){
        dot_of(v, v), dot_of(r, v), {w.hi, rest}, 0x1.8p-104 * size, size};
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

BRINK_INLINE discriminant discriminant_of(const sums *m)
{
    dd a = m->a;
    dd p = two_prod(m->b.hi, m->b.hi), q = two_prod(a.hi, m->c.hi);
    double rest = fma(a.hi, m->c.lo, a.lo * m->c.hi);
    rest = fma(2 * m->b.hi, m->b.lo, (p.lo - q.lo) - rest);
    double d = (p.hi - q.hi) + rest; // two roundings
    double least = fma(0x1p-44 * a.hi, m->size, 0x1p-900);
    return (discriminant){d, (a.hi > 0x1p-900) & (d > least)};
}
#endif
