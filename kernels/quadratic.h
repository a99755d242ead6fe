// SPDX-License-Identifier: MIT
#ifndef BRINK_QUADRATIC_H
#define BRINK_QUADRATIC_H
/**
 * Real roots of a x^2 + b x + c = 0: a drop-in for gsl_poly_solve_quadratic.
 */
#ifdef __cplusplus
extern "C" {
#endif

int brink_quadratic_roots(double a, double b, double c, double *x0, double *x1);
int brink_quadratic_roots_cr(double a, double b, double c, double *x0,
                             double *x1);

#ifdef __cplusplus
}
#endif
#endif
