// SPDX-License-Identifier: MIT
// How long a particle stays in its cell, and near which others, against the same
// in long double.
#include "adverse.h"
#include "cells.h"
#include "fuzz.h"
#include <string.h>

#define EPS 0x1p-53

typedef struct visit {
    brink_system system;
    brink_cells c;
    uint32_t i, index[3];
    double offset;
    brink_stay stay;
} visit;

static _Noreturn void broken(const visit *v, const char *law)
{
    const brink_stay *y = &v->stay;
    FINDING("cells, stay: %s", law);
    fprintf(stderr,
            "  // particle %u at offset %a in cell %u, {%u, %u, %u} of %d x %d x "
            "%d: until %a, axis %d, way %d, %d near\n",
            v->i, v->offset, v->c.cell[v->i], v->index[0], v->index[1],
            v->index[2], v->c.count[0], v->c.count[1], v->c.count[2], y->until,
            y->crossing.axis, y->crossing.way, y->cells);
    adverse_tell(&v->system);
    finding_end();
}

/** How far it is from the two walls of an axis at its own time: exactly. */
static void gaps(const visit *v, int axis, long double *below, long double *above)
{
    const uint64_t x = v->system.particle[v->i].x[axis];
    const uint64_t *wall = &v->c.wall[axis][v->index[axis]];
    const long double unit = v->system.unit[axis];
    *below = (int64_t)(x - wall[0]) * unit;
    *above = (int64_t)(wall[1] - x) * unit;
}

/* When it meets the wall ahead on an axis, from its own time on: gap and unit are
 * rounded to doubles, their product, the quotient by the speed: 4, and 2^-64s. */
static long double time_to_wall(const visit *v, int axis)
{
    const double speed = v->system.particle[v->i].v[axis];
    long double below, above;
    if (axis >= v->system.dimensions || speed == 0)
        return (long double)(double)INFINITY;
    gaps(v, axis, &below, &above);
    return (speed > 0 ? above : below) / fabs(speed);
}

static void check_time(const visit *v)
{
    const brink_particle *p = &v->system.particle[v->i];
    const brink_stay *y = &v->stay;
    long double first = (long double)(double)INFINITY;
    for (int a = 0; a < 3; a++)
        first = fminl(first, time_to_wall(v, a));
    if (isinf(first)) {
        if (!isinf(y->until))
            broken(v, "who rests, or nearly, stays for good");
        return;
    }
    const long double by = time_to_wall(v, y->crossing.axis);
    const long double at = fmaxl(p->since + first, v->offset);
    const long double off =
        EPS * (4.01L * fabsl(by) + 4.01L * fabsl(first) + fabsl(at));
    if (fabsl(by - first) > off)
        broken(v, "the wall that is crossed is the first");
    if (!(y->until >= v->offset) || fabsl(y->until - at) > off)
        broken(v, "a stay ends at the wall, and not before it is asked for");
    if (y->crossing.way != (p->v[y->crossing.axis] > 0 ? 1 : -1))
        broken(v, "a wall is crossed the way the particle goes");
}

static int is_among(uint32_t cell, const uint32_t *cells, int count)
{
    int times = 0;
    for (int k = 0; k < count; k++)
        times += cells[k] == cell;
    return times;
}

/** Whether the wall on that side comes within reach of the way: 1, or 0; -1 where
 *  that hangs on the slack, which is 2^-20 of it, or on a rounding. */
static int comes_near(const visit *v, int axis, int way)
{
    const brink_particle *p = &v->system.particle[v->i];
    long double below, above;
    if (v->c.images[axis] > 1)
        return 1;
    gaps(v, axis, &below, &above);
    const long double gap = way < 0 ? below : above;
    const long double speed = way < 0 ? p->v[axis] : -p->v[axis];
    const long double from = gap + speed * (v->offset - p->since);
    const long double to =
        isinf(v->stay.until) ? from : gap + speed * (v->stay.until - p->since);
    const long double least = fminl(from, to), range = v->system.range;
    if (isinf(v->stay.until))
        return -1; // who rests has all, or some: nobody says
    return least <= range * (1 + 0x1p-21)   ? 1
           : least <= range * (1 + 0x1p-19) ? -1
                                            : 0;
}

/** Where `near` must be and must not be: on each axis the cell's own place is,
 *  and that below and above as far as the particle comes near. */
static void check_near(const visit *v)
{
    const int d = v->system.dimensions, depth = d == 3;
    for (int z = -depth; z <= depth; z++)
        for (int y = -1; y <= 1; y++)
            for (int x = -1; x <= 1; x++) {
                const int way[3] = {x, y, z};
                uint32_t at[3];
                int must = 1, may = 1;
                for (int a = 0; a < 3; a++) {
                    const uint32_t n = (uint32_t)v->c.count[a];
                    at[a] = (v->index[a] + n + (uint32_t)way[a]) % n;
                    const int near = way[a] ? comes_near(v, a, way[a]) : 1;
                    must &= near == 1;
                    may &= near != 0;
                }
                const uint32_t nx = (uint32_t)v->c.count[0];
                const uint32_t cell =
                    at[0] + nx * (at[1] + (uint32_t)v->c.count[1] * at[2]);
                const int listed = is_among(cell, v->stay.near, v->stay.cells);
                if (listed < must || listed > may)
                    broken(v, "near are the cells that it comes within range of");
            }
    for (int k = 0; k < v->stay.cells; k++)
        if (v->stay.near[k] >= v->c.total)
            broken(v, "near is a cell that there is not");
}

/** In its cell by position, or carried on a way that no wall has stopped. */
static void wander(visit *v, stream *s)
{
    brink_particle *p = &v->system.particle[v->i];
    if (stream_int(s, 0, 1)) {
        for (int n = stream_int(s, 0, 4); n > 0; n--) {
            brink_stay stay;
            brink_cells_stay(&v->c, &v->system, v->i, p->since, &stay);
            if (!(stay.until < v->system.year))
                break;
            brink_system_advance(&v->system, v->i, stay.until);
            brink_cells_cross(&v->c, v->i, stay.crossing);
        }
    }
    v->offset = p->since;
    if (stream_int(s, 0, 1)) // asked for later: some way on
        v->offset += (v->system.year - p->since) * stream_int(s, 0, 255) / 256;
    const uint32_t cell = v->c.cell[v->i], nx = (uint32_t)v->c.count[0],
                   ny = (uint32_t)v->c.count[1];
    v->index[0] = cell % nx;
    v->index[1] = cell / nx % ny;
    v->index[2] = cell / nx / ny;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static visit v;
    stream s = stream_of_bytes(data, size);
    adverse_make(&s, &v.system);
    LAW(brink_cells_create(&v.c, &v.system, v.system.range) == 0,
        "cells: memory is out");
    for (v.i = 0; v.i < v.system.count; v.i++) {
        wander(&v, &s);
        brink_cells_stay(&v.c, &v.system, v.i, v.offset, &v.stay);
        check_time(&v);
        check_near(&v);
    }
    brink_cells_destroy(&v.c);
    brink_system_destroy(&v.system);
    return 0;
}
