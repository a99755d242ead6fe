// SPDX-License-Identifier: MIT
#include "exact.h"
#include "impulse.h"
#include "path.h"

#ifdef BRINK_DISPATCH
#define PARAMETERS                                                               \
    (const double r[3], double m1, double m2, double v1[3], double v2[3])
#define ARGUMENTS (r, m1, m2, v1, v2)

BRINK_CHOOSE(double, brink_core_impulse, PARAMETERS, ARGUMENTS)
BRINK_CHOOSE(int, brink_rim_impulse, PARAMETERS, ARGUMENTS)
BRINK_CHOOSE(double, brink_core_impulse_balanced,
             (const double r[3], double m1, double m2, double v1[3], double v2[3],
              double *owed),
             (r, m1, m2, v1, v2, owed))
BRINK_CHOOSE(int, brink_rim_impulse_balanced,
             (const double r[3], double m1, double m2, double v1[3], double v2[3],
              double *owed),
             (r, m1, m2, v1, v2, owed))
BRINK_CHOOSE(int, brink_step_impulse,
             (const double r[3], double m1, double m2, double rise,
              enum brink_direction way, double v1[3], double v2[3],
              double *virial),
             (r, m1, m2, rise, way, v1, v2, virial))
BRINK_CHOOSE(int, brink_step_impulse_balanced,
             (const double r[3], double m1, double m2, double rise,
              enum brink_direction way, double v1[3], double v2[3],
              double *virial, double *owed),
             (r, m1, m2, rise, way, v1, v2, virial, owed))
#endif
