// SPDX-License-Identifier: MIT
#ifndef BRINK_EVENT_TIME_LANES_H
#define BRINK_EVENT_TIME_LANES_H
/** What the event times do in two lanes; not installed. */
#include "event_time_sums.h"
#include "lanes.h"

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
