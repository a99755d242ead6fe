// SPDX-License-Identifier: MIT
/**
 * The calendar in memory: what brink_calendar_create makes, and the view of it.
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
  @     \separated(c, c->entry + (0 .. c->slots - 1), c->filed + (0 .. c->slots),
  @                c->heap + (0 .. c->slots - 1), c->first + (0 .. c->days - 1));
  @
  @ axiomatic Day {
  @   logic integer day_at(double days_a_time, double offset);
  @ }
  @ predicate is_a_time(brink_calendar *c, brink_instant when) =
  @     \is_finite(when.offset) && (when.epoch != 0x7FFFFFFFFFFFFFFF ==>
  @         0 <= when.offset && when.offset * c->days_a_time < c->days);
  @
  @ predicate is_view_of(view v, brink_calendar *c) =
  @     slots(v) == c->slots && days(v) == c->days && today(v) == c->today &&
  @     epoch(v) == c->epoch && count(v) == c->heap_count &&
  @     (\forall integer p; at(v, p) == c->heap[p]) &&
  @     (\forall integer s; place(v, s) == c->filed[s].place) &&
  @     (\forall integer d; first(v, d) == c->first[d]) &&
  @     (\forall integer s; next(v, s) == c->filed[s].next) &&
  @     (\forall integer s; previous(v, s) == c->filed[s].previous) &&
  @     (\forall integer s; epoch_of(v, s) == c->entry[s].when.epoch) &&
  @     (\forall integer s; day_for(v, s) ==
  @         day_at(c->days_a_time, c->entry[s].when.offset)) &&
  @     (\forall integer s; has_a_time(v, s) <==>
  @         is_a_time(c, c->entry[s].when));
  @
  @ // One view of whatever is there: a definition, which assumes nothing.
  @ axiomatic ViewOf {
  @   logic view view_of{L}(brink_calendar *c)
  @     reads *c, c->heap[..], c->first[..], c->filed[..], c->entry[..];
  @   axiom its_view{L}: \forall brink_calendar *c; is_view_of(view_of{L}(c), c);
  @ }
  @*/
