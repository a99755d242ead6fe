(* with: rounding.v exact_dd_products.v impulse_dd.v impulse_decision.v *)
(* with: impulse_sums.v impulse_kick.v *)
(* SPDX-License-Identifier: MIT *)
(* impulse.c, a core from end to end, or a bounce, with nothing owed before:
   BRINK_IMPULSE_ENERGY_ULP 4 but for its 2^-45th part, and BRINK_IMPULSE_BALANCE 0x1p-96 of the
   larger kinetic energy.  Unbounded exponents. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding exact_dd_products impulse_dd impulse_decision impulse_sums.
From Brink Require Import impulse_kick.
Open Scope R_scope.

(* (sum |r_i v_i|)^2 <= r.r v.v *)
Lemma cauchy a b c x y z : let P := Rabs (a * x) + Rabs (b * y) + Rabs (c * z) in
  P * P <= (a * a + b * b + c * c) * (x * x + y * y + z * z).
Proof.
intro P; unfold P; rewrite !Rabs_mult.
assert (S : forall t, t * t = Rabs t * Rabs t)
  by (intro; rewrite <- Rabs_mult; symmetry; apply Rabs_pos_eq, Rle_0_sqr).
rewrite (S a), (S b), (S c), (S x), (S y), (S z).
generalize (Rabs a) (Rabs b) (Rabs c) (Rabs x) (Rabs y) (Rabs z); intros a' b' c' x' y' z'.
assert (Q : forall s t, 0 <= (s - t) * (s - t)) by (intros; apply Rle_0_sqr).
generalize (Q (a' * y') (b' * x')) (Q (a' * z') (c' * x')) (Q (b' * z') (c' * y')); intros; lra.
Qed.

Section Core.
Variables r0 r1 r2 p0 p1 p2 q0 q1 q2 m1 m2 : R.
Hypotheses (Fm1 : is_double m1) (Fm2 : is_double m2) (M1 : 0 < m1) (M2 : 0 < m2).
Hypothesis Apart : 0 < r0 * r0 + r1 * r1 + r2 * r2.
Let mu := m1 * m2 / (m1 + m2).
Let speed := b r0 r1 r2 p0 p1 p2 q0 q1 q2.
Let square := rr r0 r1 r2.
Let B := r0 * (p0 - q0) + r1 * (p1 - q1) + r2 * (p2 - q2).
Let P := Rabs (r0 * (p0 - q0)) + Rabs (r1 * (p1 - q1)) + Rabs (r2 * (p2 - q2)).
Let Q := r0 * r0 + r1 * r1 + r2 * r2.
Let V := (p0 - q0) * (p0 - q0) + (p1 - q1) * (p1 - q1) + (p2 - q2) * (p2 - q2).

(* reflection() and pair_change() *)
Definition slope := dd_div (dd_add_d (dd_mul_d speed (-2)) 0) square.
Definition w0 := dd_mul_d slope r0.
Definition w1 := dd_mul_d slope r1.
Definition w2 := dd_mul_d slope r2.

Let k := total slope.

Lemma slope_is_close : Rabs (2 * B + k * Q) <= 98 * u * u * P /\
  Rabs k * Q <= 2001 / 1000 * P /\ 0 <= P.
Proof.
assert (Cb := b_is_close r0 r1 r2 p0 p1 p2 q0 q1 q2); assert (Cr := rr_is_close r0 r1 r2).
fold speed in Cb; fold B P in Cb; fold square Q in Cr.
assert (P0 : 0 <= P) by (unfold P; repeat apply Rplus_le_le_0_compat; apply Rabs_pos).
assert (Bp : Rabs B <= P).
{ unfold B, P; eapply Rle_trans; [apply Rabs_triang |]; apply Rplus_le_compat_r, Rabs_triang. }
assert (Db : is_dd speed) by apply normal_is_dd; assert (Dr : is_dd square) by apply normal_is_dd.
assert (Fr : 0 < hi square).
{ apply (dd_sign square Dr); unfold near in Cr; rewrite (Rabs_pos_eq Q) in Cr by (unfold Q; lra).
  apply Rabs_le_inv in Cr; unfold Q, u in *; lra. }
assert (C1 := dd_mul_d_near speed (-2) Db); set (y := dd_mul_d speed (-2)) in *.
assert (Dy : is_dd y) by apply normal_is_dd; assert (C2 := dd_add_d_is_close y 0 Dy).
set (z := dd_add_d y 0) in *; assert (Dz : is_dd z) by apply normal_is_dd.
assert (C3 := dd_div_near z square (normal_is_double _) Dz Fr Dr).
change (dd_div z square) with slope in C3.
fold k in C3; unfold near in *; rewrite Rabs_R0 in C2.
set (tb := total speed) in *; set (ty := total y) in *; set (tz := total z) in *.
set (tr := total square) in *; assert (Q0 : 0 < Q) by exact Apart.
rewrite (Rabs_pos_eq Q) in Cr by lra.
assert (Hk : Rabs k * Q <= 2001 / 1000 * P /\
  Rabs (k * (tr - Q)) <= 10 * u * u * (2001 / 1000 * P)).
{ assert (G : Rabs k * Q <= 2001 / 1000 * P).
  { assert (T : Rabs k * Q * (999999 / 1000000) <= Rabs (k * tr)).
    { rewrite Rabs_mult, (Rmult_assoc (Rabs k)); apply Rmult_le_compat_l; [apply Rabs_pos |].
      apply Rabs_le_inv in Cr; rewrite Rabs_pos_eq by (unfold u in *; lra); unfold u in *; lra. }
    clearbody tb ty tz tr B P k Q; clear - T C1 C2 C3 Cb Bp P0.
    assert (Rabs (tb * -2) = 2 * Rabs tb)
      by (rewrite Rabs_mult, (Rabs_left (-2)) by lra; ring).
    assert (L : forall s t, Rabs s <= Rabs (s - t) + Rabs t)
      by (intros; unfold Rabs; repeat destruct Rcase_abs; lra).
    assert (L1 := L tb B); assert (L2 := L ty (tb * -2)); assert (L3 := L tz (ty + 0)).
    assert (L4 := L (k * tr) tz); rewrite Rplus_0_r in L3, C2; unfold u in *; lra. }
  split; [exact G |]; rewrite Rabs_mult.
  apply Rle_trans with (Rabs k * (10 * u * u * Q)); [apply Rmult_le_compat_l;
    [apply Rabs_pos | exact Cr] |].
  replace (Rabs k * (10 * u * u * Q)) with (10 * u * u * (Rabs k * Q)) by ring.
  apply Rmult_le_compat_l; [unfold u; lra | exact G]. }
destruct Hk as [G Hk]; split; [| split; assumption].
clearbody tb ty tz tr B P k Q; clear - C1 C2 C3 Cb Bp P0 G Hk.
assert (E : Rabs (tb * -2) = 2 * Rabs tb) by (rewrite Rabs_mult, (Rabs_left (-2)) by lra; ring).
assert (L : forall s t, Rabs s <= Rabs (s - t) + Rabs t)
  by (intros; unfold Rabs; repeat destruct Rcase_abs; lra).
assert (L1 := L tb B); assert (L2 := L ty (tb * -2)); assert (L3 := L tz (ty + 0)).
rewrite Rplus_0_r in L3, C2; rewrite E in *.
replace (2 * B + k * Q) with
  (k * tr - tz + (tz - ty) + (ty - tb * -2) + - (2 * (tb - B)) + - (k * (tr - Q))) by ring.
repeat (eapply Rle_trans; [apply Rabs_triang |];
  match goal with |- _ + Rabs (- _) <= _ => rewrite Rabs_Ropp | _ => idtac end).
assert (T1 := Rabs_triang (k * tr - tz + (tz - ty) + (ty - tb * -2)) (- (2 * (tb - B)))).
assert (T2 := Rabs_triang (k * tr - tz + (tz - ty)) (ty - tb * -2)).
assert (T3 := Rabs_triang (k * tr - tz) (tz - ty)).
rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq 2) in T1 by lra; unfold u in *; lra.
Qed.
(* What that kick does in real numbers: next to nothing, as it should. *)
Let change := mu * (total w0 * (p0 - q0) + total w0 * total w0 / 2 +
  (total w1 * (p1 - q1) + total w1 * total w1 / 2) +
  (total w2 * (p2 - q2) + total w2 * total w2 / 2)).

Lemma one_part r d : let w := total (dd_mul_d slope r) in
  Rabs (w * d + w * w / 2 - (k * (r * d) + k * k * (r * r) / 2)) <=
    221 / 100 * u * u * (Rabs k * Rabs (r * d) + k * k * (r * r)).
Proof.
assert (Ds : is_dd slope) by apply normal_is_dd; assert (N := dd_mul_d_near slope r Ds).
cbv zeta; set (w := total (dd_mul_d slope r)) in *; unfold near in N; fold k in N.
set (e := w - k * r) in *; assert (Ew : w = k * r + e) by (unfold e; ring).
replace (w * d + w * w / 2 - (k * (r * d) + k * k * (r * r) / 2)) with
  (e * d + (e * (k * r) + e * e / 2)) by (rewrite Ew; field).
assert (K2 : Rabs (k * r) * Rabs (k * r) = k * k * (r * r)).
{ rewrite <- Rabs_mult, Rabs_pos_eq by apply Rle_0_sqr; ring. }
assert (E1 : Rabs (e * d) <= 22 / 10 * u * u * (Rabs k * Rabs (r * d))).
{ rewrite Rabs_mult, (Rabs_mult r); rewrite (Rabs_mult k) in N.
  replace (22 / 10 * u * u * (Rabs k * (Rabs r * Rabs d))) with
    (22 / 10 * u * u * (Rabs k * Rabs r) * Rabs d) by ring.
  apply Rmult_le_compat_r; [apply Rabs_pos | exact N]. }
assert (E2 : Rabs (e * (k * r)) <= 22 / 10 * u * u * (k * k * (r * r))).
{ rewrite Rabs_mult, <- K2.
  replace (22 / 10 * u * u * (Rabs (k * r) * Rabs (k * r))) with
    (22 / 10 * u * u * Rabs (k * r) * Rabs (k * r)) by ring.
  apply Rmult_le_compat_r; [apply Rabs_pos | exact N]. }
assert (E3 : Rabs (e * e) <= u * (k * k * (r * r)) * u / 1000000).
{ rewrite Rabs_mult, <- K2.
  apply Rle_trans with (22 / 10 * u * u * Rabs (k * r) * (22 / 10 * u * u * Rabs (k * r))).
  - apply Rmult_le_compat; try apply Rabs_pos; exact N.
  - assert (0 <= Rabs (k * r) * Rabs (k * r)) by (apply Rmult_le_pos; apply Rabs_pos).
    unfold u in *; lra. }
assert (T := Rabs_triang (e * d) (e * (k * r) + e * e / 2)).
assert (T' := Rabs_triang (e * (k * r)) (e * e / 2)).
unfold Rdiv at 2 in T'; rewrite (Rabs_mult (e * e)), (Rabs_pos_eq (/ 2)) in T' by lra.
assert (0 <= Rabs k * Rabs (r * d)) by (apply Rmult_le_pos; apply Rabs_pos).
assert (0 <= k * k * (r * r)) by (rewrite <- K2; apply Rmult_le_pos; apply Rabs_pos).
unfold Rdiv in *; unfold u in *; lra.
Qed.

Lemma change_is_small : Rabs change <= mu * (112 * u * u * V).
Proof.
destruct slope_is_close as (S & G & P0).
assert (Mu : 0 < mu) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat |]; lra).
unfold change; rewrite Rabs_mult, (Rabs_pos_eq mu) by lra; apply Rmult_le_compat_l; [lra |].
assert (H0 := one_part r0 (p0 - q0)); assert (H1 := one_part r1 (p1 - q1)).
assert (H2 := one_part r2 (p2 - q2)); cbv zeta in H0, H1, H2.
fold w0 in H0; fold w1 in H1; fold w2 in H2.
assert (C := cauchy r0 r1 r2 (p0 - q0) (p1 - q1) (p2 - q2)); cbv zeta in C; fold P Q V in C.
set (e0 := _ - _) in H0; set (e1 := _ - _) in H1; set (e2 := _ - _) in H2.
set (x := total w0 * (p0 - q0) + total w0 * total w0 / 2 + _ + _).
assert (Ex : x = k * (2 * B + k * Q) / 2 + (e0 + e1 + e2))
  by (unfold x, e0, e1, e2, B, Q; field).
rewrite Ex; clear Ex x; clearbody e0 e1 e2; set (E := e0 + e1 + e2).
assert (He : Rabs E <= 221 / 100 * u * u * (Rabs k * P + k * k * Q)).
{ unfold E; assert (T := Rabs_triang (e0 + e1) e2); assert (T' := Rabs_triang e0 e1).
  unfold P, Q; clear - H0 H1 H2 T T'; unfold u in *; lra. }
apply (Rmult_le_reg_l Q); [exact Apart |].
assert (K0 := Rabs_pos k); assert (Kk : k * k = Rabs k * Rabs k)
  by (rewrite <- Rabs_mult; symmetry; apply Rabs_pos_eq, Rle_0_sqr).
assert (Q0 : 0 < Q) by exact Apart.
assert (Pp : Rabs k * Q * P <= 2001 / 1000 * P * P) by (apply Rmult_le_compat_r; assumption).
assert (Pq : Rabs k * Q * (Rabs k * Q) <= 2001 / 1000 * P * (2001 / 1000 * P)).
{ assert (0 <= Rabs k * Q) by (apply Rmult_le_pos; lra); apply Rmult_le_compat; assumption. }
assert (Ks : Rabs (k * (2 * B + k * Q) / 2) * Q <= 49 * u * u * (Rabs k * Q * P)).
{ unfold Rdiv; rewrite !Rabs_mult, (Rabs_pos_eq (/ 2)) by lra.
  replace (49 * u * u * (Rabs k * Q * P)) with (Rabs k * (98 * u * u * P) * / 2 * Q) by field.
  apply Rmult_le_compat_r; [lra |]; apply Rmult_le_compat_r; [lra |].
  apply Rmult_le_compat_l; [exact K0 | exact S]. }
apply (Rmult_le_compat_r Q) in He; [| lra].
replace (221 / 100 * u * u * (Rabs k * P + k * k * Q) * Q) with
  (221 / 100 * u * u * (Rabs k * Q * P + Rabs k * Q * (Rabs k * Q))) in He by (rewrite Kk; ring).
assert (T := Rabs_triang (k * (2 * B + k * Q) / 2) E).
apply (Rmult_le_compat_l Q) in T; [| lra].
assert (0 <= P * P) by (apply Rmult_le_pos; exact P0).
apply Rle_trans with (1 := T); replace (Q * (112 * u * u * V)) with (112 * u * u * (Q * V)) by ring.
rewrite Rmult_plus_distr_l, (Rmult_comm Q), (Rmult_comm Q (Rabs E)).
set (y := Rabs (_ / 2) * Q) in *; set (z := Rabs E * Q) in *; set (qv := Q * V) in *.
set (kp := Rabs k * Q * P) in *; set (kk := Rabs k * Q * (Rabs k * Q)) in *.
clearbody y z qv kp kk; unfold u in *; lra.
Qed.

Let kinetic m x y z := m * (x * x + y * y + z * z) / 2.
Let f0 := first0 m1 m2 w0 p0.
Let f1 := first1 m1 m2 w1 p1.
Let f2 := first2 m1 m2 w2 p2.
Let g0 := second0 m1 m2 w0 q0.
Let g1 := second1 m1 m2 w1 q1.
Let g2 := second2 m1 m2 w2 q2.
Let before := kinetic m1 p0 p1 p2 + kinetic m2 q0 q1 q2.
Let after := kinetic m1 (hi f0) (hi f1) (hi f2) +
  kinetic m2 (hi g0) (hi g1) (hi g2).

Theorem core_keeps_energy K :
  kinetic m1 p0 p1 p2 <= K -> kinetic m2 q0 q1 q2 <= K ->
  kinetic m1 (hi f0) (hi f1) (hi f2) <= K ->
  kinetic m2 (hi g0) (hi g1) (hi g2) <= K ->
  Rabs (after - before) <= 4 * u * (1 + / 35184372088832) * K /\
  Rabs (after + owed_after m1 m2 w0 w1 w2 p0 p1 p2 q0 q1 q2 0 - before) <= 1024 * u * u * K.
Proof.
intros B1 B2 A1 A2.
assert (D0 : is_dd w0) by apply normal_is_dd; assert (D1 : is_dd w1) by apply normal_is_dd.
assert (D2 : is_dd w2) by apply normal_is_dd.
destruct (kick_keeps_energy m1 m2 Fm1 Fm2 M1 M2 w0 w1 w2 p0 p1 p2 q0 q1 q2 0 D0 D1 D2 K B1 B2
  A1 A2) as [E F].
fold mu in E, F; rewrite Rabs_R0 in F; assert (C := change_is_small).
assert (Mu : 0 < mu) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat |]; lra).
assert (O : forall p q, mu * ((p - q) * (p - q)) <= m1 * (p * p) + m2 * (q * q)).
{ intros p q; assert (0 <= (m1 * p + m2 * q) * (m1 * p + m2 * q) / (m1 + m2)).
  { apply Rmult_le_pos; [apply Rle_0_sqr | apply Rlt_le, Rinv_0_lt_compat; lra]. }
  replace (mu * ((p - q) * (p - q))) with (m1 * (p * p) + m2 * (q * q) -
    (m1 * p + m2 * q) * (m1 * p + m2 * q) / (m1 + m2)) by (unfold mu; field; lra); lra. }
assert (Vk : mu * V <= 4 * K).
{ generalize (O p0 q0) (O p1 q1) (O p2 q2); unfold V, kinetic in *; lra. }
replace (mu * (112 * u * u * V)) with (112 * u * u * (mu * V)) in C by ring.
assert (V0 : 0 <= mu * V).
{ apply Rmult_le_pos; [lra |]; unfold V; repeat apply Rplus_le_le_0_compat; apply Rle_0_sqr. }
fold change in E, F; apply Rabs_le_inv in C.
set (o := owed_after _ _ _ _ _ _ _ _ _ _ _ _) in *.
change (Rabs (after - (before + change)) <= 4 * u * (1 + / 70368744177664) * K) in E.
change (Rabs (after + o - (before + 0 + change)) <= 256 * u * u * K + u * (1 + / 1000) * 0) in F.
apply Rabs_le_inv in E; apply Rabs_le_inv in F.
clearbody change after before o; split; apply Rabs_le; unfold u in *; lra.
Qed.
End Core.
