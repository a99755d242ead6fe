// SPDX-License-Identifier: MIT
/**
 * The steps that change the calendar: a slot is put in the heap or a list, or is
 * taken out of it, gets another entry, or another day has come.
 */

/*@ predicate same_size(view a, view b) =
  @     slots(b) == slots(a) && days(b) == days(a);
  @ predicate same_day(view a, view b) =
  @     epoch(b) == epoch(a) && today(b) == today(a);
  @ predicate same_calendar(view a, view b) =
  @     same_size(a, b) && same_day(a, b) && same_times(a, b, -1);
  @ predicate same_structure(view a, view b) =
  @     same_size(a, b) && same_heap(a, b) && same_lists(a, b) &&
  @     same_places(a, b, -1);
  @*/

// --- The heap ------------------------------------------------------------------

/*@ predicate is_put_in(view a, view b, integer slot) =
  @     same_calendar(a, b) && same_lists(a, b) &&
  @     count(b) == count(a) + 1 <= slots(b) &&
  @     is_indexed(b) && in_heap(b, slot) && none_lost(a, b, slot);
  @ predicate is_put_out(view a, view b, integer slot) =
  @     same_calendar(a, b) && same_lists(a, b) && count(b) == count(a) - 1 &&
  @     is_indexed(b) && place(b, slot) == 0xFFFFFFFF && none_lost(a, b, slot);
  @*/

// --- The lists -----------------------------------------------------------------

/*@ predicate is_added(view a, view b, integer d, integer slot) =
  @     same_calendar(a, b) && same_heap(a, b) &&
  @     place(b, slot) == 0x80000000 + d && first(b, d) == slot &&
  @     next(b, slot) == first(a, d) && previous(b, slot) == slots(a) &&
  @     previous(b, first(a, d)) == slot &&
  @     same_firsts(a, b, d) && same_places(a, b, slot) &&
  @     same_nexts(a, b, slot) && same_previous(a, b, slot, first(a, d));
  @
  @ predicate is_removed(view a, view b, integer slot) =
  @     same_calendar(a, b) && same_heap(a, b) && place(b, slot) == 0xFFFFFFFF &&
  @     (previous(a, slot) == slots(a)
  @         ? first(b, filed_at(a, slot)) == next(a, slot) &&
  @               same_firsts(a, b, filed_at(a, slot)) && same_nexts(a, b, -1)
  @         : next(b, previous(a, slot)) == next(a, slot) &&
  @               same_firsts(a, b, -1) && same_nexts(a, b, previous(a, slot))) &&
  @     previous(b, next(a, slot)) == previous(a, slot) &&
  @     same_places(a, b, slot) && same_previous(a, b, next(a, slot), -1);
  @*/

// --- Entries and days ----------------------------------------------------------

/*@ predicate is_given(view a, view b, integer slot) =
  @     same_structure(a, b) && same_day(a, b) && same_times(a, b, slot);
  @ predicate is_turned(view a, view b) =
  @     same_structure(a, b) && same_times(a, b, -1);
  @*/
