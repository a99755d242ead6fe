// SPDX-License-Identifier: MIT
#ifndef TESTS_BASELINES_H
#define TESTS_BASELINES_H
/** What the kernels are measured against: what one would write, or finds in
 * print. */

/** a x^2 + b x + c = 0 by the formula of textbooks; the number of roots. */
int baseline_quadratic_textbook(double a, double b, double c, double *x0,
                                double *x1);
/** After Goualard (2023), The Ins and Outs of Solving Quadratic Equations with
 *  Floating-Point Arithmetic: exponents taken out first, always. */
int baseline_quadratic_goualard(double a, double b, double c, double *x0,
                                double *x1);

/** [S16] algorithm 1 as printed. */
double baseline_intersection(const double r[3], const double v[3], double sigma);
/** [S16] algorithm 2 with its branches put right, otherwise as printed. */
double baseline_disjoint(const double r[3], const double v[3], double sigma);
#endif
