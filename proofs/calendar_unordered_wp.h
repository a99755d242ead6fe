// SPDX-License-Identifier: MIT
/**
 * What heap_settle's loops keep of the order where none is asked for: nothing.
 */

/*@ predicate can_settle(brink_calendar *c, integer position, integer slot) =
  @     \true;
  @ logic integer heap_of(brink_calendar *c) = 0;
  @ predicate is_after_above(integer heap, integer position, integer slot) =
  @     \true;
  @*/
