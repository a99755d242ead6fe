// SPDX-License-Identifier: MIT
#include "cells.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

// As many cells as particles if the interaction allows: an empty cell costs a
// look and a crossing, a full one its particles.
static void choose(brink_cells *c, const brink_system *s, double reach)
{
    const double share =
        pow(brink_system_volume(s) / (double)s->count, 1.0 / s->dimensions);
    c->reach = reach * BRINK_SLACK;
    const double width = fmax(c->reach, share);
    for (int a = 0; a < 3; a++) {
        const double fit = floor(s->length[a] / width);
        const int there = a < s->dimensions;
        c->count[a] = !there ? 1 : fit < 5 ? 3 : (int)fmin(fit, 0x1p20);
        c->images[a] = there && fit < 5 ? 3 : 1;
    }
    c->total = (uint32_t)(c->count[0] * c->count[1] * c->count[2]);
}

static int build_walls(brink_cells *c)
{
    for (int a = 0; a < 3; a++) {
        const unsigned n = (unsigned)c->count[a];
        c->wall[a] = malloc((n + 1) * sizeof *c->wall[a]);
        if (!c->wall[a])
            return -1;
        for (unsigned k = 0; k <= n;
             k++) // ceil(k 2^64 / n), the end being 0 again
            c->wall[a][k] =
                (uint64_t)((((unsigned __int128)k << 64) + n - 1) / n);
    }
    return 0;
}

uint32_t brink_cells_at(const brink_cells *c, const uint64_t x[3])
{
    uint32_t index[3];
    for (int a = 0; a < 3; a++)
        index[a] =
            (uint32_t)((x[a] * (unsigned __int128)(unsigned)c->count[a]) >> 64);
    return index[0] +
           (uint32_t)c->count[0] * (index[1] + (uint32_t)c->count[1] * index[2]);
}

// The last bucket of a cell, which is where there is room or nobody comes after.
static uint32_t last_of(const brink_cells *c, uint32_t cell)
{
    uint32_t at = cell;
    while (c->bucket[at].fill > BRINK_BUCKET)
        at = c->bucket[at].fill;
    return at;
}

static void enter(brink_cells *c, uint32_t i, uint32_t cell)
{
    uint32_t at = last_of(c, cell);
    if (c->bucket[at].fill == BRINK_BUCKET) {
        const uint32_t fresh = c->free;
        c->free = c->bucket[fresh].fill;
        c->bucket[fresh].fill = 0;
        c->bucket[at].fill = fresh;
        at = fresh;
    }
    brink_bucket *b = &c->bucket[at];
    b->who[b->fill++] = i;
    c->cell[i] = cell;
}

// The place of a particle in its cell's buckets.
static uint32_t *place_of(const brink_cells *c, uint32_t i)
{
    uint32_t at = c->cell[i];
    for (;;) {
        brink_bucket *b = &c->bucket[at];
        for (uint32_t k = 0; k < b->fill && k < BRINK_BUCKET; k++)
            if (b->who[k] == i)
                return &b->who[k];
        at = b->fill;
    }
}

// The last of the cell moves up into the place.
static void leave(brink_cells *c, uint32_t i)
{
    const uint32_t cell = c->cell[i], at = last_of(c, cell);
    brink_bucket *last = &c->bucket[at];
    uint32_t *place = place_of(c, i);
    *place = last->who[--last->fill];
    if (last->fill > 0 || at == cell)
        return;
    uint32_t before = cell;
    while (c->bucket[before].fill != at)
        before = c->bucket[before].fill;
    c->bucket[before].fill = BRINK_BUCKET;
    last->fill = c->free;
    c->free = at;
}

static void split(const brink_cells *c, uint32_t cell, int index[3])
{
    const uint32_t nx = (uint32_t)c->count[0], ny = (uint32_t)c->count[1];
    index[0] = (int)(cell % nx);
    index[1] = (int)(cell / nx % ny);
    index[2] = (int)(cell / nx / ny);
}

static uint32_t join(const brink_cells *c, const int index[3])
{
    // NOLINTNEXTLINE(clang-analyzer-core.*): all three are filled in
    const int row = index[1] + c->count[1] * index[2];
    return (uint32_t)(index[0] + c->count[0] * row);
}

// The cells of the block low..high around the one at `index`, wrapped round.
static int block(const brink_cells *c, const int index[3], const int low[3],
                 const int high[3], uint32_t out[27])
{
    int side[3][3], n = 0;
    const int nx = c->count[0], ny = c->count[1];
    for (int a = 0; a < 3; a++)
        for (int d = low[a]; d <= high[a]; d++) {
            const int k = index[a] + d;
            side[a][d - low[a]] = k < 0              ? k + c->count[a]
                                  : k >= c->count[a] ? k - c->count[a]
                                                     : k;
        }
    for (int z = 0; z <= high[2] - low[2]; z++)
        for (int y = 0; y <= high[1] - low[1]; y++) {
            const int row = nx * (side[1][y] + ny * side[2][z]);
            for (int x = 0; x <= high[0] - low[0]; x++)
                out[n++] = (uint32_t)(row + side[0][x]);
        }
    return n;
}

static void reach(const brink_cells *c, int low[3], int high[3])
{
    for (int a = 0; a < 3; a++) {
        high[a] = c->count[a] > 1;
        low[a] = -high[a];
    }
}

int brink_cells_create(brink_cells *c, const brink_system *system, double reach)
{
    memset(c, 0, sizeof *c);
    c->particles = system->count;
    choose(c, system, reach);
    // Each further bucket comes after a full one, which no other comes after.
    const uint32_t further = c->particles / BRINK_BUCKET;
    c->bucket = calloc((size_t)c->total + further, sizeof *c->bucket);
    c->cell = malloc(c->particles * sizeof *c->cell);
    if (!c->bucket || !c->cell || build_walls(c)) {
        brink_cells_destroy(c);
        return -1;
    }
    c->free = c->total;
    for (uint32_t k = 0; k < further; k++)
        c->bucket[c->total + k].fill = c->total + k + 1;
    for (uint32_t i = 0; i < c->particles; i++)
        enter(c, i, brink_cells_at(c, system->particle[i].x));
    return 0;
}

void brink_cells_destroy(brink_cells *c)
{
    for (int a = 0; a < 3; a++)
        free(c->wall[a]);
    free(c->bucket);
    free(c->cell);
    memset(c, 0, sizeof *c);
}

const char *brink_cells_is_valid(const brink_cells *c)
{
    uint32_t filed = 0, who[BRINK_HANDFUL];
    for (uint32_t cell = 0; cell < c->total; cell++) {
        brink_tour tour = brink_tour_of(&cell, 1);
        for (int n; (n = brink_tour_next(c, &tour, who)) > 0;) {
            filed += (uint32_t)n;
            if (filed > c->particles)
                return "more particles are in cells than there are";
            for (int k = 0; k < n; k++)
                if (who[k] >= c->particles || c->cell[who[k]] != cell)
                    return "a cell and its particles disagree";
        }
    }
    return filed == c->particles ? NULL : "a particle is in no cell";
}

void brink_cells_place(brink_cells *c, uint32_t i, uint32_t cell)
{
    leave(c, i);
    enter(c, i, cell);
}

// A cell's walls on one axis, and what a particle in it has to do with them.
typedef struct gap {
    double below, above; // how far the particle is from them
    double v;
} gap;

// When a particle meets the wall ahead [S16 eq. 4], from its own time on.  Gap
// and speed have one sign, or it is beyond the wall by a rounding.
static double time_to_wall(gap g)
{
    if (g.v == 0)
        return (double)INFINITY;
    return (g.v > 0 ? g.above : -g.below) / g.v;
}

// Which walls come within reach some time from dt to dt_then; both do of a
// particle that rests for good, whose 0 * inf is no number.
static void look(gap g, double dt, double dt_then, double reach, int *low,
                 int *high)
{
    const double from = g.v * dt, to = g.v * dt_then;
    *low = -!((g.below + from > reach) & (g.below + to > reach));
    *high = !((g.above - from > reach) & (g.above - to > reach));
}

void brink_cells_stay(const brink_cells *c, const brink_system *system,
                      uint32_t i, double offset, brink_stay *stay)
{
    const brink_particle *p = &system->particle[i];
    int low[3], high[3], index[3], first = 0;
    gap gaps[3];
    double soonest = (double)INFINITY;
    reach(c, low, high);
    split(c, c->cell[i], index);
    for (int a = 0; a < system->dimensions; a++) {
        // NOLINTNEXTLINE(clang-analyzer-core.*): at most three dimensions
        const uint64_t *wall = &c->wall[a][index[a]];
        const double unit = system->unit[a];
        gaps[a] = (gap){(double)(int64_t)(p->x[a] - wall[0]) * unit,
                        (double)(int64_t)(wall[1] - p->x[a]) * unit, p->v[a]};
        const double t = time_to_wall(gaps[a]);
        // Chosen, not branched to: no processor could foresee which.
        first = t < soonest ? a : first;
        soonest = t < soonest ? t : soonest;
    }
    const double until = soonest + p->since;
    stay->until = until > offset ? until : offset;
    // NOLINTNEXTLINE(clang-analyzer-core.*): at least two dimensions
    stay->crossing = (brink_crossing){first, gaps[first].v > 0 ? 1 : -1};
    for (int a = 0; a < system->dimensions; a++)
        if (c->images[a] == 1)
            look(gaps[a], offset - p->since, stay->until - p->since, c->reach,
                 &low[a], &high[a]);
    stay->cells = block(c, index, low, high, stay->near);
}

int brink_cells_cross(brink_cells *c, uint32_t i, brink_crossing crossing)
{
    int index[3];
    split(c, c->cell[i], index);
    if (!brink_cell_next(index[crossing.axis], c->count[crossing.axis],
                         crossing.way, 1, &index[crossing.axis]))
        return 0;
    brink_cells_place(c, i, join(c, index));
    return 1;
}

int brink_cells_around(const brink_cells *c, uint32_t cell, uint32_t around[27])
{
    int low[3], high[3], index[3];
    reach(c, low, high);
    split(c, cell, index);
    return block(c, index, low, high, around);
}

int brink_tour_further(const brink_cells *c, brink_tour *tour,
                       uint32_t who[BRINK_HANDFUL])
{
    uint32_t n = 0, at = tour->further;
    while (at > BRINK_BUCKET && n <= BRINK_HANDFUL - BRINK_BUCKET) {
        const brink_bucket *b = &c->bucket[at];
        at = b->fill;
        for (uint32_t k = 0; k < BRINK_BUCKET && k < at; k++)
            who[n++] = b->who[k];
    }
    tour->further = at > BRINK_BUCKET ? at : 0;
    if (!tour->further) {
        tour->cell++;
        tour->cells--;
    }
    return (int)n;
}
