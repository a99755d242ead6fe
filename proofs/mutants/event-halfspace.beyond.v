(* refutes: halfspace_time_is_right *)
(* SPDX-License-Identifier: MIT *)
(* Half beyond the plane, and going on: the time is negative. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Brink Require Import event_time.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of halfspace_time_is_right in exact (T -> False)).
Proof.
intro H; specialize (H (Vector (- / 2) 0 0) (Vector (-1) 0 0) (Vector 1 0 0) (Vector 0 0 0)).
unfold halfspace_time in H.
assert (E : f_plane (Vector (- / 2) 0 0) (Vector (-1) 0 0) (Vector 1 0 0) (Vector 0 0 0) 0 = - / 2)
  by (unfold f_plane, dot, sub, add, times; simpl; lra).
assert (N : dot (Vector 1 0 0) (Vector (-1) 0 0) = -1) by (unfold dot; simpl; lra).
rewrite E, N in H; destruct (Rle_dec 0 (-1)); [lra |]; destruct (Rlt_dec (- / 2) (-1)); [lra |].
destruct H as [H _]; replace (- / 2 / - -1) with (- / 2) in H by field; lra.
Qed.
