// SPDX-License-Identifier: MIT
/**
 * What is kept of the calendar.  The heap and the places of its slots are each
 * other's inverse; the lists are linked both ways, begin with the first of their
 * day, and do not run in a circle; each slot is where the time of its entry says.
 */

/*@ predicate is_placed(view v) =
  @     \forall integer s; is_slot(v, s) ==> filed_at(v, s) < days(v) &&
  @         (filed_at(v, s) == -1 ==> in_heap(v, s));
  @
  @ // The first of a day is in its list, and nobody is before it.
  @ predicate is_headed(view v) =
  @     \forall integer d; is_day(v, d) && first(v, d) != slots(v) ==>
  @         is_slot(v, first(v, d)) && filed_at(v, first(v, d)) == d &&
  @         previous(v, first(v, d)) == slots(v);
  @ // Whoever is in a list is its first, or the next of the one before.
  @ predicate is_linked_back(view v) =
  @     \forall integer s; is_slot(v, s) && filed_at(v, s) >= 0 ==>
  @         (previous(v, s) == slots(v)
  @             ? first(v, filed_at(v, s)) == s
  @             : is_slot(v, previous(v, s)) && next(v, previous(v, s)) == s &&
  @                   filed_at(v, previous(v, s)) == filed_at(v, s));
  @ // And its last, or the previous of the one after.
  @ predicate is_linked_on(view v) =
  @     \forall integer s; is_slot(v, s) && filed_at(v, s) >= 0 &&
  @         next(v, s) != slots(v) ==>
  @         is_slot(v, next(v, s)) && previous(v, next(v, s)) == s &&
  @         filed_at(v, next(v, s)) == filed_at(v, s);
  @
  @ // The slots can be numbered so that the numbers fall along a list.
  @ axiomatic Numbering {
  @   type numbering;
  @   logic integer number(numbering n, integer slot);
  @   logic numbering with(numbering n, integer slot, integer number);
  @   axiom here: \forall numbering n, integer s, k; number(with(n, s, k),
  @     s) == k;
  @   axiom elsewhere: \forall numbering n, integer s, t, k;
  @       t != s ==> number(with(n, s, k), t) == number(n, t);
  @ }
  @ predicate falls(view v, numbering n) =
  @     \forall integer s; is_slot(v, s) && filed_at(v, s) >= 0 &&
  @         next(v, s) != slots(v) ==> number(n, next(v, s)) < number(n, s);
  @ predicate has_no_circle(view v) = \exists numbering n; falls(v, n);
  @
  @ predicate is_sized(view v) =
  @     0 <= count(v) <= slots(v) < 0x80000000 && 0 <= days(v) <= 0x40000000;
  @ predicate is_linked(view v) =
  @     is_headed(v) && is_linked_back(v) && is_linked_on(v);
  @ predicate is_sound(view v) =
  @     is_sized(v) && is_indexed(v) && is_placed(v) && is_linked(v) &&
  @     has_no_circle(v);
  @*/

// --- By time -------------------------------------------------------------------

/*@ predicate is_filed(view v, integer slot) =
  @     filed_at(v, slot) == filed_for(v, slot);
  @ predicate is_dated(view v) =
  @     is_day(v, today(v)) && epoch(v) < 0x7FFFFFFFFFFFFFFF;
  @
  @ predicate are_all_filed(view v) =
  @     \forall integer s; is_slot(v, s) ==> is_filed(v, s);
  @ // All but some of the slots, which are nowhere.
  @ predicate are_filed(view v, integer from, integer end) =
  @     is_sound(v) && is_dated(v) && \forall integer s; is_slot(v, s) ==>
  @         has_a_time(v, s) &&
  @         (from <= s < end ? filed_at(v, s) == -2 : is_filed(v, s));
  @ // All, but those of a day that has come may still be in its list.
  @ predicate are_filed_but_for(view v, integer day) =
  @     is_sound(v) && is_dated(v) && \forall integer s; is_slot(v, s) ==>
  @         has_a_time(v, s) &&
  @         (is_filed(v, s) || filed_at(v, s) == day && filed_for(v, s) == -1);
  @*/

// --- From one state to the next ------------------------------------------------

/*@ predicate same_filing(view a, view b, integer but) =
  @     \forall integer s; is_slot(a, s) && s != but ==>
  @         filed_at(b, s) == filed_at(a, s);
  @ predicate is_out(view a, view b, integer slot) =
  @     same_calendar(a, b) && same_filing(a, b, slot) &&
  @     filed_at(b, slot) == -2 &&
  @     count(b) == count(a) - (filed_at(a, slot) == -1 ? 1 : 0);
  @ predicate is_in(view a, view b, integer slot) =
  @     same_calendar(a, b) && same_filing(a, b, slot) &&
  @     filed_at(b, slot) == filed_for(a, slot) &&
  @     count(b) == count(a) + (filed_for(a, slot) == -1 ? 1 : 0);
  @*/
