// SPDX-License-Identifier: MIT
/**
 * The heap in memory and the places of its slots, while there is a hole in it.
 */

#include "calendar_index_wp.h"

/*@ predicate in_heap(brink_calendar *c, integer hole, integer slot) =
  @     c->filed[slot].place < c->heap_count && c->filed[slot].place != hole &&
  @     c->heap[c->filed[slot].place] == slot;
  @
  @ predicate has_hole(brink_calendar *c, integer hole, integer slot) =
  @     is_calendar(c) && 0 <= hole < c->heap_count && 0 <= slot < c->slots &&
  @     is_indexed(c, hole) && !in_heap(c, hole, slot);
  @
  @ // No slot is lost, none has come, and no other has another place.
  @ predicate none_lost{Old, New}(brink_calendar *c, integer before,
  @                               integer hole, integer but) =
  @     \forall integer s; 0 <= s < \at(c->slots, Old) && s != but ==>
  @         (in_heap{Old}(c, before, s)
  @             ? in_heap{New}(c, hole, s)
  @             : !in_heap{New}(c, hole, s) &&
  @                   \at(c->filed[s].place, New) == \at(c->filed[s].place, Old));
  @
  @ predicate a_hole_moved{Old, New}(brink_calendar *c, integer before,
  @                                  integer hole, integer slot) =
  @     has_hole{New}(c, hole, slot) &&
  @     \at(c->slots, New) == \at(c->slots, Old) &&
  @     \at(c->heap_count, New) == \at(c->heap_count, Old) &&
  @     none_lost{Old, New}(c, before, hole, -1);
  @*/
