(* with: numbers.v *)
(* refutes: dd_add_d_is_close *)
(* SPDX-License-Identifier: MIT *)
(* 1 and 2^-60, added to 0, become 1. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Brink Require Import exact exact_dd numbers.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of dd_add_d_is_close in exact (T -> False)).
Proof.
intro H; set (w := pow (-60)); assert (W : w = / 1152921504606846976) by (unfold w; simpl; lra).
destruct (numbers.exact 0 0 0) as [D0 Z]; [simpl; lra | lia | lia |].
destruct (numbers.exact 1 1 0) as [D1 One]; [simpl; lra | lia | lia |].
destruct (numbers.exact w 1 (-60)) as [Dw _]; [unfold w; ring | lia | lia |].
change (FLT_exp (-1074) 53) with (FLT_exp emin prec) in *.
assert (U : ulp 1 = pow (-52))
  by (change 1 with (pow 0); rewrite ulp_bpow; reflexivity).
destruct (H (Dd 1 w) 0) as [_ F]; [| exact D0 |].
- split; [exact D1 |]; split; [exact Dw |]; cbn [hi lo].
  rewrite Rabs_pos_eq by (rewrite W; lra).
  rewrite U, W; simpl; lra.
- unfold total, dd_add_d, two_sum, fast_two_sum, plus, minus in F; cbn [hi lo] in F.
  cbv zeta in F; cbn [hi lo] in F.
  rewrite !Rplus_0_r, One, Rmult_0_l, Rminus_eq_0, Z, !Rminus_0_r, One, Rminus_eq_0, Z in F.
  rewrite ?Rplus_0_r, ?Rminus_0_r, ?Z, ?Rplus_0_r, ?One, ?Rminus_eq_0, ?Z, ?Rminus_0_r, ?Z in F.
  rewrite ?Rplus_0_r, ?One, ?Rminus_eq_0, ?Z, ?Rminus_0_r, ?Z, ?Rplus_0_r in F.
  replace (1 - (1 + w)) with (- w) in F by ring.
  rewrite Rabs_Ropp, (Rabs_pos_eq 1), Rabs_pos_eq in F by (rewrite ?W; lra).
  rewrite W in F; simpl in F; lra.
Qed.
