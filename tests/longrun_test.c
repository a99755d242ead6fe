// SPDX-License-Identifier: MIT
/*
 * What must not wear out: an event late in a run, or far from the origin, is
 * placed as well as any; the same bits, where those are to be had.
 */
#include "suite.h"
#include "systems.h"
#include <brink/overlap.h>
#include <float.h>
#include <gsl/gsl_math.h>
#include <gsl/gsl_sort.h>
#include <stdio.h>
#include <string.h>

static const char *const scenes[] = {hard_spheres, square_well, square_shoulder,
                                     three_steps,  mixture,     discs_well,
                                     small_box};
enum { ALL = sizeof scenes / sizeof *scenes };

// --- The clock -----------------------------------------------------------------

/** The clock and all that waits for it, `years` later. */
static void put_off(brink_run *run, int64_t years)
{
    run->system.epoch += years;
    run->calendar.epoch += years;
    run->now.epoch += years;
    run->last.when.epoch += years;
    for (uint32_t slot = 0; slot < run->calendar.slots; slot++) {
        brink_entry e = run->calendar.entry[slot];
        if (e.when.epoch != INT64_MAX)
            e.when.epoch += years;
        brink_calendar_set(&run->calendar, slot, &e);
    }
}

/** 10^15 mean free times or more, of a run that has had some events. */
static int64_t very_late(const brink_run *run)
{
    const double free_time = brink_run_mean_free_time(run);
    return (int64_t)ceil(1e15 * free_time / run->system.year);
}

START_TEST(a_run_is_the_same_bits_after_1e15_mean_free_times)
{
    for (int k = 0; k < ALL; k++) {
        brink_run early, late;
        make_run(&early, scenes[k]);
        make_run(&late, scenes[k]);
        advance(&early, 1000);
        advance(&late, 1000);
        const int64_t years = very_late(&late);
        put_off(&late, years);
        advance(&early, 10000);
        advance(&late, 10000);
        ck_assert(late.now.epoch - years == early.now.epoch);
        late.now.epoch = early.now.epoch;
        late.system.epoch = early.system.epoch;
        for (uint32_t slot = 0; slot < late.calendar.slots; slot++)
            if (late.calendar.entry[slot].when.epoch != INT64_MAX)
                late.calendar.entry[slot].when.epoch -= years;
        ck_assert_msg(same_state(&early, &late), "scene %d", k);
        brink_run_destroy(&early);
        brink_run_destroy(&late);
    }
}
END_TEST

// --- Distance errors at contact ------------------------------------------------

/** (|r| - distance) / distance of the last event's pair, whose r is what it was
 *  then: (f / distance^2) / 2, as f is the difference of the squares. */
static double contact_error(const brink_run *run)
{
    const brink_happening *e = &run->last;
    double r[3];
    brink_system_separation(&run->system, e->i, e->j, e->when.offset, r);
    return brink_ball_overlap(r, e->distance) / e->distance / e->distance / 2;
}

typedef struct sample {
    double *value;
    size_t count;
} sample;

static void sample_make(sample *s, size_t most)
{
    s->value = calloc(most, sizeof *s->value);
    s->count = 0;
    ck_assert_ptr_nonnull(s->value);
}

/** The errors of the next `count` events. */
static void sample_next(sample *s, brink_run *run, size_t count)
{
    sample_make(s, count);
    while (s->count < count) {
        advance(run, brink_tally_events(&run->tally) + 1);
        s->value[s->count++] = contact_error(run);
    }
}

/** By Smirnov's test: the largest distance of the two distribution functions, in
 *  units of what makes it converge in distribution, sqrt(1/m + 1/n).  It is above
 *  2.23 in one case of 10 000 (2 exp(-2 x^2)), ties making it rarer. */
static double smirnov(const sample *a, const sample *b)
{
    const double m = (double)a->count, n = (double)b->count;
    double most = 0;
    gsl_sort(a->value, 1, a->count);
    gsl_sort(b->value, 1, b->count);
    for (size_t i = 0, j = 0; i < a->count && j < b->count;) {
        const double x = fmin(a->value[i], b->value[j]);
        while (i < a->count && a->value[i] <= x)
            i++;
        while (j < b->count && b->value[j] <= x)
            j++;
        most = fmax(most, fabs((double)i / m - (double)j / n));
    }
    return most / sqrt(1 / m + 1 / n);
}

#define SMIRNOV_MOST 2.23

static void tell(const char *what, const sample *s)
{
    printf("%s: %zu errors, eps:", what, s->count);
    for (int k = 0; k <= 4; k++)
        printf(" %+.2f", s->value[(size_t)(k / 4.0 * (double)(s->count - 1))] /
                             DBL_EPSILON);
    printf(" (quartiles)\n");
}

static void expect_alike(const char *what, const char *how, sample *a, sample *b)
{
    const double distance = smirnov(a, b);
    tell(what, a);
    tell(how, b);
    printf("    Smirnov's distance: %.2f\n", distance);
    fflush(stdout);
    ck_assert_msg(distance < SMIRNOV_MOST, "%s, %s: %.2f", what, how, distance);
    // That this would notice errors half as large again.
    for (size_t k = 0; k < b->count; k++)
        b->value[k] *= 1.5;
    ck_assert_double_gt(smirnov(a, b), SMIRNOV_MOST);
}

START_TEST(events_are_as_near_contact_after_1e15_mean_free_times)
{
    static const char *const names[ALL] = {"hard spheres", "wells",   "shoulders",
                                           "three steps",  "mixture", "discs",
                                           "a small box"};
    for (int k = 0; k < ALL; k++) {
        brink_run run;
        sample early, late;
        make_run(&run, scenes[k]);
        advance(&run, 1000);
        sample_next(&early, &run, 20000);
        put_off(&run, very_late(&run));
        sample_next(&late, &run, 20000);
        expect_alike(names[k], "  1e15 mean free times later", &early, &late);
        free(early.value);
        free(late.value);
        brink_run_destroy(&run);
    }
}
END_TEST

// --- The origin ----------------------------------------------------------------

// A drop of 600 in wells that nobody leaves, in a box of 1000 diameters; of
// these, 600 make for 8 cells a side, and a cell's side is 2^61 units.
static const char drop[] =
    "seed: 23\n"
    "box: {size: [1000, 1000, 1000]}\n"
    "species: {A: {count: 600}}\n"
    "start: {lattice: sc}\n"
    "potentials:\n"
    "  - {between: [A, A], steps: [[1.5, -40], [1, .inf]]}\n";

/** The lattice drawn together to sites 1.2 apart, the first of them at
 * `corner`. */
static void make_drop(brink_run *run, const uint64_t corner[3])
{
    const uint64_t apart = (uint64_t)(1.2 / 1000 * 0x1p64);
    brink_system s;
    make_system(&s, drop);
    for (uint32_t i = 0; i < s.count; i++) {
        const uint32_t site[3] = {i % 9, i / 9 % 9, i / 81};
        for (int a = 0; a < 3; a++)
            s.particle[i].x[a] = corner[a] + site[a] * apart;
    }
    ck_assert_int_eq(brink_run_create(run, &s, BRINK_TIER_PLAIN), 0);
    for (int a = 0; a < 3; a++) // or the places below are not alike
        ck_assert_int_eq(run->cells.count[a], 8);
}

START_TEST(a_drop_is_the_same_bits_wherever_it_is)
{
    // Inside a cell of 125 diameters, and in others of them in other places.
    const uint64_t cell = UINT64_C(1) << 61, middle = cell / 2;
    const uint64_t other[][3] = {
        {0, 0, 0},
        {7 * cell, 7 * cell, 7 * cell},
        {4 * cell, 7 * cell + 1, 3 * cell},
        {cell + 12345678901, 2 * cell - 9876543210, 6 * cell + 1}};
    brink_run here;
    make_drop(&here, (const uint64_t[3]){middle, middle, middle});
    advance(&here, 3000);
    for (size_t k = 0; k < sizeof other / sizeof *other; k++) {
        brink_run there;
        uint64_t corner[3];
        for (int a = 0; a < 3; a++)
            corner[a] = middle + other[k][a];
        make_drop(&there, corner);
        advance(&there, 3000);
        for (uint32_t i = 0; i < 600; i++) {
            const brink_particle *p = &here.system.particle[i],
                                 *q = &there.system.particle[i];
            for (int a = 0; a < 3; a++)
                ck_assert_msg(q->x[a] - p->x[a] == other[k][a] &&
                                  q->v[a] == p->v[a],
                              "place %zu, particle %u, axis %d: v %a, not %a", k,
                              i, a, q->v[a], p->v[a]);
        }
        ck_assert(brink_instant_compare(here.now, there.now) == 0);
        ck_assert(there.tally.contact_error_max == here.tally.contact_error_max);
        brink_run_destroy(&there);
    }
    brink_run_destroy(&here);
}
END_TEST

/** Where the last event was, as a distance from the origin. */
static double from_origin(const brink_run *run)
{
    double x[3];
    brink_system_position(&run->system, run->last.i, run->last.when.offset, x);
    return sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
}

/** What the error would be if positions were doubles that count from the origin:
 *  each coordinate rounded. */
static double contact_error_of_doubles(const brink_run *run)
{
    const brink_happening *e = &run->last;
    double x[3], y[3];
    brink_system_position(&run->system, e->i, e->when.offset, x);
    brink_system_position(&run->system, e->j, e->when.offset, y);
    for (int a = 0; a < 3; a++) {
        const double length = run->system.length[a];
        x[a] = remainder(x[a] - y[a], length);
    }
    return brink_ball_overlap(x, e->distance) / e->distance / e->distance / 2;
}

START_TEST(events_are_as_near_contact_far_from_the_origin)
{
    // A gas through all of a box of 1000 diameters, cut at 800 from the origin:
    // pi/6 0.8^3 = 0.268 of it are nearer.
    enum { EVENTS = 15000 };
    sample near, far, near_double, far_double;
    brink_run run;
    make_run(&run, "seed: 24\n"
                   "box: {size: [1000, 1000, 1000]}\n"
                   "species: {A: {count: 32000, diameter: 1}}\n"
                   "start: {random: true}\n");
    sample_make(&near, EVENTS);
    sample_make(&far, EVENTS);
    sample_make(&near_double, EVENTS);
    sample_make(&far_double, EVENTS);
    for (uint64_t n = 1; n <= EVENTS; n++) {
        advance(&run, n);
        const int is_near = from_origin(&run) < 800;
        sample *s = is_near ? &near : &far,
               *d = is_near ? &near_double : &far_double;
        s->value[s->count++] = contact_error(&run);
        d->value[d->count++] = contact_error_of_doubles(&run);
    }
    const double of_doubles = smirnov(&near_double, &far_double);
    printf("as doubles from the origin: Smirnov's distance %.2f\n", of_doubles);
    ck_assert_double_gt(of_doubles, SMIRNOV_MOST);
    expect_alike("within 800 of the origin", "beyond", &near, &far);
    free(near.value);
    free(far.value);
    free(near_double.value);
    free(far_double.value);
    brink_run_destroy(&run);
}
END_TEST

int main(void)
{
    return RUN_SUITE("longrun", 600,
                     a_run_is_the_same_bits_after_1e15_mean_free_times,
                     events_are_as_near_contact_after_1e15_mean_free_times,
                     a_drop_is_the_same_bits_wherever_it_is,
                     events_are_as_near_contact_far_from_the_origin);
}
