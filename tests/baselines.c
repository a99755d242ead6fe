// SPDX-License-Identifier: MIT
#include "baselines.h"
#include <math.h>

int baseline_quadratic_textbook(double a, double b, double c, double *x0,
                                double *x1)
{
    double d = b * b - 4 * a * c;
    if (d < 0)
        return 0;
    double s = sqrt(d);
    *x0 = (-b - s) / (2 * a);
    *x1 = (-b + s) / (2 * a);
    return 2;
}

/** Mantissa in [1, 2) and exponent; x is not 0. */
static double taken_apart(double x, int *e)
{
    double m = frexp(x, e);
    *e -= 1;
    return 2 * m;
}

/** b^2 - 4 a c, by Kahan's way with fma. */
static double discriminant(double a, double b, double c)
{
    double d = b * b - 4 * a * c;
    if (3 * fabs(d) >= b * b + fabs(4 * a * c))
        return d;
    double p = b * b, dp = fma(b, b, -p);
    double q = 4 * a * c, dq = fma(4 * a, c, -q);
    return (p - q) + (dp - dq);
}

int baseline_quadratic_goualard(double a, double b, double c, double *x0,
                                double *x1)
{
    if (a == 0) {
        if (b == 0)
            return 0;
        *x0 = -c / b;
        return 1;
    }
    if (c == 0) {
        *x0 = fmin(0, -b / a);
        *x1 = fmax(0, -b / a);
        return 2;
    }
    int ea, eb, ec;
    double a2 = taken_apart(a, &ea), c2 = taken_apart(c, &ec);
    if (b == 0) {
        if ((a > 0) == (c > 0))
            return 0;
        int odd = (ec - ea) & 1, half = (ec - ea - odd) / 2;
        double x = ldexp(sqrt(-ldexp(c2, odd) / a2), half);
        *x0 = -x;
        *x1 = x;
        return 2;
    }
    double b2 = taken_apart(b, &eb);
    int k = eb - ea, relation = ec + ea - 2 * eb;
    if (relation < -1022) { // the roots have nothing to do with each other
        double x = ldexp(-b2 / a2, k), y = ldexp(-c2 / b2, ec - eb);
        *x0 = fmin(x, y);
        *x1 = fmax(x, y);
        return 2;
    }
    if (relation >= 1020) { // b is nothing beside the others
        if ((a > 0) == (c > 0))
            return 0;
        int odd = (ec - ea) & 1, half = (ec - ea - odd) / 2;
        double x = ldexp(sqrt(-ldexp(c2, odd) / a2), half);
        *x0 = -x;
        *x1 = x;
        return 2;
    }
    c2 = ldexp(c2, relation);
    double d = discriminant(a2, b2, c2);
    if (d < 0)
        return 0;
    double q = -(b2 + copysign(sqrt(d), b2));
    double x = ldexp(q / (2 * a2), k), y = ldexp(2 * c2 / q, k);
    *x0 = fmin(x, y);
    *x1 = fmax(x, y);
    return 2;
}

double baseline_intersection(const double r[3], const double v[3], double sigma)
{
    double a = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    double b = r[0] * v[0] + r[1] * v[1] + r[2] * v[2];
    double c = r[0] * r[0] + r[1] * r[1] + r[2] * r[2] - sigma * sigma;
    double arg = b * b - a * c;
    if (b >= 0 || arg <= 0)
        return (double)INFINITY;
    return fmax(0, c / (sqrt(arg) - b));
}

double baseline_disjoint(const double r[3], const double v[3], double sigma)
{
    double a = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    double b = r[0] * v[0] + r[1] * v[1] + r[2] * v[2];
    double c = r[0] * r[0] + r[1] * r[1] + r[2] * r[2] - sigma * sigma;
    double arg = b * b - a * c;
    if (a == 0)
        return (double)INFINITY;
    if (arg <= 0)
        return fmax(0, -b / a);
    if (b > 0)
        return fmax(0, -c / (sqrt(arg) + b));
    return fmax(0, (sqrt(arg) - b) / a);
}
