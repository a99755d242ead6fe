(* with: numbers.v *)
(* refutes: two_sum_is_exact *)
(* SPDX-License-Identifier: MIT *)
(* 1 + 2^-60 becomes 1 and -2^-60. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Brink Require Import exact numbers.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of two_sum_is_exact in exact (T -> False)).
Proof.
intro H; set (w := pow (-60)); assert (W : w = / 1152921504606846976) by (unfold w; simpl; lra).
destruct (numbers.exact 0 0 0) as [_ Z]; [simpl; lra | lia | lia |].
destruct (numbers.exact 1 1 0) as [D1 One]; [simpl; lra | lia | lia |].
destruct (numbers.exact w 1 (-60)) as [Dw _]; [unfold w; ring | lia | lia |].
destruct (numbers.exact (- w) (-1) (-60)) as [_ Ew]; [unfold w; ring | lia | lia |].
change (FLT_exp (-1074) 53) with (FLT_exp emin prec) in *.
assert (S : rnd (1 + w) = 1) by (apply beside_1; [reflexivity | rewrite W; simpl; lra]).
specialize (H 1 w D1 Dw); unfold two_sum, plus, minus in H; cbn [hi lo] in H; cbv zeta in H.
rewrite S, Rminus_eq_0, Z, Rminus_0_r, One, Rminus_eq_0, Z, Rminus_0_l, Ew, Rplus_0_l, Ew in H.
lra.
Qed.
