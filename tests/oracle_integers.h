// SPDX-License-Identifier: MIT
#ifndef TESTS_ORACLE_INTEGERS_H
#define TESTS_ORACLE_INTEGERS_H
/**
 * Roots of quadratics with small whole coefficients, judged in whole numbers
 * alone: nothing is rounded here, and nothing shared with oracle.h.
 *
 * For |a|, |b|, |c| <= 60 a root other than 0 is between 2^-6 and 2^6 in
 * magnitude.  A double there and the points halfway to its neighbours are M 2^-k
 * with |M| < 2^56, k <= 60, and the polynomial is a M^2 + b M 2^k + c 2^2k in
 * units of 2^-2k: less than 2^127.
 */
#include <math.h>

__extension__ typedef __int128 whole;

static inline int sign_of_whole(whole x)
{
    return (x > 0) - (x < 0);
}

/** -1, 0, 1: M 2^-k lies before, on, or behind the lower (which = -1) or upper
 *  (1) root of a x^2 + b x + c, a > 0, which has real ones. */
static inline int side_of_root(int a, int b, int c, int which, whole M, int k)
{
    const whole unit = (whole)1 << k, slope = 2 * a * M + b * unit;
    const whole value = (a * M + b * unit) * M + c * unit * unit;
    if (which * sign_of_whole(slope) < 0) // across the vertex
        return -which;
    return which * sign_of_whole(value);
}

/** Whether x is the double nearest to that root, a != 0.  A root halfway between
 *  two doubles would be a fraction of six bits below, and none of those is. */
static inline int is_nearest_root(int a, int b, int c, int which, double x)
{
    if (a < 0)
        return is_nearest_root(-a, -b, -c, which, x);
    const int is_zero = c == 0 && b * which >= 0;
    if (x == 0 || is_zero)
        return x == 0 && is_zero;
    if (!(fabs(x) > 0x1p-6 && fabs(x) < 0x1p6))
        return 0;
    int e;
    const int is_power = fabs(frexp(x, &e)) == 0.5, k = 55 - e;
    const whole M = (whole)ldexp(x, k), way = x > 0 ? 1 : -1;
    const whole inner = M - way * (is_power ? 1 : 2), outer = M + way * 2;
    const int before = side_of_root(a, b, c, which, x > 0 ? inner : outer, k);
    const int behind = side_of_root(a, b, c, which, x > 0 ? outer : inner, k);
    return before < 0 && behind > 0;
}
#endif
