// SPDX-License-Identifier: MIT
/*
 * The yardstick measures right only if it does the same work: its events are the
 * simulator's.
 */
#include "plain_simulator.h"
#include "suite.h"
#include "systems.h"
#include <math.h>
#include <stdio.h>

/* Two that begin with different roundings part, as sequence_test has it: each
 * collision magnifies what a particle deviates by twice its way from the last
 * one or so, in diameters.  In the most dilute system here that way is 2.5 on
 * average, 1 / (sqrt(2) pi 3^2 0.01), and a particle has 4 events, some have 8:
 * 5^8 < 2^19.  Coordinates are below 2^5, so they begin with roundings of
 * 2^-49.  Seen is 4e-11. */
#define TIMES_AGREE 0x1p-30
enum { EVENTS = 512 };

static const char denser_spheres[] = "seed: 21\n"
                                     "box: {packing_fraction: 0.45}\n"
                                     "species: {A: {count: 500, diameter: 1}}\n";

static const char *const scenes[] = {hard_spheres, denser_spheres, square_well,
                                     square_shoulder};
enum { STARTS = sizeof scenes / sizeof *scenes };

static void make_plain(plain_simulator *s, const char *scene)
{
    brink_system start;
    make_system(&start, scene);
    plain_create(s, &start);
    brink_system_destroy(&start);
}

static void compare_events(int k)
{
    plain_simulator s;
    brink_run run;
    make_plain(&s, scenes[k]);
    make_run(&run, scenes[k]);
    for (uint64_t n = 1; n <= EVENTS; n++) {
        advance(&run, n);
        plain_advance(&s, n);
        const double time = brink_run_time(&run);
        ck_assert_msg(s.last.kind == run.last.kind && s.last.i == run.last.i &&
                          s.last.j == run.last.j &&
                          fabs(s.now - time) <= TIMES_AGREE,
                      "scene %d, event %d: (%u, %u) kind %d at %a, not (%u, %u) "
                      "kind %d at %a",
                      k, (int)n, s.last.i, s.last.j, (int)s.last.kind, s.now,
                      run.last.i, run.last.j, (int)run.last.kind, time);
    }
    brink_run_destroy(&run);
    plain_destroy(&s);
}

/* An event changes the kinetic energy of two particles, or of their pair's level,
 * by 16 roundings of it at most: this is far more than E events add up to, even
 * if all went one way and every pair had three times its share. */
static double energy_error(const plain_simulator *s)
{
    return 3 * 16 * 0x1p-53 * 3 * (double)s->events;
}

static void check_energy(int k)
{
    plain_simulator s;
    make_plain(&s, scenes[k]);
    const double begin = plain_energy(&s);
    plain_advance(&s, 100 * (uint64_t)s.count);
    const double error = plain_energy(&s) - begin;
    ck_assert_msg(fabs(error) <= energy_error(&s), "scene %d: %a from %a", k,
                  error, begin);
    plain_destroy(&s);
}

/* How far beyond a surface rounding may leave a pair that comes back with its
 * next event: its time, below 2^8, is rounded by 2^-46 at most, and as often
 * again in reckoning with it; speeds are below 2^3. */
#define BEYOND (4 * 0x1p-46 * 8)

static void check_levels(int k)
{
    plain_simulator s;
    make_plain(&s, scenes[k]);
    plain_advance(&s, 100 * (uint64_t)s.count);
    ck_assert_double_lt(s.now, 256);
    for (uint32_t i = 0; i < s.count; i++)
        for (uint32_t j = 0; j < i; j++) {
            double r[3], u[3];
            plain_relative(&s, i, j, r, u);
            const double distance = sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
            const int captured = plain_is_captured(&s, i, j);
            ck_assert_int_eq(captured, plain_is_captured(&s, j, i));
            ck_assert_msg(distance >= s.core - BEYOND &&
                              (captured ? distance <= s.range + BEYOND
                                        : distance >= s.range - BEYOND),
                          "scene %d: (%u, %u) at %a, captured: %d", k, i, j,
                          distance, captured);
        }
    plain_destroy(&s);
}

START_TEST(its_events_are_the_simulators)
{
    for (int k = 0; k < STARTS; k++)
        compare_events(k);
}
END_TEST

START_TEST(its_energy_is_kept)
{
    for (int k = 0; k < STARTS; k++)
        check_energy(k);
}
END_TEST

START_TEST(no_event_is_missed_so_that_levels_are_what_positions_say)
{
    for (int k = 0; k < STARTS; k++)
        check_levels(k);
}
END_TEST

int main(void)
{
    return RUN_SUITE("plain simulator", 120, its_events_are_the_simulators,
                     its_energy_is_kept,
                     no_event_is_missed_so_that_levels_are_what_positions_say);
}
