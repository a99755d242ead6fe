// SPDX-License-Identifier: MIT
// What two particles do at a step, or at a hard core.  Two measures: the pair's
// energy, in ulp of the largest kinetic energy of one of them, and its momentum,
// in ulp of the largest |m v|.
#include "arithmetics.h"
#include "oracle_impulse.h"
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

/** On the rim and moving all but along it, by angles about BRINK_RIM_ANGLE. */
static void make_rim(int k, stream *s, double *x)
{
    pair_case p;
    make_core(k, s, x);
    family_rim(s, &p);
    const double scale = length_of(x + V2) / length_of(p.v);
    const double out = stream_scaled(s, -34, -20) * length_of(p.v);
    for (int i = 0; i < 3; i++)
        x[V1 + i] = x[V2 + i] + scale * (p.v[i] + out * p.r[i]);
    memcpy(x + R, p.r, sizeof p.r);
}

// --- The right answers ---------------------------------------------------------

static oracle_pair pair_of(const double *masses, const double *v1,
                           const double *v2)
{
    return (oracle_pair){masses[0], masses[1], v1, v2};
}

static void solve(const double *x, truth *t)
{
    const oracle_pair p = pair_of(x + M1, x + V1, x + V2);
    t->n = oracle_crosses(x + R, x[RISE], &p);
}

static void solve_core(const double *x, truth *t)
{
    (void)x;
    t->n = 0;
}

static void solve_rim(const double *x, truth *t)
{
    t->n = oracle_rim_of(x + R, x + V1, x + V2).is_below;
}

static verdict judge_change(const double *x, const truth *t, int n,
                            const double *y, double rise)
{
    verdict v = {n == t->n ? WRONG_NOT : WRONG_SIDE, {0, 0}};
    for (int k = 0; k < 6; k++)
        if (!isfinite(y[k]))
            return (verdict){WRONG_SPURIOUS,
                             {(double)INFINITY, (double)INFINITY}};
    const oracle_pair before = pair_of(x + M1, x + V1, x + V2);
    const oracle_pair after = pair_of(x + M1, y, y + 3);
    v.error[0] = oracle_energy_error(&before, &after, rise);
    v.error[1] = oracle_momentum_error(&before, &after);
    return v;
}

static verdict judge_step(const double *x, const truth *t, int n, const double *y)
{
    return judge_change(x, t, n, y, n ? x[RISE] : 0);
}

/** Of a core, or on the rim: the energy is kept. */
static verdict judge(const double *x, const truth *t, int n, const double *y)
{
    return judge_change(x, t, n, y, 0);
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

#define RIM(kernel)                                                              \
    LOOP(kernel##_loop, {                                                        \
        double v1[3] = {p[V1], p[V1 + 1], p[V1 + 2]};                            \
        double v2[3] = {p[V2], p[V2 + 1], p[V2 + 2]};                            \
        out->n[i] = kernel(p + R, p[M1], p[M2], v1, v2);                         \
        take(out, i, v1, v2, 0);                                                 \
    })

STEP(double_step, int)
STEP(long_step, int)
CORE(double_core)
CORE(long_core)
RIM(double_rim)
RIM(long_rim)
#ifdef TESTS_FLOAT128
STEP(quad_step, int)
CORE(quad_core)
RIM(quad_rim)
#endif
STEP(brink_step_impulse, enum brink_direction)
CORE(brink_core_impulse)
RIM(brink_rim_impulse)

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

static const method rims[] = {
    {"rim/naive", "as written",
     "v - (v·r) r / r·r stretched, and the least angle", RANK_FORMULA,
     double_rim_loop, 0, 0},
    {"rim/long", "long double", "the same in 64 bits", RANK_WIDE, long_rim_loop,
     0, 0},
#ifdef TESTS_FLOAT128
    {"rim/float128", "__float128", "the same in 113 bits", RANK_WIDE,
     quad_rim_loop, 0, 0},
#endif
    {"rim_impulse", "brink", "brink_rim_impulse", RANK_PLAIN,
     brink_rim_impulse_loop, BRINK_IMPULSE_ENERGY_ULP, 0},
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
    .judge = judge_step,
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

const problem problem_rim = {
    .name = "rim",
    .title = "On the rim",
    .about =
        "A pair in a well flies all but along its rim, and would bounce for "
        "ever without getting anywhere.  Is its angle too small, and how does "
        "it fly on?",
    .width = 11,
    .outputs = 7,
    .families = sizeof core_families / sizeof *core_families,
    .family = core_family,
    .make = make_rim,
    .usual = "equal",
    .solve = solve_rim,
    .judge = judge,
    .measure = MEASURED_IN,
    .second = "momentum",
    .methods = sizeof rims / sizeof *rims,
    .method = rims,
};
