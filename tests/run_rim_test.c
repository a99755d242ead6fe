// SPDX-License-Identifier: MIT
/*
 * Runs that could be held up for ever at one spot, the rim of a well or of a
 * shoulder, where two particles all but slide along a step: time moves on, all is
 * counted, and energy is kept.
 */
#include "run_predict.h"
#include "suite.h"
#include "systems.h"
#include <brink/impulse.h>
#include <float.h>
#include <math.h>

static const brink_potential well = {2, (const double[]){2, 1},
                                     (const double[]){-1, (double)INFINITY}};
static const brink_potential shoulder = {2, (const double[]){2, 1},
                                         (const double[]){1, (double)INFINITY}};

/** A pair at `level` that is `ulps` of 2 beyond the distance 2 along x, whatever
 *  that shows. */
static void make_rim(brink_run *run, const brink_potential *p, int level,
                     int ulps, double radial, double tangential)
{
    make_pair(run, p, (const double[]){3, 0, 0},
              (const double[]){radial, tangential, 0});
    // An ulp of 2 is 2^-51, of a box of 64 that is 2^-57, or 2^7 units.
    const uint64_t two = UINT64_C(1) << 59;
    run->system.particle[0].x[0] =
        run->system.particle[1].x[0] + two + (uint64_t)(ulps * 128);
    ck_assert_int_eq(brink_states_set(&run->states, &run->system, 0, 1, level),
                     0);
    brink_predict(run, 0, 0.0);
    brink_predict(run, 1, 0.0);
    run->energy_begin = brink_run_energy(run);
}

static const double tangents[] = {1e-6, 0.5, 1e3};
static const double radials[] = {0,     1e-300, 1e-20, 1e-12, 1e-9,
                                 -1e-9, -1e-12, -1e-20}; // of the tangential
#define COUNT(list) (sizeof(list) / sizeof *(list))

/* An existing simulator made 20 000 bounces here without time moving on.  The
 * rule (<brink/impulse.h>): a bounce from inside leaves the rim at an angle of
 * BRINK_RIM_ANGLE or more, and the chord to the next one then takes 2 angle
 * distance / v. */
static void go_round(int ulps, double tangential, double radial)
{
    enum { EVENTS = 20000 };
    brink_run run;
    make_rim(&run, &well, 1, ulps, radial * tangential, tangential);
    const double kinetic = brink_system_kinetic_energy(&run.system);
    advance(&run, EVENTS);
    const brink_tally *t = &run.tally;
    const double chord = 2 * BRINK_RIM_ANGLE * 2 / tangential;
    ck_assert_int_eq(brink_states_level(&run.states, 0, 1), 1);
    // Such a chord is angle^2 / 2 = 2^-49 of the distance deep, 8 eps; where a
    // rounding puts a bounce an eps further in or out, it is shorter or longer,
    // on the whole by less than half.
    ck_assert_msg(t->bounce == EVENTS && t->zero_time <= 1 && t->repeated <= 1 &&
                      brink_run_time(&run) > 0.5 * EVENTS * chord,
                  "v_t %a, v_r %a v_t, %d ulp: %lu bounces, %lu at one instant, "
                  "time %a",
                  tangential, radial, ulps, (unsigned long)t->bounce,
                  (unsigned long)t->zero_time, brink_run_time(&run));
    ck_assert_msg((t->rim > 0 || fabs(radial) > BRINK_RIM_ANGLE) &&
                      t->rim <= t->bounce,
                  "v_t %a, v_r %a v_t: %lu are counted", tangential, radial,
                  (unsigned long)t->rim);
    // Every bounce rounds each velocity once: a random walk of steps of 2^-53 of
    // the kinetic energy, four standard deviations of it; or one of the sum,
    // kinetic and potential.
    const double drift = brink_run_energy(&run) - run.energy_begin;
    ck_assert_double_le(fabs(drift),
                        4 * sqrt(EVENTS) * 0x1p-53 * kinetic + 0x1p-53);
    brink_run_destroy(&run);
}

START_TEST(captured_pairs_on_the_rim_make_progress)
{
    for (size_t t = 0; t < COUNT(tangents); t++)
        for (size_t r = 0; r < COUNT(radials); r++)
            for (int ulps = -1; ulps <= 1; ulps++)
                go_round(ulps, tangents[t], radials[r]);
}
END_TEST

/** How many events it takes until the pair is on its way for good. */
static uint64_t events_until_apart(const brink_potential *p, int level, int ulps,
                                   double tangential, double radial)
{
    brink_run run;
    make_rim(&run, p, level, ulps, radial * tangential, tangential);
    const double energy = run.energy_begin;
    // Out of reach of each other, and not yet of their images.
    const double away = 4 / tangential;
    ck_assert_int_eq(
        brink_run_advance(&run, 1000, brink_instant_at(run.system.year, away)),
        BRINK_RUN_REACHED);
    const uint64_t events = brink_tally_events(&run.tally);
    ck_assert_uint_le(run.tally.zero_time, 1);
    // A few velocities rounded and the sum: some ulp of the largest part of it.
    const double kinetic = brink_system_kinetic_energy(&run.system);
    ck_assert_double_le(fabs(brink_run_energy(&run) - energy),
                        4 * DBL_EPSILON * (kinetic + 1));
    brink_run_destroy(&run);
    return events;
}

// On a shoulder there is nothing to hold a pair: inside, it is let go of and
// gains by it; outside, it passes by or bounces once.
START_TEST(pairs_at_a_shoulder_are_let_go)
{
    for (size_t t = 0; t < COUNT(tangents); t++)
        for (size_t r = 0; r < COUNT(radials); r++)
            for (int ulps = -1; ulps <= 1; ulps++) {
                const double v_t = tangents[t], v_r = radials[r];
                const uint64_t out =
                    events_until_apart(&shoulder, 0, ulps, v_t, v_r);
                ck_assert_msg(out <= 1, "outside, v_t %a v_r %a: %lu events", v_t,
                              v_r, (unsigned long)out);
            }
    // From inside the way out is the next event, wherever a rounding has put it,
    // and at the speed that it gains, sqrt(4), it is gone.
    for (size_t r = 0; r < COUNT(radials); r++)
        for (int ulps = -1; ulps <= 1; ulps++)
            ck_assert_uint_eq(
                events_until_apart(&shoulder, 1, ulps, 0.5, radials[r]), 1);
}
END_TEST

typedef struct slide {
    int dimensions;
    double box[3], mass, year;
    brink_particle pair[2];
} slide;

/* Found by fuzz/run_fuzz.c.  Two in contact at their cores, of which their
 * relative velocity is a tangent, all but 2^-54 of it.
 *
 * The first: what the impulse changes is less than a rounding of velocities three
 * times as large.  The second: r.v is 0, no event; the fast tier's r.v is below.
 * Either way they met again at the same instant, 1034 times, and the run
 * stopped. */
static const slide slides[] = {
    {2,
     {0x1.54bc7fcac0832p+2, 0x1.54bc7fcac0832p+2, 1},
     64,
     2,
     {{.x = {0x2c829abe1f453200, 0xc584133ac916a800},
       .v = {0x1.11e3f5797548ap-1, 0x1.99b82a15d79bap+0}},
      {.x = {0x28a0725c18066000, 0xadca21d906abf000},
       .v = {0x1.0743aea947e4cp+0, 0x1.850b43755b883p+0}}}},
    {3,
     {0x1.7700177p+6, 0x1.e0001e000000ap+0, 0x1.2d33460666666p+2},
     1,
     0x1p-7,
     {{.x = {0x8705aab22ab87e45, 0x6a73e0a53cb0d8d3, 0xcc1a2380ad4aa788},
       .v = {-0x1.1d52643f9d01dp+0, 0x1.f483cca85ab54p-3, 0x1.2b44c1fff0aeap+0}},
      {.x = {0x8592f0855667da55, 0xb2dc3d66b470c8d3, 0xcc1a2380ad4aa788},
       .v = {-0x1.77d4ddd999f1p+0, -0x1.bf20004f19888p-4,
             0x1.2b44c1fff0aeap+0}}}},
};

/** In contact at the inner of two steps, at level 1. */
static void slide_along(const slide *of, const brink_potential *p,
                        enum brink_tier tier)
{
    const brink_species species = {"A", of->mass, 0, 2};
    brink_system s;
    brink_run run;
    ck_assert_int_eq(brink_system_create(&s, of->dimensions, of->box, of->year, 2,
                                         1, &species, p),
                     0);
    s.particle[0] = of->pair[0];
    s.particle[1] = of->pair[1];
    ck_assert_int_eq(brink_run_create(&run, &s, tier), 0);
    brink_states_set(&run.states, &run.system, 0, 1, 1);
    brink_predict(&run, 0, 0.0);
    brink_predict(&run, 1, 0.0);
    const double energy = brink_run_energy(&run);
    double most = brink_system_kinetic_energy(&run.system);
    for (uint64_t events = 1; events <= 5; events++) {
        advance(&run, events);
        most = fmax(most, brink_system_kinetic_energy(&run.system));
    }
    ck_assert_msg(run.tally.zero_time == 0, "%lu events at one instant",
                  (unsigned long)run.tally.zero_time);
    // Two sums of few terms, and this one: a rounding each of the largest part.
    ck_assert_double_le(fabs(brink_run_energy(&run) + run.owed - energy),
                        4 * DBL_EPSILON * most);
    brink_run_destroy(&run);
}

START_TEST(pairs_that_slide_along_a_core_or_a_shoulder_go_on)
{
    const double distance[][2] = {{0.6655000000000002, 0.5}, {0.9375, 0.75}};
    const double core[] = {-2, (double)INFINITY}, step[] = {-2, 1e9};
    for (int k = 0; k < 2; k++)
        for (int tier = BRINK_TIER_FAST; tier <= BRINK_TIER_CR; tier++) {
            slide_along(&slides[k], &(brink_potential){2, distance[k], core},
                        (enum brink_tier)tier);
            slide_along(&slides[k], &(brink_potential){2, distance[k], step},
                        (enum brink_tier)tier);
        }
}
END_TEST

int main(void)
{
    return RUN_SUITE("run, rim", 300, captured_pairs_on_the_rim_make_progress,
                     pairs_at_a_shoulder_are_let_go,
                     pairs_that_slide_along_a_core_or_a_shoulder_go_on);
}
