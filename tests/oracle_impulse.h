// SPDX-License-Identifier: MIT
#ifndef TESTS_ORACLE_IMPULSE_H
#define TESTS_ORACLE_IMPULSE_H
/** What is conserved at a step, and whether it is crossed, in MPFR: exact, as
 *  oracle.h explains. */
#include "oracle.h"
#include <brink/impulse.h>

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

/** The larger |m v|, before or after. */
static inline double oracle_largest_momentum(const oracle_pair *before,
                                             const oracle_pair *after)
{
    const double speed1 = fmax(oracle_size(before->v1), oracle_size(after->v1));
    const double speed2 = fmax(oracle_size(before->v2), oracle_size(after->v2));
    return fmax(before->m1 * speed1, before->m2 * speed2);
}

/** What a component of the pair's momentum is off by: in ulp of the larger |m v|,
 *  before or after. */
static inline double oracle_momentum_error(const oracle_pair *before,
                                           const oracle_pair *after)
{
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
    return most / oracle_ulp_of(oracle_largest_momentum(before, after));
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

/** b = r.(v1 - v2), how much a step changes it, r.r, and whether it is
 *  crossed. */
typedef struct oracle_turn {
    mpfr_t b, change, rr;
    int crosses;
} oracle_turn;

static inline void oracle_turn_make(oracle_turn *t, const double r[3],
                                    double rise, int way, const oracle_pair *p)
{
    mpfr_t after, mass;
    mpfr_inits2(ORACLE_BITS, t->b, t->change, t->rr, after, mass, (mpfr_ptr)0);
    mpfr_set_zero(t->b, 1);
    mpfr_set_zero(t->rr, 1);
    for (int k = 0; k < 3; k++) {
        oracle_add(t->b, 1, r[k], p->v1[k]);
        oracle_add(t->b, -1, r[k], p->v2[k]);
        oracle_add(t->rr, 1, r[k], r[k]);
    }
    // b'^2 = b^2 - 2 rise r.r (m1 + m2) / (m1 m2)
    mpfr_set_d(mass, p->m1, ORACLE_N);
    mpfr_mul_d(mass, mass, p->m2, ORACLE_N);
    mpfr_set_d(after, p->m1, ORACLE_N);
    mpfr_add_d(after, after, p->m2, ORACLE_N);
    mpfr_mul(after, after, t->rr, ORACLE_N);
    mpfr_mul_d(after, after, rise, ORACLE_N);
    mpfr_mul_2ui(after, after, 1, ORACLE_N);
    mpfr_div(after, after, mass, ORACLE_N);
    mpfr_sqr(t->change, t->b, ORACLE_N);
    mpfr_sub(after, t->change, after, ORACLE_N);
    // That quotient is rounded, to 9000 bits: what is equal is seen to be.
    t->crosses = mpfr_sgn(after) > 0;
    if (t->crosses)
        mpfr_sqrt(after, after, ORACLE_N);
    else
        mpfr_set(after, t->b, ORACLE_N);
    mpfr_setsign(after, after, t->crosses ? way < 0 : way > 0, ORACLE_N);
    mpfr_sub(t->change, after, t->b, ORACLE_N);
    mpfr_clears(after, mass, (mpfr_ptr)0);
}

static inline void oracle_turn_clear(oracle_turn *t)
{
    mpfr_clears(t->b, t->change, t->rr, (mpfr_ptr)0);
}

/** Whether the pair's velocities are what the turn leaves of those before, each
 *  component rounded once, up to 2^-90 of the speeds. */
static inline int oracle_turned(const oracle_turn *t, const double r[3],
                                const oracle_pair *before,
                                const oracle_pair *after)
{
    const double speed =
        fmax(fmax(oracle_size(before->v1), oracle_size(before->v2)),
             fmax(oracle_size(after->v1), oracle_size(after->v2)));
    int right = 1;
    mpfr_t x, slope; // slope = change / (r.r (m1 + m2))
    mpfr_inits2(ORACLE_BITS, x, slope, (mpfr_ptr)0);
    mpfr_set_d(x, before->m1, ORACLE_N);
    mpfr_add_d(x, x, before->m2, ORACLE_N);
    mpfr_mul(x, x, t->rr, ORACLE_N);
    mpfr_div(slope, t->change, x, ORACLE_N);
    for (int k = 0; k < 6; k++) {
        const double was = k < 3 ? before->v1[k] : before->v2[k - 3];
        const double is = k < 3 ? after->v1[k] : after->v2[k - 3];
        mpfr_mul_d(x, slope, k < 3 ? before->m2 : -before->m1, ORACLE_N);
        mpfr_mul_d(x, x, r[k % 3], ORACLE_N);
        mpfr_add_d(x, x, was, ORACLE_N);
        const double nearest = mpfr_get_d(x, ORACLE_N);
        mpfr_sub_d(x, x, is, ORACLE_N);
        if (!(fabs(mpfr_get_d(x, ORACLE_N)) <=
              0.5 * oracle_ulp_of(nearest) + 0x1p-90 * speed))
            right = 0;
    }
    mpfr_clears(x, slope, (mpfr_ptr)0);
    return right;
}

/** m1 m2 / (m1 + m2) times the change of b, rounded. */
static inline double oracle_virial(const oracle_turn *t, const oracle_pair *p)
{
    mpfr_t x, mass;
    mpfr_inits2(ORACLE_BITS, x, mass, (mpfr_ptr)0);
    mpfr_set_d(mass, p->m1, ORACLE_N);
    mpfr_add_d(mass, mass, p->m2, ORACLE_N);
    mpfr_mul_d(x, t->change, p->m1, ORACLE_N);
    mpfr_mul_d(x, x, p->m2, ORACLE_N);
    mpfr_div(x, x, mass, ORACLE_N);
    const double virial = mpfr_get_d(x, ORACLE_N);
    mpfr_clears(x, mass, (mpfr_ptr)0);
    return virial;
}

/** sin^2 of the angle to the tangent as a multiple of BRINK_RIM_ANGLE's, no
 *  number at relative rest; whether it is less, and whether it goes inward. */
typedef struct oracle_rim {
    double times;
    int is_below, is_inward;
} oracle_rim;

/** (r.v)^2 and BRINK_RIM_ANGLE^2 r.r v.v, v = v1 - v2. */
static inline oracle_rim oracle_rim_of(const double r[3], const double v1[3],
                                       const double v2[3])
{
    oracle_rim angle;
    mpfr_t b, rr, vv, v;
    mpfr_inits2(ORACLE_BITS, b, rr, vv, v, (mpfr_ptr)0);
    mpfr_set_zero(b, 1);
    mpfr_set_zero(rr, 1);
    mpfr_set_zero(vv, 1);
    for (int k = 0; k < 3; k++) {
        oracle_add(b, 1, r[k], v1[k]);
        oracle_add(b, -1, r[k], v2[k]);
        oracle_add(rr, 1, r[k], r[k]);
        mpfr_set_d(v, v1[k], ORACLE_N);
        mpfr_sub_d(v, v, v2[k], ORACLE_N);
        mpfr_sqr(v, v, ORACLE_N);
        mpfr_add(vv, vv, v, ORACLE_N);
    }
    angle.is_inward = mpfr_sgn(b) < 0;
    mpfr_sqr(b, b, ORACLE_N);
    mpfr_mul(rr, rr, vv, ORACLE_N);
    mpfr_mul_d(rr, rr, BRINK_RIM_ANGLE * BRINK_RIM_ANGLE, ORACLE_N);
    angle.is_below = mpfr_cmp(b, rr) < 0;
    mpfr_div(b, b, rr, ORACLE_N);
    angle.times = mpfr_get_d(b, ORACLE_N);
    mpfr_clears(b, rr, vv, v, (mpfr_ptr)0);
    return angle;
}

/** The largest kinetic energy of either particle, before or after. */
static inline double oracle_largest_energy(const oracle_pair *before,
                                           const oracle_pair *after)
{
    const double v1 = fmax(oracle_size(before->v1), oracle_size(after->v1));
    const double v2 = fmax(oracle_size(before->v2), oracle_size(after->v2));
    return fmax(before->m1 * v1 * v1, before->m2 * v2 * v2) / 2;
}

/** Energy and account after, less those before, `rise` put back: exactly. */
static inline double oracle_off_balance(const oracle_pair *before, double owed,
                                        const oracle_pair *after,
                                        double owed_after, double rise)
{
    mpfr_t sum;
    mpfr_init2(sum, ORACLE_BITS);
    mpfr_set_d(sum, owed_after, ORACLE_N);
    mpfr_sub_d(sum, sum, owed, ORACLE_N);
    mpfr_add_d(sum, sum, rise, ORACLE_N);
    oracle_add_energy(sum, 1, after->m1, after->v1);
    oracle_add_energy(sum, 1, after->m2, after->v2);
    oracle_add_energy(sum, -1, before->m1, before->v1);
    oracle_add_energy(sum, -1, before->m2, before->v2);
    const double off = fabs(mpfr_get_d(sum, ORACLE_N));
    mpfr_clear(sum);
    return off;
}
#endif
