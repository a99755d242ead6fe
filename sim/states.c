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
    const int kinds = system->species_count * system->species_count;
    for (int p = 0; p < kinds; p++)
        if (system->potential[p].count + 1 > s->levels)
            s->levels = system->potential[p].count + 1;
    s->pairs = calloc((size_t)kinds * (size_t)s->levels, sizeof *s->pairs);
    if (!s->pairs ||
        brink_lists_create(&s->links, s->particles, sizeof(brink_link))) {
        brink_states_destroy(s);
        return -1;
    }
    return 0;
}

void brink_states_destroy(brink_states *s)
{
    brink_lists_destroy(&s->links);
    free(s->pairs);
    memset(s, 0, sizeof *s);
}

// Where i's link with j is among its links; the number of them if it is not.
static uint32_t find(const brink_states *s, uint32_t i, uint32_t j)
{
    const brink_link *link = brink_states_links(s, i);
    const uint32_t count = brink_states_partners(s, i);
    uint32_t k = 0;
    /*@ loop invariant k <= count;
      @ loop invariant level_of(s, i, j) == level_from(s, i, j, k);
      @ loop assigns k;
      @ loop variant count - k; */
    while (k < count && link[k].partner != j)
        k++;
    return k;
}

int brink_states_level(const brink_states *s, uint32_t i, uint32_t j)
{
    const uint32_t k = find(s, i, j);
    return k < brink_states_partners(s, i) ? brink_states_links(s, i)[k].level
                                           : 0;
}

// The level of a pair as i has it.
static void write_half(brink_states *s, uint32_t i, uint32_t j, int level)
{
    const uint32_t k = find(s, i, j);
    if (k == brink_states_partners(s, i))
        *(brink_link *)brink_lists_add(&s->links, i) = (brink_link){j, level};
    else if (level == 0)
        brink_lists_remove(&s->links, i, k);
    else
        ((brink_link *)brink_lists_items(&s->links, i))[k].level = level;
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
    if (before == 0 && brink_lists_make_room(&s->links, i, j))
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
        const brink_link *link = brink_states_links(s, i);
        const uint32_t count = brink_states_partners(s, i);
        links += count;
        if (links > s->links.used)
            return "a particle's partners are more than there are";
        for (uint32_t k = 0; k < count; k++) {
            const uint32_t j = link[k].partner;
            if (j >= s->particles || j == i)
                return "a particle is captured by itself or by nobody";
            const brink_potential *p = brink_system_potential(system, i, j);
            if (link[k].level < 1 || link[k].level >= brink_potential_levels(p))
                return "a pair is at a level its potential does not have";
            if (brink_states_level(s, j, i) != link[k].level)
                return "two particles disagree about their level";
        }
    }
    const int rows = s->species_count * s->species_count * s->levels;
    for (int k = 0; k < rows; k++)
        counted += s->pairs[k];
    if (links != s->links.used)
        return "a link belongs to nobody";
    return (int64_t)links == 2 * counted ? NULL
                                         : "pairs at a level are miscounted";
}
