(* with: numbers.v *)
(* refutes: later_root_inside *)
(* SPDX-License-Identifier: MIT *)
(* t^2 + 2 t - 3: the later root is 1, and 3 by the other branch. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Brink Require Import rounding event_time_near numbers.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of later_root_inside in exact (T -> False)).
Proof.
intro H; assert (P : forall x m, x = IZR m -> (Z.abs m < 2 ^ 53)%Z -> rnd x = x).
{ intros x m -> L; apply exact_unbounded with m 0%Z; [simpl; ring | exact L]. }
assert (E1 : rnd 1 = 1) by (apply (P _ 1%Z); [lra | lia]).
assert (E2 : rnd 2 = 2) by (apply (P _ 2%Z); [lra | lia]).
assert (E3 : rnd 3 = 3) by (apply (P _ 3%Z); [lra | lia]).
assert (E4 : rnd 4 = 4) by (apply (P _ 4%Z); [lra | lia]).
assert (S : sqrt 4 = 2) by (replace 4 with (2 * 2) by ring; apply sqrt_square; lra).
specialize (H 1 1 (-3) 0 1 1 (-3)); cbv zeta in H; unfold near_root, near_d in H.
rewrite E1 in H; replace (1 * 1 - 1 * -3) with 4 in H by ring.
replace (rnd (1 * 1)) with 1 in H by (rewrite Rmult_1_l; symmetry; exact E1).
replace (1 - 1 * -3) with 4 in H by ring; rewrite E4, S, E2, (Rabs_pos_eq 1) in H by lra.
replace (2 + 1) with 3 in H by ring; rewrite E3 in H; destruct (Rlt_dec 1 0); [lra |].
replace (3 / 1) with 3 in H by field; rewrite E3 in H.
replace (3 - (2 - 1) / 1) with 2 in H by field; rewrite (Rabs_pos_eq 2) in H by lra.
assert (2 <= 8 * u * ((2 - 1) / 1)); [| unfold u in *; lra].
apply H; try lra.
- rewrite Rminus_eq_0, Rabs_R0; unfold tiny, u; lra.
- rewrite Rminus_eq_0, Rabs_R0; lra.
- rewrite Rminus_eq_0, Rabs_R0; unfold u; generalize (Rabs_pos (-3)); lra.
Qed.
