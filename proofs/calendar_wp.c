// SPDX-License-Identifier: MIT
// with: -wp-fct parent_of,earlier_child,hole_up,hole_down,heap_settle
// with: -wp-fct the_root_is_the_earliest
/**
 * The calendar's heap and lists, as compiled.  The index is kept: the slot at a
 * position of the heap has that position for its place, so no slot is there
 * twice; and none gets lost: whatever was in the heap is in it afterwards, with
 * the slot that was put in.  So is the order: no slot of the heap is before the
 * one above it, and then none is before the root.  A slot that is put in a list
 * is its first, and whoever was first has it before itself.  Nothing outside the
 * calendar's own arrays is read or written, and every loop ends.
 */
#include "calendar_wp.h"

/*@ lemma index_kept: \forall heap a, b, integer hole, from, slot;
  @     has_hole(a, hole, slot) && is_moved(a, b, hole, from) ==>
  @     is_indexed(b, from) && !in_heap(b, from, slot);
  @ lemma none_is_lost: \forall heap a, b, integer hole, from, slot;
  @     has_hole(a, hole, slot) && is_moved(a, b, hole, from) ==>
  @     has_become(a, b, hole, from, -1);
  @ lemma nor_in_two_steps: \forall heap a, b, c, integer was, hole, now, but;
  @     has_become(a, b, was, hole, -1) && has_become(b, c, hole, now, but) ==>
  @     has_become(a, c, was, now, but);
  @ lemma order_upward: \forall heap a, b, integer hole, up, slot;
  @     above(up, hole) && has_hole(a, hole, slot) && is_moved(a, b, hole, up) ==>
  @     is_ordered(b, up);
  @ lemma order_downward: \forall heap a, b, integer hole, down, slot;
  @     above(hole, down) && has_hole(a, hole, slot) &&
  @     is_moved(a, b, hole, down) && is_before_below(a, hole, at(a, down)) ==>
  @     is_ordered(b, down);
  @ lemma moved_upward: \forall heap a, b, integer hole, up, slot;
  @     above(up, hole) && has_hole(a, hole, slot) && is_moved(a, b, hole, up) ==>
  @     has_hole(b, up, slot);
  @ lemma moved_downward: \forall heap a, b, integer hole, down, slot;
  @     above(hole, down) && has_hole(a, hole, slot) &&
  @     is_moved(a, b, hole, down) && is_before_below(a, hole, at(a, down)) ==>
  @     has_hole(b, down, slot);
  @ lemma after_what_moved: \forall heap a, b, integer hole, down, slot;
  @     above(hole, down) && has_hole(a, hole, slot) &&
  @     is_moved(a, b, hole, down) && before(a, at(a, down), slot) ==>
  @     is_after_above(b, down, slot);
  @ lemma before_both: \forall heap h, integer hole, down, slot;
  @     has_hole(h, hole, slot) && above(hole, down) && down < count(h) &&
  @     is_before_below(h, hole, at(h, down)) && !before(h, at(h, down), slot) ==>
  @     is_before_below(h, hole, slot);
  @ lemma filled: \forall heap a, b, integer hole, slot;
  @     has_hole(a, hole, slot) && is_put(a, b, hole, slot) ==>
  @     is_indexed(b, -1) && in_heap(b, -1, slot) &&
  @     has_become(a, b, hole, -1, slot);
  @ lemma filled_in_order: \forall heap a, b, integer hole, slot;
  @     has_hole(a, hole, slot) && is_put(a, b, hole, slot) &&
  @     is_after_above(a, hole, slot) && is_before_below(a, hole, slot) ==>
  @     is_ordered(b, -1);
  @*/

/*@ lemma not_both{L}: \forall brink_calendar *c, integer x, y;
  @     comes_first(c, x, y) ==> !comes_first(c, y, x);
  @ lemma transitive{L}: \forall brink_calendar *c, integer x, y, z;
  @     !comes_first(c, y, x) && !comes_first(c, z, y) ==> !comes_first(c, z, x);
  @
  @ // The heap that a calendar has: these say all of it.
  @ axiomatic HeapInMemory {
  @   axiom its_slots{L}: \forall brink_calendar *c; slots(heap_of(c)) == c->slots;
  @   axiom its_count{L}: \forall brink_calendar *c;
  @       count(heap_of(c)) == c->heap_count;
  @   axiom its_heap{L}: \forall brink_calendar *c, integer p; 0 <= p < c->slots ==>
  @       at(heap_of(c), p) == c->heap[p];
  @   axiom its_places{L}: \forall brink_calendar *c, integer s;
  @       0 <= s < c->slots ==> place(heap_of(c), s) == c->filed[s].place;
  @   axiom its_order{L}: \forall brink_calendar *c, integer x, y;
  @       before(heap_of(c), x, y) <==> comes_first(c, x, y);
  @ }
  @
  @ lemma order_in_memory{A, B}: \forall brink_calendar *c;
  @     same_fields{A, B}(c) && same_entries{A, B}(c) ==>
  @     same_order(\at(heap_of(c), A), \at(heap_of(c), B));
  @ lemma put_in_memory{A, B}: \forall brink_calendar *c, integer position, slot;
  @     0 <= position < \at(c->slots, A) && 0 <= slot < \at(c->slots, A) &&
  @     same_fields{A, B}(c) &&
  @     same_order(\at(heap_of(c), A), \at(heap_of(c), B)) &&
  @     heap_is_put{A, B}(c, position, slot) &&
  @     place_is_put{A, B}(c, position, slot) ==>
  @     is_put(\at(heap_of(c), A), \at(heap_of(c), B), position, slot);
  @
  @ // What the heap's clauses say where its slots are read from memory.
  @ lemma index_in_memory{L}: \forall brink_calendar *c, integer hole, p;
  @     is_calendar(c) && is_indexed(heap_of(c), hole) && p != hole &&
  @     0 <= p < c->heap_count ==>
  @     at(heap_of(c), p) == c->heap[p] && c->heap[p] < c->slots;
  @ lemma after_its_parent{L}: \forall brink_calendar *c, integer up, p, slot;
  @     is_calendar(c) && above(up, p) && p < c->heap_count &&
  @     !before(heap_of(c), slot, c->heap[up]) ==>
  @     is_after_above(heap_of(c), p, slot);
  @ lemma an_order{L}: \forall brink_calendar *c; has_an_order(heap_of(c));
  @*/

/*@ requires is_calendar(c);
  @ requires a < c->slots && b < c->slots;
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \result == 0 || \result == 1;
  @ ensures order: \result == 1 <==> before(heap_of(c), a, b);
  @*/
static int earlier(const brink_calendar *c, uint32_t a, uint32_t b);

/*@ requires is_calendar(c);
  @ requires position < c->slots && slot < c->slots;
  @ terminates \true;
  @ exits \false;
  @ assigns c->heap[position], c->filed[slot].place;
  @ ensures whole: is_calendar(c);
  @ ensures done: is_put(\old(heap_of(c)), heap_of(c), position, slot);
  @ ensures moved: \forall integer from; 0 <= from < c->heap_count &&
  @     from != position && \old(c->heap[from]) == slot ==>
  @     is_moved(\old(heap_of(c)), heap_of(c), position, from);
  @*/
static void heap_put(brink_calendar *c, uint32_t position, uint32_t slot);

/*@ requires position > 0;
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures above(\result, position);
  @*/
static uint32_t parent_of(uint32_t position);

/*@ requires is_calendar(c) && is_indexed(heap_of(c), position);
  @ requires 2 * position + 1 < c->heap_count;
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures above(position, \result) && \result < c->heap_count;
  @ ensures is_before_below(heap_of(c), position, at(heap_of(c), \result));
  @*/
static uint32_t earlier_child(const brink_calendar *c, uint32_t position);

/*@ requires is_calendar(c) && has_hole(heap_of(c), position, slot);
  @ terminates \true;
  @ exits \false;
  @ assigns c->heap[0 .. c->heap_count - 1], c->filed[0 .. c->slots - 1].place;
  @ ensures hole: a_hole(c, \result, slot, \old(heap_of(c)), \old(position));
  @ ensures above: is_after_above(heap_of(c), \result, slot);
  @*/
static uint32_t hole_up(brink_calendar *c, uint32_t position, uint32_t slot);

/*@ requires is_calendar(c) && has_hole(heap_of(c), position, slot);
  @ requires is_after_above(heap_of(c), position, slot);
  @ terminates \true;
  @ exits \false;
  @ assigns c->heap[0 .. c->heap_count - 1], c->filed[0 .. c->slots - 1].place;
  @ ensures hole: a_hole(c, \result, slot, \old(heap_of(c)), \old(position));
  @ ensures above: is_after_above(heap_of(c), \result, slot);
  @ ensures below: is_before_below(heap_of(c), \result, slot);
  @*/
static uint32_t hole_down(brink_calendar *c, uint32_t position, uint32_t slot);

/*@ requires is_calendar(c) && has_hole(heap_of(c), position, slot);
  @ terminates \true;
  @ exits \false;
  @ assigns c->heap[0 .. c->heap_count - 1], c->filed[0 .. c->slots - 1].place;
  @ ensures whole: is_calendar(c);
  @ ensures index: is_indexed(heap_of(c), -1);
  @ ensures order: is_ordered(heap_of(c), -1);
  @ ensures put_in: in_heap(heap_of(c), -1, slot);
  @ ensures none_lost:
  @     has_become(\old(heap_of(c)), heap_of(c), \old(position), -1, slot);
  @*/
static void heap_settle(brink_calendar *c, uint32_t position, uint32_t slot);

#include "../sim/calendar.c"

// --- The order, for all the heap -----------------------------------------------

/*@ requires is_calendar(c);
  @ requires is_indexed(heap_of(c), -1) && is_ordered(heap_of(c), -1);
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \forall integer p; 0 <= p < c->heap_count ==>
  @     !before(heap_of(c), c->heap[p], c->heap[0]);
  @*/
void the_root_is_the_earliest(const brink_calendar *c)
{
    /*@ loop invariant 0 <= n <= c->heap_count;
      @ loop invariant \forall integer p; 0 <= p < n ==>
      @     !before(heap_of(c), at(heap_of(c), p), at(heap_of(c), 0));
      @ loop assigns n;
      @ loop variant c->heap_count - n; */
    for (uint32_t n = 0; n < c->heap_count; n++) {
        //@ assert n > 0 ==> above((n - 1) / 2, n);
    }
}
