(* with: computed.v *)
(* refutes: two_sum_is_exact *)
(* SPDX-License-Identifier: MIT *)
(* 1 + 2^-60 becomes 1 and -2^-60. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import exact computed.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of two_sum_is_exact in exact (T -> False)).
Proof.
intro H; specialize (H 1 (pow (-60)) ltac:(written) ltac:(written)).
unfold two_sum, plus, minus in H; cbv zeta in H; cbn [hi lo] in H; work_out_in H; lra.
Qed.
