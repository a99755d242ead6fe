// SPDX-License-Identifier: MIT
#ifndef BRINK_SUM_H
#define BRINK_SUM_H
/**
 * Sums as if in twice the precision (Neumaier 1974; Ogita, Rump, Oishi 2005:
 * Dot2): what was lost at each step is carried beside the sum.  The value of n
 * terms is within 1 ulp + n^2 2^-106 sum |terms|.
 */
#include <math.h>

typedef struct brink_sum {
    double sum, carry;
} brink_sum;

static inline void brink_sum_add(brink_sum *s, double x)
{
    const double sum = s->sum + x;
    const double rest = sum - s->sum;
    s->carry += (s->sum - (sum - rest)) + (x - rest); // two_sum's error, exact
    s->sum = sum;
}

static inline void brink_sum_product(brink_sum *s, double x, double y)
{
    const double product = x * y;
    brink_sum_add(s, product);
    s->carry += fma(x, y, -product); // exact unless it underflows
}

static inline double brink_sum_value(const brink_sum *s)
{
    return s->sum + s->carry;
}
#endif
