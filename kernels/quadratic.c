// SPDX-License-Identifier: MIT
#include "quadratic.h"
#include "root.h"

int brink_quadratic_roots_cr(double a, double b, double c, double *x0, double *x1)
{
    if (!(isfinite(a) && isfinite(b) && isfinite(c)))
        return -1;
    brink_dyadic a2, b1, c2, bb, ac, d;
    brink_dyadic_double(&b1, b);
    if (a == 0) {
        if (b == 0)
            return 0;
        *x0 = 0 - c / b; // one division, correctly rounded; no -0.0
        return 1;
    }
    const double two = 2;
    brink_dyadic_dot(&a2, 1, &a, &two);
    brink_dyadic_dot(&c2, 1, &c, &two);
    brink_dyadic_mul(&bb, &b1, &b1);
    brink_dyadic_mul(&ac, &a2, &c2);
    brink_dyadic_sub(&d, &bb, &ac);
    if (d.sign < 0)
        return 0;
    *x0 = brink_dyadic_root(&a2, &b1, &c2, &d, BRINK_LOWER);
    *x1 = brink_dyadic_root(&a2, &b1, &c2, &d, BRINK_UPPER);
    return 2;
}

int brink_quadratic_roots(double a, double b, double c, double *x0, double *x1)
{
    return brink_quadratic_roots_cr(a, b, c, x0, x1);
}
