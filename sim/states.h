// SPDX-License-Identifier: MIT
#ifndef BRINK_STATES_H
#define BRINK_STATES_H
/**
 * The logical state of every pair [S16 section 2]: its level in its potential.
 * Only pairs at a level above 0 are stored, each with both its particles, so
 * memory goes with the number of captured pairs; a particle's partners and levels
 * lie side by side.  Levels change by brink_states_apply alone.
 */
#include "lists.h"
#include "system.h"

typedef struct brink_link { // one captured pair, as one of its particles has it
    uint32_t partner;
    int32_t level; // 1..count
} brink_link;

typedef struct brink_states {
    uint32_t particles;
    brink_lists links; // of brink_link
    int species_count;
    int levels;     // the most levels any potential has
    int64_t *pairs; // pairs at a level: [(a * species_count + b) * levels +
                    // level], a <= b; level 0 is not counted
} brink_states;

int brink_states_create(brink_states *s,
                        const brink_system *system); // 0, -1 no memory
void brink_states_destroy(brink_states *s);
const char *brink_states_is_valid(const brink_states *s,
                                  const brink_system *system);

int brink_states_level(const brink_states *s, uint32_t i, uint32_t j);

/** How many partners i has, and i's links with them. */
static inline uint32_t brink_states_partners(const brink_states *s, uint32_t i)
{
    return s->links.list[i].count;
}

static inline const brink_link *brink_states_links(const brink_states *s,
                                                   uint32_t i)
{
    return brink_lists_items(&s->links, i);
}

/** Sets a pair's level when a configuration is first made or loaded.  0, -1 no
 * memory. */
int brink_states_set(brink_states *s, const brink_system *system, uint32_t i,
                     uint32_t j, int level);

/** Applies an executed event.  0; -1 no memory; 1 refused by the state machine:
 * the event was illegal for the pair's level, and nothing has changed. */
int brink_states_apply(brink_states *s, const brink_system *system, uint32_t i,
                       uint32_t j, enum brink_event_kind event);

/** Potential energy: counted pairs times their energies, summed compensated. */
double brink_states_energy(const brink_states *s, const brink_system *system);
#endif
