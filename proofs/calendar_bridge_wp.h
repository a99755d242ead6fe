// SPDX-License-Identifier: MIT
/**
 * What is said of the heap in memory and of the view of it is the same; proved in
 * calendar_bridge_wp.c.
 */

/*@ lemma index_in_memory{L}: \forall brink_calendar *c;
  @     is_indexed(view_of{L}(c)) ==> is_indexed{L}(c, -1);
  @ lemma index_of_view{L}: \forall brink_calendar *c;
  @     is_indexed{L}(c, -1) ==> is_indexed(view_of{L}(c));
  @ lemma in_heap_seen{L}: \forall brink_calendar *c, integer slot;
  @     in_heap(view_of{L}(c), slot) <==> in_heap{L}(c, -1, slot);
  @ lemma none_lost_seen{A, B}: \forall brink_calendar *c, integer slot;
  @     none_lost{A, B}(c, -1, -1, slot) ==>
  @     none_lost(view_of{A}(c), view_of{B}(c), slot);
  @ lemma lists_seen{A, B}: \forall brink_calendar *c;
  @     same_numbers{A, B}(c) && same_firsts{A, B}(c) && same_nexts{A, B}(c) &&
  @     same_previous{A, B}(c) ==> same_lists(view_of{A}(c), view_of{B}(c));
  @ lemma numbers_seen{A, B}: \forall brink_calendar *c; same_numbers{A, B}(c) ==>
  @     same_size(view_of{A}(c), view_of{B}(c)) &&
  @     same_day(view_of{A}(c), view_of{B}(c));
  @ lemma first_of_view{L}: \forall brink_calendar *c, integer d;
  @     first(view_of{L}(c), d) == c->first[d];
  @ lemma top_seen{L}: \forall brink_calendar *c;
  @     at(view_of{L}(c), 0) == c->heap[0];
  @*/
