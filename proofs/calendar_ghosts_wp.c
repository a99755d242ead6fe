// SPDX-License-Identifier: MIT
// with: -wp-fct there_is_room,nobody_is_left
/**
 * A heap that a slot is not in has room for it; and a list that has no first has
 * none: as none runs in a circle, what is in the list of a day is known to the
 * day.
 */
#include "calendar_memory_wp.h"

#include "calendar_seen_wp.h"

#include "calendar_frames_wp.h"

#include "calendar_steps_wp.h"

#include "calendar_state_wp.h"

#include "calendar_places_wp.h"

#include "calendar_ghosts_wp.h"

// --- The heap ------------------------------------------------------------------

// Counted: as many of all slots are in the heap as it has positions.

/*@ logic integer in_heap_below(brink_calendar *c, integer count, integer n) =
  @     n <= 0 ? 0
  @     : in_heap_below(c, count, n - 1) +
  @           (c->filed[n - 1].place < count &&
  @            c->heap[c->filed[n - 1].place] == n - 1 ? 1 : 0);
  @*/

/*@ ghost
  @ void there_is_room(brink_calendar *c, uint32_t slot)
  @ {
  @     uint32_t n = 0, count = 0;
  @     /@ loop invariant n <= c->slots && in_heap_below(c, 0, n) == 0;
  @        loop assigns n;
  @        loop variant c->slots - n;
  @     @/
  @     while (n < c->slots)
  @         n++;
  @     /@ loop invariant count <= c->heap_count;
  @        loop invariant in_heap_below(c, count, c->slots) == count;
  @        loop assigns n, count;
  @        loop variant c->heap_count - count;
  @     @/
  @     while (count < c->heap_count) {
  @         n = 0;
  @         /@ loop invariant n <= c->slots;
  @            loop invariant in_heap_below(c, count + 1, n) ==
  @                in_heap_below(c, count, n) + (c->heap[count] < n ? 1 : 0);
  @            loop assigns n;
  @            loop variant c->slots - n;
  @         @/
  @         while (n < c->slots)
  @             n++;
  @         count++;
  @     }
  @     n = 0;
  @     /@ loop invariant n <= c->slots;
  @        loop invariant in_heap_below(c, c->heap_count, n) <=
  @            n - (slot < n ? 1 : 0);
  @        loop assigns n;
  @        loop variant c->slots - n;
  @     @/
  @     while (n < c->slots)
  @         n++;
  @ }
  @*/

// --- The lists -----------------------------------------------------------------

#include "calendar_highest_wp.h"

/*@ ghost
  @ void nobody_is_left(brink_calendar *c, uint32_t day)
  @ {
  @     uint32_t end = 0;
  @     /@ loop invariant end <= c->slots;
  @        loop invariant \forall numbering n; falls(view_of(c), n) ==>
  @            is_highest(view_of(c), n, day, end,
  @                       highest(view_of(c), n, day, end));
  @        loop assigns end;
  @        loop variant c->slots - end;
  @     @/
  @     while (end < c->slots)
  @         end++;
  @ }
  @*/
