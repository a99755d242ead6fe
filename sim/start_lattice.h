// SPDX-License-Identifier: MIT
#ifndef BRINK_START_LATTICE_H
#define BRINK_START_LATTICE_H
/**
 * The sites of a lattice that fills a periodic box: whole cells along each axis,
 * as near to their proper shape as the box allows, and just enough of them.
 */
#include "scene.h"

typedef struct brink_sites {
    enum brink_lattice lattice;
    double length[3]; // of the box
    uint64_t cells[3];
    uint64_t count; // of sites, at least as many as were asked for
} brink_sites;

/** Lays at least `least` sites of one of the lattices into a box. */
brink_sites brink_lattice_lay(enum brink_lattice lattice, const double length[3],
                              uint64_t least);

/** Coordinates of a site, 0 <= site < count; z is 0 on a plane. */
void brink_lattice_site(const brink_sites *sites, uint64_t site, double x[3]);
#endif
