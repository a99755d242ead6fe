// SPDX-License-Identifier: MIT
// u = 2^-53; error bounds are relative and to first order.
#include "path.h"

#include "lanes.h"
#include "quadratic.h"
#include "root.h"

BRINK_INLINE void in_order(double x, double y, double *x0, double *x1)
{
    *x0 = smaller(x, y);
    *x1 = larger(y, x);
}

/**
 * The roots are s / a and c / s, with s = h + sign(h) sqrt(d), h = -b / 2, exact,
 * and d = h^2 - a c.
 *
 * The error, with w = sqrt(d) / |s|: d's is halved by the root, which adds 1u,
 * all times w; the sum adds 1u.
 *
 *     a c > 0: d = (h^2 - q.hi) - q.lo, Kahan's way, is off by 1.5 ulp, 3u at
 *              most, so its sign is right; w <= 1/2: at most 2.25u
 *     a c < 0: d = (h^2 - q.lo) - q.hi is off by u (k^2 + 1), k = |h| / sqrt(d)
 *              < 1, w = 1 / (1 + k): u (1.5 + k^2 / 2) / (1 + k) + u <= 2.5u
 *
 * 2.5u are at most 2.5 ulp, and the quotient is rounded by half an ulp: 3 in all.
 * Where that is across a power of two, by a whole ulp of the root's, the root is
 * within 1 ulp of the power: a quotient of doubles is not as near to it, unless
 * it is the power (proofs/quadratic_roots.v).
 */
BRINK_INLINE double discriminant_of(double h, dd q)
{
    return fma(h, h, -larger(q.hi, q.lo)) - smaller(q.hi, q.lo);
}

BRINK_INLINE int roots_of(double a, double c, double h, double d, double *x0,
                          double *x1)
{
    double s = h + copysign(sqrt(d), h);
    two_lanes x = (two_lanes){s, c} / (two_lanes){a, s};
    in_order(x[0], x[1], x0, x1);
    return 2;
}

/** m 2^e, 1 <= |m| < 2. */
typedef struct parts {
    double m;
    int e;
} parts;

/** m with another exponent, 2^e. */
BRINK_INLINE double with_exponent(double m, int e)
{
    const uint64_t field = UINT64_C(0x7ff) << 52;
    return double_of((bits_of(m) & ~field) | (uint64_t)(e + 1023) << 52);
}

/** Of a finite number, not 0. */
BRINK_INLINE parts taken_apart(double x)
{
    int biased = biased_exponent(x), is_subnormal = biased == 0;
    double m = with_exponent(x, 0); // 1 too large, if subnormal
    m -= copysign(is_subnormal, x);
    int e = biased + is_subnormal + biased_exponent(m) - 2 * 1023;
    return (parts){with_exponent(m, 0), e};
}

/** a x^2 + b x + c = 0 as a y^2 + b y + c = 0 with x = y 2^unit, and a and c
 *  of order 1: exact, but for b where it is too small or too large to be in
 *  range. */
typedef struct balanced {
    double a, b, c;
    int b_exponent, unit;
} balanced;

static balanced balance(double a, double b, double c) // a, c not 0
{
    const int limit = 200;
    parts pa = taken_apart(a), pb = taken_apart(b), pc = taken_apart(c);
    int unit = (pc.e - pa.e) / 2, eb = pb.e + unit - pc.e;
    eb = b != 0 ? eb : -limit;
    double scaled_b = eb > -limit && eb < limit ? with_exponent(pb.m, eb) : 0;
    double scaled_a = with_exponent(pa.m, pa.e + 2 * unit - pc.e);
    return (balanced){scaled_a, scaled_b, pc.m, eb, unit};
}

static BRINK_APART int roots_rescued(double a, double b, double c, double *x0,
                                     double *x1)
{
    if (!isfinite(a) || !isfinite(b) || !isfinite(c))
        return -1;
    if (a == 0) {
        if (b == 0)
            return 0;
        *x0 = -c / b;
        return 1;
    }
    if (c == 0) {
        in_order(-b / a, 0, x0, x1);
        return 2;
    }
    balanced e = balance(a, b, c);
    if (e.b_exponent >= 200) { // 4 a c is less than 2^-390 of b^2
        in_order(-b / a, -c / b, x0, x1);
        return 2;
    }
    double h = -0.5 * e.b, d = discriminant_of(h, two_prod(e.a, e.c)), y0, y1;
    if (d < 0)
        return 0;
    roots_of(e.a, e.c, h, d, &y0, &y1);
    *x0 = scaled(y0, e.unit);
    *x1 = scaled(y1, e.unit);
    return 2;
}

/** Whether d < 0, of any a, b, c: h^2 - q.hi and a c - q.hi are rounded once
 *  each, which changes no order, and where a product overflows they do not
 *  compare so.  A subnormal h may have lost a bit: its square is nothing beside
 *  any double. */
BRINK_INLINE int is_rootless(double h, dd q)
{
    return fma(h, h, -q.hi) < q.lo;
}

/** Where d is in range so was all that it was made of: an overflow would have
 *  left no number, and what underflows, less than 2^-1074, is lost beside it. */
int brink_quadratic_roots(double a, double b, double c, double *x0, double *x1)
{
    double h = -0.5 * b;
    dd q = two_prod(a, c);
    if (is_rootless(h, q))
        return 0;
    double d = discriminant_of(h, q);
    if (is_moderate(d) && bits_of(a) << 1 != 0)
        return roots_of(a, c, h, d, x0, x1);
    return roots_rescued(a, b, c, x0, x1);
}

static BRINK_APART int roots_exact(double a, double b, double c, double *x0,
                                   double *x1) // a is not 0, and there are roots
{
    const double two = 2;
    brink_dyadic a2, b1, c2, bb, ac, d; // 2a x^2 + 2 b x + 2c
    brink_dyadic_dot(&a2, 1, &a, &two);
    brink_dyadic_double(&b1, b);
    brink_dyadic_dot(&c2, 1, &c, &two);
    brink_dyadic_mul(&bb, &b1, &b1);
    brink_dyadic_mul(&ac, &a2, &c2);
    brink_dyadic_sub(&d, &bb, &ac);
    *x0 = brink_dyadic_root(&a2, &b1, &c2, &d, BRINK_LOWER);
    *x1 = brink_dyadic_root(&a2, &b1, &c2, &d, BRINK_UPPER);
    return 2;
}

/**
 * The same with the low parts carried along.  2, 0, or -1 where a root cannot be
 * rounded with certainty or something is not in range.
 *
 * d is to within 3u the exact one, whose root is R, and root^2 to within 5.1u.
 *
 *     |h| <= 2^25 R: the residual d - root^2 is off by 16u^2 (h^2 + |a c|), 2u^2
 *              for what is lost of t's low part and of rest, 14u^2 for the other
 *              roundings; divided by 2 root that is 2^-77 of s
 *     |h| more: h^2 and a c agree in 50 bits, so t is exact, and rest is off by
 *              u d at most: where no power of two is between h^2 and a c, p.lo
 *              and q.lo are so few of the products' last places that it is exact;
 *              where one is, they are no more than the products' distances from
 *              it.  Then t.hi - root^2 is -rest, a double, but for 6.1u d, and
 *              not rounded by more than that: the residual is off by 7.2u d, s by
 *              2^-76 of itself
 *
 * and s / a and c / s by as much, and by some u^2: 2^-75 at most, which is asked
 * for (proofs/quadratic_told.v).  The inverses may be off by some u: the
 * residuals of their products make that good.
 */
BRINK_INLINE int roots_told(double a, double b, double c, double *x0, double *x1)
{
    double h = -0.5 * b;
    dd q = two_prod(a, c);
    if (is_rootless(h, q))
        return 0;
    double d = fma(h, h, -q.hi) - q.lo, size = fma(h, h, fabs(q.hi));
    if (!are_moderate(size, fabs(a), fabs(c)) || !(d > 0))
        return -1;
    double root = copysign(sqrt(d), h);
    dd p = two_prod(h, h), t = two_sum(p.hi, -q.hi);
    double rest = t.lo + (p.lo - q.lo);
    two_lanes inverse = (two_lanes){0.5, 1} / (two_lanes){root, a};
    dd s = two_sum(h, root);
    s.lo = fma(fma(-root, root, t.hi) + rest, inverse[0], s.lo);
    inverse[0] = 1 / s.hi;
    two_lanes over = {c, s.hi}, under = {s.hi, a}; // c / s and s / a
    two_lanes x = over * inverse, residual = lanes_fma(-x, under, over);
    residual =
        lanes_fma((two_lanes){-x[0], 1}, (two_lanes){s.lo, s.lo}, residual);
    if (!lanes_are_told(x, residual * inverse, &x))
        return -1;
    in_order(x[0], x[1], x0, x1);
    return 2;
}

static BRINK_APART int roots_rescued_cr(double a, double b, double c, double *x0,
                                        double *x1)
{
    if (!isfinite(a) || !isfinite(b) || !isfinite(c))
        return -1;
    if (a == 0 || c == 0) // quotients, rounded once
        return roots_rescued(a, b, c, x0, x1);
    balanced e = balance(a, b, c);
    if (e.b_exponent < 200) { // a b that is lost is less than 2^-199 of a root
        double y0, y1;
        int count = roots_told(e.a, e.b, e.c, &y0, &y1);
        if (count == 0)
            return 0;
        if (count == 2) {
            double small = scaled(fmin(fabs(y0), fabs(y1)), e.unit);
            if (small > 0x1p-1000) { // nothing is lost in scaling back
                *x0 = scaled(y0, e.unit);
                *x1 = scaled(y1, e.unit);
                return 2;
            }
        }
    }
    return roots_exact(a, b, c, x0, x1);
}

int brink_quadratic_roots_cr(double a, double b, double c, double *x0, double *x1)
{
    int count = roots_told(a, b, c, x0, x1);
    if (count >= 0)
        return count;
    return roots_rescued_cr(a, b, c, x0, x1);
}
