// SPDX-License-Identifier: MIT
/**
 * What sim/calendar.c asks of ghosts; proved in calendar_ghosts_wp.c.
 */

/*@ ghost
  @ /@ requires is_calendar(c) && is_indexed(c, -1);
  @    requires slot < c->slots && c->filed[slot].place >= c->heap_count;
  @    terminates \true;
  @    exits \false;
  @    assigns \nothing;
  @    ensures c->heap_count < c->slots;
  @ @/
  @ void there_is_room(brink_calendar *c, uint32_t slot);
  @
  @ /@ requires is_calendar(c) && is_sound(view_of(c)) && day < c->days;
  @    requires c->first[day] == c->slots;
  @    terminates \true;
  @    exits \false;
  @    assigns \nothing;
  @    ensures \forall integer s; is_slot(view_of(c), s) ==>
  @        filed_at(view_of(c), s) != day;
  @ @/
  @ void nobody_is_left(brink_calendar *c, uint32_t day);
  @*/
