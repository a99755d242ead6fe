// SPDX-License-Identifier: MIT
#ifndef BRINK_EXACT_H
#define BRINK_EXACT_H
/**
 * What the kernels are made of, and not installed with them: error-free
 * transforms and double-double arithmetic.  What those cannot decide is
 * dyadic.h's.
 *
 * u = 2^-53 is the unit roundoff.  Rounding is to nearest, ties to even.
 */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>
#ifdef __SSE2__
#include <immintrin.h>
#endif

#ifdef __FAST_MATH__
#error "brink rests on IEEE arithmetic: do not compile it with -ffast-math"
#endif
#if FLT_EVAL_METHOD != 0
#error "brink needs doubles to be rounded to double: -mfpmath=sse"
#endif

/** Always inlined: a body compiled for hardware with fma() has it throughout. */
#define BRINK_INLINE static inline __attribute__((always_inline))

/** Not inlined, so that what is rare takes no registers from what is not. */
#define BRINK_APART __attribute__((noinline))

// --- Error-free transforms -----------------------------------------------------

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

/** hi + lo = a b, exactly, where a b neither overflows nor has bits below
 * 2^-1074. */
BRINK_INLINE dd two_prod(double a, double b)
{
    double p = a * b;
    return (dd){p, fma(a, b, -p)};
}

BRINK_INLINE double sum_of(dd x) // rounded once
{
    return x.hi + x.lo;
}

// --- Double-double -------------------------------------------------------------
//
// Errors relative to the exact result, barring over- and underflow.  The
// algorithms and bounds are those of Joldes, Muller, Popescu (2017), ACM TOMS
// 44(2); the bound of dd_mul is that of Muller, Rideau (2022), ACM TOMS 48(1),
// as the first one's proof had a flaw; the square root's are those of Lefevre,
// Louvet, Muller, Picot, Rideau (2023), ACM TOMS 49(1), 1.  What kernels build on
// is what proofs/ has: 6.2u^2 of dd_mul, 13.2u^2 of dd_div, 4.2u^2 of dd_sqrt,
// and of the sums what stands here.

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

// --- Choices -------------------------------------------------------------------
//
// Without a branch, whatever the compiler thinks: these are asked where either
// answer is as likely.

#ifdef __SSE2__
/** x in the low half of a register, whose high half does not matter: GCC spends
 *  an instruction on clearing that. */
BRINK_INLINE __m128d in_register(double x)
{
#ifdef __clang__
    return _mm_set_sd(x);
#else
    __m128d v;
    __asm__("" : "=x"(v) : "0"(x));
    return v;
#endif
}
#endif

BRINK_INLINE double larger(double x, double y) // y, if one is not a number
{
#ifdef __SSE2__
    return _mm_cvtsd_f64(_mm_max_sd(in_register(x), in_register(y)));
#else
    return x > y ? x : y;
#endif
}

BRINK_INLINE double smaller(double x, double y) // y, if one is not a number
{
#ifdef __SSE2__
    return _mm_cvtsd_f64(_mm_min_sd(in_register(x), in_register(y)));
#else
    return x < y ? x : y;
#endif
}

/** y where the sign bit of x is set, otherwise z. */
BRINK_INLINE double if_negative(double x, double y, double z)
{
#ifdef __AVX__
    __m128d chosen =
        _mm_blendv_pd(in_register(z), in_register(y), in_register(x));
    return _mm_cvtsd_f64(chosen);
#else
    return signbit(x) ? y : z;
#endif
}

// --- Powers of two -------------------------------------------------------------

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

/** Whether all are in [2^-512, 2^512): also tells NaN, infinities and the
 *  negative. */
BRINK_INLINE int are_moderate(double x, double y, double z)
{
    const uint64_t least = 1023 - 512, exponents = 1024; // a power of two
    uint64_t all = (bits_of(x) >> 52) - least;
    all |= ((bits_of(y) >> 52) - least) | ((bits_of(z) >> 52) - least);
    return all < exponents;
}

/** Whether x is in [2^-512, 2^512). */
BRINK_INLINE int is_moderate(double x)
{
    return are_moderate(x, x, x);
}

/**
 * Whether x.hi is the double nearest to what x stands for, |x.lo| <= u |x.hi|,
 * when that is known to 2^-70 of itself.  Only where x.lo is within that of half
 * an ulp can it be another, and there 2^-15 more brings the sum past the
 * midpoint; at a power of two, below which the midpoint is a quarter of an ulp
 * away, that still is 2^-70.
 */
BRINK_INLINE int is_told(dd x)
{
    return fma(x.lo, 1 + 0x1p-15, x.hi) == x.hi;
}

/** Of a number that is not 0: its sign bit. */
BRINK_INLINE int sign_of(double x)
{
    return -(int)(bits_of(x) >> 63) | 1;
}

/** The biased exponent: 0 of zero and subnormals, 2047 of infinities and NaN. */
BRINK_INLINE int biased_exponent(double x)
{
    return (int)(bits_of(x) >> 52 & 0x7ff);
}

/** The e for which scaling by 2^-e brings the largest of n numbers into [1, 2),
 * or as near to it as a power of two among the normal doubles can. */
BRINK_INLINE int common_exponent(int n, const double *x)
{
    int biased = 0;
    for (int i = 0; i < n; i++)
        if (biased_exponent(x[i]) > biased)
            biased = biased_exponent(x[i]);
    return biased > 2045 ? 1022 : biased < 1 ? -1022 : biased - 1023;
}

/** 2^e, -1022 <= e <= 1023. */
BRINK_INLINE double power_of_two(int e)
{
    return double_of((uint64_t)(e + 1023) << 52);
}

/** x 2^e, |e| <= 2044, rounded once if x 2^(e/2) is normal. */
BRINK_INLINE double scaled(double x, int e)
{
    return x * power_of_two(e / 2) * power_of_two(e - e / 2);
}
#endif
