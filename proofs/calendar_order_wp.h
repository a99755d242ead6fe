// SPDX-License-Identifier: MIT
/**
 * The one order of the calendar's slots: by time, kind, i and j of their entries,
 * and then by slot.  The offset of a time is compared as the real number it is.
 */

/*@ predicate instant_before(brink_instant a, brink_instant b) =
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
  @ // It is the order of heap_of: a definition, of what `before` is there.
  @ axiomatic OrderOfHeap {
  @   axiom its_order{L}: \forall brink_calendar *c, integer x, y;
  @       before(heap_of{L}(c), x, y) <==> slot_before{L}(c, x, y);
  @ }
  @*/
