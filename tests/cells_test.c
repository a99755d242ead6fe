// SPDX-License-Identifier: MIT
#include "cells.h"
#include "suite.h"
#include <brink/event_time.h>
#include <gsl/gsl_rng.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const brink_potential hard = {1, (const double[]){1},
                                     (const double[]){(double)INFINITY}};

static void make(brink_system *s, int dimensions, double x, double y, double z,
                 uint32_t count, gsl_rng *rng)
{
    const brink_species species = {"A", 1, 1, count};
    const double box[3] = {x, y, z};
    ck_assert_int_eq(
        brink_system_create(s, dimensions, box, 1.0, count, 1, &species, &hard),
        0);
    for (uint32_t i = 0; i < count; i++)
        for (int a = 0; a < dimensions; a++) {
            s->particle[i].x[a] =
                (uint64_t)gsl_rng_get(rng) << 32 | gsl_rng_get(rng);
            s->particle[i].v[a] = gsl_rng_uniform(rng) - 0.5;
        }
}

static gsl_rng *seeded(unsigned long seed)
{
    printf("seed %lu\n", seed);
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(rng, seed);
    return rng;
}

START_TEST(cells_are_wider_than_the_interaction_or_three_with_images)
{
    gsl_rng *rng = seeded(1);
    brink_system s;
    brink_cells c;
    make(&s, 3, 30, 4.9, 5.1, 5000, rng);
    ck_assert_int_eq(brink_cells_create(&c, &s, s.range), 0);
    ck_assert_int_eq(c.count[0],
                     29); // 30 cells of exactly the range have no slack
    ck_assert_int_eq(c.images[0], 1);
    ck_assert_int_eq(c.count[1],
                     3); // 4 would fit, but not be enough for one image
    ck_assert_int_eq(c.images[1], 3);
    ck_assert_int_eq(c.count[2], 5);
    ck_assert_int_eq(c.images[2], 1);
    brink_cells_destroy(&c);
    brink_system_destroy(&s);
    make(&s, 2, 1000, 1000, 1, 100, rng); // dilute: as many cells as particles
    ck_assert_int_eq(brink_cells_create(&c, &s, s.range), 0);
    ck_assert_int_eq(c.count[0], 10);
    ck_assert_int_eq(c.count[2], 1);
    ck_assert_int_eq(c.images[2], 1);
    brink_cells_destroy(&c);
    brink_system_destroy(&s);
    gsl_rng_free(rng);
}
END_TEST

// Every pair within the range of each other is in adjacent cells.
START_TEST(whoever_is_in_range_is_adjacent)
{
    gsl_rng *rng = seeded(2);
    for (int dimensions = 2; dimensions <= 3; dimensions++) {
        brink_system s;
        brink_cells c;
        uint32_t around[27], who[BRINK_HANDFUL];
        double r[3];
        make(&s, dimensions, 12, 9, dimensions == 3 ? 4 : 1, 500, rng);
        ck_assert_int_eq(brink_cells_create(&c, &s, s.range), 0);
        for (uint32_t i = 0; i < s.count; i++) {
            uint8_t adjacent[500] = {0};
            brink_tour tour = brink_tour_around(&c, i, around);
            for (int n; (n = brink_tour_next(&c, &tour, who)) > 0;)
                for (int k = 0; k < n; k++)
                    ck_assert_msg(!adjacent[who[k]]++, "%u twice around %u",
                                  who[k], i);
            for (uint32_t j = 0; j < s.count; j++) {
                brink_system_separation(&s, i, j, 0.0, r);
                if (r[0] * r[0] + r[1] * r[1] + r[2] * r[2] <= 1)
                    ck_assert_msg(adjacent[j], "%u and %u", i, j);
            }
        }
        brink_cells_destroy(&c);
        brink_system_destroy(&s);
    }
    gsl_rng_free(rng);
}
END_TEST

static double crossing_of(const brink_cells *c, const brink_system *s, uint32_t i,
                          double offset, brink_crossing *crossing)
{
    brink_stay stay;
    brink_cells_stay(c, s, i, offset, &stay);
    *crossing = stay.crossing;
    return stay.until;
}

static int is_among(uint32_t cell, const uint32_t *cells, int count)
{
    for (int k = 0; k < count; k++)
        if (cells[k] == cell)
            return 1;
    return 0;
}

// Everybody whom a particle meets before either crosses a wall is in a near cell;
// and not every adjacent cell is near, or there would be no point in it.
START_TEST(whoever_is_met_before_a_crossing_is_near)
{
    gsl_rng *rng = seeded(3);
    brink_system s;
    brink_cells c;
    int met = 0, spared = 0;
    make(&s, 3, 12, 13, 4, 300, rng);
    ck_assert_int_eq(brink_cells_create(&c, &s, s.range), 0);
    for (uint32_t i = 0; i < s.count; i++) {
        brink_stay stay;
        brink_crossing way;
        brink_cells_stay(&c, &s, i, 0.0, &stay);
        const double then = stay.until;
        spared += 27 - stay.cells;
        for (uint32_t j = 0; j < s.count; j++) {
            double r[3], v[3];
            brink_system_separation(&s, i, j, 0.0, r);
            for (int a = 0; a < 3; a++)
                v[a] = s.particle[i].v[a] - s.particle[j].v[a];
            const double t = brink_intersection_time(r, v, 1.0);
            if (i == j || !(t < fmin(then, crossing_of(&c, &s, j, 0.0, &way))))
                continue;
            met++;
            ck_assert_msg(is_among(c.cell[j], stay.near, stay.cells),
                          "%u meets %u at %a", i, j, t);
        }
    }
    ck_assert_msg(met > 100 && spared > 1000, "met %d, spared %d", met, spared);
    brink_cells_destroy(&c);
    brink_system_destroy(&s);
    gsl_rng_free(rng);
}
END_TEST

START_TEST(all_is_near_to_a_particle_at_rest_in_the_middle_of_small_cells)
{
    gsl_rng *rng = seeded(8);
    brink_system s;
    brink_cells c;
    brink_stay stay;
    make(&s, 3, 8, 8, 8, 4000, rng); // cells of 8/7, less than twice the range
    ck_assert_int_eq(brink_cells_create(&c, &s, s.range), 0);
    for (int a = 0; a < 3; a++) {
        s.particle[3].v[a] = 0;
        s.particle[3].x[a] = UINT64_C(1) << 63;
    }
    brink_cells_destroy(&c);
    ck_assert_int_eq(brink_cells_create(&c, &s, s.range), 0);
    brink_cells_stay(&c, &s, 3, 0.0, &stay);
    ck_assert(isinf(stay.until));
    ck_assert_int_eq(stay.cells, 27);
    brink_cells_destroy(&c);
    brink_system_destroy(&s);
    gsl_rng_free(rng);
}
END_TEST

// Followed through its crossings, a particle is where its cell says, or nearly.
START_TEST(crossings_keep_the_cell_in_step_with_the_position)
{
    gsl_rng *rng = seeded(4);
    brink_system s;
    brink_cells c;
    make(&s, 3, 8, 3, 11, 300, rng);
    ck_assert_int_eq(brink_cells_create(&c, &s, s.range), 0);
    for (uint32_t i = 0; i < s.count; i++)
        for (int n = 0; n < 200; n++) {
            brink_particle *p = &s.particle[i];
            brink_crossing crossing = {0, 0};
            const double then = crossing_of(&c, &s, i, p->since, &crossing);
            ck_assert(then >= p->since && isfinite(then));
            brink_system_advance(&s, i, then);
            p->since = 0; // every flight starts a year of its own
            ck_assert_int_eq(brink_cells_cross(&c, i, crossing), 1);
            const int index =
                (int)(crossing.axis == 0   ? c.cell[i] % (uint32_t)c.count[0]
                      : crossing.axis == 1 ? c.cell[i] / (uint32_t)c.count[0] %
                                                 (uint32_t)c.count[1]
                                           : c.cell[i] / (uint32_t)c.count[0] /
                                                 (uint32_t)c.count[1]);
            const uint64_t wall =
                c.wall[crossing.axis][index + (crossing.way < 0)];
            const double off =
                fabs((double)(int64_t)(p->x[crossing.axis] - wall) *
                     s.unit[crossing.axis]);
            // gap, dt, product and quotient by the length round once each,
            // relative to a flight of at most a cell; positions to a unit.
            const double width = s.length[crossing.axis] / c.count[crossing.axis];
            ck_assert_msg(off <= 5 * width * 0x1p-53 + 2 * s.unit[crossing.axis],
                          "particle %u is %a from the wall", i, off);
        }
    ck_assert_ptr_null(brink_cells_is_valid(&c));
    brink_cells_destroy(&c);
    brink_system_destroy(&s);
    gsl_rng_free(rng);
}
END_TEST

START_TEST(a_particle_at_rest_never_crosses)
{
    gsl_rng *rng = seeded(5);
    brink_system s;
    brink_cells c;
    brink_crossing crossing;
    make(&s, 3, 8, 8, 8, 10, rng);
    for (int a = 0; a < 3; a++)
        s.particle[3].v[a] = 0;
    ck_assert_int_eq(brink_cells_create(&c, &s, s.range), 0);
    ck_assert(isinf(crossing_of(&c, &s, 3, 0.0, &crossing)));
    brink_cells_destroy(&c);
    brink_system_destroy(&s);
    gsl_rng_free(rng);
}
END_TEST

START_TEST(a_particle_beyond_its_wall_by_a_rounding_crosses_at_once)
{
    gsl_rng *rng = seeded(7);
    brink_system s;
    brink_cells c;
    brink_crossing crossing;
    make(&s, 3, 8, 8, 8, 10, rng);
    ck_assert_int_eq(brink_cells_create(&c, &s, s.range), 0);
    brink_particle *p = &s.particle[3];
    p->v[0] = 0.5, p->v[1] = p->v[2] = 0;
    p->x[0] = c.wall[0][c.cell[3] % (uint32_t)c.count[0] + 1] + 5;
    const double then = crossing_of(&c, &s, 3, 0.25, &crossing);
    ck_assert_msg(then == 0.25 && crossing.axis == 0 && crossing.way == 1,
                  "at %a", then);
    brink_cells_destroy(&c);
    brink_system_destroy(&s);
    gsl_rng_free(rng);
}
END_TEST

START_TEST(along_an_axis_with_images_all_cells_are_near)
{
    gsl_rng *rng = seeded(10);
    brink_system s;
    brink_cells c;
    make(&s, 3, 12, 13, 4, 100, rng);
    ck_assert_int_eq(brink_cells_create(&c, &s, s.range), 0);
    const uint32_t layer = (uint32_t)(c.count[0] * c.count[1]);
    for (uint32_t i = 0; i < s.count; i++) {
        brink_stay stay;
        brink_cells_stay(&c, &s, i, 0.0, &stay);
        for (int k = 0; k < stay.cells; k++)
            ck_assert_msg(
                is_among((stay.near[k] + layer) % c.total, stay.near, stay.cells),
                "cell %u is near to %u, the one above it is not", stay.near[k],
                i);
    }
    brink_cells_destroy(&c);
    brink_system_destroy(&s);
    gsl_rng_free(rng);
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "cells", 60, cells_are_wider_than_the_interaction_or_three_with_images,
        whoever_is_in_range_is_adjacent, whoever_is_met_before_a_crossing_is_near,
        all_is_near_to_a_particle_at_rest_in_the_middle_of_small_cells,
        crossings_keep_the_cell_in_step_with_the_position,
        a_particle_at_rest_never_crosses,
        a_particle_beyond_its_wall_by_a_rounding_crosses_at_once,
        along_an_axis_with_images_all_cells_are_near);
}
