// SPDX-License-Identifier: MIT
#include "arithmetics.h"
#include "oracle.h"
#include "pairs.h"
#include "problems_all.h"
#include "rivals.h"
#include "walls.h"
#include <brink/event_time.h>

enum { SLANTING = PAIR_FAMILIES, FAMILIES };

static const char *family(int k)
{
    return k == SLANTING ? "slanting" : pair_families[k].name;
}

static void make_of_pairs(int k, stream *s, wall_case *w)
{
    pair_case p, q;
    pair_families[k].make(s, &p);
    pair_families[k].make(s, &q);
    memcpy(w->r, p.r, sizeof p.r);
    memcpy(w->v, p.v, sizeof p.v);
    memcpy(w->n, q.v, sizeof q.v);
    memcpy(w->c, q.r, sizeof q.r);
}

/** r v n c */
static void make(int k, stream *s, double *x)
{
    wall_case w;
    if (k == SLANTING)
        wall_slanting(s, &w);
    else
        make_of_pairs(k, s, &w);
    memcpy(x, &w, sizeof w);
}

static void solve(const double *x, truth *t)
{
    mpfr_t time;
    mpfr_init2(time, ORACLE_BITS);
    oracle_halfspace(time, x, x + 3, x + 6, x + 9);
    real_from(&t->x[0], time);
    mpfr_clear(time);
}

static verdict judge(const double *x, const truth *t, int n, const double *y)
{
    (void)x;
    (void)n;
    return problem_judge_time(&t->x[0], y[0]);
}

#define TIMES(kernel)                                                            \
    LOOP(kernel##_loop, out->x[0][i] = kernel(p, p + 3, p + 6, p + 9))

TIMES(double_halfspace_time)
TIMES(long_halfspace_time)
#ifdef TESTS_FLOAT128
TIMES(quad_halfspace_time)
#endif
TIMES(rival_halfspace_time_mpfr256)
TIMES(rival_halfspace_time_mpfr)
TIMES(brink_halfspace_time)

static const method methods[] = {
    {"halfspace_time/naive", "as written", "n·(r - c) / -n·v", RANK_FORMULA,
     double_halfspace_time_loop, 0, 0},
    {"halfspace_time/long", "long double", "the same in 64 bits", RANK_WIDE,
     long_halfspace_time_loop, 0, 0},
#ifdef TESTS_FLOAT128
    {"halfspace_time/float128", "__float128", "the same in 113 bits", RANK_WIDE,
     quad_halfspace_time_loop, 0, 0},
#endif
    {"halfspace_time/mpfr256", "MPFR, 256 bits", "the same in 256 bits",
     RANK_WIDE, rival_halfspace_time_mpfr256_loop, 0, 0},
    {"halfspace_time/mpfr", "MPFR, 9000 bits",
     "the same where sums and products are exact: what all others are judged by",
     RANK_JUDGE, rival_halfspace_time_mpfr_loop, 0, 0},
    {"halfspace_time", "brink", "brink_halfspace_time", RANK_PLAIN,
     brink_halfspace_time_loop, 0.5, 0},
};

const problem problem_halfspace_time = {
    .name = "halfspace-time",
    .title = "When a particle meets a wall",
    .about = "A particle flies towards a plane, or away from it.  When does it "
             "arrive?",
    .width = 12,
    .outputs = 1,
    .families = FAMILIES,
    .family = family,
    .make = make,
    .usual = "dilute",
    .solve = solve,
    .judge = judge,
    .measure = {"ulp"},
    .methods = sizeof methods / sizeof *methods,
    .method = methods,
};
