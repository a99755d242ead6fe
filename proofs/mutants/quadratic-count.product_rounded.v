(* with: numbers.v *)
(* refutes: is_rootless_is_exact *)
(* SPDX-License-Identifier: MIT *)
(* h = a = c = 1 + 2^-52: h^2 is not less than a c. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Brink Require Import exact quadratic numbers.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of is_rootless_is_exact in exact (T -> False)).
Proof.
intro H; set (h := 1 + pow (-52)); set (p := 1 + pow (-51)).
assert (N : h = 4503599627370497 / 4503599627370496) by (unfold h; simpl; lra).
assert (Np : p = 2251799813685249 / 2251799813685248) by (unfold p; simpl; lra).
assert (R : h * h - p = pow (-104)) by (rewrite N, Np; simpl; lra).
destruct (numbers.exact 0 0 0) as [_ Z]; [simpl; lra | lia | lia |].
destruct (numbers.exact h (2 ^ 52 + 1) (-52)) as [Dh _]; [unfold h; simpl; lra | lia | lia |].
destruct (numbers.exact (pow (-104)) 1 (-104)) as [_ El]; [ring | lia | lia |].
change (FLT_exp (-1074) 53) with (FLT_exp emin prec) in *.
assert (S : rnd (h * h) = p).
{ replace p with (IZR (2 ^ 52 + 2) * pow (-52)) by (unfold p; simpl; lra).
  apply rounds_to; [lia | reflexivity |]; left; rewrite N; simpl; lra. }
assert (L : pow (-960) <= h * h).
{ apply Rle_trans with 1; [change 1 with (pow 0); apply bpow_le; lia | rewrite N; lra]. }
assert (P := bpow_gt_0 radix2 (-104)).
destruct (H h h h Dh Dh Dh) as [F _].
- right; rewrite Rabs_pos_eq; [exact L | apply Rle_trans with (2 := L), bpow_ge_0].
- unfold two_prod, mult, fma in F; cbn [hi lo] in F; cbv zeta in F; cbn [hi lo] in F.
  rewrite S, Rminus_eq_0, Z in F; change (h * h + - p) with (h * h - p) in F.
  rewrite R, El in F; specialize (F P); lra.
Qed.
