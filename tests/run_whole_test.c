// SPDX-License-Identifier: MIT
// A run as a whole: how it begins, what it says of itself, how it ends.
#include "run.h"
#include "suite.h"
#include "systems.h"
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const brink_potential well = {2, (double[]){2, 1},
                                     (double[]){-1, (double)INFINITY}};

START_TEST(a_run_takes_its_system_over)
{
    brink_system system;
    brink_run run;
    make_system(&system, small_box);
    const brink_particle *const particles = system.particle;
    double momentum[3];
    brink_system_momentum(&system, momentum);
    const double kinetic = brink_system_kinetic_energy(&system);
    ck_assert_int_eq(brink_run_create(&run, &system, BRINK_TIER_CR), 0);
    ck_assert_ptr_eq(run.system.particle, particles);
    ck_assert_ptr_null(system.particle);
    ck_assert_uint_eq(system.count, 0);
    ck_assert_int_eq(run.tier, BRINK_TIER_CR);
    ck_assert(run.kinetic_begin == kinetic);
    ck_assert(run.energy_begin ==
              kinetic + brink_states_energy(&run.states, &run.system));
    ck_assert(run.energy_begin < run.kinetic_begin); // some are in wells
    ck_assert_mem_eq(run.momentum_begin, momentum, sizeof momentum);
    ck_assert(brink_run_energy(&run) == run.energy_begin);
    for (uint32_t i = 0; i < run.system.count; i++) // all wait for something
        ck_assert(run.calendar.entry[i].when.epoch != INT64_MAX);
    brink_run_destroy(&run);
    static const brink_run nothing;
    ck_assert_mem_eq(&run, &nothing, sizeof run);
}
END_TEST

// From outside, in the well, and in the core by what a rounding does.
START_TEST(levels_begin_as_positions_have_them)
{
    static const struct {
        double r;
        int level;
    } c[] = {{2.5, 0}, {2, 0}, {1.999, 1}, {1, 1}, {0.999, 1}};
    for (int k = 0; k < (int)(sizeof c / sizeof *c); k++) {
        brink_run run;
        make_pair(&run, &well, (double[]){0, c[k].r, 0}, (double[]){0, 0, 1});
        ck_assert_int_eq(brink_states_level(&run.states, 0, 1), c[k].level);
        brink_run_destroy(&run);
    }
}
END_TEST

// How many of the run's images are shifted by so many lengths along each axis.
static int count_images(const brink_run *run, const int shift[3])
{
    int found = 0;
    for (int n = 0; n < run->images; n++) {
        int same = 1;
        for (int a = 0; a < 3; a++)
            same &= run->image[n][a] == shift[a] * run->system.length[a];
        found += same;
    }
    return found;
}

// Of boxes with room for one to three cells along x, along x and y, along all.
START_TEST(images_are_looked_for_along_narrow_axes)
{
    static const struct {
        const char *box;
        int count;
    } c[] = {{"[8, 8, 8]", 130},
             {"[2.5, 8, 8]", 60},
             {"[2.5, 2.625, 8]", 20},
             {"[2.5, 2.625, 2.75]", 4}};
    for (int narrow = 0; narrow < 4; narrow++) {
        char scene[300];
        snprintf(scene, sizeof scene,
                 "box: {size: %s}\n"
                 "species: {A: {count: %d, diameter: 1}}\n"
                 "start: {random: true}\n",
                 c[narrow].box, c[narrow].count);
        brink_run run;
        make_run(&run, scene);
        ck_assert_int_eq(run.images, (int)pow(3, narrow));
        for (int k = 0; k < 27; k++) {
            const int shift[3] = {k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1};
            int possible = 1;
            for (int a = 0; a < 3; a++)
                possible &= a < narrow || shift[a] == 0;
            ck_assert_int_eq(count_images(&run, shift), possible);
        }
        brink_run_destroy(&run);
    }
}
END_TEST

// Lists are made of those in adjacent cells: these are to hold all who can come
// near before either departs from home.
START_TEST(cells_are_as_wide_as_lists_reach)
{
    static const char *const scenes[] = {crowded_spheres, crowded_mixture};
    for (int k = 0; k < 2; k++) {
        brink_run run;
        make_run(&run, scenes[k]);
        ck_assert(run.neighbours.radius > 0);
        for (int a = 0; a < 3; a++)
            ck_assert_double_ge(run.system.length[a] / run.cells.count[a],
                                run.system.range + 2 * run.neighbours.radius);
        brink_run_destroy(&run);
    }
}
END_TEST

START_TEST(a_fault_of_any_room_is_one_of_the_run)
{
    for (int room = 0; room < 5; room++) {
        brink_run run;
        const char *fault = NULL;
        make_run(&run, crowded_mixture);
        ck_assert(run.neighbours.radius > 0);
        ck_assert_ptr_null(brink_run_is_valid(&run));
        switch (room) {
        case 0:
            run.system.particle[3].v[1] = (double)NAN;
            fault = brink_system_is_valid(&run.system);
            break;
        case 1:
            run.cells.cell[3] = (run.cells.cell[3] + 1) % run.cells.total;
            fault = brink_cells_is_valid(&run.cells);
            break;
        case 2:
            run.neighbours.radius *= 0x1p-60;
            fault = brink_neighbours_is_valid(&run.neighbours, &run.cells,
                                              &run.system);
            break;
        case 3:
            run.states.links.used++;
            fault = brink_states_is_valid(&run.states, &run.system);
            break;
        default:
            run.calendar.entry[3].when = BRINK_NEVER;
            fault = brink_calendar_is_valid(&run.calendar);
        }
        ck_assert_ptr_nonnull(fault);
        ck_assert_ptr_eq(brink_run_is_valid(&run), fault);
        run.states.links.used -= room == 3;
        brink_run_destroy(&run);
    }
}
END_TEST

START_TEST(a_diagnosis_says_why_and_what_was_last)
{
    static const char *const why[] = {
        [BRINK_RUN_REACHED] = "the run reached its target",
        [BRINK_RUN_AT_REST] = "nothing moves: there is no further event",
        [BRINK_RUN_STUCK] = "events go on but the clock does not",
        [BRINK_RUN_QUIET] = "nobody has met anybody for long",
        [BRINK_RUN_REFUSED] = "the state machine refused an event",
        [BRINK_RUN_NO_MEMORY] = "memory is out"};
    static const char *const kinds[] = {"core", "capture", "release", "bounce"};
    brink_run run;
    make_pair(&run, &well, (double[]){3, 0, 0}, (double[]){-1, 0.5, -0.25});
    advance(&run, 1); // at time 1.04 or so, at level 1 from 0
    for (int status = 0; status <= BRINK_RUN_NO_MEMORY; status++) {
        const brink_particle *a = &run.system.particle[0],
                             *b = &run.system.particle[1];
        char is[1000], should[1000];
        double r[3];
        brink_system_separation(&run.system, 0, 1, run.now.offset, r);
        run.last.kind = (enum brink_event_kind)(status % 4);
        brink_run_diagnosis(&run, (enum brink_run_status)status, is, sizeof is);
        snprintf(should, sizeof should,
                 "%s; after 1 events, at time %.17g\n"
                 "last event: %s of particles 0 and 1, level 0 -> 1, step at "
                 "0x1p+1\nr = {%a, %a, %a}\nv = {%a, %a, %a}\n",
                 why[status], brink_run_time(&run), kinds[status % 4], r[0], r[1],
                 r[2], a->v[0] - b->v[0], a->v[1] - b->v[1], a->v[2] - b->v[2]);
        ck_assert_str_eq(is, should);
    }
    brink_run_destroy(&run);
}
END_TEST

// Factors, one by one: powers of two are exact.
START_TEST(observables_are_those_of_the_tally)
{
    brink_run run;
    make_pair(&run, &well, (double[]){16, 0, 0}, (double[]){0, 0, 0});
    run.system.particle[0].v[0] = run.system.particle[1].v[1] = 2;
    ck_assert(brink_system_kinetic_energy(&run.system) == 4);
    const double kt = brink_system_temperature(&run.system);
    run.now = (brink_instant){8, 0};
    run.tally.core = 4;
    brink_sum_add(&run.tally.virial, 96);
    const double z = 1 + 96 / (3 * 2 * kt * 8);
    ck_assert(brink_run_compressibility(&run) == z);
    ck_assert(brink_run_pressure(&run) == z * 2 * kt / (64 * 64 * 64));
    ck_assert(brink_run_mean_free_time(&run) == 2 * 8 / (2. * 4));
    brink_run_destroy(&run);
}
END_TEST

// Also where the clock is years ahead of a particle's own time.
START_TEST(who_is_looked_at_is_where_its_path_leads)
{
    brink_run run;
    make_pair(&run, &well, (double[]){16, 0, 0}, (double[]){0, 0, 0});
    run.system.particle[0].v[1] = 0.5;
    run.now = (brink_instant){4, 0.5};
    double x[3];
    brink_run_position(&run, 0, x);
    ck_assert(x[0] == 48 && x[1] == 32 + 4.5 * 0.5 && x[2] == 32);
    brink_run_destroy(&run);
}
END_TEST

// However many crossings of cells, if there are events among them.
START_TEST(a_run_with_events_is_not_quiet)
{
    brink_run run;
    make_run(&run, "box: {size: [40, 40, 40]}\n"
                   "species: {A: {count: 125, diameter: 1}}\n"
                   "start: {random: true}\n");
    advance(&run, 20000);
    ck_assert_uint_gt(run.tally.cell, BRINK_PATIENCE + BRINK_PATIENCE / 8);
    brink_run_destroy(&run);
}
END_TEST

START_TEST(the_clock_goes_to_no_time_behind_it_and_not_for_ever)
{
    brink_run run;
    make_run(&run, hard_spheres);
    advance(&run, 100);
    const brink_instant now = run.now, begin = {0, 0};
    ck_assert_int_eq(brink_run_advance(&run, 200, begin), BRINK_RUN_REACHED);
    ck_assert_uint_eq(brink_tally_events(&run.tally), 100);
    ck_assert_int_eq(brink_instant_compare(run.now, now), 0);
    brink_run_destroy(&run);
    make_pair(&run, &well, (double[]){4, 0, 0}, (double[]){0, 0, 0});
    ck_assert_int_eq(brink_run_advance(&run, 1, BRINK_NEVER), BRINK_RUN_AT_REST);
    ck_assert_int_eq(brink_run_step(&run), BRINK_RUN_AT_REST);
    ck_assert_int_eq(brink_instant_compare(run.now, begin), 0);
    brink_run_destroy(&run);
}
END_TEST

START_TEST(what_is_due_at_the_target_takes_place)
{
    static const struct {
        brink_instant until;
        uint64_t events;
    } c[] = {{{0, 0x1.fffffffffffffp-1}, 0}, {{1, 0}, 1}};
    for (int k = 0; k < 2; k++) {
        brink_run run; // in the well at 1
        make_pair(&run, &well, (double[]){3, 0, 0}, (double[]){-1, 0, 0});
        ck_assert_int_eq(brink_run_advance(&run, 2, c[k].until),
                         BRINK_RUN_REACHED);
        ck_assert_uint_eq(brink_tally_events(&run.tally), c[k].events);
        ck_assert_int_eq(brink_instant_compare(run.now, c[k].until), 0);
        brink_run_destroy(&run);
    }
}
END_TEST

// From a cell along z that a plane does not have.
START_TEST(a_crossing_to_nowhere_is_refused_and_not_counted)
{
    brink_run run;
    make_run(&run, discs_well);
    uint32_t slot = brink_calendar_next(&run.calendar);
    while (run.calendar.entry[slot].kind != BRINK_ENTRY_CELL) {
        ck_assert_int_eq(brink_run_step(&run), BRINK_RUN_REACHED);
        slot = brink_calendar_next(&run.calendar);
    }
    const uint64_t crossed = run.tally.cell;
    run.calendar.entry[slot].j = brink_crossing_number((brink_crossing){2, 1});
    run.cells.cell[slot] = run.cells.total;
    ck_assert_int_eq(brink_run_step(&run), BRINK_RUN_REFUSED);
    ck_assert_uint_eq(run.tally.cell, crossed);
    brink_run_destroy(&run);
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "run_whole", 120, a_run_takes_its_system_over,
        levels_begin_as_positions_have_them,
        images_are_looked_for_along_narrow_axes, cells_are_as_wide_as_lists_reach,
        a_fault_of_any_room_is_one_of_the_run,
        a_diagnosis_says_why_and_what_was_last,
        observables_are_those_of_the_tally,
        who_is_looked_at_is_where_its_path_leads, a_run_with_events_is_not_quiet,
        the_clock_goes_to_no_time_behind_it_and_not_for_ever,
        a_crossing_to_nowhere_is_refused_and_not_counted,
        what_is_due_at_the_target_takes_place);
}
