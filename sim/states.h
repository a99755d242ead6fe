// SPDX-License-Identifier: MIT
#ifndef BRINK_STATES_H
#define BRINK_STATES_H
/**
 * The logical state of every pair [S16 section 2]: its level in its potential.
 * Only pairs at a level above 0 are stored, each with both its particles, so
 * memory goes with the number of captured pairs and a particle's partners are at
 * hand when it is looked at.  Levels change by brink_states_apply alone.
 */
#include "system.h"

typedef struct brink_link { // one captured pair, as one of its particles has it
    uint32_t partner;
    uint32_t next; // the particle's next link, or BRINK_NO_LINK
    int32_t level; // 1..count
} brink_link;

#define BRINK_NO_LINK UINT32_MAX

typedef struct brink_states {
    uint32_t particles;
    uint32_t *first;   // per particle: its first link
    brink_link *link;  // pool
    uint32_t capacity; // of the pool
    uint32_t free;     // first of the free links, chained by `next`
    uint32_t used;
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

/** A bit for each partner of i, by its number modulo 64: who has none there is no
 * partner, and most who are asked about are none. */
static inline uint64_t brink_states_hint(const brink_states *s, uint32_t i)
{
    uint64_t hint = 0;
    for (uint32_t k = s->first[i]; k != BRINK_NO_LINK; k = s->link[k].next)
        hint |= UINT64_C(1) << s->link[k].partner % 64;
    return hint;
}

static inline int brink_states_is_partner(const brink_states *s, uint32_t i,
                                          uint32_t j, uint64_t hint_of_i)
{
    return hint_of_i >> j % 64 & 1 && brink_states_level(s, i, j) > 0;
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
