// SPDX-License-Identifier: MIT
#include "event_time.h"
#include "root.h"

static int in_domain(const double r[3], const double v[3], double sigma)
{
    double zero = 0 * r[0] + 0 * r[1] + 0 * r[2] + 0 * v[0] + 0 * v[1] +
                  0 * v[2] + 0 * sigma;
    return zero == 0 && sigma >= 0;
}

typedef struct path { // f(t) = a t^2 + 2 b t + c, d = b^2 - a c
    brink_dyadic a, b, c, d;
} path;

static void path_make(path *p, const double r[3], const double v[3], double sigma)
{
    const double x[4] = {r[0], r[1], r[2], sigma},
                 y[4] = {r[0], r[1], r[2], -sigma};
    brink_dyadic bb, ac;
    brink_dyadic_dot(&p->a, 3, v, v);
    brink_dyadic_dot(&p->b, 3, r, v);
    brink_dyadic_dot(&p->c, 4, x, y);
    brink_dyadic_mul(&bb, &p->b, &p->b);
    brink_dyadic_mul(&ac, &p->a, &p->c);
    brink_dyadic_sub(&p->d, &bb, &ac);
}

static double intersection_exact(const double r[3], const double v[3],
                                 double sigma)
{
    path p;
    path_make(&p, r, v, sigma);
    if (p.b.sign >= 0)
        return (double)INFINITY;
    if (p.c.sign <= 0)
        return 0;
    if (p.d.sign <= 0)
        return (double)INFINITY;
    return brink_dyadic_root(&p.a, &p.b, &p.c, &p.d, BRINK_LOWER);
}

static double disjoint_exact(const double r[3], const double v[3], double sigma)
{
    path p;
    path_make(&p, r, v, sigma);
    if (p.a.sign == 0)
        return (double)INFINITY;
    if (p.b.sign >= 0 && p.c.sign >= 0)
        return 0;
    if (p.d.sign > 0)
        return brink_dyadic_root(&p.a, &p.b, &p.c, &p.d, BRINK_UPPER);
    p.b.sign = -p.b.sign;
    return brink_dyadic_quotient(&p.b, &p.a);
}

double brink_intersection_time_cr(const double r[3], const double v[3],
                                  double sigma)
{
    if (!in_domain(r, v, sigma))
        return (double)NAN;
    return intersection_exact(r, v, sigma);
}

double brink_disjoint_time_cr(const double r[3], const double v[3], double sigma)
{
    if (!in_domain(r, v, sigma))
        return (double)NAN;
    return disjoint_exact(r, v, sigma);
}

static double dot(const double x[3], const double y[3])
{
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}

static double cross_squared(const double r[3], const double v[3])
{
    double x, s = 0;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        double p = r[k] * v[j], e = fma(r[k], v[j], -p);
        x = fma(r[j], v[k], -p) - e;
        s += x * x;
    }
    return s;
}

typedef struct floats {
    double a, b, c, d;
    int sure; // signs are certain and the root well conditioned
} floats;

static floats floats_make(const double r[3], const double v[3], double sigma)
{
    floats p;
    double rr = dot(r, r), ss = sigma * sigma, x = cross_squared(r, v);
    p.a = dot(v, v);
    p.b = dot(r, v);
    p.c = rr - ss;
    p.d = ss * p.a - x;
    double rv = fabs(r[0] * v[0]) + fabs(r[1] * v[1]) + fabs(r[2] * v[2]);
    int in_range = rr > 0x1p-300 && rr < 0x1p300 && p.a > 0x1p-300 &&
                   p.a < 0x1p300 && ss > 0x1p-300 && ss < 0x1p300;
    p.sure = in_range && fabs(p.c) > 0.5 * (rr + ss) && fabs(p.b) > 0.25 * rv &&
             fabs(p.d) > 0.5 * (ss * p.a + x);
    return p;
}

double brink_intersection_time(const double r[3], const double v[3], double sigma)
{
    if (!in_domain(r, v, sigma))
        return (double)NAN;
    floats p = floats_make(r, v, sigma);
    if (!p.sure)
        return intersection_exact(r, v, sigma);
    if (p.b >= 0)
        return (double)INFINITY;
    if (p.c <= 0)
        return 0;
    if (p.d <= 0)
        return (double)INFINITY;
    return p.c / (sqrt(p.d) - p.b);
}

double brink_intersection_time_fast(const double r[3], const double v[3],
                                    double sigma)
{
    return brink_intersection_time(r, v, sigma);
}

double brink_disjoint_time(const double r[3], const double v[3], double sigma)
{
    if (!in_domain(r, v, sigma))
        return (double)NAN;
    floats p = floats_make(r, v, sigma);
    if (!p.sure)
        return disjoint_exact(r, v, sigma);
    if (p.b >= 0 && p.c >= 0)
        return 0;
    if (p.d <= 0)
        return -p.b / p.a;
    return p.b > 0 ? -p.c / (sqrt(p.d) + p.b) : (sqrt(p.d) - p.b) / p.a;
}

double brink_disjoint_time_fast(const double r[3], const double v[3],
                                double sigma)
{
    return brink_disjoint_time(r, v, sigma);
}

double brink_halfspace_time_cr(const double r[3], const double v[3],
                               const double n[3], const double c[3])
{
    if (!in_domain(r, v, 0) || !in_domain(n, c, 0))
        return (double)NAN;
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

double brink_halfspace_time(const double r[3], const double v[3],
                            const double n[3], const double c[3])
{
    return brink_halfspace_time_cr(r, v, n, c);
}

#define BATCH(name, kernel)                                                      \
    void name(size_t n, const double *rx, const double *ry, const double *rz,    \
              const double *vx, const double *vy, const double *vz,              \
              const double *sigma, double *t)                                    \
    {                                                                            \
        for (size_t i = 0; i < n; i++) {                                         \
            const double r[3] = {rx[i], ry[i], rz[i]},                           \
                         v[3] = {vx[i], vy[i], vz[i]};                           \
            t[i] = kernel(r, v, sigma[i]);                                       \
        }                                                                        \
    }

BATCH(brink_intersection_times, brink_intersection_time)
BATCH(brink_intersection_times_fast, brink_intersection_time_fast)
BATCH(brink_disjoint_times, brink_disjoint_time)
BATCH(brink_disjoint_times_fast, brink_disjoint_time_fast)
