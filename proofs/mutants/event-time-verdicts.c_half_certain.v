(* with: numbers.v *)
(* refutes: c_is_certain *)
(* SPDX-License-Identifier: MIT *)
(* -3/4 of a sum that may be off by 1, and is: C = 1/4. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Brink Require Import rounding event_time_verdicts numbers.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of c_is_certain in exact (T -> False)).
Proof.
intro H; destruct (H (/ 4) (- (3 / 4)) 1 ltac:(lra)) as [F _].
- rewrite (Rabs_left (_ - _)) by lra; unfold u; generalize (Rabs_pos (- (3 / 4))); lra.
- assert (E : rnd (- (3 / 4)) = - (3 / 4)).
  { apply exact_unbounded with (-3)%Z (-2)%Z; [simpl; lra | lia]. }
  rewrite E in F; unfold is_inside in F; lra.
Qed.
