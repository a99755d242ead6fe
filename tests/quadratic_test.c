// SPDX-License-Identifier: MIT
#include "cases.h"
#include "oracle.h"
#include "oracle_integers.h"
#include "quadratics.h"
#include "suite.h"
#include <brink/quadratic.h>

enum { CASES_A_FAMILY = 4000, SEED = 1 };

typedef int roots_kernel(double a, double b, double c, double *x0, double *x1);

/** The count exact, each root within `ulp`, and for 0.5 the nearest double. */
static void keep(roots_kernel *kernel, double ulp, const char *family, int i,
                 const quadratic_case *q)
{
    const double untouched = -12345;
    double x[2] = {untouched, untouched};
    mpfr_t exact[2];
    mpfr_inits2(ORACLE_BITS, exact[0], exact[1], (mpfr_ptr)0);
    int count = kernel(q->a, q->b, q->c, &x[0], &x[1]);
    int right = oracle_roots(exact[0], exact[1], q->a, q->b, q->c);
    int good = count == right;
    for (int k = 0; k < 2; k++) {
        if (k >= right) {
            good = good && x[k] == untouched;
            continue;
        }
        good = good && oracle_ulps(x[k], exact[k]) <= ulp;
        if (ulp == 0.5)
            good = good && x[k] == mpfr_get_d(exact[k], ORACLE_N);
    }
    if (!good)
        ck_abort_msg("%s %d (seed %d), to %g ulp:\n%a %a %a\ngot %d: %a "
                     "%a\nexact %d: %a %a",
                     family, i, SEED, ulp, q->a, q->b, q->c, count, x[0], x[1],
                     right, mpfr_get_d(exact[0], ORACLE_N),
                     mpfr_get_d(exact[1], ORACLE_N));
    mpfr_clears(exact[0], exact[1], (mpfr_ptr)0);
}

static void keep_both(const char *family, int i, const quadratic_case *q)
{
    keep(brink_quadratic_roots, BRINK_QUADRATIC_ULP, family, i, q);
    keep(brink_quadratic_roots_cr, 0.5, family, i, q);
}

START_TEST(count_is_exact_and_roots_are_within_the_bound)
{
    for (int f = 0; f < QUADRATIC_FAMILIES; f++) {
        stream s = stream_of_seed(SEED);
        quadratic_case q;
        for (int i = 0; i < (int)suite_share(CASES_A_FAMILY); i++) {
            quadratic_families[f].make(&s, &q);
            keep_both(quadratic_families[f].name, i, &q);
        }
    }
}
END_TEST

START_TEST(hard_cases_are_within_the_bound)
{
    FILE *in = cases_open("quadratic");
    double x[3];
    for (int i = 0; cases_next(in, 3, x); i++)
        keep_both("quadratic.wc", i, &(quadratic_case){x[0], x[1], x[2]});
    fclose(in);
}
END_TEST

/** x within `ulps` steps of the double nearest to the root. */
static int is_near_root(const int q[3], int which, double x, int ulps)
{
    double y = x, z = x;
    for (int n = 0; n <= ulps; n++) {
        if (is_nearest_root(q[0], q[1], q[2], which, y) ||
            is_nearest_root(q[0], q[1], q[2], which, z))
            return 1;
        y = nextafter(y, (double)INFINITY);
        z = nextafter(z, -(double)INFINITY);
    }
    return 0;
}

START_TEST(all_small_integers_are_right)
{
    enum { MOST = 12, KINDS = 2 * MOST + 1 };
    for (int i = 0; i < KINDS * KINDS * KINDS; i++) {
        const int q[3] = {i % KINDS - MOST, i / KINDS % KINDS - MOST,
                          i / (KINDS * KINDS) - MOST};
        const int d = q[1] * q[1] - 4 * q[0] * q[2];
        const int count = q[0] == 0 ? q[1] != 0 : d < 0 ? 0 : 2;
        for (int tier = 0; tier < 2; tier++) {
            double x[2] = {7, 8};
            // A root within the bound is that many doubles from the nearest one.
            const int ulps = tier == 0 ? BRINK_QUADRATIC_ULP : 0;
            int good = count == (tier == 0 ? brink_quadratic_roots
                                           : brink_quadratic_roots_cr)(
                                    q[0], q[1], q[2], &x[0], &x[1]);
            if (count == 2)
                good = good && is_near_root(q, -1, x[0], ulps) &&
                       is_near_root(q, 1, x[1], ulps);
            if (count == 1) // c / b, rounded once
                good = good && x[0] == (double)-q[2] / q[1];
            if (!good)
                ck_abort_msg("%d %d %d, tier %d: %a %a", q[0], q[1], q[2], tier,
                             x[0], x[1]);
        }
    }
}
END_TEST

START_TEST(what_is_not_finite_is_refused)
{
    const double bad[] = {(double)INFINITY, -(double)INFINITY, (double)NAN};
    for (int k = 0; k < 3; k++)
        for (int place = 0; place < 3; place++)
            for (int zeros = 0; zeros < 8; zeros++) {
                double x[3] = {zeros & 1, zeros >> 1 & 1, zeros >> 2}, x0 = 7,
                       x1 = 8;
                x[place] = bad[k];
                ck_assert_int_eq(
                    brink_quadratic_roots(x[0], x[1], x[2], &x0, &x1), -1);
                ck_assert_int_eq(
                    brink_quadratic_roots_cr(x[0], x[1], x[2], &x0, &x1), -1);
                ck_assert(x0 == 7 && x1 == 8);
            }
}
END_TEST

START_TEST(scaling_by_a_power_of_two_loses_no_root)
{
    // t^2 - 3 t + 2 = 0.  GSL 2.7.1 finds no root at 2^665, and one of 1.5 twice
    // at 2^-665.
    for (int e = -1074; e < 1022; e++) {
        double x0, x1, s = ldexp(1, e);
        ck_assert_int_eq(brink_quadratic_roots(s, -3 * s, 2 * s, &x0, &x1), 2);
        ck_assert_double_eq(x0, 1);
        ck_assert_double_eq(x1, 2);
    }
}
END_TEST

START_TEST(both_outputs_may_be_one_place)
{
    double x;
    ck_assert_int_eq(brink_quadratic_roots(1, -3, 2, &x, &x), 2);
    ck_assert_double_eq(x, 2); // the second is written last
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "quadratic", 600, count_is_exact_and_roots_are_within_the_bound,
        hard_cases_are_within_the_bound, all_small_integers_are_right,
        what_is_not_finite_is_refused, scaling_by_a_power_of_two_loses_no_root,
        both_outputs_may_be_one_place);
}
