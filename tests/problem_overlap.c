// SPDX-License-Identifier: MIT
// The overlap functions and their rates, of balls and of half-spaces, now and
// later: seven quantities of one pattern.
#include "arithmetics.h"
#include "oracle_overlap.h"
#include "pairs.h"
#include "problems_all.h"
#include "rivals.h"
#include <brink/event_time.h>
#include <brink/overlap.h>

static const double zero[3] = {0, 0, 0};

static int sign_of(double x)
{
    return (x > 0) - (x < 0);
}

// --- Inputs --------------------------------------------------------------------

static const char *family(int k)
{
    return pair_families[k].name;
}

/** r v sigma */
static void make_pair(int k, stream *s, double *x)
{
    pair_case p;
    pair_families[k].make(s, &p);
    memcpy(x, p.r, sizeof p.r);
    memcpy(x + 3, p.v, sizeof p.v);
    x[6] = p.sigma;
}

/** A time at which something may be the matter: near the event, or any. */
static double time_for(stream *s, const double *x)
{
    const double in = brink_intersection_time_cr(x, x + 3, x[6]),
                 out = brink_disjoint_time_cr(x, x + 3, x[6]);
    switch (stream_int(s, 0, 3)) {
    case 0:
        return stream_scaled(s, -4, 4);
    case 1:
        return isfinite(in) ? stream_near(s, in, 2) : 1;
    default:
        return isfinite(out) ? stream_near(s, out, 2) : 1;
    }
}

/** r v sigma t */
static void make_pair_at(int k, stream *s, double *x)
{
    make_pair(k, s, x);
    x[7] = time_for(s, x);
}

/** r n c */
static void make_plane(int k, stream *s, double *x)
{
    pair_case p, q;
    pair_families[k].make(s, &p);
    pair_families[k].make(s, &q);
    memcpy(x, p.r, sizeof p.r);
    memcpy(x + 3, q.v, sizeof q.v);
    memcpy(x + 6, q.r, sizeof q.r);
}

/** v n */
static void make_rates(int k, stream *s, double *x)
{
    pair_case p, q;
    pair_families[k].make(s, &p);
    pair_families[k].make(s, &q);
    memcpy(x, p.v, sizeof p.v);
    memcpy(x + 3, q.v, sizeof q.v);
}

/** r v n c t */
static void make_plane_at(int k, stream *s, double *x)
{
    pair_case q;
    double pair[7];
    make_pair(k, s, pair);
    pair_families[k].make(s, &q);
    memcpy(x, pair, 6 * sizeof *x);
    memcpy(x + 6, q.v, sizeof q.v);
    memcpy(x + 9, q.r, sizeof q.r);
    x[12] = time_for(s, pair);
}

// A line of overlap.wc is r v sigma n c t.
static const signed char paste_pair[] = {0,  1,  2,  3,  4,  5,  6,
                                         -1, -1, -1, -1, -1, -1, -1};
static const signed char paste_pair_at[] = {0,  1,  2,  3,  4,  5,  6,
                                            -1, -1, -1, -1, -1, -1, 7};
static const signed char paste_plane[] = {0, 1, 2, -1, -1, -1, -1,
                                          3, 4, 5, 6,  7,  8,  -1};
static const signed char paste_rates[] = {-1, -1, -1, 0,  1,  2,  -1,
                                          3,  4,  5,  -1, -1, -1, -1};
static const signed char paste_plane_at[] = {0, 1, 2, 3, 4,  5,  -1,
                                             6, 7, 8, 9, 10, 11, 12};

// --- Verdicts ------------------------------------------------------------------

static verdict judge_value(const double *x, const truth *t, int n,
                           const double *y)
{
    (void)x;
    (void)n;
    verdict v = {WRONG_NOT, {real_ulps(y[0], &t->x[0]), -1}};
    if (isnan(y[0]) || (y[0] != 0 && sign_of(y[0]) != t->n))
        v.wrong = isnan(y[0]) ? WRONG_SPURIOUS : WRONG_SIGN;
    else if (real_is_spurious(y[0], &t->x[0]))
        v.wrong = y[0] == 0 ? WRONG_SIGN : WRONG_SPURIOUS;
    return v;
}

static verdict judge_sign(const double *x, const truth *t, int n, const double *y)
{
    (void)x;
    (void)y;
    return (verdict){n == t->n ? WRONG_NOT : WRONG_SIGN, {n != t->n, -1}};
}

// --- Ways ----------------------------------------------------------------------

#ifdef TESTS_FLOAT128
#define WITH_QUAD(...) __VA_ARGS__
#else
#define WITH_QUAD(...)
#endif

static int naive_sign(double f)
{
    return (f > 0) - (f < 0);
}

/** A quantity q of `arguments`, by its formula, by the kernels, and by MPFR as f
 * of mpfr_arguments; solved, and its methods. */
#define QUANTITY(q, arguments, kernel, kernel_sign, f, mpfr_arguments)           \
    LOOP(q##_naive, out->x[0][i] = double_##q arguments)                         \
    LOOP(q##_naive_sign, out->n[i] = naive_sign(double_##q arguments))           \
    LOOP(q##_long, out->x[0][i] = long_##q arguments)                            \
    WITH_QUAD(LOOP(q##_quad, out->x[0][i] = quad_##q arguments))                 \
    LOOP(q##_mpfr256, out->x[0][i] = rival_##f##_mpfr256 mpfr_arguments)         \
    LOOP(q##_mpfr, out->x[0][i] = rival_##f##_mpfr mpfr_arguments)               \
    LOOP(q##_kernel, out->x[0][i] = brink_##kernel arguments)                    \
    LOOP(q##_sign, out->n[i] = brink_##kernel_sign arguments)                    \
    static const method q##_methods[] = {                                        \
        {#q "/naive", "as written", "its formula", RANK_FORMULA, q##_naive, 0,   \
         0},                                                                     \
        {#q "/sign", "sign, as written", "the sign of its formula",              \
         RANK_NAIVE_SIGN, q##_naive_sign, 0, 0},                                 \
        {#q "/long", "long double", "its formula in 64 bits", RANK_WIDE,         \
         q##_long, 0, 0},                                                        \
        WITH_QUAD({#q "/float128", "__float128", "its formula in 113 bits",      \
                   RANK_WIDE, q##_quad, 0, 0}, ){                                \
            #q "/mpfr256", "MPFR, 256 bits", "its formula in 256 bits",          \
            RANK_WIDE, q##_mpfr256, 0, 0},                                       \
        {#q "/mpfr", "MPFR, 9000 bits",                                          \
         "the same, exact: what all others are judged by", RANK_JUDGE, q##_mpfr, \
         0, 0},                                                                  \
        {#kernel, "brink", "brink_" #kernel, RANK_PLAIN, q##_kernel,             \
         BRINK_OVERLAP_ULP, 0},                                                  \
        {#kernel_sign, "brink, sign", "brink_" #kernel_sign, RANK_SIGN,          \
         q##_sign, 0, 0},                                                        \
    };                                                                           \
    static void q##_solve(const double *p, truth *t)                             \
    {                                                                            \
        mpfr_t exact;                                                            \
        mpfr_init2(exact, ORACLE_BITS);                                          \
        oracle_##f(exact, UNPACK mpfr_arguments);                                \
        t->n = (mpfr_sgn(exact) > 0) - (mpfr_sgn(exact) < 0);                    \
        real_from(&t->x[0], exact);                                              \
        mpfr_clear(exact);                                                       \
    }
#define UNPACK(...) __VA_ARGS__

QUANTITY(ball, (p, p[6]), ball_overlap, ball_overlap_sign, ball,
         (p, zero, p[6], 0))
QUANTITY(rate, (p, p + 3), ball_overlap_rate, ball_overlap_rate_sign, plane,
         (p, zero, p + 3, zero, 0))
QUANTITY(ball_at, (p, p + 3, p[6], p[7]), ball_overlap_at, ball_overlap_sign_at,
         ball, (p, p + 3, p[6], p[7]))
QUANTITY(rate_at, (p, p + 3, p[7]), ball_overlap_rate_at,
         ball_overlap_rate_sign_at, plane, (p, p + 3, p + 3, zero, p[7]))
QUANTITY(halfspace, (p, p + 3, p + 6), halfspace_overlap, halfspace_overlap_sign,
         plane, (p, zero, p + 3, p + 6, 0))
QUANTITY(halfspace_rate, (p, p + 3), halfspace_overlap_rate,
         halfspace_overlap_rate_sign, plane, (p, zero, p + 3, zero, 0))
QUANTITY(halfspace_at, (p, p + 3, p + 6, p + 9, p[12]), halfspace_overlap_at,
         halfspace_overlap_sign_at, plane, (p, p + 3, p + 6, p + 9, p[12]))

#define PROBLEM(q, called, words, made, wide, pasted_as)                         \
    const problem problem_##q = {                                                \
        .name = #q,                                                              \
        .title = called,                                                         \
        .about = words,                                                          \
        .width = wide,                                                           \
        .outputs = 1,                                                            \
        .paste = pasted_as,                                                      \
        .pasted = sizeof pasted_as,                                              \
        .families = PAIR_FAMILIES,                                               \
        .family = family,                                                        \
        .make = made,                                                            \
        .usual = "dilute",                                                       \
        .solve = q##_solve,                                                      \
        .judge = judge_value,                                                    \
        .judge_sign = judge_sign,                                                \
        .measure = {"ulp"},                                                      \
        .methods = sizeof q##_methods / sizeof *q##_methods,                     \
        .method = q##_methods,                                                   \
    };

PROBLEM(ball, "Overlap of two balls",
        "r·r - σ²: are they apart, in touch, or one inside the other?", make_pair,
        7, paste_pair)
PROBLEM(rate, "Nearer or farther", "r·v: are they coming nearer?", make_pair, 7,
        paste_pair)
PROBLEM(ball_at, "Overlap of two balls, later", "|r + v t|² - σ²", make_pair_at,
        8, paste_pair_at)
PROBLEM(rate_at, "Nearer or farther, later", "v·(r + v t)", make_pair_at, 8,
        paste_pair_at)
PROBLEM(halfspace, "Overlap with a wall", "n·(r - c): on which side of a plane?",
        make_plane, 9, paste_plane)
PROBLEM(halfspace_rate, "Towards a wall", "n·v: towards the plane, or away?",
        make_rates, 6, paste_rates)
PROBLEM(halfspace_at, "Overlap with a wall, later", "n·(r + v t - c)",
        make_plane_at, 13, paste_plane_at)
