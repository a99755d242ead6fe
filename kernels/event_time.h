// SPDX-License-Identifier: MIT
#ifndef BRINK_EVENT_TIME_H
#define BRINK_EVENT_TIME_H
/**
 * When a pair in free flight meets a sphere, or leaves it; when a particle meets
 * a plane.
 *
 *     f(t) = |r + v t|^2 - sigma^2    or    f(t) = n.(r + v t - c)
 *
 * is negative inside, as in <brink/overlap.h>; r and v are the pair's separation
 * and relative velocity, or a particle's position and velocity.  Units are any
 * consistent set: lengths in L, velocities in L/T, times in T; n may have any
 * length.
 *
 * Three tiers:
 *
 *     plain  event or none, now or later: exact, as the real numbers have it for
 *            the doubles given.  The time within BRINK_EVENT_TIME_ULP
 *     _fast  at the time answered the pair is within BRINK_EVENT_TIME_GAP eps
 *            (sigma + |v| t) of the surface.  What is decided within that of it
 *            may be answered either way: whether a pair passes inside or outside
 *            the rim, is in or out, before its closest approach or behind
 *     _cr    as plain, the time correctly rounded, ties to even
 *
 * A time too large or too small for a double is +inf or 0, as any result rounds.
 */
#include <stddef.h>

/** Bound of the plain times' error in ulp. */
#define BRINK_EVENT_TIME_ULP 8
/** Bound of a fast time's distance from the surface in eps (sigma + |v| t). */
#define BRINK_EVENT_TIME_GAP 8

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Smallest t >= 0 at which the pair is inside or on the sphere and still
 * approaching: f <= 0 and f' < 0 [S16 eq. 3].
 *
 * Domain     r, v, sigma finite, sigma >= 0, of any magnitude
 * Returns    the time; 0 where the pair is inside or touching, and approaches;
 *            +inf where it never does; NaN outside the domain.  Never negative
 * Special    touching and parting: none; grazing with zero discriminant: none
 * Method     filters for those that recede or pass by, with
 *            d = sigma^2 |v|^2 - |r x v|^2; t = c / (sqrt(d) - b), c, b and d
 *            from sums that carry their rounding errors.  What then is not
 *            certain: double-double, and exact numbers
 * Source     [S16] algorithm 1; [B14] for what an event is
 * Checked    tests/event_time_test.c
 */
double brink_intersection_time(const double r[3], const double v[3],
                               double sigma);
double brink_intersection_time_fast(const double r[3], const double v[3],
                                    double sigma);
double brink_intersection_time_cr(const double r[3], const double v[3],
                                  double sigma);

/**
 * First t >= 0 from which on the pair is outside and parting: the later root of
 * f, or 0 if that lies behind; where the path never enters the sphere, the
 * closest approach, max(0, -r.v / v.v).
 *
 * Domain     r, v, sigma finite, sigma >= 0, of any magnitude
 * Returns    the time; +inf only for v = 0; NaN outside the domain.  Never
 *            negative
 * Method     t = -c / (sqrt(d) + b) for b > 0, otherwise (sqrt(d) - b) / a, so
 *            that nothing cancels: [S16] prints the two the other way round.  Far
 *            pairs that part or pass by are told first; what then is not certain:
 *            double-double, and exact numbers
 * Source     [S16] algorithm 2, with its branches put right
 * Checked    tests/event_time_test.c
 */
double brink_disjoint_time(const double r[3], const double v[3], double sigma);
double brink_disjoint_time_fast(const double r[3], const double v[3],
                                double sigma);
double brink_disjoint_time_cr(const double r[3], const double v[3], double sigma);

/**
 * Smallest t >= 0 with n.(r + v t - c) <= 0 and n.v < 0: when a particle on the
 * side that n points to meets the plane through c.
 *
 * Domain     all finite, of any magnitude
 * Returns    the time, correctly rounded (a lesser tier would cost as much); 0
 *            where the particle is on the plane or beyond, and goes on; +inf
 *            where it never does; NaN outside the domain.  Never negative
 * Source     [S16 eq. 4]
 * Checked    tests/event_time_test.c
 */
double brink_halfspace_time(const double r[3], const double v[3],
                            const double n[3], const double c[3]);

/**
 * Many pairs: t[i] of the pair (rx[i], ry[i], rz[i]), (vx[i], vy[i], vz[i]),
 * sigma[i], i < n, bit for bit as the scalar function of the same tier has it.
 *
 * Aliasing   t may be any one of the inputs; inputs may be one another.  Nothing
 *            needs to be aligned
 * Checked    tests/event_time_batch_test.c
 */
void brink_intersection_times(size_t n, const double *rx, const double *ry,
                              const double *rz, const double *vx,
                              const double *vy, const double *vz,
                              const double *sigma, double *t);
void brink_intersection_times_fast(size_t n, const double *rx, const double *ry,
                                   const double *rz, const double *vx,
                                   const double *vy, const double *vz,
                                   const double *sigma, double *t);
void brink_disjoint_times(size_t n, const double *rx, const double *ry,
                          const double *rz, const double *vx, const double *vy,
                          const double *vz, const double *sigma, double *t);
void brink_disjoint_times_fast(size_t n, const double *rx, const double *ry,
                               const double *rz, const double *vx,
                               const double *vy, const double *vz,
                               const double *sigma, double *t);

#ifdef __cplusplus
}
#endif
#endif
