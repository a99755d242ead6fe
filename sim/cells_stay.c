// SPDX-License-Identifier: MIT
// How long a particle stays in its cell, and near which others: asked at every
// prediction, and compiled for several instruction sets.
#include <brink/path.h>

#include "cells_block.h"
#include <math.h>
#include <string.h>

// All axes at once, in three lanes of four; in the last nothing moves.
typedef double lanes __attribute__((vector_size(32)));
typedef uint64_t units __attribute__((vector_size(32))); // they wrap around
typedef int64_t truth __attribute__((vector_size(32)));  // -1 or 0
static const truth three = {-1, -1, -1, 0};

// No function, as not every path can hand over so many lanes.
#define CHOSEN(yes, a, b) ((lanes)(((yes) & (truth)(a)) | (~(yes) & (truth)(b))))

// A cell's walls, and what a particle in it has to do with them.
typedef struct gaps {
    lanes below, above; // how far the particle is from them
    lanes v;
} gaps;

static inline void find_gaps(gaps *g, const brink_cells *c,
                             const brink_system *system, const brink_particle *p,
                             const uint32_t index[3])
{
    const double *u = system->unit;
    const uint64_t *wx = &c->wall[0][index[0]], *wy = &c->wall[1][index[1]],
                   *wz = &c->wall[2][index[2]];
    const units lower = {wx[0], wy[0], wz[0], 0},
                upper = {wx[1], wy[1], wz[1], 0};
    const lanes unit = {u[0], u[1], u[2], 0.0};
    units x;
    lanes v;
    memcpy(&x, p->x, sizeof x); // one lane more than there is: not looked at
    memcpy(&v, p->v, sizeof v);
    x &= (units)three;
    g->v = (lanes)((truth)v & three);
    g->below = __builtin_convertvector((truth)(x - lower), lanes) * unit;
    g->above = __builtin_convertvector((truth)(upper - x), lanes) * unit;
}

// When a particle meets the walls ahead [S16 eq. 4], from its own time on.  Gap
// and speed have one sign, or it is beyond the wall by a rounding.
static inline void find_times(lanes *t, const gaps *g)
{
    const lanes zero = {0, 0, 0, 0}, one = zero + 1;
    const lanes never = zero + (double)INFINITY;
    const truth rests = g->v == zero;
    const lanes ahead = CHOSEN(g->v > zero, g->above, -g->below);
    *t = CHOSEN(rests, never, ahead / CHOSEN(rests, one, g->v));
}

void brink_cells_stay(const brink_cells *c, const brink_system *system,
                      uint32_t i, double offset, brink_stay *stay)
{
    const brink_particle *p = &system->particle[i];
    uint32_t index[3], low[3], high[3];
    int first = 0;
    double soonest = (double)INFINITY;
    gaps g;
    lanes t;
    brink_cells_split(c, c->cell[i], index);
    find_gaps(&g, c, system, p, index);
    find_times(&t, &g);
    for (int a = 0; a < 3; a++) {
        // Chosen, not branched to: no processor could foresee which.
        first = t[a] < soonest ? a : first;
        soonest = t[a] < soonest ? t[a] : soonest;
    }
    const double until = soonest + p->since;
    stay->until = until > offset ? until : offset;
    stay->crossing = (brink_crossing){first, p->v[first] > 0 ? 1 : -1};

    // Which walls come within reach some time from now to then; both do of a
    // particle that rests for good, whose 0 * inf is no number.
    const lanes from = g.v * (offset - p->since);
    const lanes to = g.v * (stay->until - p->since);
    const truth below =
        ~((g.below + from > c->reach) & (g.below + to > c->reach));
    const truth above =
        ~((g.above - from > c->reach) & (g.above - to > c->reach));
    for (int a = 0; a < 3; a++) {
        low[a] = ((uint32_t)below[a] | c->always[a]) & c->adjacent[a];
        high[a] = ((uint32_t)above[a] | c->always[a]) & c->adjacent[a];
    }
    stay->cells = brink_cells_block(c, index, low, high, stay->near);
}
