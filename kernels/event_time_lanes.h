// SPDX-License-Identifier: MIT
#ifndef BRINK_EVENT_TIME_LANES_H
#define BRINK_EVENT_TIME_LANES_H
/** What the event times do in lanes; not installed. */
#include "event_time_sums.h"
#include "lanes.h"

/** x + y - s for s = x + y rounded: exact. */
BRINK_INLINE two_lanes lanes_lost(two_lanes s, two_lanes x, two_lanes y)
{
    two_lanes t = s - x;
    return (x - (s - t)) + (y - t);
}

typedef double four_lanes __attribute__((vector_size(32)));

/** *e = x y - p for p = x y rounded: exact.  By address, as not every path can
 *  hand over so many lanes. */
BRINK_INLINE void four_lost_by_product(four_lanes *e, const four_lanes *x,
                                       const four_lanes *y, const four_lanes *p)
{
#ifdef __FMA__
    *e = (four_lanes)_mm256_fmsub_pd((__m256d)*x, (__m256d)*y, (__m256d)*p);
#else
    for (int k = 0; k < 4; k++)
        (*e)[k] = fma((*x)[k], (*y)[k], -(*p)[k]);
#endif
}

/** *sum += x, and *lost += what rounding that loses. */
BRINK_INLINE void four_add(four_lanes *sum, four_lanes *lost, const four_lanes *x)
{
    four_lanes s = *sum + *x, t = s - *sum;
    *lost += (*sum - (s - t)) + (*x - t);
    *sum = s;
}

/** What sums_of(r, v, sigma) is, bit for bit: b, c and a in lanes 0 to 2, and a
 *  again in the last. */
BRINK_INLINE sums sums_in_lanes(const double r[3], const double v[3],
                                double sigma)
{
    four_lanes p[4], e[4];
    for (int i = 0; i < 3; i++) {
        four_lanes x = {v[i], r[i], v[i], v[i]}, y = {r[i], r[i], v[i], v[i]};
        p[i] = x * y;
        four_lost_by_product(&e[i], &x, &y, &p[i]);
    }
    dd q = two_prod(-sigma, sigma);
    p[3] = (four_lanes){0, q.hi, 0, 0};
    e[3] = (four_lanes){0, q.lo, 0, 0};
    four_lanes sum = p[0], lost = {0, 0, 0, 0};
    four_add(&sum, &lost, &p[1]);
    four_add(&sum, &lost, &p[2]);
    double size = sum[1] - q.hi;
    four_add(&sum, &lost, &p[3]);
    lost += (e[0] + e[1]) + (e[2] + e[3]);
    return (sums){{sum[2], lost[2]},
                  {sum[0], lost[0]},
                  {sum[1], lost[1]},
                  0x1.8p-104 * size,
                  size};
}

/** dot_of(r, v) and dot_of(r, r), bit for bit. */
BRINK_INLINE two_dots dots_in_lanes(const double r[3], const double v[3])
{
    two_lanes p[3], e[3];
    for (int i = 0; i < 3; i++) {
        two_lanes x = {v[i], r[i]}, y = {r[i], r[i]};
        p[i] = x * y;
        e[i] = lanes_fma(x, y, -p[i]);
    }
    two_lanes s = p[0] + p[1], t = s + p[2];
    two_lanes lost = lanes_lost(s, p[0], p[1]) + lanes_lost(t, s, p[2]);
    lost = (e[0] + e[1] + e[2]) + lost;
    return (two_dots){{t[0], lost[0]}, {t[1], lost[1]}};
}
#endif
