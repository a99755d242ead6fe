// SPDX-License-Identifier: MIT
#include "states.h"
#include "sum.h"
#include <stdlib.h>
#include <string.h>

#define NO_BLOCK UINT32_MAX

// The size, as 4 * 2^size, of the block for so many links; -1 for none.
static int size_for(uint32_t count)
{
    int size = -1;
    while (count > 0 && (size < 0 || UINT32_C(4) << size < count))
        size++;
    return size;
}

static uint32_t take_block(brink_states *s, int size)
{
    uint32_t first = s->free[size];
    if (first != NO_BLOCK) {
        s->free[size] = s->link[first].partner;
    } else {
        first = s->touched;
        s->touched += UINT32_C(4) << size;
    }
    return first;
}

static void free_block(brink_states *s, uint32_t first, int size)
{
    s->link[first].partner = s->free[size];
    s->free[size] = first;
}

// Makes room in the pool for two blocks of so many links; 0, -1 no memory.
static int make_room(brink_states *s, uint32_t count)
{
    const int size = size_for(count);
    const uint64_t needed = s->touched + (size < 0 ? 0 : UINT64_C(8) << size);
    if (needed <= s->capacity)
        return 0;
    if (needed >= NO_BLOCK)
        return -1;
    uint64_t capacity = 2 * (uint64_t)s->capacity;
    capacity = capacity < needed     ? needed
               : capacity < NO_BLOCK ? capacity
                                     : NO_BLOCK;
    brink_link *grown = realloc(s->link, capacity * sizeof *grown);
    if (!grown)
        return -1;
    s->link = grown;
    s->capacity = (uint32_t)capacity;
    return 0;
}

int brink_states_create(brink_states *s, const brink_system *system)
{
    memset(s, 0, sizeof *s);
    s->particles = system->count;
    s->species_count = system->species_count;
    memset(s->free, 0xff, sizeof s->free);
    const int kinds = system->species_count * system->species_count;
    for (int p = 0; p < kinds; p++)
        if (system->potential[p].count + 1 > s->levels)
            s->levels = system->potential[p].count + 1;
    s->circle = calloc(s->particles, sizeof *s->circle);
    s->pairs = calloc((size_t)kinds * (size_t)s->levels, sizeof *s->pairs);
    if (!s->circle || !s->pairs || make_room(s, 1)) {
        brink_states_destroy(s);
        return -1;
    }
    return 0;
}

void brink_states_destroy(brink_states *s)
{
    free(s->circle);
    free(s->link);
    free(s->pairs);
    memset(s, 0, sizeof *s);
}

int brink_states_level(const brink_states *s, uint32_t i, uint32_t j)
{
    const brink_link *link = brink_states_links(s, i);
    for (uint32_t k = 0; k < s->circle[i].count; k++)
        if (link[k].partner == j)
            return link[k].level;
    return 0;
}

// Moves the links of i to a block for one more, or one fewer, if theirs is full
// or too large for that; the pool has room.
static void fit(brink_states *s, uint32_t i, uint32_t count)
{
    brink_circle *c = &s->circle[i];
    const int from = size_for(c->count), to = size_for(count);
    const uint32_t old = c->first;
    if (from == to)
        return;
    if (to >= 0) {
        c->first = take_block(s, to);
        const uint32_t kept = c->count < count ? c->count : count;
        memcpy(&s->link[c->first], &s->link[old], kept * sizeof *s->link);
    }
    if (from >= 0)
        free_block(s, old, from);
}

// The levels of a pair as i has them.
static void write_half(brink_states *s, uint32_t i, uint32_t j, int level)
{
    brink_circle *c = &s->circle[i];
    brink_link *link = &s->link[c->first];
    uint32_t k = 0;
    while (k < c->count && link[k].partner != j)
        k++;
    if (k == c->count) {
        fit(s, i, c->count + 1);
        s->link[c->first + c->count++] = (brink_link){j, level};
        s->used++;
    } else if (level == 0) {
        link[k] = link[c->count - 1];
        fit(s, i, c->count - 1);
        c->count--;
        s->used--;
    } else {
        link[k].level = level;
    }
}

static int64_t *counter(const brink_states *s, const brink_system *system,
                        uint32_t i, uint32_t j, int level)
{
    const uint32_t a = system->particle[i].species,
                   b = system->particle[j].species;
    const uint32_t pair =
        (a < b ? a : b) * (uint32_t)s->species_count + (a < b ? b : a);
    return &s->pairs[pair * (uint32_t)s->levels + (uint32_t)level];
}

int brink_states_set(brink_states *s, const brink_system *system, uint32_t i,
                     uint32_t j, int level)
{
    const int before = brink_states_level(s, i, j);
    if (level == before)
        return 0;
    const uint32_t ci = s->circle[i].count, cj = s->circle[j].count;
    // Who gets a partner may need a larger block, who loses one a smaller.
    if ((before == 0 || level == 0) && make_room(s, (ci > cj ? ci : cj) + 1))
        return -1;
    write_half(s, i, j, level);
    write_half(s, j, i, level);
    if (before > 0)
        --*counter(s, system, i, j, before);
    if (level > 0)
        ++*counter(s, system, i, j, level);
    return 0;
}

int brink_states_apply(brink_states *s, const brink_system *system, uint32_t i,
                       uint32_t j, enum brink_event_kind event)
{
    int level = brink_states_level(s, i, j);
    if (!brink_step_next(brink_system_potential(system, i, j), level, event,
                         &level))
        return 1;
    return brink_states_set(s, system, i, j, level);
}

double brink_states_energy(const brink_states *s, const brink_system *system)
{
    brink_sum sum = {0};
    for (int a = 0; a < s->species_count; a++)
        for (int b = a; b < s->species_count; b++) {
            const int pair = a * s->species_count + b;
            const brink_potential *p = &system->potential[pair];
            for (int level = 1; level < brink_potential_levels(p); level++)
                brink_sum_product(&sum,
                                  (double)s->pairs[pair * s->levels + level],
                                  brink_potential_energy(p, level));
        }
    return brink_sum_value(&sum);
}

const char *brink_states_is_valid(const brink_states *s,
                                  const brink_system *system)
{
    uint64_t links = 0;
    int64_t counted = 0;
    for (uint32_t i = 0; i < s->particles; i++) {
        const brink_circle c = s->circle[i];
        links += c.count;
        if (links > s->used || c.first + (uint64_t)c.count > s->touched)
            return "a particle's partners are more than there are";
        for (uint32_t k = c.first; k < c.first + c.count; k++) {
            const uint32_t j = s->link[k].partner;
            if (j >= s->particles || j == i)
                return "a particle is captured by itself or by nobody";
            const brink_potential *p = brink_system_potential(system, i, j);
            if (s->link[k].level < 1 ||
                s->link[k].level >= brink_potential_levels(p))
                return "a pair is at a level its potential does not have";
            if (brink_states_level(s, j, i) != s->link[k].level)
                return "two particles disagree about their level";
        }
    }
    const int rows = s->species_count * s->species_count * s->levels;
    for (int k = 0; k < rows; k++)
        counted += s->pairs[k];
    if (links != s->used)
        return "a link belongs to nobody";
    return (int64_t)links == 2 * counted ? NULL
                                         : "pairs at a level are miscounted";
}
