(* with: numbers.v *)
(* refutes: already_parted *)
(* SPDX-License-Identifier: MIT *)
(* c = 3/4 of a sum that may be off by 1, and is: C = -1/4. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Brink Require Import rounding event_time_near numbers.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of already_parted in exact (T -> False)).
Proof.
intro H; assert (E1 : rnd 1 = 1) by (apply exact_unbounded with 1%Z 0%Z; [simpl; lra | lia]).
assert (E2 : rnd (3 / 4) = 3 / 4) by (apply exact_unbounded with 3%Z (-2)%Z; [simpl; lra | lia]).
assert (L : is_leaving 1 1 1).
{ unfold is_leaving; replace (1 * 1) with 1 by ring; rewrite E1, !Rmult_1_r.
  unfold rnd, fexp; rewrite (exact_unbounded (/ _) 1 (-200)) by (simpl; lra || lia); lra. }
assert (K : Rabs (3 / 4 - - / 4) <= 1 + 3 * u * u * Rabs (3 / 4))
  by (rewrite !Rabs_pos_eq by lra; unfold u; lra).
assert (N : Rabs (1 - 1) = 0) by (rewrite Rminus_eq_0; apply Rabs_R0).
assert (O : is_outside (3 / 4) 1) by (unfold is_outside; lra).
specialize (H 1 1 (- / 4) 0 1 1 1 (3 / 4) 1 1); cbv zeta in H; rewrite E1, E2, N in H.
destruct H as [_ F]; try assumption; unfold tiny, u in *; lra.
Qed.
