// SPDX-License-Identifier: MIT
#include "cost.h"
#include "measure.h"
#include "oracle.h"
#include "problems_all.h"
#include "suite.h"
#include <float.h>

static const double infinite = (double)INFINITY;

static real real_of(double x)
{
    real r;
    mpfr_t m;
    mpfr_init2(m, 53);
    mpfr_set_d(m, x, MPFR_RNDN);
    real_from(&r, m);
    mpfr_clear(m);
    return r;
}

// The oracle rounds its result up to a double, once; here it is rounded in long
// double and once more: 2^-52 of itself.
START_TEST(errors_are_those_of_the_oracle)
{
    stream s = stream_of_seed(1);
    mpfr_t exact;
    mpfr_init2(exact, ORACLE_BITS);
    for (int i = 0; i < 20000; i++) {
        const double x = stream_scaled(&s, -1080, 1024),
                     y = stream_scaled(&s, -40, 40);
        mpfr_set_d(exact, x, MPFR_RNDN);
        mpfr_mul_d(exact, exact, i % 3 == 0 ? y : 1 + y * 0x1p-60, MPFR_RNDN);
        real r;
        real_from(&r, exact);
        const double answer = stream_near(&s, i % 2 ? x : r.nearest, 3);
        const double here = real_ulps(answer, &r),
                     there = oracle_ulps(answer, exact);
        if (!(here == there || fabs(here - there) <= 0x1p-52 * there))
            ck_abort_msg("%a for %a: %a here, %a there", answer, r.nearest, here,
                         there);
    }
    mpfr_clear(exact);
}
END_TEST

START_TEST(ends_of_the_range_are_errors_like_any_other)
{
    const real largest = real_of(DBL_MAX), least = real_of(0x1p-1074);
    ck_assert(real_ulps(infinite, &largest) == 1);
    ck_assert(real_ulps(0, &least) == 1);
    ck_assert(real_ulps(infinite,
                        &(real){(long double)infinite, 0, infinite, -1074}) == 0);
    ck_assert(
        isinf(real_ulps(1, &(real){(long double)infinite, 0, infinite, -1074})));
    ck_assert(isinf(real_ulps((double)NAN, &least)));
    ck_assert(!real_is_spurious(0, &least));
    ck_assert(real_is_spurious(0, &largest));
}
END_TEST

START_TEST(what_is_wrong_is_called_by_its_name)
{
    const real never = {(long double)infinite, 0, infinite, -1074},
               now = {0, 0, 0, -1074};
    const real later = real_of(2);
    ck_assert_int_eq(problem_judge_time(&later, infinite).wrong, WRONG_MISSED);
    ck_assert_int_eq(problem_judge_time(&never, 2).wrong, WRONG_INVENTED);
    ck_assert_int_eq(problem_judge_time(&never, 0).wrong, WRONG_INVENTED);
    ck_assert_int_eq(problem_judge_time(&now, 2).wrong, WRONG_NOW);
    ck_assert_int_eq(problem_judge_time(&later, 0).wrong, WRONG_NOW);
    ck_assert_int_eq(problem_judge_time(&later, (double)NAN).wrong,
                     WRONG_SPURIOUS);
    ck_assert_int_eq(problem_judge_time(&later, -2).wrong, WRONG_SPURIOUS);
    ck_assert_int_eq(problem_judge_time(&later, 5).wrong, WRONG_NOT);
    ck_assert(problem_judge_time(&never, infinite).error[0] <
              0); // nothing to measure
}
END_TEST

START_TEST(a_quadratic_is_judged_by_its_count_first)
{
    const double x[3] = {1, -3, 2}, right[2] = {1, 2};
    const double beside[2] = {1, 2 + 0x1p-51}, none[2] = {1, infinite};
    truth t;
    problem_quadratic.solve(x, &t);
    judge_of *judge = problem_quadratic.judge;
    ck_assert_int_eq(judge(x, &t, 0, right).wrong, WRONG_MISSED);
    ck_assert(judge(x, &t, 2, right).error[0] == 0);
    ck_assert(judge(x, &t, 2, beside).error[0] == 1);
    ck_assert_int_eq(judge(x, &t, 2, none).wrong, WRONG_SPURIOUS);
    const double nowhere[3] = {1, 0, 1};
    problem_quadratic.solve(nowhere, &t);
    ck_assert_int_eq(judge(nowhere, &t, 2, right).wrong, WRONG_INVENTED);
}
END_TEST

// The distance from the surface: the answer is a relative 2^-40 too late, so the
// pair is 2^-40 |v| t too far on, head on; in eps of sigma + |v| t, 2^12 |v| t /
// (sigma + |v| t).
START_TEST(the_gap_is_how_far_the_pair_is_from_the_surface)
{
    const double x[7] = {4, 0, 0, -1, 0, 0, 1}, t = 3 * (1 + 0x1p-40);
    truth right;
    problem_intersection.solve(x, &right);
    const verdict v = problem_intersection.judge(x, &right, 0, &t);
    ck_assert_double_eq_tol(v.error[1], 0x1p12 * 3 / 4, 0x1p-20);
    const double never = infinite; // and would be all of sigma deep at t = 4
    const verdict missed = problem_intersection.judge(x, &right, 0, &never);
    ck_assert_int_eq(missed.wrong, WRONG_MISSED);
    ck_assert_double_eq_tol(missed.error[1], 0x1p52 / 5, 0x1p20);
}
END_TEST

// Found by fuzzing: distances a million times larger than what is flown were
// taken from each other, and left their own rounding as a gap.
START_TEST(far_pairs_that_hardly_move_are_judged_by_how_they_move)
{
    stream s = stream_of_seed(1);
    for (int i = 0; i < 100; i++) {
        double x[7] = {0}, along = 0, square = 0;
        for (int k = 0; k < 6; k++)
            x[k] = stream_real(&s, -1, 1);
        for (int k = 0; k < 3; k++) {
            along += x[k] * x[3 + k];
            square += x[3 + k] * x[3 + k];
        }
        for (int k = 0; k < 3; k++) // at its closest approach, to a rounding
            x[k] -= along / square * x[3 + k];
        truth t;
        problem_disjoint.solve(x, &t);
        // That is at some t = 2^-52; at 3 t it is (2 t)^2 / 2 farther, a few eps
        // of t.  A distance rounded to long double would be off by 2^40 of them.
        const double y = 3 * t.x[0].nearest;
        ck_assert(problem_disjoint.judge(x, &t, 0, &y).error[1] < 0x1p10);
    }
}
END_TEST

START_TEST(a_sample_is_in_order_and_knows_its_worst)
{
    sample s[2], all;
    for (int f = 0; f < 2; f++)
        ck_assert_int_eq(measure(&problem_quadratic, 0, 1, f, 500, 7, &s[f]), 0);
    ck_assert_int_eq(measure_pool(&all, 2, s), 0);
    ck_assert_int_eq(all.n, 1000);
    ck_assert_int_eq(measure_wrong(&all),
                     measure_wrong(&s[0]) + measure_wrong(&s[1]));
    for (int i = 1; i < all.count[0]; i++)
        ck_assert(all.error[0][i - 1] <= all.error[0][i]);
    ck_assert(measure_quantile(&all, 0, 1) ==
              fmax(measure_quantile(&s[0], 0, 1), measure_quantile(&s[1], 0, 1)));
    ck_assert(measure_quantile(&all, 0, 0.5) == all.error[0][499]);

    double x[3]; // the worst again, alone
    stream random = stream_of_seed(7);
    for (int i = 0; i <= s[0].worst[0]; i++)
        problem_quadratic.make(0, &random, x);
    truth t;
    problem_quadratic.solve(x, &t);
    inputs one = {.n = 1, .width = 3, .rows = x};
    answers *out = answers_make(1);
    problem_quadratic.method[0].loop(&one, out);
    const double y[2] = {out->x[0][0], out->x[1][0]};
    const verdict v = problem_quadratic.judge(x, &t, out->n[0], y);
    ck_assert(v.error[0] == measure_quantile(&s[0], 0, 1));
    answers_free(out);
    measure_free(&all);
    measure_free(&s[0]);
    measure_free(&s[1]);
}
END_TEST

START_TEST(names_are_of_one_method_each)
{
    for (int i = 0; i < PROBLEMS; i++)
        for (int k = 0; k < problems[i]->methods; k++) {
            int found;
            ck_assert_ptr_eq(problem_of(problems[i]->method[k].name, &found),
                             problems[i]);
            ck_assert_int_eq(found, k);
        }
}
END_TEST

START_TEST(every_method_of_ours_keeps_its_promise)
{
    for (int i = 0; i < PROBLEMS; i++)
        for (int f = 0; f < problems[i]->families; f++)
            for (int k = 0; k < problems[i]->methods; k++) {
                const method *m = &problems[i]->method[k];
                sample s;
                if (m->rank > RANK_SIGN)
                    continue;
                ck_assert_int_eq(measure(problems[i], k, 1, f, 200, 3, &s), 0);
                // _fast may answer either way at the rim, as its bound says.
                if ((m->rank != RANK_FAST && measure_wrong(&s) > 0) ||
                    (m->bound > 0 &&
                     measure_quantile(&s, m->bound_measure, 1) > m->bound))
                    ck_abort_msg(
                        "%s, %s: %d wrong, off by %a; see ulp %s %s 200 3",
                        m->name, problems[i]->family(f), measure_wrong(&s),
                        measure_quantile(&s, m->bound_measure, 1), m->name,
                        problems[i]->family(f));
                measure_free(&s);
            }
}
END_TEST

static void once(const inputs *in, answers *out)
{
    for (int i = 0; i < in->n; i++)
        out->x[0][i] = sqrt(in->rows[i * in->width]);
}

static void four_times(const inputs *in, answers *out)
{
    for (int k = 0; k < 4; k++)
        once(in, out);
}

// Not a test of the machine's speed: four times the work costs more than twice as
// much even where somebody disturbs.
START_TEST(more_work_costs_more)
{
    loop *const loops[] = {once, four_times};
    double ns[2];
    inputs *in = inputs_make(&problem_quadratic, 0, COST_INPUTS, 1);
    answers *out = answers_make(COST_INPUTS);
    ck_assert_int_eq(cost_compare(2, loops, in, out, 0.2, ns), 0);
    ck_assert_msg(ns[1] > 2 * ns[0], "%g ns and %g ns", ns[0], ns[1]);
    answers_free(out);
    inputs_free(in);
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "measure", 120, errors_are_those_of_the_oracle,
        ends_of_the_range_are_errors_like_any_other,
        what_is_wrong_is_called_by_its_name,
        a_quadratic_is_judged_by_its_count_first,
        the_gap_is_how_far_the_pair_is_from_the_surface,
        far_pairs_that_hardly_move_are_judged_by_how_they_move,
        a_sample_is_in_order_and_knows_its_worst, names_are_of_one_method_each,
        every_method_of_ours_keeps_its_promise, more_work_costs_more);
}
