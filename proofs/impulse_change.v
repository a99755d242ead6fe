(* with: rounding.v exact_dd_products.v impulse_dd.v impulse_sums.v impulse_kick.v *)
(* with: impulse_decision.v *)
(* SPDX-License-Identifier: MIT *)
(* impulse.c, pair_change: a pair whose b changes by x with x (2 b + x) = G - L has the energy that
   it had, less the rise mu L / 2 r.r, and what is paid, mu G / 2 r.r.  What is here is what is left
   of that where x is off a little.  Unbounded exponents. *)
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

(* A kinetic energy is no less than that of the relative velocity. *)
Lemma relative_energy m1 m2 p0 p1 p2 q0 q1 q2 : 0 < m1 -> 0 < m2 ->
  m1 * m2 / (m1 + m2) * ((p0 - q0) * (p0 - q0) + (p1 - q1) * (p1 - q1) + (p2 - q2) * (p2 - q2)) / 2
  <= m1 * (p0 * p0 + p1 * p1 + p2 * p2) / 2 + m2 * (q0 * q0 + q1 * q1 + q2 * q2) / 2.
Proof.
intros M1 M2; set (mu := m1 * m2 / (m1 + m2)).
assert (W : forall p q, mu * ((p - q) * (p - q)) <= m1 * (p * p) + m2 * (q * q)).
{ intros p q; assert (0 <= (m1 * p + m2 * q) * (m1 * p + m2 * q) / (m1 + m2)).
  { apply Rmult_le_pos; [apply Rle_0_sqr | apply Rlt_le, Rinv_0_lt_compat; lra]. }
  replace (mu * ((p - q) * (p - q))) with (m1 * (p * p) + m2 * (q * q) -
    (m1 * p + m2 * q) * (m1 * p + m2 * q) / (m1 + m2)) by (unfold mu; field; lra); lra. }
generalize (W p0 q0) (W p1 q1) (W p2 q2); lra.
Qed.

Section Change.
Variables r0 r1 r2 p0 p1 p2 q0 q1 q2 m1 m2 : R. (* r, v1, v2 *)
Hypotheses (F1 : is_double m1) (F2 : is_double m2) (M1 : 0 < m1) (M2 : 0 < m2).
Hypothesis Apart : 0 < r0 * r0 + r1 * r1 + r2 * r2.
Variables c : dd. (* how b is to change *)
Hypotheses (Fc : is_double (hi c)) (Dc : is_dd c).
Let Mu := m1 * m2 / (m1 + m2).
Let square := rr r0 r1 r2.
Let B := r0 * (p0 - q0) + r1 * (p1 - q1) + r2 * (p2 - q2).
Let P := Rabs (r0 * (p0 - q0)) + Rabs (r1 * (p1 - q1)) + Rabs (r2 * (p2 - q2)).
Let Q := r0 * r0 + r1 * r1 + r2 * r2.
Let V := (p0 - q0) * (p0 - q0) + (p1 - q1) * (p1 - q1) + (p2 - q2) * (p2 - q2).

Definition slope := dd_div c square.
Definition w0 := dd_mul_d slope r0.
Definition w1 := dd_mul_d slope r1.
Definition w2 := dd_mul_d slope r2.

Let k := total slope.
Definition made := total slope * (r0 * r0 + r1 * r1 + r2 * r2). (* how it changes *)

Lemma made_is_close : near (233 / 10) made (total c).
Proof.
assert (Cr := rr_is_close r0 r1 r2); fold square Q in Cr; assert (Q0 : 0 < Q) by exact Apart.
assert (Dr : is_dd square) by apply normal_is_dd.
assert (Fr : 0 < hi square).
{ apply (dd_sign square Dr); unfold near in Cr; rewrite (Rabs_pos_eq Q) in Cr by lra.
  apply Rabs_le_inv in Cr; unfold u in *; lra. }
assert (N := dd_div_near c square Fc Dc Fr Dr); fold slope k in N.
assert (E := near_quotient _ _ _ _ _ _ N Cr ltac:(lra) ltac:(lra) (Rgt_not_eq _ _ Q0)).
unfold near in *; change made with (k * Q).
replace (k * Q - total c) with ((k - total c / Q) * Q) by (field; lra).
rewrite Rabs_mult, (Rabs_pos_eq Q) by lra; apply (Rmult_le_compat_r Q) in E; [| lra].
apply Rle_trans with (1 := E); unfold Rdiv; rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq Q) by lra.
replace ((132 * / 10 + 10 + / 1000) * u * u * (Rabs (total c) * / Q) * Q) with
  ((132 * / 10 + 10 + / 1000) * u * u * Rabs (total c)) by (field; lra).
assert (0 <= Rabs (total c)) by apply Rabs_pos; unfold u; lra.
Qed.

(* With what is paid, d, added last. *)
Lemma made_with_payment x d : is_dd x -> c = dd_add_d x d ->
  Rabs (made - (total x + d)) <= u * u * (267 / 10 * Rabs (total x) + 25 * Rabs d).
Proof.
intros X E; assert (N := made_is_close); unfold near in N; rewrite E in N.
assert (C := dd_add_d_is_close x d X); set (y := total (dd_add_d x d)) in *.
assert (Y : Rabs y <= Rabs (y - (total x + d)) + Rabs (total x) + Rabs d)
  by (unfold Rabs; repeat destruct Rcase_abs; lra).
replace (made - (total x + d)) with (made - y + (y - (total x + d))) by ring.
apply Rle_trans with (1 := Rabs_triang _ _).
generalize (Rabs_pos (total x)) (Rabs_pos d); unfold u in *; lra.
Qed.

(* What that kick does in real numbers. *)
Let change := Mu * (total w0 * (p0 - q0) + total w0 * total w0 / 2 +
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

Lemma mu_over_Q : 0 < Mu / Q.
Proof.
assert (0 < Q) by exact Apart.
repeat apply Rdiv_lt_0_compat; try lra; apply Rmult_lt_0_compat; lra.
Qed.

Lemma change_does : Rabs (change - Mu / Q * (made * (2 * B + made) / 2)) <=
  Mu / Q * (221 / 100 * u * u * (Rabs made * P + made * made)).
Proof.
assert (H0 := one_part r0 (p0 - q0)); assert (H1 := one_part r1 (p1 - q1)).
assert (H2 := one_part r2 (p2 - q2)); cbv zeta in H0, H1, H2.
fold w0 in H0; fold w1 in H1; fold w2 in H2.
set (e0 := _ - _) in H0; set (e1 := _ - _) in H1; set (e2 := _ - _) in H2.
assert (Q0 : 0 < Q) by exact Apart; assert (Mq := mu_over_Q).
change made with (k * Q); rewrite Rabs_mult, (Rabs_pos_eq Q) by lra.
replace (change - Mu / Q * (k * Q * (2 * B + k * Q) / 2)) with (Mu / Q * (Q * (e0 + e1 + e2)))
  by (unfold change, e0, e1, e2, B, Q; field; unfold Q in Q0; lra).
rewrite Rabs_mult, (Rabs_pos_eq (Mu / Q)) by lra; apply Rmult_le_compat_l; [lra |].
rewrite Rabs_mult, (Rabs_pos_eq Q) by lra.
replace (221 / 100 * u * u * (Rabs k * Q * P + k * Q * (k * Q))) with
  (Q * (221 / 100 * u * u * (Rabs k * P + k * k * Q))) by ring.
apply Rmult_le_compat_l; [lra |]; unfold P, Q.
assert (T := Rabs_triang (e0 + e1) e2); assert (T' := Rabs_triang e0 e1); unfold u in *; lra.
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

(* Mu g^2 / 2 r.r is a part of the energy, before or after. *)
Theorem change_keeps_energy rise owed left g K :
  let L := 2 * rise * Q / Mu in let G := 2 * (owed - left) * Q / Mu in
  Rabs (made * (2 * B + made) + L - G) <= 270 * u * u * (g * g) + 9 * u * Rabs G ->
  Rabs made <= 201 / 100 * g -> Rabs G <= / 1000000 * (g * g) -> left = 0 \/ left = owed ->
  P <= g -> g * g <= P * P \/ g * g <= P * P - L ->
  kinetic m1 p0 p1 p2 <= K -> kinetic m2 q0 q1 q2 <= K ->
  kinetic m1 (hi f0) (hi f1) (hi f2) <= K -> kinetic m2 (hi g0) (hi g1) (hi g2) <= K ->
  Rabs (after - (before - rise + (owed - left))) <=
    4 * u * (1 + / 35184372088832) * K + 16 * u * Rabs (owed - left) /\
  Rabs (after + owed_after m1 m2 w0 w1 w2 p0 p1 p2 q0 q1 q2 left - (before + owed - rise)) <=
    1024 * u * u * K + 16 * u * Rabs owed.
Proof.
intros L G D X Gg O Pg Gp B1 B2 A1 A2.
assert (D0 : is_dd w0) by apply normal_is_dd; assert (D1 : is_dd w1) by apply normal_is_dd.
assert (D2 : is_dd w2) by apply normal_is_dd.
destruct (kick_keeps_energy m1 m2 F1 F2 M1 M2 w0 w1 w2 p0 p1 p2 q0 q1 q2 left D0 D1 D2 K B1 B2
  A1 A2) as [E F].
fold Mu change in E, F; assert (C := change_does).
set (o := owed_after _ _ _ _ _ _ _ _ _ _ _ _) in *.
change (Rabs (after - (before + change)) <= 4 * u * (1 + / 140737488355328) * K) in E.
change (Rabs (after + o - (before + left + change)) <=
  256 * u * u * K + u * (1 + / 1000) * Rabs left) in F.
assert (Q0 : 0 < Q) by exact Apart; assert (Mq := mu_over_Q).
assert (Mp : 0 < Mu) by (apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat |]; lra).
assert (P0 : 0 <= P) by (unfold P; repeat apply Rplus_le_le_0_compat; apply Rabs_pos).
set (e := Mu / Q * (g * g) / 2).
assert (E0 : 0 <= e).
{ assert (0 <= Mu / Q * (g * g)) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]).
  unfold e; lra. }
(* what is paid, as a part of e *)
set (paid := owed - left) in *; assert (Gs : Mu / Q * Rabs G = 2 * Rabs paid).
{ rewrite <- (Rabs_pos_eq (Mu / Q)), <- (Rabs_pos_eq 2), <- !Rabs_mult by lra; f_equal.
  unfold G; field; lra. }
assert (Pe : Rabs paid <= / 1000000 * e).
{ apply (Rmult_le_compat_l (Mu / Q)) in Gg; [| lra]; unfold e; lra. }
(* what the change does, and should *)
assert (Cr : Rabs (change + rise - paid) <= 297 * u * u * e + 9 * u * Rabs paid).
{ assert (S : Rabs (Mu / Q * (made * (2 * B + made) / 2) + rise - paid) <=
    270 * u * u * e + 9 * u * Rabs paid).
  { replace (Mu / Q * (made * (2 * B + made) / 2) + rise - paid) with
      (Mu / Q * ((made * (2 * B + made) + L - G) / 2)) by (unfold L, G; field; lra).
    rewrite Rabs_mult, (Rabs_pos_eq (Mu / Q)) by lra; unfold Rdiv at 2; rewrite Rabs_mult.
    rewrite (Rabs_pos_eq (/ 2)) by lra.
    apply (Rmult_le_compat_l (Mu / Q)) in D; [| lra]; unfold e; clear - D Gs.
    set (d := Rabs _) in D |- *; set (n := Mu / Q) in *; clearbody d n; unfold u in *; lra. }
  assert (Y : Rabs made * P + made * made <= 606 / 100 * (g * g)).
  { replace (made * made) with (Rabs made * Rabs made)
      by (rewrite <- Rabs_mult; apply Rabs_pos_eq, Rle_0_sqr).
    assert (Rabs made * P <= 201 / 100 * g * g)
      by (apply Rmult_le_compat; try assumption; apply Rabs_pos).
    assert (Rabs made * Rabs made <= 201 / 100 * g * (201 / 100 * g))
      by (apply Rmult_le_compat; try assumption; apply Rabs_pos).
    generalize (Rle_0_sqr g); unfold Rsqr; lra. }
  apply (Rmult_le_compat_l (Mu / Q)) in Y; [| lra].
  replace (Mu / Q * (606 / 100 * (g * g))) with (606 / 100 * 2 * e) in Y by (unfold e; field; lra).
  replace (Mu / Q * (221 / 100 * u * u * (Rabs made * P + made * made))) with
    (221 / 100 * u * u * (Mu / Q * (Rabs made * P + made * made))) in C by ring.
  set (y := Mu / Q * (Rabs made * P + made * made)) in *.
  set (z := Mu / Q * (made * (2 * B + made) / 2)) in *.
  replace (change + rise - paid) with (change - z + (z + rise - paid)) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _); clearbody y z e; unfold u in *; lra. }
(* e is not larger than both energies *)
assert (Vb : Mu * V / 2 <= before) by now apply relative_energy.
assert (Pv : Mu / Q * (P * P) / 2 <= Mu * V / 2).
{ assert (H := cauchy r0 r1 r2 (p0 - q0) (p1 - q1) (p2 - q2)); cbv zeta in H; fold P Q V in H.
  apply (Rmult_le_compat_l (Mu / Q)) in H; [| lra].
  replace (Mu / Q * (Q * V)) with (Mu * V) in H by (field; lra); lra. }
assert (Eb : e <= before \/ e <= before - rise).
{ destruct Gp as [Gp | Gp]; [left | right]; apply (Rmult_le_compat_l (Mu / Q)) in Gp; try lra.
  - unfold e; lra.
  - replace (Mu / Q * (P * P - L)) with (Mu / Q * (P * P) - 2 * rise) in Gp
      by (unfold L; field; lra); unfold e; lra. }
assert (Ab : before <= 2 * K /\ after <= 2 * K).
{ unfold before, after; lra. }
assert (Lo : 9 * Rabs paid + 1001 / 1000 * Rabs left <= 16 * Rabs owed).
{ unfold paid; destruct O as [-> | ->]; [rewrite Rminus_0_r | rewrite Rminus_diag_eq by reflexivity];
    rewrite Rabs_R0; generalize (Rabs_pos owed); lra. }
assert (P1 := Rabs_le_inv _ _ (Rle_refl (Rabs paid))); assert (P2 := Rabs_pos paid).
replace owed with (paid + left) in * by (unfold paid; ring).
apply Rabs_le_inv in E; apply Rabs_le_inv in F; apply Rabs_le_inv in Cr.
set (a := Rabs paid) in *; set (l := Rabs left) in *; set (t := Rabs (paid + left)) in *.
clearbody change after before o e paid a l t.
assert (Ek : e <= 2001 / 1000 * K).
{ clear - E Cr Eb Ab E0 Pe P1 P2; unfold u in *; lra. }
clear - E F Cr Ek E0 Lo P1 P2; split; apply Rabs_le; unfold u in *; lra.
Qed.
End Change.
