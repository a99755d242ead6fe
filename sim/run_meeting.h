// SPDX-License-Identifier: MIT
#ifndef BRINK_RUN_MEETING_H
#define BRINK_RUN_MEETING_H
/**
 * What two particles at a step do there: the kernels' word on who crosses it, and
 * which event that makes.
 */
#include <brink/impulse.h>
#include <math.h>

typedef struct brink_meeting {
    enum brink_event_kind kind;
    double virial; // r.dp
    int rim;       // 1: turned inward, see brink_rim_impulse
} brink_meeting;

/** Of a pair r apart at a step that it meets in direction `way`, `rise` across it
 * (not NaN).  Velocities and the account of energy are those after. */
static inline brink_meeting brink_meeting_at(const double r[3], double m1,
                                             double m2, double rise,
                                             enum brink_direction way,
                                             double v1[3], double v2[3],
                                             double *owed)
{
    brink_meeting met = {.kind = BRINK_BOUNCE};
    if (isinf(rise)) {
        met.kind = BRINK_CORE;
        met.virial = brink_core_impulse_balanced(r, m1, m2, v1, v2, owed);
    } else if (brink_step_impulse_balanced(r, m1, m2, rise, way, v1, v2,
                                           &met.virial, owed)) {
        met.kind = way == BRINK_INWARD ? BRINK_CAPTURE : BRINK_RELEASE;
    } else if (way == BRINK_OUTWARD) {
        met.rim = brink_rim_impulse_balanced(r, m1, m2, v1, v2, owed);
    }
    return met;
}
#endif
