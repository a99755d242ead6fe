// SPDX-License-Identifier: MIT
// with: -wp-prop @lemma -wp-model Typed+real
/**
 * What the calendar's heap_settle does to a heap, apart from memory: a hole moves
 * up or down, and is filled.  The slots know their places, and none is lost; and
 * no slot is before the one above it, if that was so but for the hole.  And that
 * the order of the calendar's slots is one.  Each lemma is proved of those before
 * it.
 */
#include "calendar_wp.h"

#include "calendar_order_wp.h"

// --- The order is kept where the entries are -----------------------------------

/*@ lemma entries_kept{A, B}: \forall brink_entry *a, *b, *c, *d;
  @     same_entry{A, B}(a, c) && same_entry{A, B}(b, d) ==>
  @     (entry_before{A}(a, b) <==> entry_before{B}(c, d));
  @ lemma slots_kept{A, B}: \forall brink_calendar *c, integer x, y;
  @     same_entries{A, B}(c) && 0 <= x < \at(c->slots, A) &&
  @     0 <= y < \at(c->slots, A) ==>
  @     (slot_before{A}(c, x, y) <==> slot_before{B}(c, x, y));
  @ lemma order_kept{A, B}: \forall brink_calendar *c, integer x, y;
  @     same_entries{A, B}(c) && 0 <= x < \at(c->slots, A) &&
  @     0 <= y < \at(c->slots, A) ==>
  @     (before(heap_of{A}(c), x, y) <==> before(heap_of{B}(c), x, y));
  @*/

#include "calendar_kept_wp.h"

// --- The order of entries, and of slots ----------------------------------------

/*@ lemma one_way: \forall brink_instant a, b;
  @     instant_before(a, b) ==> !instant_before(b, a);
  @ lemma onward: \forall brink_instant a, b, c;
  @     !instant_before(b, a) && !instant_before(c, b) ==> !instant_before(c, a);
  @ lemma kinds_one_way{L}: \forall brink_entry *a, *b;
  @     kind_before(a, b) ==> !kind_before(b, a);
  @ lemma kinds_onward{L}: \forall brink_entry *a, *b, *c;
  @     !kind_before(b, a) && !kind_before(c, b) ==> !kind_before(c, a);
  @ lemma entries_one_way{L}: \forall brink_entry *a, *b;
  @     entry_before(a, b) ==> !entry_before(b, a);
  @ lemma entries_onward{L}: \forall brink_entry *a, *b, *c;
  @     !entry_before(b, a) && !entry_before(c, b) ==> !entry_before(c, a);
  @ lemma slots_one_way{L}: \forall brink_calendar *c, integer x, y;
  @     slot_before(c, x, y) ==> !slot_before(c, y, x);
  @ lemma slots_onward{L}: \forall brink_calendar *c, integer x, y, z;
  @     !slot_before(c, y, x) && !slot_before(c, z, y) ==> !slot_before(c, z, x);
  @ lemma one_is_before{L}: \forall brink_calendar *c, integer x, y;
  @     x == y || slot_before(c, x, y) || slot_before(c, y, x);
  @ lemma in_order{L}: \forall brink_calendar *c; has_an_order(heap_of{L}(c));
  @*/

// --- What follows when its hole moves, or is filled ----------------------------

/*@ lemma same_order_kept: \forall heap a, b;
  @     has_an_order(a) && same_order(a, b) ==> has_an_order(b);
  @ lemma one_above: \forall integer x, y, p;
  @     above(x, p) && above(y, p) ==> x == y;
  @ lemma none_twice: \forall heap h, integer hole, p, q;
  @     is_indexed(h, hole) && 0 <= p < count(h) && 0 <= q < count(h) &&
  @     p != hole && q != hole && at(h, p) == at(h, q) ==> p == q;
  @ lemma index_kept: \forall heap a, b, integer hole, from, slot;
  @     has_hole(a, hole, slot) && is_moved(a, b, hole, from) ==>
  @     is_indexed(b, from) && !in_heap(b, from, slot);
  @ lemma none_is_lost: \forall heap a, b, integer hole, from, slot;
  @     has_hole(a, hole, slot) && is_moved(a, b, hole, from) ==>
  @     has_become(a, b, hole, from, -1);
  @ lemma nor_in_two_steps: \forall heap a, b, c, integer was, hole, now, but;
  @     has_become(a, b, was, hole, -1) && has_become(b, c, hole, now, but) ==>
  @     has_become(a, c, was, now, but);
  @ lemma no_order_is_lost: \forall heap a, b, integer hole, from, x, y;
  @     is_moved(a, b, hole, from) && hole < count(a) <= slots(a) &&
  @     is_indexed(a, hole) && 0 <= x < count(a) && 0 <= y < count(a) &&
  @     x != hole && y != hole && !before(a, at(a, x), at(a, y)) ==>
  @     !before(b, at(b, x), at(b, y));
  @ lemma order_upward: \forall heap a, b, integer hole, up, slot;
  @     above(up, hole) && has_hole(a, hole, slot) && is_moved(a, b, hole, up) ==>
  @     is_ordered(b, up);
  @ lemma order_downward_elsewhere: \forall heap a, b,
  @     integer hole, down, slot, up, p;
  @     above(hole, down) && has_hole(a, hole, slot) &&
  @     is_moved(a, b, hole, down) && is_before_below(a, hole, at(a, down)) &&
  @     above(up, p) && p < count(b) && p != down && up != down ==>
  @     !before(b, at(b, p), at(b, up));
  @ lemma order_downward_across: \forall heap a, b, integer hole, down, slot, p;
  @     above(hole, down) && has_hole(a, hole, slot) &&
  @     is_moved(a, b, hole, down) && above(down, p) && p < count(b) ==>
  @     !before(b, at(b, p), at(b, hole));
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
  @ lemma filled_index: \forall heap a, b, integer hole, slot;
  @     has_hole(a, hole, slot) && is_put(a, b, hole, slot) ==> is_indexed(b, -1);
  @ lemma filled_in: \forall heap a, b, integer hole, slot;
  @     has_hole(a, hole, slot) && is_put(a, b, hole, slot) ==>
  @     in_heap(b, -1, slot);
  @ lemma filled_none_lost: \forall heap a, b, integer hole, slot;
  @     has_hole(a, hole, slot) && is_put(a, b, hole, slot) ==>
  @     has_become(a, b, hole, -1, slot);
  @*/

#include "calendar_moves_wp.h"

// --- And of the order ----------------------------------------------------------

/*@ lemma root_is_first: \forall heap h, integer p;
  @     has_an_order(h) && is_indexed(h, -1) && is_ordered(h, -1) &&
  @     count(h) <= slots(h) && 0 < p < count(h) &&
  @     !before(h, at(h, (p - 1) / 2), at(h, 0)) ==>
  @     !before(h, at(h, p), at(h, 0));
  @*/
