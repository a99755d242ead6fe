// SPDX-License-Identifier: MIT
// with: -wp-fct brink_states_partners,brink_states_links,find
// with: -wp-fct brink_states_level,brink_system_potential,brink_states_apply
// with: -inline-calls brink_lists_items
// with: -wp-model Typed+cast
/**
 * The levels of pairs, as compiled: what a particle's links say of a partner is
 * found, and an executed event sets the level that the state machine gives, one
 * up by a capture or one down by a release; a refused one writes nothing.
 */
#include "step_levels_wp.h"

#include "../sim/states.h"

/*@ logic brink_link *links(brink_states *s, integer i) =
  @     (brink_link *)s->links.list[i].item;
  @
  @ predicate is_states(brink_states *s) =
  @     \valid_read(s) && \valid_read(s->links.list + (0 .. s->particles - 1)) &&
  @     \forall integer i; 0 <= i < s->particles ==>
  @         \valid_read(links(s, i) + (0 .. s->links.list[i].count - 1));
  @
  @ // What i's links from k on say of j; level 0 where they say nothing.
  @ logic integer level_from(brink_states *s, integer i, integer j, integer k) =
  @     k >= s->links.list[i].count ? 0
  @     : links(s, i)[k].partner == j ? links(s, i)[k].level
  @                                   : level_from(s, i, j, k + 1);
  @ logic integer level_of(brink_states *s, integer i, integer j) =
  @     level_from(s, i, j, 0);
  @*/

/*@ requires is_states(s) && i < s->particles;
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \result == s->links.list[i].count;
  @*/
static inline uint32_t brink_states_partners(const brink_states *s, uint32_t i);

/*@ requires is_states(s) && i < s->particles;
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \result == links(s, i);
  @*/
static inline const brink_link *brink_states_links(const brink_states *s,
                                                   uint32_t i);

/*@ requires is_states(s) && i < s->particles;
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures 0 <= \result <= s->links.list[i].count;
  @ ensures level_of(s, i, j) == (\result < s->links.list[i].count
  @                                   ? links(s, i)[\result].level : 0);
  @*/
static uint32_t find(const brink_states *s, uint32_t i, uint32_t j);

/*@ requires is_states(s) && i < s->particles;
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \result == level_of(s, i, j);
  @*/
int brink_states_level(const brink_states *s, uint32_t i, uint32_t j);

/*@ predicate is_system(brink_system *t) =
  @     \valid_read(t) && \valid_read(t->particle + (0 .. t->count - 1)) &&
  @     1 <= t->species_count <= 0x4000 &&
  @     (\forall integer i; 0 <= i < t->count ==>
  @         t->particle[i].species < t->species_count) &&
  @     \forall integer k; 0 <= k < t->species_count * t->species_count ==>
  @         is_potential(t->potential + k);
  @
  @ logic brink_potential *potential(brink_system *t, integer i, integer j) =
  @     t->potential +
  @     (t->particle[i].species * t->species_count + t->particle[j].species);
  @*/

/*@ requires is_system(s) && i < s->count && j < s->count;
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \result == potential(s, i, j) && is_potential(\result);
  @*/
static inline const brink_potential *
brink_system_potential(const brink_system *s, uint32_t i, uint32_t j);

/*@ requires is_states(s) && i < s->particles && j < s->particles;
  @ terminates \true;
  @ exits \false;
  @ assigns *s, s->links.list[0 .. s->particles - 1], *s->pairs;
  @ ensures \result == 0 || \result == -1;
  @ ensures \result == 0 ==> level_of(s, i, j) == level;
  @*/
int brink_states_set(brink_states *s, const brink_system *system, uint32_t i,
                     uint32_t j, int level);

/*@ requires is_states(s) && i < s->particles && j < s->particles;
  @ requires is_system(system) && system->count == s->particles;
  @ terminates \true;
  @ exits \false;
  @ behavior refused:
  @     assumes !legal(potential(system, i, j), level_of(s, i, j), event);
  @     assigns \nothing;
  @     ensures \result == 1;
  @ behavior accepted:
  @     assumes legal(potential(system, i, j), level_of(s, i, j), event);
  @     ensures \result == 0 || \result == -1;
  @     ensures \result == 0 ==>
  @         level_of(s, i, j) == \old(level_of(s, i, j)) + change(event);
  @ complete behaviors;
  @ disjoint behaviors;
  @*/
int brink_states_apply(brink_states *s, const brink_system *system, uint32_t i,
                       uint32_t j, enum brink_event_kind event);

#include "../sim/states.c"
