// SPDX-License-Identifier: MIT
#ifndef BRINK_DYADIC_H
#define BRINK_DYADIC_H
/**
 * Exact arithmetic for what double-double cannot decide; not installed.
 *
 * A dyadic number is sign * sum of limb[i] 2^(32 (low + i)), exact at any
 * magnitude.  Every number here is a polynomial in doubles and is simply written
 * down; nothing is rounded until the end.  No result may be one of the operands.
 *
 * Capacity: a double, or a midpoint of two, is a multiple of 2^-1075 and less
 * than 2^1024 in magnitude, so it lies in limbs -34 to 31, 66 of them.  The
 * highest degree is 6 (m1 m2 (r.v)^2 in brink_step_impulse); each factor may be a
 * sum and have one limb more for its carries, and so may the result: 6 * 67 + 1.
 */
#include "exact.h"

#define BRINK_DYADIC_DEGREE 6
#define BRINK_DYADIC_LIMBS  (67 * BRINK_DYADIC_DEGREE + 1)

typedef struct brink_dyadic {
    int sign;  // -1, 0, 1
    int low;   // place of limb[0]
    int count; // limbs in use; the last of them is not 0
    uint32_t limb[BRINK_DYADIC_LIMBS];
} brink_dyadic;

/** z = m 2^e. */
void brink_dyadic_integer(brink_dyadic *z, int64_t m, int e);
/** z = x, which is finite. */
void brink_dyadic_double(brink_dyadic *z, double x);
void brink_dyadic_add(brink_dyadic *z, const brink_dyadic *a,
                      const brink_dyadic *b);
void brink_dyadic_sub(brink_dyadic *z, const brink_dyadic *a,
                      const brink_dyadic *b);
void brink_dyadic_mul(brink_dyadic *z, const brink_dyadic *a,
                      const brink_dyadic *b);
/** z = sum of x[i] y[i], i < n. */
void brink_dyadic_dot(brink_dyadic *z, int n, const double *x, const double *y);

/** The p for which 2^(p-1) <= |a| < 2^p; a is not 0. */
int brink_dyadic_magnitude(const brink_dyadic *a);
/** Bits of |a| from place `from` up, `count` <= 53 of them, as an integer. */
uint64_t brink_dyadic_bits(const brink_dyadic *a, int from, int count);
/** The double nearest to a, ties to even, out of range as IEEE has it. */
double brink_dyadic_round(const brink_dyadic *a);
/** a = (hi + lo) 2^*e, |hi + lo| in [1/2, 1], to 2u^2 of itself; 0 and *e = 0
 *  for 0. */
dd brink_dyadic_leading(const brink_dyadic *a, int *e);
#endif
