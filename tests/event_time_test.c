// SPDX-License-Identifier: MIT
#include "cases.h"
#include "oracle.h"
#include "pairs.h"
#include "suite.h"
#include <brink/event_time.h>
#include <check.h>

enum { CASES_A_FAMILY = 3000, SEED = 1 };

typedef double time_kernel(const double r[3], const double v[3], double sigma);
typedef void time_oracle(mpfr_t t, const double r[3], const double v[3],
                         double sigma);

/** A kernel, what it must agree with, and to how many ulp. */
typedef struct promise {
    const char *name;
    time_kernel *kernel;
    time_oracle *oracle;
    double ulp;
} promise;

static const promise promises[] = {
    {"intersection", brink_intersection_time, oracle_intersection,
     BRINK_EVENT_TIME_ULP},
    {"intersection_cr", brink_intersection_time_cr, oracle_intersection, 0.5},
    {"disjoint", brink_disjoint_time, oracle_disjoint, BRINK_EVENT_TIME_ULP},
    {"disjoint_cr", brink_disjoint_time_cr, oracle_disjoint, 0.5},
};

static void report(const char *name, const char *family, int i,
                   const pair_case *p, double got, const mpfr_t exact)
{
    ck_abort_msg("%s, %s %d (seed %d):\n%a %a %a  %a %a %a  %a\ngot %a, exact %a",
                 name, family, i, SEED, p->r[0], p->r[1], p->r[2], p->v[0],
                 p->v[1], p->v[2], p->sigma, got, mpfr_get_d(exact, ORACLE_N));
}

/** Event or none, now or later: exact.  The time within the bound, and for 0.5
 *  the nearest double, a tie to even. */
static void keep(const promise *its, const char *family, int i,
                 const pair_case *p)
{
    mpfr_t exact;
    mpfr_init2(exact, ORACLE_BITS);
    its->oracle(exact, p->r, p->v, p->sigma);
    double nearest = mpfr_get_d(exact, ORACLE_N);
    double got = its->kernel(p->r, p->v, p->sigma);
    int good = !signbit(got) && isinf(got) >= mpfr_inf_p(exact);
    good = good && (got == 0) >= mpfr_zero_p(exact);
    good = good && (got != 0 || nearest < 0x1p-1070) &&
           oracle_ulps(got, exact) <= its->ulp;
    if (its->ulp == 0.5)
        good = good && got == nearest;
    if (!good)
        report(its->name, family, i, p, got, exact);
    mpfr_clear(exact);
}

START_TEST(every_promise_is_kept_on_every_family)
{
    const pair_family *family = &pair_families[_i];
    stream s = stream_of_seed(SEED);
    pair_case p;
    for (int i = 0; i < (int)suite_share(CASES_A_FAMILY); i++) {
        family->make(&s, &p);
        for (size_t k = 0; k < sizeof promises / sizeof *promises; k++)
            keep(&promises[k], family->name, i, &p);
    }
}
END_TEST

START_TEST(every_promise_is_kept_on_the_hard_cases)
{
    FILE *in = cases_open("event_time");
    double x[7];
    for (int i = 0; cases_next(in, 7, x); i++) {
        pair_case p = {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, x[6]};
        for (size_t k = 0; k < sizeof promises / sizeof *promises; k++)
            keep(&promises[k], "event_time.wc", i, &p);
    }
    fclose(in);
}
END_TEST

static time_kernel *const all_kernels[] = {
    brink_intersection_time,      brink_disjoint_time,
    brink_intersection_time_fast, brink_disjoint_time_fast,
    brink_intersection_time_cr,   brink_disjoint_time_cr,
};
enum { KERNELS = sizeof all_kernels / sizeof *all_kernels };

START_TEST(nothing_that_is_not_a_number_is_answered)
{
    const double bad[] = {(double)INFINITY, -(double)INFINITY, (double)NAN};
    for (int place = 0; place < 7; place++)
        for (int k = 0; k < 3; k++)
            for (int receding = -1; receding <= 1; receding++) {
                pair_case p = {
                    {2, 0.5, 0.25}, {receding, receding * 0.125, 0}, 1};
                *(place < 3   ? &p.r[place]
                  : place < 6 ? &p.v[place - 3]
                              : &p.sigma) = bad[k];
                ck_assert(isnan(all_kernels[_i](p.r, p.v, p.sigma)));
            }
    const double r[3] = {2, 0, 0}, in[3] = {-1, 0, 0}, out[3] = {1, 0, 0};
    const double inside[3] = {0.5, 0, 0};
    const double negative[] = {-0x1p-1074, -1, -1.9, -3, -0x1p+600};
    for (int k = 0; k < 5; k++) {
        ck_assert(isnan(all_kernels[_i](r, in, negative[k])));
        ck_assert(isnan(all_kernels[_i](r, out, negative[k])));
        ck_assert(isnan(all_kernels[_i](inside, out, negative[k])));
    }
}
END_TEST

START_TEST(never_negative_and_never_not_a_number)
{
    stream s = stream_of_seed(SEED);
    pair_case p;
    for (int family = 0; family < PAIR_FAMILIES; family++)
        for (int i = 0; i < (int)suite_share(CASES_A_FAMILY); i++) {
            pair_families[family].make(&s, &p);
            double t = all_kernels[_i](p.r, p.v, p.sigma);
            if (!(t >= 0) || signbit(t))
                ck_abort_msg("%s %d: %a %a %a  %a %a %a  %a: %a",
                             pair_families[family].name, i, p.r[0], p.r[1],
                             p.r[2], p.v[0], p.v[1], p.v[2], p.sigma, t);
        }
}
END_TEST

START_TEST(touching_and_parting_is_no_event)
{
    const double r[3] = {0.6, 0.8, 0}, v[3] = {1, 0, 0};
    ck_assert_double_eq(brink_intersection_time(r, v, 0.5), (double)INFINITY);
    const double at[3] = {3, 4, 0}, away[3] = {4, -2.5, 0};
    ck_assert_double_eq(brink_intersection_time(at, away, 5), (double)INFINITY);
}
END_TEST

START_TEST(touching_and_approaching_is_now)
{
    const double at[3] = {3, 4, 0}, v[3] = {-4, 2, 0};
    ck_assert_double_eq(brink_intersection_time(at, v, 5), 0);
}
END_TEST

START_TEST(touching_along_the_tangent_is_no_event)
{
    const double at[3] = {3, 4, 0}, v[3] = {-4, 3, 0};
    ck_assert_double_eq(brink_intersection_time(at, v, 5), (double)INFINITY);
    ck_assert_double_eq(brink_disjoint_time(at, v, 5), 0);
}
END_TEST

START_TEST(overlapping_and_receding_is_no_event)
{
    const double r[3] = {0.5, 0, 0}, v[3] = {0.25, 5, 0};
    ck_assert_double_eq(brink_intersection_time(r, v, 1), (double)INFINITY);
}
END_TEST

START_TEST(the_printed_algorithm_2_would_say_now)
{
    // a = 1, b = -1, c = 0: -c / (sqrt(b^2 - a c) + b) = -0 / 0, and the answer
    // is 2.
    const double r[3] = {1, 0, 0}, v[3] = {-1, 0, 0};
    ck_assert_double_eq(brink_disjoint_time(r, v, 1), 2);
}
END_TEST

START_TEST(a_path_that_misses_is_disjoint_from_its_closest_approach)
{
    const double r[3] = {-4, 3, 0}, v[3] = {2, 0, 0};
    ck_assert_double_eq(brink_disjoint_time(r, v, 1), 2);
    ck_assert_double_eq(brink_disjoint_time(r, v, 3), 2);
}
END_TEST

START_TEST(pairs_at_relative_rest_never_meet_nor_part)
{
    const double r[3] = {0.5, 0, 0}, v[3] = {0, -0.0, 0};
    ck_assert_double_eq(brink_intersection_time(r, v, 1), (double)INFINITY);
    ck_assert_double_eq(brink_disjoint_time(r, v, 1), (double)INFINITY);
    ck_assert_double_eq(brink_disjoint_time(r, v, 0.25), (double)INFINITY);
}
END_TEST

START_TEST(a_tie_between_two_doubles_goes_to_the_even_one)
{
    // (1 + k 2^-52) - 2^-53 = 1 + (2k - 1) 2^-53, halfway between k - 1 and k.
    for (int k = 1; k < 100; k++) {
        const double r[3] = {0, 1 + k * 0x1p-52, 0}, v[3] = {0, -1, 0};
        int even = k % 2 == 0 ? k : k - 1;
        ck_assert_double_eq(brink_intersection_time_cr(r, v, 0x1p-53),
                            1 + even * 0x1p-52);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("event_time");
    TCase *accuracy = tcase_create("accuracy");
    tcase_set_timeout(accuracy, 600);
    tcase_add_loop_test(accuracy, every_promise_is_kept_on_every_family, 0,
                        PAIR_FAMILIES);
    tcase_add_test(accuracy, every_promise_is_kept_on_the_hard_cases);
    tcase_add_loop_test(accuracy, never_negative_and_never_not_a_number, 0,
                        KERNELS);
    suite_add_tcase(suite, accuracy);

    TCase *meaning = tcase_create("meaning");
    tcase_add_loop_test(meaning, nothing_that_is_not_a_number_is_answered, 0,
                        KERNELS);
    tcase_add_test(meaning, touching_and_parting_is_no_event);
    tcase_add_test(meaning, touching_and_approaching_is_now);
    tcase_add_test(meaning, touching_along_the_tangent_is_no_event);
    tcase_add_test(meaning, overlapping_and_receding_is_no_event);
    tcase_add_test(meaning, the_printed_algorithm_2_would_say_now);
    tcase_add_test(meaning,
                   a_path_that_misses_is_disjoint_from_its_closest_approach);
    tcase_add_test(meaning, pairs_at_relative_rest_never_meet_nor_part);
    tcase_add_test(meaning, a_tie_between_two_doubles_goes_to_the_even_one);
    suite_add_tcase(suite, meaning);

    return run_whole_suite(suite);
}
