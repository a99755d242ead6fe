// SPDX-License-Identifier: MIT
#include "snapshot_rooms.h"
#include <math.h>

void brink_code_instant(brink_codec *c, brink_instant *t)
{
    brink_code_i64(c, &t->epoch);
    brink_code_double(c, &t->offset);
}

static void write_cells(brink_codec *c, const brink_run *run)
{
    for (uint32_t i = 0; i < run->system.count; i++) {
        uint32_t cell = run->cells.cell[i];
        brink_code_u32(c, &cell);
    }
}

static void read_cells(brink_codec *c, brink_run *run)
{
    for (uint32_t i = 0; i < run->system.count && !c->fault; i++) {
        uint32_t cell = 0;
        brink_code_u32(c, &cell);
        if (cell >= run->cells.total)
            c->fault = "a particle is in a cell that does not exist";
        else
            brink_cells_place(&run->cells, i, cell);
    }
}

// Where there are lists, they follow from the homes, as the cells do.

static void write_homes(brink_codec *c, const brink_run *run)
{
    for (uint32_t i = 0; i < run->system.count && run->neighbours.home; i++)
        for (int a = 0; a < 3; a++) {
            uint32_t x = run->neighbours.home[i].x[a];
            brink_code_u32(c, &x);
        }
}

static void read_homes(brink_codec *c, brink_run *run)
{
    const brink_system *s = &run->system;
    brink_neighbours *n = &run->neighbours;
    for (uint32_t i = 0; i < s->count && n->home && !c->fault; i++) {
        brink_home home = {.species = s->particle[i].species};
        for (int a = 0; a < 3; a++)
            brink_code_u32(c, &home.x[a]);
        brink_neighbours_place(n, &run->cells, i, &home);
    }
    if (!c->fault && brink_neighbours_fill(n, &run->cells, s))
        c->fault = "memory is out";
}

static void write_levels(brink_codec *c, const brink_run *run)
{
    const brink_states *s = &run->states;
    uint64_t pairs = s->links.used / 2;
    brink_code_u64(c, &pairs);
    for (uint32_t i = 0; i < run->system.count; i++)
        for (uint32_t k = 0; k < brink_states_partners(s, i); k++) {
            const brink_link link = brink_states_links(s, i)[k];
            uint32_t first = i, second = link.partner;
            int level = link.level;
            if (first > second)
                continue;
            brink_code_u32(c, &first);
            brink_code_u32(c, &second);
            brink_code_int(c, &level);
        }
}

static void read_levels(brink_codec *c, brink_run *run)
{
    const brink_system *s = &run->system;
    uint64_t pairs = 0;
    brink_code_u64(c, &pairs);
    for (uint64_t n = 0; n < pairs && !c->fault; n++) {
        uint32_t i = 0, j = 0;
        int level = 0;
        brink_code_u32(c, &i);
        brink_code_u32(c, &j);
        brink_code_int(c, &level);
        if (i >= j || j >= s->count || level < 1 ||
            level >= brink_potential_levels(brink_system_potential(s, i, j)) ||
            brink_states_level(&run->states, i, j) != 0)
            c->fault = "a pair's level is not possible";
        else if (brink_states_set(&run->states, s, i, j, level))
            c->fault = "memory is out";
    }
}

static void code_entry(brink_codec *c, brink_entry *e)
{
    brink_code_instant(c, &e->when);
    brink_code_u32(c, &e->i);
    brink_code_u32(c, &e->j);
    brink_code_u32(c, &e->generation);
    uint32_t kind = e->kind, at_once = e->at_once;
    brink_code_u32(c, &kind);
    brink_code_u32(c, &at_once);
    e->kind = (uint16_t)kind;
    e->at_once = (uint16_t)at_once;
}

static void write_entries(brink_codec *c, const brink_run *run)
{
    for (uint32_t i = 0; i < run->system.count; i++) {
        brink_entry entry = run->calendar.entry[i];
        code_entry(c, &entry);
    }
}

static int entry_is_possible(const brink_run *run, uint32_t i,
                             const brink_entry *e)
{
    if (e->when.epoch == INT64_MAX)
        return 1;
    if (!(e->when.offset >= 0) || !(e->when.offset < run->system.year) ||
        brink_instant_compare(e->when, run->now) < 0)
        return 0;
    if (e->kind == BRINK_ENTRY_CELL)
        return e->i == i && e->j < 2 * (uint32_t)run->system.dimensions;
    if (e->kind > BRINK_ENTRY_CELL || e->i >= e->j || e->j >= run->system.count ||
        (e->i != i && e->j != i))
        return 0;
    const int level = brink_states_level(&run->states, e->i, e->j);
    const uint32_t partner = e->i == i ? e->j : e->i;
    const int stale = run->system.particle[partner].generation != e->generation;
    return stale ||
           !isnan(brink_step_rise(
               brink_system_potential(&run->system, e->i, e->j), level,
               e->kind == BRINK_ENTRY_INWARD ? BRINK_INWARD : BRINK_OUTWARD));
}

static void read_entries(brink_codec *c, brink_run *run)
{
    run->calendar.epoch = run->system.epoch;
    for (uint32_t i = 0; i < run->system.count && !c->fault; i++) {
        brink_entry entry = {0};
        code_entry(c, &entry);
        if (!c->fault && !entry_is_possible(run, i, &entry))
            c->fault = "a pending event is not possible";
        else
            brink_calendar_set(&run->calendar, i, &entry);
    }
}

void brink_rooms_write(brink_codec *c, const brink_run *run)
{
    write_cells(c, run);
    write_homes(c, run);
    write_levels(c, run);
    write_entries(c, run);
}

void brink_rooms_read(brink_codec *c, brink_run *run)
{
    read_cells(c, run);
    read_homes(c, run);
    read_levels(c, run);
    read_entries(c, run);
}
