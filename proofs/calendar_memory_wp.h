// SPDX-License-Identifier: MIT
/**
 * The calendar in memory: what brink_calendar_create makes.
 */
#include "../sim/calendar.h"
#include "libm_wp.h"

#include "calendar_view_wp.h"

/*@ predicate is_calendar(brink_calendar *c) =
  @     \valid(c) && c->slots < 0x80000000 && c->heap_count <= c->slots &&
  @     c->days <= 0x40000000 &&
  @     \valid(c->entry + (0 .. c->slots - 1)) &&
  @     \valid(c->filed + (0 .. c->slots)) &&
  @     \valid(c->heap + (0 .. c->slots - 1)) &&
  @     \valid(c->first + (0 .. c->days - 1)) &&
  @     \base_addr(c) != \base_addr(c->entry) &&
  @     \base_addr(c) != \base_addr(c->filed) &&
  @     \base_addr(c) != \base_addr(c->heap) &&
  @     \base_addr(c) != \base_addr(c->first) &&
  @     \base_addr(c->entry) != \base_addr(c->filed) &&
  @     \base_addr(c->entry) != \base_addr(c->heap) &&
  @     \base_addr(c->entry) != \base_addr(c->first) &&
  @     \base_addr(c->filed) != \base_addr(c->heap) &&
  @     \base_addr(c->filed) != \base_addr(c->first) &&
  @     \base_addr(c->heap) != \base_addr(c->first);
  @
  @ // All but how many are in the heap, and the place of a slot.
  @ predicate same_links{A, B}(brink_calendar *c) =
  @     \forall integer s; 0 <= s < \at(c->slots, A) ==>
  @         \at(c->filed[s].next, B) == \at(c->filed[s].next, A) &&
  @         \at(c->filed[s].previous, B) == \at(c->filed[s].previous, A);
  @ predicate same_ends{A, B}(brink_calendar *c) =
  @     (\forall integer p; 0 <= p < \at(c->slots, A) ==>
  @         \at(c->heap[p], B) == \at(c->heap[p], A)) &&
  @     (\forall integer d; 0 <= d < \at(c->days, A) ==>
  @         \at(c->first[d], B) == \at(c->first[d], A));
  @ predicate same_but_count{A, B}(brink_calendar *c, integer but) =
  @     \at(c->slots, B) == \at(c->slots, A) &&
  @     \at(c->days, B) == \at(c->days, A) &&
  @     same_ends{A, B}(c) && same_links{A, B}(c) &&
  @     \forall integer s; 0 <= s < \at(c->slots, A) && s != but ==>
  @         \at(c->filed[s].place, B) == \at(c->filed[s].place, A);
  @
  @ // offset * days_a_time, and that cut off: what is kept does not depend on it.
  @ axiomatic Day {
  @   logic real in_days(real days_a_time, real offset);
  @   logic integer day_at(real days_a_time, real offset);
  @ }
  @ predicate is_a_time(brink_calendar *c, brink_instant when) =
  @     \is_finite(when.offset) && (when.epoch != 0x7FFFFFFFFFFFFFFF ==>
  @         0 <= when.offset && in_days(c->days_a_time, when.offset) < c->days);
  @
  @ // The view of it: calendar_seen_wp.h says what it shows.
  @ axiomatic ViewOf {
  @   logic view view_of{L}(brink_calendar *c)
  @     reads *c, c->heap[..], c->first[..], c->filed[..], c->entry[..];
  @ }
  @*/
