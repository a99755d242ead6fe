// SPDX-License-Identifier: MIT
#ifndef BRINK_QUADRATIC_H
#define BRINK_QUADRATIC_H
/**
 * Real roots of a x^2 + b x + c = 0: a drop-in for gsl_poly_solve_quadratic.
 */
#ifdef __cplusplus
extern "C" {
#endif

/** Bound of the roots' error in ulp. */
#define BRINK_QUADRATIC_ULP 3

/**
 * The real roots, in order.
 *
 * Domain     a, b, c finite, of any magnitude
 * Returns     2  *x0 <= *x1; a double root counts twice
 *             1  a = 0, b != 0: *x0
 *             0  there is none, or a = b = 0: every x is a root, or no x
 *            -1  a coefficient is not finite
 *            An output that holds no root is left untouched.
 * Accuracy   the number of roots: exact for the doubles given.  Each root: at
 *            most BRINK_QUADRATIC_ULP, gradual underflow included; an infinity
 *            only where the root is beyond the range, 0 only where it is 0 or
 *            below 2^-1074
 * Method     discriminant h^2 - a c, h = -b/2, by fma, so that its sign is exact;
 *            s = h + sign(h) sqrt(d), roots s / a and c / s.  Exponents far from
 *            0 are taken out first, by powers of two
 * Checked    tests/quadratic_test.c
 */
int brink_quadratic_roots(double a, double b, double c, double *x0, double *x1);

/**
 * The same, each root correctly rounded, a root halfway between two doubles to
 * even.
 *
 * Method     the square root and the quotients carry their low parts, which
 *            leaves all but one root in a million certain; for that one the sign
 *            of the polynomial at the midpoint, in exact arithmetic
 */
int brink_quadratic_roots_cr(double a, double b, double c, double *x0,
                             double *x1);

#ifdef __cplusplus
}
#endif
#endif
