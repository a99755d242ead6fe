(* with: numbers.v *)
(* refutes: dot *)
(* SPDX-License-Identifier: MIT *)
(* r.v = 1 + 2^-60 becomes 1. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Brink Require Import rounding overlap_estimate overlap_value numbers.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of dot in exact (T -> False)).
Proof.
intro H; set (w := pow (-60)); assert (W : w = / 1152921504606846976) by (unfold w; simpl; lra).
assert (Z : rnd 0 = 0) by (apply exact_unbounded with 0%Z 0%Z; [simpl; lra | lia]).
assert (One : rnd 1 = 1) by (apply exact_unbounded with 1%Z 0%Z; [simpl; lra | lia]).
assert (E : rnd w = w) by (apply exact_unbounded with 1%Z (-60)%Z; [unfold w; ring | lia]).
assert (S : rnd (1 + w) = 1) by (apply beside_1; [reflexivity | rewrite W; simpl; lra]).
specialize (H 1 w 0 1 1 1).
unfold dot_parts, dot_size, two_prod, gather, total, low in H; cbn [fst snd] in H.
rewrite !Rmult_1_r, One, E, Z, !Rminus_eq_0, Rmult_0_l, !Rplus_0_r, Z in H.
rewrite (Rabs_pos_eq 1), (Rabs_pos_eq w), Rabs_R0, !Rplus_0_r, S, ?Rmult_0_l in H
  by (rewrite ?W; lra).
rewrite ?Rplus_0_r, ?Rplus_0_l, ?One, ?Z, ?Rplus_0_r, ?Rplus_0_l, ?One, ?Z in H.
match type of H with Rabs ?e <= _ => replace e with (- w) in H by ring end.
rewrite Rabs_Ropp, Rabs_pos_eq in H by (rewrite W; lra); unfold pow98 in H; lra.
Qed.
