(* with: computed.v *)
(* refutes: payment_pays *)
(* SPDX-License-Identifier: MIT *)
(* 2^-22 owed and a speed of 1: 2^-22 is added to it, whose square, 2^-44, is too much. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding impulse_payment computed.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of payment_pays in exact (T -> False)).
Proof.
intro H; set (w := bpow radix2 (-22)).
destruct (H 1 1 w 1 1 1 ltac:(lra) ltac:(lra) ltac:(lra)) as [F _];
  [rewrite Rminus_diag_eq, Rabs_R0 by reflexivity; unfold u; lra .. |].
assert (G : Rabs (gain 1 1 w) < / 1048576 * rnd (1 * 1))
  by (unfold gain, rnd, w; work_out; lra).
unfold payment, left_owed in F; cbv zeta in F; destruct Rlt_dec as [P | P]; [| contradiction].
replace (2 * (w - 0) * 1 / 1) with (2 * w) in F by field.
unfold gain, rnd, w, u in F; work_out_in F; lra.
Qed.
