(* with: computed.v *)
(* refutes: dd_sqrt_is_close *)
(* SPDX-License-Identifier: MIT *)
(* The root of (1 + 2^-60)^2 becomes 1. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding exact_dd_products computed.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of dd_sqrt_is_close in exact (T -> False)).
Proof.
intro H; set (w := bpow radix2 (-60)); destruct (H (Dd 1 (w + w + w * w))) as [_ F];
  unfold is_dd, total, dd_sqrt, normal, low, rnd, u in *; cbn [hi lo] in *; cbv zeta in *.
- written.
- lra.
- unfold w; work_out; lra.
- replace (1 + (w + w + w * w)) with ((1 + w) * (1 + w)) in F by ring.
  rewrite sqrt_square in F by (unfold w; simpl; lra); unfold w in F; work_out_in F; lra.
Qed.
