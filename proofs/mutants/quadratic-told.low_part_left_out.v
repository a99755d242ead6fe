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
assert (D : forall x m e, x = IZR m * pow e -> (Z.abs m < 2 ^ 53)%Z -> is_double x).
{ intros x m e -> L; apply generic_format_FLX; exists (Float radix2 m e); [reflexivity | exact L]. }
set (a := 1 - pow (-30)); set (c := 1 + pow (-30)); set (d := pow (-60)).
intro H; specialize (H 1 a c d).
assert (E : 1 * 1 - a * c = pow (-30) * pow (-30)) by (unfold a, c; simpl; lra).
rewrite E, sqrt_square in H by apply bpow_ge_0.
destruct H as [F _].
- apply (D _ 1%Z 0%Z); [simpl; lra | easy].
- apply (D _ (2 ^ 30 - 1)%Z (-30)%Z); [unfold a; simpl; lra | easy].
- apply (D _ (2 ^ 30 + 1)%Z (-30)%Z); [unfold c; simpl; lra | easy].
- lra.
- apply bpow_gt_0.
- unfold d, u; work_out; lra.
- replace d with (pow (-30) * pow (-30)) in F by (unfold d; simpl; lra).
  unfold s_hi, s_lo, low, rnd in F.
  unfold a, c in F; work_out_in F; lra.
Qed.
