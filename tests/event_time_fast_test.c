// SPDX-License-Identifier: MIT
// What _fast promises, on every family: at the time answered the pair is within
// BRINK_EVENT_TIME_GAP eps (sigma + |v| t) of the surface, and what is answered
// the other way round is decided within that.
#include "cases.h"
#include "oracle.h"
#include "pairs.h"
#include "suite.h"
#include <brink/event_time.h>
#include <float.h>

enum { CASES_A_FAMILY = 3000, SEED = 1 };

typedef void time_oracle(mpfr_t t, const double r[3], const double v[3],
                         double sigma);

/** |r + v t|; exact up to the root where t is a double. */
static void distance_at(mpfr_t distance, const pair_case *p, const mpfr_t t)
{
    mpfr_t x;
    mpfr_init2(x, ORACLE_BITS);
    mpfr_set_zero(distance, 1);
    for (int i = 0; i < 3; i++) {
        mpfr_mul_d(x, t, p->v[i], ORACLE_N);
        mpfr_add_d(x, x, p->r[i], ORACLE_N);
        mpfr_sqr(x, x, ORACLE_N);
        mpfr_add(distance, distance, x, ORACLE_N);
    }
    mpfr_sqrt(distance, distance, ORACLE_N);
    mpfr_clear(x);
}

/** |distance| in eps (sigma + |v| t). */
static double in_eps(const pair_case *p, const mpfr_t distance, const mpfr_t t)
{
    mpfr_t size, way;
    mpfr_inits2(ORACLE_BITS, size, way, (mpfr_ptr)0);
    mpfr_set_zero(size, 1);
    for (int i = 0; i < 3; i++)
        oracle_add(size, 1, p->v[i], p->v[i]);
    mpfr_sqrt(size, size, ORACLE_N);
    mpfr_mul(way, size, t, ORACLE_N);
    mpfr_add_d(size, way, p->sigma, ORACLE_N);
    mpfr_mul_2si(size, size, -52, ORACLE_N);
    mpfr_div(size, distance, size, ORACLE_N);
    const double eps = fabs(mpfr_get_d(size, ORACLE_N));
    mpfr_clears(size, way, (mpfr_ptr)0);
    return mpfr_zero_p(distance) ? 0 : eps;
}

/** How far the pair is from the surface at time t. */
static double gap_at(const pair_case *p, const mpfr_t t)
{
    mpfr_t distance;
    mpfr_init2(distance, ORACLE_BITS);
    distance_at(distance, p, t);
    mpfr_sub_d(distance, distance, p->sigma, ORACLE_N);
    const double gap = in_eps(p, distance, t);
    mpfr_clear(distance);
    return gap;
}

/** How far it is at time t from where it is at the exact time; on the way until
 *  the later of them. */
static double gap_between(const pair_case *p, const mpfr_t t, const mpfr_t exact)
{
    mpfr_t one, two;
    mpfr_inits2(ORACLE_BITS, one, two, (mpfr_ptr)0);
    distance_at(one, p, t);
    distance_at(two, p, exact);
    mpfr_sub(one, one, two, ORACLE_N);
    const double gap = in_eps(p, one, mpfr_cmp(t, exact) > 0 ? t : exact);
    mpfr_clears(one, two, (mpfr_ptr)0);
    return gap;
}

/** The closest approach, -b / a. */
static void closest(mpfr_t t, const pair_case *p)
{
    oracle_path q;
    oracle_path_make(&q, p->r, p->v, p->sigma);
    mpfr_div(t, q.b, q.a, ORACLE_N);
    mpfr_neg(t, t, ORACLE_N);
    oracle_path_clear(&q);
}

/** Whether t is the exact time rounded at an end of the range, where no double
 *  need put the pair on the surface: to 8 ulp, as the plain ones. */
static int is_at_the_end(double t, const mpfr_t exact)
{
    const double nearest = mpfr_get_d(exact, ORACLE_N);
    return (nearest < DBL_MIN || isinf(nearest)) && !mpfr_inf_p(exact) &&
           oracle_ulps(t, exact) <= BRINK_EVENT_TIME_ULP;
}

/** Whether the pair is inside and at its closest approach, up to as many eps of
 *  sigma: it may be told to meet now or never. */
static int hardly_moves(const pair_case *p)
{
    oracle_path q;
    mpfr_t way;
    mpfr_init2(way, ORACLE_BITS);
    oracle_path_make(&q, p->r, p->v, p->sigma);
    mpfr_sqrt(way, q.a, ORACLE_N);
    mpfr_mul_d(way, way, BRINK_EVENT_TIME_GAP * 0x1p-52 * p->sigma, ORACLE_N);
    const int hardly = mpfr_sgn(q.c) <= 0 && mpfr_cmpabs(q.b, way) <= 0;
    mpfr_clear(way);
    oracle_path_clear(&q);
    return hardly;
}

static double gap_of_intersection(const pair_case *p, double answer,
                                  const mpfr_t exact)
{
    mpfr_t t;
    mpfr_init2(t, ORACLE_BITS);
    const int same = isinf(answer) && mpfr_inf_p(exact);
    const int now = answer == 0 && mpfr_zero_p(exact);
    const int either = (answer == 0 || isinf(answer)) && hardly_moves(p);
    double gap = 0;
    if (!same && !now && !either) {
        // At the ends of the range never may stand for late, and now for past.
        mpfr_set_d(t, fmin(answer, DBL_MAX), ORACLE_N);
        gap = gap_at(p, t);
        closest(t, p);
        if (answer < DBL_MIN || isinf(answer))
            gap = fmin(gap, gap_at(p, t));
    }
    mpfr_clear(t);
    return gap;
}

static double gap_of_disjoint(const pair_case *p, double answer,
                              const mpfr_t exact)
{
    mpfr_t t;
    mpfr_init2(t, ORACLE_BITS);
    mpfr_set_d(t, answer, ORACLE_N);
    double gap = isinf(answer) == mpfr_inf_p(exact) ? 0 : (double)INFINITY;
    if (!isinf(answer) && !mpfr_inf_p(exact))
        gap = gap_between(p, t, exact);
    mpfr_clear(t);
    return gap;
}

static const struct {
    const char *name;
    double (*kernel)(const double r[3], const double v[3], double sigma);
    time_oracle *oracle;
    double (*gap)(const pair_case *p, double answer, const mpfr_t exact);
} kernels[] = {
    {"intersection_time_fast", brink_intersection_time_fast, oracle_intersection,
     gap_of_intersection},
    {"disjoint_time_fast", brink_disjoint_time_fast, oracle_disjoint,
     gap_of_disjoint},
};

static void keep(const char *family, int i, const pair_case *p)
{
    mpfr_t exact;
    mpfr_init2(exact, ORACLE_BITS);
    for (size_t k = 0; k < sizeof kernels / sizeof *kernels; k++) {
        kernels[k].oracle(exact, p->r, p->v, p->sigma);
        const double t = kernels[k].kernel(p->r, p->v, p->sigma);
        if (is_at_the_end(t, exact))
            continue;
        const double gap = kernels[k].gap(p, t, exact);
        if (!(gap <= BRINK_EVENT_TIME_GAP))
            ck_abort_msg("%s, %s %d (seed %d):\n%a %a %a  %a %a %a  %a\n"
                         "got %a, exact %a: %g eps off",
                         kernels[k].name, family, i, SEED, p->r[0], p->r[1],
                         p->r[2], p->v[0], p->v[1], p->v[2], p->sigma, t,
                         mpfr_get_d(exact, ORACLE_N), gap);
    }
    mpfr_clear(exact);
}

START_TEST(fast_times_put_the_pair_on_the_surface)
{
    const pair_family *family = &pair_families[_i];
    stream s = stream_of_seed(SEED);
    pair_case p;
    for (int i = 0; i < (int)suite_share(CASES_A_FAMILY); i++) {
        family->make(&s, &p);
        keep(family->name, i, &p);
    }
}
END_TEST

START_TEST(fast_times_put_the_hard_cases_on_the_surface)
{
    FILE *in = cases_open("event_time");
    double x[7];
    for (int i = 0; cases_next(in, 7, x); i++) {
        const pair_case p = {{x[0], x[1], x[2]}, {x[3], x[4], x[5]}, x[6]};
        keep("event_time.wc", i, &p);
    }
    fclose(in);
}
END_TEST

/* The least of lengths at the greatest of speeds, and the other way round: times
 * are in units of 2^-2044 and 2^2044 then, where scaling itself would end. */
START_TEST(units_of_time_beyond_all_doubles_give_0_or_infinity)
{
    const double least = 0x1p-1074, most = DBL_MAX, never = (double)INFINITY;
    const double near[3] = {3 * least, 0, 0}, far[3] = {most, 0, 0};
    const double swift[3] = {-most, 0, 0}, slow[3] = {-least, 0, 0};
    ck_assert(brink_intersection_time_fast(near, swift, least) == 0);
    ck_assert(brink_disjoint_time_fast(near, swift, least) == 0);
    ck_assert(brink_intersection_time_fast(far, slow, 1) == never);
    ck_assert(brink_disjoint_time_fast(far, slow, 1) == never);
}
END_TEST

/* The square of a radius is infinite, or a squared length and it are in range as
 * a product, but not one by one. */
START_TEST(radii_of_another_size_than_their_pairs_are_answered)
{
    for (int way = -1; way <= 1; way += 2) {
        const pair_case in = {{1, 0.5, 0.25}, {way, 0.75, 0.5}, 0x1p600};
        const pair_case out = {{0x1p450, 0, 0}, {way * 0x1p100, 0, 0}, 0x1p-450};
        keep("within 2^600", 0, &in);
        keep("without 2^-450", 0, &out);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("event_time_fast");
    TCase *all = tcase_create("all");
    tcase_set_timeout(all, 600);
    tcase_add_loop_test(all, fast_times_put_the_pair_on_the_surface, 0,
                        PAIR_FAMILIES);
    tcase_add_test(all, fast_times_put_the_hard_cases_on_the_surface);
    tcase_add_test(all, units_of_time_beyond_all_doubles_give_0_or_infinity);
    tcase_add_test(all, radii_of_another_size_than_their_pairs_are_answered);
    suite_add_tcase(suite, all);
    return run_whole_suite(suite);
}
