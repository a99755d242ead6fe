// SPDX-License-Identifier: MIT
/**
 * What a heap is, apart from memory; a calendar in memory, what its functions may
 * touch, the one order of its entries; and the heap that a calendar has.
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
  @*/

// --- The calendar ---------------------------------------------------------------

/*@ predicate is_in_memory(brink_calendar *c) =
  @     \valid(c) && c->slots < 0x80000000 && c->heap_count <= c->slots &&
  @     c->days <= 0x40000000 &&
  @     \valid_read(c->entry + (0 .. c->slots - 1)) &&
  @     \valid(c->filed + (0 .. c->slots)) &&
  @     \valid(c->heap + (0 .. c->slots - 1)) &&
  @     \valid(c->first + (0 .. c->days)) &&
  @     \separated(c, c->entry + (0 .. c->slots - 1), c->filed + (0 .. c->slots),
  @                c->heap + (0 .. c->slots - 1), c->first + (0 .. c->days));
  @ predicate is_calendar(brink_calendar *c) =
  @     is_in_memory(c) &&
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
  @ // What heap_put leaves as it is, and what it changes.
  @ predicate same_fields{A, B}(brink_calendar *c) =
  @     \at(c->slots, A) == \at(c->slots, B) &&
  @     \at(c->heap_count, A) == \at(c->heap_count, B) &&
  @     \at(c->entry, A) == \at(c->entry, B) &&
  @     \at(c->filed, A) == \at(c->filed, B) &&
  @     \at(c->heap, A) == \at(c->heap, B);
  @ predicate same_entry{A, B}(brink_entry *e) =
  @     \at(e->when.epoch, A) == \at(e->when.epoch, B) &&
  @     \at(e->when.offset, A) == \at(e->when.offset, B) &&
  @     \at(e->kind, A) == \at(e->kind, B) &&
  @     \at(e->i, A) == \at(e->i, B) && \at(e->j, A) == \at(e->j, B);
  @ predicate same_entries{A, B}(brink_calendar *c) =
  @     \forall integer s; 0 <= s < \at(c->slots, A) ==>
  @         same_entry{A, B}(\at(&c->entry[s], A));
  @ predicate heap_is_put{A, B}(brink_calendar *c, integer position, integer slot) =
  @     \at(c->heap[position], B) == slot &&
  @     \forall integer p; 0 <= p < \at(c->slots, A) && p != position ==>
  @         \at(c->heap[p], B) == \at(c->heap[p], A);
  @ predicate place_is_put{A, B}(brink_calendar *c, integer position,
  @                              integer slot) =
  @     \at(c->filed[slot].place, B) == position &&
  @     \forall integer s; 0 <= s < \at(c->slots, A) && s != slot ==>
  @         \at(c->filed[s].place, B) == \at(c->filed[s].place, A);
  @
  @ // The heap that a calendar has in memory.
  @ axiomatic Calendar {
  @   logic heap heap_of{L}(brink_calendar *c)
  @       reads *c, c->heap[..], c->filed[..], c->entry[..];
  @ }
  @
  @ // A calendar whose hole was at `was` when its heap was `then`.
  @ predicate a_hole(brink_calendar *c, integer hole, integer slot, heap then,
  @                  integer was) =
  @     is_calendar(c) && has_hole(heap_of(c), hole, slot) &&
  @     has_become(then, heap_of(c), was, hole, -1);
  @*/
