// SPDX-License-Identifier: MIT
#include "../sim/calendar.h"
#include "libm_wp.h"
#include "calendar_heap_wp.h"

/*@ predicate is_calendar(brink_calendar *c) =
  @     \valid(c) && c->slots < 0x80000000 && c->heap_count <= c->slots &&
  @     c->days <= 0x40000000 &&
  @     \valid_read(c->entry + (0 .. c->slots - 1)) &&
  @     \valid(c->filed + (0 .. c->slots)) &&
  @     \valid(c->heap + (0 .. c->slots - 1)) &&
  @     \valid(c->first + (0 .. c->days)) &&
  @     \separated(c, c->entry + (0 .. c->slots - 1), c->filed + (0 .. c->slots),
  @                c->heap + (0 .. c->slots - 1), c->first + (0 .. c->days));
  @ predicate has_times(brink_calendar *c) =
  @     \forall integer s; 0 <= s < c->slots ==>
  @         \is_finite(c->entry[s].when.offset);
  @
  @ predicate instant_before(brink_instant a, brink_instant b) =
  @     a.epoch != b.epoch ? a.epoch < b.epoch : a.offset < b.offset;
  @ predicate entry_before{L}(brink_entry *a, brink_entry *b) =
  @     instant_before(a->when, b->when) ||
  @     !instant_before(b->when, a->when) &&
  @     (a->kind != b->kind ? a->kind < b->kind :
  @      a->i != b->i ? a->i < b->i : a->j < b->j);
  @
  @ axiomatic HeapOf {
  @   logic heap heap_of{L}(brink_calendar *c)
  @     reads *c, c->heap[..], c->filed[..], c->entry[..];
  @   axiom its_slots{L}: \forall brink_calendar *c;
  @     slots(heap_of{L}(c)) == c->slots;
  @   axiom its_count{L}: \forall brink_calendar *c;
  @     count(heap_of{L}(c)) == c->heap_count;
  @   axiom its_at{L}: \forall brink_calendar *c, integer p;
  @     at(heap_of{L}(c), p) == c->heap[p];
  @   axiom its_place{L}: \forall brink_calendar *c, integer s;
  @     place(heap_of{L}(c), s) == c->filed[s].place;
  @   axiom its_order{L}: \forall brink_calendar *c, integer x, y;
  @     before(heap_of{L}(c), x, y) <==>
  @       entry_before(c->entry + x, c->entry + y) ||
  @       !entry_before(c->entry + y, c->entry + x) && x < y;
  @ }
  @ lemma in_order{L}: \forall brink_calendar *c; has_an_order(heap_of{L}(c));
  @
  @ predicate a_hole_moved{Old, New}(brink_calendar *c, integer before,
  @                                  integer hole, integer slot) =
  @     is_calendar{New}(c) && has_times{New}(c) &&
  @     has_hole(heap_of{New}(c), hole, slot) &&
  @     has_become(heap_of{Old}(c), heap_of{New}(c), before, hole, -1);
  @*/

/*@ requires \is_finite(a.offset) && \is_finite(b.offset);
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \result < 0 <==> instant_before(a, b);
  @ ensures \result > 0 <==> instant_before(b, a);
  @*/
static inline int brink_instant_compare(brink_instant a, brink_instant b);

/*@ requires \valid_read(a) && \valid_read(b);
  @ requires \is_finite(a->when.offset) && \is_finite(b->when.offset);
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \result < 0 <==> entry_before(a, b);
  @ ensures \result > 0 <==> entry_before(b, a);
  @*/
int brink_entry_compare(const brink_entry *a, const brink_entry *b);

/*@ requires is_calendar(c) && has_times(c);
  @ requires a < c->slots && b < c->slots;
  @ terminates \true;
  @ exits \false;
  @ assigns \nothing;
  @ ensures \result == 0 || \result == 1;
  @ ensures \result != 0 <==> before(heap_of(c), a, b);
  @*/
static int earlier(const brink_calendar *c, uint32_t a, uint32_t b);

/*@ requires is_calendar(c);
  @ requires position < c->slots && slot < c->slots;
  @ terminates \true;
  @ exits \false;
  @ assigns c->heap[position], c->filed[slot].place;
  @ ensures whole: is_calendar(c);
  @ ensures put: is_put(heap_of{Pre}(c), heap_of{Post}(c), position, slot);
  @*/
static void heap_put(brink_calendar *c, uint32_t position, uint32_t slot);

/*@ requires is_calendar(c) && has_times(c);
  @ requires has_hole(heap_of(c), position, slot);
  @ terminates \true;
  @ exits \false;
  @ ensures index: is_indexed(heap_of(c), -1);
  @ ensures order: is_ordered(heap_of(c), -1);
  @ ensures put_in: in_heap(heap_of(c), -1, slot);
  @ ensures none_lost: has_become(heap_of{Pre}(c), heap_of{Post}(c), \at(position, Pre), -1, slot);
  @*/
static void heap_settle(brink_calendar *c, uint32_t position, uint32_t slot);

#include "../sim/calendar.c"
