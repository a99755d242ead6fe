// SPDX-License-Identifier: MIT
// with: -wp-prop @lemma
/**
 * The calendar as its view shows it.
 */
#include "calendar_memory_wp.h"

#include "calendar_seen_wp.h"

#include "calendar_frames_wp.h"

#include "calendar_steps_wp.h"

#include "calendar_places_wp.h"

#include "calendar_same_wp.h"

/*@ lemma index_in_memory_at{L}: \forall brink_calendar *c, integer p;
  @     is_indexed(view_of{L}(c)) && 0 <= p < c->heap_count ==>
  @     at(view_of{L}(c), p) == c->heap[p] && c->heap[p] < c->slots &&
  @     c->filed[c->heap[p]].place == p;
  @ lemma index_of_view_at{L}: \forall brink_calendar *c, integer p;
  @     is_indexed{L}(c, -1) && 0 <= p < count(view_of{L}(c)) ==>
  @     at(view_of{L}(c), p) == c->heap[p] &&
  @     is_slot(view_of{L}(c), at(view_of{L}(c), p)) &&
  @     place(view_of{L}(c), at(view_of{L}(c), p)) == p;
  @ predicate same_time(view a, view b, integer s) =
  @     epoch_of(b, s) == epoch_of(a, s) && day_for(b, s) == day_for(a, s) &&
  @     (has_a_time(b, s) <==> has_a_time(a, s));
  @ lemma epoch_seen{A, B}: \forall brink_calendar *c, integer s;
  @     same_entry{A, B}(c, s) ==>
  @     epoch_of(view_of{B}(c), s) == epoch_of(view_of{A}(c), s);
  @ lemma day_for_seen{A, B}: \forall brink_calendar *c, integer s;
  @     same_size{A, B}(c) && same_entry{A, B}(c, s) ==>
  @     day_for(view_of{B}(c), s) == day_for(view_of{A}(c), s);
  @ lemma is_a_time_kept{A, B}: \forall brink_calendar *c, brink_instant when;
  @     same_size{A, B}(c) ==>
  @     (is_a_time{B}(c, when) <==> is_a_time{A}(c, when));
  @ lemma has_time_seen{A, B}: \forall brink_calendar *c, integer s;
  @     same_size{A, B}(c) && same_entry{A, B}(c, s) ==>
  @     (has_a_time(view_of{B}(c), s) <==> has_a_time(view_of{A}(c), s));
  @ lemma entry_seen{A, B}: \forall brink_calendar *c, integer s;
  @     same_size{A, B}(c) && same_entry{A, B}(c, s) ==>
  @     same_time(view_of{A}(c), view_of{B}(c), s);
  @ lemma entries_seen{A, B}: \forall brink_calendar *c, integer but, s;
  @     same_entries{A, B}(c, but) && is_slot(view_of{A}(c), s) && s != but ==>
  @     same_entry{A, B}(c, s);
  @*/

#include "calendar_bridge_wp.h"
