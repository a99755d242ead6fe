// SPDX-License-Identifier: MIT
// with: -wp-fct brink_instant_compare,brink_entry_compare,earlier,heap_put,list_add
/**
 * What the calendar's heap and lists are made of, as compiled: the comparison is
 * the one order; a slot put at a position of the heap is there, knows it, and all
 * else is as it was; a slot put in a list is its first, and whoever was first has
 * it before itself.  Nothing outside the calendar's own arrays is read or written.
 */
#include "calendar_wp.h"

/*@ requires \is_finite(a.offset) && \is_finite(b.offset);
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures -1 <= \result <= 1;
  @ ensures \result == -1 <==> instant_before(a, b);
  @ ensures \result == 1 <==> instant_before(b, a);
  @*/
static inline int brink_instant_compare(brink_instant a, brink_instant b);

/*@ requires \valid_read(a) && \valid_read(b);
  @ requires \is_finite(a->when.offset) && \is_finite(b->when.offset);
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures -1 <= \result <= 1;
  @ ensures earlier: \result == -1 <==> sooner(a, b);
  @ ensures later: \result == 1 <==> sooner(b, a);
  @*/
int brink_entry_compare(const brink_entry *a, const brink_entry *b);

/*@ requires is_in_memory(c);
  @ requires a < c->slots && b < c->slots;
  @ requires \valid_read(&c->entry[a]) && \valid_read(&c->entry[b]);
  @ requires \is_finite(c->entry[a].when.offset);
  @ requires \is_finite(c->entry[b].when.offset);
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \result == 0 || \result == 1;
  @ ensures order: \result == 1 <==> comes_first(c, a, b);
  @*/
static int earlier(const brink_calendar *c, uint32_t a, uint32_t b);

/*@ requires is_in_memory(c);
  @ requires position < c->slots && slot < c->slots;
  @ terminates \true;
  @ exits \false;
  @ assigns c->heap[position], c->filed[slot].place;
  @ ensures here: c->heap[position] == slot && c->filed[slot].place == position;
  @ ensures whole: is_in_memory(c) && c->slots == \old(c->slots) &&
  @                c->heap_count == \old(c->heap_count);
  @ ensures arrays: c->entry == \old(c->entry) && c->filed == \old(c->filed) &&
  @                 c->heap == \old(c->heap);
  @ ensures heap: \forall integer p; 0 <= p < c->slots && p != position ==>
  @     c->heap[p] == \old(c->heap[p]);
  @ ensures places: \forall integer s; 0 <= s < c->slots && s != slot ==>
  @     c->filed[s].place == \old(c->filed[s].place);
  @ ensures time: \forall integer s; 0 <= s < c->slots ==>
  @     c->entry[s].when.epoch == \old(c->entry[s].when.epoch) &&
  @     c->entry[s].when.offset == \old(c->entry[s].when.offset) &&
  @     c->entry[s].kind == \old(c->entry[s].kind);
  @ ensures i: \forall integer s; 0 <= s < c->slots ==>
  @     c->entry[s].i == \old(c->entry[s].i);
  @ ensures j: \forall integer s; 0 <= s < c->slots ==>
  @     c->entry[s].j == \old(c->entry[s].j);
  @*/
static void heap_put(brink_calendar *c, uint32_t position, uint32_t slot);

/*@ requires is_in_memory(c);
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
