(* refutes: f_derives *)
(* SPDX-License-Identifier: MIT *)
(* r = 0, v = (1, 0, 0): f = t^2 - sigma^2 has the derivative 2 at 1. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Brink Require Import event_time.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of f_derives in exact (T -> False)).
Proof.
intro H; specialize (H (Vector 0 0 0) (Vector 1 0 0) 0 1).
assert (G : is_derive (f (Vector 0 0 0) (Vector 1 0 0) 0) 1 2).
{ unfold f, ball_overlap, at_time, add, times, dot; simpl; auto_derive; [exact I | ring]. }
apply is_derive_unique in H; apply is_derive_unique in G; rewrite G in H.
unfold a, b, dot in H; simpl in H; lra.
Qed.
