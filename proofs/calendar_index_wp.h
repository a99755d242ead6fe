// SPDX-License-Identifier: MIT
/**
 * The heap in memory and the places of its slots are each other's inverse.
 */

/*@ // The slots know their places, but for the position where there is a hole.
  @ predicate is_indexed(brink_calendar *c, integer hole) =
  @     \forall integer p; 0 <= p < c->heap_count && p != hole ==>
  @         c->heap[p] < c->slots && c->filed[c->heap[p]].place == p;
  @*/
