// SPDX-License-Identifier: MIT
#include "arithmetics.h"
#include "baselines.h"
#include "oracle.h"
#include "problems_all.h"
#include "quadratics.h"
#include "rivals.h"
#include <brink/quadratic.h>
#include <gsl/gsl_poly.h>

static const char *family(int k)
{
    return quadratic_families[k].name;
}

static void make(int k, stream *s, double *x)
{
    quadratic_case q;
    quadratic_families[k].make(s, &q);
    x[0] = q.a;
    x[1] = q.b;
    x[2] = q.c;
}

static void solve(const double *x, truth *t)
{
    mpfr_t root[2];
    mpfr_inits2(ORACLE_BITS, root[0], root[1], (mpfr_ptr)0);
    t->n = oracle_roots(root[0], root[1], x[0], x[1], x[2]);
    for (int k = 0; k < t->n; k++)
        real_from(&t->x[k], root[k]);
    mpfr_clears(root[0], root[1], (mpfr_ptr)0);
}

static verdict judge(const double *x, const truth *t, int n, const double *y)
{
    (void)x;
    verdict v = {WRONG_NOT, {0, 0}};
    if (n != t->n)
        v.wrong = n < t->n ? WRONG_MISSED : WRONG_INVENTED;
    for (int k = 0; v.wrong == WRONG_NOT && k < n; k++) {
        if (isnan(y[k]) || real_is_spurious(y[k], &t->x[k]))
            v.wrong = WRONG_SPURIOUS;
        v.error[0] = fmax(v.error[0], real_ulps(y[k], &t->x[k]));
    }
    return v;
}

#define ROOTS(kernel)                                                            \
    LOOP(kernel##_loop,                                                          \
         out->n[i] = kernel(p[0], p[1], p[2], &out->x[0][i], &out->x[1][i]))

ROOTS(brink_quadratic_roots)
ROOTS(brink_quadratic_roots_cr)
ROOTS(baseline_quadratic_textbook)
ROOTS(baseline_quadratic_goualard)
ROOTS(double_roots)
ROOTS(rival_roots_kahan)
ROOTS(gsl_poly_solve_quadratic)
ROOTS(long_roots)
#ifdef TESTS_FLOAT128
ROOTS(quad_roots)
#endif
ROOTS(rival_roots_mpfr256)
ROOTS(rival_roots_mpfr)

static const method methods[] = {
    {"quadratic/textbook", "textbook", "(-b ± √(b² - 4ac)) / 2a, as in school",
     RANK_FORMULA, baseline_quadratic_textbook_loop, 0, 0},
    {"quadratic/stable", "stable quotient",
     "q = -(b ± √(b² - 4ac)) / 2, roots q/a and c/q: no cancellation between b "
     "and the root",
     RANK_FORMULA, double_roots_loop, 0, 0},
    {"quadratic/kahan", "Kahan's fma",
     "the stable quotient, and the discriminant to 3/2 ulp by Kahan's way with "
     "fma",
     RANK_FORMULA, rival_roots_kahan_loop, 0, 0},
    {"quadratic/gsl", "GSL", "gsl_poly_solve_quadratic", RANK_LIBRARY,
     gsl_poly_solve_quadratic_loop, 0, 0},
    {"quadratic/goualard", "Goualard 2023",
     "exponents taken out first, always; own code after the paper", RANK_LIBRARY,
     baseline_quadratic_goualard_loop, 0, 0},
    {"quadratic/long", "long double", "the stable quotient in 64 bits", RANK_WIDE,
     long_roots_loop, 0, 0},
#ifdef TESTS_FLOAT128
    {"quadratic/float128", "__float128", "the stable quotient in 113 bits",
     RANK_WIDE, quad_roots_loop, 0, 0},
#endif
    {"quadratic/mpfr256", "MPFR, 256 bits", "the stable quotient in 256 bits",
     RANK_WIDE, rival_roots_mpfr256_loop, 0, 0},
    {"quadratic/mpfr", "MPFR, 9000 bits",
     "the same where sums and products are exact: what all others are judged by",
     RANK_JUDGE, rival_roots_mpfr_loop, 0, 0},
    {"quadratic_roots", "brink", "brink_quadratic_roots", RANK_PLAIN,
     brink_quadratic_roots_loop, BRINK_QUADRATIC_ULP, 0},
    {"quadratic_roots_cr", "brink, _cr", "brink_quadratic_roots_cr", RANK_CR,
     brink_quadratic_roots_cr_loop, 0.5, 0},
};

const problem problem_quadratic = {
    .name = "quadratic",
    .title = "Roots of a quadratic",
    .about = "a x² + b x + c = 0: how many real roots are there, and where?",
    .width = 3,
    .outputs = 2,
    .families = QUADRATIC_FAMILIES,
    .family = family,
    .make = make,
    .usual = "benign",
    .solve = solve,
    .judge = judge,
    .measure = {"ulp"},
    .methods = sizeof methods / sizeof *methods,
    .method = methods,
};
