// SPDX-License-Identifier: MIT
#ifndef BRINK_NEIGHBOURS_H
#define BRINK_NEIGHBOURS_H
/**
 * Who can meet whom, where it is crowded: a list of neighbours a particle, good
 * for some dozen of its events.
 *
 * A particle has a home, a place in the box, and is in a ball around it; two that
 * have their homes so far from each other that they cannot be in range while both
 * are in their balls are no neighbours.  The home is a virtual state [S16 section
 * 4]: set from position once, then changed only by an executed departure, when
 * the particle comes to the edge of its ball.  The lists follow from the homes
 * alone.  Cells (see cells.h) hold particles by their homes, and serve to find
 * new neighbours.
 *
 * Where it is not crowded, or the box is not five cells of that width across,
 * there are no lists: radius is 0, and cells are all there is.
 */
#include "cells.h"
#include "lists.h"
#include "system.h"

typedef struct brink_home {
    uint32_t x[3]; // fraction of the box's length, in units of 2^-32
    uint32_t species;
} brink_home;

typedef struct brink_neighbours {
    double radius;    // of the balls; 0: there are no lists
    double unit[3];   // of homes: length / 2^32
    brink_home *home; // per particle
    brink_lists who;  // per particle: its neighbours, uint32_t
    // per pair of species, [a * species_count + b]: the square of the distance
    // within which two homes are neighbours'
    double *near;
    uint8_t *mark; // per particle, scratch
} brink_neighbours;

/** The radius of balls that is best for a system; 0 where lists do not pay. */
double brink_neighbours_radius(const brink_system *system);

/** Every particle at home where it is, and in the cell of its home; the lists are
 * empty.  Nothing is allocated, and nothing changed, for radius 0.  0, -1 no
 * memory. */
int brink_neighbours_create(brink_neighbours *n, brink_cells *cells,
                            const brink_system *system, double radius);
void brink_neighbours_destroy(brink_neighbours *n);
const char *brink_neighbours_is_valid(const brink_neighbours *n,
                                      const brink_cells *cells,
                                      const brink_system *system);

/** Sets a particle's home, and its cell, from a stored state (a checkpoint). */
void brink_neighbours_place(brink_neighbours *n, brink_cells *cells, uint32_t i,
                            const brink_home *home);

/** Makes all lists from the homes, by which the cells are filled.  0, -1 no
 * memory. */
int brink_neighbours_fill(brink_neighbours *n, const brink_cells *cells,
                          const brink_system *system);

/** When particle i comes to the edge of its ball, as an offset in the current
 * year that may lie beyond its end, and not before `offset`; +inf: never. */
double brink_neighbours_until(const brink_neighbours *n,
                              const brink_system *system, uint32_t i,
                              double offset);

/** Executes a departure: where i is now, at its own time, is its home, and its
 * lists and cell are that home's.  0, -1 no memory. */
int brink_neighbours_depart(brink_neighbours *n, brink_cells *cells,
                            const brink_system *system, uint32_t i);

static inline uint32_t brink_neighbours_count(const brink_neighbours *n,
                                              uint32_t i)
{
    return n->who.list[i].count;
}

static inline const uint32_t *brink_neighbours_of(const brink_neighbours *n,
                                                  uint32_t i)
{
    return brink_lists_items(&n->who, i);
}
#endif
