// SPDX-License-Identifier: MIT
#include "run_predict.h"
#include <brink/event_time.h>
#include <math.h>

typedef double event_time(const double r[3], const double v[3], double sigma);

static const struct {
    event_time *intersection, *disjoint;
} tiers[] = {
    [BRINK_TIER_FAST] = {brink_intersection_time_fast, brink_disjoint_time_fast},
    [BRINK_TIER_PLAIN] = {brink_intersection_time, brink_disjoint_time},
    [BRINK_TIER_CR] = {brink_intersection_time_cr, brink_disjoint_time_cr},
};

// The search for a slot's next pair event: the earliest found so far.
typedef struct search {
    const brink_run *run;
    uint32_t i;
    double offset;  // of now, in the current year
    double soonest; // offset + dt of `best`; its instant follows from this sum
    brink_entry best;
} search;

static void offer(search *s, uint32_t k, double dt, enum brink_entry_kind kind)
{
    const double sum = s->offset + dt;
    if (!(sum <= s->soonest) || isinf(sum))
        return;
    const brink_run *run = s->run;
    const brink_instant now = {run->system.epoch, s->offset};
    const brink_entry found = {
        .when = brink_instant_after(run->system.year, now, dt),
        .i = s->i < k ? s->i : k,
        .j = s->i < k ? k : s->i,
        .generation = run->system.particle[k].generation,
        .kind = (uint16_t)kind,
        .at_once = dt == 0,
    };
    if (brink_entry_compare(&found, &s->best) < 0) {
        s->best = found;
        s->soonest = sum;
    }
}

// Relative position and velocity of i and k, as i's prediction sees them.
static void relative(const search *s, uint32_t k, double r[3], double v[3])
{
    const brink_system *system = &s->run->system;
    brink_system_separation(system, s->i, k, s->offset, r);
    for (int a = 0; a < 3; a++)
        v[a] = system->particle[s->i].v[a] - system->particle[k].v[a];
    // With images the particles can drift past half the box from where they were.
    for (int a = 0; a < system->dimensions; a++)
        if (s->run->cells.images[a] > 1)
            r[a] -= system->length[a] * rint(r[a] / system->length[a]);
}

// A captured pair can meet the step inside and the step around it [S16 alg. 3].
static void predict_partner(search *s, uint32_t k, int level)
{
    const brink_potential *p = brink_system_potential(&s->run->system, s->i, k);
    const enum brink_tier tier = s->run->tier;
    double r[3], v[3];
    relative(s, k, r, v);
    if (level < p->count)
        offer(s, k, tiers[tier].intersection(r, v, p->distance[level]),
              BRINK_ENTRY_INWARD);
    offer(s, k, tiers[tier].disjoint(r, v, p->distance[level - 1]),
          BRINK_ENTRY_OUTWARD);
}

// An uncaptured pair can meet the outermost step, in any image.
static void predict_stranger(search *s, uint32_t k)
{
    const brink_run *run = s->run;
    const brink_potential *p = brink_system_potential(&run->system, s->i, k);
    double r[3], v[3];
    relative(s, k, r, v);
    for (int m = 0; m < run->images; m++) {
        const double *shift = run->image[m];
        const double image[3] = {r[0] + shift[0], r[1] + shift[1],
                                 r[2] + shift[2]};
        offer(s, k, tiers[run->tier].intersection(image, v, p->distance[0]),
              BRINK_ENTRY_INWARD);
    }
}

static void mark_partners(brink_run *run, uint32_t i, uint8_t mark)
{
    const brink_states *states = &run->states;
    for (uint32_t n = states->first[i]; n != BRINK_NO_LINK;
         n = states->link[n].next)
        run->mark[states->link[n].partner] = mark;
}

static void predict_strangers(search *s, const uint32_t *cells, int count)
{
    const brink_run *run = s->run;
    for (int n = 0; n < count; n++)
        for (uint32_t k = run->cells.first[cells[n]]; k != BRINK_NOBODY;
             k = run->cells.next[k])
            if (k != s->i && !run->mark[k])
                predict_stranger(s, k);
}

void brink_predict(brink_run *run, uint32_t i, double offset)
{
    const brink_states *states = &run->states;
    search s = {run, i, offset, (double)INFINITY, {.when = BRINK_NEVER}};
    uint32_t around[27];
    const int cells = brink_cells_around(&run->cells, run->cells.cell[i], around);
    for (uint32_t n = states->first[i]; n != BRINK_NO_LINK;
         n = states->link[n].next)
        predict_partner(&s, states->link[n].partner, states->link[n].level);
    mark_partners(run, i, 1);
    predict_strangers(&s, around, cells);
    mark_partners(run, i, 0);
    brink_calendar_set(&run->calendar, i, &s.best);
}

// Particle i has just come by `crossing`: only those ahead of it are new.  Its
// event with somebody it knew already stands, stale or not: a stale one is never
// too late.
void brink_predict_ahead(brink_run *run, uint32_t i, double offset,
                         brink_crossing crossing)
{
    const brink_entry *known = &run->calendar.entry[i];
    const brink_instant new_year = {run->system.epoch, 0.0};
    const double sum =
        brink_instant_since(run->system.year, known->when, new_year);
    search s = {run, i, offset, sum, *known};
    uint32_t ahead[27];
    const int cells =
        brink_cells_ahead(&run->cells, run->cells.cell[i], crossing, ahead);
    mark_partners(run, i, 1);
    predict_strangers(&s, ahead, cells);
    mark_partners(run, i, 0);
    brink_calendar_set(&run->calendar, i, &s.best);
}

void brink_predict_crossing(brink_run *run, uint32_t i, double offset)
{
    const brink_system *system = &run->system;
    brink_crossing next = {0, 0};
    const double dt = brink_cells_crossing(&run->cells, system, i, offset, &next);
    const brink_instant now = {system->epoch, offset};
    const brink_entry entry = {
        .when = brink_instant_after(system->year, now, dt),
        .i = i,
        .j = (uint32_t)(2 * next.axis + (next.way > 0)),
        .kind = BRINK_ENTRY_CELL,
    };
    brink_calendar_set(&run->calendar, system->count + i, &entry);
}
