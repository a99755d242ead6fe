(* with: numbers.v *)
(* refutes: grid_is_rounded_alike *)
(* SPDX-License-Identifier: MIT *)
(* One and a half of the smallest double. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Brink Require Import underflow numbers.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of grid_is_rounded_alike in exact (T -> False)).
Proof.
intro H; set (x := IZR 3 * pow (-1075)); specialize (H x (ex_intro _ 3%Z eq_refl)).
rewrite (exact_unbounded x 3 (-1075)) in H by (reflexivity || lia).
assert (D : is_double x)
  by (rewrite <- H; apply generic_format_round; typeclasses eauto).
apply FLT_format_generic in D; [| easy]; destruct D as [[m e] Q _ E]; cbn [Fnum Fexp] in *.
unfold x, F2R in Q; cbn [Fnum Fexp] in Q.
replace (pow e) with (pow (-1075) * pow (e + 1075)) in Q
  by (rewrite <- bpow_plus; f_equal; lia).
assert (P := bpow_gt_0 radix2 (-1075)); set (w := pow (-1075)) in *; clearbody w.
assert (Q' : IZR 3 = IZR (m * (2 * 2 ^ (e + 1074)))).
{ rewrite !mult_IZR, (IZR_Zpower radix2) by lia.
  replace (e + 1075)%Z with (1 + (e + 1074))%Z in Q by lia; rewrite bpow_plus in Q.
  change (pow 1) with 2 in Q; set (k := pow (e + 1074)) in *; clearbody k.
  apply Rmult_eq_reg_r with w; [| lra]; rewrite Q; ring. }
apply eq_IZR in Q'; lia.
Qed.
