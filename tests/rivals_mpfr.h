// SPDX-License-Identifier: MIT
/** oracle.h as rivals, in ORACLE_BITS bits; NAME(f) is a name for f in them. */
#include "oracle_overlap.h"
#include "rivals.h"

int NAME(roots)(double a, double b, double c, double *x0, double *x1)
{
    mpfr_t x, y;
    mpfr_inits2(ORACLE_BITS, x, y, (mpfr_ptr)0);
    const int count = oracle_roots(x, y, a, b, c);
    if (count > 0)
        *x0 = mpfr_get_d(x, ORACLE_N);
    if (count > 1)
        *x1 = mpfr_get_d(y, ORACLE_N);
    mpfr_clears(x, y, (mpfr_ptr)0);
    return count;
}

typedef void time_oracle(mpfr_t t, const double r[3], const double v[3],
                         double sigma);

static double time_by(time_oracle *oracle, const double r[3], const double v[3],
                      double sigma)
{
    mpfr_t t;
    mpfr_init2(t, ORACLE_BITS);
    oracle(t, r, v, sigma);
    const double nearest = mpfr_get_d(t, ORACLE_N);
    mpfr_clear(t);
    return nearest;
}

double NAME(intersection)(const double r[3], const double v[3], double sigma)
{
    return time_by(oracle_intersection, r, v, sigma);
}

double NAME(disjoint)(const double r[3], const double v[3], double sigma)
{
    return time_by(oracle_disjoint, r, v, sigma);
}

double NAME(halfspace_time)(const double r[3], const double v[3],
                            const double n[3], const double c[3])
{
    mpfr_t t;
    mpfr_init2(t, ORACLE_BITS);
    oracle_halfspace(t, r, v, n, c);
    const double nearest = mpfr_get_d(t, ORACLE_N);
    mpfr_clear(t);
    return nearest;
}

double NAME(ball)(const double r[3], const double v[3], double sigma, double t)
{
    mpfr_t f;
    mpfr_init2(f, ORACLE_BITS);
    oracle_ball(f, r, v, sigma, t);
    const double nearest = mpfr_get_d(f, ORACLE_N);
    mpfr_clear(f);
    return nearest;
}

double NAME(plane)(const double r[3], const double v[3], const double n[3],
                   const double c[3], double t)
{
    mpfr_t f;
    mpfr_init2(f, ORACLE_BITS);
    oracle_plane(f, r, v, n, c, t);
    const double nearest = mpfr_get_d(f, ORACLE_N);
    mpfr_clear(f);
    return nearest;
}
