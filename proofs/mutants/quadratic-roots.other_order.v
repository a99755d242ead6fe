(* with: computed.v *)
(* refutes: roots_are_within_3_ulp *)
(* SPDX-License-Identifier: MIT *)
(* a = 1, h = 1 + 2^-30 and c = 1 + 2^-29 - 2^-50: of d = 2^-50 + 2^-60 the second is lost. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Brink Require Import exact quadratic quadratic_sum quadratic_roots computed.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of roots_are_within_3_ulp in exact (T -> False)).
Proof.
set (h := 1 + pow (-30)); set (c := 1 + pow (-29) - pow (-50)).
assert (D : discriminant_of h (two_prod 1 c) = pow (-50)).
{ unfold discriminant_of, two_prod, mult, fma, h, c; cbn [hi lo]; work_out.
  rewrite Rmin_right, Rmax_left by lra; work_out; lra. }
intro H; destruct (H h 1 c 1) as [F _]; rewrite ?D.
- unfold h; written.
- written.
- unfold c; written.
- lra.
- left; reflexivity.
- unfold h; simpl; lra.
- apply bpow_le; lia.
- rewrite D in F; unfold sum_of in F; unfold h in F at 1; work_out_in F.
  assert (Root : pow (-25) + pow (-37) <= sqrt (h * h - 1 * c) <= pow (-25) + pow (-36)).
  { split; apply Rsqr_incr_0_var; unfold Rsqr; rewrite ?sqrt_sqrt; try apply sqrt_pos;
      unfold h, c; simpl; lra. }
  set (r := sqrt (h * h - 1 * c)) in *; clearbody r; set (S := h + 1 * r) in *.
  assert (B : 1 <= S < 2) by (unfold S, h; simpl in *; lra).
  assert (U : ulp (S / 1) = pow (-52)).
  { unfold Rdiv; rewrite Rinv_1, Rmult_1_r, ulp_neq_0 by lra; unfold cexp.
    rewrite (mag_unique _ _ 1); [reflexivity |]; rewrite Rabs_pos_eq by lra; simpl; lra. }
  rewrite U in F; apply Rabs_le_inv in F; unfold S, h in F; simpl in *; lra.
Qed.
