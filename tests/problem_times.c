// SPDX-License-Identifier: MIT
// When a pair meets a sphere, and when it leaves it.  Two measures: ulp of the
// time, and how far from where it should be the pair is at that time, in eps
// (sigma + |v| t).
#include "arithmetics.h"
#include "baselines.h"
#include "oracle.h"
#include "pairs.h"
#include "problems_all.h"
#include "rivals.h"
#include <brink/event_time.h>
#include <float.h>

static const char *family(int k)
{
    return pair_families[k].name;
}

static void make(int k, stream *s, double *x)
{
    pair_case p;
    pair_families[k].make(s, &p);
    memcpy(x, p.r, sizeof p.r);
    memcpy(x + 3, p.v, sizeof p.v);
    x[6] = p.sigma;
}

static void solve_intersection(const double *x, truth *t)
{
    mpfr_t time;
    mpfr_init2(time, ORACLE_BITS);
    oracle_intersection(time, x, x + 3, x[6]);
    real_from(&t->x[0], time);
    mpfr_clear(time);
}

static void solve_disjoint(const double *x, truth *t)
{
    mpfr_t time;
    mpfr_init2(time, ORACLE_BITS);
    oracle_disjoint(time, x, x + 3, x[6]);
    real_from(&t->x[0], time);
    mpfr_clear(time);
}

// --- The distance from the surface ---------------------------------------------
//
// In long double: its 64 bits are 11 more than those that are measured, so what
// is more than a few eps is good to a percent; its exponents reach every square.

static long double size_of(const double x[3])
{
    return sqrtl((long double)x[0] * x[0] + (long double)x[1] * x[1] +
                 (long double)x[2] * x[2]);
}

static long double distance_at(const double *x, long double t)
{
    long double square = 0;
    for (int i = 0; i < 3; i++) {
        const long double place = x[i] + x[3 + i] * t;
        square += place * place;
    }
    return sqrtl(square);
}

/** How much farther away the pair is at time t than at s.  Not a difference of
 *  distances: these may be large beside sigma + |v| t. */
static long double gone_between(const double *x, long double s, long double t)
{
    const long double sum = distance_at(x, s) + distance_at(x, t);
    long double rate = 0;
    for (int i = 0; i < 3; i++)
        rate += x[3 + i] * (2.0L * x[i] + x[3 + i] * (s + t));
    return sum > 0 ? (t - s) * rate / sum : 0;
}

static double in_eps(const double *x, long double distance, long double t)
{
    const long double size = x[6] + size_of(x + 3) * t;
    if (distance == 0)
        return 0;
    return (double)(fabsl(distance) / (0x1p-52L * size));
}

/** How deep the pair goes that is said never to meet; or how far it is from its
 *  closest approach, if that is less: one that is inside is said to part. */
static double depth_missed(const double *x)
{
    const double *r = x, *v = x + 3;
    long double cross = 0, rate = 0;
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const long double c = (long double)r[j] * v[k] - (long double)r[k] * v[j];
        cross += c * c;
        rate += (long double)r[i] * v[i];
    }
    const long double speed = size_of(v), t = -rate / (speed * speed);
    const double depth = in_eps(x, x[6] - sqrtl(cross) / speed, t);
    return fmin(depth, in_eps(x, rate / speed, 0));
}

/** A time at an end of the range may stand for one beyond it: never for one too
 *  large, and the least for one at which the pair is past the rim already. */
static double gap_of_intersection(const double *x, double t)
{
    const double last = fmin(t, DBL_MAX);
    const double gap = in_eps(x, distance_at(x, last) - x[6], last);
    return t < DBL_MIN || isinf(t) ? fmin(gap, depth_missed(x)) : gap;
}

// --- Verdicts ------------------------------------------------------------------

/** Of a time that is right, but has lost digits to the end of the range of
 * doubles, no double would put the pair on the surface. */
static int is_at_the_end(const verdict *v, const real *exact)
{
    return v->wrong == WRONG_NOT &&
           (fabs(exact->nearest) < 0x1p-1022 || isinf(exact->nearest));
}

static verdict judge_intersection(const double *x, const truth *t, int n,
                                  const double *y)
{
    (void)n;
    verdict v = problem_judge_time(&t->x[0], y[0]);
    if (v.wrong == WRONG_SPURIOUS)
        v.error[1] = (double)INFINITY;
    else if (v.error[0] >= 0 && !is_at_the_end(&v, &t->x[0]))
        v.error[1] = gap_of_intersection(x, y[0]);
    return v;
}

static verdict judge_disjoint(const double *x, const truth *t, int n,
                              const double *y)
{
    (void)n;
    const real *exact = &t->x[0];
    verdict v = problem_judge_time(exact, y[0]);
    if (v.error[0] < 0 || is_at_the_end(&v, exact))
        return v;
    if (v.wrong == WRONG_SPURIOUS || isinf(y[0]) || isinf(exact->hi))
        v.error[1] = (double)INFINITY;
    else
        v.error[1] =
            in_eps(x, gone_between(x, exact->hi, y[0]), fmaxl(y[0], exact->hi));
    return v;
}

// --- Ways ----------------------------------------------------------------------

#define TIMES(kernel) LOOP(kernel##_loop, out->x[0][i] = kernel(p, p + 3, p[6]))

TIMES(baseline_intersection)
TIMES(rival_intersection_kahan)
TIMES(rival_intersection_cross)
TIMES(long_intersection)
TIMES(rival_intersection_mpfr256)
TIMES(rival_intersection_mpfr)
TIMES(brink_intersection_time_fast)
TIMES(brink_intersection_time)
TIMES(brink_intersection_time_cr)

TIMES(baseline_disjoint)
TIMES(rival_disjoint_printed)
TIMES(rival_disjoint_cross)
TIMES(long_disjoint)
TIMES(rival_disjoint_mpfr256)
TIMES(rival_disjoint_mpfr)
TIMES(brink_disjoint_time_fast)
TIMES(brink_disjoint_time)
TIMES(brink_disjoint_time_cr)

#ifdef TESTS_FLOAT128
TIMES(quad_intersection)
TIMES(quad_disjoint)
#endif

static const method intersections[] = {
    {"intersection/printed", "[S16] alg. 1", "[S16] algorithm 1 as printed",
     RANK_FORMULA, baseline_intersection_loop, 0, 0},
    {"intersection/kahan", "with exact b² - ac",
     "algorithm 1, and the discriminant of its rounded a, b, c to 3/2 ulp by fma",
     RANK_FORMULA, rival_intersection_kahan_loop, 0, 0},
    {"intersection/cross", "cross form",
     "algorithm 1 with the discriminant as a σ² - |r × v|², each 2 × 2 by fma",
     RANK_FORMULA, rival_intersection_cross_loop, 0, 0},
    {"intersection/long", "long double", "algorithm 1 in 64 bits", RANK_WIDE,
     long_intersection_loop, 0, 0},
#ifdef TESTS_FLOAT128
    {"intersection/float128", "__float128", "algorithm 1 in 113 bits", RANK_WIDE,
     quad_intersection_loop, 0, 0},
#endif
    {"intersection/mpfr256", "MPFR, 256 bits", "algorithm 1 in 256 bits",
     RANK_WIDE, rival_intersection_mpfr256_loop, 0, 0},
    {"intersection/mpfr", "MPFR, 9000 bits",
     "the same where sums and products are exact: what all others are judged by",
     RANK_JUDGE, rival_intersection_mpfr_loop, 0, 0},
    {"intersection_time_fast", "brink, _fast", "brink_intersection_time_fast",
     RANK_FAST, brink_intersection_time_fast_loop, BRINK_EVENT_TIME_GAP, 1},
    {"intersection_time", "brink", "brink_intersection_time", RANK_PLAIN,
     brink_intersection_time_loop, BRINK_EVENT_TIME_ULP, 0},
    {"intersection_time_cr", "brink, _cr", "brink_intersection_time_cr", RANK_CR,
     brink_intersection_time_cr_loop, 0.5, 0},
};

static const method disjoints[] = {
    {"disjoint/stable", "alg. 2, put right",
     "[S16] algorithm 2 with the branches of the printed one swapped back",
     RANK_FORMULA, baseline_disjoint_loop, 0, 0},
    {"disjoint/printed", "[S16] alg. 2", "[S16] algorithm 2 as printed",
     RANK_FORMULA, rival_disjoint_printed_loop, 0, 0},
    {"disjoint/cross", "cross form",
     "put right, with the discriminant as a σ² - |r × v|², each 2 × 2 by fma",
     RANK_FORMULA, rival_disjoint_cross_loop, 0, 0},
    {"disjoint/long", "long double", "algorithm 2, put right, in 64 bits",
     RANK_WIDE, long_disjoint_loop, 0, 0},
#ifdef TESTS_FLOAT128
    {"disjoint/float128", "__float128", "algorithm 2, put right, in 113 bits",
     RANK_WIDE, quad_disjoint_loop, 0, 0},
#endif
    {"disjoint/mpfr256", "MPFR, 256 bits", "algorithm 2, put right, in 256 bits",
     RANK_WIDE, rival_disjoint_mpfr256_loop, 0, 0},
    {"disjoint/mpfr", "MPFR, 9000 bits",
     "the same where sums and products are exact: what all others are judged by",
     RANK_JUDGE, rival_disjoint_mpfr_loop, 0, 0},
    {"disjoint_time_fast", "brink, _fast", "brink_disjoint_time_fast", RANK_FAST,
     brink_disjoint_time_fast_loop, BRINK_EVENT_TIME_GAP, 1},
    {"disjoint_time", "brink", "brink_disjoint_time", RANK_PLAIN,
     brink_disjoint_time_loop, BRINK_EVENT_TIME_ULP, 0},
    {"disjoint_time_cr", "brink, _cr", "brink_disjoint_time_cr", RANK_CR,
     brink_disjoint_time_cr_loop, 0.5, 0},
};

const problem problem_intersection = {
    .name = "intersection",
    .title = "When two balls meet",
    .about = "Two balls fly freely.  Do they meet, and when?",
    .width = 7,
    .outputs = 1,
    .families = PAIR_FAMILIES,
    .family = family,
    .make = make,
    .usual = "dilute",
    .solve = solve_intersection,
    .judge = judge_intersection,
    .measure = {"ulp", "eps (σ + |v| t) from the surface"},
    .second = "gap",
    .methods = sizeof intersections / sizeof *intersections,
    .method = intersections,
};

const problem problem_disjoint = {
    .name = "disjoint",
    .title = "When two balls part",
    .about = "One ball is inside the reach of another.  When does it leave?",
    .width = 7,
    .outputs = 1,
    .families = PAIR_FAMILIES,
    .family = family,
    .make = make,
    .usual = "captured",
    .solve = solve_disjoint,
    .judge = judge_disjoint,
    .measure = {"ulp", "eps (σ + |v| t) from the surface"},
    .second = "gap",
    .methods = sizeof disjoints / sizeof *disjoints,
    .method = disjoints,
};
