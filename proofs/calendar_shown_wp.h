// SPDX-License-Identifier: MIT
/**
 * Of the lists, what the view of the calendar shows, one by one; proved in
 * calendar_bridge_wp.c.
 */

/*@ lemma first_of_view{L}: \forall brink_calendar *c, integer d;
  @     first(view_of{L}(c), d) == c->first[d];
  @ lemma place_of_view{L}: \forall brink_calendar *c, integer s;
  @     place(view_of{L}(c), s) == c->filed[s].place;
  @ lemma next_of_view{L}: \forall brink_calendar *c, integer s;
  @     next(view_of{L}(c), s) == c->filed[s].next;
  @ lemma previous_of_view{L}: \forall brink_calendar *c, integer s;
  @     previous(view_of{L}(c), s) == c->filed[s].previous;
  @*/
