// SPDX-License-Identifier: MIT
/**
 * What the calendar's functions keep, for those who need no more than that it is
 * kept: calendar_state_wp.h says what it is.
 */

/*@ axiomatic Told {
  @   predicate is_sound(view v);
  @   predicate is_dated(view v);
  @   predicate are_filed(view v, integer from, integer end);
  @   predicate are_filed_but_for(view v, integer day);
  @ }
  @*/
