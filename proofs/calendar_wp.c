// SPDX-License-Identifier: MIT
// with: -wp-fct brink_instant_compare,brink_entry_compare,earlier
// with: -wp-fct heap_put,parent_of,earlier_child,hole_up,hole_down,heap_settle
// with: -wp-fct list_add,the_root_is_the_earliest
/**
 * The calendar's heap and lists, as compiled.  The index is kept: the slot at a
 * position of the heap has that position for its place, so no slot is there
 * twice; and none gets lost: whatever was in the heap is in it afterwards, with
 * the slot that was put in.  So is the order: no slot of the heap is before the
 * one above it, and then none is before the root.  A slot that is put in a list
 * is its first, and whoever was first has it before itself.  Nothing outside the
 * calendar's own arrays is read or written, and every loop ends.
 */
#include "../sim/calendar.h"
#include "libm_wp.h"

// --- A heap, apart from memory --------------------------------------------------

/*@ axiomatic Heap {
  @   type heap; // of slots, each with a place, and an order among them
  @   logic integer slots(heap h);
  @   logic integer count(heap h);
  @   logic integer at(heap h, integer position);
  @   logic integer place(heap h, integer slot);
  @   predicate before(heap h, integer x, integer y);
  @ }
  @
  @ predicate has_an_order(heap h) =
  @     (\forall integer x, y; 0 <= x < slots(h) && 0 <= y < slots(h) &&
  @         before(h, x, y) ==> !before(h, y, x)) &&
  @     (\forall integer x, y, z; 0 <= x < slots(h) && 0 <= y < slots(h) &&
  @         0 <= z < slots(h) && !before(h, y, x) && !before(h, z, y) ==>
  @         !before(h, z, x));
  @
  @ // Position `up` is the one above p.
  @ predicate above(integer up, integer p) =
  @     0 <= up && (p == 2 * up + 1 || p == 2 * up + 2);
  @
  @ // The slots know their places, but for the position where there is a hole.
  @ predicate is_indexed(heap h, integer hole) =
  @     \forall integer p; 0 <= p < count(h) && p != hole ==>
  @         0 <= at(h, p) < slots(h) && place(h, at(h, p)) == p;
  @ predicate in_heap(heap h, integer hole, integer slot) =
  @     0 <= place(h, slot) < count(h) && place(h, slot) != hole &&
  @     at(h, place(h, slot)) == slot;
  @
  @ // No slot is before the one above it, nor across the hole.
  @ predicate is_ordered(heap h, integer hole) =
  @     (\forall integer up, p; above(up, p) && p < count(h) && p != hole &&
  @         up != hole ==> !before(h, at(h, p), at(h, up))) &&
  @     (\forall integer up, p; above(up, hole) && above(hole, p) &&
  @         p < count(h) ==> !before(h, at(h, p), at(h, up)));
  @
  @ predicate is_after_above(heap h, integer hole, integer slot) =
  @     \forall integer up; above(up, hole) ==> !before(h, slot, at(h, up));
  @ predicate is_before_below(heap h, integer hole, integer slot) =
  @     \forall integer p; above(hole, p) && p < count(h) ==>
  @         !before(h, at(h, p), slot);
  @
  @ // There is a hole, which the slot has yet to be put in.
  @ predicate has_hole(heap h, integer hole, integer slot) =
  @     0 <= hole < count(h) <= slots(h) && 0 <= slot < slots(h) &&
  @     has_an_order(h) && is_indexed(h, hole) && is_ordered(h, hole) &&
  @     !in_heap(h, hole, slot);
  @
  @ predicate same_order(heap a, heap b) =
  @     slots(a) == slots(b) && count(a) == count(b) &&
  @     \forall integer x, y; 0 <= x < slots(a) && 0 <= y < slots(a) ==>
  @         (before(a, x, y) <==> before(b, x, y));
  @
  @ predicate is_put(heap a, heap b, integer position, integer slot) =
  @     same_order(a, b) && at(b, position) == slot && place(b, slot) == position &&
  @     (\forall integer p; 0 <= p < slots(a) && p != position ==>
  @         at(b, p) == at(a, p)) &&
  @     (\forall integer s; 0 <= s < slots(a) && s != slot ==>
  @         place(b, s) == place(a, s));
  @ predicate is_moved(heap a, heap b, integer hole, integer from) =
  @     0 <= from < count(a) && from != hole && is_put(a, b, hole, at(a, from));
  @
  @ // No slot of the heap is lost, none has come, and no other has another place.
  @ predicate none_lost(heap a, heap b, integer was, integer hole, integer but) =
  @     \forall integer s; 0 <= s < slots(a) && s != but ==>
  @         (in_heap(a, was, s)
  @              ? in_heap(b, hole, s)
  @              : !in_heap(b, hole, s) && place(b, s) == place(a, s));
  @
  @ // From a to b, and what has been so all the time.
  @ predicate has_become(heap a, heap b, integer was, integer hole, integer but) =
  @     same_order(a, b) && none_lost(a, b, was, hole, but);
  @
  @ lemma index_kept: \forall heap a, b, integer hole, from, slot;
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

// --- The calendar ---------------------------------------------------------------

/*@ predicate is_calendar(brink_calendar *c) =
  @     \valid(c) && c->slots < 0x80000000 && c->heap_count <= c->slots &&
  @     c->days <= 0x40000000 &&
  @     \valid_read(c->entry + (0 .. c->slots - 1)) &&
  @     \valid(c->filed + (0 .. c->slots)) &&
  @     \valid(c->heap + (0 .. c->slots - 1)) &&
  @     \valid(c->first + (0 .. c->days)) &&
  @     \separated(c, c->entry + (0 .. c->slots - 1), c->filed + (0 .. c->slots),
  @                c->heap + (0 .. c->slots - 1), c->first + (0 .. c->days)) &&
  @     \forall integer s; 0 <= s < c->slots ==>
  @         \is_finite(c->entry[s].when.offset);
  @
  @ // The one order: time, kind, i, j; then slot.
  @ predicate instant_before(brink_instant a, brink_instant b) =
  @     a.epoch < b.epoch || (a.epoch == b.epoch && a.offset < b.offset);
  @ predicate sooner(brink_entry *a, brink_entry *b) =
  @     a->when.epoch < b->when.epoch ||
  @     (a->when.epoch == b->when.epoch &&
  @      (a->when.offset < b->when.offset ||
  @       (a->when.offset == b->when.offset &&
  @        (a->kind < b->kind ||
  @         (a->kind == b->kind &&
  @          (a->i < b->i || (a->i == b->i && a->j < b->j)))))));
  @ predicate comes_first(brink_calendar *c, integer x, integer y) =
  @     sooner(&c->entry[x], &c->entry[y]) ||
  @     (!sooner(&c->entry[y], &c->entry[x]) && x < y);
  @
  @ lemma not_both{L}: \forall brink_calendar *c, integer x, y;
  @     comes_first(c, x, y) ==> !comes_first(c, y, x);
  @ lemma transitive{L}: \forall brink_calendar *c, integer x, y, z;
  @     !comes_first(c, y, x) && !comes_first(c, z, y) ==> !comes_first(c, z, x);
  @
  @ // The heap that a calendar has in memory: these say all of it.
  @ axiomatic Calendar {
  @   logic heap heap_of{L}(brink_calendar *c)
  @       reads *c, c->heap[..], c->filed[..], c->entry[..];
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
  @ // A calendar whose hole was at `was` when its heap was `then`.
  @ predicate a_hole(brink_calendar *c, integer hole, integer slot, heap then,
  @                  integer was) =
  @     is_calendar(c) && has_hole(heap_of(c), hole, slot) &&
  @     has_become(then, heap_of(c), was, hole, -1);
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

/*@ requires \is_finite(a.offset) && \is_finite(b.offset);
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures -1 <= \result <= 1;
  @ ensures \result == -1 <==> instant_before(a, b);
  @ ensures \result == 1 <==> instant_before(b, a);
  @*/
static inline int brink_instant_compare(brink_instant a, brink_instant b);

/*@ requires \valid_read(a) && \valid_read(b);
  @ requires \is_finite(a->when.offset) && \is_finite(b->when.offset);
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures -1 <= \result <= 1;
  @ ensures earlier: \result == -1 <==> sooner(a, b);
  @ ensures later: \result == 1 <==> sooner(b, a);
  @*/
int brink_entry_compare(const brink_entry *a, const brink_entry *b);

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
