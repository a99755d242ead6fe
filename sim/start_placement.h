// SPDX-License-Identifier: MIT
#ifndef BRINK_START_PLACEMENT_H
#define BRINK_START_PLACEMENT_H
/**
 * Where particles are when a configuration is first made.  A system's particles
 * are numbered species by species; their positions are set here, and nothing
 * else.
 */
#include "scene.h"
#include <gsl/gsl_rng.h>

/** On the sites of a lattice, evenly where there are more sites than particles,
 * the species shuffled over them.  Cores may overlap.  0, -1 no memory. */
int brink_placement_lattice(brink_system *s, enum brink_lattice lattice,
                            gsl_rng *random);

/** One by one, the largest cores first, each anywhere that its core finds room.
 *  0; -1 no memory; 1 no room was found in a bounded number of trials, when the
 *  cores of those placed filled the part *packing of the box. */
int brink_placement_random(brink_system *s, gsl_rng *random, double *packing);

/** Whether cores overlap.  0; -1 no memory; 1 they do, those of i and j < i. */
int brink_placement_overlap(const brink_system *s, uint32_t *i, uint32_t *j);
#endif
