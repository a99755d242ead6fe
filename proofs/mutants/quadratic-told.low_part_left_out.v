(* with: computed.v *)
(* refutes: sum_told *)
(* SPDX-License-Identifier: MIT *)
(* h = 1 and a c = (1 - 2^-30) (1 + 2^-30): of the discriminant, 2^-60, nothing is left. *)
From Coq Require Import Reals ZArith Lra.
From Flocq Require Import Core.
From Brink Require Import rounding quadratic_told_sum computed.
Open Scope R_scope.

Notation pow := (bpow radix2).

Theorem is_false : ltac:(let T := type of sum_told in exact (T -> False)).
Proof.
set (a := 1 - pow (-30)); set (c := 1 + pow (-30)); set (d := pow (-60)).
intro H; specialize (H 1 a c d).
assert (E : 1 * 1 - a * c = pow (-30) * pow (-30)) by (unfold a, c; simpl; lra).
rewrite E, sqrt_square in H by apply bpow_ge_0.
destruct H as [F _].
- written.
- unfold a; written.
- unfold c; written.
- lra.
- apply bpow_gt_0.
- unfold d, u; work_out; lra.
- replace d with (pow (-30) * pow (-30)) in F by (unfold d; simpl; lra).
  unfold s_hi, s_lo, low, rnd in F.
  unfold a, c in F; work_out_in F; lra.
Qed.
