// SPDX-License-Identifier: MIT
/**
 * What stays as it was in memory when the calendar changes: calendar_frames_wp.h
 * says the same of the view of it.
 */

/*@ predicate same_size{A, B}(brink_calendar *c) =
  @     \at(c->slots, B) == \at(c->slots, A) &&
  @     \at(c->days, B) == \at(c->days, A) &&
  @     \at(c->days_a_time, B) == \at(c->days_a_time, A);
  @ predicate same_day{A, B}(brink_calendar *c) =
  @     \at(c->epoch, B) == \at(c->epoch, A) &&
  @     \at(c->today, B) == \at(c->today, A);
  @ predicate same_entry{A, B}(brink_calendar *c, integer s) =
  @     \at(c->entry[s].when.epoch, B) == \at(c->entry[s].when.epoch, A) &&
  @     \at(c->entry[s].when.offset, B) == \at(c->entry[s].when.offset, A) &&
  @     (\is_finite(\at(c->entry[s].when.offset, B)) <==>
  @      \is_finite(\at(c->entry[s].when.offset, A)));
  @ predicate same_entries{A, B}(brink_calendar *c, integer but) =
  @     \forall integer s; 0 <= s < \at(c->slots, A) && s != but ==>
  @         same_entry{A, B}(c, s);
  @ predicate same_heap{A, B}(brink_calendar *c) =
  @     \at(c->heap_count, B) == \at(c->heap_count, A) &&
  @     \forall integer p; 0 <= p < \at(c->heap_count, A) ==>
  @         \at(c->heap[p], B) == \at(c->heap[p], A);
  @ predicate same_firsts{A, B}(brink_calendar *c, integer but) =
  @     \forall integer d; 0 <= d < \at(c->days, A) && d != but ==>
  @         \at(c->first[d], B) == \at(c->first[d], A);
  @ predicate same_places{A, B}(brink_calendar *c, integer but) =
  @     \forall integer s; 0 <= s < \at(c->slots, A) && s != but ==>
  @         \at(c->filed[s].place, B) == \at(c->filed[s].place, A);
  @ predicate same_nexts{A, B}(brink_calendar *c, integer but) =
  @     \forall integer s; 0 <= s < \at(c->slots, A) && s != but ==>
  @         \at(c->filed[s].next, B) == \at(c->filed[s].next, A);
  @ predicate same_previous{A, B}(brink_calendar *c, integer x, integer y) =
  @     \forall integer s; 0 <= s < \at(c->slots, A) && s != x && s != y ==>
  @         \at(c->filed[s].previous, B) == \at(c->filed[s].previous, A);
  @*/
