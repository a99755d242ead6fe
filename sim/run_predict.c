// SPDX-License-Identifier: MIT
#include <brink/path.h>

#include "run_batch.h"
#include "run_predict.h"
#include <math.h>
#include <string.h>

// Memory is asked for before it is needed, many places at once.
#define BRINK_PREFETCH(address) __builtin_prefetch(address)

// The search for what particle i waits for: the earliest found so far, and those
// who are still to be looked at.
typedef struct search {
    brink_run *run;
    uint32_t i;
    double offset;  // of now, in the current year
    double soonest; // that of `best`, whose instant follows from it
    brink_entry best;
    brink_batch inward, outward; // by the way they would meet the step
} search;

static void offer(search *s, uint32_t k, double dt, enum brink_entry_kind kind)
{
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
        s->soonest = s->offset + dt;
    }
}

// The earliest of some times, which have room for three more; +inf of none.
static double first_of(double *t, int count)
{
    double first[4] = {(double)INFINITY, (double)INFINITY, (double)INFINITY,
                       (double)INFINITY};
    for (int n = count; n % 4 != 0; n++)
        t[n] = (double)INFINITY;
    // In fours, which do not wait for each other.
    for (int n = 0; n < count; n += 4)
        for (int k = 0; k < 4; k++)
            first[k] = t[n + k] < first[k] ? t[n + k] : first[k];
    const double a = first[0] < first[1] ? first[0] : first[1];
    const double b = first[2] < first[3] ? first[2] : first[3];
    return a < b ? a : b;
}

// Offers what those in a batch have, and empties it: all that are not later than
// the earliest, which is that one alone as a rule.
static void look_at(search *s, brink_batch *b, brink_batch_times *times,
                    enum brink_entry_kind kind)
{
    double t[BRINK_BATCH];
    const int count = b->count;
    b->count = 0;
    if (count == 0)
        return;
    times((size_t)count, b->r[0], b->r[1], b->r[2], b->v[0], b->v[1], b->v[2],
          b->step, t);
    const double offset = s->offset, first = offset + first_of(t, count);
    if (!(first <= s->soonest) || isinf(first))
        return;
    int who = 0, ties = 0;
    for (int n = 0; n < count; n++) {
        const int is_first = offset + t[n] <= first;
        ties += is_first;
        who = is_first ? n : who;
    }
    if (ties == 1)
        offer(s, b->who[who], t[who], kind);
    else
        for (int n = 0; n < count; n++)
            if (offset + t[n] <= first)
                offer(s, b->who[n], t[n], kind);
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

// All axes at once, in three lanes of four.
typedef double lanes __attribute__((vector_size(32)));
typedef uint64_t units __attribute__((vector_size(32))); // they wrap around
typedef int64_t way_round __attribute__((vector_size(32)));
_Static_assert(offsetof(brink_particle, v) == 24 &&
                   offsetof(brink_particle, since) == 48,
               "four lanes from x[0] or v[0] are inside a particle");

static inline void load(units *x, lanes *v, const brink_particle *p)
{
    memcpy(x, p, sizeof *x);
    memcpy(v, (const char *)p + offsetof(brink_particle, v), sizeof *v);
}

// Adds those of `who` to a batch that has room for them, in their nearest images,
// as brink_system_separation has them, with their outermost steps.  A run spends
// most of its time here.
static void add_nearest(const search *s, brink_batch *b, const uint32_t *who,
                        int count)
{
    const brink_system *system = &s->run->system;
    const brink_particle *const particle = system->particle, *p = &particle[s->i];
    const brink_potential *const with =
        &system->potential[p->species * (uint32_t)system->species_count];
    const double offset = s->offset, *u = system->unit;
    const lanes unit = {u[0], u[1], u[2], 0.0};
    units px, qx;
    lanes pv, qv;
    load(&px, &pv, p);
    const lanes way = pv * (offset - p->since);
    const int begin = b->count, end = begin + count;
    for (int n = begin; n < end; n++) {
        const uint32_t k = who[n - begin];
        const brink_particle *q = &particle[k];
        load(&qx, &qv, q);
        const lanes v = pv - qv;
        const lanes r =
            __builtin_convertvector((way_round)(px - qx), lanes) * unit +
            (way - qv * (offset - q->since));
        b->who[n] = k;
        b->step[n] = with[q->species].distance[0];
        for (int a = 0; a < 3; a++) {
            b->r[a][n] = r[a];
            b->v[a][n] = v[a];
        }
    }
    b->count = end;
}

// With images the particles can drift past half the box from where they were.
static void wrap(const search *s, brink_batch *b)
{
    const brink_system *system = &s->run->system;
    for (int a = 0; a < system->dimensions; a++)
        if (s->run->cells.images[a] > 1)
            for (int n = 0; n < b->count; n++)
                b->r[a][n] -=
                    system->length[a] * rint(b->r[a][n] / system->length[a]);
}

// A captured pair can meet the step around it and the step inside [S16 alg. 3].
static void add_steps_inside(search *s, const brink_link *link)
{
    brink_batch *b = &s->outward;
    for (int n = 0; n < b->count; n++) {
        const brink_potential *p =
            brink_system_potential(&s->run->system, s->i, b->who[n]);
        const int level = link[n].level;
        const double r[3] = {b->r[0][n], b->r[1][n], b->r[2][n]};
        const double v[3] = {b->v[0][n], b->v[1][n], b->v[2][n]};
        b->step[n] = p->distance[level - 1];
        if (level < p->count &&
            brink_batch_add(&s->inward, b->who[n], r, v, p->distance[level]))
            look_inward(s);
    }
}

static void add_partners(search *s)
{
    const brink_link *link = brink_states_links(&s->run->states, s->i);
    uint32_t left = brink_states_partners(&s->run->states, s->i),
             who[BRINK_BATCH];
    while (left > 0) {
        const uint32_t count = left < BRINK_BATCH ? left : BRINK_BATCH;
        for (uint32_t n = 0; n < count; n++)
            who[n] = link[n].partner;
        add_nearest(s, &s->outward, who, (int)count);
        wrap(s, &s->outward);
        add_steps_inside(s, link);
        look_outward(s);
        link += count;
        left -= count;
    }
}

// An uncaptured pair can meet the outermost step, in any image.
static void add_images(search *s, const uint32_t *who, int count)
{
    const brink_run *run = s->run;
    brink_batch near;
    near.count = 0;
    add_nearest(s, &near, who, count);
    wrap(s, &near);
    for (int n = 0; n < count; n++)
        for (int m = 0; m < run->images; m++) {
            const double *shift = run->image[m];
            const double v[3] = {near.v[0][n], near.v[1][n], near.v[2][n]};
            const double image[3] = {near.r[0][n] + shift[0],
                                     near.r[1][n] + shift[1],
                                     near.r[2][n] + shift[2]};
            if (brink_batch_add(&s->inward, who[n], image, v, near.step[n]))
                look_inward(s);
        }
}

static void mark_partners(brink_run *run, uint32_t i, uint8_t mark)
{
    const brink_link *link = brink_states_links(&run->states, i);
    for (uint32_t n = 0; n < brink_states_partners(&run->states, i); n++)
        run->is_partner[link[n].partner] = mark;
}

// Leaves of `who` those who are not i's partners.
static int keep_strangers(brink_run *run, uint32_t i, uint32_t *who, int count)
{
    int kept = 0;
    mark_partners(run, i, 1);
    for (int n = 0; n < count; n++) {
        who[kept] = who[n];
        kept += !run->is_partner[who[n]];
    }
    mark_partners(run, i, 0);
    return kept;
}

// Leaves of `who` those who are not i, and has their data fetched.
static int keep_others(const brink_run *run, uint32_t i, uint32_t *who, int count)
{
    int kept = 0;
    for (int n = 0; n < count; n++) {
        const uint32_t k = who[n];
        BRINK_PREFETCH(&run->system.particle[k]);
        who[kept] = k;
        kept += k != i;
    }
    return kept;
}

// Adds those of `who` who are not i's partners.
static void add_strangers(search *s, uint32_t *who, int count)
{
    brink_run *run = s->run;
    if (brink_states_partners(&run->states, s->i) > 0)
        count = keep_strangers(run, s->i, who, count);
    if (s->inward.count + count > BRINK_BATCH)
        look_inward(s);
    if (run->images == 1)
        add_nearest(s, &s->inward, who, count);
    else
        add_images(s, who, count);
}

static void add_from_cells(search *s, const uint32_t *cells, int count)
{
    uint32_t who[BRINK_HANDFUL];
    brink_tour tour = brink_tour_of(cells, count);
    for (int n; (n = brink_tour_next(&s->run->cells, &tour, who)) > 0;)
        add_strangers(s, who, keep_others(s->run, s->i, who, n));
}

static void add_neighbours(search *s)
{
    const brink_neighbours *all = &s->run->neighbours;
    const uint32_t *next = brink_neighbours_of(all, s->i);
    const uint32_t *const end = next + brink_neighbours_count(all, s->i);
    while (next < end) {
        uint32_t who[BRINK_HANDFUL];
        int n = 0;
        while (n < BRINK_HANDFUL && next < end) {
            BRINK_PREFETCH(&s->run->system.particle[*next]);
            who[n++] = *next++;
        }
        add_strangers(s, who, n);
    }
}

// What there is to beat: the end of the time for which it is known who is near,
// and which way it ends.
static void begin(search *s, brink_run *run, uint32_t i, double offset,
                  double until, uint32_t way)
{
    const brink_instant new_year = {run->system.epoch, 0.0};
    s->run = run;
    s->i = i;
    s->offset = offset;
    s->inward.count = s->outward.count = 0;
    s->soonest = until;
    s->best = (brink_entry){
        .when = brink_instant_after(run->system.year, new_year, until),
        .i = i,
        .j = way,
        .kind = BRINK_ENTRY_CELL,
    };
    add_partners(s);
}

static void search_cells(search *s, brink_run *run, uint32_t i, double offset)
{
    brink_stay stay;
    brink_cells_stay(&run->cells, &run->system, i, offset, &stay);
    begin(s, run, i, offset, stay.until, brink_crossing_number(stay.crossing));
    add_from_cells(s, stay.near, stay.cells);
}

static void search_neighbours(search *s, brink_run *run, uint32_t i,
                              double offset)
{
    begin(s, run, i, offset,
          brink_neighbours_until(&run->neighbours, &run->system, i, offset), 0);
    add_neighbours(s);
}

void brink_predict(brink_run *run, uint32_t i, double offset)
{
    search s;
    if (run->neighbours.radius > 0)
        search_neighbours(&s, run, i, offset);
    else
        search_cells(&s, run, i, offset);
    look_inward(&s);
    brink_calendar_set(&run->calendar, i, &s.best);
}
