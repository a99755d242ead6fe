(* refutes: balance_is_exact *)
(* SPDX-License-Identifier: MIT *)
(* x^2, in units of 2, beside 4. *)
From Coq Require Import Reals ZArith Lra.
From Flocq Require Import Core.
From Brink Require Import exact quadratic_rescued.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of balance_is_exact in exact (T -> False)).
Proof.
intro H; destruct (H 1 0 0 0%Z 0%Z 2%Z 1) as [F _].
change (unit_of 0 2) with 1%Z in F; simpl in F; lra.
Qed.
