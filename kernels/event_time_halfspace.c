// SPDX-License-Identifier: MIT
// A wall is met at f / -f', f = n.(r - c), f' = n.v:
// see event_time.h.  u = 2^-53.
#include "path.h"

#include "event_time.h"
#include "root.h"

static double exact_time(const double r[3], const double v[3], const double n[3],
                         const double c[3])
{
    const double x[6] = {n[0], n[1], n[2], n[0], n[1], n[2]};
    const double y[6] = {r[0], r[1], r[2], -c[0], -c[1], -c[2]};
    brink_dyadic f, rate;
    brink_dyadic_dot(&f, 6, x, y);
    brink_dyadic_dot(&rate, 3, n, v);
    if (rate.sign >= 0)
        return (double)INFINITY;
    if (f.sign <= 0)
        return 0;
    rate.sign = 1;
    return brink_dyadic_quotient(&f, &rate);
}

static int is_finite(const double x[3])
{
    return isfinite(x[0]) && isfinite(x[1]) && isfinite(x[2]);
}

static BRINK_APART double any_time(const double r[3], const double v[3],
                                   const double n[3], const double c[3])
{
    if (!is_finite(r) || !is_finite(v) || !is_finite(n) || !is_finite(c))
        return (double)NAN;
    return exact_time(r, v, n, c);
}

/** f and -f' to 2^-100 of the sizes of their terms. */
typedef struct approach {
    dd f, rate;
    double f_size, rate_size;
} approach;

static approach approach_of(const double r[3], const double v[3],
                            const double n[3], const double c[3])
{
    approach s = {{0, 0}, {0, 0}, 0, 0};
    for (int i = 0; i < 3; i++) {
        s.f = dd_add(
            s.f, dd_mul_d(two_sum(r[i], -c[i]), n[i])); // 2u^2, and 3u^2 a sum
        s.rate = dd_add(s.rate, two_prod(-n[i], v[i]));
        s.f_size += fabs(n[i]) * (fabs(r[i]) + fabs(c[i]));
        s.rate_size += fabs(n[i] * v[i]);
    }
    return s;
}

static int certain_sign(double x, double size)
{
    double error = fma(0x1p-100, size, 0x1p-900);
    return x > error ? 1 : x < -error ? -1 : 0;
}

/** Whether x is known to 2^-75 of itself. */
static int is_known(double x, double size)
{
    return x > fma(0x1p-25, size, 0x1p-800);
}

double brink_halfspace_time(const double r[3], const double v[3],
                            const double n[3], const double c[3])
{
    approach s = approach_of(r, v, n, c);
    if (s.f_size < 0x1p900 && s.rate_size < 0x1p900) {
        int coming = certain_sign(s.rate.hi, s.rate_size);
        if (coming < 0)
            return (double)INFINITY;
        if (coming > 0 && certain_sign(s.f.hi, s.f_size) < 0)
            return 0;
        if (is_known(s.f.hi, s.f_size) && is_known(s.rate.hi, s.rate_size)) {
            dd t = dd_div(s.f, s.rate); // 2^-74 and 16u^2
            if (is_told(t) && t.hi > 0x1p-900 && t.hi < 0x1p900)
                return t.hi;
        }
    }
    return any_time(r, v, n, c);
}
