// SPDX-License-Identifier: MIT
#include "oracle_dd.h"
#include "suite.h"

enum { CASES = 20000, SEED = 1 };

static const double u = 0x1p-53;

static void expect(const char *what, dd got, const mpfr_t exact, double bound,
                   dd x, dd y)
{
    double error = oracle_dd_error(got, exact);
    if (!(error <= bound))
        ck_abort_msg(
            "%s of %a + %a and %a + %a (seed %d): error %g u^2, bound %g u^2",
            what, x.hi, x.lo, y.hi, y.lo, SEED, error / (u * u), bound / (u * u));
}

START_TEST(sums_of_two_doubles_are_exact)
{
    stream s = stream_of_seed(SEED);
    mpfr_t exact;
    mpfr_init2(exact, ORACLE_BITS);
    for (int i = 0; i < (int)suite_share(CASES); i++) {
        double a = stream_scaled(&s, -1080, 1023),
               b = stream_scaled(&s, -1080, 1023);
        if (i % 2)
            b = stream_near(&s, -a, 4);
        mpfr_set_d(exact, a, ORACLE_N);
        mpfr_add_d(exact, exact, b, ORACLE_N);
        expect("two_sum", two_sum(a, b), exact, 0, (dd){a, 0}, (dd){b, 0});
        if (fabs(a) >= fabs(b))
            expect("fast_two_sum", fast_two_sum(a, b), exact, 0, (dd){a, 0},
                   (dd){b, 0});
    }
    mpfr_clear(exact);
}
END_TEST

START_TEST(products_of_two_doubles_are_exact)
{
    stream s = stream_of_seed(SEED);
    mpfr_t exact;
    mpfr_init2(exact, ORACLE_BITS);
    for (int i = 0; i < (int)suite_share(CASES); i++) {
        // Down to where the last bit of the product is 2^-1074.
        int e = stream_int(&s, 0, 900);
        double a = stream_scaled(&s, e, e + 1),
               b = stream_scaled(&s, -968 - e, 1023 - e);
        mpfr_set_zero(exact, 1);
        oracle_add(exact, 1, a, b);
        expect("two_prod", two_prod(a, b), exact, 0, (dd){a, 0}, (dd){b, 0});
    }
    mpfr_clear(exact);
}
END_TEST

START_TEST(double_doubles_keep_their_bounds)
{
    stream s = stream_of_seed(SEED);
    mpfr_t a, b, z;
    mpfr_inits2(ORACLE_BITS, a, b, z, (mpfr_ptr)0);
    for (int i = 0; i < (int)suite_share(CASES); i++) {
        dd x = oracle_any_dd(&s), y = i % 4 ? oracle_any_dd(&s) : dd_negate(x);
        if (i % 4 == 0) // cancelling
            y.lo = stream_near(&s, y.lo, 4);
        oracle_set_dd(a, x);
        oracle_set_dd(b, y);
        mpfr_add(z, a, b, ORACLE_N);
        expect("dd_add", dd_add(x, y), z, 3.01 * u * u, x, y);
        mpfr_add_d(z, a, y.hi, ORACLE_N);
        expect("dd_add_d", dd_add_d(x, y.hi), z, 2 * u * u, x, y);
        mpfr_mul(z, a, b, ORACLE_N);
        expect("dd_mul", dd_mul(x, y), z, 4 * u * u, x, y);
        mpfr_mul_d(z, a, y.hi, ORACLE_N);
        expect("dd_mul_d", dd_mul_d(x, y.hi), z, 2 * u * u, x, y);
        mpfr_div(z, a, b, ORACLE_N);
        expect("dd_div", dd_div(x, y), z, 15.01 * u * u, x, y);
        dd square = x.hi < 0 ? dd_negate(x) : x;
        oracle_set_dd(a, square);
        mpfr_sqrt(z, a, ORACLE_N);
        expect("dd_sqrt", dd_sqrt(square), z, 25.0 / 8 * u * u, square, y);
    }
    mpfr_clears(a, b, z, (mpfr_ptr)0);
}
END_TEST

START_TEST(what_is_told_is_the_nearest_double)
{
    // If it is told, x.hi + x.lo moved by 2^-70 either way rounds to x.hi.
    stream s = stream_of_seed(SEED);
    mpfr_t z, slack;
    mpfr_inits2(ORACLE_BITS, z, slack, (mpfr_ptr)0);
    int told = 0;
    for (int i = 0; i < (int)suite_share(CASES); i++) {
        double hi =
            i % 3 ? stream_scaled(&s, -3, 3) : ldexp(1, stream_int(&s, -3, 3));
        double half = ldexp(u, ilogb(hi)) * (stream_int(&s, 0, 1) ? 1 : 0.5);
        dd x = {hi, stream_sign(&s) * half *
                        (1 - stream_int(&s, 0, 8) *
                                 ldexp(1, -stream_int(&s, 10, 20)))};
        if (x.hi + x.lo != x.hi || !is_told(x))
            continue;
        told++;
        for (int end = -1; end <= 1; end += 2) {
            oracle_set_dd(z, x);
            mpfr_set_d(slack, end * 0x1p-70 * fabs(hi), ORACLE_N);
            mpfr_add(z, z, slack, ORACLE_N);
            if (mpfr_get_d(z, ORACLE_N) != x.hi)
                ck_abort_msg("%a + %a (seed %d) was told", x.hi, x.lo, SEED);
        }
    }
    ck_assert_int_gt(told, CASES / 10);
    mpfr_clears(z, slack, (mpfr_ptr)0);
}
END_TEST

START_TEST(moderate_is_what_it_says)
{
    ck_assert(is_moderate(0x1p-512) && is_moderate(1) && is_moderate(0x1.8p511));
    ck_assert(!is_moderate(0x1.fffffffffffffp-513) && !is_moderate(0x1p512));
    ck_assert(!is_moderate(0) && !is_moderate(-1) &&
              !is_moderate((double)INFINITY));
    ck_assert(!is_moderate((double)NAN) && !is_moderate(-(double)NAN));
    ck_assert(are_moderate(1, 0x1p-512, 0x1p511));
    ck_assert(!are_moderate(0x1p512, 1, 1) && !are_moderate(1, 0, 1) &&
              !are_moderate(1, 1, (double)NAN));
}
END_TEST

START_TEST(choices_are_what_they_say)
{
    static const double x[] = {-(double)INFINITY, -1, -0x1p-1074, 0, 1,
                               (double)INFINITY};
    const double none = (double)NAN;
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            ck_assert(larger(x[i], x[j]) == x[i > j ? i : j]);
            ck_assert(smaller(x[i], x[j]) == x[i < j ? i : j]);
        }
        ck_assert(larger(none, x[i]) == x[i] && smaller(none, x[i]) == x[i]);
        ck_assert(isnan(larger(x[i], none)) && isnan(smaller(x[i], none)));
        ck_assert(if_negative(x[i], 2, none) == 2 || x[i] >= 0);
        ck_assert(if_negative(x[i], none, 3) == 3 || x[i] < 0);
        ck_assert(x[i] == 0 || sign_of(x[i]) == (x[i] > 0 ? 1 : -1));
    }
    ck_assert(if_negative(-0.0, 2, 3) == 2); // by the sign bit
}
END_TEST

START_TEST(common_exponents_bring_the_largest_to_one)
{
    for (int e = -1074; e <= 1023; e++) {
        const double x[3] = {0, -ldexp(1.5, e), ldexp(1, e - 1)};
        const int common = common_exponent(3, x); // either way a normal double
        ck_assert_int_ge(common, -1022);
        ck_assert_int_le(common, 1022);
        double largest = fabs(x[1]) * power_of_two(-common);
        ck_assert(largest >= (e < -1022 ? 0x1p-52 : 1) &&
                  largest < (e > 1022 ? 4 : 2));
    }
}
END_TEST

START_TEST(nothing_is_contracted)
{
    // a b = 1 + 2^-26 + 2^-54 rounds to 1 + 2^-26; fused, 2^-54 is left.
    volatile double a = 1 + 0x1p-27, c = -(1 + 0x1p-26);
    double left = a * a + c;
    ck_assert_double_eq(left, 0);
    ck_assert_double_eq(fma(a, a, c), 0x1p-54);
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "exact", 300, sums_of_two_doubles_are_exact,
        products_of_two_doubles_are_exact, double_doubles_keep_their_bounds,
        what_is_told_is_the_nearest_double, moderate_is_what_it_says,
        choices_are_what_they_say, common_exponents_bring_the_largest_to_one,
        nothing_is_contracted);
}
