// SPDX-License-Identifier: MIT
#ifndef TESTS_RIVALS_H
#define TESTS_RIVALS_H
/** Ways to an answer that others take, beside those of baselines.h and
 * arithmetics.h. */

/** The stable quotient with the discriminant by Kahan's way with fma. */
int rival_roots_kahan(double a, double b, double c, double *x0, double *x1);

/** [S16] algorithm 1, the discriminant of its rounded a, b, c by Kahan's way. */
double rival_intersection_kahan(const double r[3], const double v[3],
                                double sigma);
/** With the discriminant as a sigma^2 - |r x v|^2, 2x2 determinants by fma. */
double rival_intersection_cross(const double r[3], const double v[3],
                                double sigma);
double rival_disjoint_cross(const double r[3], const double v[3], double sigma);
/** [S16] algorithm 2 as printed, its two branches swapped. */
double rival_disjoint_printed(const double r[3], const double v[3], double sigma);

/** The overlap of two balls as (|r| - sigma)(|r| + sigma). */
double rival_ball_factored(const double r[3], double sigma);

/** The oracle's own formulas, in so many bits that sums and products are exact,
 * and in 256, which is what one takes who wants to be on the safe side. */
int rival_roots_mpfr(double a, double b, double c, double *x0, double *x1);
int rival_roots_mpfr256(double a, double b, double c, double *x0, double *x1);
double rival_intersection_mpfr(const double r[3], const double v[3],
                               double sigma);
double rival_intersection_mpfr256(const double r[3], const double v[3],
                                  double sigma);
double rival_disjoint_mpfr(const double r[3], const double v[3], double sigma);
double rival_disjoint_mpfr256(const double r[3], const double v[3], double sigma);
double rival_halfspace_time_mpfr(const double r[3], const double v[3],
                                 const double n[3], const double c[3]);
double rival_halfspace_time_mpfr256(const double r[3], const double v[3],
                                    const double n[3], const double c[3]);

/** The overlap of two balls, and of a plane, at time t: see oracle_overlap.h. */
double rival_ball_mpfr(const double r[3], const double v[3], double sigma,
                       double t);
double rival_ball_mpfr256(const double r[3], const double v[3], double sigma,
                          double t);
double rival_plane_mpfr(const double r[3], const double v[3], const double n[3],
                        const double c[3], double t);
double rival_plane_mpfr256(const double r[3], const double v[3],
                           const double n[3], const double c[3], double t);
#endif
