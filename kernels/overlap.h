// SPDX-License-Identifier: MIT
#ifndef BRINK_OVERLAP_H
#define BRINK_OVERLAP_H
/**
 * Inside or outside, coming or going: the overlap functions of [S16] and their
 * rates.
 *
 *     ball         f = r.r - sigma^2 [S16 eq. 1], negative inside; half its rate,
 *                  r.v [eq. 2]; r and v a pair's separation and relative velocity
 *     half-space   f = n.(r - c) and its rate n.v [eq. 4], of a particle at r and
 *                  the plane through c whose normal n, of any length, points to
 *                  the valid side
 *
 * Functions with _at take r + v t for r: where free flight leads.
 *
 * Domain     finite inputs of any magnitude, t of either sign; outside of it
 *            values are NaN, and signs 0
 * Accuracy   signs are exact for the doubles given; values are within
 *            BRINK_OVERLAP_ULP of exact, under- and overflow included
 * Method     sums that carry their rounding errors along, with a bound; what lies
 *            within the bound of 0, or has lost too many digits to cancellation,
 *            in exact arithmetic
 * Checked    tests/overlap_test.c
 */
#ifdef __cplusplus
extern "C" {
#endif

/** Bound of the values' error in ulp. */
#define BRINK_OVERLAP_ULP 1

double brink_ball_overlap(const double r[3], double sigma);
int brink_ball_overlap_sign(const double r[3], double sigma); // -1, 0, 1
double brink_ball_overlap_rate(const double r[3], const double v[3]);
int brink_ball_overlap_rate_sign(const double r[3], const double v[3]);

double brink_ball_overlap_at(const double r[3], const double v[3], double sigma,
                             double t);
int brink_ball_overlap_sign_at(const double r[3], const double v[3], double sigma,
                               double t);
double brink_ball_overlap_rate_at(const double r[3], const double v[3], double t);
int brink_ball_overlap_rate_sign_at(const double r[3], const double v[3],
                                    double t);

double brink_halfspace_overlap(const double r[3], const double n[3],
                               const double c[3]);
int brink_halfspace_overlap_sign(const double r[3], const double n[3],
                                 const double c[3]);
double brink_halfspace_overlap_rate(const double v[3], const double n[3]);
int brink_halfspace_overlap_rate_sign(const double v[3], const double n[3]);

double brink_halfspace_overlap_at(const double r[3], const double v[3],
                                  const double n[3], const double c[3], double t);
int brink_halfspace_overlap_sign_at(const double r[3], const double v[3],
                                    const double n[3], const double c[3],
                                    double t);

#ifdef __cplusplus
}
#endif
#endif
