// SPDX-License-Identifier: MIT
#include "times.h"

__extension__ typedef __int128 whole;

static _Noreturn void broken(const char *what, const double r[3],
                             const double v[3], double sigma, double got,
                             double other)
{
    FINDING("%s", what);
    finding_numbers("r", 3, r);
    finding_numbers("v", 3, v);
    finding_numbers("sigma", 1, &sigma);
    fprintf(stderr, "  %a and %a\n", got, other);
    finding_end();
}

static void keep_to_paths(time_kernel *const on[3], const double *x)
{
    for (int path = 1; path < PATHS_IN_ALL && can_try(path); path++) {
        const double any = on[0](x, x + 3, x[6]), t = on[path](x, x + 3, x[6]);
        if (!same(any, t))
            broken("another path, other bits", x, x + 3, x[6], any, t);
    }
}

static void check(const lawful *l, enum rank rank, const double *x, stream *s)
{
    truth right = {0};
    l->problem->solve(x, &right);
    contract_check(l->problem, rank, x, &right);
    laws_check(l, rank, x, s);
}

static void check_families(const time_tier *tier, stream *s)
{
    static const lawful intersection = {&problem_intersection, "LLLVVVR", "T"},
                        disjoint = {&problem_disjoint, "LLLVVVR", "T"};
    double x[PROBLEM_INPUTS] = {0};
    contract_case(&problem_intersection, s, 7, x);
    check(&intersection, tier->rank, x, s);
    check(&disjoint, tier->rank, x, s);
    keep_to_paths(tier->intersection_on, x);
    keep_to_paths(tier->disjoint_on, x);
}

// --- Whole numbers -------------------------------------------------------------

enum { MOST_BITS = 20, LATEST = 64 };

typedef struct whole_pair {
    double r[3], v[3], sigma;
    whole a, b, c, d; // f(t) = a t^2 + 2 b t + c, d = b^2 - a c
} whole_pair;

static void find_path(whole_pair *p)
{
    const whole sigma = (whole)p->sigma;
    p->a = p->b = 0;
    p->c = -sigma * sigma;
    for (int i = 0; i < 3; i++) {
        const whole r = (whole)p->r[i], v = (whole)p->v[i];
        p->a += v * v;
        p->b += r * v;
        p->c += r * r;
    }
    p->d = p->b * p->b - p->a * p->c; // < 2^3 (2^27)^4
}

/** sigma is near |r|, or near how closely the pair passes, or any. */
static double some_radius(stream *s, const whole_pair *p, int bits)
{
    const double rr = (double)p->c,
                 nearest = rr - (double)(p->b * p->b) / (double)p->a;
    switch (stream_int(s, 0, 2)) {
    case 0:
        return fmax(0, rint(sqrt(rr)) + stream_int(s, -1, 1));
    case 1:
        return p->a > 0
                   ? fmax(0, rint(sqrt(fabs(nearest))) + stream_int(s, -1, 1))
                   : 0;
    default:
        return stream_int(s, 0, 1 << bits);
    }
}

static whole_pair some_whole_pair(stream *s)
{
    whole_pair p = {.sigma = 0};
    const int bits = stream_int(s, 2, MOST_BITS), most = 1 << bits;
    for (int i = 0; i < 3; i++) {
        p.r[i] = stream_int(s, -most, most);
        p.v[i] = stream_int(s, -most, most);
    }
    find_path(&p);
    p.sigma = some_radius(s, &p, bits);
    find_path(&p);
    return p;
}

/** 0: now, +inf: never, 1: later. */
static double meets(const whole_pair *p)
{
    if (p->b >= 0 || (p->c > 0 && p->d <= 0))
        return (double)INFINITY;
    return p->c > 0;
}

static double parts(const whole_pair *p)
{
    if (p->a == 0)
        return (double)INFINITY;
    return p->b < 0 || p->c < 0;
}

static double checked(time_kernel *kernel, double when, const whole_pair *p)
{
    const double t = kernel(p->r, p->v, p->sigma);
    const int right = when == 1 ? t > 0 && isfinite(t) : t == when;
    if (!right)
        broken("never, now or later, in whole numbers", p->r, p->v, p->sigma, t,
               when);
    return t;
}

static double ulp_of(double x)
{
    return nextafter(x, (double)INFINITY) - x;
}

/** first + way second = while_, each of the two off by so many ulp; the sum in
 *  long double has 2^-11 ulp of the larger term to add. */
static void expect_sum(const char *law, const whole_pair *p, double first,
                       int way, double second, double sum, double ulp)
{
    const long double off =
        (long double)first + (long double)(way * second) - (long double)sum;
    const double slack = ulp * (ulp_of(first) + ulp_of(second)) +
                         0x1p-9 * ulp_of(fmax(fmax(first, second), sum));
    if (!(fabsl(off) <= (long double)slack))
        broken(law, p->r, p->v, p->sigma, first, second);
}

static void check_whole(const time_tier *tier, stream *s)
{
    const problem *of = &problem_intersection;
    const double ulp = of->method[contract_kernel(of, tier->rank)].bound;
    const whole_pair now = some_whole_pair(s);
    whole_pair later = now, back;
    const int wait = stream_int(s, 1, LATEST);
    for (int i = 0; i < 3; i++)
        later.r[i] += wait * later.v[i];
    find_path(&later);
    back = later;
    for (int i = 0; i < 3; i++)
        back.v[i] = -back.v[i];
    find_path(&back);

    const double in = checked(tier->intersection, meets(&now), &now);
    const double in_later = checked(tier->intersection, meets(&later), &later);
    const double in_back = checked(tier->intersection, meets(&back), &back);
    const double out = checked(tier->disjoint, parts(&now), &now);
    const double out_later = checked(tier->disjoint, parts(&later), &later);
    if (meets(&now) == 1 && meets(&later) == 1 && later.c > 0)
        expect_sum("nearer by the while that passed", &now, in, -1, in_later,
                   wait, ulp);
    if (parts(&now) == 1 && parts(&later) == 1 && out > 0)
        expect_sum("parts after the while that passed", &now, out, -1, out_later,
                   wait, ulp);
    if (meets(&back) == 1 && parts(&now) == 1 && now.d > 0)
        expect_sum("gone back, it meets where it parted", &now, out, 1, in_back,
                   wait, ulp);
}

void times_check(const time_tier *tier, stream *s)
{
    const int in_whole = stream_int(s, 0, 3) == 0;
    if (in_whole && tier->rank != RANK_FAST)
        check_whole(tier, s);
    else
        check_families(tier, s);
}
