(* refutes: kick_keeps_momentum *)
(* SPDX-License-Identifier: MIT *)
(* Masses 1 and 3, kicked from rest. *)
From Coq Require Import Reals Lra.
From Brink Require Import event_time impulse.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of kick_keeps_momentum in exact (T -> False)).
Proof.
intro H; destruct (H (Vector 1 0 0) 1 3 ltac:(lra) ltac:(lra) (Vector 1 0 0) (Vector 0 0 0)
  (Vector 0 0 0)) as [E _]; apply (f_equal x1) in E.
unfold momentum, kick1, kick2, k1, k2, add, times in E; simpl in E; lra.
Qed.
