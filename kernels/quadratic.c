// SPDX-License-Identifier: MIT
// u = 2^-53; error bounds are relative and to first order.
#include "quadratic.h"
#include "paths.h"
#include "root.h"

#define PARAMETERS (double a, double b, double c, double *x0, double *x1)
#define ARGUMENTS  (a, b, c, x0, x1)

/** Whether nothing below can over- or underflow so as to matter; not for c = 0, not for
 *  infinities and NaN. */
BRINK_INLINE int in_range(double a, double b, double c)
{
    return fabs(a) > 0x1p-240 && fabs(a) < 0x1p240 && fabs(b) < 0x1p240 &&
           fabs(c) > 0x1p-240 && fabs(c) < 0x1p240;
}

/** b^2 - 4 a c.  The sign of `kahan` is exact, its error being at most 2u by Kahan's way;
 *  that of `value` is 1u where it is not far smaller than b^2. */
typedef struct discriminant {
    double kahan, value;
} discriminant;

BRINK_INLINE discriminant discriminant_of(double a, double b, double c)
{
    dd p = two_prod(b, b), q = two_prod(4 * a, c);
    double high = fma(b, b, -q.hi);
    dd t = two_sum(p.hi, -q.hi);
    double lost = (t.hi - high) + (t.lo + p.lo); // of b^2 - q.hi in `high`
    return (discriminant){high - q.lo, high + (lost - q.lo)};
}

BRINK_INLINE void in_order(double x, double y, double *x0, double *x1)
{
    *x0 = x < y ? x : y;
    *x1 = x < y ? y : x;
}

/** In range.  sqrt(d) is off by 0.5u + 1u, the sum by 1u more; the quotient's rounding
 *  is half an ulp, and 2.5u are at most two and a half: 3 in all. */
BRINK_INLINE int roots_in_range PARAMETERS
{
    discriminant d = discriminant_of(a, b, c);
    if (d.kahan < 0)
        return 0;
    // Where d is next to nothing beside b^2 its value may be off by all of itself, which
    // is next to nothing beside b.
    double q = -0.5 * (b + copysign(sqrt(fmax(d.value, 0)), b));
    in_order(q / a, c / q, x0, x1);
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

/** a x^2 + b x + c = 0 as a y^2 + b y + c = 0 with x = y 2^unit, and a and c of order 1:
 *  exact, but for b where it is too small or too large to be in range. */
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

static __attribute__((noinline)) int roots_rescued PARAMETERS
{
    if (!isfinite(a) || !isfinite(b) || !isfinite(c))
        return -1;
    if (a == 0) {
        if (b == 0)
            return 0;
        *x0 = 0 - c / b; // + 0 where c is 0
        return 1;
    }
    if (c == 0) {
        in_order(0 - b / a, 0, x0, x1);
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

BRINK_INLINE int brink_quadratic_roots_body PARAMETERS
{
    if (in_range(a, b, c))
        return roots_in_range(a, b, c, x0, x1);
    return roots_rescued(a, b, c, x0, x1);
}

static __attribute__((noinline)) int roots_exact PARAMETERS // a is not 0
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

/** Whether x.hi + x.lo, off by 2^-78 of itself, has no midpoint of doubles about it. */
BRINK_INLINE int is_told(dd x)
{
    double slack = 0x1p-78 * x.hi;
    return x.hi + (x.lo + slack) == x.hi + (x.lo - slack);
}

/** In range.  2 or 0, or -1 where a root cannot be rounded with certainty. */
BRINK_INLINE int roots_told PARAMETERS
{
    dd p = two_prod(b, b), q = two_prod(4 * a, c);
    double kahan = fma(b, b, -q.hi) - q.lo; // its sign is exact
    if (kahan < 0)
        return 0;
    dd t = two_sum(p.hi, -q.hi); // d to 5u^2 (b^2 + |4 a c|)
    dd d = two_sum(t.hi, t.lo + (p.lo - q.lo));
    if (!(d.hi > 0x1p-20 * (p.hi + fabs(q.hi))))
        return -1;
    // |b| + sqrt(d), to 2^-83; its reciprocal serves both roots' low parts.
    dd sum = dd_add_d(dd_sqrt(d), fabs(b));
    double inverse = 1 / sum.hi, a2 = 2 * fabs(a), c2 = 2 * fabs(c);
    dd x, y; // x = sum / a2, y = c2 / sum
    x.hi = sum.hi / a2;
    x.lo = (fma(-x.hi, a2, sum.hi) + sum.lo) * (x.hi * inverse);
    y.hi = c2 * inverse;
    y.lo = (fma(-y.hi, sum.hi, c2) - y.hi * sum.lo) * inverse;
    x = fast_two_sum(x.hi, x.lo);
    y = fast_two_sum(y.hi, y.lo);
    if (!is_told(x) || !is_told(y))
        return -1;
    double large = copysign(x.hi, -copysign(1, b) * a);
    double small = copysign(y.hi, -copysign(1, b) * c);
    in_order(large, small, x0, x1);
    return 2;
}

static __attribute__((noinline)) int roots_rescued_cr PARAMETERS
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

BRINK_INLINE int brink_quadratic_roots_cr_body PARAMETERS
{
    if (in_range(a, b, c)) {
        int count = roots_told(a, b, c, x0, x1);
        if (count >= 0)
            return count;
    }
    return roots_rescued_cr(a, b, c, x0, x1);
}

BRINK_SCALAR_PATHS(int, brink_quadratic_roots, PARAMETERS, ARGUMENTS)
BRINK_SCALAR_PATHS(int, brink_quadratic_roots_cr, PARAMETERS, ARGUMENTS)
