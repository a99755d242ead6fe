// SPDX-License-Identifier: MIT
#ifndef BRINK_EXACT_H
#define BRINK_EXACT_H
/**
 * What the kernels are made of, and not installed with them: error-free transforms,
 * double-double arithmetic, and exact dyadic numbers for what those cannot decide.
 *
 * u = 2^-53 is the unit roundoff.  Rounding is to nearest, ties to even.
 */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#ifdef __FAST_MATH__
#error "brink's results rest on IEEE arithmetic: do not compile it with -ffast-math"
#endif
#if FLT_EVAL_METHOD != 0
#error "brink needs doubles to be rounded to double (on old x86: -msse2 -mfpmath=sse)"
#endif

/** Always inlined, so that a body compiled for hardware with fma() has it throughout. */
#define BRINK_INLINE static inline __attribute__((always_inline))

// --- Error-free transforms -----------------------------------------------------------

typedef struct dd { // the unevaluated sum hi + lo, |lo| <= u |hi|
    double hi, lo;
} dd;

/** hi + lo = a + b, exactly, unless a + b overflows. */
BRINK_INLINE dd two_sum(double a, double b)
{
    double s = a + b, t = s - a;
    return (dd){s, (a - (s - t)) + (b - t)};
}

/** The same where |a| >= |b| or a = 0. */
BRINK_INLINE dd fast_two_sum(double a, double b)
{
    double s = a + b;
    return (dd){s, b - (s - a)};
}

/** hi + lo = a b, exactly, where a b neither overflows nor has bits below 2^-1074. */
BRINK_INLINE dd two_prod(double a, double b)
{
    double p = a * b;
    return (dd){p, fma(a, b, -p)};
}

// --- Double-double -------------------------------------------------------------------
// Errors relative to the exact result, barring over- and underflow.  The algorithms and
// bounds are those of Joldes, Muller, Popescu (2017), ACM TOMS 44(2); the square
// root's of Lefevre, Louvet, Muller, Picot, Rideau (2023), ACM TOMS 49(1), 1.

BRINK_INLINE dd dd_negate(dd x)
{
    return (dd){-x.hi, -x.lo}; // exact
}

BRINK_INLINE dd dd_add(dd x, dd y)
{
    dd s = two_sum(x.hi, y.hi), t = two_sum(x.lo, y.lo);
    dd v = fast_two_sum(s.hi, s.lo + t.hi);
    return fast_two_sum(v.hi, t.lo + v.lo); // error <= 3u^2 + 13u^3
}

BRINK_INLINE dd dd_add_d(dd x, double y)
{
    dd s = two_sum(x.hi, y);
    return fast_two_sum(s.hi, x.lo + s.lo); // error <= 2u^2
}

BRINK_INLINE dd dd_mul(dd x, dd y)
{
    dd p = two_prod(x.hi, y.hi);
    double t = fma(x.lo, y.hi, fma(x.hi, y.lo, x.lo * y.lo));
    return fast_two_sum(p.hi, p.lo + t); // error <= 4u^2
}

BRINK_INLINE dd dd_mul_d(dd x, double y)
{
    dd p = two_prod(x.hi, y);
    return fast_two_sum(p.hi, fma(x.lo, y, p.lo)); // error <= 2u^2
}

BRINK_INLINE dd dd_div(dd x, dd y)
{
    double q = x.hi / y.hi;
    dd r = dd_mul_d(y, q);
    double d = (x.hi - r.hi) + (x.lo - r.lo);
    return fast_two_sum(q, d / y.hi); // error <= 15u^2 + 56u^3
}

BRINK_INLINE dd dd_sqrt(dd x)
{
    if (x.hi == 0)
        return x;
    double s = sqrt(x.hi);
    double d = fma(-s, s, x.hi) + x.lo;
    return fast_two_sum(s, d / (2 * s)); // error <= 25/8 u^2
}

// --- Powers of two -------------------------------------------------------------------

BRINK_INLINE uint64_t bits_of(double x)
{
    uint64_t b;
    memcpy(&b, &x, sizeof b);
    return b;
}

BRINK_INLINE double double_of(uint64_t b)
{
    double x;
    memcpy(&x, &b, sizeof x);
    return x;
}

/** The biased exponent: 0 for zero and subnormals, 2047 for infinities and NaN. */
BRINK_INLINE int biased_exponent(double x)
{
    return (int)(bits_of(x) >> 52 & 0x7ff);
}

/** 2^e, -1022 <= e <= 1023. */
BRINK_INLINE double power_of_two(int e)
{
    return double_of((uint64_t)(e + 1023) << 52);
}

// --- Dyadic numbers ------------------------------------------------------------------
/**
 * sign * sum of limb[i] 2^(32 (low + i)), exact at any magnitude.  Every number here is
 * a polynomial in doubles and is simply written down; nothing is rounded until
 * brink_dyadic_round.  No result may be one of the operands.
 *
 * Capacity: a double, or a midpoint of two, is a multiple of 2^-1075 and less than
 * 2^1024 in magnitude, so it lies in limbs -34 to 31, 66 of them.  The highest degree is
 * 6 (m1 m2 (r.v)^2 in brink_step_impulse); each factor may be a sum and have one limb
 * more for its carries, and so may the result: 6 * 67 + 1.
 */
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
void brink_dyadic_add(brink_dyadic *z, const brink_dyadic *a, const brink_dyadic *b);
void brink_dyadic_sub(brink_dyadic *z, const brink_dyadic *a, const brink_dyadic *b);
void brink_dyadic_mul(brink_dyadic *z, const brink_dyadic *a, const brink_dyadic *b);
/** z = sum of x[i] y[i], i < n. */
void brink_dyadic_dot(brink_dyadic *z, int n, const double *x, const double *y);

/** The double nearest to a, ties to even, over- and underflow as IEEE has them. */
double brink_dyadic_round(const brink_dyadic *a);
/** a = (hi + lo) 2^*e with |hi + lo| in [1/2, 1], error < 2u^2 relative; 0 for 0. */
dd brink_dyadic_leading(const brink_dyadic *a, int *e);
#endif
