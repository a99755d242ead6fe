(* refutes: rounded_is_nearest *)
(* SPDX-License-Identifier: MIT *)
(* y is 1/2 - 2^-44 and t 1/2 + 2^-44, which is nearest to 1. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Brink Require Import root.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of rounded_is_nearest in exact (T -> False)).
Proof.
intro H; set (w := pow (-44)); assert (W : w = / 17592186044416) by (unfold w; simpl; lra).
specialize (H (/ 2 + w) (/ 2 - w)).
assert (M : m (/ 2 - w) = 0%Z) by (apply Zfloor_imp; simpl; lra).
assert (B : below (/ 2 - w) = 2147483647%Z).
{ unfold below; rewrite M; apply Zfloor_imp; simpl; rewrite W; lra. }
assert (T : ZnearestE (/ 2 + w) = 1%Z) by (apply Znearest_imp, Rabs_def1; simpl; lra).
rewrite T in H; unfold rounded, away in H; rewrite B, M in H.
assert (F : 0%Z = 1%Z); [apply H | discriminate].
replace (/ 2 + w - (/ 2 - w)) with (2 * w) by ring.
rewrite Rabs_pos_eq by lra; rewrite W; simpl; lra.
Qed.
