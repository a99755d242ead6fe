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

/** The step, the core and the rim one after the other: what they answer and leave
 *  in the velocities. */
static inline void impulses(int path, const double r[3], double m1, double m2,
                            double rise, double y[15])
{
    step *const at_step[] = PATHS(brink_step_impulse);
    core *const at_core[] = PATHS(brink_core_impulse);
    rim *const at_rim[] = PATHS(brink_rim_impulse);
    double *v1 = y, *v2 = y + 3, v3[3], v4[3];
    memcpy(v3, v1, sizeof v3);
    memcpy(v4, v2, sizeof v4);
    const enum brink_direction way = rise > 0 ? BRINK_INWARD : BRINK_OUTWARD;
    y[6] = at_step[path](r, m1, m2, rise, way, v1, v2, &y[7]);
    y[8] = at_rim[path](r, m1, m2, v1, v2);
    y[9] = at_core[path](r, m1, m2, v3, v4);
    for (int k = 0; k < 3; k++)
        y[10 + k] = v3[k] - v4[k];
    y[13] = v3[0];
    y[14] = v4[0];
}

/** The same, with an account of energy. */
static inline void balanced_impulses(int path, const double r[3], double m1,
                                     double m2, double rise, double y[15])
{
    step_balanced *const at_step[] = PATHS(brink_step_impulse_balanced);
    core_balanced *const at_core[] = PATHS(brink_core_impulse_balanced);
    rim_balanced *const at_rim[] = PATHS(brink_rim_impulse_balanced);
    double *v1 = y, *v2 = y + 3, v3[3], v4[3];
    memcpy(v3, v1, sizeof v3);
    memcpy(v4, v2, sizeof v4);
    const enum brink_direction way = rise > 0 ? BRINK_INWARD : BRINK_OUTWARD;
    y[14] = 0x1p-52 * rise;
    y[6] = at_step[path](r, m1, m2, rise, way, v1, v2, &y[7], &y[14]);
    y[13] = y[14];
    y[8] = at_rim[path](r, m1, m2, v1, v2, &y[14]);
    y[9] = at_core[path](r, m1, m2, v3, v4, &y[13]);
    for (int k = 0; k < 3; k++)
        y[10 + k] = v3[k] - v4[k];
}
#endif
