// SPDX-License-Identifier: MIT
#ifndef BRINK_START_CROWD_H
#define BRINK_START_CROWD_H
/**
 * Whose hard core is in whose: a grid that particles are put into one by one,
 * each in O(1), while a configuration is first made.  Cells are at least as wide
 * as the largest core and about as many as there are particles.
 */
#include "system.h"

typedef struct brink_crowd {
    const brink_system *system;
    uint32_t cells[3]; // along each axis
    uint32_t *first;   // per cell: one of its particles, or BRINK_ALONE
    uint32_t *next;    // per particle: another in its cell
} brink_crowd;

#define BRINK_ALONE UINT32_MAX

int brink_crowd_create(brink_crowd *c,
                       const brink_system *system); // 0, -1 no memory
void brink_crowd_destroy(brink_crowd *c);

/** A particle of the crowd whose core overlaps that of particle i where it is
 * now, by exact signs, or BRINK_ALONE.  Cores that touch do not overlap. */
uint32_t brink_crowd_overlap(const brink_crowd *c, uint32_t i);

void brink_crowd_add(brink_crowd *c, uint32_t i);
#endif
