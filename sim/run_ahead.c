// SPDX-License-Identifier: MIT
#include "run_ahead.h"

#define PREFETCH(address) __builtin_prefetch(address)

// A day has one or two events as a rule; who comes third must wait.
enum { TO_A_DAY = 2 };

// The first slot of a day of this year, or the number of slots.
static uint32_t first_of(const brink_calendar *c, uint32_t days)
{
    const uint32_t day = c->today + days;
    return day < c->days ? c->first[day] : c->slots;
}

static void ask_slot(const brink_calendar *c, uint32_t slot)
{
    PREFETCH(&c->entry[slot]);
    PREFETCH(&c->filed[slot]);
}

static void ask_particle(const brink_run *run, uint32_t i)
{
    const brink_neighbours *n = &run->neighbours;
    PREFETCH(&run->system.particle[i]);
    PREFETCH(&run->states.links.list[i]);
    PREFETCH(&run->cells.cell[i]);
    ask_slot(&run->calendar, i);
    if (n->radius > 0) {
        PREFETCH(&n->home[i]);
        PREFETCH(&n->who.list[i]);
    }
}

static void ask_list(const brink_run *run, uint32_t i)
{
    PREFETCH(brink_neighbours_of(&run->neighbours, i));
}

static void ask_neighbours(const brink_run *run, uint32_t i)
{
    const uint32_t *who = brink_neighbours_of(&run->neighbours, i);
    const uint32_t count = brink_neighbours_count(&run->neighbours, i);
    for (uint32_t k = 0; k < count; k++)
        PREFETCH(&run->system.particle[who[k]]);
}

// The rows of cells around i's; beyond the box's edges others, to no harm.
static void ask_cells(const brink_run *run, uint32_t i)
{
    const brink_cells *c = &run->cells;
    const uint32_t nx = (uint32_t)c->count[0], ny = (uint32_t)c->count[1];
    const uint32_t cell = c->cell[i], below = cell - nx * (ny + 1);
    for (uint32_t z = 0; z < 3; z++)
        for (uint32_t y = 0; y < 3; y++) {
            const uint32_t at = below + nx * (y + ny * z);
            PREFETCH(&c->bucket[at < c->total ? at : cell]);
        }
}

// Asks something for those that the slots of a day are about.
static void for_day(const brink_run *run, uint32_t days,
                    void ask(const brink_run *run, uint32_t i))
{
    const brink_calendar *c = &run->calendar;
    uint32_t slot = first_of(c, days);
    for (int k = 0; k < TO_A_DAY && slot < c->slots; k++) {
        const brink_entry *e = &c->entry[slot];
        ask(run, e->i);
        if (e->kind != BRINK_ENTRY_CELL)
            ask(run, e->j);
        slot = c->filed[slot].next;
    }
}

// Each thing two days before the next one, which it tells where to find.
void brink_look_ahead(brink_run *run)
{
    const brink_calendar *c = &run->calendar;
    if (c->today == run->looked)
        return;
    run->looked = c->today;
    uint32_t slot = first_of(c, 6);
    if (slot < c->slots)
        ask_slot(c, slot);
    slot = first_of(c, 5);
    if (slot < c->slots && c->filed[slot].next < c->slots)
        ask_slot(c, c->filed[slot].next);
    for_day(run, 4, ask_particle);
    if (run->neighbours.radius > 0) {
        for_day(run, 2, ask_list);
        for_day(run, 1, ask_neighbours);
    } else {
        for_day(run, 2, ask_cells);
    }
}
