// SPDX-License-Identifier: MIT
#include "states.h"
#include "sum.h"
#include <stdlib.h>
#include <string.h>

int brink_states_create(brink_states *s, const brink_system *system)
{
    memset(s, 0, sizeof *s);
    s->particles = system->count;
    s->species_count = system->species_count;
    s->free = BRINK_NO_LINK;
    const int kinds = system->species_count * system->species_count;
    for (int p = 0; p < kinds; p++)
        if (system->potential[p].count + 1 > s->levels)
            s->levels = system->potential[p].count + 1;
    s->first = malloc(s->particles * sizeof *s->first);
    s->pairs = calloc((size_t)kinds * (size_t)s->levels, sizeof *s->pairs);
    if (!s->first || !s->pairs) {
        brink_states_destroy(s);
        return -1;
    }
    memset(s->first, 0xff, s->particles * sizeof *s->first);
    return 0;
}

void brink_states_destroy(brink_states *s)
{
    free(s->first);
    free(s->link);
    free(s->pairs);
    memset(s, 0, sizeof *s);
}

// Where the link of i to j hangs: the index that leads to it, or to nothing.
static uint32_t *find(const brink_states *s, uint32_t i, uint32_t j)
{
    uint32_t *at = &s->first[i];
    while (*at != BRINK_NO_LINK && s->link[*at].partner != j)
        at = &s->link[*at].next;
    return at;
}

int brink_states_level(const brink_states *s, uint32_t i, uint32_t j)
{
    const uint32_t at = *find(s, i, j);
    return at == BRINK_NO_LINK ? 0 : s->link[at].level;
}

// Makes two links free at least; 0, -1 no memory.
static int make_room(brink_states *s)
{
    if (s->used + 2 <= s->capacity)
        return 0;
    if (s->capacity > BRINK_NO_LINK / 2)
        return -1;
    const uint32_t capacity = s->capacity ? 2 * s->capacity : 64;
    brink_link *grown = realloc(s->link, capacity * sizeof *grown);
    if (!grown)
        return -1;
    for (uint32_t k = s->capacity; k < capacity; k++)
        grown[k].next = k + 1 < capacity ? k + 1 : s->free;
    s->free = s->capacity;
    s->link = grown;
    s->capacity = capacity;
    return 0;
}

static void write_half(brink_states *s, uint32_t i, uint32_t j, int level)
{
    uint32_t *at = find(s, i, j);
    const uint32_t k = *at;
    if (k == BRINK_NO_LINK) {
        const uint32_t fresh = s->free;
        s->free = s->link[fresh].next;
        s->used++;
        s->link[fresh] = (brink_link){j, s->first[i], level};
        s->first[i] = fresh;
    } else if (level == 0) {
        *at = s->link[k].next;
        s->link[k].next = s->free;
        s->free = k;
        s->used--;
    } else {
        s->link[k].level = level;
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
    if (before == 0 && make_room(s))
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
    uint32_t links = 0;
    int64_t stored = 0, counted = 0;
    for (uint32_t i = 0; i < s->particles; i++)
        for (uint32_t k = s->first[i]; k != BRINK_NO_LINK; k = s->link[k].next) {
            if (k >= s->capacity || ++links > s->used)
                return "a particle's partners run in a circle";
            const uint32_t j = s->link[k].partner;
            if (j >= s->particles || j == i)
                return "a particle is captured by itself or by nobody";
            const brink_potential *p = brink_system_potential(system, i, j);
            if (s->link[k].level < 1 ||
                s->link[k].level >= brink_potential_levels(p))
                return "a pair is at a level its potential does not have";
            if (brink_states_level(s, j, i) != s->link[k].level)
                return "two particles disagree about their level";
            stored++;
        }
    const int rows = s->species_count * s->species_count * s->levels;
    for (int k = 0; k < rows; k++)
        counted += s->pairs[k];
    if (links != s->used)
        return "a link belongs to nobody";
    return stored == 2 * counted ? NULL : "pairs at a level are miscounted";
}
