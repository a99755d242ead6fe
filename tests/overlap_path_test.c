// SPDX-License-Identifier: MIT
// The overlap functions give the same bits on every path: see path_test.c.
#include "pairs.h"
#include "paths.h"
#include "suite.h"
#include <brink/overlap.h>

enum { CASES_A_FAMILY = 2000, SEED = 1, QUANTITIES = 10 };

typedef double of_ball(const double r[3], double sigma);
typedef double of_two(const double r[3], const double v[3]);
typedef double of_path(const double r[3], const double v[3], double sigma,
                       double t);
typedef int sign_of_path(const double r[3], const double v[3], double sigma,
                         double t);
typedef double of_rate(const double r[3], const double v[3], double t);
typedef int sign_of_rate(const double r[3], const double v[3], double t);
typedef double of_plane(const double r[3], const double n[3], const double c[3]);
typedef double of_plane_at(const double r[3], const double v[3],
                           const double n[3], const double c[3], double t);
typedef int sign_of_plane_at(const double r[3], const double v[3],
                             const double n[3], const double c[3], double t);

PATHS_OF(of_ball, brink_ball_overlap)
PATHS_OF(of_two, brink_ball_overlap_rate)
PATHS_OF(of_path, brink_ball_overlap_at)
PATHS_OF(sign_of_path, brink_ball_overlap_sign_at)
PATHS_OF(of_rate, brink_ball_overlap_rate_at)
PATHS_OF(sign_of_rate, brink_ball_overlap_rate_sign_at)
PATHS_OF(of_plane, brink_halfspace_overlap)
PATHS_OF(of_two, brink_halfspace_overlap_rate)
PATHS_OF(of_plane_at, brink_halfspace_overlap_at)
PATHS_OF(sign_of_plane_at, brink_halfspace_overlap_sign_at)

static of_ball *const ball[] = PATHS(brink_ball_overlap);
static of_two *const rate[] = PATHS(brink_ball_overlap_rate);
static of_path *const ball_at[] = PATHS(brink_ball_overlap_at);
static sign_of_path *const sign_at[] = PATHS(brink_ball_overlap_sign_at);
static of_rate *const rate_at[] = PATHS(brink_ball_overlap_rate_at);
static sign_of_rate *const rate_sign_at[] =
    PATHS(brink_ball_overlap_rate_sign_at);
static of_plane *const plane[] = PATHS(brink_halfspace_overlap);
static of_two *const plane_rate[] = PATHS(brink_halfspace_overlap_rate);
static of_plane_at *const plane_at[] = PATHS(brink_halfspace_overlap_at);
static sign_of_plane_at *const plane_sign_at[] =
    PATHS(brink_halfspace_overlap_sign_at);

/** All of them, of a pair p at time t, and of its first at a plane q. */
static void quantities(int path, const pair_case *p, const pair_case *q, double t,
                       double y[QUANTITIES])
{
    y[0] = ball[path](p->r, p->sigma);
    y[1] = rate[path](p->r, p->v);
    y[2] = ball_at[path](p->r, p->v, p->sigma, t);
    y[3] = sign_at[path](p->r, p->v, p->sigma, t);
    y[4] = rate_at[path](p->r, p->v, t);
    y[5] = rate_sign_at[path](p->r, p->v, t);
    y[6] = plane[path](p->r, q->v, q->r);
    y[7] = plane_rate[path](p->v, q->v);
    y[8] = plane_at[path](p->r, p->v, q->v, q->r, t);
    y[9] = plane_sign_at[path](p->r, p->v, q->v, q->r, t);
}

START_TEST(overlaps_are_the_same_on_every_path)
{
    const pair_family *family = &pair_families[_i];
    for (int path = 1; path < PATHS_IN_ALL && can_try(path); path++) {
        stream s = stream_of_seed(SEED);
        for (int i = 0; i < CASES_A_FAMILY; i++) {
            pair_case p, q;
            double y[2][QUANTITIES];
            family->make(&s, &p);
            family->make(&s, &q);
            const double t = stream_scaled(&s, -4, 4);
            quantities(0, &p, &q, t, y[0]);
            quantities(path, &p, &q, t, y[1]);
            for (int k = 0; k < QUANTITIES; k++)
                if (!same(y[0][k], y[1][k]))
                    ck_abort_msg(
                        "path %d, quantity %d, %s %d (seed %d): %a and %a\n"
                        "r %a %a %a  v %a %a %a  sigma %a  t %a\n"
                        "n %a %a %a  c %a %a %a",
                        path, k, family->name, i, SEED, y[0][k], y[1][k], p.r[0],
                        p.r[1], p.r[2], p.v[0], p.v[1], p.v[2], p.sigma, t,
                        q.v[0], q.v[1], q.v[2], q.r[0], q.r[1], q.r[2]);
        }
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("overlap_path");
    TCase *all = tcase_create("all");
    tcase_set_timeout(all, 600);
    tcase_add_loop_test(all, overlaps_are_the_same_on_every_path, 0,
                        PAIR_FAMILIES);
    suite_add_tcase(suite, all);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    const int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
