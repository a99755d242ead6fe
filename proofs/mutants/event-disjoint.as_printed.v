(* refutes: disjoint_time_is_right *)
(* SPDX-License-Identifier: MIT *)
(* r = (2, 0, 0), v = (-1, 0, 0), sigma = 1 is told to part now, and is inside at 2. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Brink Require Import event_time.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of disjoint_time_is_right in exact (T -> False)).
Proof.
intro H; specialize (H (Vector 2 0 0) (Vector (-1) 0 0) 1).
set (r := Vector 2 0 0) in *; set (v := Vector (-1) 0 0) in *.
assert (a v = 1 /\ b r v = -2 /\ d r v 1 = 1 /\ c r 1 = 3) as (A & B & D & C)
  by (unfold d, a, b, c, dot; simpl; lra).
unfold disjoint_time in H; rewrite A, B, C, D, (Rmax_left 0 (- (3))) in H by lra.
destruct (Req_EM_T 1 0); [lra |]; destruct (Rle_dec 1 0); [lra |].
destruct (Rlt_dec 0 (-2)); [lra |]; destruct H as (_ & H & _); destruct (H 2) as [F _].
- unfold Rdiv; rewrite Rmult_0_l; lra.
- unfold f, ball_overlap, at_time, add, times, dot, r, v in F; simpl in F; lra.
Qed.
