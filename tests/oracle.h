// SPDX-License-Identifier: MIT
#ifndef TESTS_ORACLE_H
#define TESTS_ORACLE_H
/**
 * What is right, by MPFR with so many bits that sums and products of doubles are
 * exact.  One more square root and division are rounded, to 9000 bits: a tie
 * between two doubles is a rational number with few bits and comes out exact, and
 * nothing else is as near to one as 2^-8900.
 */
#include <math.h>
#include <mpfr.h>

// A product of four doubles lies between 2^-4296 and 2^4096: 8392 bits, and then
// some for sums.
#ifndef ORACLE_BITS // the same with fewer bits is a rival: see rivals.h
#define ORACLE_BITS 9000
#endif
#define ORACLE_N MPFR_RNDN

/** z += sign x y. */
static inline void oracle_add(mpfr_t z, int sign, double x, double y)
{
    mpfr_t p;
    mpfr_init2(p, ORACLE_BITS);
    mpfr_set_d(p, x, ORACLE_N);
    mpfr_mul_d(p, p, sign * y, ORACLE_N);
    mpfr_add(z, z, p, ORACLE_N);
    mpfr_clear(p);
}

/** f(t) = a t^2 + 2 b t + c of a pair, and d = b^2 - a c. */
typedef struct oracle_path {
    mpfr_t a, b, c, d;
} oracle_path;

static inline void oracle_path_make(oracle_path *p, const double r[3],
                                    const double v[3], double sigma)
{
    mpfr_t ac;
    mpfr_inits2(ORACLE_BITS, p->a, p->b, p->c, p->d, ac, (mpfr_ptr)0);
    mpfr_set_zero(p->a, 1);
    mpfr_set_zero(p->b, 1);
    mpfr_set_zero(p->c, 1);
    for (int i = 0; i < 3; i++) {
        oracle_add(p->a, 1, v[i], v[i]);
        oracle_add(p->b, 1, r[i], v[i]);
        oracle_add(p->c, 1, r[i], r[i]);
    }
    oracle_add(p->c, -1, sigma, sigma);
    mpfr_sqr(p->d, p->b, ORACLE_N);
    mpfr_mul(ac, p->a, p->c, ORACLE_N);
    mpfr_sub(p->d, p->d, ac, ORACLE_N);
    mpfr_clear(ac);
}

static inline void oracle_path_clear(oracle_path *p)
{
    mpfr_clears(p->a, p->b, p->c, p->d, (mpfr_ptr)0);
}

/** Smallest t >= 0 with f <= 0 and f' < 0 [S16 eq. 3]. */
static inline void oracle_intersection(mpfr_t t, const double r[3],
                                       const double v[3], double sigma)
{
    oracle_path p;
    oracle_path_make(&p, r, v, sigma);
    if (mpfr_sgn(p.b) >= 0) // f' = 2 (b + a t) is not negative for any t >= 0
        mpfr_set_inf(t, 1);
    else if (mpfr_sgn(p.c) <= 0) // now
        mpfr_set_zero(t, 1);
    else if (mpfr_sgn(p.d) <= 0) // f > 0 for ever, or f = 0 where f' = 0
        mpfr_set_inf(t, 1);
    else { // (-b - sqrt(d)) / a = c / (sqrt(d) - b)
        mpfr_sqrt(t, p.d, ORACLE_N);
        mpfr_sub(t, t, p.b, ORACLE_N);
        mpfr_div(t, p.c, t, ORACLE_N);
    }
    oracle_path_clear(&p);
}

/** First t >= 0 from which the pair is outside and parting. */
static inline void oracle_disjoint(mpfr_t t, const double r[3], const double v[3],
                                   double sigma)
{
    oracle_path p;
    oracle_path_make(&p, r, v, sigma);
    if (mpfr_zero_p(p.a))
        mpfr_set_inf(t, 1);
    else if (mpfr_sgn(p.b) >= 0 && mpfr_sgn(p.c) >= 0)
        mpfr_set_zero(t, 1);
    else { // the later root, or, where there is none, the closest approach
        if (mpfr_sgn(p.d) > 0)
            mpfr_sqrt(t, p.d, ORACLE_N);
        else
            mpfr_set_zero(t, 1);
        if (mpfr_sgn(p.b) > 0) { // (sqrt(d) - b) / a without its cancellation
            mpfr_add(t, t, p.b, ORACLE_N);
            mpfr_div(t, p.c, t, ORACLE_N);
            mpfr_neg(t, t, ORACLE_N);
        } else {
            mpfr_sub(t, t, p.b, ORACLE_N);
            mpfr_div(t, t, p.a, ORACLE_N);
        }
    }
    oracle_path_clear(&p);
}

/** Smallest t >= 0 with f = n.(r + v t - c) <= 0 and f' = n.v < 0. */
static inline void oracle_halfspace(mpfr_t t, const double r[3],
                                    const double v[3], const double n[3],
                                    const double c[3])
{
    mpfr_t rate;
    mpfr_init2(rate, ORACLE_BITS);
    mpfr_set_zero(rate, 1);
    mpfr_set_zero(t, 1);
    for (int i = 0; i < 3; i++) {
        oracle_add(rate, -1, n[i], v[i]);
        oracle_add(t, 1, n[i], r[i]);
        oracle_add(t, -1, n[i], c[i]);
    }
    if (mpfr_sgn(rate) <= 0)
        mpfr_set_inf(t, 1);
    else if (mpfr_sgn(t) <= 0)
        mpfr_set_zero(t, 1);
    else
        mpfr_div(t, t, rate, ORACLE_N);
    mpfr_clear(rate);
}

/** The real roots of a x^2 + b x + c, counted as brink_quadratic_roots does. */
static inline int oracle_roots(mpfr_t x0, mpfr_t x1, double a, double b, double c)
{
    if (a == 0) {
        if (b == 0)
            return 0;
        mpfr_set_d(x0, -c, ORACLE_N);
        mpfr_div_d(x0, x0, b, ORACLE_N);
        return 1;
    }
    mpfr_t d, ac;
    mpfr_inits2(ORACLE_BITS, d, ac, (mpfr_ptr)0);
    mpfr_set_d(d, b, ORACLE_N);
    mpfr_sqr(d, d, ORACLE_N);
    mpfr_set_ui(ac, 4, ORACLE_N);
    mpfr_mul_d(ac, ac, a, ORACLE_N);
    mpfr_mul_d(ac, ac, c, ORACLE_N);
    mpfr_sub(d, d, ac, ORACLE_N);
    int count = mpfr_sgn(d) < 0 ? 0 : 2;
    if (count == 2) { // -(b + sign(b) sqrt(d)) / 2 = q: roots q / a and c / q
        mpfr_sqrt(d, d, ORACLE_N);
        if (b < 0)
            mpfr_neg(d, d, ORACLE_N);
        mpfr_add_d(d, d, b, ORACLE_N);
        mpfr_div_2ui(d, d, 1, ORACLE_N);
        mpfr_neg(d, d, ORACLE_N);
        mpfr_div_d(x0, d, a, ORACLE_N);
        if (mpfr_zero_p(d))
            mpfr_set_zero(x1, 1);
        else
            mpfr_d_div(x1, c, d, ORACLE_N);
        if (mpfr_greater_p(x0, x1))
            mpfr_swap(x0, x1);
    }
    mpfr_clears(d, ac, (mpfr_ptr)0);
    return count;
}

/**
 * |x - exact| in ulp, those of the exact value's binade; an infinite x counts as
 * 2^1024, so rounding to infinity from the edge is an error like any other.  0
 * where x is the infinity the exact value is or rounds to; +inf for NaN and for a
 * missed infinity.
 */
static inline double oracle_ulps(double x, const mpfr_t exact)
{
    if (x != x || (mpfr_inf_p(exact) && x != mpfr_get_d(exact, ORACLE_N)))
        return (double)INFINITY;
    if (x == mpfr_get_d(exact, ORACLE_N) && (isinf(x) || mpfr_zero_p(exact)))
        return 0;
    mpfr_t error;
    mpfr_init2(error, ORACLE_BITS);
    if (isinf(x))
        mpfr_set_si_2exp(error, x > 0 ? 1 : -1, 1024, ORACLE_N);
    else
        mpfr_set_d(error, x, ORACLE_N);
    mpfr_sub(error, error, exact, ORACLE_N);
    mpfr_abs(error, error, ORACLE_N);
    mpfr_exp_t e = mpfr_zero_p(exact) ? -1074 : mpfr_get_exp(exact) - 53;
    mpfr_mul_2si(error, error, -(long)(e < -1074 ? -1074 : e), ORACLE_N);
    double ulps = mpfr_get_d(error, MPFR_RNDU);
    mpfr_clear(error);
    return ulps;
}
#endif
