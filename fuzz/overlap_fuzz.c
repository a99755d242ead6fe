// SPDX-License-Identifier: MIT
#include <brink/overlap.h>

#include "../tests/overlap_paths.h"
#include "laws.h"

static const lawful quantities_of[] = {
    {&problem_ball, "LLL---L", "LL"},
    {&problem_rate, "LLLVVV-", "LV"},
    {&problem_ball_at, "LLLVVVLT", "LL"},
    {&problem_rate_at, "LLLVVV-T", "LV"},
    {&problem_halfspace, "LLLNNNLLL", "NL"},
    {&problem_halfspace_rate, "VVVNNN", "NV"},
    {&problem_halfspace_at, "LLLVVVNNNLLLT", "NL"},
};

// --- Whole numbers -------------------------------------------------------------

__extension__ typedef __int128 whole;

/** Every quantity of a ball, a plane and a time. */
enum { VALUES = 7 };

/** Positions of up to 26 bits, so that squares, summed, are exact in 128 bits a
 *  few times over; half of them next to the surface. */
static void some_whole_numbers(stream *s, pair_case *p, pair_case *q, double *t)
{
    const int most = 1 << stream_int(s, 1, 26);
    *t = stream_int(s, -16, 16);
    for (int i = 0; i < 3; i++) {
        p->r[i] = stream_int(s, -most, most);
        p->v[i] = stream_int(s, -most, most);
        q->r[i] = p->r[i] + *t * p->v[i] + stream_int(s, -2, 2);
        q->v[i] = stream_int(s, -most, most);
    }
    double x[3];
    for (int i = 0; i < 3; i++)
        x[i] = p->r[i] + *t * p->v[i];
    p->sigma = rint(length_of(x)) + stream_int(s, -1, 1);
}

/** The seven, without a rounding. */
static void in_whole_numbers(const pair_case *p, const pair_case *q, double time,
                             whole f[VALUES])
{
    const whole t = (whole)time, sigma = (whole)p->sigma;
    f[0] = f[2] = -sigma * sigma;
    f[1] = f[3] = f[4] = f[5] = f[6] = 0;
    for (int i = 0; i < 3; i++) {
        const whole r = (whole)p->r[i], v = (whole)p->v[i], n = (whole)q->v[i],
                    c = (whole)q->r[i], x = r + v * t;
        f[0] += r * r;
        f[1] += r * v;
        f[2] += x * x;
        f[3] += x * v;
        f[4] += n * (r - c);
        f[5] += n * v;
        f[6] += n * (x - c);
    }
}

static void by_kernels(const pair_case *p, const pair_case *q, double t,
                       double f[VALUES], int sign[VALUES])
{
    const double *r = p->r, *v = p->v, *n = q->v, *c = q->r, sigma = p->sigma;
    f[0] = brink_ball_overlap(r, sigma);
    f[1] = brink_ball_overlap_rate(r, v);
    f[2] = brink_ball_overlap_at(r, v, sigma, t);
    f[3] = brink_ball_overlap_rate_at(r, v, t);
    f[4] = brink_halfspace_overlap(r, n, c);
    f[5] = brink_halfspace_overlap_rate(v, n);
    f[6] = brink_halfspace_overlap_at(r, v, n, c, t);
    sign[0] = brink_ball_overlap_sign(r, sigma);
    sign[1] = brink_ball_overlap_rate_sign(r, v);
    sign[2] = brink_ball_overlap_sign_at(r, v, sigma, t);
    sign[3] = brink_ball_overlap_rate_sign_at(r, v, t);
    sign[4] = brink_halfspace_overlap_sign(r, n, c);
    sign[5] = brink_halfspace_overlap_rate_sign(v, n);
    sign[6] = brink_halfspace_overlap_sign_at(r, v, n, c, t);
}

static _Noreturn void broken(const char *law, int k, const pair_case *p,
                             const pair_case *q, double t)
{
    FINDING("overlap, quantity %d: %s", k, law);
    finding_numbers("r", 3, p->r);
    finding_numbers("v", 3, p->v);
    finding_numbers("sigma", 1, &p->sigma);
    finding_numbers("n", 3, q->v);
    finding_numbers("c", 3, q->r);
    finding_numbers("t", 1, &t);
    finding_end();
}

/** A whole number rounded to a double, and that by an ulp. */
static int is_within_bound(double f, whole right)
{
    const double nearest = (double)right;
    const double ulp = nextafter(fabs(nearest), (double)INFINITY) - fabs(nearest);
    return right == 0 ? f == 0 : fabs(f - nearest) <= BRINK_OVERLAP_ULP * ulp;
}

static void check_whole(stream *s)
{
    pair_case p, q;
    double t, f[VALUES];
    whole right[VALUES];
    int sign[VALUES];
    some_whole_numbers(s, &p, &q, &t);
    in_whole_numbers(&p, &q, t, right);
    by_kernels(&p, &q, t, f, sign);
    for (int k = 0; k < VALUES; k++) {
        if (sign[k] != (right[k] > 0) - (right[k] < 0))
            broken("the sign in whole numbers", k, &p, &q, t);
        if (!is_within_bound(f[k], right[k]))
            broken("the value in whole numbers", k, &p, &q, t);
    }
}

// --- Paths, and what is the same by two names ----------------------------------

static void keep_to_paths(stream *s)
{
    const pair_family *family =
        &pair_families[stream_int(s, 0, PAIR_FAMILIES - 1)];
    pair_case p, q;
    double y[PATHS_IN_ALL][QUANTITIES];
    family->make(s, &p);
    family->make(s, &q);
    const double t = stream_scaled(s, -4, 4);
    for (int path = 0; path < PATHS_IN_ALL && can_try(path); path++) {
        quantities(path, &p, &q, t, y[path]);
        for (int k = 0; k < QUANTITIES; k++)
            if (!same(y[path][k], y[0][k]))
                broken("another path, other bits", k, &p, &q, t);
    }
    double f[VALUES];
    int now[VALUES], at[VALUES];
    by_kernels(&p, &q, t, f, now);
    by_kernels(&p, &q, 0, f, at);
    for (int k = 0; k < VALUES; k++) {
        static const int by_another_name[VALUES] = {2, 3, 0, 1, 6, 5, 4};
        if (at[k] != at[by_another_name[k]])
            broken("now is not at once", k, &p, &q, t);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    stream s = stream_of_bytes(data, size);
    const int k = stream_int(&s, 0, VALUES + 1);
    if (k >= VALUES) {
        check_whole(&s);
        keep_to_paths(&s);
        return 0;
    }
    const lawful *l = &quantities_of[k];
    const problem *p = l->problem;
    double x[PROBLEM_INPUTS] = {0};
    truth right = {0};
    contract_case(p, &s, p->width, x);
    p->solve(x, &right);
    contract_check(p, RANK_PLAIN, x, &right);
    contract_check(p, RANK_SIGN, x, &right);
    laws_check(l, RANK_PLAIN, x, &s);
    laws_check(l, RANK_SIGN, x, &s);
    return 0;
}
