// SPDX-License-Identifier: MIT
/**
 * What is said of the calendar in memory and of the view of it is the same;
 * proved in calendar_bridge_wp.c.
 */

#include "calendar_shown_wp.h"

/*@ lemma index_in_memory{L}: \forall brink_calendar *c;
  @     is_indexed(view_of{L}(c)) ==> is_indexed{L}(c, -1);
  @ lemma index_of_view{L}: \forall brink_calendar *c;
  @     is_indexed{L}(c, -1) ==> is_indexed(view_of{L}(c));
  @ lemma in_heap_seen{L}: \forall brink_calendar *c, integer slot;
  @     in_heap(view_of{L}(c), slot) <==> in_heap{L}(c, -1, slot);
  @ lemma none_lost_seen{A, B}: \forall brink_calendar *c, integer slot;
  @     none_lost{A, B}(c, -1, -1, slot) ==>
  @     none_lost(view_of{A}(c), view_of{B}(c), slot);
  @ lemma size_seen{A, B}: \forall brink_calendar *c;
  @     same_size{A, B}(c) ==> same_size(view_of{A}(c), view_of{B}(c));
  @ lemma day_seen{A, B}: \forall brink_calendar *c;
  @     same_day{A, B}(c) ==> same_day(view_of{A}(c), view_of{B}(c));
  @ lemma times_seen{A, B}: \forall brink_calendar *c, integer but;
  @     same_entries{A, B}(c, but) && same_size{A, B}(c) ==>
  @     same_times(view_of{A}(c), view_of{B}(c), but);
  @ lemma time_seen{L}: \forall brink_calendar *c, integer slot;
  @     is_a_time{L}(c, c->entry[slot].when) ==>
  @     has_a_time(view_of{L}(c), slot);
  @ lemma heap_seen{A, B}: \forall brink_calendar *c;
  @     same_heap{A, B}(c) ==> same_heap(view_of{A}(c), view_of{B}(c));
  @ lemma firsts_seen{A, B}: \forall brink_calendar *c, integer but;
  @     same_firsts{A, B}(c, but) ==>
  @     same_firsts(view_of{A}(c), view_of{B}(c), but);
  @ lemma places_seen{A, B}: \forall brink_calendar *c, integer but;
  @     same_places{A, B}(c, but) ==>
  @     same_places(view_of{A}(c), view_of{B}(c), but);
  @ lemma nexts_seen{A, B}: \forall brink_calendar *c, integer but;
  @     same_nexts{A, B}(c, but) ==>
  @     same_nexts(view_of{A}(c), view_of{B}(c), but);
  @ lemma previous_seen{A, B}: \forall brink_calendar *c, integer x, y;
  @     same_previous{A, B}(c, x, y) ==>
  @     same_previous(view_of{A}(c), view_of{B}(c), x, y);
  @ lemma lists_seen{A, B}: \forall brink_calendar *c;
  @     same_firsts{A, B}(c, -1) && same_nexts{A, B}(c, -1) &&
  @     same_previous{A, B}(c, -1, -1) ==>
  @     same_lists(view_of{A}(c), view_of{B}(c));
  @ lemma structure_seen{A, B}: \forall brink_calendar *c;
  @     same_size{A, B}(c) && same_heap{A, B}(c) && same_places{A, B}(c, -1) &&
  @     same_firsts{A, B}(c, -1) && same_nexts{A, B}(c, -1) &&
  @     same_previous{A, B}(c, -1, -1) ==>
  @     same_structure(view_of{A}(c), view_of{B}(c));
  @ lemma given_seen{A, B}: \forall brink_calendar *c, integer slot;
  @     same_size{A, B}(c) && same_heap{A, B}(c) && same_places{A, B}(c, -1) &&
  @     same_firsts{A, B}(c, -1) && same_nexts{A, B}(c, -1) &&
  @     same_previous{A, B}(c, -1, -1) && same_day{A, B}(c) &&
  @     same_entries{A, B}(c, slot) ==>
  @     is_given(view_of{A}(c), view_of{B}(c), slot);
  @ lemma turned_seen{A, B}: \forall brink_calendar *c;
  @     same_size{A, B}(c) && same_heap{A, B}(c) && same_places{A, B}(c, -1) &&
  @     same_firsts{A, B}(c, -1) && same_nexts{A, B}(c, -1) &&
  @     same_previous{A, B}(c, -1, -1) && same_entries{A, B}(c, -1) ==>
  @     is_turned(view_of{A}(c), view_of{B}(c));
  @ lemma top_seen{L}: \forall brink_calendar *c;
  @     at(view_of{L}(c), 0) == c->heap[0];
  @*/
