(* with: numbers.v *)
(* refutes: dot_of_error *)
(* SPDX-License-Identifier: MIT *)
(* 1 + 3/4 u and 3/8 u^2: what the first leaves takes the second with it. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Brink Require Import event_time_sums numbers.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of dot_of_error in exact (T -> False)).
Proof.
intro H; set (l := 3 / 4 * u); set (y := 3 / 8 * u * u); specialize (H (1 + l) y 0).
assert (Sizes : 0 < y < pow (-53) / 4 /\ 0 < l < pow (-53)) by (unfold y, l, u; simpl; lra).
assert (X : rnd (1 + l) = 1) by (apply beside_1; [reflexivity | lra]).
assert (S : rnd (1 + y) = 1) by (apply beside_1; [reflexivity | lra]).
assert (One : rnd 1 = 1) by (apply exact_unbounded with 1%Z 0%Z; [simpl; lra | lia]).
assert (Z : rnd 0 = 0) by (apply exact_unbounded with 0%Z 0%Z; [simpl; lra | lia]).
assert (Y : rnd y = y)
  by (apply exact_unbounded with 3%Z (-109)%Z; [unfold y, u; simpl; lra | lia]).
assert (L : rnd l = l)
  by (apply exact_unbounded with 3%Z (-55)%Z; [unfold l, u; simpl; lra | lia]).
assert (F : rnd (l + y) = l).
{ assert (E : l = IZR (3 * 2 ^ 51) * pow (-106)) by (unfold l, u; simpl; lra).
  rewrite E at 2; apply rounds_to; [lia | reflexivity |].
  left; unfold y, l, u; simpl; lra. }
unfold dot_of, low in H; cbv zeta in H.
rewrite X, Y, Z, S in H; replace (1 + 0) with 1 in H by ring; rewrite One in H.
replace (1 + l - 1 + (y - y)) with l in H by ring; rewrite L in H.
replace (l + (0 - 0)) with l in H by ring; rewrite L in H.
replace (1 + y - 1 + (1 - 1)) with y in H by ring; rewrite Y, F in H.
replace (1 + l - (1 + l + y + 0)) with (- y) in H by ring.
rewrite Rabs_Ropp, Rabs_R0, !Rabs_pos_eq in H by lra.
unfold y, l, tiny, u in H; lra.
Qed.
