(* with: rounding.v exact_dd_products.v impulse_dd.v impulse_sums.v impulse_kick.v *)
(* with: impulse_decision.v impulse_change.v impulse_payment.v impulse_crossed.v *)
(* SPDX-License-Identifier: MIT *)
(* impulse.c, a crossing from end to end, a capture or a release, whatever was owed before:
   BRINK_IMPULSE_ENERGY_ULP 4 but for its 2^-45th part, and BRINK_IMPULSE_BALANCE 0x1p-96 of the
   larger kinetic energy, and 2^-49 of what was owed.  Unbounded exponents. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding exact_dd_products impulse_dd impulse_decision impulse_sums.
From Brink Require Import impulse_kick impulse_change impulse_payment impulse_crossed.
Open Scope R_scope.

Section Crossing.
Variables r0 r1 r2 p0 p1 p2 q0 q1 q2 m1 m2 way rise top owed : R.
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
Let square := rr r0 r1 r2.
Let reduced := mu m1 m2.
Let kept := rest r0 r1 r2 p0 p1 p2 q0 q1 q2 m1 m2 way rise top.

(* crossed(), by what is left of s^2 and the sign of s, and with what is paid. *)
Definition left_of := if Rlt_dec 0 (hi kept) then dd_sqrt kept else zero.
Definition along :=
  if Rlt_dec 0 (hi kept) then
    if Rlt_dec 0 (hi speed) then dd_div (dd_negate lost) (dd_add (dd_sqrt kept) speed)
    else dd_add (dd_sqrt kept) (dd_negate speed)
  else dd_add zero (dd_negate speed).
Definition paid := payment (hi square) (hi reduced) owed (hi left_of).
Definition left := left_owed (hi square) (hi reduced) owed (hi left_of).
Definition changed := dd_add_d along paid.
Definition crossed := Dd (way * hi changed) (way * lo changed). (* by 1 or -1: exact *)

(* What decides, and rises that the pair can climb are less than what stands for the higher. *)
Hypothesis Surplus : 0 < surplus r0 r1 r2 p0 p1 p2 q0 q1 q2 m1 m2 rise.
Hypothesis Top : Mu * V / 2 <= top.

Let L := 2 * rise * Q / Mu.
Let G := 2 * (owed - left) * Q / Mu.
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
  (Rabs (x * (2 * B + x) + L - G) <= 270 * u * u * (g * g) + 9 * u * Rabs G /\
    Rabs x <= 201 / 100 * g /\ Rabs G <= / 1000000 * (g * g)) /\
  (left = 0 \/ left = owed) /\ P <= g /\ (g * g <= P * P \/ g * g <= P * P - L).
Proof.
intro x; destruct climbs as (C & R & Sp); assert (Q0 : 0 < Q) by exact Apart.
assert (P0 : 0 <= P) by (apply Rle_trans with (2 := Sp), Rabs_pos).
assert (S2 : S * S <= P * P).
{ replace (S * S) with (Rabs S * Rabs S) by (rewrite <- Rabs_mult; apply Rabs_pos_eq, Rle_0_sqr).
  apply Rmult_le_compat; try apply Rabs_pos; exact Sp. }
(* g^2 is P^2 or P^2 - L *)
assert (G0 : exists g, P <= g /\ Rabs L <= g * g /\ S * S - L <= g * g /\
  (g * g <= P * P \/ g * g <= P * P - L)).
{ assert (0 <= S * S) by apply Rle_0_sqr; destruct (Rle_or_lt 0 L) as [L0 | L0].
  - exists P; rewrite (Rabs_pos_eq L) by exact L0; repeat split; lra.
  - assert (0 <= P * P) by (apply Rmult_le_pos; exact P0).
    exists (sqrt (P * P - L)); rewrite sqrt_sqrt, (Rabs_left L) by lra; repeat split; try lra.
    rewrite <- (sqrt_square P) at 1 by exact P0; apply sqrt_le_1_alt; lra. }
destruct G0 as (g & Pg & Lg & Sg & G0); exists g.
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
(* what goes on *)
assert (Cg : 0 < S * S - L <= g * g) by (split; assumption).
destruct (dd_sign speed Ds) as [Ss _]; destruct (dd_sign kept Dr) as [Sr _].
assert (Go : is_dd left_of /\ 0 <= total left_of <= 1001 / 1000 * g /\
  goes_on S L g (total along) (total left_of)).
{ unfold left_of, along; destruct (Rlt_dec 0 (hi kept)) as [H | H].
  - destruct (dd_sqrt_square kept (normal_is_double _) Dr H) as (Dz & A & Az); apply Sr in H.
    unfold near in Az; rewrite (Rabs_pos_eq (total kept)) in Az by lra; split; [exact Dz |].
    set (z := dd_sqrt kept) in *; split.
    { split; [lra |].
      exact (root_size S L P g _ _ _ Sp Pg Lg Cg Cs Nl Tl _ Az H). }
    destruct (Rlt_dec 0 (hi speed)) as [K | K].
    + apply Ss in K; apply by_quotient with P (total speed) (total lost) (total kept);
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
      set (y := total (dd_div (dd_negate lost) d)) in *.
      set (n := total z + total speed) in *; assert (N0 : 0 < n) by (unfold n; lra).
      unfold near in *; replace (y * n - - total lost) with ((y - - total lost / n) * n)
        by (field; lra).
      rewrite Rabs_mult, (Rabs_pos_eq n) by lra; apply (Rmult_le_compat_r n) in N5; [| lra].
      apply Rle_trans with (1 := N5); unfold Rdiv.
      rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq n) by lra.
      match goal with |- ?e * u * u * (?l * / n) * n <= _ =>
        replace (e * u * u * (l * / n) * n) with (e * u * u * l) by (field; lra) end.
      assert (0 <= Rabs (- total lost)) by apply Rabs_pos; unfold u; lra.
    + assert (T0 : total speed <= 0).
      { destruct (Rle_or_lt (total speed) 0) as [U | U]; [exact U | exfalso; apply K, Ss, U]. }
      apply by_difference with P (total speed) (total lost) (total kept); try assumption.
      assert (N3 := dd_add_sizes z (dd_negate speed) Dz (dd_negate_is_dd speed Ds)).
      rewrite dd_negate_total, Rabs_Ropp in N3.
      unfold near; rewrite (Rabs_pos_eq (total z - total speed)) by lra.
      rewrite (Rabs_pos_eq (total z)), (Rabs_left1 (total speed)) in N3 by lra.
      apply Rle_trans with (1 := N3); unfold u; lra.
  - assert (T0 : total kept <= 0).
    { destruct (Rle_or_lt (total kept) 0) as [U | U]; [exact U | exfalso; apply H, Sr, U]. }
    assert (O : is_dd zero) by (unfold is_dd, zero; cbn [hi lo]; rewrite Rabs_R0; lra).
    assert (Oz : total zero = 0) by (unfold total, zero; cbn [hi lo]; ring); rewrite Oz.
    split; [exact O | split; [lra |]].
    apply stopped with P (total speed) (total lost) (total kept); try assumption.
    assert (N3 := dd_add_sizes zero (dd_negate speed) O (dd_negate_is_dd speed Ds)).
    rewrite dd_negate_total, Oz, Rabs_R0, !Rplus_0_l in N3.
    unfold near; assert (0 <= Rabs (- total speed)) by apply Rabs_pos; unfold u in *; lra. }
destruct Go as (Dg & Ga & Go).
(* what is paid *)
assert (Cr := rr_is_close r0 r1 r2); fold square Q in Cr.
destruct (mu_is_close m1 m2 F2 M1 M2) as (Dm & Cm & _); fold reduced in Dm, Cm; fold Mu in Cm.
assert (Mp : 0 < Mu) by exact mu_pos.
assert (Hh : Rabs (hi left_of - total left_of) <= 1002 / 1000 * u * total left_of).
{ rewrite <- (Rabs_pos_eq (total left_of)) at 2 by lra.
  replace (hi left_of - total left_of) with (- lo left_of) by (unfold total; ring).
  rewrite Rabs_Ropp; apply dd_size, Dg. }
assert (H0 : 0 <= hi left_of) by (apply Rabs_le_inv in Hh; unfold u in *; lra).
destruct (payment_pays (hi square) (hi reduced) owed (hi left_of) Q Mu Q0 Mp H0
  (near_high 10 square Q ltac:(apply normal_is_dd) Cr ltac:(lra) Q0)
  (near_high _ reduced Mu Dm Cm ltac:(lra) Mp)) as (Pd & Ph & Pp & Pl).
fold paid left G in Pd, Ph, Pp, Pl.
(* what is made of it *)
assert (Fd : is_double (hi crossed)).
{ unfold crossed; cbn [hi]; destruct Way as [Wy | Wy]; rewrite Wy; [rewrite Rmult_1_l |
    replace (-1 * hi changed) with (- hi changed) by ring; apply generic_format_opp];
    apply normal_is_double. }
assert (Dp : is_dd changed) by apply normal_is_dd.
assert (Dc : is_dd crossed).
{ unfold is_dd, crossed in *; cbn [hi lo]; rewrite !Rabs_mult, way_size, !Rmult_1_l by exact Way.
  exact Dp. }
assert (Da : is_dd along) by (unfold along; repeat destruct Rlt_dec; apply normal_is_dd).
assert (Made : exists y, x = way * y /\
  Rabs (y - (total along + paid)) <= u * u * (29 * Rabs (total along) + 25 * Rabs paid)).
{ assert (N := made_is_close r0 r1 r2 Apart crossed Fd Dc); fold x in N; unfold near in N.
  assert (Cp := dd_add_d_is_close along paid Da); fold changed in Cp.
  assert (E : total crossed = way * total changed) by (unfold total, crossed; cbn [hi lo]; ring).
  exists (way * x); split; [destruct Way as [Wy | Wy]; rewrite Wy; ring |].
  rewrite E, (Rabs_mult way), (way_size way Way), Rmult_1_l in N.
  replace (x - way * total changed) with (way * (way * x - total changed)) in N
    by (destruct Way as [Wy | Wy]; rewrite Wy; ring).
  rewrite Rabs_mult, (way_size way Way), Rmult_1_l in N; set (y := way * x) in *.
  set (z := total changed) in *; set (w := total along) in *.
  assert (Z : Rabs z <= Rabs (z - (w + paid)) + Rabs w + Rabs paid)
    by (unfold Rabs; repeat destruct Rcase_abs; lra).
  replace (y - (w + paid)) with (y - z + (z - (w + paid))) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _).
  generalize (Rabs_pos w) (Rabs_pos paid); unfold u in *; lra. }
destruct Made as (y & Ex & Ny).
replace (x * (2 * B + x)) with (y * (2 * S + y))
  by (rewrite Ex; unfold S; destruct Way as [Wy | Wy]; rewrite Wy; ring).
replace (Rabs x) with (Rabs y) by (rewrite Ex, Rabs_mult, (way_size way Way); ring).
split; [| repeat split; assumption].
exact (with_payment _ _ _ _ _ _ _ _ _ Go Ga Hh Pd Ph Pp Ny).
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

(* owed - left is what is paid: all that was owed, or nothing. *)
Theorem crossing_keeps_energy K :
  kinetic m1 p0 p1 p2 <= K -> kinetic m2 q0 q1 q2 <= K ->
  kinetic m1 (hi f0) (hi f1) (hi f2) <= K -> kinetic m2 (hi g0) (hi g1) (hi g2) <= K ->
  Rabs (after - (before - rise + (owed - left))) <=
    4 * u * (1 + / 35184372088832) * K + 16 * u * Rabs (owed - left) /\
  Rabs (after + owed_after m1 m2 c0 c1 c2 p0 p1 p2 q0 q1 q2 left - (before + owed - rise)) <=
    1024 * u * u * K + 16 * u * Rabs owed.
Proof.
intros B1 B2 A1 A2; destruct crossing_is_right as (g & (D & X & Gg) & Pl & Pg & Gp).
exact (change_keeps_energy r0 r1 r2 p0 p1 p2 q0 q1 q2 m1 m2 F1 F2 M1 M2 Apart crossed rise owed left
  g K D X Gg Pl Pg Gp B1 B2 A1 A2).
Qed.
End Crossing.
