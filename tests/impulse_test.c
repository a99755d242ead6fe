// SPDX-License-Identifier: MIT
#include "oracle.h"
#include "pairs.h"
#include "suite.h"
#include <brink/impulse.h>

enum { CASES = 4000, SEED = 1 };

/** What two particles do at a step. */
typedef struct impact {
    double r[3], m1, m2, rise, v1[3], v2[3];
    enum brink_direction way;
} impact;

static void stop(const char *what, int i, const impact *p, const double v1[3],
                 const double v2[3])
{
    ck_abort_msg("%s, case %d (seed %d):\nr %a %a %a  m %a %a  rise %a  way %d\n"
                 "v1 %a %a %a  v2 %a %a %a\nafter %a %a %a  %a %a %a",
                 what, i, SEED, p->r[0], p->r[1], p->r[2], p->m1, p->m2, p->rise,
                 p->way, p->v1[0], p->v1[1], p->v1[2], p->v2[0], p->v2[1],
                 p->v2[2], v1[0], v1[1], v1[2], v2[0], v2[1], v2[2]);
}

static double ulp_of(double x)
{
    return nextafter(fabs(x), (double)INFINITY) - fabs(x);
}

/** z += factor m v.v / 2; returns the kinetic energy. */
static double add_energy(mpfr_t z, int factor, double m, const double v[3])
{
    mpfr_t e;
    mpfr_init2(e, ORACLE_BITS);
    mpfr_set_zero(e, 1);
    for (int i = 0; i < 3; i++)
        oracle_add(e, 1, v[i], v[i]);
    mpfr_mul_d(e, e, m, ORACLE_N);
    mpfr_div_2ui(e, e, 1, ORACLE_N);
    double energy = mpfr_get_d(e, ORACLE_N);
    mpfr_mul_si(e, e, factor, ORACLE_N);
    mpfr_add(z, z, e, ORACLE_N);
    mpfr_clear(e);
    return energy;
}

/** The pair's energy, changed by `rise`, right to 4 ulp of the larger kinetic
 *  energy, and its momentum to 2 ulp of the larger |m v|. */
static void keep_what_is_conserved(int i, const impact *p, double rise,
                                   const double v1[3], const double v2[3])
{
    mpfr_t change;
    mpfr_init2(change, ORACLE_BITS);
    mpfr_set_d(change, rise, ORACLE_N);
    double largest = add_energy(change, -1, p->m1, p->v1);
    largest = fmax(largest, add_energy(change, -1, p->m2, p->v2));
    largest = fmax(largest, add_energy(change, 1, p->m1, v1));
    largest = fmax(largest, add_energy(change, 1, p->m2, v2));
    if (fabs(mpfr_get_d(change, ORACLE_N)) >
        BRINK_IMPULSE_ENERGY_ULP * ulp_of(largest))
        stop("energy", i, p, v1, v2);

    double size = fmax(p->m1 * fmax(length_of(p->v1), length_of(v1)),
                       p->m2 * fmax(length_of(p->v2), length_of(v2)));
    for (int k = 0; k < 3; k++) {
        mpfr_set_zero(change, 1);
        oracle_add(change, -1, p->m1, p->v1[k]);
        oracle_add(change, -1, p->m2, p->v2[k]);
        oracle_add(change, 1, p->m1, v1[k]);
        oracle_add(change, 1, p->m2, v2[k]);
        if (fabs(mpfr_get_d(change, ORACLE_N)) >
            BRINK_IMPULSE_MOMENTUM_ULP * ulp_of(size))
            stop("momentum", i, p, v1, v2);
    }
    mpfr_clear(change);
}

/** What is exact: whether the pair crosses, and the change of b = r.(v1 - v2). */
static int oracle_impulse(mpfr_t change, mpfr_t rr, const impact *p)
{
    mpfr_t b, after, mass;
    mpfr_inits2(ORACLE_BITS, b, after, mass, (mpfr_ptr)0);
    mpfr_set_zero(b, 1);
    mpfr_set_zero(rr, 1);
    for (int k = 0; k < 3; k++) {
        oracle_add(b, 1, p->r[k], p->v1[k]);
        oracle_add(b, -1, p->r[k], p->v2[k]);
        oracle_add(rr, 1, p->r[k], p->r[k]);
    }
    // b'^2 = b^2 - 2 rise r.r (m1 + m2) / (m1 m2)
    mpfr_set_d(mass, p->m1, ORACLE_N);
    mpfr_mul_d(mass, mass, p->m2, ORACLE_N);
    mpfr_set_d(after, p->m1, ORACLE_N);
    mpfr_add_d(after, after, p->m2, ORACLE_N);
    mpfr_mul(after, after, rr, ORACLE_N);
    mpfr_mul_d(after, after, p->rise, ORACLE_N);
    mpfr_mul_2ui(after, after, 1, ORACLE_N);
    mpfr_div(after, after, mass, ORACLE_N);
    mpfr_sqr(change, b, ORACLE_N);
    mpfr_sub(after, change, after, ORACLE_N);
    // That quotient is rounded, to 9000 bits: what is equal is seen to be.
    int crosses = mpfr_sgn(after) > 0;
    if (crosses)
        mpfr_sqrt(after, after, ORACLE_N);
    else
        mpfr_set(after, b, ORACLE_N);
    if (crosses)
        mpfr_setsign(after, after, p->way < 0, ORACLE_N);
    else
        mpfr_setsign(after, after, p->way > 0, ORACLE_N);
    mpfr_sub(change, after, b, ORACLE_N);
    mpfr_clears(b, after, mass, (mpfr_ptr)0);
    return crosses;
}

/** Each component is the exact one rounded once, up to 2^-90 of the speeds. */
static void keep_velocity(int i, const impact *p, const mpfr_t change,
                          const mpfr_t rr, int which, const double v1[3],
                          const double v2[3])
{
    const double *before = which == 1 ? p->v1 : p->v2,
                 *after = which == 1 ? v1 : v2;
    double other = which == 1 ? p->m2 : p->m1;
    double speed = fmax(fmax(length_of(p->v1), length_of(p->v2)),
                        fmax(length_of(v1), length_of(v2)));
    mpfr_t x, mass;
    mpfr_inits2(ORACLE_BITS, x, mass, (mpfr_ptr)0);
    for (int k = 0; k < 3; k++) {
        mpfr_set_d(mass, p->m1, ORACLE_N);
        mpfr_add_d(mass, mass, p->m2, ORACLE_N);
        mpfr_mul_d(x, change, which == 1 ? other : -other, ORACLE_N);
        mpfr_mul_d(x, x, p->r[k], ORACLE_N);
        mpfr_div(x, x, mass, ORACLE_N);
        mpfr_div(x, x, rr, ORACLE_N);
        mpfr_add_d(x, x, before[k], ORACLE_N);
        double nearest = mpfr_get_d(x, ORACLE_N);
        mpfr_sub_d(x, x, after[k], ORACLE_N);
        if (fabs(mpfr_get_d(x, ORACLE_N)) >
            0.5 * ulp_of(nearest) + 0x1p-90 * speed)
            stop(which == 1 ? "v1" : "v2", i, p, v1, v2);
    }
    mpfr_clears(x, mass, (mpfr_ptr)0);
}

static void keep(int i, const impact *p)
{
    double v1[3], v2[3], virial;
    memcpy(v1, p->v1, sizeof v1);
    memcpy(v2, p->v2, sizeof v2);
    int crossed =
        brink_step_impulse(p->r, p->m1, p->m2, p->rise, p->way, v1, v2, &virial);
    mpfr_t change, rr;
    mpfr_inits2(ORACLE_BITS, change, rr, (mpfr_ptr)0);
    if (crossed != oracle_impulse(change, rr, p))
        stop(crossed ? "crossed" : "reflected", i, p, v1, v2);
    keep_velocity(i, p, change, rr, 1, v1, v2);
    keep_velocity(i, p, change, rr, 2, v1, v2);
    keep_what_is_conserved(i, p, crossed ? p->rise : 0, v1, v2);
    double mu = p->m1 / (p->m1 + p->m2) * p->m2, b = mpfr_get_d(change, ORACLE_N);
    if (!(fabs(virial - mu * b) <= 0x1p-50 * fabs(mu * b)))
        stop("virial", i, p, v1, v2);
    mpfr_clears(change, rr, (mpfr_ptr)0);
}

/** A pair at a step, on the surface to a few ulp; masses up to 1e12 apart. */
static void random_impact(stream *s, impact *p)
{
    fill_normal(s, p->r, 1);
    resize(p->r, 1 + stream_int(s, -4, 4) * 0x1p-52);
    p->m1 = stream_real(s, 0.5, 2);
    p->m2 = stream_real(s, 0.5, 2);
    if (stream_int(s, 0, 1))
        p->m2 *= pow(10, stream_real(s, -11.5, 11.5));
    fill_normal(s, p->v1, 1);
    fill_normal(s, p->v2, stream_int(s, 0, 1) ? 1 : sqrt(p->m1 / p->m2));
    double b = 0, vv = 0;
    for (int k = 0; k < 3; k++) {
        b += p->r[k] * (p->v1[k] - p->v2[k]);
        vv += (p->v1[k] - p->v2[k]) * (p->v1[k] - p->v2[k]);
    }
    p->way = b < 0 ? BRINK_INWARD : BRINK_OUTWARD;
    double mu = p->m1 / (p->m1 + p->m2) * p->m2;
    switch (stream_int(s, 0, 3)) {
    case 0:
        p->rise = stream_real(s, -1, 1) * mu * vv;
        break;
    case 1:
        p->rise = stream_scaled(s, -60, 4) * mu * vv;
        break;
    case 2: // on the brink
        p->rise = stream_near(s, mu * b * b / 2, 3);
        break;
    default: // a small step, as of a potential mapped to many
        p->rise = stream_real(s, -1, 1) * 0x1p-10 * mu * b * b;
    }
}

START_TEST(energy_momentum_and_decision_are_right)
{
    stream s = {SEED};
    for (int i = 0; i < CASES; i++) {
        impact p;
        random_impact(&s, &p);
        keep(i, &p);
        p.way = p.way == BRINK_INWARD ? BRINK_OUTWARD : BRINK_INWARD;
        keep(i, &p); // b has the wrong sign, by far more than rounding can
    }
}
END_TEST

START_TEST(scaling_by_powers_of_two_changes_nothing_else)
{
    stream s = {SEED};
    for (int i = 0; i < CASES; i++) {
        impact p;
        random_impact(&s, &p);
        int er = stream_int(&s, -900, 900), ev = stream_int(&s, -300, 300);
        int em = stream_int(&s, -300, 300);
        impact q = p;
        for (int k = 0; k < 3; k++) {
            q.r[k] = ldexp(p.r[k], er);
            q.v1[k] = ldexp(p.v1[k], ev);
            q.v2[k] = ldexp(p.v2[k], ev);
        }
        q.m1 = ldexp(p.m1, em);
        q.m2 = ldexp(p.m2, em);
        q.rise = ldexp(p.rise, em + 2 * ev);
        double w1, w2;
        int one =
            brink_step_impulse(p.r, p.m1, p.m2, p.rise, p.way, p.v1, p.v2, &w1);
        int two =
            brink_step_impulse(q.r, q.m1, q.m2, q.rise, q.way, q.v1, q.v2, &w2);
        ck_assert_int_eq(one, two);
        for (int k = 0; k < 3; k++) {
            ck_assert(ldexp(p.v1[k], ev) == q.v1[k]);
            ck_assert(ldexp(p.v2[k], ev) == q.v2[k]);
        }
        ck_assert(ldexp(w1, er + ev + em) == w2);
    }
}
END_TEST

START_TEST(extreme_rises_do_as_they_must)
{
    const double r[3] = {1, 0, 0};
    double v1[3] = {-1, 0, 0}, v2[3] = {0, 0, 0}, virial;
    ck_assert_int_eq(
        brink_step_impulse(r, 1, 1, DBL_MAX, BRINK_INWARD, v1, v2, &virial), 0);
    ck_assert(v1[0] == 0 && v2[0] == -1 && virial == 1);
    ck_assert_int_eq(
        brink_step_impulse(r, 1, 1, -0x1p1000, BRINK_OUTWARD, v1, v2, &virial),
        1);
    ck_assert(v1[0] == 0x1p500 && v2[0] == -0x1p500);
    ck_assert_int_eq(
        brink_step_impulse(r, 1, 1, -0x1p-1074, BRINK_OUTWARD, v1, v2, &virial),
        1);
    ck_assert(v1[0] == 0x1p500 && v2[0] == -0x1p500);
    double w1[3] = {0x1p-400, 0, 0}, w2[3] = {0, 0, 0};
    ck_assert_int_eq(
        brink_step_impulse(r, 1, 1, -0x1p700, BRINK_OUTWARD, w1, w2, &virial), 1);
    ck_assert(w1[0] == 0x1p350 && w2[0] == -0x1p350);
}
END_TEST

START_TEST(radial_energy_equal_to_the_rise_does_not_suffice)
{
    // mu b^2 / (2 r.r) = 1/2 1 / 2 = 1/4
    const double r[3] = {1, 0, 0};
    for (int ulps = -1; ulps <= 1; ulps++) {
        double v1[3] = {-1, 2, 0}, v2[3] = {0, 0, 0}, virial;
        double rise = ulps < 0   ? nextafter(0.25, 0)
                      : ulps > 0 ? nextafter(0.25, 1)
                                 : 0.25;
        ck_assert_int_eq(
            brink_step_impulse(r, 1, 1, rise, BRINK_INWARD, v1, v2, &virial),
            ulps < 0);
        if (ulps >= 0)
            ck_assert(v1[0] == 0 && v2[0] == -1 && v1[1] == 2);
    }
}
END_TEST

START_TEST(equality_is_decided_where_double_double_cannot)
{
    // m1 = 2 i (i + j), m2 = 2 j (i + j): mu = 2 i j, but not so in
    // double-double, where j / (i + j) comes first.  v = k r, so
    // mu b^2 / (2 r.r) = i j k^2 r.r.
    stream s = {SEED};
    for (int c = 0; c < CASES; c++) {
        double i = stream_int(&s, 1, 1 << 8), j = stream_int(&s, 1, 1 << 8);
        double m1 = 2 * i * (i + j), m2 = 2 * j * (i + j);
        double k = stream_int(&s, 1, 1 << 8), r[3], rr = 0, virial;
        for (int axis = 0; axis < 3; axis++) {
            r[axis] = stream_int(&s, 1, 1 << 9);
            rr += r[axis] * r[axis];
        }
        for (int ulps = -1; ulps <= 1; ulps++) {
            double rise = i * j * k * k * rr, v1[3], v2[3] = {0, 0, 0};
            for (int axis = 0; axis < 3; axis++)
                v1[axis] = k * r[axis];
            rise = ulps < 0   ? nextafter(rise, 0)
                   : ulps > 0 ? nextafter(rise, DBL_MAX)
                              : rise;
            ck_assert_int_eq(brink_step_impulse(r, m1, m2, rise, BRINK_OUTWARD,
                                                v1, v2, &virial),
                             ulps < 0);
        }
    }
}
END_TEST

START_TEST(no_radial_motion_does_not_cross_a_step_of_nothing)
{
    const double r[3] = {1, 0, 0};
    double v1[3] = {0, 1, 0}, v2[3] = {0, 0, 0}, virial;
    ck_assert_int_eq(
        brink_step_impulse(r, 1, 1, 0, BRINK_INWARD, v1, v2, &virial), 0);
    ck_assert(v1[0] == 0 && v1[1] == 1 && virial == 0);
}
END_TEST

START_TEST(cores_reflect_elastically)
{
    stream s = {SEED};
    for (int i = 0; i < CASES; i++) {
        impact p;
        random_impact(&s, &p);
        double v1[3], v2[3];
        memcpy(v1, p.v1, sizeof v1);
        memcpy(v2, p.v2, sizeof v2);
        double virial = brink_core_impulse(p.r, p.m1, p.m2, v1, v2);
        keep_what_is_conserved(i, &p, 0, v1, v2);
        if (p.way == BRINK_OUTWARD) { // going apart already: nothing to do
            ck_assert_double_eq(virial, 0);
            ck_assert(memcmp(v1, p.v1, sizeof v1) == 0 &&
                      memcmp(v2, p.v2, sizeof v2) == 0);
            continue;
        }
        mpfr_t change, rr;
        mpfr_inits2(ORACLE_BITS, change, rr, (mpfr_ptr)0);
        p.rise = DBL_MAX;
        oracle_impulse(change, rr, &p);
        keep_velocity(i, &p, change, rr, 1, v1, v2);
        keep_velocity(i, &p, change, rr, 2, v1, v2);
        ck_assert_double_gt(virial, 0);
        mpfr_clears(change, rr, (mpfr_ptr)0);
    }
}
END_TEST

/** Sine of the angle that the relative velocity makes with the tangent,
 *  outward > 0. */
static double angle(const impact *p, const double v1[3], const double v2[3])
{
    double b = 0, v[3];
    for (int k = 0; k < 3; k++) {
        v[k] = v1[k] - v2[k];
        b += p->r[k] * v[k];
    }
    return b / (length_of(p->r) * length_of(v));
}

START_TEST(pairs_on_the_rim_are_turned_inward)
{
    stream s = {SEED};
    for (int i = 0; i < CASES; i++) {
        impact p;
        pair_case rim;
        random_impact(&s, &p);
        family_rim(&s, &rim);
        double before = stream_scaled(&s, -60, -20) * length_of(rim.v);
        memcpy(p.r, rim.r, sizeof p.r);
        for (int k = 0; k < 3; k++)
            p.v1[k] = p.v2[k] + rim.v[k] + before * rim.r[k];
        double v1[3], v2[3];
        memcpy(v1, p.v1, sizeof v1);
        memcpy(v2, p.v2, sizeof v2);
        double sine = angle(&p, v1, v2);
        int turned = brink_rim_impulse(p.r, p.m1, p.m2, v1, v2);
        // The sine above is off by some ulp of the velocities.
        double slack = 0x1p-50 * (1 + length_of(p.v2) / length_of(rim.v));
        if (turned != (fabs(sine) < BRINK_RIM_ANGLE) &&
            fabs(fabs(sine) - BRINK_RIM_ANGLE) > slack)
            stop("rim", i, &p, v1, v2);
        if (!turned) {
            ck_assert(memcmp(v1, p.v1, sizeof v1) == 0 &&
                      memcmp(v2, p.v2, sizeof v2) == 0);
            continue;
        }
        keep_what_is_conserved(i, &p, 0, v1, v2);
        slack =
            0x1p-50 * (1 + (length_of(v1) + length_of(v2)) / length_of(rim.v));
        if (fabs(angle(&p, v1, v2) + BRINK_RIM_ANGLE) > slack)
            stop("rim angle", i, &p, v1, v2);
    }
}
END_TEST

START_TEST(pairs_at_relative_rest_stay_so)
{
    const double r[3] = {1, 0, 0};
    double v1[3] = {1, 2, 3}, v2[3] = {1, 2, 3};
    ck_assert_double_eq(brink_core_impulse(r, 1, 2, v1, v2), 0);
    ck_assert_int_eq(brink_rim_impulse(r, 1, 2, v1, v2), 0);
    ck_assert(v1[0] == 1 && v1[1] == 2 && v1[2] == 3);
}
END_TEST

int main(void)
{
    return RUN_SUITE("impulse", 600, energy_momentum_and_decision_are_right,
                     scaling_by_powers_of_two_changes_nothing_else,
                     extreme_rises_do_as_they_must,
                     radial_energy_equal_to_the_rise_does_not_suffice,
                     equality_is_decided_where_double_double_cannot,
                     no_radial_motion_does_not_cross_a_step_of_nothing,
                     cores_reflect_elastically,
                     pairs_on_the_rim_are_turned_inward,
                     pairs_at_relative_rest_stay_so);
}
