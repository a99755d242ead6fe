// SPDX-License-Identifier: MIT
#include "problems_all.h"
#include <stdlib.h>
#include <string.h>

const problem *const problems[PROBLEMS] = {
    &problem_quadratic,      &problem_intersection, &problem_disjoint,
    &problem_halfspace_time, &problem_ball,         &problem_rate,
    &problem_ball_at,        &problem_rate_at,      &problem_halfspace,
    &problem_halfspace_rate, &problem_halfspace_at, &problem_step,
    &problem_core,           &problem_rim,
};

const char *const problem_wrong_names[WRONG_KINDS] = {
    [WRONG_NOT] = "right",         [WRONG_MISSED] = "missed",
    [WRONG_INVENTED] = "invented", [WRONG_NOW] = "now/later",
    [WRONG_SIGN] = "sign",         [WRONG_SIDE] = "side",
    [WRONG_SPURIOUS] = "spurious",
};

int problem_family(const problem *p, const char *name)
{
    for (int family = 0; family < p->families; family++)
        if (strcmp(p->family(family), name) == 0)
            return family;
    return -1;
}

const problem *problem_of(const char *name, int *k)
{
    for (int i = 0; i < PROBLEMS; i++)
        for (*k = 0; *k < problems[i]->methods; ++*k)
            if (strcmp(problems[i]->method[*k].name, name) == 0)
                return problems[i];
    return NULL;
}

inputs *inputs_make(const problem *p, int family, int n, uint64_t seed)
{
    const size_t width = (size_t)p->width, count = (size_t)n;
    inputs *in = malloc(sizeof *in);
    double *room = malloc(2 * width * count * sizeof *room);
    if (in == NULL || room == NULL) {
        free(in);
        free(room);
        return NULL;
    }
    *in = (inputs){.n = n, .width = p->width, .rows = room};
    for (size_t k = 0; k < width; k++)
        in->columns[k] = room + (width + k) * count;
    stream s = stream_of_seed(seed);
    for (size_t i = 0; i < count; i++) {
        p->make(family, &s, room + i * width);
        for (size_t k = 0; k < width; k++)
            in->columns[k][i] = room[i * width + k];
    }
    return in;
}

void inputs_free(inputs *in)
{
    if (in != NULL)
        free(in->rows);
    free(in);
}

answers *answers_make(int n)
{
    const size_t count = (size_t)n;
    answers *a = malloc(sizeof *a);
    double *x = calloc(PROBLEM_OUTPUTS * count, sizeof *x);
    int *of = calloc(count, sizeof *of);
    if (a == NULL || x == NULL || of == NULL) {
        free(a);
        free(x);
        free(of);
        return NULL;
    }
    for (size_t k = 0; k < PROBLEM_OUTPUTS; k++)
        a->x[k] = x + k * count;
    a->n = of;
    return a;
}

void answers_free(answers *a)
{
    if (a != NULL) {
        free(a->x[0]);
        free(a->n);
    }
    free(a);
}

void real_from(real *x, const mpfr_t exact)
{
    // The ulp in [2^(e-1), 2^e) is 2^(e-53); that of subnormals, 2^-1074.
    const long e = mpfr_regular_p(exact) ? (long)mpfr_get_exp(exact) - 53 : -1074;
    mpfr_t rest;
    mpfr_init2(rest, 128); // more than a long double has anywhere
    x->hi = mpfr_get_ld(exact, MPFR_RNDN);
    mpfr_set_ld(rest, x->hi, MPFR_RNDN);
    if (mpfr_number_p(exact))
        mpfr_sub(rest, exact, rest, MPFR_RNDN);
    x->lo = mpfr_number_p(exact) ? mpfr_get_ld(rest, MPFR_RNDN) : 0;
    x->nearest = mpfr_get_d(exact, MPFR_RNDN);
    x->ulp = e < -1074 ? -1074 : (int)e;
    mpfr_clear(rest);
}

double real_ulps(double x, const real *exact)
{
    if (isnan(x) || (isinf(exact->hi) && x != exact->nearest))
        return (double)INFINITY;
    if (x == exact->nearest && (isinf(x) || exact->hi == 0))
        return 0;
    long double y = x;
    if (isinf(x))
        y = copysignl(0x1p1024L, y);
    return (double)scalbnl(fabsl((y - exact->hi) - exact->lo), -exact->ulp);
}

int real_is_spurious(double x, const real *exact)
{
    // The widest bound that any kernel states is 8 ulp.
    return (x == 0 || !isfinite(x)) && real_ulps(x, exact) > 8;
}

verdict problem_judge_time(const real *exact, double t)
{
    verdict v = {WRONG_NOT, {real_ulps(t, exact), -1}};
    if (t == exact->hi && (t == 0 || isinf(t)))
        v.error[0] = -1;
    if (isnan(t) || t < 0)
        v.wrong = WRONG_SPURIOUS;
    else if (isinf(t) && real_is_spurious(t, exact))
        v.wrong = WRONG_MISSED;
    else if (!isinf(t) && isinf(exact->hi))
        v.wrong = WRONG_INVENTED;
    else if ((t > 0 && exact->hi == 0) || (t == 0 && real_is_spurious(t, exact)))
        v.wrong = WRONG_NOW;
    return v;
}
