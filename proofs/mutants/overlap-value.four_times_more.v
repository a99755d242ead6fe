(* with: computed.v *)
(* refutes: precise_is_within_1_ulp *)
(* SPDX-License-Identifier: MIT *)
(* f = 1 - 8u - 5/16 u is estimated as 1 - 8u + 10/16 u and rounded to 1 - 7u. *)
From Coq Require Import Reals ZArith Lra.
From Flocq Require Import Core.
From Brink Require Import rounding overlap_estimate overlap_value computed.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of precise_is_within_1_ulp in exact (T -> False)).
Proof.
set (v := pow (-53)); set (w := 1 - 8 * v + 10 * pow (-57)); set (f := 1 - 8 * v - 5 * pow (-57)).
assert (F : f = 1 - 8 * v - 5 / 16 * v /\ v = u) by (unfold f, v, u; simpl; lra).
assert (R : rnd w = 1 - 7 * u) by (unfold rnd, w, v, u; work_out; lra).
assert (U : ulp f = u).
{ rewrite ulp_neq_0 by (unfold u in F; lra); unfold cexp; rewrite (mag_unique _ _ 0).
  - unfold u; simpl; lra.
  - rewrite Rabs_pos_eq by (unfold u in F; lra); unfold u in F; simpl; lra. }
intro H; specialize (H w f (pow 45 - pow (-5)) 0); rewrite R, U in H.
assert (N : Rabs (1 - 7 * u - f) <= u).
{ apply H.
  - simpl; lra.
  - lra.
  - unfold w, f, v, pow98; work_out; lra.
  - unfold precise_from, pow43, rnd, u.
    match goal with |- context [round _ _ _ ?number] =>
      replace number with (1 - pow (-50)) by (simpl; lra) end.
    work_out; lra. }
apply Rabs_le_inv in N; unfold u in *; lra.
Qed.
