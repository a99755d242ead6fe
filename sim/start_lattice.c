// SPDX-License-Identifier: MIT
#include "start_lattice.h"
#include <math.h>

// A cell: how long it properly is along each axis, and the sites in it.  Sites
// keep off the faces, so that none lies on the box's own.
struct shape {
    int dimensions;
    unsigned sites;
    double proper[3];
    double site[4][3];
};

static const struct shape shapes[] = {
    [BRINK_START_FCC] = {3,
                         4,
                         {1, 1, 1},
                         {{0.25, 0.25, 0.25},
                          {0.75, 0.75, 0.25},
                          {0.75, 0.25, 0.75},
                          {0.25, 0.75, 0.75}}},
    [BRINK_START_SC] = {3, 1, {1, 1, 1}, {{0.5, 0.5, 0.5}}},
    [BRINK_START_SQUARE] = {2, 1, {1, 1, 1}, {{0.5, 0.5, 0}}},
    [BRINK_START_HEXAGONAL] = {2,
                               2,
                               {1, 1.7320508075688773, 1}, // sqrt(3)
                               {{0.25, 0.25, 0}, {0.75, 0.75, 0}}},
};

// Let cells shrink from the size of the box, in their proper shape: whenever one
// more fits along an axis it is laid there, and the cells that are there share
// the room.  So neighbours are nowhere closer than in the largest proper lattice
// that fits.
brink_sites brink_lattice_lay(enum brink_lattice lattice, const double length[3],
                              uint64_t least)
{
    const struct shape *shape = &shapes[lattice];
    brink_sites s = {.lattice = lattice,
                     .length = {length[0], length[1], length[2]},
                     .cells = {1, 1, 1},
                     .count = shape->sites};
    while (s.count < least) {
        int widest = 0;
        double size = 0;
        for (int a = 0; a < shape->dimensions; a++) {
            const double next =
                length[a] / (shape->proper[a] * (double)(s.cells[a] + 1));
            widest = next > size ? a : widest;
            size = fmax(size, next);
        }
        s.cells[widest]++;
        s.count = shape->sites * s.cells[0] * s.cells[1] * s.cells[2];
    }
    return s;
}

void brink_lattice_site(const brink_sites *s, uint64_t site, double x[3])
{
    const struct shape *shape = &shapes[s->lattice];
    const double *within = shape->site[site % shape->sites];
    uint64_t cell = site / shape->sites;
    for (int a = 0; a < 3; a++) {
        x[a] = ((double)(cell % s->cells[a]) + within[a]) / (double)s->cells[a] *
               s->length[a];
        cell /= s->cells[a];
    }
}
