// SPDX-License-Identifier: MIT
// with: -wp-prop @lemma
/**
 * The heap as its view shows it.
 */
#include "calendar_memory_wp.h"

#include "calendar_frames_wp.h"

#include "calendar_steps_wp.h"

#include "calendar_places_wp.h"

/*@ lemma index_in_memory_at{L}: \forall brink_calendar *c, integer p;
  @     is_indexed(view_of{L}(c)) && 0 <= p < c->heap_count ==>
  @     at(view_of{L}(c), p) == c->heap[p] && c->heap[p] < c->slots &&
  @     c->filed[c->heap[p]].place == p;
  @ lemma index_of_view_at{L}: \forall brink_calendar *c, integer p;
  @     is_indexed{L}(c, -1) && 0 <= p < count(view_of{L}(c)) ==>
  @     at(view_of{L}(c), p) == c->heap[p] &&
  @     is_slot(view_of{L}(c), at(view_of{L}(c), p)) &&
  @     place(view_of{L}(c), at(view_of{L}(c), p)) == p;
  @ lemma first_seen{A, B}: \forall brink_calendar *c, integer d;
  @     same_firsts{A, B}(c) && is_day(view_of{A}(c), d) ==>
  @     first(view_of{B}(c), d) == first(view_of{A}(c), d);
  @ lemma next_seen{A, B}: \forall brink_calendar *c, integer s;
  @     same_nexts{A, B}(c) && is_slot(view_of{A}(c), s) ==>
  @     next(view_of{B}(c), s) == next(view_of{A}(c), s);
  @ lemma previous_seen{A, B}: \forall brink_calendar *c, integer s;
  @     same_previous{A, B}(c) && is_slot(view_of{A}(c), s) ==>
  @     previous(view_of{B}(c), s) == previous(view_of{A}(c), s);
  @*/

#include "calendar_bridge_wp.h"
