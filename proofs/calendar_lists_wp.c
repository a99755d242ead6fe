// SPDX-License-Identifier: MIT
// with: -wp-fct heap_add,heap_remove,list_add,list_remove,entry_put,turn_to
// with: -wp-timeout 60
/**
 * What the calendar's functions do to its heap and lists, as compiled, slot by
 * slot.  A slot that is put in a list is its first, one that is taken out is left
 * out by the two beside it, and every other link, place and first is what it was;
 * the heap's moves touch no link at all, and of slots that are not in the heap no
 * place.  That this keeps the calendar as a whole is calendar_filed_wp.c.
 */
#include "calendar_memory_wp.h"

#include "calendar_told_wp.h"

#include "calendar_places_wp.h"

#include "calendar_same_wp.h"

#include "calendar_shown_wp.h"

/*@ lemma firsts_on{A, B, C}: \forall brink_calendar *c, integer but;
  @     same_but_count{A, B}(c, but) && same_firsts{B, C}(c, -1) ==>
  @     same_firsts{A, C}(c, -1);
  @ lemma nexts_on{A, B, C}: \forall brink_calendar *c, integer but;
  @     same_but_count{A, B}(c, but) && same_nexts{B, C}(c, -1) ==>
  @     same_nexts{A, C}(c, -1);
  @ lemma previous_on{A, B, C}: \forall brink_calendar *c, integer but;
  @     same_but_count{A, B}(c, but) && same_previous{B, C}(c, -1, -1) ==>
  @     same_previous{A, C}(c, -1, -1);
  @ lemma one_more{A, B}: \forall brink_calendar *c, integer s;
  @     same_but_count{A, B}(c, -1) &&
  @     \at(c->heap_count, A) < \at(c->slots, A) &&
  @     \at(c->heap_count, B) == \at(c->heap_count, A) + 1 &&
  @     0 <= s < \at(c->slots, A) ==>
  @     (in_heap{B}(c, \at(c->heap_count, A), s) <==> in_heap{A}(c, -1, s));
  @ lemma one_more_and_on{A, B, C}: \forall brink_calendar *c, integer end, slot;
  @     same_but_count{A, B}(c, -1) &&
  @     \at(c->heap_count, A) < \at(c->slots, A) &&
  @     \at(c->heap_count, B) == \at(c->heap_count, A) + 1 &&
  @     end == \at(c->heap_count, A) && none_lost{B, C}(c, end, -1, slot) ==>
  @     none_lost{A, C}(c, -1, -1, slot);
  @
  @ predicate is_one_less{A, B}(brink_calendar *c, integer slot, integer last) =
  @     same_but_count{A, B}(c, slot) && 0 <= slot < \at(c->slots, A) &&
  @     \at(c->heap_count, B) == \at(c->heap_count, A) - 1 &&
  @     \at(c->filed[slot].place, B) == 0xFFFFFFFF &&
  @     \at(c->heap_count, A) <= \at(c->slots, A) < 0x80000000 &&
  @     last == \at(c->heap[c->heap_count - 1], A) &&
  @     is_indexed{A}(c, -1) && in_heap{A}(c, -1, slot);
  @ lemma one_less{A, B}: \forall brink_calendar *c, integer slot, last, s;
  @     is_one_less{A, B}(c, slot, last) && 0 <= s < \at(c->slots, A) &&
  @     s != slot && s != last ==>
  @     (in_heap{B}(c, \at(c->filed[slot].place, A), s) <==>
  @         in_heap{A}(c, -1, s));
  @ lemma one_less_and_on{A, B, C}: \forall brink_calendar *c,
  @     integer hole, slot, last; is_one_less{A, B}(c, slot, last) &&
  @     hole == \at(c->filed[slot].place, A) &&
  @     none_lost{B, C}(c, hole, -1, last) && in_heap{C}(c, -1, last) ==>
  @     none_lost{A, C}(c, -1, -1, slot);
  @ lemma the_last_less{A, B}: \forall brink_calendar *c, integer slot;
  @     is_one_less{A, B}(c, slot, slot) ==>
  @     is_indexed{B}(c, -1) && none_lost{A, B}(c, -1, -1, slot);
  @ lemma a_hole_less{A, B}: \forall brink_calendar *c, integer slot, last;
  @     is_one_less{A, B}(c, slot, last) && last != slot ==>
  @     is_indexed{B}(c, \at(c->filed[slot].place, A)) &&
  @     0 <= last < \at(c->slots, A) &&
  @     \at(c->filed[slot].place, A) < \at(c->heap_count, B) &&
  @     !in_heap{B}(c, \at(c->filed[slot].place, A), last);
  @*/

#include "calendar_ghosts_wp.h"

#include "calendar_unordered_wp.h"

#include "calendar_calls_wp.h"

// --- The heap, but for its order, which is calendar_wp.c's ---------------------

// Trusted: as calendar_wp.c proves it, of the heap apart from memory.
/*@ requires has_hole(c, position, slot);
  @ terminates \true;
  @ exits \false;
  @ assigns c->heap[0 .. c->heap_count - 1],
  @         c->filed[0 .. c->slots - 1].place;
  @ ensures whole: is_calendar(c) && c->heap_count == \old(c->heap_count);
  @ ensures size: same_size{Pre, Post}(c);
  @ ensures day: same_day{Pre, Post}(c);
  @ ensures firsts: same_firsts{Pre, Post}(c, -1);
  @ ensures nexts: same_nexts{Pre, Post}(c, -1);
  @ ensures previous: same_previous{Pre, Post}(c, -1, -1);
  @ ensures index: is_indexed(c, -1);
  @ ensures put_in: in_heap(c, -1, slot);
  @ ensures none_lost: none_lost{Pre, Post}(c, \at(position, Pre), -1, slot);
  @*/
static void heap_settle(brink_calendar *c, uint32_t position, uint32_t slot);

#include "../sim/calendar.c"
