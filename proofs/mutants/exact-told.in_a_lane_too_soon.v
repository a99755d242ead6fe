(* with: computed.v *)
(* refutes: told_in_lane_is_nearest *)
(* SPDX-License-Identifier: MIT *)
(* 1 and 2^-26 less than half an ulp, of what is 2^-27 more than half an ulp. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import exact computed.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of told_in_lane_is_nearest in exact (T -> False)).
Proof.
set (y := pow (-53) - pow (-79)); set (z := 1 + pow (-53) + pow (-80)).
intro H; assert (N : rnd z = rnd (1 + y)); [| unfold z, y in N; work_out_in N; lra].
apply H; unfold is_told_in_lane, plus, minus, fma, z, y; cbv zeta.
- written.
- written.
- work_out; lra.
- work_out; lra.
- work_out; lra.
Qed.
