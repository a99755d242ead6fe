(* with: rounding.v exact_dd_products.v impulse_dd.v impulse_sums.v impulse_kick.v *)
(* with: impulse_decision.v impulse_change.v *)
(* SPDX-License-Identifier: MIT *)
(* impulse.c, brink_rim_impulse_balanced: what the parts are off by that the velocity is turned with:
   the speed along r before and after, and how the rest of it is stretched.  Unbounded exponents. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding exact_dd_products impulse_dd impulse_decision impulse_change.
Open Scope R_scope.

Section Parts.
Variables r0 r1 r2 p0 p1 p2 q0 q1 q2 : R. (* r, v1, v2 *)
Let B := r0 * (p0 - q0) + r1 * (p1 - q1) + r2 * (p2 - q2).
Let Q := r0 * r0 + r1 * r1 + r2 * r2.
Let V := (p0 - q0) * (p0 - q0) + (p1 - q1) * (p1 - q1) + (p2 - q2) * (p2 - q2).
Hypotheses (Apart : 0 < Q) (Moving : 0 < V). (* else there is no rim *)
Let speed := b r0 r1 r2 p0 p1 p2 q0 q1 q2.
Let square := rr r0 r1 r2.
Let d0 := v0 p0 q0.
Let d1 := v1 p1 q1.
Let d2 := v2 p2 q2.

Definition vv := sum3 (dd_mul d0 d0) (dd_mul d1 d1) (dd_mul d2 d2).
Definition root := dd_sqrt (dd_mul square vv).
Definition rim := dd_mul_d root (/ 16777216).
Definition bb := dd_div (dd_mul speed speed) square.
Definition rim2 := dd_div (dd_mul rim rim) square.
Definition share_left := dd_div (dd_add vv (dd_negate rim2)) (dd_add vv (dd_negate bb)).
Definition stretch := dd_sqrt share_left.
Definition along := dd_div speed square.
Definition inward := dd_negate (dd_div rim square).
Hypothesis Slow : Rabs (hi speed) < hi rim.

(* |r| and |v|; and the speed along r. *)
Let R := sqrt Q.
Let W := sqrt V.
Let beta := B / R.

Lemma lengths : 0 < R /\ R * R = Q /\ 0 < W /\ W * W = V.
Proof.
unfold R, W; repeat split; try (apply sqrt_lt_R0; assumption); apply sqrt_sqrt; lra.
Qed.

Lemma speed_is_close : Rabs (total speed - B) <= 12 * u * u * (R * W).
Proof.
assert (C := b_is_close r0 r1 r2 p0 p1 p2 q0 q1 q2); fold speed B in C.
apply Rle_trans with (1 := C); apply Rmult_le_compat_l; [unfold u; lra |].
destruct lengths as (R0 & R2 & W0 & W2); assert (0 < R * W) by (apply Rmult_lt_0_compat; assumption).
apply square_le; [lra |]; replace (R * W * (R * W)) with (Q * V) by (rewrite <- R2, <- W2; ring).
exact (cauchy r0 r1 r2 (p0 - q0) (p1 - q1) (p2 - q2)).
Qed.

Lemma vv_is_close : near (161 / 10) (total vv) V.
Proof.
assert (N : forall p q, let y := dd_mul (normal (p - q)) (normal (p - q)) in
  is_dd y /\ near (63 / 10) (total y) ((p - q) * (p - q))).
{ intros p q y; split; [apply normal_is_dd |]; destruct (normal_is_dd (p - q)) as [D E].
  assert (F := dd_mul_near _ _ D D); rewrite E in F; exact F. }
destruct (N p0 q0) as [D0 N0], (N p1 q1) as [D1 N1], (N p2 q2) as [D2 N2].
assert (S := sum3_is_close _ _ _ D0 D1 D2).
change (sum3 _ _ _) with vv in S; set (y0 := total (dd_mul (normal (p0 - q0)) _)) in *.
set (y1 := total (dd_mul (normal (p1 - q1)) _)) in *.
set (y2 := total (dd_mul (normal (p2 - q2)) _)) in *; unfold near, V in *.
assert (G : forall x, 0 <= x * x) by (intro; apply Rle_0_sqr).
assert (G0 := G (p0 - q0)); assert (G1 := G (p1 - q1)); assert (G2 := G (p2 - q2)).
set (z0 := (p0 - q0) * _) in *; set (z1 := (p1 - q1) * _) in *; set (z2 := (p2 - q2) * _) in *.
rewrite (Rabs_pos_eq z0) in N0 by lra; rewrite (Rabs_pos_eq z1) in N1 by lra.
rewrite (Rabs_pos_eq z2) in N2 by lra; rewrite (Rabs_pos_eq (z0 + z1 + z2)) by lra.
assert (L : forall y z, 0 <= z -> Rabs (y - z) <= 63 / 10 * u * u * z -> Rabs y <= 1001 / 1000 * z).
{ intros y z Z H; apply Rabs_le_inv in H; apply Rabs_le; unfold u in *; lra. }
assert (L0 := L _ _ G0 N0); assert (L1 := L _ _ G1 N1); assert (L2 := L _ _ G2 N2).
apply Rabs_le_inv in N0; apply Rabs_le_inv in N1; apply Rabs_le_inv in N2.
apply Rabs_le_inv in S; set (s := total vv) in *; clearbody s y0 y1 y2 z0 z1 z2.
apply Rabs_le; unfold u in *; lra.
Qed.

Lemma square_is_right : is_dd square /\ near 10 (total square) Q /\ 0 < hi square.
Proof.
assert (D : is_dd square) by apply normal_is_dd; assert (C := rr_is_close r0 r1 r2).
fold square Q in C; repeat split; try assumption; apply (dd_sign square D).
unfold near in C; rewrite (Rabs_pos_eq Q) in C by lra; apply Rabs_le_inv in C.
unfold u in *; lra.
Qed.

Lemma rim_is_close : is_dd rim /\ near 45 (total rim) (/ 16777216 * (R * W)).
Proof.
destruct lengths as (R0 & R2 & W0 & W2); destruct square_is_right as (Dr & Nr & _).
assert (Dv : is_dd vv) by apply normal_is_dd; assert (Nv := vv_is_close).
assert (N := dd_mul_near square vv Dr Dv); set (y := dd_mul square vv) in *.
assert (Dy : is_dd y) by apply normal_is_dd.
assert (P := near_product _ _ _ _ _ _ Nr Nv ltac:(lra) ltac:(lra)).
assert (T := near_trans _ _ _ _ _ N P ltac:(lra) ltac:(lra)).
assert (Y0 : 0 < Q * V) by (apply Rmult_lt_0_compat; assumption).
assert (Hy : 0 < hi y).
{ apply (dd_sign y Dy); assert (S := near_size _ _ _ T ltac:(lra)).
  unfold near in T; rewrite (Rabs_pos_eq (Q * V)) in T by lra; apply Rabs_le_inv in T.
  unfold u in *; lra. }
destruct (dd_sqrt_square y (normal_is_double _) Dy Hy) as (Ds & S0 & Ns).
change (dd_sqrt y) with root in *.
assert (E := near_trans _ _ _ _ _ Ns T ltac:(lra) ltac:(lra)).
replace (Q * V) with (R * W * (R * W)) in E by (rewrite <- R2, <- W2; ring).
apply near_root in E; [| lra | apply Rmult_lt_0_compat; assumption].
assert (M := dd_mul_d_near root (/ 16777216) Ds); fold rim in M.
assert (E' : near (42 + / 10) (total root * / 16777216) (/ 16777216 * (R * W))).
{ unfold near in *; replace (total root * / 16777216 - / 16777216 * (R * W)) with
    (/ 16777216 * (total root - R * W)) by ring.
  rewrite !(Rabs_mult (/ 16777216)), (Rabs_pos_eq (/ 16777216)) by lra.
  generalize (Rabs_pos (R * W)); unfold u in *; lra. }
assert (F := near_trans _ _ _ _ _ M E' ltac:(lra) ltac:(lra)).
split; [apply normal_is_dd |]; unfold near in *.
generalize (Rabs_pos (/ 16777216 * (R * W))); unfold u in *; lra.
Qed.

(* How slow it is along r. *)
Lemma speed_is_small : Rabs (total speed) <= 6 / 100000000 * (R * W) /\
  Rabs B <= 601 / 10000000000 * (R * W).
Proof.
destruct lengths as (R0 & _ & W0 & _); assert (X := Rmult_lt_0_compat _ _ R0 W0).
destruct rim_is_close as [D N]; assert (C := speed_is_close).
assert (Db : is_dd speed) by apply normal_is_dd; destruct (dd_sign speed Db) as (_ & _ & _ & Hb).
destruct (dd_sign rim D) as (_ & _ & Hr & _).
set (x := R * W) in *; unfold near in N; rewrite (Rabs_pos_eq (/ 16777216 * x)) in N by lra.
assert (A : hi rim <= Rabs (hi rim)) by apply Rle_abs.
assert (E : Rabs (total rim) <= Rabs (total rim - / 16777216 * x) + / 16777216 * x)
  by (unfold Rabs; repeat destruct Rcase_abs; lra).
assert (F : Rabs B <= Rabs (total speed - B) + Rabs (total speed))
  by (unfold Rabs; repeat destruct Rcase_abs; lra).
unfold u in *; split; lra.
Qed.

(* x / r.r of an x, as a part of |r|. *)
Lemma over_square x y e : is_double (hi x) -> is_dd x -> near e (total x) y -> 0 <= e <= 300 ->
  near (e + 24) (total (dd_div x square)) (y / Q).
Proof.
intros F D N E; destruct square_is_right as (Ds & Ns & Ps).
assert (T := near_trans _ _ _ _ _ (dd_div_near x square F D Ps Ds) N ltac:(lra) ltac:(lra)).
assert (K := near_quotient _ _ _ _ _ _ T Ns ltac:(lra) ltac:(lra) (Rgt_not_eq _ _ Apart)).
unfold near in *; apply Rle_trans with (1 := K); apply Rmult_le_compat_r; [apply Rabs_pos |].
unfold u; lra.
Qed.

(* What is along r, before and after, times |r|. *)
Lemma along_is_close : let k := total along * R in let l := total inward * R in
  Rabs (k - beta) <= 13 * u * u * W /\ Rabs beta <= 601 / 10000000000 * W /\
  Rabs (l + / 16777216 * W) <= / 100000 * u * u * W.
Proof.
destruct lengths as (R0 & R2 & W0 & W2); intros k l.
destruct speed_is_small as [Hb HB]; assert (C := speed_is_close).
assert (Db : is_dd speed) by apply normal_is_dd; destruct rim_is_close as [Dr Nr].
assert (N0 : near 0 (total speed) (total speed)).
{ unfold near; rewrite Rminus_diag_eq, Rabs_R0 by reflexivity; lra. }
assert (Nk := over_square speed _ 0 (normal_is_double _) Db N0 ltac:(lra)).
assert (Nl := over_square rim _ 45 (normal_is_double _) Dr Nr ltac:(lra)).
change (dd_div speed square) with along in Nk.
assert (L : l = - (total (dd_div rim square) * R)) by (unfold l, inward; rewrite dd_negate_total; ring).
rewrite L; set (y := total (dd_div rim square)) in *; unfold k; set (x := total along) in *.
assert (By : forall z, z / Q * R = z / R) by (intro; rewrite <- R2; field; lra).
assert (Scale : forall e z t, near e z (t / Q) -> Rabs (z * R - t / R) <= e * u * u * Rabs (t / R)).
{ intros e z t N; unfold near in N; rewrite <- By, Rabs_mult, (Rabs_pos_eq R) by lra.
  replace (z * R - t / Q * R) with ((z - t / Q) * R) by ring.
  rewrite Rabs_mult, (Rabs_pos_eq R) by lra; rewrite <- Rmult_assoc.
  apply Rmult_le_compat_r; [lra | exact N]. }
apply Scale in Nk; apply Scale in Nl.
replace (/ 16777216 * (R * W) / R) with (/ 16777216 * W) in Nl by (field; lra).
rewrite (Rabs_pos_eq (/ 16777216 * W)) in Nl by lra.
assert (Over : forall t m, Rabs t <= m * (R * W) -> Rabs (t / R) <= m * W).
{ intros t m H; apply (Rmult_le_reg_r R); [exact R0 |]; rewrite <- (Rabs_pos_eq R) at 2 by lra.
  rewrite <- Rabs_mult; replace (t / R * R) with t by (field; lra); lra. }
apply Over in Hb; apply Over in HB; apply Over in C; fold beta in HB.
replace ((total speed - B) / R) with (total speed / R - beta) in C by (unfold beta; field; lra).
repeat split; [| exact HB |].
- replace (x * R - beta) with (x * R - total speed / R + (total speed / R - beta)) by ring.
  eapply Rle_trans; [apply Rabs_triang |]; unfold u in *; lra.
- rewrite <- Rabs_Ropp; replace (- (- (y * R) + / 16777216 * W)) with (y * R - / 16777216 * W)
    by ring; unfold u in *; lra.
Qed.

(* Its square is what it should be: (V - rim^2 / r.r) / (V - b^2 / r.r). *)
Lemma stretch_is_close : let s := total stretch in is_dd stretch /\ 0 < s <= 1001 / 1000 /\
  Rabs (s * s * (V - beta * beta) - (V - / 281474976710656 * V)) <= 62 * u * u * V.
Proof.
destruct lengths as (R0 & R2 & W0 & W2); intro s.
destruct speed_is_small as [Hb HB]; assert (C := speed_is_close).
assert (Db : is_dd speed) by apply normal_is_dd; destruct rim_is_close as [Dr Nr].
assert (Dv : is_dd vv) by apply normal_is_dd; assert (Nv := vv_is_close).
assert (Nrr := dd_mul_near rim rim Dr Dr); assert (Nbb := dd_mul_near speed speed Db Db).
assert (Np := near_product _ _ _ _ _ _ Nr Nr ltac:(lra) ltac:(lra)).
assert (N3 := over_square (dd_mul speed speed) _ (63 / 10) (normal_is_double _)
  ltac:(apply normal_is_dd) Nbb ltac:(lra)).
change (dd_div (dd_mul speed speed) square) with bb in N3.
assert (X2 : near 122 (total rim2) (/ 281474976710656 * V)).
{ assert (T := near_trans _ _ _ _ _ Nrr Np ltac:(lra) ltac:(lra)).
  assert (T' : near 97 (total (dd_mul rim rim)) (/ 16777216 * (R * W) * (/ 16777216 * (R * W)))).
  { unfold near in *; generalize (Rabs_pos (/ 16777216 * (R * W) * (/ 16777216 * (R * W)))).
    unfold u in *; lra. }
  assert (E := over_square (dd_mul rim rim) _ 97 (normal_is_double _) ltac:(apply normal_is_dd) T'
    ltac:(lra)).
  change (dd_div (dd_mul rim rim) square) with rim2 in E.
  replace (/ 16777216 * (R * W) * (/ 16777216 * (R * W)) / Q) with (/ 281474976710656 * V) in E
    by (rewrite <- R2, <- W2; field; lra).
  unfold near in *; generalize (Rabs_pos (/ 281474976710656 * V)); unfold u in *; lra. }
(* b^2 / r.r *)
set (t := total speed / R); assert (Over : forall x m, Rabs x <= m * (R * W) -> Rabs (x / R) <= m * W).
{ intros x m H; apply (Rmult_le_reg_r R); [exact R0 |]; rewrite <- (Rabs_pos_eq R) at 2 by lra.
  rewrite <- Rabs_mult; replace (x / R * R) with x by (field; lra); lra. }
apply Over in Hb; apply Over in HB; apply Over in C; fold beta in HB; fold t in Hb.
replace ((total speed - B) / R) with (t - beta) in C by (unfold t, beta; field; lra).
replace (total speed * total speed / Q) with (t * t) in N3 by (unfold t; rewrite <- R2; field; lra).
assert (T2 : Rabs (t * t) <= / 100000000000000 * V).
{ rewrite Rabs_mult, <- W2; assert (Rabs t * Rabs t <= 6 / 100000000 * W * (6 / 100000000 * W))
    by (apply Rmult_le_compat; try apply Rabs_pos; exact Hb).
  assert (0 < W * W) by (apply Rmult_lt_0_compat; exact W0); lra. }
assert (B2 : Rabs (beta * beta) <= / 100000000000000 * V).
{ rewrite Rabs_mult, <- W2.
  assert (Rabs beta * Rabs beta <= 601 / 10000000000 * W * (601 / 10000000000 * W))
    by (apply Rmult_le_compat; try apply Rabs_pos; exact HB).
  assert (0 < W * W) by (apply Rmult_lt_0_compat; exact W0); lra. }
assert (Tb : Rabs (t * t - beta * beta) <= / 100000 * u * u * V).
{ replace (t * t - beta * beta) with ((t - beta) * (t + beta)) by ring; rewrite Rabs_mult, <- W2.
  assert (Rabs (t - beta) * Rabs (t + beta) <= 12 * u * u * W * (1201 / 10000000000 * W)).
  { apply Rmult_le_compat; try apply Rabs_pos; [exact C |].
    eapply Rle_trans; [apply Rabs_triang |]; lra. }
  assert (0 < W * W) by (apply Rmult_lt_0_compat; exact W0); unfold u in *; lra. }
set (b2 := beta * beta) in *; set (tt := t * t) in *.
assert (X3 : Rabs (total bb - b2) <= / 10000 * u * u * V).
{ unfold near in N3; replace (total bb - b2) with (total bb - tt + (tt - b2)) by ring.
  eapply Rle_trans; [apply Rabs_triang |]; unfold u in *; lra. }
unfold near in X2, Nv; rewrite (Rabs_pos_eq (/ 281474976710656 * V)) in X2 by lra.
rewrite (Rabs_pos_eq V) in Nv by lra.
(* above and below the line *)
assert (D2 : is_dd rim2) by apply normal_is_dd; assert (D3 : is_dd bb) by apply normal_is_dd.
assert (A := dd_add_sizes vv (dd_negate rim2) Dv (dd_negate_is_dd _ D2)).
assert (A' := dd_add_sizes vv (dd_negate bb) Dv (dd_negate_is_dd _ D3)).
rewrite dd_negate_total, Rabs_Ropp in A, A'.
set (a := dd_add vv (dd_negate rim2)) in *; set (c := dd_add vv (dd_negate bb)) in *.
assert (Da : is_dd a) by apply normal_is_dd; assert (Dc : is_dd c) by apply normal_is_dd.
assert (Sizes : Rabs (total vv) <= 1001 / 1000 * V /\ Rabs (total rim2) <= / 1000 * V /\
  Rabs (total bb) <= / 1000 * V).
{ apply Rabs_le_inv in Nv; apply Rabs_le_inv in X2; apply Rabs_le_inv in X3.
  apply Rabs_le_inv in B2; repeat split; apply Rabs_le; unfold u in *; lra. }
assert (Ca : Rabs (total a - (V - / 281474976710656 * V)) <= 194 / 10 * u * u * V).
{ replace (total a - (V - / 281474976710656 * V)) with (total a - (total vv + - total rim2) +
    (total vv - V) + - (total rim2 - / 281474976710656 * V)) by ring.
  eapply Rle_trans; [apply Rabs_triang |]; rewrite Rabs_Ropp.
  assert (E := Rabs_triang (total a - (total vv + - total rim2)) (total vv - V)).
  unfold u in *; lra. }
assert (Cc : Rabs (total c - (V - b2)) <= 194 / 10 * u * u * V).
{ replace (total c - (V - b2)) with (total c - (total vv + - total bb) + (total vv - V) +
    - (total bb - b2)) by ring.
  eapply Rle_trans; [apply Rabs_triang |]; rewrite Rabs_Ropp.
  assert (E := Rabs_triang (total c - (total vv + - total bb)) (total vv - V)).
  unfold u in *; lra. }
assert (Pa : 999 / 1000 * V <= total a <= 10001 / 10000 * V).
{ apply Rabs_le_inv in Ca; unfold u in *; lra. }
assert (Pc : 9999 / 10000 * V <= total c <= 10001 / 10000 * V).
{ apply Rabs_le_inv in Cc; apply Rabs_le_inv in B2; unfold u in *; lra. }
assert (Hc : 0 < hi c) by (apply (dd_sign c Dc); lra).
assert (Nq := dd_div_near a c (normal_is_double _) Da Hc Dc).
change (dd_div a c) with share_left in Nq; assert (Dq : is_dd share_left) by apply normal_is_dd.
unfold near in Nq; rewrite (Rabs_pos_eq (total a)) in Nq by lra.
assert (Q0 : 0 < total share_left <= 1001 / 1000).
{ apply Rabs_le_inv in Nq; split; apply (Rmult_lt_reg_r (total c)) || apply (Rmult_le_reg_r (total c));
    unfold u in *; lra. }
assert (Hq : 0 < hi share_left) by (apply (dd_sign share_left Dq); lra).
destruct (dd_sqrt_square share_left (normal_is_double _) Dq Hq) as (Ds & S0 & Ns).
change (dd_sqrt share_left) with stretch in *; fold s in S0, Ns; split; [exact Ds |].
unfold near in Ns; rewrite (Rabs_pos_eq (total share_left)) in Ns by lra.
set (q := total share_left) in *; set (ss := s * s) in *.
assert (S2 : 0 <= ss <= 1002 / 1000).
{ split; [apply Rle_0_sqr |]; apply Rabs_le_inv in Ns; unfold u in *; lra. }
split.
{ split; [exact S0 |]; apply square_le; [lra |]; unfold ss in S2; lra. }
replace (ss * (V - b2) - (V - / 281474976710656 * V)) with (- (ss * (total c - (V - b2))) +
  (ss - q) * total c + (q * total c - total a) + (total a - (V - / 281474976710656 * V))) by ring.
assert (E1 : Rabs (ss * (total c - (V - b2))) <= 1002 / 1000 * (194 / 10 * u * u * V)).
{ rewrite Rabs_mult, (Rabs_pos_eq ss) by lra; apply Rmult_le_compat; try apply Rabs_pos; lra. }
assert (E2 : Rabs ((ss - q) * total c) <= 85 / 10 * u * u * (1001 / 1000) * (10001 / 10000 * V)).
{ rewrite Rabs_mult, (Rabs_pos_eq (total c)) by lra.
  apply Rmult_le_compat; try apply Rabs_pos; unfold u in *; lra. }
apply Rabs_le_inv in E1; apply Rabs_le_inv in E2; apply Rabs_le_inv in Nq.
apply Rabs_le_inv in Ca; set (e1 := ss * _) in *; set (e2 := (ss - q) * _) in *.
set (e3 := q * total c - total a) in *; set (e4 := total a - _) in *; clearbody e1 e2 e3 e4.
apply Rabs_le; unfold u in *; lra.
Qed.
End Parts.
