(* with: computed.v *)
(* refutes: roots_are_within_3_ulp *)
(* SPDX-License-Identifier: MIT *)
(* Of a x^2 - 2 h x + c, where nothing cancels, the later root is 2.24 ulp off. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Brink Require Import exact quadratic quadratic_sum quadratic_roots computed.
Open Scope R_scope.

Definition a := 4666034316553431 * pow (-51).
Definition h := 4227727239789537 * pow (-51).
Definition c := - 3457515121631815 * pow (-52).

Lemma discriminant_here : discriminant_of h (two_prod a c) = 2879931817226421 * pow (-49).
Proof.
unfold discriminant_of, two_prod, mult, fma, a, h, c; cbn [hi lo]; work_out.
rewrite Rmin_left, Rmax_right by lra; work_out; lra.
Qed.

Lemma root_here : 2607689924686207577 * pow (-60) <= sqrt (h * h - a * c) <=
  2607689924686207578 * pow (-60).
Proof.
split; apply Rsqr_incr_0_var; unfold Rsqr; rewrite ?sqrt_sqrt; try apply sqrt_pos;
  unfold a, h, c; simpl; lra.
Qed.

Lemma sum_here : sum_of h 1 (2879931817226421 * pow (-49)) = 582554476496393 * pow (-47).
Proof. unfold sum_of, h; work_out; lra. Qed.

Theorem is_false : ltac:(let T := type of roots_are_within_3_ulp in exact (T -> False)).
Proof.
intro H; destruct (H h a c 1) as [F _]; rewrite ?discriminant_here.
- apply few_bits; unfold emin; lia.
- apply few_bits; unfold emin; lia.
- apply few_bits; unfold emin; lia.
- unfold a; simpl; lra.
- left; reflexivity.
- unfold h; simpl; lra.
- apply Rle_trans with (pow 0); [apply bpow_le; lia | simpl; lra].
- rewrite discriminant_here, sum_here in F; unfold a in F at 1; work_out_in F.
  assert (R := root_here); set (r := sqrt (h * h - a * c)) in *; clearbody r.
  set (X := (h + 1 * r) / a) in *.
  assert (E : X * a = h + r) by (unfold X; field; unfold a; simpl; lra).
  assert (B : 1 <= X < 2 /\ 4498196018772683 * pow (-51) - X > 224 / 100 * pow (-52)).
  { unfold a, h in E; simpl in *; lra. }
  assert (U : ulp X = pow (-52)).
  { rewrite ulp_neq_0 by lra; unfold cexp; rewrite (mag_unique _ _ 1); [reflexivity |].
    rewrite Rabs_pos_eq by lra; simpl; lra. }
  rewrite U in F; apply Rabs_le_inv in F; simpl in *; lra.
Qed.
