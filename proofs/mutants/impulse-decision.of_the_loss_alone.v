(* with: computed.v computed_dd.v *)
(* refutes: filter_is_right *)
(* SPDX-License-Identifier: MIT *)
(* Masses 1 and b = 2^-300 - 2^-106, of which double-double sees 2^-300: an energy a third more than the
   rise (tests/impulse.wc). *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding exact_dd_products impulse_dd impulse_decision.
From Brink Require Import computed computed_dd.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of filter_is_right in exact (T -> False)).
Proof.
intro H; assert (F1 : is_double 1) by written.
set (p1 := bpow radix2 (-53)); set (p2 := - (1 + bpow radix2 (-52))).
set (q0 := - (bpow radix2 (-53) - bpow radix2 (-106))); set (q2 := - bpow radix2 (-300)).
set (high := bpow radix2 (-216)); set (top := bpow radix2 130).
assert (Low : high <= top) by (apply bpow_le; easy).
assert (B : b 1 1 1 1 p1 p2 q0 0 q2 = Dd (bpow radix2 (-300)) 0).
{ unfold b, v0, v1, v2, sum3, zero, p1, p2, q0, q2; is_pair. }
assert (S : s 1 1 1 1 p1 p2 q0 0 q2 1 = Dd (bpow radix2 (-300)) 0)
  by (unfold s; rewrite B; cbn [hi lo]; f_equal; lra).
assert (R : rr 1 1 1 = Dd 3 0) by (unfold rr, sum3, zero; is_pair).
assert (M : mu 1 1 = Dd (/ 2) 0) by (unfold mu, k1, mass; is_pair).
assert (L : loss 1 1 1 1 1 high top = Dd (12 * high) 0)
  by (unfold loss; rewrite R, M, Rmin_left by exact Low; unfold high; is_pair).
eassert (T : rest 1 1 1 1 p1 p2 q0 0 q2 1 1 1 high top = Dd _ _)
  by (unfold rest, ss; rewrite S, L; unfold high; work_out_dd; reflexivity).
destruct (H 1 1 1 1 p1 p2 q0 0 q2 1 1 F1 ltac:(lra) ltac:(lra) 1 high top (or_introl eq_refl))
  as [_ N].
- unfold p1, p2, q0, q2; work_out; lra.
- lra.
- right; lra.
- unfold top; simpl; lra.
- assert (surplus 1 1 1 1 p1 p2 q0 0 q2 1 1 high < 0); [apply N |].
  + unfold margin; rewrite L, T; cbn [hi]; unfold high, rnd; work_out; lra.
  + unfold surplus, p1, p2, q0, q2, high in *; simpl bpow in *; lra.
Qed.
