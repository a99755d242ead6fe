// SPDX-License-Identifier: MIT
#ifndef BRINK_OVERLAP_H
#define BRINK_OVERLAP_H
/**
 * Inside or outside, coming or going: the overlap functions of [S16] and their
 * rates.
 *
 * A pair's separation r, relative velocity v and the sphere's radius sigma; or a
 * particle's position r, a plane through c with normal n pointing to the valid
 * side. Lengths and times in any consistent units.  All inputs are finite, of any
 * magnitude.
 */
#ifdef __cplusplus
extern "C" {
#endif

double brink_ball_overlap(const double r[3], double sigma);
double brink_ball_overlap_rate(const double r[3], const double v[3]);
int brink_ball_overlap_sign(const double r[3], double sigma);
int brink_ball_overlap_rate_sign(const double r[3], const double v[3]);

#ifdef __cplusplus
}
#endif
#endif
