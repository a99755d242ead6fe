// SPDX-License-Identifier: MIT
#ifndef TESTS_SQUARE_WELL_H
#define TESTS_SQUARE_WELL_H
/**
 * What is known of the square-well fluid: a core of diameter 1, a well of depth 1
 * out to lambda, here 1 < lambda <= 2.  Temperatures are k_B T, energies those of
 * a particle.
 */

typedef struct square_well_state {
    double z, energy; // P V / N k_B T; potential, per particle
} square_well_state;

/** B_2 and B_3, exact; B_3 by Kihara's polynomials, in the form of [E09]. */
double square_well_second(double lambda, double temperature);
double square_well_third(double lambda, double temperature);

/** Up to the third virial coefficient. */
square_well_state square_well_dilute(double lambda, double temperature,
                                     double density);

/** The equation of state of [E09]: R. Espindola-Heredia, F. del Rio, A.
 *  Malijevsky, J. Chem. Phys. 130, 024509 (2009), doi 10.1063/1.3054361.  It is
 *  a series to the fourth order in 1 / T, fitted to simulations.  Its figures are
 *  as NIST's library teqp has them, in models/model_potentials/squarewell.hpp. */
square_well_state square_well_fluid(double lambda, double temperature,
                                    double density);
#endif
