// SPDX-License-Identifier: MIT
#include "../sim/calendar.h"
#include "libm_wp.h"
#include "calendar_heap_wp.h"

/*@ predicate is_calendar(brink_calendar *c) =
  @     \valid(c) && c->slots < 0x80000000 && c->heap_count <= c->slots &&
  @     c->days <= 0x40000000 &&
  @     \valid_read(c->entry + (0 .. c->slots - 1)) &&
  @     \valid(c->filed + (0 .. c->slots)) &&
  @     \valid(c->heap + (0 .. c->slots - 1)) &&
  @     \valid(c->first + (0 .. c->days)) &&
  @     \separated(c, c->entry + (0 .. c->slots - 1), c->filed + (0 .. c->slots),
  @                c->heap + (0 .. c->slots - 1), c->first + (0 .. c->days));
  @ predicate knows_slots(brink_calendar *c) =
  @     \forall integer p; 0 <= p < c->slots ==> c->heap[p] < c->slots;
  @ predicate has_times(brink_calendar *c) =
  @     \forall integer s; 0 <= s < c->slots ==>
  @         \is_finite(c->entry[s].when.offset);
  @
  @ predicate is_heap_of{L}(heap h, brink_calendar *c) =
  @     slots(h) == c->slots && count(h) == c->heap_count &&
  @     (\forall integer p; at(h, p) == c->heap[p]) &&
  @     (\forall integer s; place(h, s) == c->filed[s].place);
  @
  @ axiomatic HeapOf {
  @   logic heap heap_of{L}(brink_calendar *c)
  @     reads *c, c->heap[..], c->filed[..], c->entry[..];
  @   axiom it_is{L}: \forall brink_calendar *c; is_heap_of{L}(heap_of{L}(c), c);
  @ }
  @
  @ predicate a_hole_moved{Old, New}(brink_calendar *c, integer before,
  @                                  integer hole, integer slot) =
  @     is_calendar{New}(c) && has_times{New}(c) && knows_slots{New}(c) &&
  @     0 <= hole < \at(c->heap_count, New) &&
  @     \at(c->heap_count, New) == \at(c->heap_count, Old) &&
  @     \at(c->slots, New) == \at(c->slots, Old) &&
  @     has_hole(heap_of{New}(c), hole, slot) &&
  @     has_become(heap_of{Old}(c), heap_of{New}(c), before, hole, -1);
  @*/

/*@ requires is_calendar(c) && has_times(c);
  @ requires a < c->slots && b < c->slots;
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \result == 0 || \result == 1;
  @ ensures \result != 0 <==> before(heap_of(c), a, b);
  @*/
static int earlier(const brink_calendar *c, uint32_t a, uint32_t b);

/*@ requires is_calendar(c);
  @ requires position < c->slots && slot < c->slots;
  @ terminates \true;
  @ exits \false;
  @ assigns c->heap[position], c->filed[slot].place;
  @ ensures whole: is_calendar(c);
  @ ensures slots: \old(knows_slots(c)) ==> knows_slots(c);
  @ ensures put: is_put(heap_of{Pre}(c), heap_of{Post}(c), position, slot);
  @*/
static void heap_put(brink_calendar *c, uint32_t position, uint32_t slot);

/*@ requires is_calendar(c) && has_times(c) && knows_slots(c);
  @ requires position < c->heap_count && slot < c->slots;
  @ requires has_hole(heap_of(c), position, slot);
  @ terminates \true;
  @ exits \false;
  @ ensures index: is_indexed(heap_of(c), -1);
  @ ensures order: is_ordered(heap_of(c), -1);
  @ ensures put_in: in_heap(heap_of(c), -1, slot);
  @ ensures none_lost: has_become(heap_of{Pre}(c), heap_of{Post}(c), \at(position, Pre), -1, slot);
  @*/
static void heap_settle(brink_calendar *c, uint32_t position, uint32_t slot);

#include "../sim/calendar.c"
