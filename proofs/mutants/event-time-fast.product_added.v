(* with: computed.v *)
(* refutes: near_discriminant *)
(* SPDX-License-Identifier: MIT *)
(* sigma = 1, r = (7/8, 0, 0), v = (1, 0, 0): d is 17/32, not 1. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding event_time_sums event_time_path event_time_fast computed.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of near_discriminant in exact (T -> False)).
Proof.
intro H; specialize (H (7 / 8) 0 0 1 0 0 1 ltac:(lra) ltac:(lra)).
unfold dot_rounded, least_far, rnd in H; destruct H as [F _]; [work_out; lra | work_out; lra |].
work_out_in F; unfold u in F; lra.
Qed.
