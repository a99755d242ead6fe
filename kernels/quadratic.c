// SPDX-License-Identifier: MIT
// u = 2^-53; error bounds are relative and to first order.
#include "path.h"

#include "quadratic.h"
#include "root.h"

BRINK_INLINE void in_order(double x, double y, double *x0, double *x1)
{
    *x0 = x < y ? x : y;
    *x1 = y > x ? y : x;
}

/**
 * With h = -b / 2, exact, and d = h^2 - a c: roots s / a and c / s, where
 * s = h + sign(h) sqrt(d).  The size h^2 + |a c| is to be in range: then nothing
 * overflows, and what underflows is lost beside the rest.
 *
 * The error, with w = sqrt(d) / |s|: d's is halved by the root, which adds 1u,
 * all times w; the sum adds 1u; the quotient half an ulp.
 *   a c > 0: d = (h^2 - q.hi) - q.lo, off by 2u (Kahan), so its sign is right; w
 *   <= 1/2:
 *            at most 2u before the quotient
 *   a c < 0: d = (h^2 - q.lo) - q.hi, off by u (k^2 + 1) where k = |h| / sqrt(d)
 *   < 1, and
 *            w = 1 / (1 + k): at most u (1.5 + k^2 / 2) / (1 + k) + u <= 2.5u
 *            before it
 * and 2.5u are at most 2.5 ulp: 3 in all.
 */
BRINK_INLINE int roots_in_range(double a, double b, double c, double *x0,
                                double *x1)
{
    double h = -0.5 * b;
    dd q = two_prod(a, c);
    double first = q.hi > q.lo ? q.hi : q.lo, last = q.lo < q.hi ? q.lo : q.hi;
    double d = fma(h, h, -first) - last;
    if (d < 0)
        return 0;
    double s = h + copysign(sqrt(d), h);
    in_order(s / a, c / s, x0, x1);
    return 2;
}

/** Exponent of x: 2^e <= |x| < 2^(e+1). */
static int exponent_of(double x)
{
    int e = biased_exponent(x);
    return e != 0 ? e - 1023 : biased_exponent(x * 0x1p54) - 1077;
}

/** x 2^e, rounded once: x is so that the first step stays normal. */
static double scaled(double x, int e)
{
    return x * power_of_two(e / 2) * power_of_two(e - e / 2);
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
    int ea = exponent_of(a), ec = exponent_of(c), unit = (ec - ea) / 2;
    int eb = b != 0 ? exponent_of(b) + unit - ec : -3000, limit = 200;
    int shift = unit - ec;
    balanced e = {scaled(a, 2 * unit - ec), 0, scaled(c, -ec), eb, unit};
    if (eb > -limit && eb < limit)
        e.b = scaled(b, shift);
    return e;
}

static __attribute__((noinline)) int roots_rescued(double a, double b, double c,
                                                   double *x0, double *x1)
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
    double y0, y1;
    int count = roots_in_range(e.a, e.b, e.c, &y0, &y1);
    if (count == 2) {
        *x0 = scaled(y0, e.unit);
        *x1 = scaled(y1, e.unit);
    }
    return count;
}

int brink_quadratic_roots(double a, double b, double c, double *x0, double *x1)
{
    if (bits_of(a) << 1 != 0 && is_moderate(fma(0.5 * b, 0.5 * b, fabs(a * c))))
        return roots_in_range(a, b, c, x0, x1);
    return roots_rescued(a, b, c, x0, x1);
}

static __attribute__((noinline)) int
roots_exact(double a, double b, double c, double *x0, double *x1) // a is not 0
{
    const double two = 2;
    brink_dyadic a2, b1, c2, bb, ac, d; // 2a x^2 + 2 b x + 2c
    brink_dyadic_dot(&a2, 1, &a, &two);
    brink_dyadic_double(&b1, b);
    brink_dyadic_dot(&c2, 1, &c, &two);
    brink_dyadic_mul(&bb, &b1, &b1);
    brink_dyadic_mul(&ac, &a2, &c2);
    brink_dyadic_sub(&d, &bb, &ac);
    if (d.sign < 0)
        return 0;
    *x0 = brink_dyadic_root(&a2, &b1, &c2, &d, BRINK_LOWER);
    *x1 = brink_dyadic_root(&a2, &b1, &c2, &d, BRINK_UPPER);
    return 2;
}

/**
 * The same with the low parts carried along.  2, 0, or -1 where a root cannot be
 * rounded with certainty or the size is not in range.
 *
 * d is off by 5u^2 of its size, which is at most 2^20 d; s, to which the root's
 * error comes at most once, by 2^-85; a root by 2^-84.
 */
BRINK_INLINE int roots_told(double a, double b, double c, double *x0, double *x1)
{
    double h = -0.5 * b;
    dd p = two_prod(h, h), q = two_prod(a, c), t = two_sum(p.hi, -q.hi);
    double rest = t.lo + (p.lo - q.lo), d = t.hi + rest, size = p.hi + fabs(q.hi);
    if (!is_moderate(size) || !is_moderate(fabs(a)) || !is_moderate(fabs(c)))
        return -1;
    if (!(d > 0x1p-20 * size)) // Kahan's d has the right sign
        return fma(h, h, -q.hi) - q.lo < 0 ? 0 : -1;
    double root = copysign(sqrt(d), h);
    dd s = two_sum(h, root);
    s.lo = fma(fma(-root, root, t.hi) + rest, 0.5 / root, s.lo);
    double by_a = 1 / a,
           by_s = 1 / s.hi; // good enough: the residuals put it right
    double x = s.hi * by_a, y = c * by_s;
    dd x_told = fast_two_sum(x, (fma(-x, a, s.hi) + s.lo) * by_a);
    dd y_told = fast_two_sum(y, fma(-y, s.lo, fma(-y, s.hi, c)) * by_s);
    if (!is_told(x_told) || !is_told(y_told))
        return -1;
    in_order(x_told.hi, y_told.hi, x0, x1);
    return 2;
}

static __attribute__((noinline)) int
roots_rescued_cr(double a, double b, double c, double *x0, double *x1)
{
    if (!isfinite(a) || !isfinite(b) || !isfinite(c))
        return -1;
    if (a == 0 || c == 0) // quotients, rounded once
        return roots_rescued(a, b, c, x0, x1);
    balanced e = balance(a, b, c);
    if (e.b_exponent > -200 && e.b_exponent < 200) {
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
