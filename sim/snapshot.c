// SPDX-License-Identifier: MIT
#include "snapshot.h"
#include "snapshot_rooms.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char magic[] = "brink checkpoint";

// The layout, once for both directions: a codec writes what it is shown, or reads
// into it.  Whatever is read is checked before it is used.

static void code_head(brink_codec *c)
{
    char name[sizeof magic - 1];
    memcpy(name, magic, sizeof name);
    brink_code_bytes(c, name, sizeof name);
    uint32_t version = BRINK_SNAPSHOT_VERSION;
    brink_code_u32(c, &version);
    if (c->fault)
        return;
    if (memcmp(name, magic, sizeof name) != 0)
        c->fault = "it is not a checkpoint of brink";
    else if (version != BRINK_SNAPSHOT_VERSION)
        c->fault = "it is of another version of brink";
}

static void code_plan(brink_codec *c, brink_plan *plan)
{
    brink_code_u64(c, &plan->events);
    brink_code_double(c, &plan->until);
    brink_code_u64(c, &plan->seed);
    brink_code_u64(c, &plan->frames);
    brink_code_u64(c, &plan->frame_end);
    brink_code_double(c, &plan->wall_seconds);
    brink_code_u64(c, &plan->scene_size);
    plan->scene = brink_code_room(c, plan->scene, plan->scene_size, 1, 1);
    brink_code_bytes(c, plan->scene, plan->scene_size);
    brink_code_u64(c, &plan->record_size);
    plan->record = brink_code_room(c, plan->record, plan->record_size, 1, 1);
    brink_code_bytes(c, plan->record, plan->record_size);
}

static void code_tally(brink_codec *c, brink_tally *t)
{
    uint64_t *const counts[] = {&t->core,     &t->capture, &t->release,
                                &t->bounce,   &t->wall,    &t->cell,
                                &t->stale,    &t->clamped, &t->zero_time,
                                &t->repeated, &t->rim,     &t->refused};
    for (size_t k = 0; k < sizeof counts / sizeof *counts; k++)
        brink_code_u64(c, counts[k]);
    brink_code_double(c, &t->virial.sum);
    brink_code_double(c, &t->virial.carry);
    brink_code_double(c, &t->contact_error_max);
}

static void code_happening(brink_codec *c, brink_happening *h)
{
    uint32_t kind = (uint32_t)h->kind;
    brink_code_u32(c, &kind);
    h->kind = (enum brink_event_kind)kind;
    brink_code_u32(c, &h->i);
    brink_code_u32(c, &h->j);
    brink_code_int(c, &h->level_before);
    brink_code_int(c, &h->level_after);
    brink_code_double(c, &h->distance);
    brink_code_instant(c, &h->when);
}

static void code_species(brink_codec *c, brink_species *s)
{
    brink_code_bytes(c, s->name, sizeof s->name);
    s->name[sizeof s->name - 1] = '\0';
    brink_code_double(c, &s->mass);
    brink_code_double(c, &s->diameter);
    brink_code_u32(c, &s->count);
}

// The tables of a potential are const to everybody else; here they are made.
static void code_potential(brink_codec *c, brink_potential *p)
{
    brink_code_int(c, &p->count);
    const size_t count = p->count > 0 ? (size_t)p->count : 0;
    double *distance =
        brink_code_room(c, (void *)p->distance, count, sizeof(double), 16);
    double *energy =
        brink_code_room(c, (void *)p->energy, count, sizeof(double), 16);
    for (size_t k = 0; k < count && !c->fault; k++) {
        brink_code_double(c, &distance[k]);
        brink_code_double(c, &energy[k]);
    }
    p->distance = distance;
    p->energy = energy;
    if (!c->fault && !brink_potential_is_valid(p))
        c->fault = "a potential is not one";
}

static void code_particle(brink_codec *c, brink_particle *p)
{
    for (int a = 0; a < 3; a++) {
        brink_code_u64(c, &p->x[a]);
        brink_code_double(c, &p->v[a]);
    }
    brink_code_double(c, &p->since);
    brink_code_u32(c, &p->generation);
    brink_code_u32(c, &p->species);
}

// Everything a system is made from, then its particles.
static void code_system(brink_codec *c, brink_system *s)
{
    brink_code_int(c, &s->dimensions);
    for (int a = 0; a < 3; a++)
        brink_code_double(c, &s->length[a]);
    brink_code_double(c, &s->year);
    brink_code_i64(c, &s->epoch);
    brink_code_u32(c, &s->count);
    brink_code_int(c, &s->species_count);
    const size_t kinds = s->species_count > 0 ? (size_t)s->species_count : 0;
    s->species = brink_code_room(c, s->species, kinds, sizeof *s->species, 36);
    for (size_t k = 0; k < kinds && !c->fault; k++)
        code_species(c, &s->species[k]);
    s->potential =
        brink_code_room(c, s->potential, kinds * kinds, sizeof *s->potential, 20);
    for (size_t k = 0; k < kinds * kinds && !c->fault; k++)
        code_potential(c, &s->potential[k]);
    s->particle =
        brink_code_room(c, s->particle, s->count, sizeof *s->particle, 64);
    for (uint32_t i = 0; i < s->count && !c->fault; i++)
        code_particle(c, &s->particle[i]);
}

// What the run keeps besides its rooms.
static void code_run(brink_codec *c, brink_run *run)
{
    uint32_t tier = (uint32_t)run->tier;
    brink_code_u32(c, &tier);
    if (tier > BRINK_TIER_CR)
        c->fault = "there is no such tier";
    run->tier = (enum brink_tier)tier;
    brink_code_instant(c, &run->now);
    code_tally(c, &run->tally);
    code_happening(c, &run->last);
    brink_code_u32(c, &run->idle);
    brink_code_double(c, &run->owed);
    brink_code_double(c, &run->energy_begin);
    brink_code_double(c, &run->kinetic_begin);
    for (int a = 0; a < 3; a++)
        brink_code_double(c, &run->momentum_begin[a]);
}

// What a run's rooms take for granted of one that was read.
static const char *run_fault(const brink_run *run)
{
    const brink_system *s = &run->system;
    const brink_happening *last = &run->last;
    if (s->count == 0 || s->count > BRINK_PARTICLES_MOST || s->species_count < 1)
        return "its number of particles or species is not possible";
    if (run->now.epoch < s->epoch || !(run->now.offset >= 0) ||
        !(run->now.offset < s->year))
        return "its clock is not in the current year";
    if (last->i >= s->count || last->j >= s->count || last->kind > BRINK_BOUNCE)
        return "its last event is not possible";
    brink_system checked = *s;
    for (int k = 0; k < s->species_count * s->species_count; k++)
        checked.range = fmax(checked.range, s->potential[k].distance[0]);
    return brink_system_is_valid(&checked);
}

// The codec takes by pointer what it writes, and does not change it.
const char *brink_snapshot_write(FILE *file, const brink_run *run,
                                 const brink_plan *plan)
{
    brink_codec c;
    brink_codec_write_to(&c, file);
    brink_run r = *run;
    brink_plan p = *plan;
    code_head(&c);
    code_plan(&c, &p);
    code_system(&c, &r.system);
    code_run(&c, &r);
    brink_rooms_write(&c, run);
    brink_codec_seal(&c);
    return c.fault;
}

// A run around deep copies of what was read; on a fault there is no run.
static void read_run(brink_codec *c, brink_run *run)
{
    brink_run read = {0};
    code_system(c, &read.system);
    code_run(c, &read);
    if (c->fault || (c->fault = run_fault(&read)))
        return;
    const brink_system *s = &read.system;
    brink_system system;
    if (brink_system_create(&system, s->dimensions, s->length, s->year, s->count,
                            s->species_count, s->species, s->potential)) {
        c->fault = "memory is out";
        return;
    }
    system.epoch = s->epoch;
    memcpy(system.particle, s->particle, s->count * sizeof *s->particle);
    if (brink_run_assemble(run, &system, read.tier)) {
        brink_system_destroy(&system);
        c->fault = "memory is out";
        return;
    }
    run->now = read.now;
    run->tally = read.tally;
    run->last = read.last;
    run->idle = read.idle;
    run->owed = read.owed;
    run->energy_begin = read.energy_begin;
    run->kinetic_begin = read.kinetic_begin;
    memcpy(run->momentum_begin, read.momentum_begin, sizeof run->momentum_begin);
    brink_rooms_read(c, run);
    brink_codec_seal(c);
    if (!c->fault)
        c->fault = brink_run_is_valid(run);
    if (c->fault)
        brink_run_destroy(run);
}

static char *copy(const char *bytes, uint64_t size)
{
    char *kept = calloc(size + 1, 1);
    return kept && size > 0 ? memcpy(kept, bytes, size) : kept;
}

// The plan with texts of its own.  0, -1 no memory.
static int keep_plan(brink_plan *plan, const brink_plan *read)
{
    *plan = *read;
    plan->scene = copy(read->scene, read->scene_size);
    plan->record = copy(read->record, read->record_size);
    if (plan->scene && plan->record)
        return 0;
    brink_plan_destroy(plan);
    return -1;
}

const char *brink_snapshot_read(FILE *file, brink_run *run, brink_plan *plan)
{
    brink_codec c;
    memset(run, 0, sizeof *run);
    memset(plan, 0, sizeof *plan);
    brink_codec_read_from(&c, file);
    brink_plan p = {0};
    code_head(&c);
    code_plan(&c, &p);
    read_run(&c, run);
    if (!c.fault && keep_plan(plan, &p)) {
        c.fault = "memory is out";
        brink_run_destroy(run);
    }
    brink_codec_close(&c);
    return c.fault;
}

void brink_plan_destroy(brink_plan *plan)
{
    free(plan->scene);
    free(plan->record);
    memset(plan, 0, sizeof *plan);
}
