(* with: rounding.v exact_dd_products.v impulse_dd.v impulse_sums.v impulse_kick.v *)
(* with: impulse_decision.v impulse_change.v *)
(* SPDX-License-Identifier: MIT *)
(* impulse.c, a core from end to end, or a bounce, with nothing owed before:
   BRINK_IMPULSE_ENERGY_ULP 4 but for its 2^-45th part, and BRINK_IMPULSE_BALANCE 0x1p-96 of the
   larger kinetic energy.  Unbounded exponents. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding exact_dd_products impulse_dd impulse_decision impulse_sums.
From Brink Require Import impulse_kick impulse_change.
Open Scope R_scope.

Section Core.
Variables r0 r1 r2 p0 p1 p2 q0 q1 q2 m1 m2 : R.
Hypotheses (F1 : is_double m1) (F2 : is_double m2) (M1 : 0 < m1) (M2 : 0 < m2).
Hypothesis Apart : 0 < r0 * r0 + r1 * r1 + r2 * r2.
Let speed := b r0 r1 r2 p0 p1 p2 q0 q1 q2.
Let B := r0 * (p0 - q0) + r1 * (p1 - q1) + r2 * (p2 - q2).
Let P := Rabs (r0 * (p0 - q0)) + Rabs (r1 * (p1 - q1)) + Rabs (r2 * (p2 - q2)).

Definition reflection := dd_add_d (dd_mul_d speed (-2)) 0.

Lemma reflection_is_right : let x := made r0 r1 r2 reflection in
  Rabs (x * (2 * B + x)) <= 240 * u * u * (P * P) /\ Rabs x <= 201 / 100 * P.
Proof.
intro x; assert (Cb := b_is_close r0 r1 r2 p0 p1 p2 q0 q1 q2); fold speed in Cb; fold B P in Cb.
assert (P0 : 0 <= P) by (unfold P; repeat apply Rplus_le_le_0_compat; apply Rabs_pos).
assert (Bp : Rabs B <= P).
{ unfold B, P; eapply Rle_trans; [apply Rabs_triang |]; apply Rplus_le_compat_r, Rabs_triang. }
assert (Db : is_dd speed) by apply normal_is_dd.
assert (C1 := dd_mul_d_near speed (-2) Db).
assert (C2 := dd_add_0_near (dd_mul_d speed (-2)) ltac:(apply normal_is_dd)).
assert (C3 := made_is_close r0 r1 r2 Apart reflection (normal_is_double _)
  ltac:(apply normal_is_dd)).
assert (C4 := near_trans _ _ _ _ _ C3 C2 ltac:(lra) ltac:(lra)).
assert (C := near_trans _ _ _ _ _ C4 C1 ltac:(lra) ltac:(lra)); fold x in C.
unfold near in C; set (t := total speed) in *; clear C1 C2 C3 C4.
assert (T : Rabs (t * -2) <= 2001 / 1000 * P /\ Rabs (t * -2 - - (2 * B)) <= 24 * u * u * P).
{ revert Cb Bp P0; generalize P; clearbody t B; clear; intro P; unfold u, Rabs.
  repeat destruct Rcase_abs; lra. }
destruct T as [T1 T2].
assert (X : Rabs (2 * B + x) <= 83 * u * u * P).
{ replace (2 * B + x) with (x - t * -2 + (t * -2 - - (2 * B))) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _); unfold u in *; lra. }
assert (Y : Rabs x <= 201 / 100 * P).
{ assert (Rabs x <= Rabs (x - t * -2) + Rabs (t * -2))
    by (unfold Rabs; repeat destruct Rcase_abs; lra).
  unfold u in *; lra. }
split; [| exact Y]; rewrite Rabs_mult.
assert (Rabs x * Rabs (2 * B + x) <= 201 / 100 * P * (83 * u * u * P))
  by (apply Rmult_le_compat; try apply Rabs_pos; assumption).
assert (0 <= P * P) by (apply Rmult_le_pos; exact P0); unfold u in *; lra.
Qed.

Let kinetic m x y z := m * (x * x + y * y + z * z) / 2.
Let c0 := w0 r0 r1 r2 reflection.
Let c1 := w1 r0 r1 r2 reflection.
Let c2 := w2 r0 r1 r2 reflection.
Let f0 := first0 m1 m2 c0 p0.
Let f1 := first1 m1 m2 c1 p1.
Let f2 := first2 m1 m2 c2 p2.
Let g0 := second0 m1 m2 c0 q0.
Let g1 := second1 m1 m2 c1 q1.
Let g2 := second2 m1 m2 c2 q2.
Let before := kinetic m1 p0 p1 p2 + kinetic m2 q0 q1 q2.
Let after := kinetic m1 (hi f0) (hi f1) (hi f2) + kinetic m2 (hi g0) (hi g1) (hi g2).

Theorem core_keeps_energy K :
  kinetic m1 p0 p1 p2 <= K -> kinetic m2 q0 q1 q2 <= K ->
  kinetic m1 (hi f0) (hi f1) (hi f2) <= K -> kinetic m2 (hi g0) (hi g1) (hi g2) <= K ->
  Rabs (after - before) <= 4 * u * (1 + / 35184372088832) * K /\
  Rabs (after + owed_after m1 m2 c0 c1 c2 p0 p1 p2 q0 q1 q2 0 - before) <= 1024 * u * u * K.
Proof.
intros B1 B2 A1 A2; destruct reflection_is_right as [D X].
set (Q := r0 * r0 + r1 * r1 + r2 * r2) in Apart; set (mu := m1 * m2 / (m1 + m2)).
assert (N : 2 * 0 * Q / mu = 0) by (unfold Rdiv; ring).
rewrite <- (Rminus_0_r before).
apply (change_keeps_energy r0 r1 r2 p0 p1 p2 q0 q1 q2 m1 m2 F1 F2 M1 M2 Apart reflection 0 P K);
  [| exact X | exact (Rle_refl P) | left; exact (Rle_refl (P * P)) | assumption ..].
fold Q mu; rewrite N, Rplus_0_r; exact D.
Qed.
End Core.
