(* refutes: intersection_time_is_right *)
(* SPDX-License-Identifier: MIT *)
(* r = 0, v = 0, sigma = 1: inside, and nothing moves. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Brink Require Import event_time.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of intersection_time_is_right in exact (T -> False)).
Proof.
intro H; specialize (H (Vector 0 0 0) (Vector 0 0 0) 1); set (o := Vector 0 0 0) in *.
assert (b o o = 0 /\ c o 1 = -1) as (B & C) by (unfold b, c, dot; simpl; lra).
unfold intersection_time in H; rewrite B, C in H.
destruct (Rlt_dec 0 0); [lra |]; destruct (Rle_dec (-1) 0); [| lra].
destruct H as (_ & (_ & H) & _); rewrite rate_is_derivative in H.
unfold ball_overlap_rate, at_time, add, times, dot, o in H; simpl in H; lra.
Qed.
