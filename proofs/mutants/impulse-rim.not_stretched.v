(* refutes: rim_keeps_energy *)
(* SPDX-License-Identifier: MIT *)
(* Masses 2, r = (1, 0, 0), v = (0, 1, 0): turned without being shortened it is faster. *)
From Coq Require Import Reals Lra.
From Brink Require Import event_time impulse.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of rim_keeps_energy in exact (T -> False)).
Proof.
intro H; set (r := Vector 1 0 0); set (v := Vector 0 1 0); set (o := Vector 0 0 0).
assert (R : rr r = 1) by (unfold rr, dot; simpl; lra).
assert (M : rim r v o = / 16777216).
{ unfold rim; rewrite R; replace (1 * dot (sub v o) (sub v o)) with 1
    by (unfold dot, sub, add, times; simpl; lra).
  rewrite sqrt_1; unfold angle; replace (2 ^ 24) with 16777216 by ring; lra. }
destruct (H r 2 2 ltac:(lra) ltac:(lra) ltac:(lra) 1 (or_introl eq_refl) v o) as (_ & _ & F & _).
- rewrite M; replace (dot r (sub v o)) with 0 by (unfold dot, sub, add, times; simpl; lra).
  rewrite Rabs_R0; lra.
- unfold rim_change, kick1, kick2, k1, k2, stretch in F; rewrite M, R in F.
  unfold dot, sub, add, times in F; simpl in F; lra.
Qed.
