(* with: rounding.v exact_dd_products.v impulse_dd.v *)
(* SPDX-License-Identifier: MIT *)
(* impulse.c, pair_make and brink_step_impulse_balanced: what b, r.r, mu and the loss of a step are
   off by, and that the filter of its decision is right where it answers.  Unbounded exponents. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding exact_dd_products impulse_dd.
Open Scope R_scope.

Section Pair.
Variables r0 r1 r2 p0 p1 p2 q0 q1 q2 m1 m2 : R. (* r, v1, v2 *)

(* pair_make() *)
Definition v0 := normal (p0 - q0).
Definition v1 := normal (p1 - q1).
Definition v2 := normal (p2 - q2).
Definition b := sum3 (dd_mul_d v0 r0) (dd_mul_d v1 r1) (dd_mul_d v2 r2).
Definition rr := sum3 (normal (r0 * r0)) (normal (r1 * r1)) (normal (r2 * r2)).
Definition mass := normal (m1 + m2).
Definition k1 := dd_div (Dd m2 0) mass.
Definition mu := dd_mul_d k1 m1.

(* As they are meant. *)
Let B := r0 * (p0 - q0) + r1 * (p1 - q1) + r2 * (p2 - q2).
Let P := Rabs (r0 * (p0 - q0)) + Rabs (r1 * (p1 - q1)) + Rabs (r2 * (p2 - q2)).
Let Q := r0 * r0 + r1 * r1 + r2 * r2.
Let Mu := m1 * m2 / (m1 + m2).

Lemma b_is_close : Rabs (total b - B) <= 12 * u * u * P.
Proof.
assert (N : forall p q x, let y := dd_mul_d (normal (p - q)) x in
  is_dd y /\ near (22 / 10) (total y) (x * (p - q))).
{ intros p q x y; split; [apply normal_is_dd |]; destruct (normal_is_dd (p - q)) as [D E].
  assert (F := dd_mul_d_near (normal (p - q)) x D); rewrite E in F; rewrite Rmult_comm; exact F. }
destruct (N p0 q0 r0) as [D0 N0], (N p1 q1 r1) as [D1 N1], (N p2 q2 r2) as [D2 N2].
fold v0 in D0, N0; fold v1 in D1, N1; fold v2 in D2, N2.
assert (S := sum3_is_close _ _ _ D0 D1 D2); fold b in S; unfold B, P, near in *.
set (y0 := total (dd_mul_d v0 r0)) in *; set (y1 := total (dd_mul_d v1 r1)) in *.
set (y2 := total (dd_mul_d v2 r2)) in *; set (s := total b) in *.
set (z0 := r0 * (p0 - q0)) in *; set (z1 := r1 * (p1 - q1)) in *.
set (z2 := r2 * (p2 - q2)) in *; clearbody y0 y1 y2 s z0 z1 z2; clear N D0 D1 D2.
assert (L : forall y z, Rabs y <= Rabs (y - z) + Rabs z)
  by (intros; unfold Rabs; repeat destruct Rcase_abs; lra).
assert (L0 := L y0 z0); assert (L1 := L y1 z1); assert (L2 := L y2 z2).
assert (T : Rabs (s - (z0 + z1 + z2)) <=
  Rabs (s - (y0 + y1 + y2)) + (Rabs (y0 - z0) + Rabs (y1 - z1) + Rabs (y2 - z2))).
{ replace (s - (z0 + z1 + z2)) with
    (s - (y0 + y1 + y2) + (y0 - z0 + (y1 - z1) + (y2 - z2))) by ring.
  assert (A := Rabs_triang (s - (y0 + y1 + y2)) (y0 - z0 + (y1 - z1) + (y2 - z2))).
  assert (A' := Rabs_triang (y0 - z0 + (y1 - z1)) (y2 - z2)).
  assert (A'' := Rabs_triang (y0 - z0) (y1 - z1)); lra. }
assert (0 <= Rabs z0) by apply Rabs_pos; assert (0 <= Rabs z1) by apply Rabs_pos.
assert (0 <= Rabs z2) by apply Rabs_pos; unfold u in *; lra.
Qed.

Lemma rr_is_close : near 10 (total rr) Q.
Proof.
assert (N := fun x => normal_is_dd (x * x)); destruct (N r0) as [D0 E0], (N r1) as [D1 E1].
destruct (N r2) as [D2 E2]; assert (S := sum3_is_close _ _ _ D0 D1 D2); fold rr in S.
rewrite E0, E1, E2 in S; fold Q in S; unfold near.
assert (G : forall x, 0 <= x * x) by (intro; apply Rle_0_sqr).
rewrite !(Rabs_pos_eq (_ * _)) in S by apply G; fold Q in S.
assert (0 <= Q) by (unfold Q; generalize (G r0) (G r1) (G r2); lra).
rewrite (Rabs_pos_eq Q) by assumption; unfold u in *; lra.
Qed.

Hypotheses (F2 : is_double m2) (M1 : 0 < m1) (M2 : 0 < m2).

Lemma mass_is_dd : is_dd mass /\ total mass = m1 + m2 /\ 0 < hi mass.
Proof.
destruct (normal_is_dd (m1 + m2)) as [D E]; repeat split; try assumption.
apply (dd_sign _ D); lra.
Qed.

Lemma Mu_pos : 0 < Mu.
Proof. apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat |]; lra. Qed.

Lemma mu_is_close : is_dd mu /\ near (155 / 10) (total mu) Mu /\ 0 < hi mu.
Proof.
destruct mass_is_dd as (D & E & F); assert (Pm := Mu_pos).
destruct (dd_div_of_double m2 mass F2 M2 F D) as [Dk K]; fold k1 in Dk, K; rewrite E in K.
assert (N := dd_mul_d_near k1 m1 Dk); fold mu in N; split; [apply normal_is_dd |].
assert (K' : near (132 / 10) (total k1 * m1) Mu).
{ unfold near; rewrite (Rabs_pos_eq Mu) by lra; apply (Rmult_le_reg_r (m1 + m2)); [lra |].
  rewrite <- (Rabs_pos_eq (m1 + m2)) at 1 by lra; rewrite <- Rabs_mult.
  replace ((total k1 * m1 - Mu) * (m1 + m2)) with (m1 * (total k1 * (m1 + m2) - m2))
    by (unfold Mu; field; lra).
  replace (132 / 10 * u * u * Mu * (m1 + m2)) with (m1 * (132 / 10 * u * u * m2))
    by (unfold Mu; field; lra).
  rewrite Rabs_mult, (Rabs_pos_eq m1) by lra; apply Rmult_le_compat_l; [lra | exact K]. }
assert (T := near_trans _ _ _ _ _ N K' ltac:(lra) ltac:(lra)).
assert (N' : near (155 / 10) (total mu) Mu).
{ unfold near in *; assert (0 <= Rabs Mu) by apply Rabs_pos; unfold u in *; lra. }
split; [exact N' |].
assert (Dm : is_dd mu) by apply normal_is_dd; destruct (dd_sign mu Dm) as [G _]; apply G.
unfold near in N'; rewrite (Rabs_pos_eq Mu) in N' by lra; apply Rabs_le_inv in N'.
unfold u in N'; lra.
Qed.

(* --- A step ------------------------------------------------------------------- *)

Variables way rise top : R. (* way 1 or -1; top: 2^900, for all rises that are higher *)
Hypothesis Way : way = 1 \/ way = -1.

Definition s := Dd (way * hi b) (way * lo b). (* by 1 or -1: exact *)
Definition ss := dd_mul s s.
Definition loss := dd_div (dd_mul_d rr (2 * Rmin rise top)) mu.
Definition rest := dd_add ss (dd_negate loss).

Lemma way_size : Rabs way = 1.
Proof. destruct Way as [-> | ->]; unfold Rabs; destruct Rcase_abs; lra. Qed.

Let S := way * B.
Let L := 2 * Rmin rise top * Q / Mu.

Lemma s_is_close : is_dd s /\ Rabs (total s - S) <= 12 * u * u * P.
Proof.
assert (D : is_dd b) by apply normal_is_dd; assert (C := b_is_close).
assert (W : forall x, Rabs (way * x) = Rabs x).
{ intro; rewrite Rabs_mult, way_size; ring. }
unfold is_dd, total, s in *; cbn [hi lo]; rewrite !W; split; [exact D |].
unfold S; rewrite <- Rmult_plus_distr_l, <- Rmult_minus_distr_l, W; exact C.
Qed.

Lemma loss_is_close : is_dd loss /\ near 41 (total loss) L.
Proof.
destruct mu_is_close as (Dm & Nm & Fm); assert (Pm := Mu_pos).
split; [apply normal_is_dd |].
assert (Dr : is_dd rr) by apply normal_is_dd; assert (Nr := rr_is_close).
assert (N1 := dd_mul_d_near rr (2 * Rmin rise top) Dr).
set (X := dd_mul_d rr (2 * Rmin rise top)) in *; assert (Dx : is_dd X) by apply normal_is_dd.
assert (N2 := dd_div_near X mu (normal_is_double _) Dx Fm Dm); change (dd_div X mu) with loss in N2.
assert (N3 : near 10 (total rr * (2 * Rmin rise top)) (2 * Rmin rise top * Q)).
{ unfold near in *; rewrite Rmult_comm, <- Rmult_minus_distr_l, !(Rabs_mult (2 * _)).
  replace (10 * u * u * (Rabs (2 * Rmin rise top) * Rabs Q)) with
    (Rabs (2 * Rmin rise top) * (10 * u * u * Rabs Q)) by ring.
  apply Rmult_le_compat_l; [apply Rabs_pos | exact Nr]. }
assert (N4 := near_trans _ _ _ _ _ N1 N3 ltac:(lra) ltac:(lra)).
assert (N5 := near_trans _ _ _ _ _ N2 N4 ltac:(lra) ltac:(lra)).
assert (N6 := near_quotient _ _ _ _ _ _ N5 Nm ltac:(lra) ltac:(lra) (Rgt_not_eq _ _ Pm)).
fold L in N6; clear - N6; unfold near in *; assert (0 <= Rabs L) by apply Rabs_pos.
unfold u in *; lra.
Qed.

(* What is left, to some u^2 of what it is made of. *)
Lemma rest_is_close : is_dd rest /\ Rabs S <= P /\
  Rabs (total rest - (S * S - L)) <= u * u * (34 * (P * P) + 45 * Rabs L).
Proof.
destruct s_is_close as [Ds Cs], loss_is_close as [Dl Nl]; split; [apply normal_is_dd |].
assert (Sp : Rabs S <= P).
{ unfold S, P, B; rewrite Rabs_mult, way_size, Rmult_1_l.
  eapply Rle_trans; [apply Rabs_triang |]; apply Rplus_le_compat_r.
  apply Rabs_triang. }
split; [exact Sp |].
assert (Nq := dd_mul_near s s Ds Ds); fold ss in Nq; assert (Dq : is_dd ss) by apply normal_is_dd.
assert (Dn := dd_negate_is_dd loss Dl).
assert (C := dd_add_sizes ss (dd_negate loss) Dq Dn); fold rest in C.
rewrite dd_negate_total, Rabs_Ropp in C.
assert (Zl := near_size _ _ _ Nl ltac:(lra)); assert (Zq := near_size _ _ _ Nq ltac:(lra)).
unfold near in *; set (t := total s) in *; set (c := total ss) in *; set (l := total loss) in *.
set (x := total rest) in *; clearbody t c l x; clear Ds Dl Dq Dn.
assert (P0 : 0 <= P) by (apply Rle_trans with (2 := Sp), Rabs_pos).
assert (Tp : Rabs t <= (1 + / 1000 * u) * P).
{ assert (Rabs t <= Rabs (t - S) + Rabs S) by (unfold Rabs; repeat destruct Rcase_abs; lra).
  unfold u in *; lra. }
assert (T2 : Rabs (t * t) <= (1 + / 400 * u) * (P * P)).
{ rewrite Rabs_mult; apply Rle_trans with ((1 + / 1000 * u) * P * ((1 + / 1000 * u) * P)).
  - apply Rmult_le_compat; try apply Rabs_pos; exact Tp.
  - assert (0 <= P * P) by (apply Rmult_le_pos; exact P0); unfold u in *; lra. }
assert (D2 : Rabs (t * t - S * S) <= 2401 / 100 * u * u * (P * P)).
{ replace (t * t - S * S) with ((t - S) * (t + S)) by ring; rewrite Rabs_mult.
  assert (Rabs (t + S) <= (2 + / 1000 * u) * P).
  { eapply Rle_trans; [apply Rabs_triang |]; lra. }
  apply Rle_trans with (12 * u * u * P * ((2 + / 1000 * u) * P)).
  - apply Rmult_le_compat; try apply Rabs_pos; assumption.
  - assert (0 <= P * P) by (apply Rmult_le_pos; exact P0); unfold u in *; lra. }
assert (T : Rabs (x - (S * S - L)) <= Rabs (x - (c + - l)) + Rabs (c - t * t) +
  Rabs (t * t - S * S) + Rabs (l - L)).
{ replace (x - (S * S - L)) with
    (x - (c + - l) + (c - t * t) + (t * t - S * S) + - (l - L)) by ring.
  eapply Rle_trans; [apply Rabs_triang |]; rewrite Rabs_Ropp; apply Rplus_le_compat_r.
  eapply Rle_trans; [apply Rabs_triang |]; apply Rplus_le_compat_r; apply Rabs_triang. }
assert (0 <= P * P) by (apply Rmult_le_pos; exact P0); assert (0 <= Rabs L) by apply Rabs_pos.
unfold u in *; lra.
Qed.

(* The surplus of exact_surplus(): what decides. *)
Definition surplus := m1 * m2 * (B * B) - 2 * rise * Q * (m1 + m2).

Hypotheses (Sizes : P <= 96) (Light : Mu <= 4) (Long : Q = 0 \/ / 2 ^ 104 <= Q).
Hypothesis Top : 2 ^ 130 <= top.

(* The filter: 2^-87 + 2^-98 of the loss. *)
Definition margin := rnd (/ 154742504910672534362390528 + / 316912650057057350374175801344 *
  Rabs (hi loss)).

Theorem filter_is_right :
  (margin < hi rest -> 0 < surplus) /\ (margin < - hi rest -> surplus < 0).
Proof.
destruct rest_is_close as (Dr & Sp & C), loss_is_close as [Dl Nl].
assert (Z := near_size _ _ _ Nl ltac:(lra)); destruct (dd_sign loss Dl) as (_ & _ & _ & Hl).
assert (Hl' : 998 / 1000 * Rabs L <= Rabs (hi loss)).
{ clear - Z Hl; unfold u in *; lra. }
assert (P0 : 0 <= P) by (apply Rle_trans with (2 := Sp), Rabs_pos).
assert (P2 : P * P <= 96 * 96) by (apply Rmult_le_compat; lra).
assert (L0 := Rabs_pos L).
assert (G : u * u * (34 * (P * P) + 45 * Rabs L) <= 998 / 1000 * margin).
{ unfold margin; rewrite rounded.
  match goal with |- context [low ?e] => assert (W := low_own e); rewrite (Rabs_pos_eq e) in W
    by lra; set (w := low e) in * end.
  clearbody w; unfold u in *; lra. }
destruct (dd_sign rest Dr) as (Pr & Nr & Hr & _).
assert (Pm := Mu_pos).
assert (Sg : S * S - 2 * rise * Q / Mu = surplus * / (m1 * m2)).
{ unfold surplus, Mu; replace (S * S) with (B * B)
    by (unfold S; destruct Way as [-> | ->]; ring); field; repeat split; lra. }
assert (I : 0 < / (m1 * m2)) by (apply Rinv_0_lt_compat, Rmult_lt_0_compat; lra).
assert (Q0 : 0 <= Q) by (destruct Long as [-> | H]; [lra |]; apply Rle_trans with (2 := H); lra).
assert (M0 : 0 <= margin).
{ assert (0 <= u * u * (34 * (P * P) + 45 * Rabs L)); [| lra].
  assert (0 <= P * P) by (apply Rmult_le_pos; exact P0).
  repeat apply Rmult_le_pos; unfold u; lra. }
(* a rise beyond top is one, and so is what stands for it *)
assert (H : Rmin rise top = rise \/ (Rmin rise top = top /\ top <= rise /\
  (Q = 0 \/ S * S - L < 0))).
{ unfold Rmin at 1 2; destruct (Rle_dec rise top) as [A | A]; [left; reflexivity | right].
  split; [reflexivity |]; split; [lra |].
  destruct Long as [O | O]; [left; exact O | right].
  assert (S * S <= P * P).
  { replace (S * S) with (Rabs S * Rabs S) by (rewrite <- Rabs_mult; apply Rabs_pos_eq, Rle_0_sqr).
    apply Rmult_le_compat; try apply Rabs_pos; exact Sp. }
  unfold L; rewrite Rmin_right by lra.
  assert (2 ^ 130 * / 2 ^ 104 <= top * Q) by (apply Rmult_le_compat; lra).
  assert (2 * top * Q / Mu * Mu = 2 * top * Q) by (field; lra).
  assert (T0 : 0 <= 2 * top * Q / Mu).
  { apply Rmult_le_pos; [| apply Rlt_le, Rinv_0_lt_compat; lra].
    repeat apply Rmult_le_pos; lra. }
  assert (2 * top * Q / Mu * Mu <= 2 * top * Q / Mu * 4) by (apply Rmult_le_compat_l; lra).
  lra. }
split; intro F.
- assert (E : Rabs (hi rest) = hi rest) by (apply Rabs_pos_eq; lra).
  assert (0 < total rest) by (apply Pr; lra); rewrite E in Hr.
  rewrite (Rabs_pos_eq (total rest)) in Hr by lra; apply Rabs_le_inv in C.
  assert (A : 0 < S * S - L) by lra.
  apply (Rmult_lt_reg_r (/ (m1 * m2))); [exact I |]; rewrite Rmult_0_l, <- Sg.
  destruct H as [H | (H & _ & [O | H'])]; [| | lra].
  + unfold L in A; rewrite H in A; exact A.
  + rewrite O; unfold L in A; rewrite O in A; unfold Rdiv in *; lra.
- assert (E : Rabs (hi rest) = - hi rest) by (apply Rabs_left; lra).
  assert (total rest < 0) by (apply Nr; lra); rewrite E in Hr.
  rewrite (Rabs_left (total rest)) in Hr by lra; apply Rabs_le_inv in C.
  assert (S * S - L < 0) by lra.
  apply (Rmult_lt_reg_r (/ (m1 * m2))); [exact I |]; rewrite Rmult_0_l, <- Sg.
  apply Rle_lt_trans with (S * S - L); [| lra].
  apply Rplus_le_compat_l, Ropp_le_contravar; unfold L.
  apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat; lra |].
  apply Rmult_le_compat_r; [exact Q0 |]; apply Rmult_le_compat_l; [lra |]; apply Rmin_l.
Qed.
End Pair.
