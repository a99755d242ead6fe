// SPDX-License-Identifier: MIT
// with: -wp-prop @lemma
/**
 * What keeps the calendar as a whole, apart from memory: what its functions are
 * proved by, of the steps that they take (calendar_steps_wp.h) and what is kept
 * (calendar_state_wp.h).  Each lemma is proved of those before it.
 */
#include "calendar_view_wp.h"

#include "calendar_frames_wp.h"

#include "calendar_steps_wp.h"

#include "calendar_state_wp.h"

// --- The same lists ------------------------------------------------------------

/*@ predicate same_listing(view a, view b) =
  @     \forall integer s; is_slot(a, s) &&
  @         (filed_at(a, s) >= 0 || filed_at(b, s) >= 0) ==>
  @         filed_at(b, s) == filed_at(a, s);
  @ lemma headed_kept: \forall view a, b; is_headed(a) && same_size(a, b) &&
  @     same_lists(a, b) && same_listing(a, b) ==> is_headed(b);
  @ lemma back_kept: \forall view a, b; is_linked_back(a) && same_size(a, b) &&
  @     same_lists(a, b) && same_listing(a, b) && is_placed(a) ==>
  @     is_linked_back(b);
  @ lemma on_kept: \forall view a, b; is_linked_on(a) && same_size(a, b) &&
  @     same_lists(a, b) && same_listing(a, b) ==> is_linked_on(b);
  @ lemma fall_kept: \forall view a, b, numbering n; falls(a, n) &&
  @     same_size(a, b) && same_lists(a, b) && same_listing(a, b) ==> falls(b, n);
  @*/

// --- The same heap, and all else but times -------------------------------------

/*@ lemma structure_filing: \forall view a, b; same_structure(a, b) ==>
  @     same_filing(a, b, -1) && same_listing(a, b);
  @ lemma structure_indexed: \forall view a, b;
  @     same_structure(a, b) && is_indexed(a) ==> is_indexed(b);
  @ lemma structure_placed: \forall view a, b; same_structure(a, b) &&
  @     is_sized(a) && is_indexed(a) && is_placed(a) ==>
  @     is_placed(b) && is_sized(b);
  @ lemma structure_sound: \forall view a, b;
  @     same_structure(a, b) && is_sound(a) ==> is_sound(b);
  @*/

// --- The heap's steps ----------------------------------------------------------

/*@ lemma top: \forall view v; is_indexed(v) && count(v) > 0 ==>
  @     is_slot(v, at(v, 0)) && place(v, at(v, 0)) == 0;
  @ lemma filing_of_heap: \forall view a, b, integer slot, s;
  @     is_placed(a) && is_sized(a) && is_slot(a, s) && s != slot &&
  @     same_size(a, b) && none_lost(a, b, slot) && is_indexed(b) &&
  @     count(b) <= slots(b) ==> filed_at(b, s) == filed_at(a, s) &&
  @     (filed_at(a, s) >= 0 ==> place(b, s) == place(a, s)) &&
  @     (filed_at(b, s) == -1 ==> in_heap(b, s));
  @ lemma heap_filing: \forall view a, b, integer slot;
  @     is_placed(a) && is_sized(a) && same_size(a, b) && none_lost(a, b, slot) &&
  @     is_indexed(b) && count(b) <= slots(b) ==> same_filing(a, b, slot);
  @ lemma heap_placed: \forall view a, b, integer slot;
  @     is_placed(a) && is_sized(a) && same_size(a, b) && none_lost(a, b, slot) &&
  @     is_indexed(b) && count(b) <= slots(b) && filed_at(b, slot) < 0 &&
  @     (filed_at(b, slot) == -1 ==> in_heap(b, slot)) ==>
  @     is_placed(b);
  @ lemma heap_out: \forall view a, b, integer slot;
  @     is_placed(a) && is_sized(a) && is_slot(a, slot) &&
  @     filed_at(a, slot) == -1 && is_put_out(a, b, slot) ==>
  @     is_out(a, b, slot) && is_placed(b) && is_sized(b);
  @ lemma heap_filed: \forall view a, b, integer slot; is_sized(a) &&
  @     same_size(a, b) && in_heap(b, slot) && count(b) <= slots(b) ==>
  @     filed_at(b, slot) == -1;
  @ lemma heap_in: \forall view a, b, integer slot;
  @     is_placed(a) && is_sized(a) && filed_at(a, slot) == -2 &&
  @     is_put_in(a, b, slot) && filed_for(a, slot) == -1 &&
  @     same_filing(a, b, slot) && filed_at(b, slot) == -1 ==> is_in(a, b, slot);
  @ lemma heap_in_place: \forall view a, b, integer slot;
  @     is_placed(a) && is_sized(a) && is_put_in(a, b, slot) ==>
  @     same_filing(a, b, slot) && filed_at(b, slot) == -1 && is_sized(b);
  @ lemma heap_in_placed: \forall view a, b, integer slot;
  @     is_placed(a) && is_sized(a) && is_put_in(a, b, slot) &&
  @     filed_at(b, slot) == -1 ==> is_placed(b);
  @*/

// --- The lists' steps ----------------------------------------------------------

/*@ lemma filing_of_lists: \forall view a, b, integer slot;
  @     same_size(a, b) && same_heap(a, b) && same_places(a, b, slot) ==>
  @     same_filing(a, b, slot);
  @ lemma index_kept: \forall view a, b, integer slot;
  @     is_indexed(a) && is_sized(a) && same_size(a, b) && same_heap(a, b) &&
  @     filed_at(a, slot) != -1 && is_placed(a) && is_slot(a, slot) &&
  @     same_places(a, b, slot) ==> is_indexed(b);
  @ lemma places_kept: \forall view a, b, integer slot;
  @     is_placed(a) && same_size(a, b) && same_heap(a, b) && is_sized(a) &&
  @     same_places(a, b, slot) && filed_at(b, slot) != -1 &&
  @     filed_at(b, slot) < days(b) ==> is_placed(b);
  @ lemma added_headed: \forall view a, b, integer d, slot;
  @     is_added(a, b, d, slot) && is_linked(a) && is_slot(a, slot) &&
  @     is_sized(a) &&
  @     is_day(a, d) && filed_at(a, slot) == -2 ==> is_headed(b);
  @ lemma added_back_of_first: \forall view a, b, integer d, slot;
  @     is_added(a, b, d, slot) && is_headed(a) && is_slot(a, slot) &&
  @     is_sized(a) && is_day(a, d) && filed_at(a, slot) == -2 &&
  @     first(a, d) != slots(a) ==>
  @     is_slot(b, slot) && filed_at(b, slot) == d &&
  @     filed_at(b, first(a, d)) == d;
  @ lemma added_as_first: \forall view a, b, integer d, slot, s;
  @     is_added(a, b, d, slot) && is_linked_back(a) && is_slot(a, slot) &&
  @     is_sized(a) && is_day(a, d) && filed_at(a, slot) == -2 && s != slot &&
  @     s != first(a, d) && is_slot(a, s) && filed_at(a, s) >= 0 &&
  @     is_placed(a) && previous(a, s) == slots(a) ==>
  @     previous(b, s) == slots(b) && first(b, filed_at(b, s)) == s;
  @ lemma added_as_next: \forall view a, b, integer d, slot, s;
  @     is_added(a, b, d, slot) && is_linked_back(a) && is_slot(a, slot) &&
  @     is_sized(a) && is_day(a, d) && filed_at(a, slot) == -2 && s != slot &&
  @     s != first(a, d) && is_slot(a, s) && filed_at(a, s) >= 0 &&
  @     previous(a, s) != slots(a) ==>
  @     previous(b, s) == previous(a, s) && is_slot(b, previous(b, s)) &&
  @     next(b, previous(b, s)) == s &&
  @     filed_at(b, previous(b, s)) == filed_at(b, s);
  @ lemma added_linked_back: \forall view a, b, integer d, slot;
  @     is_added(a, b, d, slot) && is_linked(a) && is_slot(a, slot) &&
  @     is_sized(a) &&
  @     is_placed(a) && is_day(a, d) && filed_at(a, slot) == -2 ==>
  @     is_linked_back(b);
  @ lemma added_linked_on: \forall view a, b, integer d, slot;
  @     is_added(a, b, d, slot) && is_linked(a) && is_slot(a, slot) &&
  @     is_sized(a) &&
  @     is_day(a, d) && filed_at(a, slot) == -2 ==> is_linked_on(b);
  @ lemma added_falls: \forall view a, b, integer d, slot, numbering n;
  @     is_added(a, b, d, slot) && is_linked(a) && is_slot(a, slot) &&
  @     is_sized(a) &&
  @     is_day(a, d) && filed_at(a, slot) == -2 && falls(a, n) ==>
  @     falls(b, with(n, slot, number(n, first(a, d)) + 1));
  @ lemma removed_headed: \forall view a, b, integer slot;
  @     is_removed(a, b, slot) && is_linked(a) && is_slot(a, slot) &&
  @     is_day(a, filed_at(a, slot)) ==> is_headed(b);
  @ lemma removed_back_of_next: \forall view a, b, integer slot;
  @     is_removed(a, b, slot) && is_linked(a) && is_slot(a, slot) &&
  @     is_day(a, filed_at(a, slot)) && next(a, slot) != slots(a) &&
  @     next(a, slot) != slot ==>
  @     (previous(b, next(a, slot)) == slots(b)
  @         ? first(b, filed_at(a, slot)) == next(a, slot)
  @         : is_slot(b, previous(a, slot)) &&
  @               previous(b, next(a, slot)) == previous(a, slot) &&
  @               next(b, previous(a, slot)) == next(a, slot) &&
  @               filed_at(b, previous(a, slot)) == filed_at(a, slot)) &&
  @     filed_at(b, next(a, slot)) == filed_at(a, slot);
  @ lemma removed_as_first: \forall view a, b, integer slot, s;
  @     is_removed(a, b, slot) && is_linked_back(a) && is_slot(a, slot) &&
  @     is_day(a, filed_at(a, slot)) && s != slot && s != next(a, slot) &&
  @     is_slot(a, s) && is_day(a, filed_at(a, s)) &&
  @     previous(a, s) == slots(a) ==>
  @     previous(b, s) == slots(b) && first(b, filed_at(b, s)) == s;
  @ lemma removed_as_next: \forall view a, b, integer slot, s;
  @     is_removed(a, b, slot) && is_linked_back(a) && is_slot(a, slot) &&
  @     is_day(a, filed_at(a, slot)) && s != slot && s != next(a, slot) &&
  @     is_slot(a, s) && is_day(a, filed_at(a, s)) &&
  @     previous(a, s) != slots(a) ==>
  @     previous(b, s) == previous(a, s) && is_slot(b, previous(b, s)) &&
  @     next(b, previous(b, s)) == s &&
  @     filed_at(b, previous(b, s)) == filed_at(b, s);
  @ lemma removed_linked_back: \forall view a, b, integer slot;
  @     is_removed(a, b, slot) && is_linked(a) && is_slot(a, slot) &&
  @     is_placed(a) && is_day(a, filed_at(a, slot)) ==> is_linked_back(b);
  @ lemma removed_linked_on: \forall view a, b, integer slot;
  @     is_removed(a, b, slot) && is_linked(a) && is_slot(a, slot) &&
  @     is_day(a, filed_at(a, slot)) ==> is_linked_on(b);
  @ lemma removed_falls: \forall view a, b, integer slot, numbering n;
  @     is_removed(a, b, slot) && is_linked(a) && is_slot(a, slot) &&
  @     is_day(a, filed_at(a, slot)) && falls(a, n) ==> falls(b, n);
  @ lemma list_out: \forall view a, b, integer slot;
  @     is_placed(a) && is_sized(a) && is_indexed(a) && is_slot(a, slot) &&
  @     filed_at(a, slot) >= 0 && is_removed(a, b, slot) ==>
  @     is_out(a, b, slot) && is_indexed(b) && is_placed(b);
  @ lemma list_in: \forall view a, b, integer d, slot;
  @     is_placed(a) && is_sized(a) && is_indexed(a) && is_slot(a, slot) &&
  @     filed_at(a, slot) == -2 && is_day(a, d) && is_added(a, b, d, slot) &&
  @     filed_for(a, slot) == d ==>
  @     is_in(a, b, slot) && is_indexed(b) && is_placed(b);
  @*/

// --- By time -------------------------------------------------------------------

/*@ lemma top_is_due: \forall view v; is_indexed(v) && is_sized(v) &&
  @     count(v) > 0 && are_all_filed(v) ==>
  @     is_slot(v, at(v, 0)) && filed_at(v, at(v, 0)) == -1 &&
  @     epoch_of(v, at(v, 0)) <= epoch(v);
  @ lemma nobody_is_due: \forall view v, integer s; is_placed(v) &&
  @     are_all_filed(v) && count(v) == 0 && today(v) == days(v) - 1 &&
  @     is_slot(v, s) ==> filed_at(v, s) == -2 && epoch_of(v, s) > epoch(v);
  @*/

#include "calendar_highest_wp.h"

#include "calendar_keeps_wp.h"
