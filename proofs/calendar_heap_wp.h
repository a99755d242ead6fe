// SPDX-License-Identifier: MIT
/**
 * A heap apart from memory, as the calendar's is one (calendar_wp.h), and what it
 * is to be in order but for a hole.  What follows is in calendar_moves_wp.h.
 */

// --- What a heap is ------------------------------------------------------------

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
  @     same_order(a, b) && at(b, position) == slot &&
  @     place(b, slot) == position &&
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
