// SPDX-License-Identifier: MIT
#include "conventional.h"
#include <brink/event_time.h>
#include <brink/impulse.h>
#include <brink/overlap.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

// The search for a particle's next pair event: the earliest so far.
typedef struct search {
    const brink_run *house;
    const brink_rule *rule;
    uint32_t i;
    brink_entry best;
    int seen; // the level it was predicted for
} search;

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static double mass(const brink_system *s, uint32_t i)
{
    return s->species[s->particle[i].species].mass;
}

static void offer(search *s, uint32_t k, double dt, enum brink_direction way,
                  int seen)
{
    const brink_system *system = &s->house->system;
    const brink_entry found = {
        .when = brink_instant_after(system->year, s->house->now, dt),
        .i = s->i < k ? s->i : k,
        .j = s->i < k ? k : s->i,
        .generation = system->particle[k].generation,
        .kind = way == BRINK_INWARD ? BRINK_ENTRY_INWARD : BRINK_ENTRY_OUTWARD,
        .at_once = dt == 0,
    };
    if (brink_entry_compare(&found, &s->best) < 0) {
        s->best = found;
        s->seen = seen;
    }
}

// dt moved clear of the step: later if the pair will cross it, earlier if not. At
// the step the square of r.v is b^2 - a c.
static double nudged(const search *s, uint32_t k, const double r[3],
                     const double v[3], double dt, double distance, double rise)
{
    const double m1 = mass(&s->house->system, s->i),
                 m2 = mass(&s->house->system, k);
    const double a = dot(v, v), b = dot(r, v), ss = distance * distance;
    const double radial = (b * b - a * (dot(r, r) - ss)) / ss;
    const int crosses = m1 * m2 / (m1 + m2) * radial / 2 > rise;
    const double nudge = s->rule->time_nudge * distance / sqrt(a);
    return fmax(0, crosses ? dt + nudge : dt - nudge);
}

// One step that the pair can meet from the level it is seen at.
static void offer_step(search *s, uint32_t k, const double r[3],
                       const double v[3], int level, enum brink_direction way)
{
    const brink_potential *p = brink_system_potential(&s->house->system, s->i, k);
    const double distance = p->distance[way == BRINK_INWARD ? level : level - 1];
    const double dt = way == BRINK_INWARD
                          ? brink_intersection_time(r, v, distance)
                          : s->rule->disjoint_time(r, v, distance);
    if (!(dt < (double)INFINITY))
        return;
    const double rise = brink_step_rise(p, level, way);
    offer(s, k, nudged(s, k, r, v, dt, distance, rise), way, level);
}

static void predict_stranger(search *s, uint32_t k, const double r[3],
                             const double v[3])
{
    for (int m = 0; m < s->house->images; m++) {
        const double *shift = s->house->image[m];
        const double image[3] = {r[0] + shift[0], r[1] + shift[1],
                                 r[2] + shift[2]};
        offer_step(s, k, image, v, 0, BRINK_INWARD);
    }
}

static void predict_captured(search *s, uint32_t k, const double r[3],
                             const double v[3], int level)
{
    if (level < brink_system_potential(&s->house->system, s->i, k)->count)
        offer_step(s, k, r, v, level, BRINK_INWARD);
    offer_step(s, k, r, v, level, BRINK_OUTWARD);
}

static void predict_in(search *s, const uint32_t *cells, int count)
{
    const brink_run *house = s->house;
    const brink_system *system = &house->system;
    uint32_t who[BRINK_HANDFUL];
    brink_tour tour = brink_tour_of(cells, count);
    for (int n; (n = brink_tour_next(&house->cells, &tour, who)) > 0;)
        for (int m = 0; m < n; m++) {
            const uint32_t k = who[m];
            if (k == s->i)
                continue;
            double r[3], v[3];
            brink_separation_now(house, s->i, k, r);
            for (int a = 0; a < 3; a++)
                v[a] = system->particle[s->i].v[a] - system->particle[k].v[a];
            const int level = s->rule->level(house, s->i, k, r);
            if (level == 0)
                predict_stranger(s, k, r, v);
            else
                predict_captured(s, k, r, v, level);
        }
}

static void keep(brink_conventional *c, const search *s)
{
    c->seen[s->i] = s->seen;
    brink_calendar_set(&c->house.calendar, s->i, &s->best);
}

// Both slots of particle i, as the run has them in one.
static void predict(brink_conventional *c, uint32_t i)
{
    brink_run *house = &c->house;
    const brink_system *system = &house->system;
    const double offset = house->now.offset;
    const brink_instant new_year = {system->epoch, 0.0};
    search s = {house, c->rule, i, {.when = BRINK_NEVER}, 0};
    brink_stay stay;
    brink_cells_stay(&house->cells, system, i, offset, &stay);
    const brink_entry crossing = {
        .when = brink_instant_after(system->year, new_year, stay.until),
        .i = i,
        .j = brink_crossing_number(stay.crossing),
        .kind = BRINK_ENTRY_CELL};
    brink_calendar_set(&house->calendar, system->count + i, &crossing);
    predict_in(&s, stay.near, stay.cells);
    keep(c, &s);
}

static void cross_wall(brink_conventional *c, const brink_entry *entry)
{
    const uint32_t i = entry->i;
    brink_system_advance(&c->house.system, i, entry->when.offset);
    brink_cells_cross(&c->house.cells, i, brink_crossing_of(entry->j));
    c->house.tally.cell++;
    predict(c, i);
}

// The impulse of the method's choice; returns what it takes to have happened. Its
// direction is the pair's own, as in the textbook's formulas.
static enum brink_event_kind strike(brink_run *house, const brink_meeting *m,
                                    int inside)
{
    brink_system *s = &house->system;
    double *vi = s->particle[m->i].v, *vj = s->particle[m->j].v, virial;
    const double mi = mass(s, m->i), mj = mass(s, m->j);
    const double rise =
        inside ? brink_step_rise(m->potential, m->step + 1, BRINK_OUTWARD)
               : brink_step_rise(m->potential, m->step, BRINK_INWARD);
    if (isinf(rise)) {
        virial = brink_core_impulse_balanced(m->r, mi, mj, vi, vj, &house->owed);
        brink_sum_add(&house->tally.virial, virial);
        return BRINK_CORE;
    }
    const int parting = brink_ball_overlap_rate_sign(m->r, m->v) > 0;
    const int crossed = brink_step_impulse_balanced(
        m->r, mi, mj, rise, parting ? BRINK_OUTWARD : BRINK_INWARD, vi, vj,
        &virial, &house->owed);
    brink_sum_add(&house->tally.virial, virial);
    return !crossed ? BRINK_BOUNCE : inside ? BRINK_RELEASE : BRINK_CAPTURE;
}

// Moves both particles along their separation, to the side of the step where the
// pair is to be; a hard core has only one side.
static void displace(brink_system *s, const brink_meeting *m, double part,
                     int inside)
{
    for (int a = 0; a < s->dimensions; a++) {
        const uint64_t by = brink_system_fraction(s, a, part * m->r[a]);
        s->particle[m->i].x[a] += inside ? -by : by;
        s->particle[m->j].x[a] += inside ? by : -by;
    }
}

static void count_event(brink_conventional *c, const brink_entry *entry,
                        enum brink_event_kind kind, const brink_meeting *m,
                        int before, int after)
{
    brink_run *house = &c->house;
    brink_tally *t = &house->tally;
    uint64_t *kinds[] = {[BRINK_CORE] = &t->core,
                         [BRINK_CAPTURE] = &t->capture,
                         [BRINK_RELEASE] = &t->release,
                         [BRINK_BOUNCE] = &t->bounce};
    const int again = brink_tally_events(t) > 0 && m->i == house->last.i &&
                      m->j == house->last.j &&
                      brink_instant_compare(entry->when, house->last.when) == 0;
    c->still = again ? c->still + 1 : 0;
    ++*kinds[kind];
    t->repeated += (uint64_t)again;
    t->clamped += entry->at_once;
    house->last = (brink_happening){.kind = kind,
                                    .i = m->i,
                                    .j = m->j,
                                    .level_before = before,
                                    .level_after = after,
                                    .distance = m->potential->distance[m->step],
                                    .when = entry->when};
}

static enum brink_run_status meet(brink_conventional *c, const brink_entry *entry,
                                  int seen)
{
    brink_run *house = &c->house;
    brink_system *s = &house->system;
    const uint32_t i = entry->i, j = entry->j;
    const int outward = entry->kind == BRINK_ENTRY_OUTWARD;
    brink_meeting m = {.i = i,
                       .j = j,
                       .potential = brink_system_potential(s, i, j),
                       .step = outward ? seen - 1 : seen,
                       .seen_inside = outward};
    brink_system_advance(s, i, entry->when.offset);
    brink_system_advance(s, j, entry->when.offset);
    brink_separation_now(house, i, j, m.r);
    for (int a = 0; a < 3; a++)
        m.v[a] = s->particle[i].v[a] - s->particle[j].v[a];

    const int core = isinf(m.potential->energy[m.step]);
    const int inside = !core && c->rule->is_inside(house, &m);
    const enum brink_event_kind kind = strike(house, &m, inside);
    const int crossed = kind == BRINK_CAPTURE || kind == BRINK_RELEASE;
    const int ends_inside = inside != crossed;
    if (!core)
        displace(s, &m, c->rule->place_nudge, ends_inside);
    s->particle[i].generation++;
    s->particle[j].generation++;
    count_event(c, entry, kind, &m, m.step + inside, m.step + ends_inside);
    if (brink_states_set(&house->states, s, i, j, m.step + ends_inside))
        return BRINK_RUN_NO_MEMORY;
    predict(c, i);
    predict(c, j);
    return c->still > BRINK_STANDSTILL ? BRINK_RUN_STUCK : BRINK_RUN_REACHED;
}

static enum brink_run_status execute(brink_conventional *c, uint32_t slot)
{
    brink_run *house = &c->house;
    const brink_entry entry = house->calendar.entry[slot];
    if (entry.when.epoch > house->system.epoch)
        brink_system_turn(&house->system, entry.when.epoch);
    house->now = entry.when;
    if (entry.kind == BRINK_ENTRY_CELL) {
        cross_wall(c, &entry);
        return BRINK_RUN_REACHED;
    }
    const uint32_t partner = slot == entry.i ? entry.j : entry.i;
    if (house->system.particle[partner].generation == entry.generation)
        return meet(c, &entry, c->seen[slot]);
    house->tally.stale++;
    predict(c, slot);
    return BRINK_RUN_REACHED;
}

enum brink_run_status brink_conventional_advance(brink_conventional *c,
                                                 uint64_t events)
{
    enum brink_run_status status = BRINK_RUN_REACHED;
    while (status == BRINK_RUN_REACHED &&
           brink_tally_events(&c->house.tally) < events) {
        const uint32_t slot = brink_calendar_next(&c->house.calendar);
        status = slot == c->house.calendar.slots ? BRINK_RUN_AT_REST
                                                 : execute(c, slot);
    }
    return status;
}

int brink_conventional_assemble(brink_conventional *c, brink_run *run,
                                const brink_rule *rule)
{
    const uint32_t count = run->system.count;
    *c = (brink_conventional){.house = *run, .rule = rule};
    memset(run, 0, sizeof *run);
    c->seen = calloc(count, sizeof *c->seen);
    // Two slots a particle, unlike a run's: its first meeting and its crossing.
    brink_calendar *calendar = &c->house.calendar;
    brink_calendar_destroy(calendar);
    if (c->seen == NULL ||
        brink_calendar_create(calendar, 2 * count, c->house.system.year,
                              2 * count)) {
        brink_conventional_destroy(c);
        return -1;
    }
    calendar->epoch = c->house.system.epoch;
    return 0;
}

int brink_conventional_create(brink_conventional *c, brink_system *system,
                              const brink_rule *rule)
{
    const uint32_t count = system->count;
    brink_run run;
    memset(c, 0, sizeof *c);
    if (brink_run_create(&run, system, BRINK_TIER_PLAIN) ||
        brink_conventional_assemble(c, &run, rule))
        return -1;
    for (uint32_t i = 0; i < count; i++)
        predict(c, i);
    return 0;
}

void brink_conventional_destroy(brink_conventional *c)
{
    brink_run_destroy(&c->house);
    free(c->seen);
    memset(c, 0, sizeof *c);
}

double brink_energy_by_position(const brink_run *run)
{
    const brink_system *s = &run->system;
    const brink_happening *last = &run->last;
    brink_sum sum = {0};
    brink_sum_add(&sum, brink_system_kinetic_energy(s));
    for (uint32_t i = 0; i < s->count; i++) {
        uint32_t around[27], who[BRINK_HANDFUL];
        brink_tour tour = brink_tour_around(&run->cells, i, around);
        for (int n; (n = brink_tour_next(&run->cells, &tour, who)) > 0;)
            for (int m = 0; m < n; m++) {
                const uint32_t k = who[m];
                if (k <= i)
                    continue;
                const brink_potential *p = brink_system_potential(s, i, k);
                double r[3];
                brink_separation_now(run, i, k, r);
                const int was_last = i == last->i && k == last->j;
                const int level =
                    was_last ? last->level_after : brink_level_by_position(p, r);
                brink_sum_add(&sum, brink_potential_energy(p, level));
            }
    }
    return brink_sum_value(&sum);
}
