// SPDX-License-Identifier: MIT
/**
 * Who has the highest number in the list of a day is its first.
 */

/*@ // Of the first slots that with the highest number in the list of a day.
  @ logic integer highest(view v, numbering n, integer day, integer end) =
  @     end <= 0 ? -1
  @     : filed_at(v, end - 1) == day &&
  @           (highest(v, n, day, end - 1) < 0 ||
  @            number(n, highest(v, n, day, end - 1)) < number(n, end - 1))
  @         ? end - 1 : highest(v, n, day, end - 1);
  @ predicate is_highest(view v, numbering n, integer day, integer end,
  @                      integer slot) =
  @     -1 <= slot < end && (slot >= 0 ==> filed_at(v, slot) == day) &&
  @     \forall integer s; 0 <= s < end && filed_at(v, s) == day ==>
  @         slot >= 0 && number(n, s) <= number(n, slot);
  @
  @ lemma highest_is_first: \forall view v, numbering n, integer day, slot;
  @     is_sized(v) && is_linked_back(v) && falls(v, n) && is_day(v, day) &&
  @     is_highest(v, n, day, slots(v), slot) && slot >= 0 ==>
  @     first(v, day) == slot;
  @ lemma no_first: \forall view v, numbering n, integer day, slot;
  @     is_sized(v) && is_linked_back(v) && falls(v, n) && is_day(v, day) &&
  @     is_highest(v, n, day, slots(v), slot) && first(v, day) == slots(v) ==>
  @     \forall integer s; is_slot(v, s) ==> filed_at(v, s) != day;
  @*/
