// SPDX-License-Identifier: MIT
#include "path.h"

#include "event_time.h"
#include "event_time_fast.h"

static BRINK_APART double intersection_rescued(const double r[3],
                                               const double v[3], double sigma)
{
    scaled_pair p;
    if (!scale_pair(&p, r, v, sigma))
        return (double)NAN;
    outline o = outline_of(p.r, p.v, p.sigma);
    return scaled(meeting_time_fast(&o), p.unit);
}

double brink_intersection_time_fast(const double r[3], const double v[3],
                                    double sigma)
{
    outline o = outline_of(r, v, sigma);
    if (!is_in_range_fast(&o, sigma))
        return intersection_rescued(r, v, sigma);
    return meeting_time_fast(&o);
}

static BRINK_APART double disjoint_rescued(const double r[3], const double v[3],
                                           double sigma)
{
    scaled_pair p;
    if (!scale_pair(&p, r, v, sigma))
        return (double)NAN;
    if (largest_of(p.v) == 0)
        return (double)INFINITY;
    return scaled(parting_time_fast(p.r, p.v, p.sigma), p.unit);
}

double brink_disjoint_time_fast(const double r[3], const double v[3],
                                double sigma)
{
    double a = dot_rounded(v, v), rr = dot_rounded(r, r), ss = sigma * sigma;
    if (!(are_in_range(a, rr + ss) && sigma >= 0))
        return disjoint_rescued(r, v, sigma);
    return parting_time_fast(r, v, sigma);
}
