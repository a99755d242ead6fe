// SPDX-License-Identifier: MIT
// Every function of exact.h and its stated bound.
#include "../tests/oracle_dd.h"
#include "fuzz.h"

static const double u = 0x1p-53;

static _Noreturn void broken(const char *what, double a, double b, double c)
{
    FINDING("exact: %s", what);
    const double x[3] = {a, b, c};
    finding_numbers("x", 3, x);
    finding_end();
}

/** A double: few bits or all of them, a power of two, a neighbour of one. */
static double some_double(stream *s, int low, int high)
{
    const double x = stream_scaled(s, low, high);
    switch (stream_int(s, 0, 3)) {
    case 0:
        return ldexp(stream_int(s, -64, 64), ilogb(x) - 6);
    case 1:
        return stream_near(s, ldexp(stream_sign(s), ilogb(x)), 2);
    default:
        return x;
    }
}

// --- Error-free transforms -----------------------------------------------------

static void expect_exact(const char *what, dd got, const mpfr_t exact, double a,
                         double b)
{
    if (oracle_dd_error(got, exact) != 0)
        broken(what, a, b, got.lo);
}

static void check_transforms(stream *s)
{
    // The lowest bits of products are 2^-1074 and more.
    const int e = stream_int(s, 0, 900), low = e < 56 ? -966 - e : -1021;
    double a = some_double(s, -1074, 1022), b = some_double(s, -1074, 1022);
    const double c = some_double(s, e, e + 1), d = some_double(s, low, 1022 - e);
    if (stream_int(s, 0, 1)) // of one magnitude, or cancelling
        b = stream_near(s, stream_sign(s) * a, 4);
    mpfr_t z;
    mpfr_init2(z, ORACLE_BITS);
    mpfr_set_d(z, a, ORACLE_N);
    mpfr_add_d(z, z, b, ORACLE_N);
    expect_exact("two_sum", two_sum(a, b), z, a, b);
    expect_exact("two_sum", two_sum(b, a), z, b, a);
    if (fabs(a) >= fabs(b))
        expect_exact("fast_two_sum", fast_two_sum(a, b), z, a, b);
    expect_exact("fast_two_sum", fast_two_sum(0, b),
                 (mpfr_set_d(z, b, ORACLE_N), z), 0, b);
    mpfr_set_d(z, c, ORACLE_N);
    mpfr_mul_d(z, z, d, ORACLE_N);
    expect_exact("two_prod", two_prod(c, d), z, c, d);
    mpfr_clear(z);
}

// --- Double-double -------------------------------------------------------------

static void expect_close(const char *what, dd got, const mpfr_t exact,
                         double bound, dd x, dd y)
{
    const int normal = fabs(got.lo) <= u * fabs(got.hi);
    if (oracle_dd_error(got, exact) <= bound * u * u && normal)
        return;
    FINDING("exact: %s, off by more than %g u^2, or lo beyond half an ulp", what,
            bound);
    const double in[4] = {x.hi, x.lo, y.hi, y.lo}, out[2] = {got.hi, got.lo};
    finding_numbers("x", 4, in);
    finding_numbers("got", 2, out);
    finding_end();
}

static void check_double_doubles(stream *s)
{
    const dd x = oracle_any_dd(s);
    dd y = oracle_any_dd(s);
    if (stream_int(s, 0, 2) == 0) // all but cancelling
        y = (dd){-x.hi, stream_near(s, -x.lo, 4)};
    if (stream_int(s, 0, 3) == 0) // low parts in the way of high ones
        y = (dd){y.hi, 0};
    mpfr_t a, b, z;
    mpfr_inits2(ORACLE_BITS, a, b, z, (mpfr_ptr)0);
    oracle_set_dd(a, x);
    oracle_set_dd(b, y);
    mpfr_add(z, a, b, ORACLE_N);
    expect_close("dd_add", dd_add(x, y), z, 3.01, x, y);
    mpfr_add_d(z, a, y.hi, ORACLE_N);
    expect_close("dd_add_d", dd_add_d(x, y.hi), z, 2, x, y);
    mpfr_mul(z, a, b, ORACLE_N);
    expect_close("dd_mul", dd_mul(x, y), z, 4, x, y);
    mpfr_mul_d(z, a, y.hi, ORACLE_N);
    expect_close("dd_mul_d", dd_mul_d(x, y.hi), z, 2, x, y);
    mpfr_div(z, a, b, ORACLE_N);
    expect_close("dd_div", dd_div(x, y), z, 15.01, x, y);
    mpfr_neg(z, a, ORACLE_N);
    expect_close("dd_negate", dd_negate(x), z, 0, x, y);
    const dd square = x.hi < 0 ? dd_negate(x) : x;
    oracle_set_dd(a, square);
    mpfr_sqrt(z, a, ORACLE_N);
    expect_close("dd_sqrt", dd_sqrt(square), z, 25.0 / 8, square, y);
    oracle_set_dd(a, x);
    if (sum_of(x) != mpfr_get_d(a, ORACLE_N))
        broken("sum_of", x.hi, x.lo, sum_of(x));
    mpfr_clears(a, b, z, (mpfr_ptr)0);
}

/** What is told is the nearest double whatever the error, up to 2^-70 of it. */
static void check_told(stream *s)
{
    const double hi = some_double(s, -3, 3);
    if (hi == 0)
        return;
    const double half = ldexp(u, ilogb(hi)) * (stream_int(s, 0, 1) ? 1 : 0.5);
    const double inside = ldexp(stream_int(s, 0, 8), -stream_int(s, 10, 20));
    const dd x = {hi, stream_sign(s) * half * (1 - inside)};
    mpfr_t z, moved;
    mpfr_inits2(ORACLE_BITS, z, moved, (mpfr_ptr)0);
    oracle_set_dd(z, x);
    for (int way = -1; way <= 1; way += 2) {
        mpfr_add_d(moved, z, way * 0x1p-70 * fabs(hi), ORACLE_N);
        if (x.hi + x.lo == x.hi && is_told(x) &&
            mpfr_get_d(moved, ORACLE_N) != x.hi)
            broken("told, but not certain", x.hi, x.lo, 0);
    }
    mpfr_clears(z, moved, (mpfr_ptr)0);
}

// --- Choices, powers of two ----------------------------------------------------

/** Any 64 bits that are a double; the odd ones among them. */
static double any_double(stream *s)
{
    static const double odd[] = {0.0,
                                 -0.0,
                                 (double)INFINITY,
                                 -(double)INFINITY,
                                 (double)NAN,
                                 0x1p-1074,
                                 DBL_MAX,
                                 0x1p-512,
                                 0x1p512,
                                 0x1.fffffffffffffp-513};
    if (stream_int(s, 0, 1))
        return odd[stream_int(s, 0, 9)];
    return double_of(stream_bits(s));
}

static int equal(double x, double y)
{
    return x == y || (isnan(x) && isnan(y));
}

static void check_choices(stream *s)
{
    const double x = any_double(s), y = any_double(s), z = any_double(s);
    const int ordered = !isnan(x) && !isnan(y);
    if (!equal(larger(x, y), ordered && x > y ? x : y))
        broken("larger", x, y, larger(x, y));
    if (!equal(smaller(x, y), ordered && x < y ? x : y))
        broken("smaller", x, y, smaller(x, y));
    if (!equal(if_negative(x, y, z), signbit(x) ? y : z))
        broken("if_negative", x, y, z);
    const int all = x >= 0x1p-512 && x < 0x1p512,
              two = y >= 0x1p-512 && y < 0x1p512,
              three = z >= 0x1p-512 && z < 0x1p512;
    if (is_moderate(x) != all || are_moderate(x, y, z) != (all && two && three))
        broken("moderate", x, y, z);
    if (x != 0 && !isnan(x) && sign_of(x) != (x > 0 ? 1 : -1))
        broken("sign_of", x, 0, 0);
    if (bits_of(double_of(bits_of(x))) != bits_of(x))
        broken("bits_of", x, 0, 0);
}

static void check_exponents(stream *s)
{
    double x[3], largest = 0;
    for (int k = 0; k < 3; k++) {
        x[k] = any_double(s);
        x[k] = isfinite(x[k]) ? x[k] : 1;
        largest = fmax(largest, fabs(x[k]));
    }
    const int e = common_exponent(3, x), is_small = largest < 0x1p-1022;
    const double scaled_to = largest * power_of_two(-e);
    if (e < -1022 || e > 1022 || (!is_small && !(scaled_to >= 1)) ||
        !(scaled_to < (largest >= 0x1p1023 ? 4 : 2)))
        broken("common_exponent", x[0], x[1], x[2]);
    if (is_small && e != -1022)
        broken("common_exponent of subnormals", x[0], x[1], x[2]);
    if (isnormal(largest) && biased_exponent(largest) - 1023 != ilogb(largest))
        broken("biased_exponent", largest, 0, 0);

    const int power = stream_int(s, -1022, 1023), by = stream_int(s, -2040, 2040);
    if (power_of_two(power) != ldexp(1, power))
        broken("power_of_two", power, 0, 0);
    if (isnormal(ldexp(x[0], by / 2)) && scaled(x[0], by) != ldexp(x[0], by))
        broken("scaled", x[0], by, scaled(x[0], by));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    stream s = stream_of_bytes(data, size);
    switch (stream_int(&s, 0, 3)) {
    case 0:
        check_transforms(&s);
        break;
    case 1:
        check_double_doubles(&s);
        break;
    case 2:
        check_told(&s);
        break;
    default:
        check_choices(&s);
        check_exponents(&s);
    }
    return 0;
}
