(* refutes: rim_keeps_energy *)
(* SPDX-License-Identifier: MIT *)
(* A pair of velocity 1 at its closest approach is given 2^-24 inward beside it. *)
From Coq Require Import Reals Lra.
From Brink Require Import event_time impulse.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of rim_keeps_energy in exact (T -> False)).
Proof.
intro H; specialize (H (Vector 1 0 0) 1 1 ltac:(lra) ltac:(lra)).
assert (A : 0 < angle) by (unfold angle; apply Rinv_0_lt_compat, pow_lt; lra).
assert (R : rim (Vector 1 0 0) (Vector 0 1 0) (Vector 0 0 0) = angle).
{ unfold rim, rr, dot, sub, add, times; cbn [x1 x2 x3].
  match goal with |- sqrt ?x * _ = _ => replace x with 1 by ring end.
  rewrite sqrt_1; ring. }
assert (W : rim_change (Vector 1 0 0) (Vector 0 1 0) (Vector 0 0 0) = Vector (- angle) 0 0).
{ unfold rim_change; rewrite R; unfold rr, stretch, dot, sub, add, times; cbn [x1 x2 x3].
  f_equal; field. }
destruct (H ltac:(unfold rr, dot; cbn [x1 x2 x3]; lra) 1 (or_introl eq_refl) (Vector 0 1 0)
  (Vector 0 0 0)) as (_ & _ & E & _).
- rewrite R; unfold dot, sub, add, times; cbn [x1 x2 x3]; rewrite Rabs_pos_eq; lra.
- rewrite W in E.
  assert (K : sub (kick1 1 1 (Vector (- angle) 0 0) (Vector 0 1 0))
    (kick2 1 1 (Vector (- angle) 0 0) (Vector 0 0 0)) = Vector (- angle) 1 0).
  { unfold kick1, kick2, k1, k2, sub, add, times; cbn [x1 x2 x3]; f_equal; field. }
  rewrite K in E; unfold dot, sub, add, times in E; cbn [x1 x2 x3] in E.
  assert (0 < angle * angle) by (apply Rmult_lt_0_compat; exact A); lra.
Qed.
