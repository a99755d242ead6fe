(* refutes: intersection_time_is_right *)
(* SPDX-License-Identifier: MIT *)
(* r = (2, 0, 0), v = (-1, 0, 0), sigma = 1: at 3 it leaves. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Brink Require Import event_time.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of intersection_time_is_right in exact (T -> False)).
Proof.
intro H; specialize (H (Vector 2 0 0) (Vector (-1) 0 0) 1).
set (r := Vector 2 0 0) in *; set (v := Vector (-1) 0 0) in *.
assert (b r v = -2 /\ d r v 1 = 1 /\ c r 1 = 3) as (B & D & C)
  by (unfold d, a, b, c, dot; simpl; lra).
unfold intersection_time in H; rewrite B, C, D, sqrt_1 in H.
destruct (Rle_dec 0 (-2)); [lra |]; destruct (Rle_dec 3 0); [lra |].
destruct (Rle_dec 1 0); [lra |]; destruct H as (_ & (_ & H) & _).
rewrite rate_is_derivative in H.
replace (- (3) / (1 + -2)) with 3 in H by field.
unfold ball_overlap_rate, at_time, add, times, dot, r, v in H; simpl in H; lra.
Qed.
