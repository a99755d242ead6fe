// SPDX-License-Identifier: MIT
#include "start_crowd.h"
#include "scene_species.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

// Cells along an axis: the quotient of the box by the width, a little less than
// what its two roundings could have made too much.
static uint32_t cells_along(double length, double width)
{
    const double n = floor(length / width * (1 - 0x1p-50));
    return n < 1 ? 1 : (uint32_t)n;
}

int brink_crowd_create(brink_crowd *c, const brink_system *system)
{
    const int pairs = system->species_count * system->species_count;
    const double each = brink_system_volume(system) / system->count;
    double width = system->dimensions == 3 ? cbrt(each) : sqrt(each);
    size_t total = 1;
    *c = (brink_crowd){.system = system, .cells = {1, 1, 1}};
    for (int p = 0; p < pairs; p++)
        width = fmax(width, brink_species_core(&system->potential[p]));
    for (int a = 0; a < system->dimensions; a++)
        total *= c->cells[a] = cells_along(system->length[a], width);
    c->first = malloc(total * sizeof *c->first);
    c->next = malloc(system->count * sizeof *c->next);
    if (!c->first || !c->next) {
        brink_crowd_destroy(c);
        return -1;
    }
    memset(c->first, 0xff, total * sizeof *c->first); // BRINK_ALONE
    return 0;
}

void brink_crowd_destroy(brink_crowd *c)
{
    free(c->first);
    free(c->next);
    memset(c, 0, sizeof *c);
}

// floor(x cells / 2^64), exactly: both halves of the product fit, with cells <
// 2^32.
static uint32_t place(uint64_t x, uint32_t cells)
{
    const uint64_t high = (x >> 32) * cells, low = (x & UINT32_MAX) * cells;
    return (uint32_t)((high + (low >> 32)) >> 32);
}

static size_t cell_of(const brink_crowd *c, const uint32_t at[3])
{
    return at[0] + c->cells[0] * (at[1] + (size_t)c->cells[1] * at[2]);
}

static int overlaps(const brink_system *s, uint32_t i, uint32_t j)
{
    const brink_potential *p = brink_system_potential(s, i, j);
    double r[3];
    brink_system_separation(s, i, j, 0.0, r);
    return brink_species_core(p) > 0 && brink_step_level_at(p, r) == p->count;
}

// The cells next to cell k along an axis, itself among them; one or two where
// there are no more.
static int adjacent(uint32_t k, uint32_t cells, uint32_t around[3])
{
    const uint32_t count = cells < 3 ? cells : 3;
    const uint32_t from = cells < 3 ? 0 : k + cells - 1;
    for (uint32_t m = 0; m < count; m++)
        around[m] = (from + m) % cells;
    return (int)count;
}

uint32_t brink_crowd_overlap(const brink_crowd *c, uint32_t i)
{
    uint32_t around[3][3];
    int count[3];
    for (int a = 0; a < 3; a++)
        count[a] = adjacent(place(c->system->particle[i].x[a], c->cells[a]),
                            c->cells[a], around[a]);
    for (int z = 0; z < count[2]; z++)
        for (int y = 0; y < count[1]; y++)
            for (int x = 0; x < count[0]; x++) {
                const uint32_t at[3] = {around[0][x], around[1][y], around[2][z]};
                for (uint32_t j = c->first[cell_of(c, at)]; j != BRINK_ALONE;
                     j = c->next[j])
                    if (overlaps(c->system, i, j))
                        return j;
            }
    return BRINK_ALONE;
}

void brink_crowd_add(brink_crowd *c, uint32_t i)
{
    uint32_t at[3];
    for (int a = 0; a < 3; a++)
        at[a] = place(c->system->particle[i].x[a], c->cells[a]);
    const size_t cell = cell_of(c, at);
    c->next[i] = c->first[cell];
    c->first[cell] = i;
}
