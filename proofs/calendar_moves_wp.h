// SPDX-License-Identifier: MIT
/**
 * What follows for a heap when its hole moves, or is filled: what heap_settle is
 * proved by.  Each lemma is proved in calendar_heap_wp.c.
 */

/*@ lemma gone_up: \forall heap o, a, b, integer was, hole, up, slot;
  @     has_become(o, a, was, hole, -1) && above(up, hole) &&
  @     has_hole(a, hole, slot) && is_moved(a, b, hole, up) ==>
  @     has_become(o, b, was, up, -1) && has_hole(b, up, slot);
  @ lemma gone_down: \forall heap o, a, b, integer was, hole, down, slot;
  @     has_become(o, a, was, hole, -1) && above(hole, down) &&
  @     has_hole(a, hole, slot) && is_moved(a, b, hole, down) &&
  @     is_before_below(a, hole, at(a, down)) && before(a, at(a, down), slot) ==>
  @     has_become(o, b, was, down, -1) && has_hole(b, down, slot) &&
  @     is_after_above(b, down, slot);
  @ lemma left_is_alone: \forall heap h, integer hole, left;
  @     has_an_order(h) && is_indexed(h, hole) && 0 <= hole &&
  @     count(h) <= slots(h) && left == 2 * hole + 1 && left < count(h) &&
  @     count(h) <= left + 1 ==> is_before_below(h, hole, at(h, left));
  @ lemma left_is_first: \forall heap h, integer hole, left, right;
  @     has_an_order(h) && is_indexed(h, hole) && 0 <= hole &&
  @     left == 2 * hole + 1 && right == 2 * hole + 2 && right < count(h) &&
  @     !before(h, at(h, right), at(h, left)) ==>
  @     is_before_below(h, hole, at(h, left));
  @ lemma right_is_first: \forall heap h, integer hole, left, right;
  @     has_an_order(h) && is_indexed(h, hole) && 0 <= hole &&
  @     left == 2 * hole + 1 && right == 2 * hole + 2 && right < count(h) &&
  @     before(h, at(h, right), at(h, left)) ==>
  @     is_before_below(h, hole, at(h, right));
  @ lemma none_below: \forall heap h, integer hole, slot;
  @     has_hole(h, hole, slot) && count(h) <= 2 * hole + 1 ==>
  @     is_before_below(h, hole, slot);
  @ lemma before_both: \forall heap h, integer hole, down, slot;
  @     has_hole(h, hole, slot) && above(hole, down) && down < count(h) &&
  @     is_before_below(h, hole, at(h, down)) && !before(h, at(h, down), slot) ==>
  @     is_before_below(h, hole, slot);
  @ lemma filled_in_order: \forall heap a, b, integer hole, slot;
  @     has_hole(a, hole, slot) && is_put(a, b, hole, slot) &&
  @     is_after_above(a, hole, slot) && is_before_below(a, hole, slot) ==>
  @     is_ordered(b, -1);
  @ lemma filled: \forall heap o, a, b, integer was, hole, slot;
  @     has_become(o, a, was, hole, -1) && has_hole(a, hole, slot) &&
  @     is_put(a, b, hole, slot) ==>
  @     has_become(o, b, was, -1, slot) && is_indexed(b, -1) &&
  @     in_heap(b, -1, slot);
  @ lemma known{L}: \forall brink_calendar *c, integer hole, slot, p;
  @     has_hole(heap_of{L}(c), hole, slot) && 0 <= p < c->heap_count &&
  @     p != hole ==> c->heap[p] < c->slots;
  @*/
