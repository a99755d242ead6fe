(* with: numbers.v *)
(* refutes: rest_error *)
(* SPDX-License-Identifier: MIT *)
(* a = 1 + u, b = 0, c = 1. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Brink Require Import rounding event_time_sums event_time_discriminant numbers.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of rest_error in exact (T -> False)).
Proof.
intro H; assert (Z : rnd 0 = 0) by (apply exact_unbounded with 0%Z 0%Z; [simpl; lra | lia]).
assert (One : rnd 1 = 1) by (apply exact_unbounded with 1%Z 0%Z; [simpl; lra | lia]).
specialize (H (1 + u) 0 1 0 1 1 u 0 0 1 0); unfold rest_of, low in H; cbv zeta in H.
replace (u * 0) with 0 in H by ring; replace (0 * 0) with 0 in H by ring.
replace (1 * 0) with 0 in H by ring; replace (1 * 1) with 1 in H by ring.
replace (2 * 0 * 0) with 0 in H by ring.
rewrite Z, One, ?Rplus_0_l, ?Rminus_0_r, ?Rminus_eq_0, ?Rplus_0_l, ?Z in H.
replace (0 - 0 - (1 - 1)) with 0 in H by ring; rewrite ?Z, ?Rminus_0_r, ?Rplus_0_l, ?Z in H.
destruct H as [H _]; unfold u in *; lra.
Qed.
