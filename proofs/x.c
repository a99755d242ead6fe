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
  @ predicate knows_slots(brink_calendar *c) =
  @     \forall integer p; 0 <= p < c->slots ==> c->heap[p] < c->slots;
  @ predicate has_times(brink_calendar *c) =
  @     \forall integer s; 0 <= s < c->slots ==>
  @         \is_finite(c->entry[s].when.offset);
  @
  @ predicate instant_before(brink_instant a, brink_instant b) =
  @     a.epoch != b.epoch ? a.epoch < b.epoch : a.offset < b.offset;
  @ predicate kind_before{L}(brink_entry *a, brink_entry *b) =
  @     a->kind != b->kind ? a->kind < b->kind
  @     : a->i != b->i     ? a->i < b->i
  @                        : a->j < b->j;
  @ predicate entry_before{L}(brink_entry *a, brink_entry *b) =
  @     instant_before(a->when, b->when) ||
  @     !instant_before(b->when, a->when) && kind_before(a, b);
  @ predicate slot_before{L}(brink_calendar *c, integer x, integer y) =
  @     entry_before(c->entry + x, c->entry + y) ||
  @     !entry_before(c->entry + y, c->entry + x) && x < y;
  @
  @ predicate is_heap_of{L}(heap h, brink_calendar *c) =
  @     slots(h) == c->slots && count(h) == c->heap_count &&
  @     (\forall integer p; at(h, p) == c->heap[p]) &&
  @     (\forall integer s; place(h, s) == c->filed[s].place) &&
  @     (\forall integer x, y; before(h, x, y) <==> slot_before{L}(c, x, y));
  @
  @ axiomatic HeapOf {
  @   logic heap heap_of{L}(brink_calendar *c)
  @     reads *c, c->heap[..], c->filed[..], c->entry[..];
  @   axiom it_is{L}: \forall brink_calendar *c; is_heap_of{L}(heap_of{L}(c), c);
  @ }
  @
  @ lemma o1: \forall brink_instant a, b; instant_before(a,b) ==> !instant_before(b,a);
  @ lemma o2: \forall brink_instant a, b, c; !instant_before(b,a) && !instant_before(c,b)==> !instant_before(c,a);
  @ lemma o3{L}: \forall brink_entry *a, *b; kind_before(a,b) ==> !kind_before(b,a);
  @ lemma o4{L}: \forall brink_entry *a, *b, *c; !kind_before(b,a) && !kind_before(c,b)==> !kind_before(c,a);
  @ lemma o5{L}: \forall brink_entry *a, *b; entry_before(a,b) ==> !entry_before(b,a);
  @ lemma o6{L}: \forall brink_entry *a, *b, *c; !entry_before(b,a) && !entry_before(c,b)==> !entry_before(c,a);
  @ lemma o7{L}: \forall brink_calendar *c, integer x, y; slot_before(c,x,y) ==> !slot_before(c,y,x);
  @ lemma o8{L}: \forall brink_calendar *c, integer x, y, z; !slot_before(c,y,x) && !slot_before(c,z,y)==> !slot_before(c,z,x);
  @ lemma in_order{L}: \forall brink_calendar *c; has_an_order(heap_of{L}(c));
  @
  @ predicate same_entry{A, B}(brink_entry *e, brink_entry *f) =
  @     \at(e->when, A) == \at(f->when, B) && \at(e->kind, A) == \at(f->kind, B) &&
  @     \at(e->i, A) == \at(f->i, B) && \at(e->j, A) == \at(f->j, B);
  @ predicate same_entries{A, B}(brink_calendar *c) =
  @     \at(c->slots, A) == \at(c->slots, B) &&
  @     \at(c->heap_count, A) == \at(c->heap_count, B) &&
  @     \forall integer s; 0 <= s < \at(c->slots, A) ==>
  @         same_entry{A, B}(\at(c->entry, A) + s, \at(c->entry, B) + s);
  @ lemma o9{A, B}: \forall brink_entry *e, *f, *g, *h; same_entry{A,B}(e, g) && same_entry{A,B}(f, h) ==> (entry_before{A}(e,f) <==> entry_before{B}(g,h));
  @ lemma o10{A, B}: \forall brink_calendar *c, integer x, y; same_entries{A,B}(c) && 0 <= x < \at(c->slots,A) && 0 <= y < \at(c->slots,A) ==> (slot_before{A}(c,x,y) <==> slot_before{B}(c,x,y));
  @ lemma same_entries_same_order{A, B}: \forall brink_calendar *c;
  @     same_entries{A, B}(c) ==> same_order(heap_of{A}(c), heap_of{B}(c));
  @
  @ predicate a_hole_moved{Old, New}(brink_calendar *c, integer before,
  @                                  integer hole, integer slot) =
  @     is_calendar{New}(c) && has_times{New}(c) && knows_slots{New}(c) &&
  @     0 <= hole < \at(c->heap_count, New) &&
  @     \at(c->heap_count, New) == \at(c->heap_count, Old) &&
  @     \at(c->slots, New) == \at(c->slots, Old) &&
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
  @ ensures slots: \old(knows_slots(c)) ==> knows_slots(c);
  @ ensures entries: same_entries{Pre, Post}(c);
  @ ensures put: same_entries{Pre, Post}(c) ==>
  @     is_put(heap_of{Pre}(c), heap_of{Post}(c), position, slot);
  @ ensures moved: same_entries{Pre, Post}(c) ==> \forall integer from;
  @     0 <= from < c->heap_count && from != position &&
  @     \old(c->heap[from]) == slot ==>
  @     is_moved(heap_of{Pre}(c), heap_of{Post}(c), position, from);
  @*/
static void heap_put(brink_calendar *c, uint32_t position, uint32_t slot);

/*@ requires is_calendar(c) && has_times(c) && knows_slots(c);
  @ requires position < c->heap_count && slot < c->slots;
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
