// SPDX-License-Identifier: MIT
#include "event_time.h"
#include "root.h"

static double halfspace_exact(const double r[3], const double v[3],
                              const double n[3], const double c[3])
{
    const double x[6] = {n[0], n[1], n[2], n[0], n[1], n[2]};
    const double y[6] = {r[0], r[1], r[2], -c[0], -c[1], -c[2]};
    brink_dyadic rate, f;
    brink_dyadic_dot(&rate, 3, n, v);
    brink_dyadic_dot(&f, 6, x, y);
    if (rate.sign >= 0)
        return (double)INFINITY;
    if (f.sign <= 0)
        return 0;
    rate.sign = 1;
    return brink_dyadic_quotient(&f, &rate);
}

static int all_finite(const double x[3])
{
    return isfinite(x[0]) && isfinite(x[1]) && isfinite(x[2]);
}

double brink_halfspace_time_cr(const double r[3], const double v[3],
                               const double n[3], const double c[3])
{
    if (!all_finite(r) || !all_finite(v) || !all_finite(n) || !all_finite(c))
        return (double)NAN;
    return halfspace_exact(r, v, n, c);
}

double brink_halfspace_time(const double r[3], const double v[3],
                            const double n[3], const double c[3])
{
    return brink_halfspace_time_cr(r, v, n, c);
}
