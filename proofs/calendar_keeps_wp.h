// SPDX-License-Identifier: MIT
/**
 * What follows for the calendar from its steps, and from what is kept of it: what
 * its functions are proved by.  Each lemma is proved in calendar_links_wp.c.
 */

// --- What is known of a calendar that is sound ---------------------------------

/*@ lemma its_heap: \forall view v, integer slot; is_sound(v) ==>
  @     is_indexed(v) && (is_slot(v, slot) && filed_at(v, slot) == -1 ==>
  @         in_heap(v, slot));
  @ lemma its_lists: \forall view v, integer slot;
  @     is_sound(v) && is_slot(v, slot) && filed_at(v, slot) >= 0 ==>
  @     is_day(v, filed_at(v, slot)) && 0 <= previous(v, slot) <= slots(v) &&
  @     0 <= next(v, slot) <= slots(v);
  @ lemma its_firsts: \forall view v, integer d; is_sound(v) && is_day(v, d) ==>
  @     0 <= first(v, d) <= slots(v) &&
  @     (first(v, d) != slots(v) ==> filed_at(v, first(v, d)) == d);
  @ lemma its_date: \forall view v; is_dated(v) ==>
  @     is_day(v, today(v)) && epoch(v) < 0x7FFFFFFFFFFFFFFF;
  @*/

// --- Slots are taken out, and put in where their time says ---------------------

/*@ lemma out_of_the_heap: \forall view a, b, integer slot;
  @     is_sound(a) && is_slot(a, slot) && filed_at(a, slot) == -1 &&
  @     is_put_out(a, b, slot) ==> is_sound(b) && is_out(a, b, slot);
  @ lemma out_of_a_list: \forall view a, b, integer slot;
  @     is_sound(a) && is_slot(a, slot) && filed_at(a, slot) >= 0 &&
  @     is_removed(a, b, slot) ==> is_sound(b) && is_out(a, b, slot);
  @ lemma out_already: \forall view a, integer slot;
  @     is_slot(a, slot) && filed_at(a, slot) == -2 ==> is_out(a, a, slot);
  @ lemma into_the_heap: \forall view a, b, integer slot;
  @     is_sound(a) && is_slot(a, slot) && filed_at(a, slot) == -2 &&
  @     is_put_in(a, b, slot) && filed_for(a, slot) == -1 ==>
  @     is_sound(b) && is_in(a, b, slot);
  @ lemma into_a_list: \forall view a, b, integer d, slot;
  @     is_sound(a) && is_slot(a, slot) && filed_at(a, slot) == -2 &&
  @     is_day(a, d) && is_added(a, b, d, slot) && filed_for(a, slot) == d ==>
  @     is_sound(b) && is_in(a, b, slot);
  @ lemma not_in_yet: \forall view a, integer slot;
  @     is_slot(a, slot) && filed_at(a, slot) == -2 &&
  @     filed_for(a, slot) == -2 ==> is_in(a, a, slot);
  @ lemma out: \forall view a, b, integer slot;
  @     is_out(a, b, slot) && is_slot(a, slot) ==>
  @     filed_at(b, slot) == -2 && slots(b) == slots(a) && days(b) == days(a) &&
  @     today(b) == today(a) &&
  @     filed_for(b, slot) == filed_for(a, slot) &&
  @     (filed_at(a, slot) >= 0 ==> count(b) == count(a));
  @ lemma in: \forall view a, b, integer slot; is_in(a, b, slot) ==>
  @     slots(b) == slots(a) && days(b) == days(a) && today(b) == today(a) &&
  @     count(b) == count(a) + (filed_for(a, slot) == -1 ? 1 : 0);
  @*/

// --- All slots -----------------------------------------------------------------

/*@ lemma those_filed: \forall view v, integer from, end;
  @     are_filed(v, from, end) ==> is_sound(v) && is_dated(v);
  @ lemma those_nowhere: \forall view v, integer from, end;
  @     are_filed(v, from, end) && is_slot(v, from) && from < end ==>
  @     filed_at(v, from) == -2 && has_a_time(v, from);
  @ lemma one_given: \forall view a, b, c, integer slot;
  @     are_filed(a, 0, 0) && is_slot(a, slot) && is_out(a, b, slot) &&
  @     is_sound(b) && is_given(b, c, slot) && has_a_time(c, slot) ==>
  @     are_filed(c, slot, slot + 1);
  @ lemma one_filed: \forall view a, b, integer slot, end;
  @     are_filed(a, slot, end) && slot < end && is_slot(a, slot) &&
  @     is_in(a, b, slot) && is_sound(b) ==> are_filed(b, slot + 1, end);
  @ lemma the_one_filed: \forall view a, b, integer slot;
  @     are_filed(a, slot, slot + 1) && is_slot(a, slot) && is_in(a, b, slot) &&
  @     is_sound(b) ==> are_filed(b, 0, 0);
  @ lemma all_filed: \forall view v, integer end;
  @     are_filed(v, end, end) ==> are_filed(v, 0, 0);
  @ lemma none_excepted: \forall view v; are_filed(v, 0, 0) ==> are_all_filed(v);
  @ lemma is_due: \forall view v;
  @     is_sound(v) && count(v) > 0 && are_all_filed(v) ==>
  @     is_slot(v, at(v, 0)) && filed_at(v, at(v, 0)) == -1 &&
  @     epoch_of(v, at(v, 0)) <= epoch(v);
  @*/

// --- Another day, another year -------------------------------------------------

/*@ lemma next_day: \forall view a, b;
  @     are_filed(a, 0, 0) && is_turned(a, b) && epoch(b) == epoch(a) &&
  @     today(b) == today(a) + 1 && today(b) < days(b) ==>
  @     are_filed_but_for(b, today(b));
  @ lemma some_of_it_left: \forall view v, integer d;
  @     are_filed_but_for(v, d) ==> is_sound(v) && is_dated(v);
  @ lemma one_of_it: \forall view v, integer slot; is_slot(v, slot) &&
  @     are_filed_but_for(v, today(v)) && filed_at(v, slot) == today(v) ==>
  @     has_a_time(v, slot) && filed_for(v, slot) == -1;
  @ lemma out_keeps_times: \forall view a, b, integer slot;
  @     is_out(a, b, slot) && is_slot(a, slot) && has_a_time(a, slot) ==>
  @     has_a_time(b, slot);
  @ lemma out_keeps_date: \forall view a, b, integer slot;
  @     is_out(a, b, slot) && is_dated(a) ==> is_dated(b);
  @ lemma one_opened: \forall view a, b, c, integer d, slot;
  @     are_filed_but_for(a, d) && d == today(a) && is_slot(a, slot) &&
  @     filed_at(a, slot) == d && is_out(a, b, slot) && is_in(b, c, slot) &&
  @     is_sound(c) ==> are_filed_but_for(c, d);
  @ lemma all_opened: \forall view v, integer d; are_filed_but_for(v, d) &&
  @     (\forall integer s; is_slot(v, s) ==> filed_at(v, s) != d) ==>
  @     are_filed(v, 0, 0);
  @ lemma year_over: \forall view a, integer epoch;
  @     are_filed(a, 0, 0) && count(a) == 0 && today(a) == days(a) - 1 &&
  @     is_earliest_epoch(a, epoch, slots(a)) ==> epoch > epoch(a);
  @ lemma new_year: \forall view a, b;
  @     are_filed(a, 0, 0) && count(a) == 0 && today(a) == days(a) - 1 &&
  @     is_turned(a, b) && is_earliest_epoch(a, epoch(b), slots(a)) &&
  @     epoch(b) < 0x7FFFFFFFFFFFFFFF && today(b) == 0 ==>
  @     are_filed(b, 0, slots(b));
  @*/
