// SPDX-License-Identifier: MIT
/**
 * The calendar in memory, and the heap that it is.
 */
#include "calendar_memory_wp.h"

#include "calendar_heap_wp.h"

/*@ predicate has_times(brink_calendar *c) =
  @     \forall integer s; 0 <= s < c->slots ==>
  @         \is_finite(c->entry[s].when.offset);
  @
  @ predicate is_heap_of{L}(heap h, brink_calendar *c) =
  @     slots(h) == c->slots && count(h) == c->heap_count &&
  @     (\forall integer p; at(h, p) == c->heap[p]) &&
  @     (\forall integer s; place(h, s) == c->filed[s].place);
  @
  @ // What is in memory is the heap of these numbers: one for whatever is there,
  @ // so that this is a definition, and assumes nothing.
  @ axiomatic HeapOf {
  @   logic heap heap_of{L}(brink_calendar *c)
  @     reads *c, c->heap[..], c->filed[..], c->entry[..];
  @   axiom it_is{L}: \forall brink_calendar *c;
  @       is_heap_of{L}(heap_of{L}(c), c);
  @ }
  @
  @ predicate same_entry{A, B}(brink_entry *e, brink_entry *f) =
  @     \at(e->when.epoch, A) == \at(f->when.epoch, B) &&
  @     \at(e->when.offset, A) == \at(f->when.offset, B) &&
  @     \at(e->kind, A) == \at(f->kind, B) &&
  @     \at(e->i, A) == \at(f->i, B) && \at(e->j, A) == \at(f->j, B);
  @ predicate same_entries{A, B}(brink_calendar *c) =
  @     \at(c->slots, A) == \at(c->slots, B) &&
  @     \at(c->heap_count, A) == \at(c->heap_count, B) &&
  @     \forall integer s; 0 <= s < \at(c->slots, A) ==>
  @         same_entry{A, B}(\at(c->entry, A) + s, \at(c->entry, B) + s);
  @
  @ predicate can_settle(brink_calendar *c, integer position, integer slot) =
  @     is_calendar(c) && has_times(c) && 0 <= position < c->heap_count &&
  @     0 <= slot < c->slots;
  @
  @ // The hole has moved, no slot is lost, the one to be put in is not in yet.
  @ predicate a_hole_moved{Old, New}(brink_calendar *c, integer before,
  @                                  integer hole, integer slot) =
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
  @ ensures entries: same_entries{Pre, Post}(c);
  @ ensures put: same_entries{Pre, Post}(c) ==>
  @     is_put(heap_of{Pre}(c), heap_of{Post}(c), position, slot);
  @ ensures moved: same_entries{Pre, Post}(c) ==> \forall integer from;
  @     0 <= from < c->heap_count && from != position &&
  @     \old(c->heap[from]) == slot ==>
  @     is_moved(heap_of{Pre}(c), heap_of{Post}(c), position, from);
  @*/
static void heap_put(brink_calendar *c, uint32_t position, uint32_t slot);
