// SPDX-License-Identifier: MIT
#ifndef BRINK_ROOT_H
#define BRINK_ROOT_H
/**
 * Correctly rounded roots of exact polynomials: where the slow path of every
 * kernel that answers with a root ends; not installed.
 *
 * The root is found in double-double to 2^-96 of itself.  Only if that lies so
 * near a midpoint of two doubles that it cannot tell which is nearer, the sign of
 * the polynomial at the midpoint does: bounded work, no ever higher precision.
 */
#include "dyadic.h"

enum brink_which { BRINK_LOWER, BRINK_UPPER };

/** The lower or upper root of a x^2 + 2 b x + c, a != 0, b^2 - a c = d >= 0. */
double brink_dyadic_root(const brink_dyadic *a, const brink_dyadic *b,
                         const brink_dyadic *c, const brink_dyadic *d,
                         enum brink_which which);

/** x / y, y != 0. */
double brink_dyadic_quotient(const brink_dyadic *x, const brink_dyadic *y);
#endif
