// SPDX-License-Identifier: MIT
/**
 * What the view of the calendar shows: all that is in memory.
 */

/*@ predicate is_view_of(view v, brink_calendar *c) =
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
  @ axiomatic Seen {
  @   axiom its_view{L}: \forall brink_calendar *c; is_view_of(view_of{L}(c), c);
  @ }
  @*/
