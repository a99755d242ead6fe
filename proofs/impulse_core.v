(* with: rounding.v exact_dd_products.v impulse_dd.v impulse_sums.v impulse_kick.v *)
(* with: impulse_decision.v impulse_change.v impulse_payment.v *)
(* SPDX-License-Identifier: MIT *)
(* impulse.c, a core from end to end, or a bounce, whatever was owed before: BRINK_IMPULSE_ENERGY_ULP
   4 but for its 2^-45th part, and BRINK_IMPULSE_BALANCE 0x1p-96 of the larger kinetic energy, and
   2^-49 of what was owed.  Unbounded exponents. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding exact_dd_products impulse_dd impulse_decision impulse_sums.
From Brink Require Import impulse_kick impulse_change impulse_payment.
Open Scope R_scope.

Section Core.
Variables r0 r1 r2 p0 p1 p2 q0 q1 q2 m1 m2 way owed : R.
Hypotheses (F1 : is_double m1) (F2 : is_double m2) (M1 : 0 < m1) (M2 : 0 < m2).
Hypothesis Apart : 0 < r0 * r0 + r1 * r1 + r2 * r2.
Hypothesis Way : way = 1 \/ way = -1.
Let speed := b r0 r1 r2 p0 p1 p2 q0 q1 q2.
Let square := rr r0 r1 r2.
Let reduced := mu m1 m2.
Let B := r0 * (p0 - q0) + r1 * (p1 - q1) + r2 * (p2 - q2).
Let P := Rabs (r0 * (p0 - q0)) + Rabs (r1 * (p1 - q1)) + Rabs (r2 * (p2 - q2)).
Let Q := r0 * r0 + r1 * r1 + r2 * r2.
Let Mu := m1 * m2 / (m1 + m2).

(* What goes along `way` is reflected, with what is paid. *)
Definition kept := rnd (way * hi speed).
Definition paid := payment (hi square) (hi reduced) owed kept.
Definition left := left_owed (hi square) (hi reduced) owed kept.
Definition reflection := dd_add_d (dd_mul_d speed (-2)) (rnd (- way * paid)).
Hypothesis Along : 0 < kept.

Let G := 2 * (owed - left) * Q / Mu.

Lemma reflection_is_right : let x := made r0 r1 r2 reflection in
  Rabs (x * (2 * B + x) - G) <= 270 * u * u * (P * P) + 9 * u * Rabs G /\
  Rabs x <= 201 / 100 * P /\ Rabs G <= / 1000000 * (P * P) /\ (left = 0 \/ left = owed).
Proof.
intro x; assert (Ww : way * way = 1) by (destruct Way as [Wy | Wy]; rewrite Wy; ring).
assert (Cb := b_is_close r0 r1 r2 p0 p1 p2 q0 q1 q2); fold speed in Cb; fold B P in Cb.
assert (P0 : 0 <= P) by (unfold P; repeat apply Rplus_le_le_0_compat; apply Rabs_pos).
assert (Bp : Rabs B <= P).
{ unfold B, P; eapply Rle_trans; [apply Rabs_triang |]; apply Rplus_le_compat_r, Rabs_triang. }
assert (Db : is_dd speed) by apply normal_is_dd; assert (Fb : is_double (hi speed))
  by apply normal_is_double.
assert (Signed : forall y, is_double y -> rnd (way * y) = way * y /\ rnd (- way * y) = - way * y).
{ intros y Y; assert (E : rnd y = y) by (apply round_generic; [typeclasses eauto | exact Y]).
  destruct Way as [Wy | Wy]; rewrite Wy.
  - replace (1 * y) with y by ring; replace (- (1) * y) with (- y) by ring.
    rewrite rnd_negative, E; split; reflexivity.
  - replace (-1 * y) with (- y) by ring; replace (- -1 * y) with y by ring.
    rewrite rnd_negative, E; split; reflexivity. }
assert (Ek : kept = way * hi speed) by apply (Signed _ Fb).
(* what is paid for the speed t, rounded to h *)
set (t := way * total speed); set (h := kept) in *.
assert (H : Rabs (h - t) <= 1002 / 1000 * u * t /\ 0 <= t <= 1001 / 1000 * P /\
  Rabs (t - way * B) <= 12 * u * u * P).
{ assert (Hl : Rabs (h - t) <= 1002 / 1000 * u * Rabs t).
  { unfold t; rewrite Ek; rewrite <- Rmult_minus_distr_l, !Rabs_mult.
    rewrite (way_size way Way), !Rmult_1_l.
    replace (hi speed - total speed) with (- lo speed) by (unfold total; ring).
    rewrite Rabs_Ropp; apply dd_size, Db. }
  assert (Tb : Rabs (t - way * B) <= 12 * u * u * P).
  { unfold t; rewrite <- Rmult_minus_distr_l, Rabs_mult, (way_size way Way), Rmult_1_l; exact Cb. }
  assert (Wb : Rabs (way * B) <= P) by (rewrite Rabs_mult, (way_size way Way), Rmult_1_l; exact Bp).
  assert (T0 : 0 < t).
  { revert Hl Along; clear; unfold u, Rabs; repeat destruct Rcase_abs; intros; lra. }
  rewrite (Rabs_pos_eq t) in Hl by lra; split; [exact Hl | split; [| exact Tb]].
  apply Rabs_le_inv in Tb; apply Rabs_le_inv in Wb; unfold u in *; lra. }
destruct H as (Ht & T & Tb).
assert (Cr := rr_is_close r0 r1 r2); fold square Q in Cr; assert (Q0 : 0 < Q) by exact Apart.
destruct (mu_is_close m1 m2 F2 M1 M2) as (Dm & Cm & _); fold reduced in Dm, Cm; fold Mu in Cm.
assert (Mp : 0 < Mu) by exact (Mu_pos m1 m2 M1 M2).
destruct (payment_pays (hi square) (hi reduced) owed h Q Mu Q0 Mp (Rlt_le _ _ Along)
  (near_high 10 square Q ltac:(apply normal_is_dd) Cr ltac:(lra) Q0)
  (near_high _ reduced Mu Dm Cm ltac:(lra) Mp)) as (Pd & Ph & Pg & Pl).
fold paid left G in Pd, Ph, Pg, Pl.
(* beside it, seen against `way`: from - way B by 2 t to t *)
set (y := - way * x).
assert (Y : Rabs (y - (2 * t + paid)) <= u * u * (29 * Rabs (2 * t) + 25 * Rabs paid)).
{ assert (Fp : is_double paid).
  { unfold paid, payment; cbv zeta; destruct Rlt_dec; [apply generic_format_round | apply
      generic_format_0]; typeclasses eauto. }
  assert (D2 : is_dd (dd_mul_d speed (-2))) by apply normal_is_dd.
  assert (M := made_with_payment r0 r1 r2 Apart reflection (normal_is_double _)
    ltac:(apply normal_is_dd) _ _ D2 eq_refl); fold x in M.
  rewrite (proj2 (Signed _ Fp)) in M.
  assert (C := dd_mul_d_near speed (-2) Db); unfold near in C.
  set (z := total (dd_mul_d speed (-2))) in *.
  replace (total speed * -2) with (- way * (2 * t)) in C
    by (unfold t; replace (- way * (2 * (way * total speed))) with
          (way * way * (total speed * -2)) by ring; rewrite Ww; ring).
  rewrite !(Rabs_mult (- way)), !Rabs_Ropp, (way_size way Way), !Rmult_1_l in *.
  assert (Z : Rabs z <= Rabs (z - - way * (2 * t)) + Rabs (- way * (2 * t)))
    by (unfold Rabs; repeat destruct Rcase_abs; lra).
  rewrite (Rabs_mult (- way)), Rabs_Ropp, (way_size way Way), !Rmult_1_l in Z.
  replace (y - (2 * t + paid)) with (- way * (x - (z + - way * paid) + (z - - way * (2 * t)))).
  2: { unfold y; replace (- way * (x - (z + - way * paid) + (z - - way * (2 * t)))) with
         (- way * x - way * way * (2 * t + paid)) by ring; rewrite Ww; ring. }
  rewrite Rabs_mult, Rabs_Ropp, (way_size way Way), Rmult_1_l.
  apply Rle_trans with (1 := Rabs_triang _ _).
  generalize (Rabs_pos (2 * t)) (Rabs_pos paid); unfold u in *; lra. }
assert (Go : goes_on (- way * B) 0 P (2 * t) t).
{ assert (E : Rabs (- way * B + 2 * t - t) <= 12 * u * u * P)
    by (replace (- way * B + 2 * t - t) with (t - way * B) by ring; exact Tb).
  assert (E' : Rabs (- way * B + 2 * t) <= 10011 / 10000 * P)
    by (apply Rabs_le_inv in E; apply Rabs_le; unfold u in *; lra).
  assert (P2 : 0 <= P * P) by (apply Rmult_le_pos; exact P0).
  assert (T2 : Rabs (2 * t) = 2 * t) by (apply Rabs_pos_eq; lra).
  unfold goes_on; rewrite !T2; repeat split; try lra.
  - replace (2 * t * (2 * (- way * B) + 2 * t) + 0) with (4 * t * (t - way * B)) by ring.
    rewrite Rabs_mult, (Rabs_pos_eq (4 * t)) by lra.
    assert (4 * t * Rabs (t - way * B) <= 4 * (1001 / 1000 * P) * (12 * u * u * P))
      by (apply Rmult_le_compat; try apply Rabs_pos; lra).
    unfold u in *; lra.
  - assert (t * Rabs (- way * B + 2 * t - t) <= 1001 / 1000 * P * (12 * u * u * P))
      by (apply Rmult_le_compat; try apply Rabs_pos; lra).
    unfold u in *; lra.
  - assert (2 * t * Rabs (- way * B + 2 * t) <= 2 * (1001 / 1000 * P) * (10011 / 10000 * P))
      by (apply Rmult_le_compat; try apply Rabs_pos; lra).
    lra. }
destruct (with_payment _ _ _ _ t h paid G y Go T Ht Pd Ph Pg Y) as (E & X & Gp).
replace (y * (2 * (- way * B) + y) + 0 - G) with (way * way * (x * (2 * B + x)) - G) in E
  by (unfold y; ring).
unfold y in X; rewrite Rabs_mult, Rabs_Ropp, (way_size way Way), Rmult_1_l in X.
rewrite Ww, Rmult_1_l in E; repeat split; assumption.
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

(* owed - left is what is paid: all that was owed, or nothing. *)
Theorem core_keeps_energy K :
  kinetic m1 p0 p1 p2 <= K -> kinetic m2 q0 q1 q2 <= K ->
  kinetic m1 (hi f0) (hi f1) (hi f2) <= K -> kinetic m2 (hi g0) (hi g1) (hi g2) <= K ->
  Rabs (after - (before + (owed - left))) <=
    4 * u * (1 + / 35184372088832) * K + 16 * u * Rabs (owed - left) /\
  Rabs (after + owed_after m1 m2 c0 c1 c2 p0 p1 p2 q0 q1 q2 left - (before + owed)) <=
    1024 * u * u * K + 16 * u * Rabs owed.
Proof.
intros B1 B2 A1 A2; destruct reflection_is_right as (D & X & Gp & Pl).
assert (N : 2 * 0 * Q / Mu = 0) by (unfold Rdiv; ring).
rewrite <- (Rminus_0_r (before + owed)), <- (Rminus_0_r before) at 1.
apply (change_keeps_energy r0 r1 r2 p0 p1 p2 q0 q1 q2 m1 m2 F1 F2 M1 M2 Apart reflection 0 owed left
  P K); [| exact X | exact Gp | exact Pl | exact (Rle_refl P) | left; exact (Rle_refl (P * P)) |
  assumption ..].
fold Q Mu; rewrite N, Rplus_0_r; exact D.
Qed.
End Core.
