// SPDX-License-Identifier: MIT
#ifndef BRINK_LANES_H
#define BRINK_LANES_H
/** Two doubles that go through the same arithmetic; not installed. */
#include "exact.h"
#ifdef __FMA__
#include <immintrin.h>
#endif

typedef double two_lanes __attribute__((vector_size(16)));

BRINK_INLINE two_lanes lanes_fma(two_lanes x, two_lanes y, two_lanes z)
{
#ifdef __FMA__ // what follows would be two instructions
    return (two_lanes)_mm_fmadd_pd((__m128d)x, (__m128d)y, (__m128d)z);
#else
    return (two_lanes){fma(x[0], y[0], z[0]), fma(x[1], y[1], z[1])};
#endif
}

/** x + y - s for s = x + y rounded: exact. */
BRINK_INLINE two_lanes lanes_lost(two_lanes s, two_lanes x, two_lanes y)
{
    two_lanes t = s - x;
    return (x - (s - t)) + (y - t);
}
#endif
