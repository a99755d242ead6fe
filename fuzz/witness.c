// SPDX-License-Identifier: MIT
#include "adverse.h"
#include "fuzz.h"
#include "witness_parts.h"
#include <inttypes.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#define EPS 0x1p-53

void witness_break(const witness *w, const char *format, ...)
{
    const brink_happening *e = &w->run->last;
    va_list list;
    va_start(list, format);
    fputs("finding: run: ", stderr);
    vfprintf(stderr, format, list);
    va_end(list);
    fprintf(stderr,
            "\n  // tier %d, at event %" PRIu64
            ", year %lld, offset %a: kind %d, "
            "%u and %u, level %d -> %d at %a\n",
            (int)w->run->tier, brink_tally_events(&w->run->tally),
            (long long)w->run->now.epoch, w->run->now.offset, (int)e->kind, e->i,
            e->j, e->level_before, e->level_after, e->distance);
    adverse_tell(&w->begin);
    finding_end();
}

int *witness_level(const witness *w, uint32_t i, uint32_t j)
{
    return &w->level[i < j ? i * w->begin.count + j : j * w->begin.count + i];
}

double witness_contact_bound(const witness *w)
{
    const brink_system *s = &w->begin;
    const double length = fmax(s->length[0], fmax(s->length[1], s->length[2]));
    return EPS * (75 * length + 4 * w->speed * s->year);
}

// --- What a system has ---------------------------------------------------------

static double mass(const brink_system *s, uint32_t i)
{
    return s->species[s->particle[i].species].mass;
}

static long double kinetic(const brink_system *s)
{
    long double sum = 0;
    for (uint32_t i = 0; i < s->count; i++)
        for (int a = 0; a < 3; a++) {
            const long double v = s->particle[i].v[a];
            sum += mass(s, i) * v * v / 2;
        }
    return sum;
}

static long double potential(const witness *w)
{
    const brink_system *s = &w->begin;
    long double sum = 0;
    for (uint32_t i = 0; i < s->count; i++)
        for (uint32_t j = i + 1; j < s->count; j++) {
            const int level = *witness_level(w, i, j);
            if (level > 0)
                sum += brink_system_potential(s, i, j)->energy[level - 1];
        }
    return sum;
}

static void remember_largest(witness *w)
{
    const brink_system *s = &w->run->system;
    w->energy_most = fmax(w->energy_most, (double)kinetic(s));
    for (uint32_t i = 0; i < s->count; i++) {
        const double *v = s->particle[i].v;
        const double speed = hypot(hypot(v[0], v[1]), v[2]);
        w->speed = fmax(w->speed, speed);
        w->momentum_most = fmax(w->momentum_most, mass(s, i) * speed);
    }
}

// --- Before and after ----------------------------------------------------------

static void copy_before(witness *w)
{
    const brink_system *now = &w->run->system;
    memcpy(w->before.particle, now->particle, now->count * sizeof *now->particle);
    w->before.epoch = now->epoch;
    w->since = w->run->now;
}

void witness_begin(witness *w, const brink_run *run)
{
    const brink_system *s = &run->system;
    *w = (witness){.run = run, .energy = 0};
    adverse_copy(&w->begin, s);
    adverse_copy(&w->before, s);
    w->level = calloc((size_t)s->count * s->count, sizeof *w->level);
    for (uint32_t i = 0; i < s->count; i++)
        for (uint32_t j = i + 1; j < s->count; j++) {
            const brink_potential *p = brink_system_potential(s, i, j);
            *witness_level(w, i, j) = brink_states_level(&run->states, i, j);
            for (int k = 0; k < p->count; k++)
                w->energies += isinf(p->energy[k]) ? 0 : fabs(p->energy[k]);
        }
    w->energy = kinetic(s) + potential(w);
    brink_system_momentum(s, w->momentum);
    w->since = run->now;
    remember_largest(w);
}

void witness_end(witness *w)
{
    brink_system_destroy(&w->begin);
    brink_system_destroy(&w->before);
    free(w->level);
}
// --- What is kept --------------------------------------------------------------

static void look_at_levels(const witness *w)
{
    for (uint32_t i = 0; i < w->begin.count; i++)
        for (uint32_t j = i + 1; j < w->begin.count; j++) {
            const int got = brink_states_level(&w->run->states, i, j);
            if (got != *witness_level(w, i, j))
                witness_break(w, "%u and %u at level %d, and by the log at %d", i,
                              j, got, *witness_level(w, i, j));
        }
}

/* An event changes energy and what is owed by 2^-96 of the largest kinetic energy
 * (<brink/impulse.h>): that is less than what is rounded here, by 2^-64 a term in
 * sums of a few terms a particle, each three products.  A rise is the difference
 * of two energies, rounded: on its way a pair may be off by 2^-53 of each. */
static void look_at_energy(const witness *w)
{
    const brink_system *s = &w->run->system;
    const long double now = kinetic(s) + potential(w) + w->run->owed;
    const double events = (double)brink_tally_events(&w->counted);
    const double kept = 0x1p-64 * 16 * s->count * (w->energy_most + w->energies) +
                        events * 0x1p-96 * w->energy_most + 2 * EPS * w->energies;
    if (!(fabsl(now - w->energy) <= kept))
        witness_break(w, "energy is off by %La, at most %a allowed",
                      now - w->energy, kept);
    // A rounding an axis and particle takes 2^-53 of m v^2, twice the energy.
    const double owed = events * 12 * EPS * w->energy_most;
    if (!(fabs(w->run->owed) <= owed))
        witness_break(w, "%a is owed, at most %a", w->run->owed, owed);
}

/** 2 ulp of the larger |m v| an event (<brink/impulse.h>), and the two sums'. */
static void look_at_momentum(const witness *w)
{
    double now[3];
    const double events = (double)brink_tally_events(&w->counted);
    const double kept =
        (2 * 2 * events + 4 * w->begin.count) * EPS * w->momentum_most;
    brink_system_momentum(&w->run->system, now);
    for (int a = 0; a < 3; a++)
        if (!(fabs(now[a] - w->momentum[a]) <= kept))
            witness_break(w, "momentum is off by %a, at most %a allowed",
                          now[a] - w->momentum[a], kept);
}

static void look_at_tallies(const witness *w)
{
    const brink_tally *t = &w->run->tally, *c = &w->counted;
    if (t->core != c->core || t->capture != c->capture ||
        t->release != c->release || t->bounce != c->bounce || t->wall != 0)
        witness_break(w, "the events are miscounted");
    if (t->zero_time != c->zero_time || t->repeated > t->zero_time)
        witness_break(
            w, "%" PRIu64 " events at one instant with another, not %" PRIu64,
            t->zero_time, c->zero_time);
    if (t->refused != 0 || t->rim > t->bounce + t->core ||
        !isfinite(t->virial.sum) || t->clamped > brink_tally_events(t))
        witness_break(w, "an anomaly that cannot be");
    if (t->contact_error_max != c->contact_error_max)
        witness_break(w, "the largest contact error is %a, not %a",
                      t->contact_error_max, c->contact_error_max);
}

void witness_look(witness *w, int event)
{
    if (brink_instant_compare(w->run->now, w->since) < 0)
        witness_break(w, "time runs back");
    witness_look_at_flights(w);
    remember_largest(w);
    if (event)
        witness_look_at_event(w);
    look_at_levels(w);
    look_at_energy(w);
    look_at_momentum(w);
    look_at_tallies(w);
    const char *fault = brink_run_is_valid(w->run);
    if (fault)
        witness_break(w, "%s", fault);
    copy_before(w);
}
