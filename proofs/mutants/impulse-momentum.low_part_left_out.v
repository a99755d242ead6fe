(* with: computed.v *)
(* refutes: dd_add_d_is_close *)
(* SPDX-License-Identifier: MIT *)
(* 1 + u / 2 and 0 are 1. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding exact_dd_products impulse_dd computed.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of dd_add_d_is_close in exact (T -> False)).
Proof.
intro H; assert (F := H (Dd 1 (bpow radix2 (-54))) 0).
unfold is_dd, total, dd_add_d, normal, low, rnd, u in F; cbn [hi lo] in F; cbv zeta in F.
specialize (F ltac:(work_out; lra)); work_out_in F; lra.
Qed.
