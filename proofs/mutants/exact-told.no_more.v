(* with: computed.v *)
(* refutes: told_is_nearest *)
(* SPDX-License-Identifier: MIT *)
(* 1 and a little less than half an ulp stand for a little more. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import exact computed.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of told_is_nearest in exact (T -> False)).
Proof.
set (l := pow (-53) - pow (-73)); set (x := 1 + l + pow (-71)).
intro H; assert (N : rnd x = 1); [| unfold x, l in N; work_out_in N; lra].
apply (H (Dd 1 l)); unfold is_told, plus; cbn [hi lo].
- written.
- unfold l; work_out; lra.
- unfold x, l; work_out; lra.
Qed.
