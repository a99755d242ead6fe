// SPDX-License-Identifier: MIT
#ifndef FUZZ_ADVERSE_H
#define FUZZ_ADVERSE_H
/**
 * Systems that are near discontinuities on purpose: pairs at a step or a few ulp
 * from it, tangents, rows and grids whose particles meet at once, particles on
 * walls of cells, on the rim with next to no radial velocity, masses and speeds
 * far apart, boxes just wide enough.
 *
 * What is not made: cores in each other by more than a few ulp, which no dynamics
 * is defined for; rings of touching cores around the box, and masses more than
 * 2^13 apart.  In the first of these a push goes round without end at one
 * instant, and between two heavy ones that touch it a light one is hit pi
 * sqrt(ratio) times at one instant: more than a run waits for before it says that
 * it is stuck.
 */
#include "../tests/random.h"
#include "system.h"
#include <stdio.h>

enum { ADVERSE_MOST = 72, ADVERSE_STEPS = 4, ADVERSE_KINDS = 3 };

/** Makes one; 2 to 16 particles as a rule, 64 where lists of neighbours are to be
 * kept. */
void adverse_make(stream *s, brink_system *system);

/** 2 to 5 particles anywhere, near nothing but by chance, and of speeds near 1: a
 *  kinetic energy that is lost in the rounding of a depth decides nothing. */
void adverse_make_few(stream *s, brink_system *system);

/** A copy, particles and all. */
void adverse_copy(brink_system *to, const brink_system *from);

/**
 * Prints it in hex, and as a scene and the positions that it starts from, which
 * `brink run` reads: into the folder that BRINK_FINDING_DIR names, else to
 * standard error.  A file's coordinates are doubles: where a position is finer
 * than that, or cores overlap by a rounding, which `brink run` refuses, that is
 * said.
 */
void adverse_tell(const brink_system *system);
#endif
