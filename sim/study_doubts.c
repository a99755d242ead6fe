// SPDX-License-Identifier: MIT
#include "study_doubts.h"
#include "conventional_method.h"
#include <brink/event_time.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

// A pair at a step, and where it is.
typedef struct look {
    const brink_potential *potential;
    double distance; // of the step
    double r[3];
    int shown; // the level that r shows
    int place; // of |g(r)| among those counted
} look;

// |r| - sigma = f / (|r| + sigma), and f = r.r - sigma^2 in twice the precision.
static int place_of(const look *l)
{
    brink_sum f = {0};
    for (int a = 0; a < 3; a++)
        brink_sum_product(&f, l->r[a], l->r[a]);
    const double size = sqrt(f.sum), sigma = l->distance;
    brink_sum_product(&f, -sigma, sigma);
    int exponent; // 2^(exponent-1) <= gap
    frexp(brink_sum_value(&f) / ((size + sigma) * sigma), &exponent);
    const int place = 1 - exponent;
    return !(fabs(brink_sum_value(&f)) > 0) || place >= BRINK_GAPS
               ? BRINK_GAPS - 1
           : place < 0 ? 0
                       : place;
}

static void show(look *l)
{
    l->shown = brink_level_by_position(l->potential, l->r);
    l->place = place_of(l);
}

static look look_at(const brink_run *run, uint32_t i, uint32_t j, double distance)
{
    look l = {.potential = brink_system_potential(&run->system, i, j),
              .distance = distance};
    brink_separation_now(run, i, j, l.r);
    show(&l);
    return l;
}

static int is_core(const look *l)
{
    const brink_potential *p = l->potential;
    return isinf(p->energy[p->count - 1]) &&
           l->distance == p->distance[p->count - 1];
}

static void count(brink_doubt *d, const look *l, int level)
{
    d->looks++;
    if (is_core(l)) { // no state ends here, and s(r) is far from any other
        d->wrong += l->shown != level;
        return;
    }
    d->within[l->place]++;
    if (l->shown != level) {
        d->wrong++;
        d->wrong_by[l->place]++;
    }
}

static uint64_t sum(const uint64_t *counts, int from, int to)
{
    uint64_t all = 0;
    for (int k = from; k <= to; k++)
        all += counts[k];
    return all;
}

uint64_t brink_doubt_beyond(const brink_doubt *d, int exponent)
{
    return sum(d->wrong_by, 0, exponent);
}

uint64_t brink_doubt_within(const brink_doubt *d, int exponent)
{
    return sum(d->within, exponent + 1, BRINK_GAPS - 1);
}

// Particle i's slot has been filled anew.
static void remember_prediction(brink_doubter *d, const brink_run *run,
                                uint32_t i)
{
    const brink_entry *e = &run->calendar.entry[i];
    const brink_particle *particle = run->system.particle;
    brink_memory *m = &d->memory[i];
    m->when = BRINK_NEVER;
    if (e->when.epoch == INT64_MAX || e->kind == BRINK_ENTRY_CELL)
        return;
    m->when = run->now;
    brink_separation_now(run, e->i, e->j, m->r);
    for (int a = 0; a < 3; a++)
        m->v[a] = particle[e->i].v[a] - particle[e->j].v[a];
}

int brink_doubter_create(brink_doubter *d, const brink_run *run)
{
    memset(d, 0, sizeof *d);
    d->particles = run->system.count;
    d->memory = calloc(d->particles, sizeof *d->memory);
    if (d->memory == NULL)
        return -1;
    for (uint32_t i = 0; i < d->particles; i++) {
        d->memory[i].met = d->memory[i].untested = BRINK_NOBODY;
        remember_prediction(d, run, i);
    }
    return 0;
}

void brink_doubter_destroy(brink_doubter *d)
{
    free(d->memory);
    d->memory = NULL;
}

// Everybody near particle i is tested: so is the pair that it was in.
static void look_tested(brink_doubter *d, const brink_run *run, uint32_t i)
{
    const uint32_t j = d->memory[i].untested;
    if (j == BRINK_NOBODY)
        return;
    const look l = look_at(run, i, j, d->memory[i].distance);
    count(&d->seen.of[BRINK_DOUBT_TESTED], &l,
          brink_states_level(&run->states, i, j));
    d->memory[i].untested = d->memory[j].untested = BRINK_NOBODY;
}

// Particle i has had an event with somebody else than it had one with before.
static void look_next(brink_doubter *d, const brink_run *run, uint32_t i)
{
    const uint32_t j = d->memory[i].met;
    look_tested(d, run, i);
    if (j == BRINK_NOBODY)
        return;
    const look l = look_at(run, i, j, d->memory[i].distance);
    count(&d->seen.of[BRINK_DOUBT_NEXT], &l,
          brink_states_level(&run->states, i, j));
    d->memory[i].met = d->memory[j].met = BRINK_NOBODY;
}

// The pair of the event before, at this one.
static void look_back(brink_doubter *d, const brink_run *run,
                      const brink_happening *before)
{
    const uint32_t i = before->i, j = before->j;
    if (d->seen.events == 0 || (i == run->last.i && j == run->last.j))
        return;
    const look l = look_at(run, i, j, before->distance);
    count(&d->seen.of[BRINK_DOUBT_SYSTEM], &l,
          brink_states_level(&run->states, i, j));
}

// The separation that the event was predicted from, and that brought to now.
static void look_stored(brink_doubter *d, const brink_run *run,
                        const brink_memory *m, look l)
{
    const int level = run->last.level_before;
    const double dt = brink_instant_since(run->system.year, run->now, m->when);
    memcpy(l.r, m->r, sizeof l.r);
    show(&l);
    count(&d->seen.of[BRINK_DOUBT_STORED], &l, level);
    for (int a = 0; a < 3; a++)
        l.r[a] += m->v[a] * dt;
    show(&l);
    count(&d->seen.of[BRINK_DOUBT_MOVED], &l, level);
}

// 0 never, 1 now, 2 later.
static int sort(double t)
{
    return isinf(t) ? 0 : t > 0 ? 2 : 1;
}

static void compare(brink_answers *a, double answer, double right)
{
    a->asked++;
    if (sort(answer) != sort(right))
        a->other++;
    else if (sort(right) == 2)
        a->astray += fabs(answer - right) > 0x1p-20 * right;
}

static void ask(brink_doubter *d, const brink_run *run, const look *l)
{
    const brink_potential *p = l->potential;
    const brink_particle *i = &run->system.particle[run->last.i];
    const brink_particle *j = &run->system.particle[run->last.j];
    const int level = run->last.level_after;
    const double v[3] = {i->v[0] - j->v[0], i->v[1] - j->v[1], i->v[2] - j->v[2]};
    brink_answers *a = d->seen.answers;
    if (level < p->count) {
        const double in = p->distance[level];
        compare(&a[BRINK_FORMULA_INWARD],
                brink_intersection_time_as_printed(l->r, v, in),
                brink_intersection_time(l->r, v, in));
    }
    if (level > 0) {
        const double out = p->distance[level - 1];
        const double right = brink_disjoint_time(l->r, v, out);
        compare(&a[BRINK_FORMULA_OUTWARD],
                brink_disjoint_time_put_right(l->r, v, out), right);
        compare(&a[BRINK_FORMULA_PRINTED],
                brink_disjoint_time_as_printed(l->r, v, out), right);
    }
}

// The run has executed an event, which was due in `slot` with the entry `due`.
static void look_event(brink_doubter *d, const brink_run *run, uint32_t slot,
                       const brink_entry *due, const brink_happening *before)
{
    const brink_happening *last = &run->last;
    const uint32_t i = last->i, j = last->j;
    const look l = look_at(run, i, j, last->distance);
    count(&d->seen.of[BRINK_DOUBT_EXECUTED], &l, last->level_before);
    count(&d->seen.of[BRINK_DOUBT_AFTER], &l, last->level_after);
    // Two at one instant: `due` may have been a crossing, and the event the next.
    if (due->kind != BRINK_ENTRY_CELL && due->i == i && due->j == j)
        look_stored(d, run, &d->memory[slot], l);
    d->seen.overlaps += last->kind == BRINK_CORE &&
                        brink_step_level_at(l.potential, l.r) > l.shown;
    ask(d, run, &l);
    look_back(d, run, before);
    d->seen.events++;
    if (d->memory[i].met != j) {
        look_next(d, run, i);
        look_next(d, run, j);
    }
    d->memory[i].met = d->memory[i].untested = j;
    d->memory[j].met = d->memory[j].untested = i;
    d->memory[i].distance = d->memory[j].distance = last->distance;
    remember_prediction(d, run, i);
    remember_prediction(d, run, j);
}

// One step of the calendar: an event; or a crossing, or a prediction made anew.
static enum brink_run_status step(brink_doubter *d, brink_run *run,
                                  uint64_t *events)
{
    const uint32_t slot = brink_calendar_next(&run->calendar);
    if (slot == run->calendar.slots)
        return BRINK_RUN_AT_REST;
    const brink_entry due = run->calendar.entry[slot];
    const brink_happening before = run->last;
    const enum brink_run_status status =
        brink_run_advance(run, *events + 1, due.when);
    if (status != BRINK_RUN_REACHED)
        return status;
    if (brink_tally_events(&run->tally) > *events) {
        look_event(d, run, slot, &due, &before);
        ++*events;
    } else {
        look_tested(d, run, slot);
        remember_prediction(d, run, slot);
    }
    return status;
}

enum brink_run_status brink_doubter_advance(brink_doubter *d, brink_run *run,
                                            uint64_t events)
{
    enum brink_run_status status = BRINK_RUN_REACHED;
    uint64_t done = brink_tally_events(&run->tally);
    while (status == BRINK_RUN_REACHED && done < events)
        status = step(d, run, &done);
    return status;
}
