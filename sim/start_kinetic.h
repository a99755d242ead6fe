// SPDX-License-Identifier: MIT
#ifndef BRINK_START_KINETIC_H
#define BRINK_START_KINETIC_H
/**
 * Kinetic theory for a configuration first made: velocities at a temperature, and
 * how soon something is to be expected.
 */
#include "system.h"
#include <gsl/gsl_rng.h>

/**
 * Draws velocities from Maxwell-Boltzmann, takes out the momentum (of two
 * particles or more) and scales: brink_system_temperature is then the temperature
 * asked for, to a relative error of at most BRINK_KINETIC_ERROR.
 */
#define BRINK_KINETIC_ERROR (11 * 0x1p-53)
void brink_kinetic_heat(brink_system *s, double temperature, gsl_rng *random);

/** A power of two near the time in which a particle has an event: to meet
 * another's outermost step, or to fly as far as the next particle, whichever is
 * sooner.  1 for a system at rest. */
double brink_kinetic_year(const brink_system *s);
#endif
