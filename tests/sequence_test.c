// SPDX-License-Identifier: MIT
/*
 * The simulator's events are the reference's, one by one, for as long as doubles
 * can know them.
 *
 * These systems are chaotic: every event magnifies a deviation, until it decides
 * which pair meets first.  How long that takes is measured, not guessed: the
 * reference is run again, deflected before every event by DEFLECTION of the
 * velocities and of the box, four times with different signs, and the first event
 * at which one of them departs from the undeflected one is the floor.  The
 * simulator must not depart before it.
 *
 * Why that is fair.  An event costs the simulator less than 64 roundings of 2^-53
 * of the quantities at hand: separation and relative velocity 12, the time 8, its
 * sum with the offset 1, two positions 12, two velocities 4 each in 3
 * components.  That is less than one deflection of 2^(6 - 53); and two bits more,
 * as four choices of signs are not all directions.
 *
 * Printed beside it: where deflections of one rounding, 2^-53, depart.  There or
 * a few events later one expects the simulator to depart, and so it does.
 */
#include "reference.h"
#include "suite.h"
#include "systems.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

#define DEFLECTION 0x1p-45
enum {
    LONGEST = 400,
    SIGNS = 4,
    SEEDS = 2,
    BITS = 320 // departs from 256 bits later than the simulator: asserted below
};

/* Two sequences have parted when kind or pair differ, or the time by more than
 * this: two particles have only one pair to meet.  In units of sigma / thermal
 * speed, half a dozen bits below the time between events, where every
 * deviation passes on its way up. */
#define TIMES_PART 0x1p-6

static const char *const scenes[] = {
    "title: two spheres\n"
    "box: {size: [4, 5, 4.5]}\n"
    "species: {A: {count: 2, diameter: 1}}\n"
    "start: {random: true}\n",

    "title: hard spheres, three cells a side\n"
    "box: {size: [3.5, 3, 4]}\n"
    "species: {A: {count: 12, diameter: 1}}\n"
    "start: {random: true}\n",

    "title: hard spheres, dilute\n"
    "box: {size: [9, 8, 10]}\n"
    "species: {A: {count: 16, diameter: 1}}\n"
    "start: {random: true}\n",

    "title: square well\n"
    "box: {size: [4, 5, 4.5]}\n"
    "species: {A: {count: 8}}\n"
    "start: {random: true}\n"
    "potentials: [{between: [A, A], steps: [[1.5, -1], [1, .inf]]}]\n",

    "title: square shoulder\n"
    "box: {size: [7, 8, 6]}\n"
    "species: {A: {count: 10}}\n"
    "start: {random: true}\n"
    "potentials: [{between: [A, A], steps: [[2, 1], [1, .inf]]}]\n",

    "title: three steps, soft inside\n"
    "box: {size: [5, 5, 5]}\n"
    "species: {A: {count: 5}}\n"
    "start: {random: true}\n"
    "potentials: [{between: [A, A], steps: [[2, -0.3], [1.5, -1], [1, 3]]}]\n",

    "title: mixture\n"
    "box: {size: [5, 5, 5]}\n"
    "species: {A: {count: 3, mass: 100, diameter: 1.5}, B: {count: 9, diameter: "
    "0.5}}\n"
    "start: {random: true}\n",

    "title: discs\n"
    "dimensions: 2\n"
    "box: {size: [5, 6]}\n"
    "species: {A: {count: 12, diameter: 1}}\n"
    "start: {random: true}\n",

    "title: discs in wells\n"
    "dimensions: 2\n"
    "box: {size: [5, 4]}\n"
    "species: {A: {count: 4}}\n"
    "start: {random: true}\n"
    "potentials: [{between: [A, A], steps: [[1.5, -1], [1, .inf]]}]\n",
};

static int same(const reference_event *a, const reference_event *b)
{
    return a->kind == b->kind && a->i == b->i && a->j == b->j &&
           fabs(a->time - b->time) <= TIMES_PART;
}

/** The first event at which a reference of `bits`, deflected, departs from
 *  `truth`, or `most`. */
static int departs(const brink_system *system, mpfr_prec_t bits,
                   double deflection, unsigned long signs,
                   const reference_event *truth, int most)
{
    reference w;
    reference_event e;
    int n = 0;
    reference_create(&w, system, bits);
    do
        reference_deflect(&w, deflection, signs * LONGEST + (unsigned long)n);
    while (reference_next(&w, &e) && same(&e, &truth[n]) && ++n < most);
    reference_destroy(&w);
    return n;
}

/** The first of the simulator's events that is not the reference's, or
 *  LONGEST; what the reference says up to it in truth. */
static int simulator_departs(brink_run *run, reference *w, reference_event *truth)
{
    for (int n = 0; n < LONGEST; n++) {
        ck_assert(reference_next(w, &truth[n]));
        ck_assert_int_eq(brink_run_advance(run, (uint64_t)n + 1, BRINK_NEVER),
                         BRINK_RUN_REACHED);
        reference_event e = {run->last.kind, run->last.i, run->last.j,
                             brink_run_time(run)};
        if (!same(&e, &truth[n]))
            return n;
    }
    return LONGEST;
}

static void compare(const char *scene, int seed)
{
    char text[400];
    reference_event truth[LONGEST];
    brink_system system;
    brink_run run;
    reference w;
    snprintf(text, sizeof text, "%sseed: %d\n", scene, seed);
    make_system(&system, text);
    make_run(&run, text);
    reference_create(&w, &system, BITS);
    int parted = simulator_departs(&run, &w, truth);
    int most = parted < LONGEST ? parted + 1 : LONGEST;
    ck_assert_int_eq(departs(&system, 256, 0, 0, truth, most), most);
    int floor = LONGEST, rounding = LONGEST;
    for (unsigned long signs = 1; signs <= SIGNS; signs++) {
        int n = departs(&system, BITS, DEFLECTION, signs, truth, most);
        int m = departs(&system, BITS, 0x1p-53, signs, truth, most);
        floor = n < floor ? n : floor;
        rounding = m < rounding ? m : rounding;
    }
    printf(
        "%.*s, seed %d: departs at event %d; deflected by 2^-53 at %d, by 2^-45 "
        "(the floor) at %d\n",
        (int)strcspn(scene + 7, "\n"), scene + 7, seed, parted, rounding, floor);
    fflush(stdout);
    ck_assert_int_ge(parted, floor);
    brink_run_destroy(&run);
    reference_destroy(&w);
    brink_system_destroy(&system);
}

START_TEST(events_are_the_references_for_as_long_as_doubles_can_know_them)
{
    for (size_t n = 0; n < sizeof scenes / sizeof *scenes; n++)
        for (int seed = 1; seed <= SEEDS; seed++)
            compare(scenes[n], seed);
}
END_TEST

int main(void)
{
    return RUN_SUITE(
        "sequence", 600,
        events_are_the_references_for_as_long_as_doubles_can_know_them);
}
