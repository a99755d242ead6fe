// SPDX-License-Identifier: MIT
#ifndef BRINK_IMPULSE_H
#define BRINK_IMPULSE_H
/**
 * What a pair does at a step: the momentum change along the line of centres.
 *
 * Throughout: r = r1 - r2, the *actual* separation at the event, a few ulp off
 * the surface as it may be; v1, v2 the velocities, updated in place; m1, m2 > 0
 * finite.  With mu = m1 m2 / (m1 + m2) and b = r.(v1 - v2), the energy of the
 * radial motion is mu b^2 / (2 r.r).  Nothing here depends on r having the length
 * of the step, so the energy is right wherever the pair was put.
 */
#include "step.h"

/** Bound of the pair energy's error in ulp of the larger kinetic energy, and
 *  of the pair momentum's in ulp of the larger |m v|, before or after; for
 *  masses up to 1e12 apart.  That is the last rounding of either velocity; what
 *  double-double leaves is less than 2^-45 of it, and comes on top where that
 *  energy, or |m v|, is as near as that below a power of two: 4 + 2^-52 ulp of
 *  energy are known there, of momentum no more than 2.  A virial is, where it is
 *  normal, within 2^-52 of itself and 2^-90 of |r| times the larger m |v|, unless
 *  a crossing leaves less than 2^-90 of the energy. */
#define BRINK_IMPULSE_ENERGY_ULP   4
#define BRINK_IMPULSE_MOMENTUM_ULP 2

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Elastic reflection: b changes its sign, going outward afterwards whatever the
 * rounding of b said before.  Returns r.dp, dp = m1 (v1' - v1): the pair's
 * contribution to the virial, >= 0.
 */
double brink_core_impulse(const double r[3], double m1, double m2, double v1[3],
                          double v2[3]);

/**
 * A finite step met in direction `way`, across which the potential energy rises
 * by `rise` (negative: falls).  The pair crosses if its radial energy suffices
 * (mu b^2 / (2 r.r) > rise, decided exactly for the doubles given) and keeps its
 * direction with the radial energy less the rise; otherwise it is reflected.
 * After a crossing b has the sign of `way`, after a reflection the other one.
 *
 * Returns   1 crossed, 0 reflected; the virial r.dp in *virial.
 */
int brink_step_impulse(const double r[3], double m1, double m2, double rise,
                       enum brink_direction way, double v1[3], double v2[3],
                       double *virial);

/**
 * The rim rule.  A captured pair that is on the rim with next to no radial
 * velocity bounces on the inside of a step at ever shorter intervals: below an
 * angle of about sqrt(eps) to the tangent the chord to the next bounce is lost in
 * the rounding of r itself, and time would stand still.  Where the angle is less
 * than BRINK_RIM_ANGLE the relative velocity is turned inward to just that angle,
 * its magnitude, hence the energy, and the pair's momentum kept; the angular
 * momentum changes by BRINK_RIM_ANGLE^2 / 2 = 2^-49 of itself, to first order,
 * less than its rounding in a bounce or two.
 *
 * Returns   1 if it turned the pair, 0 if the angle was large enough as it was.
 */
#define BRINK_RIM_ANGLE 0x1p-24
int brink_rim_impulse(const double r[3], double m1, double m2, double v1[3],
                      double v2[3]);

/**
 * The same three with an account of energy.  Each velocity is rounded at the end,
 * which makes the energy of a run go the way of a random walk; but what a
 * rounding takes is known.  *owed, finite, is the kinetic energy that roundings
 * have taken so far, negative if they have given some.  It is added to the energy
 * with which the pair goes on, where that changes its radial energy by less than
 * 2^-20 of itself (else it stays owed), and what is rounded here is put down:
 *
 *     energy after + *owed after = energy before + *owed before - rise if crossed
 *
 * to BRINK_IMPULSE_BALANCE of the larger kinetic energy and 2^-49 of *owed
 * before.  What is added is there to 2^-49 of itself, which comes on top of
 * BRINK_IMPULSE_ENERGY_ULP.  Whether the pair crosses does not depend on *owed;
 * where that is 0, velocities become what they become above.
 */
#define BRINK_IMPULSE_BALANCE 0x1p-96
double brink_core_impulse_balanced(const double r[3], double m1, double m2,
                                   double v1[3], double v2[3], double *owed);
int brink_step_impulse_balanced(const double r[3], double m1, double m2,
                                double rise, enum brink_direction way,
                                double v1[3], double v2[3], double *virial,
                                double *owed);
int brink_rim_impulse_balanced(const double r[3], double m1, double m2,
                               double v1[3], double v2[3], double *owed);

#ifdef __cplusplus
}
#endif
#endif
