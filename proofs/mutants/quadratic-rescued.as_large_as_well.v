(* with: computed.v *)
(* refutes: rootless_has_no_root *)
(* SPDX-License-Identifier: MIT *)
(* 0 x^2 + 0 x + 0 has a root. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import exact quadratic_rescued computed.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of rootless_has_no_root in exact (T -> False)).
Proof.
intro H; assert (Z := generic_format_0 radix2 exponent); specialize (H 0 0 0 Z Z Z).
enough (0 * 0 / 4 < 0 * 0) by lra; apply H.
unfold is_rootless, half, two_prod, mult, fma; cbn [hi lo]; work_out; lra.
Qed.
