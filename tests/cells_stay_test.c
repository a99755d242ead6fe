// SPDX-License-Identifier: MIT
// A stay against what it is made of, written down axis by axis: to the bit when
// it ends and by which wall; near is where a wall comes within reach on the way.
#include "cells_block.h"
#include "run.h"
#include "suite.h"
#include "systems.h"
#include <float.h>
#include <math.h>

// When a particle meets the wall ahead of it along an axis, from its own time on.
static double time_along(const brink_run *run, uint32_t i,
                         const uint32_t index[3], int a)
{
    const brink_particle *p = &run->system.particle[i];
    const uint64_t *wall = &run->cells.wall[a][index[a]];
    const double v = p->v[a], unit = run->system.unit[a];
    if (v == 0)
        return (double)INFINITY;
    return v > 0 ? (double)(int64_t)(wall[1] - p->x[a]) * unit / v
                 : -((double)(int64_t)(p->x[a] - wall[0]) * unit) / v;
}

static void expect_end(const brink_run *run, uint32_t i, double offset,
                       const brink_stay *stay)
{
    const brink_particle *p = &run->system.particle[i];
    uint32_t index[3];
    int first = 0;
    double t[3];
    brink_cells_split(&run->cells, run->cells.cell[i], index);
    for (int a = 0; a < 3; a++) {
        t[a] = a < run->system.dimensions ? time_along(run, i, index, a)
                                          : (double)INFINITY;
        if (t[a] < t[first])
            first = a;
    }
    const double until = fmax(t[first] + p->since, offset);
    ck_assert_msg(stay->until == until && stay->crossing.axis == first &&
                      stay->crossing.way == (p->v[first] > 0 ? 1 : -1),
                  "particle %u stays until %a, not %a, axis %d, not %d", i,
                  stay->until, until, stay->crossing.axis, first);
}

// Whether the cell beside i's, along the axis, is among those near to it.
static int has_near(const brink_run *run, uint32_t i, const brink_stay *stay,
                    int a, int way)
{
    const brink_cells *c = &run->cells;
    uint32_t own[3], other[3];
    brink_cells_split(c, c->cell[i], own);
    const uint32_t count = (uint32_t)c->count[a];
    const uint32_t beside = (own[a] + (way > 0 ? 1 : count - 1)) % count;
    for (int k = 0; k < stay->cells; k++) {
        brink_cells_split(c, stay->near[k], other);
        if (other[a] == beside)
            return 1;
    }
    return 0;
}

// The lower wall is near if it comes within reach at the start or the end of the
// way, and likewise the upper one.  Four roundings of numbers less than the box
// are left out of account: where they could matter, either answer is right.
static int expect_near(const brink_run *run, uint32_t i, double offset,
                       const brink_stay *stay)
{
    const brink_cells *c = &run->cells;
    const brink_particle *p = &run->system.particle[i];
    uint32_t index[3];
    int spared = 0;
    brink_cells_split(c, c->cell[i], index);
    for (int a = 0; a < run->system.dimensions; a++) {
        if (c->images[a] > 1 || !isfinite(stay->until))
            continue; // all are near
        const double unit = run->system.unit[a], v = p->v[a];
        const double error = 4 * DBL_EPSILON * run->system.length[a];
        const double from = v * (offset - p->since),
                     to = v * (stay->until - p->since);
        for (int way = -1; way <= 1; way += 2) {
            // NOLINTNEXTLINE(clang-analyzer-core.*): at most three dimensions
            const uint64_t wall = c->wall[a][index[a] + (way > 0)];
            const double gap = way * (double)(int64_t)(wall - p->x[a]) * unit;
            const double least = fmin(gap - way * from, gap - way * to);
            const int is_near = has_near(run, i, stay, a, way);
            spared += !is_near;
            ck_assert_msg(fabs(least - c->reach) <= error ||
                              is_near == (least < c->reach),
                          "particle %u comes to %a of the wall at %d of axis %d, "
                          "reach %a, near: %d",
                          i, least, way, a, c->reach, is_near);
        }
    }
    return spared;
}

// Of particles whose times are not their runs', and asked for later than that.
START_TEST(a_stay_is_what_it_is_made_of)
{
    static const char *const scenes[] = {hard_spheres, square_shoulder,
                                         discs_well, small_box, mixture};
    int spared = 0;
    for (size_t k = 0; k < sizeof scenes / sizeof *scenes; k++) {
        brink_run run;
        make_run(&run, scenes[k]);
        for (uint64_t events = 1000; events <= 5000; events += 1000) {
            advance(&run, events);
            for (uint32_t i = 0; i < run.system.count; i++) {
                brink_stay stay;
                brink_cells_stay(&run.cells, &run.system, i, run.now.offset,
                                 &stay);
                expect_end(&run, i, run.now.offset, &stay);
                spared += expect_near(&run, i, run.now.offset, &stay);
            }
        }
        brink_run_destroy(&run);
    }
    ck_assert_msg(spared > 1000, "%d cells are not near", spared);
}
END_TEST

// Along the diagonal of a cube of cells it meets three walls at once.
START_TEST(of_walls_that_are_met_at_once_the_first_axis_is_crossed)
{
    brink_run run;
    brink_stay stay;
    make_run(&run, hard_spheres);
    brink_particle *p = &run.system.particle[0];
    for (int a = 0; a < 3; a++) {
        p->x[a] = UINT64_C(1) << 63;
        p->v[a] = 1;
    }
    run.cells.cell[0] = brink_cells_at(&run.cells, p->x);
    brink_cells_stay(&run.cells, &run.system, 0, run.now.offset, &stay);
    ck_assert_int_eq(stay.crossing.axis, 0);
    brink_run_destroy(&run);
}
END_TEST

int main(void)
{
    return RUN_SUITE("cells_stay", 120, a_stay_is_what_it_is_made_of,
                     of_walls_that_are_met_at_once_the_first_axis_is_crossed);
}
