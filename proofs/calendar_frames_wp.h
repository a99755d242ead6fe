// SPDX-License-Identifier: MIT
/**
 * What stays as it was when the calendar changes, and what its heap is.
 */

/*@ predicate same_times(view a, view b, integer but) =
  @     \forall integer s; is_slot(a, s) && s != but ==>
  @         epoch_of(b, s) == epoch_of(a, s) && day_for(b, s) == day_for(a, s) &&
  @         (has_a_time(b, s) <==> has_a_time(a, s));
  @ predicate same_heap(view a, view b) =
  @     count(b) == count(a) &&
  @     \forall integer p; 0 <= p < count(a) ==> at(b, p) == at(a, p);
  @ predicate same_firsts(view a, view b, integer but) =
  @     \forall integer d; is_day(a, d) && d != but ==>
  @     first(b, d) == first(a, d);
  @ predicate same_places(view a, view b, integer but) =
  @     \forall integer s; is_slot(a, s) && s != but ==>
  @         place(b, s) == place(a, s);
  @ predicate same_nexts(view a, view b, integer but) =
  @     \forall integer s; is_slot(a, s) && s != but ==> next(b, s) == next(a, s);
  @ predicate same_previous(view a, view b, integer x, integer y) =
  @     \forall integer s; is_slot(a, s) && s != x && s != y ==>
  @         previous(b, s) == previous(a, s);
  @ predicate same_lists(view a, view b) =
  @     same_firsts(a, b, -1) && same_nexts(a, b, -1) &&
  @     same_previous(a, b, -1, -1);
  @*/

// --- The heap ------------------------------------------------------------------

/*@ predicate is_indexed(view v) =
  @     \forall integer p; 0 <= p < count(v) ==>
  @         is_slot(v, at(v, p)) && place(v, at(v, p)) == p;
  @ predicate in_heap(view v, integer slot) =
  @     0 <= place(v, slot) < count(v) && at(v, place(v, slot)) == slot;
  @ predicate none_lost(view a, view b, integer but) =
  @     \forall integer s; is_slot(a, s) && s != but ==>
  @         (in_heap(a, s) ? in_heap(b, s)
  @                        : !in_heap(b, s) && place(b, s) == place(a, s));
  @*/
