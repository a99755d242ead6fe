(* with: numbers.v *)
(* refutes: told_in_lane_is_nearest *)
(* SPDX-License-Identifier: MIT *)
(* 1 and 2^-26 less than half an ulp, of what is 2^-27 more than half an ulp. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Brink Require Import exact numbers.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of told_in_lane_is_nearest in exact (T -> False)).
Proof.
intro H; set (y := pow (-53) - pow (-79)); set (z := 1 + pow (-53) + pow (-80)).
destruct (numbers.exact 0 0 0) as [_ Z]; [simpl; lra | lia | lia |].
destruct (numbers.exact 1 1 0) as [D1 _]; [simpl; lra | lia | lia |].
destruct (numbers.exact y (2 ^ 26 - 1) (-79)) as [Dy Ey]; [unfold y; simpl; lra | lia | lia |].
change (FLT_exp (-1074) 53) with (FLT_exp emin prec) in *.
assert (S : rnd (1 + y) = 1) by (apply beside_1; [reflexivity | unfold y; simpl; lra]).
assert (F : rnd (y * (1 + pow (-27)) + 1) = 1)
  by (apply beside_1; [reflexivity | unfold y; simpl; lra]).
assert (E : rnd z = 1 + pow (-52)).
{ replace (1 + pow (-52)) with (IZR (2 ^ 52 + 1) * pow (-52)) by (simpl; lra).
  apply rounds_to; [lia | reflexivity |]; right; split; [| lia].
  unfold z; simpl; lra. }
specialize (H 1 y z D1 Dy); rewrite E, S in H.
assert (1 + pow (-52) = 1); [| simpl in *; lra]; apply H.
- rewrite !Rabs_pos_eq; unfold y; simpl; lra.
- unfold is_told_in_lane, plus, minus, fma; cbv zeta.
  rewrite S, Rminus_eq_0, Z, Rminus_0_r, Ey; exact F.
- replace (1 + y - z) with (- (pow (-79) + pow (-80))) by (unfold y, z; ring).
  rewrite Rabs_Ropp, !Rabs_pos_eq; simpl; lra.
Qed.
