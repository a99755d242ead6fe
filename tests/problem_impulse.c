// SPDX-License-Identifier: MIT
// What two particles do at a step, or at a hard core.  Two measures: the pair's
// energy, in ulp of the largest kinetic energy of one of them, and its momentum,
// in ulp of the largest |m v|.
#include "arithmetics.h"
#include "oracle.h"
#include "pairs.h"
#include "problems_all.h"
#include <brink/impulse.h>

/** r m1 m2 v1 v2, and at a step its rise and the way. */
enum { R = 0, M1 = 3, M2 = 4, V1 = 5, V2 = 8, RISE = 11, WAY = 12 };

enum { EQUAL, MASSES, BRINK, SMALL, SCALED, FAMILIES };

static const char *family(int k)
{
    static const char *const names[FAMILIES] = {"equal", "masses", "brink",
                                                "small", "scaled"};
    return names[k];
}

static double rise_for(int k, stream *s, double mu, double b, double vv)
{
    switch (k) {
    case BRINK: // the energy that is there, to a few ulp
        return stream_near(s, mu * b * b / 2, 3);
    case SMALL: // a step of a potential mapped to many
        return stream_real(s, -1, 1) * 0x1p-10 * mu * b * b;
    default:
        return stream_real(s, -1, 1) * mu * vv;
    }
}

/** On the surface to a few ulp; masses up to 1e12 apart, or equal in EQUAL. */
static void make(int k, stream *s, double *x)
{
    fill_normal(s, x + R, 1);
    resize(x + R, 1 + stream_int(s, -4, 4) * 0x1p-52);
    x[M1] = stream_real(s, 0.5, 2);
    x[M2] = k == EQUAL ? x[M1] : x[M1] * pow(10, stream_real(s, -11.5, 11.5));
    fill_normal(s, x + V1, 1);
    fill_normal(s, x + V2, stream_int(s, 0, 1) ? 1 : sqrt(x[M1] / x[M2]));
    double b = 0, vv = 0;
    for (int i = 0; i < 3; i++) {
        const double v = x[V1 + i] - x[V2 + i];
        b += x[R + i] * v;
        vv += v * v;
    }
    x[WAY] = b < 0 ? BRINK_INWARD : BRINK_OUTWARD;
    x[RISE] = rise_for(k, s, x[M1] / (x[M1] + x[M2]) * x[M2], b, vv);
    if (k != SCALED)
        return;
    const int lengths = stream_int(s, -600, 600),
              speeds = stream_int(s, -300, 300),
              masses = stream_int(s, -300, 300);
    for (int i = 0; i < 3; i++) {
        x[R + i] = ldexp(x[R + i], lengths);
        x[V1 + i] = ldexp(x[V1 + i], speeds);
        x[V2 + i] = ldexp(x[V2 + i], speeds);
    }
    x[M1] = ldexp(x[M1], masses);
    x[M2] = ldexp(x[M2], masses);
    x[RISE] = ldexp(x[RISE], masses + 2 * speeds);
}

/** Of the families those in which the rise is not what matters. */
static const int core_families[] = {EQUAL, MASSES, SCALED};

static const char *core_family(int k)
{
    return family(core_families[k]);
}

static void make_core(int k, stream *s, double *x)
{
    double step[13];
    make(core_families[k], s, step);
    memcpy(x, step, 11 * sizeof *x);
}

// --- The right answers ---------------------------------------------------------

/** Crossed where m1 m2 b^2 > 2 rise r.r (m1 + m2). */
static void solve(const double *x, truth *t)
{
    mpfr_t b, rr, mass;
    mpfr_inits2(ORACLE_BITS, b, rr, mass, (mpfr_ptr)0);
    mpfr_set_zero(b, 1);
    mpfr_set_zero(rr, 1);
    for (int i = 0; i < 3; i++) {
        oracle_add(b, 1, x[R + i], x[V1 + i]);
        oracle_add(b, -1, x[R + i], x[V2 + i]);
        oracle_add(rr, 2, x[R + i], x[R + i]);
    }
    mpfr_set_d(mass, x[M1], ORACLE_N);
    mpfr_add_d(mass, mass, x[M2], ORACLE_N);
    mpfr_mul(rr, rr, mass, ORACLE_N);
    mpfr_mul_d(rr, rr, x[RISE], ORACLE_N);
    mpfr_sqr(b, b, ORACLE_N);
    mpfr_mul_d(b, b, x[M1], ORACLE_N);
    mpfr_mul_d(b, b, x[M2], ORACLE_N);
    t->n = mpfr_cmp(b, rr) > 0;
    mpfr_clears(b, rr, mass, (mpfr_ptr)0);
}

static void solve_core(const double *x, truth *t)
{
    (void)x;
    t->n = 0;
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
    mpfr_mul_d(e, e, m / 2, ORACLE_N);
    const double energy = mpfr_get_d(e, ORACLE_N);
    mpfr_mul_si(e, e, factor, ORACLE_N);
    mpfr_add(z, z, e, ORACLE_N);
    mpfr_clear(e);
    return energy;
}

/** y: the velocities afterwards. */
static double energy_error(const double *x, const double *y, double rise)
{
    mpfr_t change;
    mpfr_init2(change, ORACLE_BITS);
    mpfr_set_d(change, rise, ORACLE_N);
    double largest = add_energy(change, -1, x[M1], x + V1);
    largest = fmax(largest, add_energy(change, -1, x[M2], x + V2));
    largest = fmax(largest, add_energy(change, 1, x[M1], y));
    largest = fmax(largest, add_energy(change, 1, x[M2], y + 3));
    const double error = fabs(mpfr_get_d(change, ORACLE_N)) / ulp_of(largest);
    mpfr_clear(change);
    return error;
}

static double momentum_error(const double *x, const double *y)
{
    const double size = fmax(x[M1] * fmax(length_of(x + V1), length_of(y)),
                             x[M2] * fmax(length_of(x + V2), length_of(y + 3)));
    double error = 0;
    mpfr_t change;
    mpfr_init2(change, ORACLE_BITS);
    for (int k = 0; k < 3; k++) {
        mpfr_set_zero(change, 1);
        oracle_add(change, -1, x[M1], x[V1 + k]);
        oracle_add(change, -1, x[M2], x[V2 + k]);
        oracle_add(change, 1, x[M1], y[k]);
        oracle_add(change, 1, x[M2], y[3 + k]);
        error = fmax(error, fabs(mpfr_get_d(change, ORACLE_N)) / ulp_of(size));
    }
    mpfr_clear(change);
    return error;
}

static verdict judge(const double *x, const truth *t, int n, const double *y)
{
    verdict v = {n == t->n ? WRONG_NOT : WRONG_SIDE, {0, 0}};
    for (int k = 0; k < 6; k++)
        if (!isfinite(y[k]))
            return (verdict){WRONG_SPURIOUS,
                             {(double)INFINITY, (double)INFINITY}};
    v.error[0] = energy_error(x, y, n ? x[RISE] : 0);
    v.error[1] = momentum_error(x, y);
    return v;
}

// --- Ways ----------------------------------------------------------------------

/** What a kernel leaves in v1, v2 and the virial, as an answer. */
static void take(answers *out, int i, const double v1[3], const double v2[3],
                 double virial)
{
    for (int k = 0; k < 3; k++) {
        out->x[k][i] = v1[k];
        out->x[3 + k][i] = v2[k];
    }
    out->x[6][i] = virial;
}

#define STEP(kernel, way_type)                                                   \
    LOOP(kernel##_loop, {                                                        \
        double v1[3] = {p[V1], p[V1 + 1], p[V1 + 2]};                            \
        double v2[3] = {p[V2], p[V2 + 1], p[V2 + 2]}, virial;                    \
        out->n[i] = kernel(p + R, p[M1], p[M2], p[RISE], (way_type)p[WAY], v1,   \
                           v2, &virial);                                         \
        take(out, i, v1, v2, virial);                                            \
    })

#define CORE(kernel)                                                             \
    LOOP(kernel##_loop, {                                                        \
        double v1[3] = {p[V1], p[V1 + 1], p[V1 + 2]};                            \
        double v2[3] = {p[V2], p[V2 + 1], p[V2 + 2]};                            \
        const double virial = kernel(p + R, p[M1], p[M2], v1, v2);               \
        out->n[i] = 0;                                                           \
        take(out, i, v1, v2, virial);                                            \
    })

STEP(double_step, int)
STEP(long_step, int)
CORE(double_core)
CORE(long_core)
#ifdef TESTS_FLOAT128
STEP(quad_step, int)
CORE(quad_core)
#endif
STEP(brink_step_impulse, enum brink_direction)
CORE(brink_core_impulse)

static const method steps[] = {
    {"step/naive", "as written",
     "b' = √(b² - 2 rise r·r / μ), and the kick along r", RANK_FORMULA,
     double_step_loop, 0, 0},
    {"step/long", "long double", "the same in 64 bits", RANK_WIDE, long_step_loop,
     0, 0},
#ifdef TESTS_FLOAT128
    {"step/float128", "__float128", "the same in 113 bits", RANK_WIDE,
     quad_step_loop, 0, 0},
#endif
    {"step_impulse", "brink", "brink_step_impulse", RANK_PLAIN,
     brink_step_impulse_loop, BRINK_IMPULSE_ENERGY_ULP, 0},
};

static const method cores[] = {
    {"core/naive", "as written", "b' = -b, and the kick along r", RANK_FORMULA,
     double_core_loop, 0, 0},
    {"core/long", "long double", "the same in 64 bits", RANK_WIDE, long_core_loop,
     0, 0},
#ifdef TESTS_FLOAT128
    {"core/float128", "__float128", "the same in 113 bits", RANK_WIDE,
     quad_core_loop, 0, 0},
#endif
    {"core_impulse", "brink", "brink_core_impulse", RANK_PLAIN,
     brink_core_impulse_loop, BRINK_IMPULSE_ENERGY_ULP, 0},
};

#define MEASURED_IN                                                              \
    {                                                                            \
        "ulp of the largest kinetic energy", "ulp of the largest |m v|"          \
    }

const problem problem_step = {
    .name = "step",
    .title = "Across a step",
    .about = "Two particles meet a step of their potential.  Have they the "
             "energy to cross it, and how do they fly on?",
    .width = 13,
    .outputs = 7,
    .families = FAMILIES,
    .family = family,
    .make = make,
    .usual = "equal",
    .solve = solve,
    .judge = judge,
    .measure = MEASURED_IN,
    .second = "momentum",
    .methods = sizeof steps / sizeof *steps,
    .method = steps,
};

const problem problem_core = {
    .name = "core",
    .title = "A hard core",
    .about = "Two hard particles collide.  How do they fly on?",
    .width = 11,
    .outputs = 7,
    .families = sizeof core_families / sizeof *core_families,
    .family = core_family,
    .make = make_core,
    .usual = "equal",
    .solve = solve_core,
    .judge = judge,
    .measure = MEASURED_IN,
    .second = "momentum",
    .methods = sizeof cores / sizeof *cores,
    .method = cores,
};
