(* with: computed.v *)
(* refutes: is_rootless_is_exact *)
(* SPDX-License-Identifier: MIT *)
(* h = a = c = 1 + 2^-52: h^2 is not less than a c. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import exact quadratic computed.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of is_rootless_is_exact in exact (T -> False)).
Proof.
set (h := 1 + pow (-52)); assert (D : is_double h) by (unfold h; written).
intro H; destruct (H h h h D D D) as [F _].
- right; unfold h; work_out; lra.
- unfold two_prod, mult, fma in F; cbv zeta in F; cbn [hi lo] in F; unfold h in F.
  enough (h * h < h * h) by lra; apply F; work_out; lra.
Qed.
