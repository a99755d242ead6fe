// SPDX-License-Identifier: MIT
#ifndef TESTS_ORACLE_OVERLAP_H
#define TESTS_ORACLE_OVERLAP_H
/** The overlap functions in MPFR: exact, as oracle.h explains. */
#include "oracle.h"

/** |r + v t|^2 - sigma^2 */
static inline void oracle_ball(mpfr_t f, const double r[3], const double v[3],
                               double sigma, double t)
{
    mpfr_t x;
    mpfr_init2(x, ORACLE_BITS);
    mpfr_set_zero(f, 1);
    for (int i = 0; i < 3; i++) {
        mpfr_set_d(x, r[i], ORACLE_N);
        oracle_add(x, 1, v[i], t);
        mpfr_sqr(x, x, ORACLE_N);
        mpfr_add(f, f, x, ORACLE_N);
    }
    oracle_add(f, -1, sigma, sigma);
    mpfr_clear(x);
}

/** n.(r + v t - c) */
static inline void oracle_plane(mpfr_t f, const double r[3], const double v[3],
                                const double n[3], const double c[3], double t)
{
    mpfr_t x;
    mpfr_init2(x, ORACLE_BITS);
    mpfr_set_zero(f, 1);
    for (int i = 0; i < 3; i++) {
        mpfr_set_d(x, r[i], ORACLE_N);
        oracle_add(x, 1, v[i], t);
        mpfr_sub_d(x, x, c[i], ORACLE_N);
        mpfr_mul_d(x, x, n[i], ORACLE_N);
        mpfr_add(f, f, x, ORACLE_N);
    }
    mpfr_clear(x);
}
#endif
