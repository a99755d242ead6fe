// SPDX-License-Identifier: MIT
/**
 * Where the entries are the same, so is the order: what heap_put is proved by.
 * Proved in calendar_heap_wp.c.
 */

/*@ lemma same_order_of_same_entries{A, B}: \forall brink_calendar *c;
  @     same_entries{A, B}(c) ==> same_order(heap_of{A}(c), heap_of{B}(c));
  @*/
