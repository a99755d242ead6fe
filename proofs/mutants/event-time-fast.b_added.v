(* with: computed.v *)
(* refutes: along_close *)
(* SPDX-License-Identifier: MIT *)
(* r = (2, 0, 0), v = (1, 0, 0): at t = 3 the pair is 5 along, not 1. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding event_time_sums event_time_path computed.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of along_close in exact (T -> False)).
Proof.
intro H; specialize (H 2 0 0 1 0 0 ltac:(lra) 1 1 (or_introl eq_refl) ltac:(lra)).
assert (V1 : len 1 0 0 = 1).
{ unfold len; replace (1 * 1 + 0 * 0 + 0 * 0) with 1 by ring; apply sqrt_1. }
assert (R2 : len 2 0 0 = 2).
{ unfold len; replace (2 * 2 + 0 * 0 + 0 * 0) with (2 * 2) by ring; apply sqrt_square; lra. }
rewrite V1, R2 in H; unfold dot_rounded, rnd in H; destruct H as [_ F]; [work_out; lra |].
work_out_in F; unfold u in F; lra.
Qed.
