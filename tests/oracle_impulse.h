// SPDX-License-Identifier: MIT
#ifndef TESTS_ORACLE_IMPULSE_H
#define TESTS_ORACLE_IMPULSE_H
/** What is conserved at a step, and whether it is crossed, in MPFR: exact, as
 *  oracle.h explains. */
#include "oracle.h"

/** Two particles: their masses and velocities. */
typedef struct oracle_pair {
    double m1, m2;
    const double *v1, *v2;
} oracle_pair;

static inline double oracle_ulp_of(double x)
{
    return nextafter(fabs(x), (double)INFINITY) - fabs(x);
}

/** z += sign m v.v / 2; returns that kinetic energy. */
static inline double oracle_add_energy(mpfr_t z, int sign, double m,
                                       const double v[3])
{
    mpfr_t e;
    mpfr_init2(e, ORACLE_BITS);
    mpfr_set_zero(e, 1);
    for (int i = 0; i < 3; i++)
        oracle_add(e, 1, v[i], v[i]);
    mpfr_mul_d(e, e, m, ORACLE_N);
    mpfr_div_2ui(e, e, 1, ORACLE_N);
    const double energy = mpfr_get_d(e, ORACLE_N);
    mpfr_mul_si(e, e, sign, ORACLE_N);
    mpfr_add(z, z, e, ORACLE_N);
    mpfr_clear(e);
    return energy;
}

/** What the pair's energy is off by where `rise` of it was to go: in ulp of the
 *  larger kinetic energy, before or after. */
static inline double oracle_energy_error(const oracle_pair *before,
                                         const oracle_pair *after, double rise)
{
    mpfr_t change;
    mpfr_init2(change, ORACLE_BITS);
    mpfr_set_d(change, rise, ORACLE_N);
    double largest = oracle_add_energy(change, -1, before->m1, before->v1);
    largest =
        fmax(largest, oracle_add_energy(change, -1, before->m2, before->v2));
    largest = fmax(largest, oracle_add_energy(change, 1, after->m1, after->v1));
    largest = fmax(largest, oracle_add_energy(change, 1, after->m2, after->v2));
    const double off = fabs(mpfr_get_d(change, ORACLE_N));
    mpfr_clear(change);
    return off / oracle_ulp_of(largest);
}

static inline double oracle_size(const double x[3])
{
    return sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
}

/** What a component of the pair's momentum is off by: in ulp of the larger |m v|,
 *  before or after. */
static inline double oracle_momentum_error(const oracle_pair *before,
                                           const oracle_pair *after)
{
    const double speed1 = fmax(oracle_size(before->v1), oracle_size(after->v1));
    const double speed2 = fmax(oracle_size(before->v2), oracle_size(after->v2));
    const double size = fmax(before->m1 * speed1, before->m2 * speed2);
    double most = 0;
    mpfr_t change;
    mpfr_init2(change, ORACLE_BITS);
    for (int i = 0; i < 3; i++) {
        mpfr_set_zero(change, 1);
        oracle_add(change, -1, before->m1, before->v1[i]);
        oracle_add(change, -1, before->m2, before->v2[i]);
        oracle_add(change, 1, after->m1, after->v1[i]);
        oracle_add(change, 1, after->m2, after->v2[i]);
        most = fmax(most, fabs(mpfr_get_d(change, ORACLE_N)));
    }
    mpfr_clear(change);
    return most / oracle_ulp_of(size);
}

/** Crossed where m1 m2 b^2 > 2 rise r.r (m1 + m2), b = r.(v1 - v2). */
static inline int oracle_crosses(const double r[3], double rise,
                                 const oracle_pair *p)
{
    mpfr_t b, rr, mass;
    mpfr_inits2(ORACLE_BITS, b, rr, mass, (mpfr_ptr)0);
    mpfr_set_zero(b, 1);
    mpfr_set_zero(rr, 1);
    for (int i = 0; i < 3; i++) {
        oracle_add(b, 1, r[i], p->v1[i]);
        oracle_add(b, -1, r[i], p->v2[i]);
        oracle_add(rr, 2, r[i], r[i]);
    }
    mpfr_set_d(mass, p->m1, ORACLE_N);
    mpfr_add_d(mass, mass, p->m2, ORACLE_N);
    mpfr_mul(rr, rr, mass, ORACLE_N);
    mpfr_mul_d(rr, rr, rise, ORACLE_N);
    mpfr_sqr(b, b, ORACLE_N);
    mpfr_mul_d(b, b, p->m1, ORACLE_N);
    mpfr_mul_d(b, b, p->m2, ORACLE_N);
    const int crosses = mpfr_cmp(b, rr) > 0;
    mpfr_clears(b, rr, mass, (mpfr_ptr)0);
    return crosses;
}
#endif
