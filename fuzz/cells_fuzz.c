// SPDX-License-Identifier: MIT
// Particles moved from cell to cell, against a plain list of where each is: who
// is in a cell, which cells are around one, and the walls between them.
#include "adverse.h"
#include "cells.h"
#include "fuzz.h"
#include <string.h>

enum { STEPS = 150 };

typedef struct grid {
    brink_system system;
    brink_cells c;
    uint32_t index[ADVERSE_MOST][3]; // of each particle's cell, by the log
} grid;

static _Noreturn void broken(const grid *g, const char *law)
{
    FINDING("cells: %s", law);
    fprintf(stderr, "  // %d x %d x %d cells, wider than %a\n", g->c.count[0],
            g->c.count[1], g->c.count[2], g->c.reach);
    adverse_tell(&g->system);
    finding_end();
}

static uint32_t number_of(const grid *g, const uint32_t index[3])
{
    const uint32_t nx = (uint32_t)g->c.count[0], ny = (uint32_t)g->c.count[1];
    return index[0] + nx * (index[1] + ny * index[2]);
}

/** Lower wall <= x < upper wall, by the walls and by the fraction of the box. */
static void place_by_position(grid *g, uint32_t i)
{
    const uint64_t *x = g->system.particle[i].x;
    for (int a = 0; a < 3; a++) {
        const uint64_t n = (uint64_t)g->c.count[a], *wall = g->c.wall[a];
        uint64_t k = 0;
        while (k + 1 < n && x[a] >= wall[k + 1])
            k++;
        const unsigned __int128 scaled = (unsigned __int128)x[a] * n;
        if (scaled >> 64 != k || wall[0] != 0 || wall[n] != 0)
            broken(g, "walls part the box into equal parts");
        g->index[i][a] = (uint32_t)k;
    }
    if (brink_cells_at(&g->c, x) != number_of(g, g->index[i]))
        broken(g, "a position is in the cell between whose walls it is");
}

static void check_size(const grid *g)
{
    const brink_cells *c = &g->c;
    uint32_t total = 1;
    for (int a = 0; a < 3; a++) {
        const int there = a < g->system.dimensions, n = c->count[a];
        const int images = there && n == 3 ? 3 : 1;
        total *= (uint32_t)n;
        if (there ? n != 3 && n < 5 : n != 1)
            broken(g, "an axis has three cells, or five and more");
        if (c->images[a] != images)
            broken(g, "images are looked for where there are three cells");
        if (n >= 5 && !(g->system.length[a] / n > g->system.range))
            broken(g, "cells are wider than the interaction");
    }
    if (c->total != total)
        broken(g, "all cells are counted");
}

/** Everybody in it, once, and nobody else. */
static void check_cell(const grid *g, uint32_t cell)
{
    uint8_t seen[ADVERSE_MOST] = {0};
    uint32_t who[BRINK_HANDFUL];
    brink_tour tour = brink_tour_of(&cell, 1);
    for (int n; (n = brink_tour_next(&g->c, &tour, who)) > 0;)
        for (int k = 0; k < n; k++)
            if (who[k] >= g->system.count || seen[who[k]]++)
                broken(g, "a cell holds a particle once");
    for (uint32_t i = 0; i < g->system.count; i++)
        if (seen[i] != (number_of(g, g->index[i]) == cell))
            broken(g, "a cell holds those who are in it, and nobody else");
}

static int is_near(uint32_t a, uint32_t b, uint32_t count)
{
    const uint32_t apart = a > b ? a - b : b - a;
    return apart <= 1 || apart == count - 1;
}

/** Of i: all within one step along each axis, round the box, and each once. */
static void check_around(const grid *g, uint32_t i)
{
    uint8_t seen[ADVERSE_MOST] = {0};
    uint32_t around[27], who[BRINK_HANDFUL];
    const int d = g->system.dimensions, cells = d == 3 ? 27 : 9;
    if (brink_cells_around(&g->c, g->c.cell[i], around) != cells)
        broken(g, "27 cells are around one, on a plane 9");
    for (int k = 0; k < cells; k++)
        for (int m = 0; m < k; m++)
            if (around[k] == around[m] || around[k] >= g->c.total)
                broken(g, "cells around one are others");
    brink_tour tour = brink_tour_around(&g->c, i, around);
    for (int n; (n = brink_tour_next(&g->c, &tour, who)) > 0;)
        for (int k = 0; k < n; k++)
            if (who[k] >= g->system.count || seen[who[k]]++)
                broken(g, "a tour comes by everybody once");
    for (uint32_t j = 0; j < g->system.count; j++) {
        int near = 1;
        for (int a = 0; a < 3; a++)
            near &=
                is_near(g->index[i][a], g->index[j][a], (uint32_t)g->c.count[a]);
        if (near != seen[j])
            broken(g, "a tour comes by those in adjacent cells, and nobody else");
    }
}

static void cross(grid *g, stream *s, uint32_t i)
{
    const brink_crossing way = {stream_int(s, 0, g->system.dimensions - 1),
                                stream_int(s, 0, 1) ? 1 : -1};
    const brink_crossing again = brink_crossing_of(brink_crossing_number(way));
    uint32_t *index = &g->index[i][way.axis];
    const uint32_t count = (uint32_t)g->c.count[way.axis];
    *index = (*index + (way.way > 0 ? 1 : count - 1)) % count;
    if (again.axis != way.axis || again.way != way.way)
        broken(g, "a crossing is a number and back");
    if (!brink_cells_cross(&g->c, i, way))
        broken(g, "a crossing is refused");
}

static void move(grid *g, stream *s, uint32_t i)
{
    const uint32_t to = (uint32_t)stream_int(s, 0, (int)g->system.count - 1);
    switch (stream_int(s, 0, 3)) {
    case 0: // where another is, until a cell has many
        memcpy(g->index[i], g->index[to], sizeof g->index[i]);
        brink_cells_place(&g->c, i, number_of(g, g->index[i]));
        break;
    case 1: // anywhere
        for (int a = 0; a < 3; a++)
            g->index[i][a] = (uint32_t)stream_int(s, 0, g->c.count[a] - 1);
        brink_cells_place(&g->c, i, number_of(g, g->index[i]));
        break;
    default:
        cross(g, s, i);
        break;
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static grid g;
    stream s = stream_of_bytes(data, size);
    adverse_make(&s, &g.system);
    LAW(brink_cells_create(&g.c, &g.system, g.system.range) == 0,
        "cells: memory is out");
    check_size(&g);
    for (uint32_t i = 0; i < g.system.count; i++)
        place_by_position(&g, i);
    for (int n = stream_int(&s, 0, STEPS); n > 0; n--) {
        const uint32_t i = (uint32_t)stream_int(&s, 0, (int)g.system.count - 1);
        const uint32_t left = g.c.cell[i];
        move(&g, &s, i);
        if (g.c.cell[i] != number_of(&g, g.index[i]))
            broken(&g, "a particle is in the cell that it was moved to");
        check_cell(&g, left);
        check_cell(&g, g.c.cell[i]);
        check_around(&g, i);
    }
    const char *fault = brink_cells_is_valid(&g.c);
    if (fault)
        broken(&g, fault);
    brink_cells_destroy(&g.c);
    brink_system_destroy(&g.system);
    return 0;
}
