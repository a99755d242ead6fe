(* with: computed.v *)
(* refutes: dd_mul_is_close *)
(* SPDX-License-Identifier: MIT *)
(* (1 + 2^-60) 1 becomes 1. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding exact_dd_products computed.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of dd_mul_is_close in exact (T -> False)).
Proof.
intro H; destruct (H (Dd 1 (bpow radix2 (-60))) (Dd 1 0)) as [F _];
  unfold is_dd, total, dd_mul, normal, low, rnd, u in *; cbn [hi lo] in *.
- work_out; lra.
- work_out; lra.
- work_out_in F; lra.
Qed.
