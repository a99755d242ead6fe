// SPDX-License-Identifier: MIT
/**
 * The calendar apart from memory: a view of all that it holds.
 */

/*@ axiomatic View {
  @   type view;
  @   logic integer slots(view v);
  @   logic integer days(view v);
  @   logic integer today(view v);
  @   logic integer epoch(view v);
  @   logic integer count(view v); // of the heap
  @   logic integer at(view v, integer position);
  @   logic integer place(view v, integer slot);
  @   logic integer first(view v, integer day);
  @   logic integer next(view v, integer slot);
  @   logic integer previous(view v, integer slot);
  @   logic integer epoch_of(view v, integer slot); // of its entry
  @   logic integer day_for(view v, integer slot); // in its year
  @   predicate has_a_time(view v, integer slot);
  @ }
  @
  @ predicate is_slot(view v, integer slot) = 0 <= slot < slots(v);
  @ predicate is_day(view v, integer day) = 0 <= day < days(v);
  @
  @ // Where a slot is: in the list of a day; -1: in the heap; -2: nowhere.
  @ logic integer filed_at(view v, integer slot) =
  @     place(v, slot) == 0xFFFFFFFF ? -2
  @     : place(v, slot) < 0x80000000 ? -1 : place(v, slot) - 0x80000000;
  @ // And where the time of its entry says.
  @ logic integer filed_for(view v, integer slot) =
  @     epoch_of(v, slot) > epoch(v) ? -2
  @     : epoch_of(v, slot) == epoch(v) && day_for(v, slot) > today(v)
  @         ? day_for(v, slot) : -1;
  @
  @ predicate is_earliest_epoch(view v, integer epoch, integer end) =
  @     (\forall integer s; 0 <= s < end ==> epoch_of(v, s) >= epoch) &&
  @     (epoch == 0x7FFFFFFFFFFFFFFF ||
  @         \exists integer s; 0 <= s < end && epoch_of(v, s) == epoch);
  @*/
