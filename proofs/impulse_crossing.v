(* with: rounding.v exact_dd_products.v impulse_dd.v impulse_sums.v impulse_kick.v *)
(* with: impulse_decision.v impulse_change.v *)
(* SPDX-License-Identifier: MIT *)
(* impulse.c, a crossing from end to end, a capture or a release, with nothing owed before:
   BRINK_IMPULSE_ENERGY_ULP 4 but for its 2^-45th part, and BRINK_IMPULSE_BALANCE 0x1p-96 of the
   larger kinetic energy.  Unbounded exponents. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding exact_dd_products impulse_dd impulse_decision impulse_sums.
From Brink Require Import impulse_kick impulse_change.
Open Scope R_scope.

(* What is computed of S and L is t and l, and T of t^2 - l; x is how s changes then. *)
Section Crossed.
Variables S L P g t l T : R.
Hypotheses (Sp : Rabs S <= P) (Pg : P <= g) (Lg : Rabs L <= g * g).
Hypothesis Crosses : 0 < S * S - L <= g * g.
Hypotheses (St : Rabs (t - S) <= 12 * u * u * P) (Ll : near 41 l L).
Hypothesis Tl : Rabs (T - (t * t - l)) <= u * u * (96 / 10 * (t * t) + 33 / 10 * Rabs l).

Lemma sizes : 0 <= g /\ Rabs t <= 10001 / 10000 * g /\ 0 <= t * t <= 10001 / 10000 * (g * g) /\
  Rabs l <= 10001 / 10000 * (g * g) /\ T <= 10001 / 10000 * (g * g) /\
  Rabs (t * t - l - (S * S - L)) <= 66 * u * u * (g * g).
Proof.
unfold near in Ll.
assert (G0 : 0 <= g) by (generalize (Rabs_pos S); lra).
assert (A : Rabs t <= 100001 / 100000 * g).
{ assert (Rabs t <= Rabs (t - S) + Rabs S) by (unfold Rabs; repeat destruct Rcase_abs; lra).
  unfold u in *; lra. }
assert (Tt : Rabs t * Rabs t = t * t) by (rewrite <- Rabs_mult; apply Rabs_pos_eq, Rle_0_sqr).
assert (t * t <= 100001 / 100000 * g * (100001 / 100000 * g))
  by (rewrite <- Tt; apply Rmult_le_compat; try apply Rabs_pos; exact A).
assert (0 <= g * g) by (apply Rmult_le_pos; exact G0).
assert (D : Rabs (t * t - S * S) <= 12 * u * u * g * (2001 / 1000 * g)).
{ replace (t * t - S * S) with ((t - S) * (t + S)) by ring; rewrite Rabs_mult.
  apply Rmult_le_compat; try apply Rabs_pos; [unfold u in *; lra |].
  apply Rle_trans with (1 := Rabs_triang _ _); lra. }
assert (Al : Rabs l <= Rabs (l - L) + Rabs L) by (unfold Rabs; repeat destruct Rcase_abs; lra).
assert (0 <= t * t) by apply Rle_0_sqr.
assert (E : Rabs (t * t - l - (S * S - L)) <= 66 * u * u * (g * g)).
{ replace (t * t - l - (S * S - L)) with (t * t - S * S + - (l - L)) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; unfold u in *; lra. }
repeat split; try assumption; try (unfold u in *; lra).
apply Rabs_le_inv in Tl; apply Rabs_le_inv in E.
assert (Rabs l <= 10001 / 10000 * (g * g)) by (unfold u in *; lra).
assert (t * t <= 10001 / 10000 * (g * g)) by lra.
set (tt := t * t) in *; set (gg := g * g) in *; set (ss := S * S) in *.
clearbody tt gg ss; unfold u in *; lra.
Qed.

Lemma difference x : Rabs x <= 201 / 100 * g ->
  Rabs (2 * x * (S - t) + (L - l)) <= (2 * 12 * 201 / 100 + 41) * u * u * (g * g).
Proof.
intro X; unfold near in Ll; destruct sizes as (G0 & _).
apply Rle_trans with (1 := Rabs_triang _ _); rewrite !Rabs_mult, (Rabs_pos_eq 2) by lra.
rewrite (Rabs_minus_sym S), (Rabs_minus_sym L).
assert (Rabs x * Rabs (t - S) <= 201 / 100 * g * (12 * u * u * g)).
{ apply Rmult_le_compat; try apply Rabs_pos; [exact X | unfold u in *; lra]. }
unfold u in *; lra.
Qed.

Variable a : R.
Hypothesis A : 0 < a.
Hypothesis Root : Rabs (a * a - T) <= 85 / 10 * u * u * T.

Lemma balance : Rabs (a * a - t * t + l) <= 22 * u * u * (g * g).
Proof.
destruct sizes as (G0 & _ & T2 & L2 & Tg & _).
replace (a * a - t * t + l) with (a * a - T + (T - (t * t - l))) by ring.
apply Rle_trans with (1 := Rabs_triang _ _).
set (tt := t * t) in *; set (gg := g * g) in *; clearbody tt gg; unfold u in *; lra.
Qed.

Lemma by_quotient x : 0 < T -> 0 < t -> near 44 (x * (a + t)) (- l) ->
  Rabs (x * (2 * S + x) + L) <= 240 * u * u * (g * g) /\ Rabs x <= 201 / 100 * g.
Proof.
intros Tp Tt X; destruct sizes as (G0 & _ & T2 & L2 & Tg & _); assert (Ba := balance).
unfold near in X; rewrite Rabs_Ropp in X; set (n := a + t) in *.
assert (N0 : 0 < n) by (unfold n; lra).
assert (N2 : a * a <= n * n /\ t * t <= n * n).
{ unfold n; assert (0 < a * t) by (apply Rmult_lt_0_compat; lra).
  assert (0 <= a * a) by apply Rle_0_sqr; lra. }
assert (Ln : Rabs l <= 1001 / 1000 * (n * n)).
{ apply Rabs_le_inv in Tl; apply Rabs_le_inv in Root.
  assert (0 <= a * a) by apply Rle_0_sqr.
  set (tt := t * t) in *; set (nn := n * n) in *; set (aa := a * a) in *.
  clearbody tt nn aa; clear - Tl Root N2 H Tp T2; unfold u in *; revert Tl.
  unfold Rabs; destruct Rcase_abs; intros; lra. }
assert (Xl : Rabs x * n <= 1001 / 1000 * Rabs l).
{ rewrite <- (Rabs_pos_eq n) by lra; rewrite <- Rabs_mult.
  assert (Rabs (x * n) <= Rabs (x * n - - l) + Rabs l)
    by (unfold Rabs; repeat destruct Rcase_abs; lra).
  generalize (Rabs_pos l); unfold u in *; lra. }
assert (Xn : Rabs x <= 1003 / 1000 * n).
{ apply (Rmult_le_reg_r n); [exact N0 |]; lra. }
assert (X0 := Rabs_pos x).
assert (Xg : Rabs x <= 1005 / 1000 * g).
{ apply square_le; [lra |].
  assert (Rabs x * Rabs x <= Rabs x * (1003 / 1000 * n)) by (apply Rmult_le_compat_l; lra).
  set (gg := g * g) in *; replace (1005 / 1000 * g * (1005 / 1000 * g)) with
    (1005 / 1000 * 1005 / 1000 * gg) by (unfold gg; field); lra. }
split; [| lra].
assert (D := difference x ltac:(lra)).
assert (E : Rabs ((x - (a - t)) * n) <= 67 * u * u * (g * g)).
{ replace ((x - (a - t)) * n) with (x * n - - l + - (a * a - t * t + l)) by (unfold n; ring).
  apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp.
  set (gg := g * g) in *; clearbody gg; unfold u in *; lra. }
assert (F : Rabs (x * (x - (a - t))) <= 1003 / 1000 * (67 * u * u * (g * g))).
{ rewrite Rabs_mult in *; rewrite (Rabs_pos_eq n) in E by lra.
  assert (Rabs x * Rabs (x - (a - t)) <= 1003 / 1000 * n * Rabs (x - (a - t)))
    by (apply Rmult_le_compat_r; [apply Rabs_pos | exact Xn]).
  lra. }
replace (x * (2 * S + x) + L) with
  (x * (x - (a - t)) + (x * n - - l) + (2 * x * (S - t) + (L - l))) by (unfold n; ring).
apply Rle_trans with (1 := Rabs_triang _ _).
assert (G := Rabs_triang (x * (x - (a - t))) (x * n - - l)).
set (gg := g * g) in *; clearbody gg; unfold u in *; lra.
Qed.

Lemma by_difference x : 0 < T -> t <= 0 -> near 30 x (a - t) ->
  Rabs (x * (2 * S + x) + L) <= 240 * u * u * (g * g) /\ Rabs x <= 201 / 100 * g.
Proof.
intros Tp Tt X; destruct sizes as (G0 & Tg & T2 & L2 & Tgg & _); assert (Ba := balance).
unfold near in X; rewrite (Rabs_pos_eq (a - t)) in X by lra.
rewrite (Rabs_left1 t) in Tg by lra.
assert (Ag : a <= 1001 / 1000 * g).
{ apply square_le; [lra |]; apply Rabs_le_inv in Root.
  set (gg := g * g) in *; replace (1001 / 1000 * g * (1001 / 1000 * g)) with
    (1001 / 1000 * 1001 / 1000 * gg) by (unfold gg; field); unfold u in *; lra. }
assert (Cg : a - t <= 2002 / 1000 * g) by lra.
assert (Xg : Rabs x <= 201 / 100 * g).
{ apply Rabs_le_inv in X; apply Rabs_le; unfold u in *; lra. }
split; [| exact Xg]; assert (D := difference x Xg).
assert (F : Rabs ((x - (a - t)) * (x + (a - t) + 2 * t)) <=
  30 * u * u * (2002 / 1000 * g) * (2003 / 1000 * g)).
{ rewrite Rabs_mult; apply Rmult_le_compat; try apply Rabs_pos; [unfold u in *; lra |].
  apply Rabs_le_inv in X; apply Rabs_le; unfold u in *; lra. }
replace (x * (2 * S + x) + L) with
  ((x - (a - t)) * (x + (a - t) + 2 * t) + (a * a - t * t + l) + (2 * x * (S - t) + (L - l)))
  by ring.
apply Rle_trans with (1 := Rabs_triang _ _).
assert (G := Rabs_triang ((x - (a - t)) * (x + (a - t) + 2 * t)) (a * a - t * t + l)).
set (gg := g * g) in *; replace (30 * u * u * (2002 / 1000 * g) * (2003 / 1000 * g)) with
  (30 * u * u * (2002 / 1000) * (2003 / 1000) * gg) in F by (unfold gg; ring).
clearbody gg; unfold u in *; lra.
Qed.
End Crossed.

(* Where nothing is left of it. *)
Lemma stopped S L P g t l T x : Rabs S <= P -> P <= g -> Rabs L <= g * g ->
  0 < S * S - L <= g * g -> Rabs (t - S) <= 12 * u * u * P -> near 41 l L ->
  Rabs (T - (t * t - l)) <= u * u * (96 / 10 * (t * t) + 33 / 10 * Rabs l) ->
  T <= 0 -> near 30 x (- t) ->
  Rabs (x * (2 * S + x) + L) <= 240 * u * u * (g * g) /\ Rabs x <= 201 / 100 * g.
Proof.
intros Sp Pg Lg C St Ll Tl T0 X.
destruct (sizes S L P g t l T Sp Pg Lg C St Ll Tl) as (G0 & Tg & T2 & L2 & _ & E).
unfold near in X; rewrite Rabs_Ropp in X.
assert (Xg : Rabs x <= 201 / 100 * g).
{ assert (Rabs x <= Rabs (x - - t) + Rabs t) by (unfold Rabs; repeat destruct Rcase_abs; lra).
  unfold u in *; lra. }
split; [| exact Xg].
assert (Xs : Rabs (x + S) <= / 1000 * u * g).
{ replace (x + S) with (x - - t + - (t - S)) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; unfold u in *; lra. }
assert (X2 : Rabs ((x + S) * (x + S)) <= / 1000 * u * g * (/ 1000 * u * g)).
{ rewrite Rabs_mult; apply Rmult_le_compat; try apply Rabs_pos; exact Xs. }
replace (x * (2 * S + x) + L) with ((x + S) * (x + S) + - (S * S - L)) by ring.
apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp, (Rabs_pos_eq (_ - _)) by lra.
apply Rabs_le_inv in E; apply Rabs_le_inv in Tl.
set (gg := g * g) in *; replace (/ 1000 * u * g * (/ 1000 * u * g)) with
  (/ 1000 * / 1000 * u * u * gg) in X2 by (unfold gg; ring).
set (tt := t * t) in *; set (ss := S * S) in *; clearbody gg tt ss; unfold u in *; lra.
Qed.

Section Crossing.
Variables r0 r1 r2 p0 p1 p2 q0 q1 q2 m1 m2 way rise top : R.
Hypotheses (F1 : is_double m1) (F2 : is_double m2) (M1 : 0 < m1) (M2 : 0 < m2).
Hypothesis Apart : 0 < r0 * r0 + r1 * r1 + r2 * r2.
Hypothesis Way : way = 1 \/ way = -1.
Let Mu := m1 * m2 / (m1 + m2).
Let B := r0 * (p0 - q0) + r1 * (p1 - q1) + r2 * (p2 - q2).
Let P := Rabs (r0 * (p0 - q0)) + Rabs (r1 * (p1 - q1)) + Rabs (r2 * (p2 - q2)).
Let Q := r0 * r0 + r1 * r1 + r2 * r2.
Let V := (p0 - q0) * (p0 - q0) + (p1 - q1) * (p1 - q1) + (p2 - q2) * (p2 - q2).
Let speed := s r0 r1 r2 p0 p1 p2 q0 q1 q2 way.
Let speed2 := dd_mul speed speed.
Let lost := loss r0 r1 r2 m1 m2 rise top.
Let kept := rest r0 r1 r2 p0 p1 p2 q0 q1 q2 m1 m2 way rise top.

(* crossed(), by what is left of s^2 and the sign of s. *)
Definition along :=
  if Rlt_dec 0 (hi kept) then
    if Rlt_dec 0 (hi speed) then dd_div (dd_negate lost) (dd_add (dd_sqrt kept) speed)
    else dd_add (dd_sqrt kept) (dd_negate speed)
  else dd_add zero (dd_negate speed).
Definition paid := dd_add_d along 0.
Definition crossed := Dd (way * hi paid) (way * lo paid). (* by 1 or -1: exact *)

(* What decides, and rises that the pair can climb are less than what stands for the higher. *)
Hypothesis Surplus : 0 < surplus r0 r1 r2 p0 p1 p2 q0 q1 q2 m1 m2 rise.
Hypothesis Top : Mu * V / 2 <= top.

Let L := 2 * rise * Q / Mu.
Let S := way * B.

Lemma mu_pos : 0 < Mu.
Proof. apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat |]; lra. Qed.

Lemma climbs : 0 < S * S - L /\ Rmin rise top = rise /\ Rabs S <= P.
Proof.
assert (Mp := mu_pos); assert (Q0 : 0 < Q) by exact Apart.
assert (W : S * S = B * B) by (unfold S; destruct Way as [Wy | Wy]; rewrite Wy; ring).
assert (A : 0 < S * S - L).
{ rewrite W; unfold surplus in Surplus; fold B Q in Surplus.
  replace (B * B - L) with ((m1 * m2 * (B * B) - 2 * rise * Q * (m1 + m2)) / (m1 * m2))
    by (unfold L, Mu; field; repeat split; lra).
  apply Rdiv_lt_0_compat; [exact Surplus | apply Rmult_lt_0_compat; lra]. }
assert (Bp : Rabs B <= P).
{ unfold B, P; eapply Rle_trans; [apply Rabs_triang |]; apply Rplus_le_compat_r, Rabs_triang. }
assert (Sp : Rabs S <= P).
{ unfold S; rewrite Rabs_mult, way_size, Rmult_1_l by exact Way; exact Bp. }
repeat split; try assumption; apply Rmin_left, Rle_trans with (2 := Top).
assert (H := cauchy r0 r1 r2 (p0 - q0) (p1 - q1) (p2 - q2)); cbv zeta in H; fold P Q V in H.
assert (S * S <= P * P).
{ replace (S * S) with (Rabs S * Rabs S) by (rewrite <- Rabs_mult; apply Rabs_pos_eq, Rle_0_sqr).
  apply Rmult_le_compat; try apply Rabs_pos; exact Sp. }
apply (Rmult_le_reg_l (2 * Q / Mu)); [apply Rdiv_lt_0_compat; lra |].
replace (2 * Q / Mu * rise) with L by (unfold L; field; lra).
replace (2 * Q / Mu * (Mu * V / 2)) with (Q * V) by (field; lra); lra.
Qed.

Lemma crossing_is_right : let x := made r0 r1 r2 crossed in exists g,
  Rabs (x * (2 * B + x) + L) <= 240 * u * u * (g * g) /\ Rabs x <= 201 / 100 * g /\ P <= g /\
  (g * g <= P * P \/ g * g <= P * P - L).
Proof.
intro x; destruct climbs as (C & R & Sp); assert (Q0 : 0 < Q) by exact Apart.
assert (P0 : 0 <= P) by (apply Rle_trans with (2 := Sp), Rabs_pos).
assert (S2 : S * S <= P * P).
{ replace (S * S) with (Rabs S * Rabs S) by (rewrite <- Rabs_mult; apply Rabs_pos_eq, Rle_0_sqr).
  apply Rmult_le_compat; try apply Rabs_pos; exact Sp. }
(* g^2 is P^2 or P^2 - L *)
assert (G : exists g, P <= g /\ Rabs L <= g * g /\ S * S - L <= g * g /\
  (g * g <= P * P \/ g * g <= P * P - L)).
{ assert (0 <= S * S) by apply Rle_0_sqr; destruct (Rle_or_lt 0 L) as [L0 | L0].
  - exists P; rewrite (Rabs_pos_eq L) by exact L0; repeat split; lra.
  - assert (0 <= P * P) by (apply Rmult_le_pos; exact P0).
    exists (sqrt (P * P - L)); rewrite sqrt_sqrt, (Rabs_left L) by lra; repeat split; try lra.
    rewrite <- (sqrt_square P) at 1 by exact P0; apply sqrt_le_1_alt; lra. }
destruct G as (g & Pg & Lg & Sg & G); exists g; rewrite <- and_assoc; split; [| split; assumption].
(* what is computed *)
destruct (s_is_close r0 r1 r2 p0 p1 p2 q0 q1 q2 way Way) as [Ds Cs].
destruct (loss_is_close r0 r1 r2 m1 m2 F2 M1 M2 rise top) as [Dl Nl]; rewrite R in Nl.
change (is_dd speed) in Ds; change (Rabs (total speed - S) <= 12 * u * u * P) in Cs.
change (is_dd lost) in Dl; change (near 41 (total lost) L) in Nl.
assert (Nq := dd_mul_near speed speed Ds Ds); fold speed2 in Nq.
assert (Dq : is_dd speed2) by apply normal_is_dd.
assert (Nd := dd_add_sizes speed2 (dd_negate lost) Dq (dd_negate_is_dd lost Dl)).
change (dd_add speed2 (dd_negate lost)) with kept in Nd; rewrite dd_negate_total, Rabs_Ropp in Nd.
assert (Dr : is_dd kept) by apply normal_is_dd.
assert (Tl : Rabs (total kept - (total speed * total speed - total lost)) <=
  u * u * (96 / 10 * (total speed * total speed) + 33 / 10 * Rabs (total lost))).
{ set (tt := total speed * total speed) in *; assert (T0 : 0 <= tt) by apply Rle_0_sqr.
  unfold near in Nq; rewrite (Rabs_pos_eq tt) in Nq by exact T0.
  assert (Rabs (total speed2) <= Rabs (total speed2 - tt) + tt)
    by (unfold Rabs; repeat destruct Rcase_abs; lra).
  replace (total kept - (tt - total lost)) with
    (total kept - (total speed2 + - total lost) + (total speed2 - tt)) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _).
  assert (0 <= Rabs (total lost)) by apply Rabs_pos; unfold u in *; lra. }
(* what is made of it *)
assert (Fd : is_double (hi crossed)).
{ unfold crossed; cbn [hi]; destruct Way as [Wy | Wy]; rewrite Wy; [rewrite Rmult_1_l |
    replace (-1 * hi paid) with (- hi paid) by ring; apply generic_format_opp];
    apply normal_is_double. }
assert (Dp : is_dd paid) by apply normal_is_dd.
assert (Dc : is_dd crossed).
{ unfold is_dd, crossed in *; cbn [hi lo]; rewrite !Rabs_mult, way_size, !Rmult_1_l by exact Way.
  exact Dp. }
assert (Da : is_dd along) by (unfold along; repeat destruct Rlt_dec; apply normal_is_dd).
assert (Made : exists y, x = way * y /\ near (267 / 10 + / 100) y (total along)).
{ assert (N := made_is_close r0 r1 r2 Apart crossed Fd Dc); fold x in N.
  assert (E : total crossed = way * total paid) by (unfold total, crossed; cbn [hi lo]; ring).
  exists (way * x); split; [destruct Way as [Wy | Wy]; rewrite Wy; ring |].
  assert (N1 : near (233 / 10) (way * x) (total paid)).
  { unfold near in *; rewrite E, (Rabs_mult way), (way_size way Way), Rmult_1_l in N.
    replace (way * x - total paid) with (way * (x - way * total paid))
      by (destruct Way as [Wy | Wy]; rewrite Wy; ring).
    rewrite Rabs_mult, (way_size way Way), Rmult_1_l; exact N. }
  assert (N2 := near_trans _ _ _ _ _ N1 (dd_add_0_near along Da) ltac:(lra) ltac:(lra)).
  unfold near in *; assert (0 <= Rabs (total along)) by apply Rabs_pos; unfold u in *; lra. }
destruct Made as (y & Ex & Ny).
replace (x * (2 * B + x)) with (y * (2 * S + y))
  by (rewrite Ex; unfold S; destruct Way as [Wy | Wy]; rewrite Wy; ring).
replace (Rabs x) with (Rabs y) by (rewrite Ex, Rabs_mult, (way_size way Way); ring).
assert (Cg : 0 < S * S - L <= g * g) by (split; assumption).
destruct (dd_sign speed Ds) as [Ss _]; destruct (dd_sign kept Dr) as [Sr _].
assert (Root : 0 < hi kept -> is_dd (dd_sqrt kept) /\ 0 < total (dd_sqrt kept) /\
  Rabs (total (dd_sqrt kept) * total (dd_sqrt kept) - total kept) <=
    85 / 10 * u * u * total kept).
{ intro H; destruct (dd_sqrt_is_close kept (normal_is_double _) H Dr) as [D E].
  split; [exact D |]; apply Sr in H; assert (Pz := sqrt_lt_R0 _ H).
  assert (Z := sqrt_sqrt _ (Rlt_le _ _ H)).
  set (z := sqrt (total kept)) in *; set (a := total (dd_sqrt kept)) in *; clearbody z a.
  apply Rabs_le_inv in E; split; [unfold u in *; lra |]; rewrite <- Z.
  replace (a * a - z * z) with ((a - z) * (a + z)) by ring; rewrite Rabs_mult.
  assert (Rabs (a - z) * Rabs (a + z) <= 42 / 10 * u * u * z * (2001 / 1000 * z)).
  { apply Rmult_le_compat; try apply Rabs_pos; apply Rabs_le; unfold u in *; lra. }
  assert (0 <= z * z) by apply Rle_0_sqr; unfold u in *; lra. }
unfold along in Ny; destruct (Rlt_dec 0 (hi kept)) as [H | H].
- destruct (Root H) as (Dz & A & Az); apply Sr in H.
  set (z := dd_sqrt kept) in *; destruct (Rlt_dec 0 (hi speed)) as [K | K].
  + apply Ss in K; apply by_quotient with P (total speed) (total lost) (total kept) (total z);
      try assumption.
    set (d := dd_add z speed) in *; assert (Dd' : is_dd d) by apply normal_is_dd.
    assert (Nd' := dd_add_sizes z speed Dz Ds); fold d in Nd'.
    assert (N3 : near (32 / 10) (total d) (total z + total speed)).
    { unfold near; rewrite (Rabs_pos_eq (total z + total speed)) by lra.
      rewrite (Rabs_pos_eq (total z)), (Rabs_pos_eq (total speed)) in Nd' by lra; exact Nd'. }
    assert (Pd : 0 < hi d).
    { destruct (dd_sign d Dd') as [[_ U] _]; apply U; unfold near in N3.
      rewrite (Rabs_pos_eq (total z + total speed)) in N3 by lra; apply Rabs_le_inv in N3.
      unfold u in *; lra. }
    assert (Fl : is_double (hi (dd_negate lost))).
    { unfold dd_negate; cbn [hi]; apply generic_format_opp, normal_is_double. }
    assert (N4 := dd_div_near (dd_negate lost) d Fl (dd_negate_is_dd lost Dl) Pd Dd').
    rewrite dd_negate_total in N4.
    assert (N5 := near_quotient _ _ _ _ _ _ N4 N3 ltac:(lra) ltac:(lra) ltac:(lra)).
    assert (N6 := near_trans _ _ _ _ _ Ny N5 ltac:(lra) ltac:(lra)).
    set (n := total z + total speed) in *; assert (N0 : 0 < n) by (unfold n; lra).
    unfold near in *; replace (y * n - - total lost) with ((y - - total lost / n) * n)
      by (field; lra).
    rewrite Rabs_mult, (Rabs_pos_eq n) by lra; apply (Rmult_le_compat_r n) in N6; [| lra].
    apply Rle_trans with (1 := N6); unfold Rdiv.
    rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq n) by lra.
    match goal with |- ?e * u * u * (?l * / n) * n <= _ =>
      replace (e * u * u * (l * / n) * n) with (e * u * u * l) by (field; lra) end.
    assert (0 <= Rabs (- total lost)) by apply Rabs_pos; unfold u; lra.
  + assert (T0 : total speed <= 0).
    { destruct (Rle_or_lt (total speed) 0) as [U | U]; [exact U | exfalso; apply K, Ss, U]. }
    apply by_difference with P (total speed) (total lost) (total kept) (total z); try assumption.
    assert (N3 := dd_add_sizes z (dd_negate speed) Dz (dd_negate_is_dd speed Ds)).
    rewrite dd_negate_total, Rabs_Ropp in N3.
    assert (N4 : near (32 / 10) (total (dd_add z (dd_negate speed))) (total z - total speed)).
    { unfold near; rewrite (Rabs_pos_eq (total z - total speed)) by lra.
      rewrite (Rabs_pos_eq (total z)), (Rabs_left1 (total speed)) in N3 by lra; exact N3. }
    assert (N5 := near_trans _ _ _ _ _ Ny N4 ltac:(lra) ltac:(lra)).
    unfold near in *; assert (0 <= Rabs (total z - total speed)) by apply Rabs_pos.
    unfold u in *; lra.
- assert (T0 : total kept <= 0).
  { destruct (Rle_or_lt (total kept) 0) as [U | U]; [exact U | exfalso; apply H, Sr, U]. }
  apply stopped with P (total speed) (total lost) (total kept); try assumption.
  assert (O : is_dd zero) by (unfold is_dd, zero; cbn [hi lo]; rewrite Rabs_R0; lra).
  assert (N3 := dd_add_sizes zero (dd_negate speed) O (dd_negate_is_dd speed Ds)).
  rewrite dd_negate_total in N3; replace (total zero) with 0 in N3
    by (unfold total, zero; cbn [hi lo]; ring).
  rewrite Rabs_R0, !Rplus_0_l in N3.
  assert (N5 := near_trans _ _ _ _ _ Ny N3 ltac:(lra) ltac:(lra)).
  unfold near in *; assert (0 <= Rabs (- total speed)) by apply Rabs_pos; unfold u in *; lra.
Qed.

Let kinetic m x y z := m * (x * x + y * y + z * z) / 2.
Let c0 := w0 r0 r1 r2 crossed.
Let c1 := w1 r0 r1 r2 crossed.
Let c2 := w2 r0 r1 r2 crossed.
Let f0 := first0 m1 m2 c0 p0.
Let f1 := first1 m1 m2 c1 p1.
Let f2 := first2 m1 m2 c2 p2.
Let g0 := second0 m1 m2 c0 q0.
Let g1 := second1 m1 m2 c1 q1.
Let g2 := second2 m1 m2 c2 q2.
Let before := kinetic m1 p0 p1 p2 + kinetic m2 q0 q1 q2.
Let after := kinetic m1 (hi f0) (hi f1) (hi f2) + kinetic m2 (hi g0) (hi g1) (hi g2).

Theorem crossing_keeps_energy K :
  kinetic m1 p0 p1 p2 <= K -> kinetic m2 q0 q1 q2 <= K ->
  kinetic m1 (hi f0) (hi f1) (hi f2) <= K -> kinetic m2 (hi g0) (hi g1) (hi g2) <= K ->
  Rabs (after - (before - rise)) <= 4 * u * (1 + / 35184372088832) * K /\
  Rabs (after + owed_after m1 m2 c0 c1 c2 p0 p1 p2 q0 q1 q2 0 - (before - rise)) <=
    1024 * u * u * K.
Proof.
intros B1 B2 A1 A2; destruct crossing_is_right as (g & D & X & Pg & G).
exact (change_keeps_energy r0 r1 r2 p0 p1 p2 q0 q1 q2 m1 m2 F1 F2 M1 M2 Apart crossed rise g K
  D X Pg G B1 B2 A1 A2).
Qed.
End Crossing.
