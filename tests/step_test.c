// SPDX-License-Identifier: MIT
#include "suite.h"
#include <brink/step.h>
#include <float.h>
#include <limits.h>
#include <math.h>

#define INF ((double)INFINITY)
#define NaN ((double)NAN)

static const double distance[] = {3, 2, 1};
static const double soft_energy[] = {-1, 2, -3}, hard_energy[] = {-1, 2, INF};
static const brink_potential soft = {3, distance, soft_energy};
static const brink_potential hard = {3, distance, hard_energy};
static const double one = 1;
static const double infinite = INF;
static const brink_potential sphere = {1, &one, &infinite};

/** Where an event leads from a level, or -1 where it is refused; *next is then
 *  kept. */
static int next_of(const brink_potential *p, int level, int event)
{
    int next = 12345;
    int legal = brink_step_next(p, level, (enum brink_event_kind)event, &next);
    ck_assert(legal == 1 || (legal == 0 && next == level));
    ck_assert(legal == 0 || next >= 0); // below, -1 is for what is not legal
    return legal ? next : -1;
}

START_TEST(a_soft_potential_leads_where_it_should)
{
    static const int to[4][4] = {// core, capture, release, bounce from each level
                                 {-1, 1, -1, 0},
                                 {-1, 2, 0, 1},
                                 {-1, 3, 1, 2},
                                 {-1, -1, 2, 3}};
    ck_assert_int_eq(brink_potential_levels(&soft), 4);
    for (int level = 0; level < 4; level++)
        for (int event = 0; event < 4; event++)
            ck_assert_int_eq(next_of(&soft, level, event), to[level][event]);
}
END_TEST

START_TEST(a_hard_core_is_never_entered)
{
    static const int to[3][4] = {{-1, 1, -1, 0}, {-1, 2, 0, 1}, {2, -1, 1, 2}};
    ck_assert_int_eq(brink_potential_levels(&hard), 3);
    for (int level = 0; level < 3; level++)
        for (int event = 0; event < 4; event++)
            ck_assert_int_eq(next_of(&hard, level, event), to[level][event]);
}
END_TEST

START_TEST(hard_spheres_know_cores_alone)
{
    ck_assert_int_eq(brink_potential_levels(&sphere), 1);
    ck_assert_int_eq(next_of(&sphere, 0, BRINK_CORE), 0);
    ck_assert_int_eq(next_of(&sphere, 0, BRINK_CAPTURE), -1);
    ck_assert_int_eq(next_of(&sphere, 0, BRINK_RELEASE), -1);
    ck_assert_int_eq(next_of(&sphere, 0, BRINK_BOUNCE), -1);
}
END_TEST

START_TEST(a_square_well_is_left_or_bounced_in_and_has_a_core)
{
    static const int to[2][4] = {{-1, 1, -1, 0}, {1, -1, 0, 1}};
    static const double depth[] = {-1, INF};
    const brink_potential well = {2, distance, depth};
    for (int level = 0; level < 2; level++)
        for (int event = 0; event < 4; event++)
            ck_assert_int_eq(next_of(&well, level, event), to[level][event]);
}
END_TEST

START_TEST(what_is_no_level_or_no_event_is_refused)
{
    const brink_potential *potentials[] = {&soft, &hard, &sphere};
    const int strange[] = {INT_MIN, -1000, -1, 4, 5, 1000, INT_MAX};
    for (int p = 0; p < 3; p++)
        for (int k = 0; k < 7; k++)
            for (int event = -2; event < 7; event++)
                ck_assert_int_eq(next_of(potentials[p], strange[k], event), -1);
    ck_assert_int_eq(next_of(&hard, 3, BRINK_RELEASE), -1); // inside the core
    for (int event = 4; event < 100; event++)
        ck_assert_int_eq(next_of(&soft, 1, event), -1);
    ck_assert_int_eq(next_of(&soft, 1, -1), -1);
}
END_TEST

START_TEST(levels_change_by_one_and_energies_by_the_rise)
{
    const brink_potential *potentials[] = {&soft, &hard, &sphere};
    for (int k = 0; k < 3; k++) {
        const brink_potential *p = potentials[k];
        for (int level = -2; level < 6; level++) {
            int in = next_of(p, level, BRINK_CAPTURE);
            int out = next_of(p, level, BRINK_RELEASE);
            if (in >= 0) {
                ck_assert_int_eq(in, level + 1);
                ck_assert_double_eq(brink_step_rise(p, level, BRINK_INWARD),
                                    brink_potential_energy(p, in) -
                                        brink_potential_energy(p, level));
                ck_assert_int_eq(next_of(p, in, BRINK_RELEASE),
                                 level); // and back
            }
            if (out >= 0) {
                ck_assert_int_eq(out, level - 1);
                ck_assert_double_eq(brink_step_rise(p, level, BRINK_OUTWARD),
                                    -brink_step_rise(p, out, BRINK_INWARD));
            }
        }
    }
}
END_TEST

START_TEST(energies_and_rises_are_those_of_the_table)
{
    const double among[] = {12345, 1, 2, 12345}; // what is beside is not its
    const brink_potential inside = {2, distance, among + 1};
    ck_assert_double_eq(brink_potential_energy(&inside, 0), 0);
    ck_assert_double_eq(brink_potential_energy(&soft, 0), 0);
    ck_assert_double_eq(brink_potential_energy(&soft, 2), 2);
    ck_assert_double_eq(brink_potential_energy(&hard, 3), INF);
    ck_assert(isnan(brink_potential_energy(&soft, -1)));
    ck_assert(isnan(brink_potential_energy(&soft, 4)));
    ck_assert_double_eq(brink_step_rise(&soft, 0, BRINK_INWARD), -1);
    ck_assert_double_eq(brink_step_rise(&soft, 1, BRINK_INWARD), 3);
    ck_assert_double_eq(brink_step_rise(&soft, 1, BRINK_OUTWARD), 1);
    ck_assert_double_eq(brink_step_rise(&hard, 2, BRINK_INWARD), INF);
    ck_assert(isnan(brink_step_rise(&soft, 0, BRINK_OUTWARD)));
    ck_assert(isnan(brink_step_rise(&soft, 3, BRINK_INWARD)));
    ck_assert(isnan(brink_step_rise(&hard, 3, BRINK_OUTWARD)));
    ck_assert(isnan(brink_step_rise(&soft, INT_MAX, BRINK_INWARD)));
    ck_assert(isnan(brink_step_rise(&soft, INT_MIN, BRINK_OUTWARD)));
}
END_TEST

START_TEST(the_level_from_position_is_exact_and_the_surface_counts_as_outside)
{
    for (int k = 0; k < 3; k++) {
        const double at[3] = {0, distance[k], 0};
        ck_assert_int_eq(brink_step_level_at(&soft, at), k);
        const double in[3] = {0, nextafter(distance[k], 0), 0};
        ck_assert_int_eq(brink_step_level_at(&soft, in), k + 1);
        const double out[3] = {0, nextafter(distance[k], INF), 0};
        ck_assert_int_eq(brink_step_level_at(&soft, out), k);
    }
    const double origin[3] = {0, 0, 0};
    ck_assert_int_eq(brink_step_level_at(&hard, origin), 3);
}
END_TEST

static int is_valid(int count, const double *d, const double *e)
{
    return brink_potential_is_valid(&(brink_potential){count, d, e});
}

START_TEST(only_decreasing_distances_and_an_innermost_core_are_valid)
{
    ck_assert_int_eq(brink_potential_is_valid(&soft), 1);
    ck_assert_int_eq(brink_potential_is_valid(&hard), 1);
    ck_assert_int_eq(brink_potential_is_valid(&sphere), 1);
    ck_assert(!brink_potential_is_valid(NULL));
    ck_assert(!is_valid(0, distance, soft_energy) &&
              !is_valid(-1, distance, soft_energy));
    ck_assert(!is_valid(1, NULL, soft_energy) && !is_valid(1, distance, NULL));
    ck_assert(!is_valid(2, (double[]){2, 2}, soft_energy));
    ck_assert(!is_valid(2, (double[]){1, 2}, soft_energy));
    const double bad[] = {0, -0.0, -1, INF, NaN};
    for (int k = 0; k < 5; k++) {
        ck_assert(!is_valid(1, &bad[k], soft_energy));
        ck_assert(!is_valid(2, (double[]){bad[k], 1}, soft_energy) || bad[k] > 1);
        ck_assert(!is_valid(2, (double[]){5, bad[k]}, soft_energy));
    }
    ck_assert(!is_valid(2, distance, (double[]){INF, 1}));
    ck_assert(!is_valid(2, distance, (double[]){1, -INF}));
    ck_assert(!is_valid(2, distance, (double[]){1, NaN}));
    ck_assert(!is_valid(2, distance, (double[]){NaN, INF}));
    ck_assert(is_valid(1, (double[]){0x1p-1074}, (double[]){DBL_MAX}));
}
END_TEST

START_TEST(a_wall_has_two_sides)
{
    int next;
    ck_assert(brink_side_next(0, &next) == 1 && next == 1);
    ck_assert(brink_side_next(1, &next) == 1 && next == 0);
    const int strange[] = {INT_MIN, -1, 2, INT_MAX};
    for (int k = 0; k < 4; k++)
        ck_assert(brink_side_next(strange[k], &next) == 0 && next == strange[k]);
}
END_TEST

START_TEST(cells_follow_one_another)
{
    for (int cells = 1; cells < 6; cells++)
        for (int cell = -2; cell < 8; cell++)
            for (int way = -2; way <= 2; way++)
                for (int periodic = 0; periodic < 2; periodic++) {
                    int next, legal = brink_cell_next(cell, cells, way, periodic,
                                                      &next);
                    int is_cell = cell >= 0 && cell < cells;
                    int is_way = way == -1 || way == 1, to = cell + way;
                    int right = is_cell && is_way &&
                                (periodic || (to >= 0 && to < cells));
                    ck_assert_int_eq(legal, right);
                    ck_assert_int_eq(next, right ? (to + cells) % cells : cell);
                }
    int next;
    ck_assert_int_eq(brink_cell_next(INT_MAX - 1, INT_MAX, 1, 1, &next), 1);
    ck_assert_int_eq(next, 0);
    ck_assert_int_eq(brink_cell_next(INT_MAX, INT_MAX, 1, 1, &next), 0);
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "step", 60, a_soft_potential_leads_where_it_should,
        a_hard_core_is_never_entered, hard_spheres_know_cores_alone,
        a_square_well_is_left_or_bounced_in_and_has_a_core,
        what_is_no_level_or_no_event_is_refused,
        levels_change_by_one_and_energies_by_the_rise,
        energies_and_rises_are_those_of_the_table,
        the_level_from_position_is_exact_and_the_surface_counts_as_outside,
        only_decreasing_distances_and_an_innermost_core_are_valid,
        a_wall_has_two_sides, cells_follow_one_another);
}
