// SPDX-License-Identifier: MIT
/*
 * What must not change: energy and momentum over a million events, and the past,
 * when all velocities are reversed.
 */
#include "suite.h"
#include "systems.h"
#include <float.h>
#include <gsl/gsl_rng.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

// --- Energy and momentum -------------------------------------------------------

/** The largest |m v| along an axis and the largest kinetic energy of any
 *  particle. */
static void largest(const brink_system *s, double *momentum, double *energy)
{
    for (uint32_t i = 0; i < s->count; i++) {
        const brink_particle *p = &s->particle[i];
        const double m = s->species[p->species].mass;
        double sum = 0;
        for (int a = 0; a < 3; a++) {
            *momentum = fmax(*momentum, m * fabs(p->v[a]));
            sum += m * p->v[a] * p->v[a] / 2;
        }
        *energy = fmax(*energy, sum);
    }
}

/* An event may put momentum off by 2 ulp of the larger |m v| of the two
 * (<brink/impulse.h>); rounded to nearest, so with either sign: n events by
 * sqrt(n) of these, and by 4 sqrt(n) in one case of 16 000.
 *
 * What roundings take of the energy is put down, and paid at the next event as a
 * rule: it is off by no more than what the last few took, six components by half
 * an ulp each, and by a rounding of the sum, before and after. */
static void conserve(const char *name, const char *scene)
{
    const uint64_t events = suite_share(1000000);
    brink_run run;
    double momentum[3], most_momentum = 0, most_energy = 0, off = 0;
    make_run(&run, scene);
    for (uint64_t piece = 1; piece <= 100; piece++) {
        advance(&run, events / 100 * piece);
        largest(&run.system, &most_momentum, &most_energy);
    }
    const double ulps = 4 * sqrt((double)events) * DBL_EPSILON;
    const double most_owed = 4 * 6 * DBL_EPSILON * most_energy;
    const double most_off =
        most_owed + DBL_EPSILON * (run.kinetic_begin + fabs(run.energy_begin));
    const double energy = fabs(brink_run_energy(&run) - run.energy_begin);
    brink_system_momentum(&run.system, momentum);
    for (int a = 0; a < 3; a++)
        off = fmax(off, fabs(momentum[a] - run.momentum_begin[a]));
    printf("%s, %g events: momentum off by %.2g, %.2g allowed; energy by %.2g of "
           "the "
           "kinetic energy, %.2g allowed\n",
           name, (double)events, off, 2 * ulps * most_momentum,
           energy / run.kinetic_begin, most_off / run.kinetic_begin);
    fflush(stdout);
    ck_assert_double_le(off, 2 * ulps * most_momentum);
    ck_assert_double_le(fabs(run.owed), most_owed);
    ck_assert_double_le(energy, most_off);
    ck_assert_double_le(energy, 1e-15 * run.kinetic_begin); // as promised
    brink_run_destroy(&run);
}

START_TEST(energy_and_momentum_stay_for_a_million_events)
{
    conserve("hard spheres", hard_spheres);
    conserve("square well", square_well);
    conserve("square shoulder", square_shoulder);
    conserve("mixture, masses 1 and 30", mixture);
}
END_TEST

// --- Time reversal -------------------------------------------------------------

static void copy(brink_system *to, const brink_system *from)
{
    ck_assert_int_eq(brink_system_create(to, from->dimensions, from->length,
                                         from->year, from->count,
                                         from->species_count, from->species,
                                         from->potential),
                     0);
    memcpy(to->particle, from->particle, from->count * sizeof *to->particle);
}

static void start(brink_run *run, const brink_system *from)
{
    brink_system system;
    copy(&system, from);
    ck_assert_int_eq(brink_run_create(run, &system, BRINK_TIER_PLAIN), 0);
}

enum { MOST = 10000 };

typedef struct
    past { // the first events of a run, and half the way to the next one
    int count;
    brink_happening event[MOST];
    double before[MOST]; // time from the event to the end
    brink_instant end;
    brink_system reversed; // as it is then, with all velocities turned round
} past;

/** Half-way between two events no pair is at a surface: levels are what
 *  position says. */
static void past_make(past *p, const brink_system *begin, int count)
{
    brink_run run;
    start(&run, begin);
    advance(&run, (uint64_t)count + 1);
    const brink_instant next = run.last.when;
    brink_run_destroy(&run);

    start(&run, begin);
    p->count = count;
    for (int n = 0; n < count; n++) {
        advance(&run, (uint64_t)n + 1);
        p->event[n] = run.last;
    }
    const double half = brink_instant_since(begin->year, next, run.now) / 2;
    p->end = brink_instant_after(begin->year, run.now, half);
    ck_assert_int_eq(brink_run_advance(&run, UINT64_MAX, p->end),
                     BRINK_RUN_REACHED);
    for (int n = 0; n < count; n++)
        p->before[n] = brink_instant_since(begin->year, p->end, p->event[n].when);

    copy(&p->reversed, begin);
    brink_system_turn(&run.system, p->end.epoch);
    for (uint32_t i = 0; i < begin->count; i++) {
        brink_system_advance(&run.system, i, p->end.offset);
        for (int a = 0; a < begin->dimensions; a++) {
            p->reversed.particle[i].x[a] = run.system.particle[i].x[a];
            p->reversed.particle[i].v[a] = -run.system.particle[i].v[a];
        }
    }
    brink_run_destroy(&run);
}

/** How many of the past's events `run` undoes, the last one first: same pair,
 *  mirrored kind, and the time to 2^-6, as two particles have only one pair to
 *  meet. */
static int undone(const past *p, brink_run *run)
{
    static const enum brink_event_kind mirror[] = {
        [BRINK_CORE] = BRINK_CORE,
        [BRINK_CAPTURE] = BRINK_RELEASE,
        [BRINK_RELEASE] = BRINK_CAPTURE,
        [BRINK_BOUNCE] = BRINK_BOUNCE};
    for (int n = 0; n < p->count; n++) {
        const brink_happening *event = &p->event[p->count - 1 - n];
        advance(run, (uint64_t)n + 1);
        if (run->last.kind != mirror[event->kind] || run->last.i != event->i ||
            run->last.j != event->j ||
            fabs(brink_run_time(run) - p->before[p->count - 1 - n]) > 0x1p-6)
            return n;
    }
    return p->count;
}

START_TEST(two_in_a_line_go_back_over_ten_thousand_events)
{
    /* In a line deviations do not multiply.  After n events velocities are 4
     * sqrt(n) times 2 ulp off, relative; a flight between two events is
     * shorter than the box, 8, so after n of them positions are 8 n times that
     * off; and twice that there and back. */
    static past p;
    const double allowed = 2 * 8.0 * MOST * 4 * sqrt(MOST) * 2 * DBL_EPSILON;
    brink_system begin;
    brink_run run;
    double off = 0;
    make_system(&begin, "box: {size: [8, 8, 8]}\n"
                        "species: {A: {count: 1}, B: {count: 1, mass: 3}}\n"
                        "start: {lattice: sc}\n"
                        "potentials:\n"
                        "  - {between: [A, A], steps: [[2, -1], [1, .inf]]}\n"
                        "  - {between: [B, B], steps: [[2, -1], [1, .inf]]}\n");
    for (int i = 0; i < 2; i++)
        for (int a = 0; a < 3; a++) {
            const double x = a == 0 ? 2 + 3 * i : 4, v = a == 0 ? 1 - 1.7 * i : 0;
            begin.particle[i].x[a] = brink_system_fraction(&begin, a, x);
            begin.particle[i].v[a] = v;
        }
    past_make(&p, &begin, MOST);
    start(&run, &p.reversed);
    ck_assert_int_eq(undone(&p, &run), MOST);
    ck_assert_int_eq(brink_run_advance(&run, MOST + 1, p.end), BRINK_RUN_REACHED);
    for (uint32_t i = 0; i < 2; i++) {
        double x[3], there[3];
        brink_run_position(&run, i, x);
        brink_system_position(&begin, i, 0, there);
        for (int a = 0; a < 3; a++)
            off = fmax(off, fabs(x[a] - there[a]));
    }
    printf("two in a line, %d events there and back: off by %.2g, %.2g allowed\n",
           MOST, off, allowed);
    fflush(stdout);
    ck_assert_double_le(off, allowed);
    brink_system_destroy(&p.reversed);
    brink_run_destroy(&run);
    brink_system_destroy(&begin);
}
END_TEST

/** As many events as `past` undoes from its turning point when velocities are
 *  deflected by +-`by` relative there. */
static int undone_deflected(const past *p, double by, unsigned long signs)
{
    brink_system system;
    brink_run run;
    gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
    gsl_rng_set(rng, signs);
    copy(&system, &p->reversed);
    for (uint32_t i = 0; i < system.count; i++)
        for (int a = 0; a < 3; a++)
            system.particle[i].v[a] *=
                gsl_rng_uniform(rng) < 0.5 ? 1 - by : 1 + by;
    gsl_rng_free(rng);
    ck_assert_int_eq(brink_run_create(&run, &system, BRINK_TIER_PLAIN), 0);
    const int n = undone(p, &run);
    brink_run_destroy(&run);
    return n;
}

/** The way back is as chaotic as the way there, so events can be undone for as
 *  long as a deflection that stands for all roundings does not show.  An event's
 *  are less than 2^-47 (tests/sequence_test.c).  Deviations grow by a bit at
 *  least every 6 events here, so what is lost at later events adds less than
 *  1 / (1 - 2^(-1/6)) < 10 times the loss of one: 2^-43; two bits more, as four
 *  choices of signs are not all directions, and one, as there and back is twice
 *  the events: 2^-40. */
static void go_back(const char *name, const char *scene, int events)
{
    static past p;
    brink_system begin;
    make_system(&begin, scene);
    past_make(&p, &begin, events);
    const int parted = undone_deflected(&p, 0, 1);
    int floor = events;
    for (unsigned long signs = 1; signs <= 4; signs++) {
        const int n = undone_deflected(&p, 0x1p-40, signs);
        floor = n < floor ? n : floor;
    }
    printf("%s: %d of %d events undone, at least %d expected\n", name, parted,
           events, floor);
    fflush(stdout);
    ck_assert_int_ge(parted, floor);
    brink_system_destroy(&p.reversed);
    brink_system_destroy(&begin);
}

START_TEST(two_and_ten_go_back_until_chaos_has_eaten_the_digits)
{
    go_back("two spheres",
            "box: {size: [4, 5, 4.5]}\n"
            "species: {A: {count: 2, diameter: 1}}\n"
            "start: {random: true}\n",
            100);
    go_back("ten spheres",
            "box: {size: [4, 5, 4.5]}\n"
            "species: {A: {count: 10, diameter: 1}}\n"
            "start: {random: true}\n",
            1000);
    go_back("ten in each other's wells",
            "box: {size: [4, 5, 4.5]}\n"
            "species: {A: {count: 10}}\n"
            "start: {random: true}\n"
            "potentials:\n"
            "  - {between: [A, A], steps: [[1.5, -1], [1, .inf]]}\n",
            1000);
}
END_TEST

int main(void)
{
    return RUN_SUITE("conservation", 600,
                     energy_and_momentum_stay_for_a_million_events,
                     two_in_a_line_go_back_over_ten_thousand_events,
                     two_and_ten_go_back_until_chaos_has_eaten_the_digits);
}
