// SPDX-License-Identifier: MIT
#ifndef BRINK_EVENT_TIME_LANES_H
#define BRINK_EVENT_TIME_LANES_H
/** Two doubles that go through the same arithmetic, which is less work for a
 *  single pair; not installed. */
#include "event_time_sums.h"
#ifdef __FMA__
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

/** x + y - s for s = x + y rounded: exact. */
BRINK_INLINE two_lanes lanes_lost(two_lanes s, two_lanes x, two_lanes y)
{
    two_lanes t = s - x;
    return (x - (s - t)) + (y - t);
}

/** What sums_of(r, v, sigma) is, bit for bit: b in lane 0, c in lane 1. */
BRINK_INLINE sums sums_in_lanes(const double r[3], const double v[3],
                                double sigma)
{
    two_lanes p[4], e[4];
    for (int i = 0; i < 3; i++) {
        two_lanes x = {v[i], r[i]}, y = {r[i], r[i]};
        p[i] = x * y;
        e[i] = lanes_fma(x, y, -p[i]);
    }
    dd q = two_prod(-sigma, sigma);
    p[3] = (two_lanes){0, q.hi};
    e[3] = (two_lanes){0, q.lo};
    two_lanes s = p[0] + p[1], t = s + p[2], w = t + p[3];
    two_lanes lost = lanes_lost(s, p[0], p[1]) + lanes_lost(t, s, p[2]);
    lost = ((e[0] + e[1]) + (e[2] + e[3])) + (lost + lanes_lost(w, t, p[3]));
    double size = t[1] - q.hi;
    return (sums){{w[0], lost[0]}, {w[1], lost[1]}, 0x1.8p-104 * size, size};
}
#endif
