// SPDX-License-Identifier: MIT
// A short program on dyadic numbers, and the same in MPFR: after every step the
// two are one number, and every question about it has one answer.
#include "fuzz.h" // before MPFR, which prints if stdio is there

#include "../tests/oracle_dyadic.h"

enum { PLACES = 3, MOST_STEPS = 6 };

static const mpfr_rnd_t N = MPFR_RNDN;

/** A number both ways. */
typedef struct number {
    brink_dyadic d;
    mpfr_t m;
    int degree; // in doubles: at most BRINK_DYADIC_DEGREE
} number;

static _Noreturn void broken(const char *what, const number *x)
{
    FINDING("dyadic: %s", what);
    fprintf(stderr, "  sign %d, low %d, limbs", x->d.sign, x->d.low);
    for (int i = 0; i < x->d.count; i++)
        fprintf(stderr, " 0x%08x", (unsigned)x->d.limb[i]);
    mpfr_fprintf(stderr, "\n  exact %.60Ra\n", x->m);
    finding_end();
}

// --- What is asked of one ------------------------------------------------------

static void expect_equal(const char *what, const number *x)
{
    mpfr_t z;
    mpfr_init2(z, ORACLE_DYADIC_BITS);
    if (!oracle_set_dyadic(z, &x->d) || !mpfr_equal_p(z, x->m))
        broken(what, x);
    mpfr_clear(z);
}

/** Bits from a place up, of floor(|x| 2^-from) mod 2^count. */
static void check_bits(const number *x, stream *s)
{
    const int at = x->d.sign ? brink_dyadic_magnitude(&x->d) : 0;
    const int from = at + stream_int(s, -120, 40), count = stream_int(s, 0, 53);
    mpfr_t z, modulus;
    mpfr_inits2(ORACLE_DYADIC_BITS, z, modulus, (mpfr_ptr)0);
    mpfr_abs(z, x->m, N);
    mpfr_mul_2si(z, z, -from, N);
    mpfr_floor(z, z);
    mpfr_set_ui_2exp(modulus, 1, count, N);
    mpfr_fmod(z, z, modulus, N);
    if (brink_dyadic_bits(&x->d, from, count) != mpfr_get_uj(z, N))
        broken("bits", x);
    mpfr_clears(z, modulus, (mpfr_ptr)0);
}

static void check_leading(const number *x)
{
    int e;
    const dd m = brink_dyadic_leading(&x->d, &e);
    mpfr_t z;
    mpfr_init2(z, ORACLE_DYADIC_BITS);
    mpfr_set_d(z, m.hi, N);
    mpfr_add_d(z, z, m.lo, N);
    mpfr_mul_2si(z, z, e, N);
    mpfr_sub(z, z, x->m, N);
    // Off by 2u^2 of itself, which is at least 2^(e-1).
    if (!mpfr_zero_p(z) && (mpfr_get_exp(z) > mpfr_get_exp(x->m) - 105))
        broken("its leading part", x);
    if (m.hi == 0 ? x->d.sign != 0 : fabs(m.hi) < 0.5 || fabs(m.hi) > 1)
        broken("the size of its leading part", x);
    mpfr_clear(z);
}

static void check(const char *what, const number *x, stream *s)
{
    expect_equal(what, x);
    const double nearest = mpfr_get_d(x->m, N);
    if (brink_dyadic_round(&x->d) != nearest)
        broken("rounded", x);
    if (x->d.sign && brink_dyadic_magnitude(&x->d) != mpfr_get_exp(x->m))
        broken("magnitude", x);
    check_bits(x, s);
    check_leading(x);
}

// --- Steps ---------------------------------------------------------------------

static void load_double(number *z, stream *s)
{
    const double x = oracle_any_double(s);
    brink_dyadic_double(&z->d, x);
    mpfr_set_d(z->m, x, N);
    z->degree = 1;
}

/** Of up to 64 bits; where they are 54 and odd, a midpoint of two doubles. */
static void load_integer(number *z, stream *s)
{
    static const int64_t extremes[] = {INT64_MIN, INT64_MAX, 1, -1, 0};
    const int bits = stream_int(s, 1, 63), e = stream_int(s, -1075, 960);
    int64_t m = (int64_t)(stream_bits(s) >> (64 - bits)) | 1;
    if (stream_int(s, 0, 7) == 0)
        m = extremes[stream_int(s, 0, 4)];
    brink_dyadic_integer(&z->d, m, e);
    mpfr_set_sj_2exp(z->m, m, e, N);
    z->degree = 1;
}

static void load_dot(number *z, stream *s)
{
    double x[6], y[6];
    mpfr_t p;
    const int n = stream_int(s, 0, 6), cancels = stream_int(s, 0, 1);
    mpfr_init2(p, ORACLE_DYADIC_BITS);
    mpfr_set_zero(z->m, 1);
    for (int i = 0; i < n; i++) {
        x[i] = cancels && i % 2 ? -x[i - 1] : oracle_any_double(s);
        y[i] =
            cancels && i % 2 ? stream_near(s, y[i - 1], 1) : oracle_any_double(s);
        y[i] = isfinite(y[i]) ? y[i] : 1;
        mpfr_set_d(p, x[i], N);
        mpfr_mul_d(p, p, y[i], N);
        mpfr_add(z->m, z->m, p, N);
    }
    brink_dyadic_dot(&z->d, n, x, y);
    mpfr_clear(p);
    z->degree = 2;
}

static const char *combine(number *z, const number *x, const number *y, int how)
{
    z->degree = x->degree > y->degree ? x->degree : y->degree;
    if (how == 0) {
        brink_dyadic_add(&z->d, &x->d, &y->d);
        mpfr_add(z->m, x->m, y->m, N);
        return "a sum";
    }
    if (how == 1 || x->degree + y->degree > BRINK_DYADIC_DEGREE) {
        brink_dyadic_sub(&z->d, &x->d, &y->d);
        mpfr_sub(z->m, x->m, y->m, N);
        return "a difference";
    }
    brink_dyadic_mul(&z->d, &x->d, &y->d);
    mpfr_mul(z->m, x->m, y->m, N);
    z->degree = x->degree + y->degree;
    return "a product";
}

static const char *step(number *z, const number *x, const number *y, stream *s)
{
    switch (stream_int(s, 0, 7)) {
    case 0:
        load_double(z, s);
        return "a double";
    case 1:
        load_integer(z, s);
        return "an integer";
    case 2:
        load_dot(z, s);
        return "a dot product";
    case 3: // a number less itself
        return combine(z, x, x, 1);
    default:
        return combine(z, x, y, stream_int(s, 0, 2));
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static number x[PLACES];
    stream s = stream_of_bytes(data, size);
    for (int k = 0; k < PLACES; k++) {
        mpfr_init2(x[k].m, ORACLE_DYADIC_BITS);
        stream_int(&s, 0, 1) ? load_integer(&x[k], &s) : load_double(&x[k], &s);
        check("loaded", &x[k], &s);
    }
    for (int n = stream_int(&s, 1, MOST_STEPS); n > 0; n--) {
        const int to = stream_int(&s, 0, PLACES - 1);
        number *z = &x[to];
        const number *a = &x[(to + 1) % PLACES], *b = &x[(to + 2) % PLACES];
        check(step(z, a, b, &s), z, &s);
    }
    for (int k = 0; k < PLACES; k++)
        mpfr_clear(x[k].m);
    return 0;
}
