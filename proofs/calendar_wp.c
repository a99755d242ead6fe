// SPDX-License-Identifier: MIT
// with: -wp-fct first_below,heap_settle,list_add -wp-model Typed+real
/**
 * The calendar's heap and lists, as compiled.  The index is kept: the slot at a
 * position of the heap has that position for its place, so no slot is there
 * twice; and none gets lost: whatever was in the heap is in it afterwards, with
 * the slot that was put in.  The order is kept: no slot is before the one above
 * it.  A slot that is put in a list is its first, and whoever was first has it
 * before itself.  Nothing outside the calendar's own arrays is read or written,
 * and every loop ends.
 */
#include "calendar_wp.h"
#include "calendar_moves_wp.h"

/*@ requires is_calendar(c) && has_times(c);
  @ requires 2 * position + 1 < c->heap_count;
  @ requires has_an_order(heap_of(c)) && is_indexed(heap_of(c), position);
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures below: above(position, \result) && \result < c->heap_count;
  @ ensures first: is_before_below(heap_of(c), position, at(heap_of(c), \result));
  @*/
static uint32_t first_below(const brink_calendar *c, uint32_t position);

/*@ requires can_settle(c, position, slot);
  @ requires has_hole(heap_of(c), position, slot);
  @ terminates \true;
  @ exits \false;
  @ ensures index: is_indexed(heap_of(c), -1);
  @ ensures order: is_ordered(heap_of(c), -1);
  @ ensures put_in: in_heap(heap_of(c), -1, slot);
  @ ensures none_lost: has_become(heap_of{Pre}(c), heap_of{Post}(c),
  @                               \at(position, Pre), -1, slot);
  @*/
static void heap_settle(brink_calendar *c, uint32_t position, uint32_t slot);

/*@ requires is_calendar(c);
  @ requires list <= c->days && slot < c->slots;
  @ requires c->first[list] <= c->slots && c->first[list] != slot;
  @ terminates \true;
  @ exits \false;
  @ assigns c->first[list], c->filed[slot];
  @ assigns c->filed[\at(c->first[list], Pre)].previous;
  @ ensures first: c->first[list] == slot;
  @ ensures before: c->filed[slot].previous == c->slots;
  @ ensures after: c->filed[slot].next == \old(c->first[list]);
  @ ensures and_back: c->filed[c->filed[slot].next].previous == slot;
  @ ensures place: c->filed[slot].place == 0x80000000 + list;
  @*/
static void list_add(brink_calendar *c, uint32_t list, uint32_t slot);

#include "../sim/calendar.c"
