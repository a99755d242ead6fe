// SPDX-License-Identifier: MIT
#include "neighbours.h"
#include "suite.h"
#include "systems.h"
#include <math.h>
#include <stdio.h>

static int is_listed(const brink_neighbours *n, uint32_t i, uint32_t j)
{
    int times = 0;
    for (uint32_t k = 0; k < brink_neighbours_count(n, i); k++)
        times += brink_neighbours_of(n, i)[k] == j;
    return times;
}

// The distance of two homes, nearest images.
static double between_homes(const brink_run *run, uint32_t i, uint32_t j)
{
    const brink_home *p = &run->neighbours.home[i], *q = &run->neighbours.home[j];
    double square = 0;
    for (int a = 0; a < 3; a++) {
        const double length = run->system.length[a];
        const double d =
            (double)(int32_t)(p->x[a] - q->x[a]) * ldexp(length, -32);
        square += d * d;
    }
    return sqrt(square);
}

// Of all pairs, without cells: those are listed, by both and once, whose homes
// are nearer than their potential reaches and two balls.  What differs by less
// than the slack may be either.
static void lists_are_right(const brink_run *run)
{
    const brink_system *s = &run->system;
    const brink_neighbours *n = &run->neighbours;
    for (uint32_t i = 0; i < s->count; i++)
        for (uint32_t j = i + 1; j < s->count; j++) {
            const double reach =
                brink_system_potential(s, i, j)->distance[0] + 2 * n->radius;
            const double distance = between_homes(run, i, j);
            const int near = distance < reach, listed = is_listed(n, i, j);
            ck_assert_int_eq(listed, is_listed(n, j, i));
            if (fabs(distance - reach) > 0x1p-18 * reach)
                ck_assert_msg(listed == near, "%u and %u at %a: %d times", i, j,
                              distance, listed);
        }
}

START_TEST(those_are_listed_who_could_meet_and_nobody_else)
{
    const char *const scenes[] = {crowded_spheres, crowded_mixture};
    for (int k = 0; k < 2; k++) {
        brink_run run;
        make_run(&run, scenes[k]);
        ck_assert_double_gt(run.neighbours.radius, 0);
        for (uint64_t events = 0; events <= 20000; events += 10000) {
            advance(&run, events);
            lists_are_right(&run);
            ck_assert_ptr_null(brink_run_is_valid(&run));
        }
        ck_assert_uint_gt(run.tally.cell, 1000); // departures
        brink_run_destroy(&run);
    }
}
END_TEST

// At that time it is on the edge of the ball, to the rounding of the flight: a
// few 2^-53 of distances and speeds below 16.
START_TEST(a_particle_departs_from_the_edge_of_its_ball)
{
    brink_run run;
    make_run(&run, crowded_spheres);
    advance(&run, 5000);
    for (uint32_t i = 0; i < run.system.count; i++) {
        const brink_particle *p = &run.system.particle[i];
        const double until =
            brink_neighbours_until(&run.neighbours, &run.system, i, 0.0);
        double square = 0;
        for (int a = 0; a < 3; a++) {
            const uint64_t home = (uint64_t)run.neighbours.home[i].x[a] << 32;
            const double r =
                (double)(int64_t)(p->x[a] - home) * run.system.unit[a] +
                p->v[a] * (until - p->since);
            square += r * r;
        }
        ck_assert_double_ge(until, p->since);
        ck_assert_double_eq_tol(sqrt(square), run.neighbours.radius, 0x1p-45);
        ck_assert_double_eq(
            brink_neighbours_until(&run.neighbours, &run.system, i, until + 1),
            until + 1);
    }
    brink_run_destroy(&run);
}
END_TEST

START_TEST(who_departs_is_at_home_where_it_is_and_listed_by_those_there)
{
    brink_run run;
    make_run(&run, crowded_mixture);
    // Far away, where all its neighbours are others.
    brink_particle *p = &run.system.particle[7];
    for (int a = 0; a < 3; a++)
        p->x[a] += UINT64_C(1) << 63;
    ck_assert_ptr_nonnull(brink_run_is_valid(&run));
    ck_assert_int_eq(
        brink_neighbours_depart(&run.neighbours, &run.cells, &run.system, 7), 0);
    ck_assert_ptr_null(brink_run_is_valid(&run));
    lists_are_right(&run);
    brink_run_destroy(&run);
}
END_TEST

START_TEST(the_check_sees_a_list_without_a_neighbour)
{
    brink_run run;
    make_run(&run, crowded_spheres);
    brink_lists_remove(&run.neighbours.who, 3, 0);
    ck_assert_ptr_nonnull(brink_run_is_valid(&run));
    brink_run_destroy(&run);
}
END_TEST

START_TEST(lists_are_kept_where_it_is_crowded_and_the_box_is_large_enough)
{
    const char *const cells[] = {hard_spheres, square_well,
                                 // as crowded as can be, four balls across
                                 "box: {packing_fraction: 0.5}\n"
                                 "species: {A: {count: 108, diameter: 1}}\n"};
    brink_system s;
    for (int k = 0; k < 3; k++) {
        make_system(&s, cells[k]);
        ck_assert_double_eq(brink_neighbours_radius(&s), 0);
        brink_system_destroy(&s);
    }
    make_system(&s, crowded_mixture);
    // A quarter of the distance between particles, which is 1.461, the cube root
    // of 12 * 11.5 * 11.3 / 500, in 64ths of 1.5.
    ck_assert_double_eq(brink_neighbours_radius(&s), 16.0 / 64 * 1.5);
    brink_system_destroy(&s);
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "neighbours", 120, those_are_listed_who_could_meet_and_nobody_else,
        a_particle_departs_from_the_edge_of_its_ball,
        who_departs_is_at_home_where_it_is_and_listed_by_those_there,
        the_check_sees_a_list_without_a_neighbour,
        lists_are_kept_where_it_is_crowded_and_the_box_is_large_enough);
}
