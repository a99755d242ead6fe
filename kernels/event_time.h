// SPDX-License-Identifier: MIT
#ifndef BRINK_EVENT_TIME_H
#define BRINK_EVENT_TIME_H
/**
 * When does a pair in free flight meet a sphere, or leave it; when does a
 * particle meet a plane.  f = |r + v t|^2 - sigma^2, or n.(r + v t - c), as in
 * <brink/overlap.h>.
 */
#include <stddef.h>

/** Bound of the times' error in ulp. */
#define BRINK_EVENT_TIME_ULP 8
/** Bound of a fast time's distance from the surface in eps (sigma + |v| t). */
#define BRINK_EVENT_TIME_GAP 8

#ifdef __cplusplus
extern "C" {
#endif

double brink_intersection_time(const double r[3], const double v[3],
                               double sigma);
double brink_intersection_time_fast(const double r[3], const double v[3],
                                    double sigma);
double brink_intersection_time_cr(const double r[3], const double v[3],
                                  double sigma);

double brink_disjoint_time(const double r[3], const double v[3], double sigma);
double brink_disjoint_time_fast(const double r[3], const double v[3],
                                double sigma);
double brink_disjoint_time_cr(const double r[3], const double v[3], double sigma);

double brink_halfspace_time(const double r[3], const double v[3],
                            const double n[3], const double c[3]);

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
