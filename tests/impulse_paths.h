// SPDX-License-Identifier: MIT
#ifndef TESTS_IMPULSE_PATHS_H
#define TESTS_IMPULSE_PATHS_H
/** The impulses by the names that they have on each path. */
#include "paths.h"
#include <brink/impulse.h>

typedef int step(const double r[3], double m1, double m2, double rise,
                 enum brink_direction way, double v1[3], double v2[3],
                 double *virial);
typedef double core(const double r[3], double m1, double m2, double v1[3],
                    double v2[3]);
typedef int rim(const double r[3], double m1, double m2, double v1[3],
                double v2[3]);
typedef int step_balanced(const double r[3], double m1, double m2, double rise,
                          enum brink_direction way, double v1[3], double v2[3],
                          double *virial, double *owed);
typedef double core_balanced(const double r[3], double m1, double m2,
                             double v1[3], double v2[3], double *owed);
typedef int rim_balanced(const double r[3], double m1, double m2, double v1[3],
                         double v2[3], double *owed);
PATHS_OF(step, brink_step_impulse)
PATHS_OF(core, brink_core_impulse)
PATHS_OF(rim, brink_rim_impulse)
PATHS_OF(step_balanced, brink_step_impulse_balanced)
PATHS_OF(core_balanced, brink_core_impulse_balanced)
PATHS_OF(rim_balanced, brink_rim_impulse_balanced)

/** Of each impulse: v1, v2, what it answers, a step's virial, what is owed. */
enum { ALL_IMPULSES = 6, OF_IMPULSE = 9 };

/** All of them, each of the same pair: what they leave and answer. */
static inline void impulses(int path, const double r[3], double m1, double m2,
                            double rise, double y[ALL_IMPULSES][OF_IMPULSE])
{
    step *const at_step[] = PATHS(brink_step_impulse);
    core *const at_core[] = PATHS(brink_core_impulse);
    rim *const at_rim[] = PATHS(brink_rim_impulse);
    step_balanced *const at_step_balanced[] = PATHS(brink_step_impulse_balanced);
    core_balanced *const at_core_balanced[] = PATHS(brink_core_impulse_balanced);
    rim_balanced *const at_rim_balanced[] = PATHS(brink_rim_impulse_balanced);
    const enum brink_direction way = rise > 0 ? BRINK_INWARD : BRINK_OUTWARD;
    double *v1[ALL_IMPULSES], *v2[ALL_IMPULSES];
    for (int k = 0; k < ALL_IMPULSES; k++) {
        v1[k] = y[k];
        v2[k] = y[k] + 3;
    }
    y[0][6] = at_step[path](r, m1, m2, rise, way, v1[0], v2[0], &y[0][7]);
    y[1][6] = at_core[path](r, m1, m2, v1[1], v2[1]);
    y[2][6] = at_rim[path](r, m1, m2, v1[2], v2[2]);
    y[3][6] = at_step_balanced[path](r, m1, m2, rise, way, v1[3], v2[3], &y[3][7],
                                     &y[3][8]);
    y[4][6] = at_core_balanced[path](r, m1, m2, v1[4], v2[4], &y[4][8]);
    y[5][6] = at_rim_balanced[path](r, m1, m2, v1[5], v2[5], &y[5][8]);
}

/** The first of them to which a path gives other bits than path 0; -1: none. */
static inline int impulses_differ(int path, const double r[3], double m1,
                                  double m2, double rise, const double v1[3],
                                  const double v2[3])
{
    double y[2][ALL_IMPULSES][OF_IMPULSE] = {{{0}}};
    for (int n = 0; n < 2; n++) {
        for (int k = 0; k < ALL_IMPULSES; k++) {
            memcpy(y[n][k], v1, 3 * sizeof *v1);
            memcpy(y[n][k] + 3, v2, 3 * sizeof *v2);
            y[n][k][8] = 0x1p-52 * rise;
        }
        impulses(n * path, r, m1, m2, rise, y[n]);
    }
    for (int k = 0; k < ALL_IMPULSES; k++)
        for (int i = 0; i < OF_IMPULSE; i++)
            if (!same(y[0][k][i], y[1][k][i]))
                return k;
    return -1;
}
#endif
