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
    int rim;       // 1: turned inward, see brink_rim_impulse; or outward, below
} brink_meeting;

/** The rim rule seen from outside.  A pair that all but slides along a core or a
 * shoulder is turned by less than its velocities are rounded to, or than a tier
 * can tell from going in, 3 2^-53 of the sum: it would come again at this
 * instant, for ever.  (Two that move together 2^24 times as fast as apart are not
 * helped: that angle is no more than a rounding, and such a run stops.) */
static inline int brink_meeting_turns_away(const double r[3], double m1,
                                           double m2, double v1[3], double v2[3],
                                           double *owed)
{
    const double back[3] = {-r[0], -r[1], -r[2]};
    double rate = 0, sum = 0;
    for (int a = 0; a < 3; a++) {
        const double product = r[a] * (v1[a] - v2[a]);
        rate += product;
        sum += fabs(product);
    }
    return rate <= 0x1p-50 * sum &&
           brink_rim_impulse_balanced(back, m1, m2, v1, v2, owed);
}

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
    if (way == BRINK_INWARD && met.kind != BRINK_CAPTURE)
        met.rim = brink_meeting_turns_away(r, m1, m2, v1, v2, owed);
    return met;
}
#endif
