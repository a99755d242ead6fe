// SPDX-License-Identifier: MIT
// with: -wp-prop @lemma
/**
 * What keeps the calendar's lists linked, apart from memory: a slot is added or
 * taken out, or a list is taken from its day and its slots let go one by one from
 * the first, which is `loose`, to be filed anew; slots that are not loose stay
 * linked all the while.  What happens to each link is calendar_lists_wp.c.
 */

// --- What lists are ------------------------------------------------------------

/*@ axiomatic Lists {
  @   type lists; // of slots, each in one list, -1 if it is in none
  @   logic integer slots(lists l);
  @   logic integer days(lists l);
  @   logic integer first(lists l, integer day);
  @   logic integer day(lists l, integer slot);
  @   logic integer next(lists l, integer slot);
  @   logic integer previous(lists l, integer slot);
  @ }
  @
  @ predicate is_slot(lists l, integer slot) = 0 <= slot < slots(l);
  @ predicate is_day(lists l, integer day) = 0 <= day <= days(l);
  @
  @ // The first of a day is of that day, and nobody is before it.
  @ predicate is_headed(lists l, integer loose) =
  @     \forall integer d; is_day(l, d) && first(l, d) != slots(l) ==>
  @         is_slot(l, first(l, d)) && first(l, d) != loose &&
  @         day(l, first(l, d)) == d && previous(l, first(l, d)) == slots(l);
  @
  @ // Whoever is in a list is the first of it, or the next of the one before.
  @ predicate is_linked_back(lists l, integer loose) =
  @     \forall integer s; is_slot(l, s) && s != loose && is_day(l, day(l, s)) ==>
  @         (previous(l, s) == slots(l)
  @             ? first(l, day(l, s)) == s
  @             : is_slot(l, previous(l, s)) && next(l, previous(l, s)) == s &&
  @                   day(l, previous(l, s)) == day(l, s));
  @
  @ // And the last of it, or the previous of the one after.
  @ predicate is_linked_on(lists l, integer loose) =
  @     \forall integer s; is_slot(l, s) && is_day(l, day(l, s)) &&
  @         next(l, s) != slots(l) ==>
  @         is_slot(l, next(l, s)) && next(l, s) != loose &&
  @         previous(l, next(l, s)) == s && day(l, next(l, s)) == day(l, s);
  @
  @ predicate is_linked(lists l, integer loose) =
  @     is_headed(l, loose) && is_linked_back(l, loose) &&
  @     is_linked_on(l, loose);
  @
  @ predicate same_size(lists a, lists b) =
  @     slots(a) == slots(b) && days(a) == days(b);
  @
  @ // A slot that was in no list has become the first of day d.
  @ predicate is_added(lists a, lists b, integer d, integer slot) =
  @     same_size(a, b) && first(b, d) == slot && day(b, slot) == d &&
  @     next(b, slot) == first(a, d) && previous(b, slot) == slots(a) &&
  @     (is_slot(a, first(a, d)) ==> previous(b, first(a, d)) == slot) &&
  @     (\forall integer e; is_day(a, e) && e != d ==>
  @         first(b, e) == first(a, e)) &&
  @     (\forall integer s; is_slot(a, s) && s != slot ==>
  @         day(b, s) == day(a, s)) &&
  @     (\forall integer s; is_slot(a, s) && s != slot ==>
  @         next(b, s) == next(a, s)) &&
  @     (\forall integer s; is_slot(a, s) && s != slot && s != first(a, d) ==>
  @         previous(b, s) == previous(a, s));
  @
  @ // It has been taken out of its list.
  @ predicate is_taken(lists a, lists b, integer slot) =
  @     same_size(a, b) && !is_day(b, day(b, slot)) &&
  @     (previous(a, slot) == slots(a)
  @         ? first(b, day(a, slot)) == next(a, slot)
  @         : next(b, previous(a, slot)) == next(a, slot) &&
  @               first(b, day(a, slot)) == first(a, day(a, slot))) &&
  @     (is_slot(a, next(a, slot)) ==>
  @         previous(b, next(a, slot)) == previous(a, slot)) &&
  @     (\forall integer e; is_day(a, e) && e != day(a, slot) ==>
  @         first(b, e) == first(a, e)) &&
  @     (\forall integer s; is_slot(a, s) && s != slot ==>
  @         day(b, s) == day(a, s)) &&
  @     (\forall integer s; is_slot(a, s) && s != slot &&
  @         s != previous(a, slot) ==> next(b, s) == next(a, s)) &&
  @     (\forall integer s; is_slot(a, s) && s != slot && s != next(a, slot) ==>
  @         previous(b, s) == previous(a, s));
  @
  @ // A day has no first any more: its slots are loose.
  @ predicate is_loosened(lists a, lists b, integer d) =
  @     same_size(a, b) && first(b, d) == slots(a) &&
  @     (\forall integer e; is_day(a, e) && e != d ==>
  @         first(b, e) == first(a, e)) &&
  @     (\forall integer s; is_slot(a, s) ==> day(b, s) == day(a, s)) &&
  @     (\forall integer s; is_slot(a, s) ==> next(b, s) == next(a, s)) &&
  @     (\forall integer s; is_slot(a, s) ==> previous(b, s) == previous(a, s));
  @
  @ // The first of the loose ones is nowhere: the next one is first.
  @ predicate is_let_go(lists a, lists b, integer slot) =
  @     same_size(a, b) && !is_day(b, day(b, slot)) &&
  @     (\forall integer d; is_day(a, d) ==> first(b, d) == first(a, d)) &&
  @     (\forall integer s; is_slot(a, s) && s != slot ==>
  @         day(b, s) == day(a, s)) &&
  @     (\forall integer s; is_slot(a, s) ==> next(b, s) == next(a, s)) &&
  @     (\forall integer s; is_slot(a, s) ==> previous(b, s) == previous(a, s));
  @*/

// --- What keeps them linked ----------------------------------------------------

/*@ lemma added_headed: \forall lists a, b, integer loose, d, slot;
  @     is_added(a, b, d, slot) && is_linked(a, loose) && is_slot(a, slot) &&
  @     is_day(a, d) && slot != loose && !is_day(a, day(a, slot)) ==>
  @     is_headed(b, loose);
  @ lemma added_linked_back: \forall lists a, b, integer loose, d, slot;
  @     is_added(a, b, d, slot) && is_linked(a, loose) && is_slot(a, slot) &&
  @     is_day(a, d) && slot != loose && !is_day(a, day(a, slot)) ==>
  @     is_linked_back(b, loose);
  @ lemma added_linked_on: \forall lists a, b, integer loose, d, slot;
  @     is_added(a, b, d, slot) && is_linked(a, loose) && is_slot(a, slot) &&
  @     is_day(a, d) && slot != loose && !is_day(a, day(a, slot)) ==>
  @     is_linked_on(b, loose);
  @ lemma taken_headed: \forall lists a, b, integer loose, slot;
  @     is_taken(a, b, slot) && is_linked(a, loose) && is_slot(a, slot) &&
  @     slot != loose && is_day(a, day(a, slot)) ==> is_headed(b, loose);
  @ lemma taken_linked_back: \forall lists a, b, integer loose, slot;
  @     is_taken(a, b, slot) && is_linked(a, loose) && is_slot(a, slot) &&
  @     slot != loose && is_day(a, day(a, slot)) ==> is_linked_back(b, loose);
  @ lemma taken_linked_on: \forall lists a, b, integer loose, slot;
  @     is_taken(a, b, slot) && is_linked(a, loose) && is_slot(a, slot) &&
  @     slot != loose && is_day(a, day(a, slot)) ==> is_linked_on(b, loose);
  @ lemma loosened_headed: \forall lists a, b, integer d;
  @     is_loosened(a, b, d) && is_linked(a, slots(a)) && is_day(a, d) ==>
  @     is_headed(b, first(a, d));
  @ lemma loosened_linked_back: \forall lists a, b, integer d;
  @     is_loosened(a, b, d) && is_linked(a, slots(a)) && is_day(a, d) ==>
  @     is_linked_back(b, first(a, d));
  @ lemma loosened_linked_on: \forall lists a, b, integer d;
  @     is_loosened(a, b, d) && is_linked(a, slots(a)) && is_day(a, d) ==>
  @     is_linked_on(b, first(a, d));
  @ lemma let_go: \forall lists a, b, integer slot;
  @     is_let_go(a, b, slot) && is_linked(a, slot) && is_slot(a, slot) &&
  @     is_day(a, day(a, slot)) ==> is_linked(b, next(a, slot));
  @*/
