(* with: computed.v *)
(* refutes: discriminant_sign_is_exact *)
(* SPDX-License-Identifier: MIT *)
(* h = a = c = 1 + 2^-52: h^2 - a c is 0. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import exact quadratic computed.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of discriminant_sign_is_exact in exact (T -> False)).
Proof.
set (h := 1 + pow (-52)); assert (D : is_double h) by (unfold h; written).
intro H; destruct (H h h h D D D) as [_ [_ F]]; [unfold h; simpl; lra |].
specialize (F eq_refl); unfold discriminant, two_prod, mult, fma in F; cbv zeta in F.
cbn [hi lo] in F; unfold h in F; work_out_in F; lra.
Qed.
