// SPDX-License-Identifier: MIT
/**
 * Numbers that decrease: what a potential's distances do.
 */
/*@ predicate decreases(double *d, integer n) =
  @     \forall integer i; 0 < i < n ==> d[i] < d[i - 1];
  @ lemma of_none: \forall double *d, integer n; n <= 1 ==> decreases(d, n);
  @ lemma of_one_more: \forall double *d, integer n;
  @     decreases(d, n) && d[n] < d[n - 1] ==> decreases(d, n + 1);
  @*/
