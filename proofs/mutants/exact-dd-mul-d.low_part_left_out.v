(* with: numbers.v *)
(* refutes: dd_mul_d_is_close *)
(* SPDX-License-Identifier: MIT *)
(* (1 + 2^-52)^2, without its last 2^-104. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Brink Require Import exact numbers.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of dd_mul_d_is_close in exact (T -> False)).
Proof.
intro H; set (h := 1 + pow (-52)); set (p := 1 + pow (-51)).
assert (N : h = 4503599627370497 / 4503599627370496) by (unfold h; simpl; lra).
assert (Np : p = 2251799813685249 / 2251799813685248) by (unfold p; simpl; lra).
destruct (numbers.exact 0 0 0) as [_ Z]; [simpl; lra | lia | lia |].
destruct (numbers.exact h (2 ^ 52 + 1) (-52)) as [Dh _]; [unfold h; simpl; lra | lia | lia |].
destruct (numbers.exact p (2 ^ 51 + 1) (-51)) as [_ Ep]; [unfold p; simpl; lra | lia | lia |].
change (FLT_exp (-1074) 53) with (FLT_exp emin prec) in *.
assert (S : rnd (h * h) = p).
{ replace p with (IZR (2 ^ 52 + 2) * pow (-52)) by (unfold p; simpl; lra).
  apply rounds_to; [lia | reflexivity |]; left; rewrite N; simpl; lra. }
specialize (H (Dd h 0) h Dh Dh); cbn [hi lo] in H.
unfold dd_mul_d, two_prod, fast_two_sum, plus, minus, mult in H; cbn [hi lo] in H; cbv zeta in H.
cbn [hi lo] in H.
rewrite S, Rmult_0_l, Z, Rplus_0_r, Ep, Rminus_eq_0, Z, Rminus_0_r, Z, !Rplus_0_r, Rabs_R0 in H.
assert (Rabs (p - h * h) <= pow (-105) * Rabs (h * h)).
{ apply H; [apply Rmult_le_pos; [apply bpow_ge_0 | apply Rabs_pos] |].
  apply Rle_trans with 1; [change 1 with (pow 0); apply bpow_le; lia |].
  rewrite Rabs_pos_eq; rewrite N; lra. }
rewrite Rabs_minus_sym, !Rabs_pos_eq in H0 by (rewrite ?Np, ?N; lra).
rewrite Np, N in H0; simpl in H0; lra.
Qed.
