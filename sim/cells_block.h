// SPDX-License-Identifier: MIT
#ifndef BRINK_CELLS_BLOCK_H
#define BRINK_CELLS_BLOCK_H
/** Numbers of cells, by axes and in blocks: for the files of cells alone. */
#include "cells.h"

/** n / d for the divisor d >= 2 whose inverse is ceil(2^64 / d): exact, as n and
 * d are below 2^32. */
static inline uint32_t brink_quotient(uint32_t n, uint64_t inverse)
{
    return (uint32_t)(((unsigned __int128)inverse * n) >> 64);
}

static inline void brink_cells_split(const brink_cells *c, uint32_t cell,
                                     uint32_t index[3])
{
    const uint32_t row = brink_quotient(cell, c->inverse[0]);
    index[2] = brink_quotient(row, c->inverse[1]);
    index[1] = row - (uint32_t)c->count[1] * index[2];
    index[0] = cell - (uint32_t)c->count[0] * row;
}

static inline uint32_t brink_cells_join(const brink_cells *c,
                                        const uint32_t index[3])
{
    return index[0] +
           (uint32_t)c->count[0] * (index[1] + (uint32_t)c->count[1] * index[2]);
}

/** The cells around the one at `index`, wrapped round; on each axis its own
 * place, that below if low (0 or 1), and that above if high.  How many. */
static inline int brink_cells_block(const brink_cells *c, const uint32_t index[3],
                                    const uint32_t low[3], const uint32_t high[3],
                                    uint32_t out[27])
{
    uint32_t place[3][3], places[3], stride = 1;
    for (int a = 0; a < 3; a++) {
        const uint32_t count = (uint32_t)c->count[a], k = index[a];
        uint32_t n = 0;
        place[a][n] = stride * (k == 0 ? count - 1 : k - 1);
        n += low[a];
        place[a][n++] = stride * k;
        place[a][n] = stride * (k == count - 1 ? 0 : k + 1);
        places[a] = n + high[a];
        stride *= count;
    }
    int n = 0;
    for (uint32_t z = 0; z < places[2]; z++)
        for (uint32_t y = 0; y < places[1]; y++) {
            const uint32_t row = place[1][y] + place[2][z];
            for (uint32_t x = 0; x < places[0]; x++)
                out[n++] = row + place[0][x];
        }
    return n;
}
#endif
