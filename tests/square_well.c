// SPDX-License-Identifier: MIT
#include "square_well.h"
#include <gsl/gsl_math.h>
#include <gsl/gsl_poly.h>
#include <math.h>

// f = exp(-u / kT) - 1 is -1 in the core and x in the well.
static double mayer(double temperature)
{
    return exp(1 / temperature) - 1;
}

// B_3 18 / pi^2 = 5 - p1 x + p2 x^2 - p3 x^3
typedef struct kihara {
    double p1, p2, p3;
} kihara;

static kihara kihara_of(double lambda)
{
    const double l2 = lambda * lambda, l3 = l2 * lambda, l4 = l2 * l2,
                 l6 = l3 * l3;
    return (kihara){l6 - 18 * l4 + 32 * l3 - 15,
                    -2 * l6 + 36 * l4 - 32 * l3 - 18 * l2 + 16,
                    6 * l6 - 18 * l4 + 18 * l2 - 6};
}

double square_well_second(double lambda, double temperature)
{
    return 2 * M_PI / 3 *
           (1 - (lambda * lambda * lambda - 1) * mayer(temperature));
}

double square_well_third(double lambda, double temperature)
{
    const kihara k = kihara_of(lambda);
    const double c[] = {5, -k.p1, k.p2, -k.p3};
    return M_PI * M_PI / 18 * gsl_poly_eval(c, 4, mayer(temperature));
}

// Free energy a beyond the ideal gas's, in units of N k_B T; from it follow
// Z = 1 + density da/d(density) and the energy, da/d(1/T).  Central differences
// of 2^-13 are off by 2^-26 of the third derivative's term, and by 2^-40 through
// rounding.
typedef double free_energy(double lambda, double temperature, double density);

static square_well_state state_of(free_energy *a, double lambda,
                                  double temperature, double density)
{
    const double h = 0x1p-13, beta = 1 / temperature;
    const double z = a(lambda, temperature, density * (1 + h)) -
                     a(lambda, temperature, density * (1 - h));
    const double e = a(lambda, 1 / (beta * (1 + h)), density) -
                     a(lambda, 1 / (beta * (1 - h)), density);
    return (square_well_state){1 + z / (2 * h), e / (2 * h) / beta};
}

static double dilute(double lambda, double temperature, double density)
{
    return square_well_second(lambda, temperature) * density +
           square_well_third(lambda, temperature) / 2 * density * density;
}

square_well_state square_well_dilute(double lambda, double temperature,
                                     double density)
{
    return state_of(dilute, lambda, temperature, density);
}

// --- [E09] ---------------------------------------------------------------------

// The coefficients of density^2 in the terms of 1/T to 1/T^4: B_3 / 2 expanded.
static void third_order(double lambda, double a3[5])
{
    const kihara k = kihara_of(lambda);
    const double unit = M_PI * M_PI / 36;
    a3[1] = -unit * k.p1;
    a3[2] = unit * (k.p2 - k.p1 / 2);
    a3[3] = unit * (k.p2 - k.p1 / 6 - k.p3);
    a3[4] = unit * (-k.p1 / 24 + 7 * k.p2 / 12 - 3 * k.p3 / 2);
}

// Those of density, of B_2.
static double second_order(double lambda, double factorial)
{
    return -2 * M_PI / (3 * factorial) * (lambda * lambda * lambda - 1);
}

// Of density^(n+2), n = 1 to 4, in the first term.
static double first_term_coefficient(int n, double lambda)
{
    static const double g[4][14] = {
        {-59.0464, 26.098, 26.4454, 7.40136, 11.0743, -5.49152, 0.781823,
         -0.0319751, 0.827621, 0.605635, -0.254959, 0.0377111, -0.00210896,
         0.0000452328},
        {214.316, -88.1394, 273.3, 95.9759, 71.1228, -40.2656, 5.94069, -0.23842,
         -2.17558, -1.29255, 0.554993, -0.0857543, 0.00492511, -0.000107067},
        {-225.479, 88.8202, 250.472, 90.2606, 57.0274, -33.2376, 4.99527,
         -0.195714, 1.84677, 0.99813, -0.440314, 0.0708793, -0.00416274,
         0.0000917291},
        {65.0504, -25.096, 74.3095, 26.2153, 18.4397, -10.0891, 1.50243,
         -0.057694, -1.87154, -1.01682, 0.445247, -0.0725107, 0.00427862,
         -0.0000949723}};
    const double *c = g[n - 1], y = lambda * lambda * lambda - 1;
    const double over = c[2] + y * y * gsl_poly_eval(c + 3, 5, y);
    const double under = c[8] + y * y * y * gsl_poly_eval(c + 9, 5, y);
    return c[0] * lambda + c[1] * lambda * lambda + over / under;
}

// What stands in the exponent of the third and the fourth term.
static double higher_exponent(const double over[4], const double under[3],
                              double lambda, double density)
{
    return density * density * lambda * gsl_poly_eval(over, 4, lambda) /
           (1 + density * lambda * gsl_poly_eval(under, 3, lambda));
}

static double fluid(double lambda, double temperature, double density)
{
    static const double phi1[8] = {-1320.19, 5124.1,  -8145.37, 6895.8,
                                   -3381.42, 968.739, -151.255, 9.98592},
                        phi2[8] = {1049.76, -4023.29, 6305.95, -5265.42,
                                   2553.84, -727.3,   113.631, -7.56266},
                        over3[4] = {-945.597, 1326.61, -471.688, 0},
                        under3[3] = {23.2271, -2.63477, 0},
                        over4[4] = {4131.09, -10501.1, 8909.18, -2521.96},
                        under4[3] = {-16.7882, 19.5315, -1.27373};
    const double eta = M_PI / 6 * density, square = density * density;
    double a3[5], a2[5], factorial = 1;
    third_order(lambda, a3);
    for (int n = 1; n <= 4; n++)
        a2[n] = second_order(lambda, factorial *= n);

    // Carnahan and Starling's spheres, then term by term
    const double cores = eta * (4 - 3 * eta) / ((1 - eta) * (1 - eta));
    double first = a2[1] * density + a3[1] * square;
    for (int n = 1; n <= 4; n++)
        first += first_term_coefficient(n, lambda) * pow(density, n + 2);
    const double second = a2[2] * density * (1 - square / 1.5129) *
                          exp(a3[2] / a2[2] * density +
                              density * square *
                                  (gsl_poly_eval(phi1, 8, lambda) +
                                   density * gsl_poly_eval(phi2, 8, lambda)));
    const double third = a2[3] * density *
                         exp(a3[3] / a2[3] * density +
                             higher_exponent(over3, under3, lambda, density));
    const double fourth = a2[4] * density *
                          exp(a3[4] / a2[4] * density +
                              higher_exponent(over4, under4, lambda, density));
    const double terms[] = {cores, first, second, third, fourth};
    return gsl_poly_eval(terms, 5, 1 / temperature);
}

square_well_state square_well_fluid(double lambda, double temperature,
                                    double density)
{
    return state_of(fluid, lambda, temperature, density);
}
