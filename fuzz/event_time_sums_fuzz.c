// SPDX-License-Identifier: MIT
// The sums that the event times are made of, against the bounds that their
// comments state and the proofs of what is certain rest on.
#include "../tests/oracle.h"
#include "../tests/pairs.h"
#include "fuzz.h"
#include <brink/event_time_parting.h>

static const double u = 0x1p-53;

/** A pair, what is exact of it, and the sizes P and R of the terms. */
typedef struct certain {
    const pair_case *pair;
    oracle_path path;
    double p, r;
} certain;

static double off_by(const mpfr_t exact, double hi, double lo)
{
    mpfr_t z;
    mpfr_init2(z, ORACLE_BITS);
    mpfr_set_d(z, hi, ORACLE_N);
    mpfr_add_d(z, z, lo, ORACLE_N);
    mpfr_sub(z, z, exact, ORACLE_N);
    const double off = fabs(mpfr_get_d(z, MPFR_RNDA));
    mpfr_clear(z);
    return off;
}

/** Bounds are to first order: 1 + 2^-20 is for the rest. */
static void expect(const certain *c, const char *what, const mpfr_t exact, dd got,
                   double bound)
{
    const double off = off_by(exact, got.hi, got.lo);
    if (off <= bound * (1 + 0x1p-20))
        return;
    FINDING("%s: off by %g of its bound", what, off / bound);
    finding_numbers("r", 3, c->pair->r);
    finding_numbers("v", 3, c->pair->v);
    finding_numbers("sigma", 1, &c->pair->sigma);
    finding_end();
}

static void check_carried(const certain *c)
{
    const pair_case *p = c->pair;
    const double a = mpfr_get_d(c->path.a, ORACLE_N),
                 b = fabs(mpfr_get_d(c->path.b, ORACLE_N)),
                 size = fabs(mpfr_get_d(c->path.c, ORACLE_N));
    sums m = sums_of(p->r, p->v, p->sigma);
    expect(c, "a", c->path.a, m.a, 7 * u * u * a);
    expect(c, "b", c->path.b, m.b, 7 * u * u * c->p);
    expect(c, "c", c->path.c, m.c, 11 * u * u * c->r);
    if (size < 0.33 * c->r)
        expect(c, "c where it is small", c->path.c, m.c, m.c_error);
    look_closer(&m, p->r, p->sigma);
    expect(c, "c looked at closer", c->path.c, m.c,
           2 * u * u * size + 0x1p-150 * c->r);
    expect(c, "b, closely", c->path.b, (dd){dot_closely(p->r, p->v), 0},
           2 * u * b + 8 * u * u * c->p);
}

static void check_near(const certain *c)
{
    const pair_case *p = c->pair;
    const double b = fabs(mpfr_get_d(c->path.b, ORACLE_N)),
                 size = fabs(mpfr_get_d(c->path.c, ORACLE_N));
    const two_dots dots = {dot_of(p->r, p->v), dot_of(p->r, p->r)};
    near_sums m = near_sums_of(dots, p->sigma);
    expect(c, "b of a near pair", c->path.b, (dd){m.b, 0},
           u * b + 7 * u * u * c->p);
    expect(c, "c of a near pair", c->path.c, (dd){m.c, 0},
           size < 0.33 * c->r ? u * size + m.c_error : 2 * u * size);
    look_closer_near(&m, p->r, p->sigma);
    expect(c, "c of a near pair, closer", c->path.c, (dd){m.c, 0},
           u * size + m.c_error);
}

/** Where a discriminant is certain, its sign is and its error is stated. */
static void check_discriminant(const certain *c)
{
    const pair_case *p = c->pair;
    const sums m = sums_of(p->r, p->v, p->sigma);
    const discriminant d = discriminant_of(&m);
    if (d.certain)
        expect(c, "d", c->path.d, (dd){d.d, 0},
               2.4 * u * fabs(mpfr_get_d(c->path.d, ORACLE_N)));
}

static void check_filters(const certain *c)
{
    const pair_case *p = c->pair;
    const double a = dot_rounded(p->v, p->v), b = dot_rounded(p->r, p->v),
                 rr = dot_rounded(p->r, p->r), ss = p->sigma * p->sigma;
    expect(c, "b, rounded", c->path.b, (dd){b, 0}, 3 * u * c->p);
    if (!is_far(rr, ss) || !passes(a, b, rr - ss))
        return;
    if (mpfr_sgn(c->path.d) > 0 && mpfr_sgn(c->path.b) < 0) {
        FINDING("a pair that meets passes by");
        finding_numbers("r", 3, p->r);
        finding_numbers("v", 3, p->v);
        finding_numbers("sigma", 1, &p->sigma);
        finding_end();
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    stream s = stream_of_bytes(data, size);
    pair_case p;
    pair_families[stream_int(&s, 0, PAIR_FAMILIES - 1)].make(&s, &p);
    const double least = 0x1p-150, most = 0x1p150; // nothing of it underflows
    int is_square = 1;                             // each r_i v_i is 0
    certain c = {.pair = &p};
    double vv = 0;
    c.r = p.sigma * p.sigma;
    for (int i = 0; i < 3; i++) {
        c.p += fabs(p.r[i] * p.v[i]);
        c.r += p.r[i] * p.r[i];
        vv += p.v[i] * p.v[i];
        is_square &= p.r[i] == 0 || p.v[i] == 0;
    }
    if (!(c.r > least && c.r < most && vv > least && vv < most) ||
        !(c.p > least || is_square))
        return 0;
    oracle_path_make(&c.path, p.r, p.v, p.sigma);
    check_carried(&c);
    check_near(&c);
    check_discriminant(&c);
    check_filters(&c);
    oracle_path_clear(&c.path);
    return 0;
}
