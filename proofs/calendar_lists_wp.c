// SPDX-License-Identifier: MIT
// with: -wp-fct heap_add,heap_remove,list_add,list_remove,entry_put,turn_to
// with: -wp-timeout 60
/**
 * What the calendar's functions do to its heap and lists, as compiled, slot by
 * slot.  A slot that is put in a list is its first, one that is taken out is left
 * out by the two beside it, and every other link, place and first is what it was;
 * the heap's moves touch no link at all, and of slots that are not in the heap no
 * place.  That this keeps the calendar as a whole is calendar_filed_wp.c.
 */
#include "calendar_memory_wp.h"

#include "calendar_frames_wp.h"

#include "calendar_steps_wp.h"

#include "calendar_told_wp.h"

#include "calendar_places_wp.h"

#include "calendar_ghosts_wp.h"

#include "calendar_unordered_wp.h"

#include "calendar_calls_wp.h"

// --- The heap, but for its order, which is calendar_wp.c's ---------------------

// Trusted: as calendar_wp.c proves it, of the heap apart from memory.
/*@ requires has_hole(c, position, slot);
  @ terminates \true;
  @ exits \false;
  @ assigns c->heap[0 .. c->heap_count - 1],
  @         c->filed[0 .. c->slots - 1].place;
  @ ensures whole: is_calendar(c) && c->heap_count == \old(c->heap_count);
  @ ensures numbers: same_numbers{Pre, Post}(c);
  @ ensures firsts: same_firsts{Pre, Post}(c);
  @ ensures nexts: same_nexts{Pre, Post}(c);
  @ ensures previous: same_previous{Pre, Post}(c);
  @ ensures index: is_indexed(c, -1);
  @ ensures put_in: in_heap(c, -1, slot);
  @ ensures none_lost: none_lost{Pre, Post}(c, \at(position, Pre), -1, slot);
  @*/
static void heap_settle(brink_calendar *c, uint32_t position, uint32_t slot);

#include "../sim/calendar.c"
