(* refutes: payment_pays *)
(* SPDX-License-Identifier: MIT *)
(* Masses 2, so mu = 1: a speed of 1 becomes 1 + 2^-22, and half of what is owed is paid. *)
From Coq Require Import Reals Lra.
From Brink Require Import event_time impulse.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of payment_pays in exact (T -> False)).
Proof.
intro H; set (r := Vector 1 0 0); assert (R : rr r = 1) by (unfold rr, dot; simpl; lra).
assert (M : mu 2 2 = 1) by (unfold mu, k1; lra).
set (x := 1 + / 4194304); set (owed := x * x - 1).
assert (G : gain r 2 2 owed = x * x - 1) by (unfold gain; rewrite R, M; unfold owed; field).
destruct (H r 2 2 ltac:(lra) ltac:(lra) ltac:(lra) owed 1 ltac:(lra)) as [F _].
- unfold is_paid; rewrite G, Rabs_pos_eq by (unfold x; lra).
  unfold x; replace (2 ^ 20) with 1048576 by ring; lra.
- assert (P : payment r 2 2 owed 1 = x - 1).
  { unfold payment; rewrite G; replace (1 * 1 + (x * x - 1)) with (x * x) by ring.
    rewrite sqrt_square by (unfold x; lra); unfold x; field. }
  unfold radial_energy in F; rewrite P, R, M in F; unfold owed, x in F; lra.
Qed.
