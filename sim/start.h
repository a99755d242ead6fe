// SPDX-License-Identifier: MIT
#ifndef BRINK_START_H
#define BRINK_START_H
/**
 * A configuration first made: from a checked scene to particles with positions
 * and velocities.  All randomness is GSL's mt19937 with the scene's seed.
 */
#include "scene.h"

/**
 * Places the particles (lattice sites taken evenly where there are more than
 * particles, species shuffled over them; or one by one at random without
 * overlapping cores; or from a file), draws velocities from Maxwell-Boltzmann,
 * takes out the momentum of the centre of mass and scales to the temperature. The
 * clock's year is chosen here, a power of two near the expected time in which
 * each particle has an event.
 *
 * Returns 0; or -1 with *errors told why (cores overlap at the start: which pair,
 * how far, what to do; no room to place at random; a bad file; no memory),
 * *system empty.
 */
int brink_start_make(const brink_scene *scene, const char *name,
                     brink_system *system, FILE *errors);
#endif
