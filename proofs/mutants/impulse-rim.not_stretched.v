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
assert (M : 0 < rim r v o).
{ unfold rim; rewrite R; replace (1 * dot (sub v o) (sub v o)) with 1
    by (unfold dot, sub, add, times; cbn [x1 x2 x3 r v o]; ring).
  rewrite sqrt_1, Rmult_1_l; apply Rinv_0_lt_compat, pow_lt; lra. }
destruct (H r 2 2 ltac:(lra) ltac:(lra) ltac:(lra) 1 (or_introl eq_refl) v o) as (_ & _ & F & _).
- replace (dot r (sub v o)) with 0 by (unfold dot, sub, add, times; cbn [x1 x2 x3 r v o]; ring).
  rewrite Rabs_R0; exact M.
- unfold rim_change, kick1, kick2, k1, k2, stretch in F; rewrite R in F.
  set (m := rim r v o) in *; clearbody m.
  unfold dot, sub, add, times in F; cbn [x1 x2 x3 r v o] in F.
  assert (0 < m * m) by (apply Rmult_lt_0_compat; exact M); lra.
Qed.
