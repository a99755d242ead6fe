// SPDX-License-Identifier: MIT
#include "witness.h"
#include "adverse.h"
#include "fuzz.h"
#include <brink/impulse.h>
#include <brink/overlap.h>
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

static int *level_of(const witness *w, uint32_t i, uint32_t j)
{
    return &w->level[i < j ? i * w->begin.count + j : j * w->begin.count + i];
}

/* How far a pair may be from where its level says.  In units of 2^-53:
 *
 * A prediction looks at a pair whose nearest image is at most sqrt(3)/2 L away, L
 * the longest side, and each flies at most sqrt(3) L until it is looked at anew:
 * a particle crosses a cell, at most L/3 wide, or departs from home, and who
 * meets it has come no further than to it.  Its time is within 16 (8 ulp), which
 * the pair flies L in; or, by the fast tier, the pair within 16 (L + sigma).  The
 * separation that it is predicted from has some 6 roundings of lengths below 3 L
 * on each of three axes; the same again when the event is executed.  A position
 * is rounded whenever it is written down, by 3 of the flight since, and by half a
 * unit of 2^-64 L.  Flights add up to those above; times of writing down are
 * events of the run, which are few enough to forget their units.  In all some
 * 16 sqrt(3) + 2 * 6 * 3 + 3 * 2 sqrt(3) < 75 L.
 *
 * The instant is rounded to 1 of a year and what follows, offsets are subtracted,
 * twice a particle: 4 years' flight. */
static double contact_bound(const witness *w)
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
            const int level = *level_of(w, i, j);
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
            *level_of(w, i, j) = brink_states_level(&run->states, i, j);
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

// --- The paths between two events ----------------------------------------------

/** The nearest and the furthest that |r + v t| gets from 0 to h. */
static void extremes(const long double r[3], const long double v[3],
                     long double h, long double *least, long double *most)
{
    long double a = 0, b = 0, t = 0, end[3] = {0};
    for (int k = 0; k < 3; k++) {
        a += v[k] * v[k];
        b += v[k] * r[k];
    }
    if (a > 0)
        t = fminl(fmaxl(-b / a, 0), h);
    for (int k = 0; k < 3; k++) {
        const long double x = r[k] + v[k] * t, z = r[k] + v[k] * h;
        end[0] += r[k] * r[k];
        end[1] += z * z;
        end[2] += x * x;
    }
    *least = sqrtl(fminl(end[2], fminl(end[0], end[1])));
    *most = sqrtl(fmaxl(end[0], end[1]));
}

/** Which images, -1, 0, 1 lengths along an axis, come within `reach`; how many.
 */
static int images_in_reach(long double x, long double v, long double h,
                           double length, double reach, long double at[3])
{
    int n = 0;
    for (int shift = -1; shift <= 1; shift++) {
        const long double here = x + shift * length, there = here + v * h;
        if (!((here > reach && there > reach) ||
              (here < -reach && there < -reach)))
            at[n++] = here;
    }
    return n;
}

/** A captured pair has one image that is where its level says; all others, and
 *  all of a pair that is not, are outside of the outermost step. */
static void look_at_path(const witness *w, uint32_t i, uint32_t j,
                         const long double r[3], const long double v[3],
                         long double h)
{
    const brink_system *s = &w->begin;
    const brink_potential *p = brink_system_potential(s, i, j);
    const int level = *level_of(w, i, j);
    const double off = contact_bound(w), reach = p->distance[0] + off;
    const double inner = level < p->count ? p->distance[level] - off : -1;
    const double outer = level > 0 ? p->distance[level - 1] + off : reach;
    long double at[3][3] = {{0}}; // of a plane 0 is all there is
    int n[3] = {1, 1, 1}, inside = 0, right = level == 0;
    for (int a = 0; a < (s->dimensions == 3 ? 3 : 2); a++)
        n[a] = images_in_reach(r[a], v[a], h, s->length[a], reach, at[a]);
    for (int k = 0; k < n[0] * n[1] * n[2]; k++) {
        const long double image[3] = {at[0][k % n[0]], at[1][k / n[0] % n[1]],
                                      at[2][k / n[0] / n[1]]};
        long double least, most;
        extremes(image, v, h, &least, &most);
        inside += least < p->distance[0] - off;
        right |= least >= inner && most <= outer;
    }
    if (!right || inside > (level > 0))
        witness_break(
            w,
            "%u and %u at level %d are not where it says: r = {%La, %La, "
            "%La}, v = {%La, %La, %La}, for %La",
            i, j, level, r[0], r[1], r[2], v[0], v[1], v[2], h);
}

enum { PARTS = 64 }; // of a flight; longer ones are looked at no further

/** In parts of which none is longer than a quarter of the box, so that the images
 *  around the nearest are all there are. */
static void look_at_flight(const witness *w, uint32_t i, uint32_t j,
                           long double left)
{
    const brink_system *s = &w->before;
    const brink_particle *p = &s->particle[i], *q = &s->particle[j];
    const brink_instant year = {s->epoch, 0};
    const long double now = brink_instant_since(s->year, w->since, year);
    long double x[3], v[3], part = left;
    for (int a = 0; a < 3; a++) {
        v[a] = (long double)p->v[a] - q->v[a];
        x[a] = (int64_t)(p->x[a] - q->x[a]) * (long double)s->unit[a] +
               p->v[a] * (now - p->since) - q->v[a] * (now - q->since);
        if (a < s->dimensions)
            part = fminl(part, s->length[a] / 4 / fabsl(v[a]));
    }
    for (int n = 0; n < PARTS && left >= 0; n++, left -= part) {
        for (int a = 0; a < (s->dimensions == 3 ? 3 : 2); a++)
            x[a] -= s->length[a] * rintl(x[a] / s->length[a]);
        look_at_path(w, i, j, x, v, fminl(part, left));
        for (int a = 0; a < 3; a++)
            x[a] += v[a] * part;
        if (!(part < left))
            return;
    }
}

static void look_at_flights(const witness *w)
{
    const long double h =
        brink_instant_since(w->begin.year, w->run->now, w->since);
    for (uint32_t i = 0; i < w->begin.count; i++)
        for (uint32_t j = i + 1; j < w->begin.count; j++)
            look_at_flight(w, i, j, h);
}

// --- The event -----------------------------------------------------------------

/** [S16 fig. 1]: what it does to a level, and which step it is at. */
static int is_legal(const brink_potential *p, const brink_happening *e, int level,
                    enum brink_direction *way)
{
    const double inner = level < p->count ? p->distance[level] : -1;
    const int core = level < p->count && isinf(p->energy[level]);
    const int change = (e->kind == BRINK_CAPTURE) - (e->kind == BRINK_RELEASE);
    *way = e->distance == inner ? BRINK_INWARD : BRINK_OUTWARD;
    if (e->level_before != level || e->level_after != level + change)
        return 0;
    if (*way == BRINK_OUTWARD &&
        (level == 0 || e->distance != p->distance[level - 1]))
        return 0;
    return e->kind == BRINK_CORE      ? core && *way == BRINK_INWARD
           : e->kind == BRINK_CAPTURE ? !core && *way == BRINK_INWARD
           : e->kind == BRINK_RELEASE ? *way == BRINK_OUTWARD
                                      : *way == BRINK_OUTWARD || !core;
}

/* At the step, and on its way to it: the radial speed may have the other sign by
 * what the separation's error turns the line of centres. */
static void look_at_contact(witness *w, enum brink_direction way)
{
    const brink_run *run = w->run;
    const brink_happening *e = &run->last;
    const double bound = contact_bound(w);
    double r[3], square = 0, b = 0, speed = 0;
    brink_system_separation(&run->system, e->i, e->j, e->when.offset, r);
    for (int a = 0; a < 3; a++) {
        const double v =
            w->before.particle[e->i].v[a] - w->before.particle[e->j].v[a];
        square += r[a] * r[a];
        b += r[a] * v;
        speed += v * v;
    }
    const double distance = sqrt(square);
    const double off = fabs(distance - e->distance);
    w->counted.contact_error_max =
        fmax(w->counted.contact_error_max, off / e->distance);
    if (!(off <= bound))
        witness_break(w, "an event %a off its step, at most %a allowed", off,
                      bound);
    if (!((int)way * b >= -4 * sqrt(speed) * bound))
        witness_break(w, "an event of a pair that goes the other way: b = %a", b);
}

// BRINK_RIM_ANGLE of their relative speed is then 2^-48 of their speeds.
int witness_is_hidden(const witness *w, uint32_t i, uint32_t j)
{
    const double *vi = w->run->system.particle[i].v;
    const double *vj = w->run->system.particle[j].v;
    double apart = 0, together = 0;
    for (int a = 0; a < 3; a++) {
        apart += (vi[a] - vj[a]) * (vi[a] - vj[a]);
        together += vi[a] * vi[a] + vj[a] * vj[a];
    }
    return apart <= 0x1p-48 * together;
}

/* In through all steps and out again, and once more for a contact a rounding off.
 * A pair that bounced on without time moving on would be held up for ever: the
 * rim rule of <brink/impulse.h>. */
static void look_at_progress(witness *w, const brink_happening *e, int again)
{
    const int steps = brink_system_potential(&w->begin, e->i, e->j)->count;
    const int same = again && e->i == w->last.i && e->j == w->last.j;
    w->repeats = same ? w->repeats + 1 : 0;
    w->last = *e;
    if (w->repeats > 2 * steps + 1 && !witness_is_hidden(w, e->i, e->j))
        witness_break(w, "%d events of one pair at one instant", w->repeats + 1);
}

/* Who is turned back goes the other way afterwards: from a step's inside at the
 * angle of the rim rule or more, from its outside, or a core, not in again,
 * unless the two move together so fast that their roundings hide it. */
static void look_at_parting(const witness *w, enum brink_direction way)
{
    const brink_system *s = &w->run->system;
    const brink_happening *e = &w->run->last;
    const double *vi = s->particle[e->i].v, *vj = s->particle[e->j].v;
    double r[3], v[3], square = 0, speed = 0, b = 0;
    if (e->level_before != e->level_after || witness_is_hidden(w, e->i, e->j))
        return;
    brink_system_separation(s, e->i, e->j, e->when.offset, r);
    for (int a = 0; a < 3; a++) {
        v[a] = vi[a] - vj[a];
        square += r[a] * r[a];
        speed += v[a] * v[a];
        b += r[a] * v[a];
    }
    // Velocities are rounded to 2^-53 of themselves, so the angle to 2^-5 of it.
    if (way == BRINK_OUTWARD &&
        -b < BRINK_RIM_ANGLE * (1 - 0x1p-4) * sqrt(square * speed))
        witness_break(w, "a bounce along the rim: b = %a", b);
    if (way == BRINK_INWARD && brink_ball_overlap_rate_sign(r, v) < 0)
        witness_break(w, "turned back, and still going in: b = %a", b);
}

static void count(witness *w, const brink_happening *e)
{
    brink_tally *t = &w->counted;
    uint64_t *const kinds[] = {&t->core, &t->capture, &t->release, &t->bounce};
    const int again = brink_tally_events(t) > 0 &&
                      brink_instant_compare(e->when, w->since) == 0;
    ++*kinds[e->kind];
    t->zero_time += (uint64_t)again;
    look_at_progress(w, e, again);
}

static void look_at_event(witness *w)
{
    const brink_happening *e = &w->run->last;
    enum brink_direction way;
    if (e->i >= e->j || e->j >= w->begin.count)
        witness_break(w, "an event of no pair");
    int *level = level_of(w, e->i, e->j);
    if (!is_legal(brink_system_potential(&w->begin, e->i, e->j), e, *level, &way))
        witness_break(w, "an event that is not legal at level %d", *level);
    if (brink_instant_compare(e->when, w->run->now) != 0)
        witness_break(w, "an event at another instant than now");
    look_at_contact(w, way);
    look_at_parting(w, way);
    count(w, e);
    *level = e->level_after;
}

// --- What is kept --------------------------------------------------------------

static void look_at_levels(const witness *w)
{
    for (uint32_t i = 0; i < w->begin.count; i++)
        for (uint32_t j = i + 1; j < w->begin.count; j++) {
            const int got = brink_states_level(&w->run->states, i, j);
            if (got != *level_of(w, i, j))
                witness_break(w, "%u and %u at level %d, and by the log at %d", i,
                              j, got, *level_of(w, i, j));
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
    look_at_flights(w);
    remember_largest(w);
    if (event)
        look_at_event(w);
    look_at_levels(w);
    look_at_energy(w);
    look_at_momentum(w);
    look_at_tallies(w);
    const char *fault = brink_run_is_valid(w->run);
    if (fault)
        witness_break(w, "%s", fault);
    copy_before(w);
}
