// SPDX-License-Identifier: MIT
#include "array.h"
#include "cells_block.h"
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
        c->adjacent[a] = c->count[a] > 1;
        c->always[a] = c->images[a] > 1;
    }
    for (int a = 0; a < 2; a++) // which every system has
        c->inverse[a] = UINT64_MAX / (unsigned)c->count[a] + 1;
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
    return brink_cells_join(c, index);
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

int brink_cells_create(brink_cells *c, const brink_system *system, double reach)
{
    memset(c, 0, sizeof *c);
    c->particles = system->count;
    choose(c, system, reach);
    // Each further bucket comes after a full one, which no other comes after.
    const uint32_t further = c->particles / BRINK_BUCKET;
    c->bucket = brink_array_create((size_t)c->total + further, sizeof *c->bucket);
    c->cell = brink_array_create(c->particles, sizeof *c->cell);
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

int brink_cells_cross(brink_cells *c, uint32_t i, brink_crossing crossing)
{
    uint32_t index[3];
    int next;
    brink_cells_split(c, c->cell[i], index);
    if (!brink_cell_next((int)index[crossing.axis], c->count[crossing.axis],
                         crossing.way, 1, &next))
        return 0;
    index[crossing.axis] = (uint32_t)next;
    brink_cells_place(c, i, brink_cells_join(c, index));
    return 1;
}

int brink_cells_around(const brink_cells *c, uint32_t cell, uint32_t around[27])
{
    uint32_t index[3];
    brink_cells_split(c, cell, index);
    return brink_cells_block(c, index, c->adjacent, c->adjacent, around);
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
