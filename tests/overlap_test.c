// SPDX-License-Identifier: MIT
#include "cases.h"
#include "oracle_overlap.h"
#include "pairs.h"
#include "suite.h"
#include <brink/overlap.h>

enum { CASES_A_FAMILY = 2000, SEED = 1 };

/** A pair, a plane to go with it, and a time. */
typedef struct scene {
    pair_case p, plane; // the plane's normal is plane.v, a point of it plane.r
    double t;
} scene;

/** One quantity both ways: the value, its sign, and what is right. */
typedef struct quantity {
    const char *name;
    double (*value)(const scene *);
    int (*sign)(const scene *);
    void (*exact)(mpfr_t f, const scene *);
} quantity;

static const double zero[3] = {0, 0, 0};

#define QUANTITY(name, value_call, sign_call, exact_call)                        \
    static double name##_value(const scene *s)                                   \
    {                                                                            \
        return value_call;                                                       \
    }                                                                            \
    static int name##_sign(const scene *s)                                       \
    {                                                                            \
        return sign_call;                                                        \
    }                                                                            \
    static void name##_exact(mpfr_t f, const scene *s)                           \
    {                                                                            \
        exact_call;                                                              \
    }

#define R     s->p.r
#define V     s->p.v
#define SIGMA s->p.sigma
#define N     s->plane.v
#define C     s->plane.r
#define T     s->t

QUANTITY(ball, brink_ball_overlap(R, SIGMA), brink_ball_overlap_sign(R, SIGMA),
         oracle_ball(f, R, V, SIGMA, 0))
QUANTITY(ball_rate, brink_ball_overlap_rate(R, V),
         brink_ball_overlap_rate_sign(R, V), oracle_plane(f, R, zero, V, zero, 0))
QUANTITY(ball_at, brink_ball_overlap_at(R, V, SIGMA, T),
         brink_ball_overlap_sign_at(R, V, SIGMA, T),
         oracle_ball(f, R, V, SIGMA, T))
QUANTITY(ball_rate_at, brink_ball_overlap_rate_at(R, V, T),
         brink_ball_overlap_rate_sign_at(R, V, T),
         oracle_plane(f, R, V, V, zero, T))
QUANTITY(halfspace, brink_halfspace_overlap(R, N, C),
         brink_halfspace_overlap_sign(R, N, C), oracle_plane(f, R, zero, N, C, 0))
QUANTITY(halfspace_rate, brink_halfspace_overlap_rate(V, N),
         brink_halfspace_overlap_rate_sign(V, N),
         oracle_plane(f, V, zero, N, zero, 0))
QUANTITY(halfspace_at, brink_halfspace_overlap_at(R, V, N, C, T),
         brink_halfspace_overlap_sign_at(R, V, N, C, T),
         oracle_plane(f, R, V, N, C, T))

#define QUANTITY_OF(name)                                                        \
    {                                                                            \
#name, name##_value, name##_sign, name##_exact                           \
    }

static const quantity quantities[] = {
    QUANTITY_OF(ball),         QUANTITY_OF(ball_rate),
    QUANTITY_OF(ball_at),      QUANTITY_OF(ball_rate_at),
    QUANTITY_OF(halfspace),    QUANTITY_OF(halfspace_rate),
    QUANTITY_OF(halfspace_at),
};
enum { QUANTITIES = sizeof quantities / sizeof *quantities };

static void keep(const char *family, int i, const scene *s)
{
    mpfr_t exact;
    mpfr_init2(exact, ORACLE_BITS);
    for (int k = 0; k < QUANTITIES; k++) {
        const quantity *q = &quantities[k];
        q->exact(exact, s);
        double value = q->value(s);
        int sign = q->sign(s),
            right = (mpfr_sgn(exact) > 0) - (mpfr_sgn(exact) < 0);
        if (sign != right || oracle_ulps(value, exact) > BRINK_OVERLAP_ULP)
            ck_abort_msg(
                "%s, %s %d (seed %d):\nr %a %a %a  v %a %a %a  sigma %a  t %a\n"
                "n %a %a %a  c %a %a %a\ngot %a and %d, exact %a and %d",
                q->name, family, i, SEED, R[0], R[1], R[2], V[0], V[1], V[2],
                SIGMA, T, N[0], N[1], N[2], C[0], C[1], C[2], value, sign,
                mpfr_get_d(exact, ORACLE_N), right);
    }
    mpfr_clear(exact);
}

/** A time at which something may be the matter: near the event, or any. */
static double time_of(stream *random, const pair_case *p)
{
    oracle_path q;
    double t;
    oracle_path_make(&q, p->r, p->v, p->sigma);
    if (mpfr_sgn(q.d) >= 0) // a root; where there is none, the closest approach
        mpfr_sqrt(q.d, q.d, ORACLE_N);
    else
        mpfr_set_zero(q.d, 1);
    mpfr_add(q.b, q.b, q.d, ORACLE_N);
    mpfr_div(q.b, q.b, q.a, ORACLE_N);
    t = -mpfr_get_d(q.b, ORACLE_N);
    oracle_path_clear(&q);
    if (!isfinite(t) || stream_int(random, 0, 3) == 0)
        return stream_scaled(random, -1080, 1024);
    return stream_near(random, t, 1);
}

/** Lays the plane through the particle, as nearly as rounding lets it. */
static void lay_plane(stream *random, scene *s)
{
    const double *n = s->plane.v, length = stream_scaled(random, -10, 10);
    double w[3];
    fill_normal(random, w, length * length_of(s->p.r) / length_of(n));
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const double c = s->p.r[i] + (n[j] * w[k] - n[k] * w[j]);
        s->plane.r[i] = isfinite(c) ? c : 0;
    }
}

START_TEST(signs_are_exact_and_values_within_the_bound)
{
    for (int f = 0; f < PAIR_FAMILIES; f++) {
        stream random = stream_of_seed(SEED);
        scene s;
        for (int i = 0; i < (int)suite_share(CASES_A_FAMILY); i++) {
            pair_families[f].make(&random, &s.p);
            pair_families[f].make(&random, &s.plane);
            if (stream_int(&random, 0, 1))
                lay_plane(&random, &s);
            s.t = time_of(&random, &s.p);
            keep(pair_families[f].name, i, &s);
        }
    }
}
END_TEST

START_TEST(hard_cases_are_right)
{
    FILE *in = cases_open("overlap");
    double x[14];
    for (int i = 0; cases_next(in, 14, x); i++) {
        scene s;
        memcpy(&s.p, x, sizeof s.p);
        memcpy(s.plane.v, x + 7, sizeof s.plane.v);
        memcpy(s.plane.r, x + 10, sizeof s.plane.r);
        s.t = x[13];
        keep("overlap.wc", i, &s);
    }
    fclose(in);
}
END_TEST

START_TEST(what_is_not_finite_has_no_value_and_no_sign)
{
    // Which inputs a quantity has, in the order of `quantities`.
    enum { OF_R = 1, OF_V = 2, OF_SIGMA = 4, OF_N = 8, OF_C = 16, OF_T = 32 };
    static const int inputs[QUANTITIES] = {
        OF_R | OF_SIGMA,
        OF_R | OF_V,
        OF_R | OF_V | OF_SIGMA | OF_T,
        OF_R | OF_V | OF_T,
        OF_R | OF_N | OF_C,
        OF_V | OF_N,
        OF_R | OF_V | OF_N | OF_C | OF_T,
    };
    const double bad[] = {(double)INFINITY, -(double)INFINITY, (double)NAN};
    for (int place = 0; place < 14; place++)
        for (int k = 0; k < 3 * QUANTITIES; k++) {
            scene s = {{{3, 1, 2}, {1, 0, 2}, 1}, {{0, 0, 1}, {1, 2, 0}, 0}, 0.5};
            const quantity *its = &quantities[k / 3];
            const struct {
                double *x;
                int input;
            } at[] = {{s.p.r, OF_R},          {s.p.v, OF_V},
                      {s.plane.v, OF_N},      {s.plane.r, OF_C},
                      {&s.p.sigma, OF_SIGMA}, {&s.t, OF_T}};
            const int which = place < 12 ? place / 3 : place - 8;
            at[which].x[place < 12 ? place % 3 : 0] = bad[k % 3];
            const int refused = (inputs[k / 3] & at[which].input) != 0;
            ck_assert_msg((isnan(its->value(&s)) != 0) == refused &&
                              (its->sign(&s) == 0) == refused,
                          "%s with %g for its input %d", its->name, bad[k % 3],
                          place);
        }
}
END_TEST

START_TEST(perpendicular_is_neither_coming_nor_going)
{
    stream random = stream_of_seed(SEED);
    for (int i = 0; i < (int)suite_share(10000); i++) {
        // (a, b, a b).(b, -a, 0) = 0
        double a = stream_int(&random, -30000, 30000),
               b = stream_int(&random, -30000, 30000);
        const double r[3] = {a, b, a * b}, v[3] = {b, -a, 0};
        ck_assert_int_eq(brink_ball_overlap_rate_sign(r, v), 0);
        ck_assert_double_eq(brink_ball_overlap_rate(r, v), 0);
    }
}
END_TEST

START_TEST(touching_is_zero)
{
    const double r[3] = {3, 4, 12};
    for (int e = -1070; e < 1020; e++) {
        const double s[3] = {ldexp(r[0], e), ldexp(r[1], e), ldexp(r[2], e)};
        ck_assert_int_eq(brink_ball_overlap_sign(s, ldexp(13, e)), 0);
        double outside = nextafter(ldexp(13, e), 0);
        ck_assert_int_eq(brink_ball_overlap_sign(s, outside), 1);
        double inside = nextafter(ldexp(13, e), (double)INFINITY);
        ck_assert_int_eq(brink_ball_overlap_sign(s, inside), -1);
    }
}
END_TEST

/** Three whole numbers up to +-most, and times 2^e; what is left of n. */
static int whole_vector(int n, int most, int e, int x[3], double y[3])
{
    for (int i = 0; i < 3; i++, n /= 2 * most + 1) {
        x[i] = n % (2 * most + 1) - most;
        y[i] = ldexp(x[i], e);
    }
    return n;
}

/** Whether f has that sign and, where it is not scaled, that value. */
static int is_whole(int f, int sign, int e, double value)
{
    const double ulp = nextafter(abs(f), (double)INFINITY) - abs(f);
    return sign == (f > 0) - (f < 0) &&
           (e != 0 || fabs(value - f) <= (f == 0 ? 0 : BRINK_OVERLAP_ULP * ulp));
}

// Products underflow to nothing at 2^-1074, lose their last bits at 2^-538, and
// overflow at 2^1000.
static const int scales[] = {0, -1074, -538, 1000};

START_TEST(all_small_whole_balls_are_right)
{
    const int e = scales[_i];
    for (int n = 0; n < 125 * 27 * 5 * 5; n++) {
        int r[3], v[3], f = 0, rate = 0, rate_at = 0;
        double x[3], y[3];
        int rest = whole_vector(n, 2, e, r, x);
        rest = whole_vector(rest, 1, e, v, y);
        const int sigma = rest % 5, t = rest / 5 - 2;
        for (int k = 0; k < 3; k++) {
            f += (r[k] + v[k] * t) * (r[k] + v[k] * t);
            rate += r[k] * v[k];
            rate_at += (r[k] + v[k] * t) * v[k];
        }
        f -= sigma * sigma;
        const double s = ldexp(sigma, e);
        int good = is_whole(f, brink_ball_overlap_sign_at(x, y, s, t), e,
                            brink_ball_overlap_at(x, y, s, t));
        good = good && is_whole(rate, brink_ball_overlap_rate_sign(x, y), e,
                                brink_ball_overlap_rate(x, y));
        good = good && is_whole(rate_at, brink_ball_overlap_rate_sign_at(x, y, t),
                                e, brink_ball_overlap_rate_at(x, y, t));
        if (t == 0)
            good = good && is_whole(f, brink_ball_overlap_sign(x, s), e,
                                    brink_ball_overlap(x, s));
        if (!good)
            ck_abort_msg("2^%d: r %d %d %d  v %d %d %d  sigma %d  t %d", e, r[0],
                         r[1], r[2], v[0], v[1], v[2], sigma, t);
    }
}
END_TEST

START_TEST(all_small_whole_half_spaces_are_right)
{
    const int e = scales[_i];
    for (int m = 0; m < 27 * 27 * 27 * 27; m++) {
        int r[3], v[3], n[3], c[3], f = 0, rate = 0, at = 0;
        double x[3], y[3], normal[3], place[3];
        int rest = whole_vector(m, 1, e, r, x);
        rest = whole_vector(rest, 1, e, v, y);
        rest = whole_vector(rest, 1, 0, n, normal);
        whole_vector(rest, 1, e, c, place);
        for (int k = 0; k < 3; k++) {
            f += n[k] * (r[k] - c[k]);
            rate += n[k] * v[k];
            at += n[k] * (r[k] + 2 * v[k] - c[k]);
        }
        int good = is_whole(f, brink_halfspace_overlap_sign(x, normal, place), e,
                            brink_halfspace_overlap(x, normal, place));
        good =
            good && is_whole(rate, brink_halfspace_overlap_rate_sign(y, normal),
                             e, brink_halfspace_overlap_rate(y, normal));
        good =
            good &&
            is_whole(at, brink_halfspace_overlap_sign_at(x, y, normal, place, 2),
                     e, brink_halfspace_overlap_at(x, y, normal, place, 2));
        if (!good)
            ck_abort_msg("2^%d: r %d %d %d  v %d %d %d  n %d %d %d  c %d %d %d",
                         e, r[0], r[1], r[2], v[0], v[1], v[2], n[0], n[1], n[2],
                         c[0], c[1], c[2]);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("overlap");
    TCase *all = tcase_create("all");
    const int count = sizeof scales / sizeof *scales;
    tcase_set_timeout(all, 600);
    tcase_add_test(all, signs_are_exact_and_values_within_the_bound);
    tcase_add_test(all, hard_cases_are_right);
    tcase_add_test(all, what_is_not_finite_has_no_value_and_no_sign);
    tcase_add_test(all, perpendicular_is_neither_coming_nor_going);
    tcase_add_test(all, touching_is_zero);
    tcase_add_loop_test(all, all_small_whole_balls_are_right, 0, count);
    tcase_add_loop_test(all, all_small_whole_half_spaces_are_right, 0, count);
    suite_add_tcase(suite, all);
    return run_whole_suite(suite);
}
