// SPDX-License-Identifier: MIT
#include "root.h"

typedef struct wide { // m 2^e, m of moderate size or 0
    dd m;
    int e;
} wide;

static wide leading(const brink_dyadic *a)
{
    wide w;
    w.m = brink_dyadic_leading(a, &w.e); // error < 2u^2
    return w;
}

static wide wide_div(wide x, wide y)
{
    return (wide){dd_div(x.m, y.m), x.e - y.e}; // error <= 16u^2
}

static wide wide_sqrt(wide x)
{
    int odd = x.e & 1;
    dd m = {ldexp(x.m.hi, odd), ldexp(x.m.lo, odd)};
    return (wide){dd_sqrt(m), (x.e - odd) / 2}; // error <= 5u^2
}

/** x + y; where they are more than 2^1000 apart the smaller one may get lost. */
static wide wide_add(wide x, wide y)
{
    if (y.m.hi != 0 && (x.m.hi == 0 || x.e < y.e))
        return wide_add(y, x);
    int shift = y.e - x.e;
    dd m = {ldexp(y.m.hi, shift), ldexp(y.m.lo, shift)};
    return (wide){dd_add(x.m, m), x.e}; // error <= 4u^2 where the signs are equal
}

/** A polynomial a x^2 + 2 b x + c, and its root asked for; a = 0 with
 * BRINK_UPPER: of 2 b x + c. */
typedef struct polynomial {
    const brink_dyadic *a, *b, *c;
    enum brink_which which;
} polynomial;

/** Sign of root - x, exact. */
static int root_minus(const polynomial *p, const brink_dyadic *x)
{
    brink_dyadic ax, slope, sum, rest, value;
    brink_dyadic_mul(&ax, p->a, x);
    brink_dyadic_add(&slope, &ax, p->b); // half the derivative at x
    brink_dyadic_add(&sum, &slope, p->b);
    brink_dyadic_mul(&rest, &sum, x);
    brink_dyadic_add(&value, &rest, p->c);

    // Seen with a > 0 (or rising): behind the vertex the root is on the other
    // side of it; before the vertex the value tells.
    int up = p->a->sign != 0 ? p->a->sign : p->b->sign;
    if (p->which == BRINK_UPPER)
        return up * slope.sign < 0 ? 1 : -up * value.sign;
    return up * slope.sign > 0 ? -1 : up * value.sign;
}

/** The double nearest to the root of p, which is y to 2^-96 of itself. */
static double round_root(const polynomial *p, wide y)
{
    if (y.m.hi == 0)
        return 0;
    brink_dyadic hi, lo, x, middle;
    brink_dyadic_double(&hi, y.m.hi);
    brink_dyadic_double(&lo, y.m.lo);
    brink_dyadic_add(&x, &hi, &lo);
    int magnitude = brink_dyadic_magnitude(&x) + y.e;
    if (magnitude > 1024)
        return x.sign * (double)INFINITY;

    // m 2^last is y cut off, and `below` the 32 bits that follow.  The error of y
    // is at most 2^-96 2^53 = 2^-43 in units of the last place: less than 2^-11
    // of below's.
    int last = magnitude - 53 < -1074 ? -1074 : magnitude - 53;
    uint64_t m = brink_dyadic_bits(&x, last - y.e, 53);
    uint64_t below = brink_dyadic_bits(&x, last - y.e - 32, 32);
    const uint64_t half = UINT64_C(1) << 31;
    int away =
        below >= half; // whether the root is farther from 0 than the midpoint
    if (below == half || below == half - 1) {
        brink_dyadic_integer(&middle, x.sign * (int64_t)(2 * m + 1), last - 1);
        int beyond = x.sign * root_minus(p, &middle);
        away = beyond > 0 || (beyond == 0 && m % 2 == 1); // a tie: to even
    }
    return x.sign * ldexp((double)(m + (uint64_t)away), last);
}

double brink_dyadic_root(const brink_dyadic *a, const brink_dyadic *b,
                         const brink_dyadic *c, const brink_dyadic *d,
                         enum brink_which which)
{
    // The root of the larger magnitude is q / a, the other one c / q, with
    // q = -(b + sign(b) sqrt(d)): nothing cancels.
    wide root = wide_sqrt(leading(d)), q = leading(b);
    root.m = b->sign < 0 ? dd_negate(root.m) : root.m;
    q = wide_add(q, root);
    q.m = dd_negate(q.m); // error <= 9u^2

    // q / a is the upper root where q and a have equal signs.
    polynomial p = {a, b, c, which};
    int upper = (q.m.hi > 0) == (a->sign > 0);
    if (q.m.hi == 0) // b = d = 0: a double root at 0
        return 0;
    wide x = upper == (which == BRINK_UPPER) ? wide_div(q, leading(a))
                                             : wide_div(leading(c), q);
    return round_root(&p, x); // error <= (9 + 2 + 16)u^2 < 2^-101
}

double brink_dyadic_quotient(const brink_dyadic *x, const brink_dyadic *y)
{
    // The root of y t - x, as 2 (y / 2) t - x.
    brink_dyadic half, b, c, zero;
    brink_dyadic_integer(&zero, 0, 0);
    brink_dyadic_integer(&half, 1, -1);
    brink_dyadic_mul(&b, &half, y);
    brink_dyadic_sub(&c, &zero, x);
    polynomial p = {&zero, &b, &c, BRINK_UPPER};
    return round_root(&p, wide_div(leading(x), leading(y))); // error <= 20u^2
}
