// SPDX-License-Identifier: MIT
// Every path gives the same bits: each is called by name, where the library has
// it and the processor can, and compared with the path that has neither vectors
// nor fma() in hardware.  A compiler that contracted a * b + c would show, too.
#include "impulse_paths.h"
#include "pairs.h"
#include "quadratics.h"
#include "suite.h"
#include <brink/event_time.h>
#include <brink/quadratic.h>

enum { CASES_A_FAMILY = 2000, SEED = 1 };

typedef int roots(double a, double b, double c, double *x0, double *x1);
typedef double pair_time(const double r[3], const double v[3], double sigma);
typedef double wall_time(const double r[3], const double v[3], const double n[3],
                         const double c[3]);
typedef void times(size_t n, const double *rx, const double *ry, const double *rz,
                   const double *vx, const double *vy, const double *vz,
                   const double *sigma, double *t);

PATHS_OF(roots, brink_quadratic_roots)
PATHS_OF(roots, brink_quadratic_roots_cr)
PATHS_OF(pair_time, brink_intersection_time)
PATHS_OF(pair_time, brink_intersection_time_fast)
PATHS_OF(pair_time, brink_intersection_time_cr)
PATHS_OF(pair_time, brink_intersection_time_slow)
PATHS_OF(pair_time, brink_disjoint_time)
PATHS_OF(pair_time, brink_disjoint_time_fast)
PATHS_OF(pair_time, brink_disjoint_time_cr)
PATHS_OF(pair_time, brink_disjoint_time_slow)
PATHS_OF(wall_time, brink_halfspace_time)
PATHS_OF(times, brink_intersection_times)
PATHS_OF(times, brink_intersection_times_fast)
PATHS_OF(times, brink_disjoint_times)
PATHS_OF(times, brink_disjoint_times_fast)

START_TEST(roots_are_the_same_on_every_path)
{
    roots *const kernels[2][3] = {PATHS(brink_quadratic_roots),
                                  PATHS(brink_quadratic_roots_cr)};
    for (int path = 1; path < PATHS_IN_ALL && can_try(path); path++)
        for (int f = 0; f < QUADRATIC_FAMILIES; f++) {
            stream s = stream_of_seed(SEED);
            quadratic_case q;
            for (int i = 0; i < CASES_A_FAMILY; i++) {
                quadratic_families[f].make(&s, &q);
                for (int k = 0; k < 2; k++) {
                    double x[2] = {0, 0}, y[2] = {0, 0};
                    int m = kernels[k][0](q.a, q.b, q.c, &x[0], &x[1]);
                    int n = kernels[k][path](q.a, q.b, q.c, &y[0], &y[1]);
                    if (m != n || !same(x[0], y[0]) || !same(x[1], y[1]))
                        ck_abort_msg("path %d, tier %d, %s %d: %a %a %a", path, k,
                                     quadratic_families[f].name, i, q.a, q.b,
                                     q.c);
                }
            }
        }
}
END_TEST

START_TEST(times_are_the_same_on_every_path)
{
    pair_time *const kernels[][3] = {
        PATHS(brink_intersection_time),    PATHS(brink_intersection_time_fast),
        PATHS(brink_intersection_time_cr), PATHS(brink_intersection_time_slow),
        PATHS(brink_disjoint_time),        PATHS(brink_disjoint_time_fast),
        PATHS(brink_disjoint_time_cr),     PATHS(brink_disjoint_time_slow),
    };
    wall_time *const wall[3] = PATHS(brink_halfspace_time);
    for (int path = 1; path < PATHS_IN_ALL && can_try(path); path++)
        for (int f = 0; f < PAIR_FAMILIES; f++) {
            stream s = stream_of_seed(SEED);
            pair_case p, q;
            for (int i = 0; i < CASES_A_FAMILY; i++) {
                pair_families[f].make(&s, &p);
                pair_families[f].make(&s, &q);
                int good = same(wall[0](p.r, p.v, q.v, q.r),
                                wall[path](p.r, p.v, q.v, q.r));
                for (size_t k = 0; k < sizeof kernels / sizeof *kernels; k++)
                    good = good && same(kernels[k][0](p.r, p.v, p.sigma),
                                        kernels[k][path](p.r, p.v, p.sigma));
                if (!good)
                    ck_abort_msg("path %d, %s %d: %a %a %a  %a %a %a  %a", path,
                                 pair_families[f].name, i, p.r[0], p.r[1], p.r[2],
                                 p.v[0], p.v[1], p.v[2], p.sigma);
            }
        }
}
END_TEST

START_TEST(batches_are_the_same_on_every_path)
{
    static double x[7][CASES_A_FAMILY], t[2][CASES_A_FAMILY];
    times *const kernels[][3] = {
        PATHS(brink_intersection_times), PATHS(brink_intersection_times_fast),
        PATHS(brink_disjoint_times), PATHS(brink_disjoint_times_fast)};
    for (int path = 1; path < PATHS_IN_ALL && can_try(path); path++)
        for (int f = 0; f < PAIR_FAMILIES; f++) {
            stream s = stream_of_seed(SEED);
            for (int i = 0; i < CASES_A_FAMILY; i++) {
                pair_case p;
                pair_families[f].make(&s, &p);
                for (int k = 0; k < 3; k++) {
                    x[k][i] = p.r[k];
                    x[3 + k][i] = p.v[k];
                }
                x[6][i] = p.sigma;
            }
            for (size_t k = 0; k < sizeof kernels / sizeof *kernels; k++) {
                kernels[k][0](CASES_A_FAMILY, x[0], x[1], x[2], x[3], x[4], x[5],
                              x[6], t[0]);
                kernels[k][path](CASES_A_FAMILY, x[0], x[1], x[2], x[3], x[4],
                                 x[5], x[6], t[1]);
                for (int i = 0; i < CASES_A_FAMILY; i++)
                    if (!same(t[0][i], t[1][i]))
                        ck_abort_msg(
                            "path %d, tier %zu, %s %d: %a %a %a  %a %a %a  %a",
                            path, k, pair_families[f].name, i, x[0][i], x[1][i],
                            x[2][i], x[3][i], x[4][i], x[5][i], x[6][i]);
            }
        }
}
END_TEST

START_TEST(impulses_are_the_same_on_every_path)
{
    static void (*const make[])(stream *, pair_case *) = {
        family_contact, family_rim, family_grazing, family_axial};
    for (int path = 1; path < PATHS_IN_ALL && can_try(path); path++) {
        stream s = stream_of_seed(SEED);
        for (int i = 0; i < CASES_A_FAMILY; i++) {
            pair_case p;
            make[i % 4](&s, &p);
            const double m1 = stream_real(&s, 1, 2);
            const double m2 = fabs(stream_scaled(&s, -30, 30));
            const double rise = stream_real(&s, -1, 1);
            const double rest[3] = {0, 0, 0};
            const int k = impulses_differ(path, p.r, m1, m2, rise, p.v, rest);
            if (k >= 0)
                ck_abort_msg("path %d, case %d, impulse %d: %a %a %a  %a %a  %a "
                             "%a %a  rise %a",
                             path, i, k, p.r[0], p.r[1], p.r[2], m1, m2, p.v[0],
                             p.v[1], p.v[2], rise);
        }
    }
}
END_TEST

int main(void)
{
    return RUN_SUITE("path", 600, roots_are_the_same_on_every_path,
                     times_are_the_same_on_every_path,
                     batches_are_the_same_on_every_path,
                     impulses_are_the_same_on_every_path);
}
