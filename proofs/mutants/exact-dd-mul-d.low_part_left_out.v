(* with: computed.v *)
(* refutes: dd_mul_d_is_close *)
(* SPDX-License-Identifier: MIT *)
(* (1 + 2^-52)^2, without its last 2^-104. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import exact computed.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of dd_mul_d_is_close in exact (T -> False)).
Proof.
set (h := 1 + pow (-52)); assert (D : is_double h) by (unfold h; written).
intro H; specialize (H (Dd h 0) h D D); unfold dd_mul_d, two_prod, fast_two_sum, plus, minus, mult,
  fma in H; cbv zeta in H; cbn [hi lo] in H; unfold h in H.
enough (F : 1 + pow (-51) + pow (-104) <= 1 + pow (-51)) by (simpl in F; lra).
work_out_in H; simpl; lra.
Qed.
