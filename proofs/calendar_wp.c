// SPDX-License-Identifier: MIT
// with: -wp-fct brink_instant_compare,brink_entry_compare,earlier
// with: -wp-fct heap_put,heap_settle,list_add
/**
 * The calendar's heap and lists, as compiled.  The index is kept: the slot at a
 * position of the heap has that position for its place, so no slot is there
 * twice; and none gets lost: whatever was in the heap is in it afterwards, with
 * the slot that was put in.  A slot that is put in a list is its first, and
 * whoever was first has it before itself.  Nothing outside the calendar's own
 * arrays is read or written, and every loop ends.
 */
#include "../sim/calendar.h"
#include "libm_wp.h"

/*@ predicate is_calendar(brink_calendar *c) =
  @     \valid(c) && c->slots < 0x80000000 && c->heap_count <= c->slots &&
  @     c->days <= 0x40000000 &&
  @     \valid_read(c->entry + (0 .. c->slots - 1)) &&
  @     \valid(c->filed + (0 .. c->slots)) &&
  @     \valid(c->heap + (0 .. c->slots - 1)) &&
  @     \valid(c->first + (0 .. c->days)) &&
  @     \separated(c, c->entry + (0 .. c->slots - 1), c->filed + (0 .. c->slots),
  @                c->heap + (0 .. c->slots - 1), c->first + (0 .. c->days));
  @
  @ // The heap knows its slots' places, but at the position where it has a hole.
  @ predicate is_indexed(brink_calendar *c, integer hole) =
  @     \forall integer p; 0 <= p < c->heap_count && p != hole ==>
  @         c->heap[p] < c->slots && c->filed[c->heap[p]].place == p;
  @
  @ predicate in_heap(brink_calendar *c, integer hole, integer slot) =
  @     c->filed[slot].place < c->heap_count && c->filed[slot].place != hole &&
  @     c->heap[c->filed[slot].place] == slot;
  @
  @ predicate has_hole(brink_calendar *c, integer hole, integer slot) =
  @     is_calendar(c) && 0 <= hole < c->heap_count && 0 <= slot < c->slots &&
  @     is_indexed(c, hole) && !in_heap(c, hole, slot);
  @
  @ // The hole has moved, no slot is lost, the one to be put in is not in yet.
  @ predicate a_hole_moved{Old, New}(brink_calendar *c, integer before,
  @                                  integer hole, integer slot) =
  @     has_hole{New}(c, hole, slot) &&
  @     \at(c->slots, New) == \at(c->slots, Old) &&
  @     \at(c->heap_count, New) == \at(c->heap_count, Old) &&
  @     \forall integer s; 0 <= s < \at(c->slots, Old) &&
  @         in_heap{Old}(c, before, s) ==> in_heap{New}(c, hole, s);
  @*/

/*@ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures -1 <= \result <= 1;
  @*/
static inline int brink_instant_compare(brink_instant a, brink_instant b);

/*@ requires \valid_read(a) && \valid_read(b);
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures -1 <= \result <= 1;
  @*/
int brink_entry_compare(const brink_entry *a, const brink_entry *b);

/*@ requires is_calendar(c);
  @ requires a < c->slots && b < c->slots;
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \result == 0 || \result == 1;
  @*/
static int earlier(const brink_calendar *c, uint32_t a, uint32_t b);

/*@ requires is_calendar(c);
  @ requires position < c->slots && slot < c->slots;
  @ terminates \true;
  @ exits \false;
  @ assigns c->heap[position], c->filed[slot].place;
  @ ensures here: c->heap[position] == slot && c->filed[slot].place == position;
  @ ensures whole: is_calendar(c) && c->slots == \old(c->slots) &&
  @                c->heap_count == \old(c->heap_count);
  @ ensures heap: \forall integer p; 0 <= p < c->slots && p != position ==>
  @     c->heap[p] == \old(c->heap[p]);
  @ ensures places: \forall integer s; 0 <= s < c->slots && s != slot ==>
  @     c->filed[s].place == \old(c->filed[s].place);
  @ ensures moves_the_hole: \forall integer from, to_come;
  @     \old(has_hole(c, position, to_come)) && 0 <= from < c->heap_count &&
  @     from != position && \old(c->heap[from]) == slot ==>
  @     a_hole_moved{Pre, Post}(c, position, from, to_come);
  @ ensures fills_the_hole: \old(has_hole(c, position, slot)) ==>
  @     is_indexed(c, -1) && in_heap(c, -1, slot) &&
  @     \forall integer s; 0 <= s < c->slots && in_heap{Pre}(c, position, s) ==>
  @         in_heap(c, -1, s);
  @*/
static void heap_put(brink_calendar *c, uint32_t position, uint32_t slot);

/*@ requires has_hole(c, position, slot);
  @ terminates \true;
  @ exits \false;
  @ ensures index: is_indexed(c, -1);
  @ ensures put_in: in_heap(c, -1, slot);
  @ ensures none_lost: \forall integer s; 0 <= s < c->slots &&
  @     in_heap{Pre}(c, \at(position, Pre), s) ==> in_heap(c, -1, s);
  @*/
static void heap_settle(brink_calendar *c, uint32_t position, uint32_t slot);

/*@ requires is_calendar(c);
  @ requires list <= c->days && slot < c->slots;
  @ requires c->first[list] <= c->slots && c->first[list] != slot;
  @ terminates \true;
  @ exits \false;
  @ assigns c->first[list], c->filed[slot];
  @ assigns c->filed[\at(c->first[list], Pre)].previous;
  @ ensures first: c->first[list] == slot;
  @ ensures before: c->filed[slot].previous == c->slots;
  @ ensures after: c->filed[slot].next == \old(c->first[list]);
  @ ensures and_back: c->filed[c->filed[slot].next].previous == slot;
  @ ensures place: c->filed[slot].place == 0x80000000 + list;
  @*/
static void list_add(brink_calendar *c, uint32_t list, uint32_t slot);

#include "../sim/calendar.c"
