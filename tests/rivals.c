// SPDX-License-Identifier: MIT
#include "rivals.h"
#include "arithmetics.h"

/** x y - z w to 3/2 ulp, by Kahan's way. */
static double determinant(double x, double y, double z, double w)
{
    const double p = z * w, error = fma(-z, w, p);
    return fma(x, y, -p) + error;
}

int rival_roots_kahan(double a, double b, double c, double *x0, double *x1)
{
    return double_roots_for(a, b, c, determinant(b, b, 4 * a, c), x0, x1);
}

typedef struct coefficients { // of a t^2 + 2 b t + c
    double a, b, c;
} coefficients;

static coefficients rounded(const double r[3], const double v[3], double sigma)
{
    return (coefficients){double_dot(v, v), double_dot(r, v),
                          double_dot(r, r) - sigma * sigma};
}

/** a sigma^2 - |r x v|^2 */
static double cross_form(double a, const double r[3], const double v[3],
                         double sigma)
{
    const double x = determinant(r[1], v[2], r[2], v[1]),
                 y = determinant(r[2], v[0], r[0], v[2]),
                 z = determinant(r[0], v[1], r[1], v[0]);
    return a * (sigma * sigma) - (x * x + y * y + z * z);
}

double rival_intersection_kahan(const double r[3], const double v[3],
                                double sigma)
{
    const coefficients f = rounded(r, v, sigma);
    return double_intersection_for(f.b, f.c, determinant(f.b, f.b, f.a, f.c));
}

double rival_intersection_cross(const double r[3], const double v[3],
                                double sigma)
{
    const coefficients f = rounded(r, v, sigma);
    return double_intersection_for(f.b, f.c, cross_form(f.a, r, v, sigma));
}

double rival_disjoint_cross(const double r[3], const double v[3], double sigma)
{
    const coefficients f = rounded(r, v, sigma);
    return double_disjoint_for(f.a, f.b, f.c, cross_form(f.a, r, v, sigma));
}

double rival_disjoint_printed(const double r[3], const double v[3], double sigma)
{
    const coefficients f = rounded(r, v, sigma);
    const double arg = f.b * f.b - f.a * f.c;
    if (f.a == 0)
        return (double)INFINITY;
    if (arg <= 0)
        return fmax(0, -f.b / f.a);
    if (f.b > 0)
        return fmax(0, (sqrt(arg) - f.b) / f.a);
    return fmax(0, -f.c / (sqrt(arg) + f.b));
}

double rival_ball_factored(const double r[3], double sigma)
{
    const double length = sqrt(double_dot(r, r));
    return (length - sigma) * (length + sigma);
}
