// SPDX-License-Identifier: MIT
#include "run_predict.h"
#include "run_batch.h"
#include <math.h>

// The search for a slot's next pair event: the earliest found so far, and those
// who are still to be looked at.
typedef struct search {
    const brink_run *run;
    uint32_t i;
    double offset;  // of now, in the current year
    double soonest; // offset + dt of `best`; its instant follows from this sum
    brink_entry best;
    brink_batch inward, outward; // by the way they would meet the step
} search;

static void begin(search *s, const brink_run *run, uint32_t i, double offset)
{
    s->run = run;
    s->i = i;
    s->offset = offset;
    s->soonest = (double)INFINITY;
    s->best = (brink_entry){.when = BRINK_NEVER};
    s->inward.count = s->outward.count = 0;
}

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

// Offers what those in a batch have, and empties it: all that are not later than
// the earliest, which is that one alone as a rule.
static void look_at(search *s, brink_batch *b, brink_batch_times *times,
                    enum brink_entry_kind kind)
{
    double t[BRINK_BATCH], first = (double)INFINITY;
    if (b->count == 0)
        return;
    times((size_t)b->count, b->r[0], b->r[1], b->r[2], b->v[0], b->v[1], b->v[2],
          b->step, t);
    for (int n = 0; n < b->count; n++)
        first = t[n] < first ? t[n] : first;
    const double sum = s->offset + first;
    for (int n = 0; n < b->count; n++)
        if (s->offset + t[n] <= sum)
            offer(s, b->who[n], t[n], kind);
    b->count = 0;
}

static void look_inward(search *s)
{
    look_at(s, &s->inward, brink_batch_tiers[s->run->tier].intersection,
            BRINK_ENTRY_INWARD);
}

static void look_outward(search *s)
{
    look_at(s, &s->outward, brink_batch_tiers[s->run->tier].disjoint,
            BRINK_ENTRY_OUTWARD);
}

// Relative position and velocity of i and k, as i's prediction sees them.
static inline void relative(const search *s, uint32_t k, double r[3], double v[3])
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
static void add_partner(search *s, uint32_t k, int level)
{
    const brink_potential *p = brink_system_potential(&s->run->system, s->i, k);
    double r[3], v[3];
    relative(s, k, r, v);
    if (level < p->count &&
        brink_batch_add(&s->inward, k, r, v, p->distance[level]))
        look_inward(s);
    if (brink_batch_add(&s->outward, k, r, v, p->distance[level - 1]))
        look_outward(s);
}

// An uncaptured pair can meet the outermost step, in any image.
static inline void add_stranger(search *s, uint32_t k)
{
    const brink_run *run = s->run;
    const brink_potential *p = brink_system_potential(&run->system, s->i, k);
    double r[3], v[3];
    relative(s, k, r, v);
    for (int m = 0; m < run->images; m++) {
        const double *shift = run->image[m];
        const double image[3] = {r[0] + shift[0], r[1] + shift[1],
                                 r[2] + shift[2]};
        if (brink_batch_add(&s->inward, k, image, v, p->distance[0]))
            look_inward(s);
    }
}

static void add_partners(search *s)
{
    const brink_states *states = &s->run->states;
    for (uint32_t n = states->first[s->i]; n != BRINK_NO_LINK;
         n = states->link[n].next)
        add_partner(s, states->link[n].partner, states->link[n].level);
}

// Everybody in these cells but i and its partners.
static void add_strangers(search *s, const uint32_t *cells, int count)
{
    const brink_run *run = s->run;
    const uint64_t hint = brink_states_hint(&run->states, s->i);
    uint32_t who[BRINK_HANDFUL];
    brink_tour tour = brink_tour_of(cells, count);
    for (int n; (n = brink_tour_next(&run->cells, &tour, who)) > 0;)
        for (int m = 0; m < n; m++)
            if (who[m] != s->i &&
                !brink_states_is_partner(&run->states, s->i, who[m], hint))
                add_stranger(s, who[m]);
}

void brink_predict(brink_run *run, uint32_t i, double offset)
{
    search s;
    uint32_t around[27];
    begin(&s, run, i, offset);
    add_partners(&s);
    add_strangers(&s, around,
                  brink_cells_around(&run->cells, run->cells.cell[i], around));
    look_inward(&s);
    look_outward(&s);
    brink_calendar_set(&run->calendar, i, &s.best);
}

// Particle i has just come by `crossing`: only those ahead of it are new.  Its
// event with somebody it knew already stands, stale or not: a stale one is never
// too late.
void brink_predict_ahead(brink_run *run, uint32_t i, double offset,
                         brink_crossing crossing)
{
    const brink_instant new_year = {run->system.epoch, 0.0};
    search s;
    uint32_t ahead[27];
    begin(&s, run, i, offset);
    s.best = run->calendar.entry[i];
    s.soonest = brink_instant_since(run->system.year, s.best.when, new_year);
    add_strangers(
        &s, ahead,
        brink_cells_ahead(&run->cells, run->cells.cell[i], crossing, ahead));
    look_inward(&s);
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
