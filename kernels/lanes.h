// SPDX-License-Identifier: MIT
#ifndef BRINK_LANES_H
#define BRINK_LANES_H
/**
 * Two doubles that go through the same arithmetic: less work for one input than
 * one after the other, divisions above all; not installed.
 */
#include "exact.h"
#ifdef __SSE2__
#include <immintrin.h>
#endif

typedef double two_lanes __attribute__((vector_size(16)));

BRINK_INLINE two_lanes lanes_fma(two_lanes x, two_lanes y, two_lanes z)
{
#ifdef __FMA__ // what is below would not be recognised as one instruction
    return (two_lanes)_mm_fmadd_pd((__m128d)x, (__m128d)y, (__m128d)z);
#else
    return (two_lanes){fma(x[0], y[0], z[0]), fma(x[1], y[1], z[1])};
#endif
}

/** Whether x + y, |y| <= 2u |x|, tells in both lanes which double is nearest to
 *  what it stands for, when that is known to 2^-75 of itself: see is_told.  The
 *  doubles go to *nearest. */
BRINK_INLINE int lanes_are_told(two_lanes x, two_lanes y, two_lanes *nearest)
{
    const two_lanes margin = {1 + 0x1p-20, 1 + 0x1p-20};
    two_lanes hi = x + y, again = lanes_fma(y - (hi - x), margin, hi);
    *nearest = hi;
    return (again[0] == hi[0]) & (again[1] == hi[1]);
}
#endif
