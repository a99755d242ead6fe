// SPDX-License-Identifier: MIT
// Correctly rounded roots and quotients against MPFR, at midpoints of two doubles
// and within any distance of them.
#include "fuzz.h" // before MPFR, which prints if stdio is there

#include "../tests/oracle_dyadic.h"
#include <brink/root.h>

// Coefficients are at most 2^-4250 to 2^4250 and a root is rounded once more.
enum { BITS = 9000 };

static const mpfr_rnd_t N = MPFR_RNDN;

typedef struct quadratic { // a x^2 + 2 b x + c
    brink_dyadic a, b, c, d;
} quadratic;

static void print(const char *name, const brink_dyadic *x)
{
    mpfr_t z;
    mpfr_init2(z, BITS);
    oracle_set_dyadic(z, x);
    mpfr_fprintf(stderr, "  %s = %Ra\n", name, z);
    mpfr_clear(z);
}

static void find_discriminant(quadratic *q)
{
    brink_dyadic bb, ac;
    brink_dyadic_mul(&bb, &q->b, &q->b);
    brink_dyadic_mul(&ac, &q->a, &q->c);
    brink_dyadic_sub(&q->d, &bb, &ac);
}

// --- What is right -------------------------------------------------------------

/** Both, the lower first: nothing cancels. */
static void find_roots(mpfr_t lower, mpfr_t upper, const quadratic *q)
{
    mpfr_t a, b, c;
    mpfr_inits2(BITS, a, b, c, (mpfr_ptr)0);
    oracle_set_dyadic(a, &q->a);
    oracle_set_dyadic(b, &q->b);
    oracle_set_dyadic(c, &q->c);
    mpfr_sqr(lower, b, N);
    mpfr_mul(upper, a, c, N);
    mpfr_sub(lower, lower, upper, N);
    mpfr_sqrt(lower, lower, N);
    if (mpfr_sgn(b) < 0)
        mpfr_neg(lower, lower, N);
    mpfr_add(lower, lower, b, N);
    mpfr_neg(lower, lower, N);
    if (mpfr_zero_p(lower))
        mpfr_set_zero(upper, 1);
    else
        mpfr_div(upper, c, lower, N);
    mpfr_div(lower, lower, a, N);
    if (mpfr_greater_p(lower, upper))
        mpfr_swap(lower, upper);
    mpfr_clears(a, b, c, (mpfr_ptr)0);
}

static void check_root(const quadratic *q)
{
    mpfr_t exact[2];
    mpfr_inits2(BITS, exact[0], exact[1], (mpfr_ptr)0);
    find_roots(exact[0], exact[1], q);
    for (int k = 0; k < 2; k++) {
        const double got =
            brink_dyadic_root(&q->a, &q->b, &q->c, &q->d, (enum brink_which)k);
        const double right = mpfr_get_d(exact[k], N);
        if (got == right)
            continue;
        FINDING("dyadic_root %d: %a, right is %a", k, got, right);
        print("a", &q->a);
        print("b", &q->b);
        print("c", &q->c);
        finding_end();
    }
    mpfr_clears(exact[0], exact[1], (mpfr_ptr)0);
}

static void check_quotient(const brink_dyadic *x, const brink_dyadic *y)
{
    mpfr_t a, b;
    mpfr_inits2(BITS, a, b, (mpfr_ptr)0);
    oracle_set_dyadic(a, x);
    oracle_set_dyadic(b, y);
    mpfr_div(a, a, b, N);
    const double got = brink_dyadic_quotient(x, y), right = mpfr_get_d(a, N);
    if (got != right) {
        FINDING("dyadic_quotient: %a, right is %a", got, right);
        print("x", x);
        print("y", y);
        finding_end();
    }
    mpfr_clears(a, b, (mpfr_ptr)0);
}

// --- Cases ---------------------------------------------------------------------

static int64_t some_integer(stream *s, int bits)
{
    const int64_t m = (int64_t)(stream_bits(s) >> (64 - bits));
    return stream_sign(s) < 0 ? -m : m;
}

static void some_number(brink_dyadic *x, stream *s)
{
    const int scale = stream_int(s, 0, 1) ? 2000 : 60;
    const int bits = stream_int(s, 1, 62);
    brink_dyadic_integer(x, some_integer(s, bits), stream_int(s, -scale, scale));
}

/** An odd m of 54 bits times 2^e: halfway between two doubles; and, as a rule, a
 *  little off: by 2^-32 to 2^-200 of itself, where double-double knows, is not
 *  sure, or cannot tell. */
static void near_midpoint(brink_dyadic *p, stream *s)
{
    const int64_t m = (int64_t)(stream_bits(s) >> 10 | UINT64_C(1) << 53) | 1;
    const int e = stream_int(s, -1140, 975), off = stream_int(s, -1, 1);
    const int64_t way = stream_sign(s) < 0 ? -1 : 1;
    brink_dyadic middle, little;
    brink_dyadic_integer(&middle, way * m, e);
    brink_dyadic_integer(&little, off * m, e - stream_int(s, 32, 200));
    brink_dyadic_add(p, &middle, &little);
}

/** A few bits, or many. */
static void other_root(brink_dyadic *q, stream *s)
{
    const int bits = stream_int(s, 1, 53);
    brink_dyadic_integer(q, some_integer(s, bits) | 1,
                         stream_int(s, -1100, 1000));
}

/** a (x - p)(x - q) = a x^2 - a (p + q) x + a p q */
static void from_roots(quadratic *f, const brink_dyadic *p, const brink_dyadic *q,
                       stream *s)
{
    brink_dyadic half, sum, slope, product;
    const int64_t a = some_integer(s, 4) | 1;
    brink_dyadic_integer(&f->a, a, 0);
    brink_dyadic_integer(&half, -a, -1);
    brink_dyadic_add(&sum, p, q);
    brink_dyadic_mul(&slope, &half, &sum);
    brink_dyadic_mul(&product, p, q);
    f->b = slope;
    brink_dyadic_mul(&f->c, &f->a, &product);
    find_discriminant(f);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    stream s = stream_of_bytes(data, size);
    quadratic f;
    brink_dyadic p, q, x;
    switch (stream_int(&s, 0, 3)) {
    case 0: // any
        some_number(&f.a, &s);
        some_number(&f.b, &s);
        some_number(&f.c, &s);
        find_discriminant(&f);
        if (f.a.sign != 0 && f.d.sign >= 0)
            check_root(&f);
        if (f.b.sign != 0)
            check_quotient(&f.c, &f.b);
        break;
    case 1: // two roots
        near_midpoint(&p, &s);
        other_root(&q, &s);
        from_roots(&f, &p, &q, &s);
        check_root(&f);
        break;
    case 2: // a double one
        near_midpoint(&p, &s);
        q = p;
        from_roots(&f, &p, &q, &s);
        check_root(&f);
        break;
    default:
        near_midpoint(&p, &s);
        other_root(&q, &s);
        brink_dyadic_mul(&x, &p, &q);
        check_quotient(&x, &q);
    }
    return 0;
}
