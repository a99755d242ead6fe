(* refutes: crosses_if_energy_suffices *)
(* SPDX-License-Identifier: MIT *)
(* Masses 2, so mu = 1, and b = 1: an energy of 1/2 does not cross a rise of 3/4. *)
From Coq Require Import Reals Lra.
From Brink Require Import event_time impulse.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of crosses_if_energy_suffices in exact (T -> False)).
Proof.
intro H; set (r := Vector 1 0 0); assert (R : rr r = 1) by (unfold rr, dot; simpl; lra).
assert (M : mu 2 2 = 1) by (unfold mu, k1; lra).
destruct (H r 2 2 ltac:(lra) ltac:(lra) ltac:(lra) 1 (or_introl eq_refl) (3 / 4) 1) as [[E _] _].
unfold crosses, loss, radial_energy in E; rewrite R, M in E; lra.
Qed.
