// SPDX-License-Identifier: MIT
#include "run.h"
#include "array.h"
#include "run_ahead.h"
#include "run_meeting.h"
#include "run_predict.h"
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static enum brink_run_status cross_wall(brink_run *run, const brink_entry *entry)
{
    const brink_crossing crossing = brink_crossing_of(entry->j);
    return brink_cells_cross(&run->cells, entry->i, crossing) ? BRINK_RUN_REACHED
                                                              : BRINK_RUN_REFUSED;
}

static enum brink_run_status leave_home(brink_run *run, uint32_t i)
{
    return brink_neighbours_depart(&run->neighbours, &run->cells, &run->system, i)
               ? BRINK_RUN_NO_MEMORY
               : BRINK_RUN_REACHED;
}

// A particle comes among others, by a virtual state of the one sort or the other.
static enum brink_run_status move_on(brink_run *run, const brink_entry *entry)
{
    const uint32_t i = entry->i;
    const double offset = entry->when.offset;
    brink_system_advance(&run->system, i, offset);
    const enum brink_run_status status =
        run->neighbours.radius > 0 ? leave_home(run, i) : cross_wall(run, entry);
    if (status == BRINK_RUN_REACHED) {
        run->tally.cell++;
        brink_predict(run, i, offset);
    }
    return status;
}

// Velocities after the meeting; what happened.
static enum brink_event_kind resolve(brink_run *run, const double r[3],
                                     double rise, enum brink_direction way,
                                     uint32_t i, uint32_t j)
{
    const brink_system *s = &run->system;
    brink_particle *a = &s->particle[i], *b = &s->particle[j];
    const double ma = s->species[a->species].mass,
                 mb = s->species[b->species].mass;
    const brink_meeting met =
        brink_meeting_at(r, ma, mb, rise, way, a->v, b->v, &run->owed);
    run->tally.rim += (uint64_t)met.rim;
    brink_sum_add(&run->tally.virial, met.virial);
    a->generation++;
    b->generation++;
    return met.kind;
}

static void count_event(brink_run *run, const brink_entry *entry,
                        const brink_happening *event, const double r[3])
{
    brink_tally *t = &run->tally;
    uint64_t *kinds[] = {[BRINK_CORE] = &t->core,
                         [BRINK_CAPTURE] = &t->capture,
                         [BRINK_RELEASE] = &t->release,
                         [BRINK_BOUNCE] = &t->bounce};
    ++*kinds[event->kind];
    const double distance = sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]);
    const double error = fabs(distance - event->distance) / event->distance;
    t->contact_error_max = fmax(t->contact_error_max, error);
    t->clamped += entry->at_once;
    const int again = brink_tally_events(t) > 1 &&
                      brink_instant_compare(entry->when, run->last.when) == 0;
    run->idle = again ? run->idle + 1 : 0;
    t->zero_time += (uint64_t)again;
    t->repeated += again && event->i == run->last.i && event->j == run->last.j;
}

static enum brink_run_status meet(brink_run *run, const brink_entry *entry)
{
    brink_system *s = &run->system;
    const uint32_t i = entry->i, j = entry->j;
    const double offset = entry->when.offset;
    const brink_potential *p = brink_system_potential(s, i, j);
    const int level = brink_states_level(&run->states, i, j);
    const enum brink_direction way =
        entry->kind == BRINK_ENTRY_INWARD ? BRINK_INWARD : BRINK_OUTWARD;
    const double rise = brink_step_rise(p, level, way);
    double r[3];
    brink_system_advance(s, i, offset);
    brink_system_advance(s, j, offset);
    brink_system_separation(s, i, j, offset, r);
    if (isnan(rise)) { // there is no such step to meet from this level
        run->tally.refused++;
        return BRINK_RUN_REFUSED;
    }
    brink_happening event = {
        .i = i,
        .j = j,
        .level_before = level,
        .distance = p->distance[way == BRINK_INWARD ? level : level - 1],
        .when = entry->when,
    };
    event.kind = resolve(run, r, rise, way, i, j);
    const int applied = brink_states_apply(&run->states, s, i, j, event.kind);
    event.level_after = brink_states_level(&run->states, i, j);
    count_event(run, entry, &event, r);
    run->last = event;
    if (applied != 0) {
        run->tally.refused += applied > 0;
        return applied > 0 ? BRINK_RUN_REFUSED : BRINK_RUN_NO_MEMORY;
    }
    brink_predict(run, i, offset);
    brink_predict(run, j, offset);
    // A scene may have as many simultaneous events as it has pairs in contact,
    // some a few times over; one that has this many more has stopped.
    return run->idle > 1000 + 16 * (uint64_t)s->count ? BRINK_RUN_STUCK
                                                      : BRINK_RUN_REACHED;
}

// Of a pair's entry: the partner of who keeps it has changed since.
static int is_stale(const brink_run *run, uint32_t slot, const brink_entry *entry)
{
    const uint32_t partner = slot == entry->i ? entry->j : entry->i;
    return run->system.particle[partner].generation != entry->generation;
}

static enum brink_run_status execute(brink_run *run, uint32_t slot)
{
    const brink_entry entry = run->calendar.entry[slot];
    brink_system *s = &run->system;
    if (entry.when.epoch > s->epoch)
        brink_system_turn(s, entry.when.epoch);
    run->now = entry.when;
    if (entry.kind == BRINK_ENTRY_CELL)
        return move_on(run, &entry);
    if (is_stale(run, slot, &entry)) {
        run->tally.stale++;
        brink_predict(run, slot, entry.when.offset);
        return BRINK_RUN_REACHED;
    }
    return meet(run, &entry);
}

enum brink_run_status brink_run_advance(brink_run *run, uint64_t events,
                                        brink_instant until)
{
    uint64_t crossed = run->tally.cell; // by the time of the last event
    uint64_t done = brink_tally_events(&run->tally);
    while (done < events) {
        if (run->tally.cell > crossed + BRINK_PATIENCE)
            return BRINK_RUN_QUIET;
        const uint32_t slot = brink_calendar_next(&run->calendar);
        const int at_rest = slot == run->calendar.slots;
        if (at_rest ||
            brink_instant_compare(run->calendar.entry[slot].when, until) > 0) {
            if (until.epoch != INT64_MAX &&
                brink_instant_compare(until, run->now) > 0)
                run->now = until;
            return at_rest ? BRINK_RUN_AT_REST : BRINK_RUN_REACHED;
        }
        brink_look_ahead(run);
        const enum brink_run_status status = execute(run, slot);
        if (status != BRINK_RUN_REACHED)
            return status;
        const uint64_t now = brink_tally_events(&run->tally);
        crossed = now > done ? run->tally.cell : crossed;
        done = now;
    }
    return BRINK_RUN_REACHED;
}

int brink_run_is_event(const brink_run *run, uint32_t slot)
{
    const brink_entry *entry = &run->calendar.entry[slot];
    return entry->kind != BRINK_ENTRY_CELL && !is_stale(run, slot, entry);
}

enum brink_run_status brink_run_step(brink_run *run)
{
    const uint32_t slot = brink_calendar_next(&run->calendar);
    return slot == run->calendar.slots ? BRINK_RUN_AT_REST : execute(run, slot);
}

// The images: every combination of -L, 0, L on the axes that have three.
static void list_images(brink_run *run)
{
    const int *images = run->cells.images;
    for (int z = 0; z < images[2]; z++)
        for (int y = 0; y < images[1]; y++)
            for (int x = 0; x < images[0]; x++) {
                const int shift[3] = {x - images[0] / 2, y - images[1] / 2,
                                      z - images[2] / 2};
                double *image = run->image[run->images++];
                for (int a = 0; a < 3; a++)
                    image[a] = run->system.length[a] * shift[a];
            }
}

// Levels by position, of i and those in adjacent cells.
static int find_levels_of(brink_run *run, uint32_t i)
{
    const brink_system *s = &run->system;
    uint32_t around[27], who[BRINK_HANDFUL];
    brink_tour tour = brink_tour_around(&run->cells, i, around);
    for (int n; (n = brink_tour_next(&run->cells, &tour, who)) > 0;)
        for (int m = 0; m < n; m++) {
            const uint32_t k = who[m];
            if (k <= i)
                continue;
            const brink_potential *p = brink_system_potential(s, i, k);
            double r[3];
            brink_system_separation(s, i, k, 0.0, r);
            const int seen = brink_step_level_at(p, r);
            const int most = brink_potential_levels(p) - 1;
            if (brink_states_set(&run->states, s, i, k,
                                 seen < most ? seen : most))
                return -1;
        }
    return 0;
}

static int find_levels(brink_run *run)
{
    for (uint32_t i = 0; i < run->system.count; i++)
        if (find_levels_of(run, i))
            return -1;
    return 0;
}

int brink_run_assemble(brink_run *run, brink_system *system, enum brink_tier tier)
{
    memset(run, 0, sizeof *run);
    run->system = *system;
    memset(system, 0, sizeof *system);
    run->tier = tier;
    const uint32_t n = run->system.count;
    run->is_partner = brink_array_create(n, 1);
    // A year is as long as a particle takes to cross a cell or two (see
    // brink_kinetic_year), so that a day has an event or a few.
    const double radius = brink_neighbours_radius(&run->system);
    const double reach = run->system.range + 2 * radius;
    if (!run->is_partner ||
        brink_cells_create(&run->cells, &run->system, reach) ||
        brink_neighbours_create(&run->neighbours, &run->cells, &run->system,
                                radius) ||
        brink_states_create(&run->states, &run->system) ||
        brink_calendar_create(&run->calendar, n, run->system.year, 2 * n)) {
        brink_run_destroy(run);
        return -1;
    }
    list_images(run);
    return 0;
}

int brink_run_create(brink_run *run, brink_system *system, enum brink_tier tier)
{
    if (brink_run_assemble(run, system, tier))
        return -1;
    if (find_levels(run) ||
        brink_neighbours_fill(&run->neighbours, &run->cells, &run->system)) {
        brink_run_destroy(run);
        return -1;
    }
    for (uint32_t i = 0; i < run->system.count; i++)
        brink_predict(run, i, 0.0);
    run->energy_begin = brink_run_energy(run);
    run->kinetic_begin = brink_system_kinetic_energy(&run->system);
    brink_system_momentum(&run->system, run->momentum_begin);
    return 0;
}

void brink_run_destroy(brink_run *run)
{
    brink_system_destroy(&run->system);
    brink_states_destroy(&run->states);
    brink_cells_destroy(&run->cells);
    brink_neighbours_destroy(&run->neighbours);
    brink_calendar_destroy(&run->calendar);
    free(run->is_partner);
    memset(run, 0, sizeof *run);
}

const char *brink_run_is_valid(const brink_run *run)
{
    const char *fault = brink_system_is_valid(&run->system);
    if (!fault)
        fault = brink_cells_is_valid(&run->cells);
    if (!fault)
        fault = brink_neighbours_is_valid(&run->neighbours, &run->cells,
                                          &run->system);
    if (!fault)
        fault = brink_states_is_valid(&run->states, &run->system);
    if (!fault)
        fault = brink_calendar_is_valid(&run->calendar);
    return fault;
}

void brink_run_diagnosis(const brink_run *run, enum brink_run_status status,
                         char *text, size_t size)
{
    static const char *const why[] = {
        [BRINK_RUN_REACHED] = "the run reached its target",
        [BRINK_RUN_AT_REST] = "nothing moves: there is no further event",
        [BRINK_RUN_STUCK] = "events go on but the clock does not",
        [BRINK_RUN_QUIET] = "nobody has met anybody for long",
        [BRINK_RUN_REFUSED] = "the state machine refused an event",
        [BRINK_RUN_NO_MEMORY] = "memory is out",
    };
    static const char *const kinds[] = {"core", "capture", "release", "bounce"};
    const brink_happening *e = &run->last;
    const brink_particle *a = &run->system.particle[e->i];
    const brink_particle *b = &run->system.particle[e->j];
    double r[3];
    brink_system_separation(&run->system, e->i, e->j, a->since, r);
    snprintf(text, size,
             "%s; after %" PRIu64 " events, at time %.17g\n"
             "last event: %s of particles %" PRIu32 " and %" PRIu32
             ", level %d -> %d, step at %a\n"
             "r = {%a, %a, %a}\nv = {%a, %a, %a}\n",
             why[status], brink_tally_events(&run->tally), brink_run_time(run),
             kinds[e->kind], e->i, e->j, e->level_before, e->level_after,
             e->distance, r[0], r[1], r[2], a->v[0] - b->v[0], a->v[1] - b->v[1],
             a->v[2] - b->v[2]);
}

double brink_run_time(const brink_run *run)
{
    return brink_instant_time(run->system.year, run->now);
}

double brink_run_energy(const brink_run *run)
{
    return brink_system_kinetic_energy(&run->system) +
           brink_states_energy(&run->states, &run->system);
}

double brink_run_compressibility(const brink_run *run)
{
    const brink_system *s = &run->system;
    const double kt = brink_system_temperature(s);
    return 1.0 +
           brink_sum_value(&run->tally.virial) /
               (s->dimensions * (double)s->count * kt * brink_run_time(run));
}

double brink_run_pressure(const brink_run *run)
{
    const brink_system *s = &run->system;
    return brink_run_compressibility(run) * (double)s->count *
           brink_system_temperature(s) / brink_system_volume(s);
}

double brink_run_mean_free_time(const brink_run *run)
{
    return (double)run->system.count * brink_run_time(run) /
           (2.0 * (double)brink_tally_events(&run->tally));
}

void brink_run_position(const brink_run *run, uint32_t i, double x[3])
{
    const brink_instant new_year = {run->system.epoch, 0.0};
    brink_system_position(
        &run->system, i,
        brink_instant_since(run->system.year, run->now, new_year), x);
}
