(* with: rounding.v exact_dd_products.v impulse_dd.v impulse_sums.v *)
(* SPDX-License-Identifier: MIT *)
(* impulse.c, pair_kick: the energy of a pair that is kicked, and what is owed for it.  Whatever the
   kick w, energy is what real numbers have (impulse.v, kick_changes_energy) but for the last
   rounding of either velocity: BRINK_IMPULSE_ENERGY_ULP 4; and with what that rounding is known to
   have taken, to 2^-98 of the larger kinetic energy, a quarter of BRINK_IMPULSE_BALANCE 0x1p-96.
   Unbounded exponents. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding exact_dd_products impulse_dd impulse_sums.
Open Scope R_scope.

(* A component of one velocity. *)
Lemma one_energy m mu k w v : 0 < m -> 0 < mu -> is_dd k -> is_dd w ->
  Rabs (m * total k - mu) <= 132 / 10 * u * u * mu ->
  let n := hi (kicked k w v) in let l := lo (kicked k w v) in let om := total w in
  Rabs (m * (n * n) / 2 + m * (n * l) - (m * (v * v) / 2 + mu * (om * v) +
    mu * mu / m * (om * om) / 2)) <= u * u * (39 * (m * (n * n)) + 13 * (m * (v * v))) /\
  Rabs (m * (n * l)) <= (1 + 2 * u) * u * (m * (n * n)).
Proof.
intros M Mu K W E n l om; destruct (one_mass_kicked m mu k w v M Mu K W E) as [T L].
fold n in T, L; fold l in L; unfold total at 1 in T; fold n l om in T.
set (p := m * (n + l) - m * v - mu * om) in *.
assert (N2 : Rabs n * Rabs n = n * n) by (rewrite <- Rabs_mult; apply Rabs_pos_eq, Rle_0_sqr).
assert (V2 : Rabs v * Rabs v = v * v) by (rewrite <- Rabs_mult; apply Rabs_pos_eq, Rle_0_sqr).
assert (An := Rabs_pos n); assert (Av := Rabs_pos v).
set (a := Rabs n) in *; set (b := Rabs v) in *.
assert (D : 0 <= (a - b) * (a - b)) by apply Rle_0_sqr.
assert (Nl : Rabs (n * l) <= (1 + 2 * u) * u * (n * n)).
{ rewrite Rabs_mult; fold a; rewrite <- N2.
  replace ((1 + 2 * u) * u * (a * a)) with (a * (u * (1 + 2 * u) * a)) by ring.
  apply Rmult_le_compat_l; assumption. }
split.
2: { rewrite Rabs_mult, (Rabs_pos_eq m) by lra.
  replace ((1 + 2 * u) * u * (m * (n * n))) with (m * ((1 + 2 * u) * u * (n * n))) by ring.
  apply Rmult_le_compat_l; [lra | exact Nl]. }
assert (Ll : l * l <= (1 + 5 * u) * u * u * (n * n)).
{ replace (l * l) with (Rabs l * Rabs l) by (rewrite <- Rabs_mult; apply Rabs_pos_eq, Rle_0_sqr).
  apply Rle_trans with (u * (1 + 2 * u) * a * (u * (1 + 2 * u) * a)).
  - apply Rmult_le_compat; try apply Rabs_pos; exact L.
  - replace (u * (1 + 2 * u) * a * (u * (1 + 2 * u) * a))
      with (u * u * (1 + 2 * u) * (1 + 2 * u) * (n * n)) by (rewrite <- N2; ring).
    assert (0 <= n * n) by apply Rle_0_sqr; unfold u in *; lra. }
assert (L0 : 0 <= l * l) by apply Rle_0_sqr.
(* r: what the velocity is off by before its rounding *)
set (r := p / m); assert (Er : m * r = p) by (unfold r; field; lra).
assert (R : Rabs r <= 25 * u * u * (a + b)).
{ apply (Rmult_le_reg_l m); [exact M |]; rewrite <- (Rabs_pos_eq m) at 1 by lra.
  rewrite <- Rabs_mult, Er; lra. }
assert (Eo : mu / m * om = n + l - v - r).
{ apply (Rmult_eq_reg_l m); [| lra]; replace (m * (mu / m * om)) with (mu * om) by (field; lra).
  replace (m * (n + l - v - r)) with (m * (n + l) - m * v - m * r) by ring.
  rewrite Er; unfold p; ring. }
replace (mu * (om * v)) with (m * (mu / m * om * v)) by (field; lra).
replace (mu * mu / m * (om * om) / 2) with (m * (mu / m * om * (mu / m * om)) / 2) by (field; lra).
rewrite Eo.
replace (m * (n * n) / 2 + m * (n * l) - (m * (v * v) / 2 + m * ((n + l - v - r) * v) +
  m * ((n + l - v - r) * (n + l - v - r)) / 2))
  with (m * (r * (n + l - r / 2) - l * l / 2)) by field.
replace (u * u * (39 * (m * (n * n)) + 13 * (m * (v * v))))
  with (m * (u * u * (39 * (n * n) + 13 * (v * v)))) by ring.
rewrite Rabs_mult, (Rabs_pos_eq m) by lra; apply Rmult_le_compat_l; [lra |].
assert (S : Rabs (n + l - r / 2) <= 1001 / 1000 * a + / 1000 * b).
{ clear - L R An Av; unfold a, b, u in *; revert L R An Av; unfold Rabs.
  repeat destruct Rcase_abs; lra. }
assert (P : Rabs (r * (n + l - r / 2)) <= 25 * u * u * (a + b) * (1001 / 1000 * a + / 1000 * b)).
{ rewrite Rabs_mult; apply Rmult_le_compat; try apply Rabs_pos; assumption. }
apply Rabs_le_inv in P.
replace (25 * u * u * (a + b) * (1001 / 1000 * a + / 1000 * b)) with
  (25 * u * u * (1001 / 1000 * (a * a) + 1002 / 1000 * (a * b) + / 1000 * (b * b))) in P by field.
replace ((a - b) * (a - b)) with (a * a - 2 * (a * b) + b * b) in D by ring.
rewrite N2, V2 in *; assert (0 <= n * n) by apply Rle_0_sqr; assert (0 <= v * v) by apply Rle_0_sqr.
set (nn := n * n) in *; set (vv := v * v) in *; set (ab := a * b) in *; set (ll := l * l) in *.
set (q := r * _) in *; clearbody nn vv ab ll q; clear - P D Ll L0 H H0.
apply Rabs_le; unfold u in *; lra.
Qed.

Section Kick.
Variables m1 m2 : R.
Hypotheses (Fm1 : is_double m1) (Fm2 : is_double m2) (M1 : 0 < m1) (M2 : 0 < m2).
Let mu := m1 * m2 / (m1 + m2).

(* Of both particles. *)
Lemma two_energies w v1 v2 : is_dd w ->
  let y1 := kicked (share m1 m2) w v1 in let y2 := kicked (share m2 m1) (dd_negate w) v2 in
  let n1 := hi y1 in let n2 := hi y2 in let om := total w in
  let before := m1 * (v1 * v1) + m2 * (v2 * v2) in
  let after := m1 * (n1 * n1) + m2 * (n2 * n2) in
  Rabs (after / 2 + (m1 * (n1 * lo y1) + m2 * (n2 * lo y2)) -
    (before / 2 + mu * (om * (v1 - v2) + om * om / 2))) <= u * u * (39 * after + 13 * before) /\
  m1 * Rabs (n1 * lo y1) + m2 * Rabs (n2 * lo y2) <= (1 + 2 * u) * u * after.
Proof.
intros W y1 y2 n1 n2 om before after.
destruct (share_is_close m1 m2 Fm2 M1 M2) as (Mu & D1 & S1).
destruct (share_is_close m2 m1 Fm1 M2 M1) as (_ & D2 & S2).
replace (m2 * m1 / (m2 + m1)) with (m1 * m2 / (m1 + m2)) in S2 by (field; lra).
fold mu in Mu, S1, S2.
assert (Dw := dd_negate_is_dd w W).
destruct (one_energy m1 mu _ w v1 M1 Mu D1 W S1) as [E1 L1].
destruct (one_energy m2 mu _ _ v2 M2 Mu D2 Dw S2) as [E2 L2].
rewrite dd_negate_total in E2; fold y1 in E1, L1; fold y2 in E2, L2.
fold n1 in E1, L1; fold n2 in E2, L2.
fold om in E1, E2; rewrite Rabs_mult, (Rabs_pos_eq m1) in L1 by lra.
rewrite Rabs_mult, (Rabs_pos_eq m2) in L2 by lra.
assert (Em : mu * mu / m1 + mu * mu / m2 = mu) by (unfold mu; field; lra).
split; [| unfold after; lra].
replace (mu * (om * (v1 - v2) + om * om / 2)) with
  (mu * (om * (v1 - v2)) + (mu * mu / m1 + mu * mu / m2) * (om * om / 2)) by (rewrite Em; ring).
replace (after / 2 + (m1 * (n1 * lo y1) + m2 * (n2 * lo y2)) -
  (before / 2 + (mu * (om * (v1 - v2)) + (mu * mu / m1 + mu * mu / m2) * (om * om / 2)))) with
  (m1 * (n1 * n1) / 2 + m1 * (n1 * lo y1) - (m1 * (v1 * v1) / 2 + mu * (om * v1) +
    mu * mu / m1 * (om * om) / 2) +
  (m2 * (n2 * n2) / 2 + m2 * (n2 * lo y2) - (m2 * (v2 * v2) / 2 + mu * (- om * v2) +
    mu * mu / m2 * (- om * - om) / 2)))
  by (unfold before, after; field; lra).
apply Rle_trans with (1 := Rabs_triang _ _); unfold before, after; lra.
Qed.

(* In space. *)
Variables a b c : dd. (* w *)
Variables p0 p1 p2 q0 q1 q2 owed : R. (* v1, v2 *)
Hypotheses (Da : is_dd a) (Db : is_dd b) (Dc : is_dd c).

Definition first0 := kicked (share m1 m2) a p0.
Definition first1 := kicked (share m1 m2) b p1.
Definition first2 := kicked (share m1 m2) c p2.
Definition second0 := kicked (share m2 m1) (dd_negate a) q0.
Definition second1 := kicked (share m2 m1) (dd_negate b) q1.
Definition second2 := kicked (share m2 m1) (dd_negate c) q2.

Definition owed_after :=
  rnd (owed + rnd (
    rnd (m1 * dot_plain (hi first0 * lo first0) (hi first1 * lo first1) (hi first2 * lo first2)) +
    rnd (m2 * dot_plain (hi second0 * lo second0) (hi second1 * lo second1)
      (hi second2 * lo second2)))).

Let kinetic m x y z := m * (x * x + y * y + z * z) / 2.
Let before := kinetic m1 p0 p1 p2 + kinetic m2 q0 q1 q2.
Let first := kinetic m1 (hi first0) (hi first1) (hi first2).
Let second := kinetic m2 (hi second0) (hi second1) (hi second2).
Let after := first + second.
(* What the kick does in real numbers: mu (w.v + w.w / 2). *)
Let change := mu * (total a * (p0 - q0) + total a * total a / 2 +
  (total b * (p1 - q1) + total b * total b / 2) + (total c * (p2 - q2) + total c * total c / 2)).

Variable K : R. (* the larger kinetic energy *)
Hypotheses (B1 : kinetic m1 p0 p1 p2 <= K) (B2 : kinetic m2 q0 q1 q2 <= K).
Hypotheses (A1 : first <= K) (A2 : second <= K).

Theorem kick_keeps_energy :
  Rabs (after - (before + change)) <= 4 * u * (1 + / 140737488355328) * K /\
  Rabs (after + owed_after - (before + owed + change)) <=
    256 * u * u * K + u * (1 + / 1000) * Rabs owed.
Proof.
destruct (two_energies a p0 q0 Da) as [Ea La], (two_energies b p1 q1 Db) as [Eb Lb].
destruct (two_energies c p2 q2 Dc) as [Ec Lc].
fold first0 second0 in Ea, La; fold first1 second1 in Eb, Lb; fold first2 second2 in Ec, Lc.
assert (T1 := dot_plain_error (hi first0 * lo first0) (hi first1 * lo first1)
  (hi first2 * lo first2)).
assert (T2 := dot_plain_error (hi second0 * lo second0) (hi second1 * lo second1)
  (hi second2 * lo second2)).
unfold owed_after; set (t1 := dot_plain _ _ (hi first2 * _)) in *.
set (t2 := dot_plain _ _ (hi second2 * _)) in *.
set (x0 := hi first0 * lo first0) in *; set (x1 := hi first1 * lo first1) in *.
set (x2 := hi first2 * lo first2) in *; set (y0 := hi second0 * lo second0) in *.
set (y1 := hi second1 * lo second1) in *; set (y2 := hi second2 * lo second2) in *.
assert (Sq : forall m x, 0 < m -> 0 <= m * (x * x))
  by (intros; apply Rmult_le_pos; [lra | apply Rle_0_sqr]).
assert (F0 := Sq m1 (hi first0) M1); assert (F1 := Sq m1 (hi first1) M1).
assert (F2 := Sq m1 (hi first2) M1); assert (G0 := Sq m2 (hi second0) M2).
assert (G1 := Sq m2 (hi second1) M2); assert (G2 := Sq m2 (hi second2) M2).
assert (P0 := Sq m1 p0 M1); assert (P1 := Sq m1 p1 M1); assert (P2 := Sq m1 p2 M1).
assert (Q0 := Sq m2 q0 M2); assert (Q1 := Sq m2 q1 M2); assert (Q2 := Sq m2 q2 M2).
set (X := Rabs x0 + Rabs x1 + Rabs x2) in *; set (Y := Rabs y0 + Rabs y1 + Rabs y2) in *.
set (taken := m1 * (x0 + x1 + x2) + m2 * (y0 + y1 + y2)).
assert (K0 : 0 <= K) by (unfold first, kinetic in A1; lra).
assert (Mx : m1 * X + m2 * Y <= (1 + 2 * u) * u * (4 * K)).
{ unfold X, Y; unfold after, first, second, kinetic in *; unfold u in *; lra. }
assert (Mt : Rabs taken <= m1 * X + m2 * Y).
{ unfold taken; apply Rle_trans with (1 := Rabs_triang _ _).
  rewrite !Rabs_mult, (Rabs_pos_eq m1), (Rabs_pos_eq m2) by lra.
  apply Rplus_le_compat; (apply Rmult_le_compat_l; [lra |]); unfold X, Y;
    (eapply Rle_trans; [apply Rabs_triang |]; apply Rplus_le_compat_r, Rabs_triang). }
assert (Exact : Rabs (after + taken - (before + change)) <= u * u * (208 * K)).
{ set (ea := _ - _) in Ea; set (eb := _ - _) in Eb; set (ec := _ - _) in Ec.
  replace (after + taken - (before + change)) with (ea + eb + ec)
    by (unfold ea, eb, ec, taken, x0, x1, x2, y0, y1, y2, after, first, second, before, change,
      kinetic; field).
  apply Rabs_le_inv in Ea; apply Rabs_le_inv in Eb; apply Rabs_le_inv in Ec.
  clearbody ea eb ec; unfold after, first, second, kinetic in *; apply Rabs_le.
  unfold u in *; lra. }
split.
- replace (after - (before + change)) with (after + taken - (before + change) + - taken) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; unfold u in *; lra.
- assert (X0 : 0 <= m1 * X) by (apply Rmult_le_pos; [lra |]; unfold X;
    repeat apply Rplus_le_le_0_compat; apply Rabs_pos).
  assert (Y0 : 0 <= m2 * Y) by (apply Rmult_le_pos; [lra |]; unfold Y;
    repeat apply Rplus_le_le_0_compat; apply Rabs_pos).
  apply (Rmult_le_compat_l m1) in T1; [| lra]; apply (Rmult_le_compat_l m2) in T2; [| lra].
  rewrite <- (Rabs_pos_eq m1) in T1 at 1 by lra; rewrite <- (Rabs_pos_eq m2) in T2 at 1 by lra.
  rewrite <- Rabs_mult in T1, T2; apply Rabs_le_inv in T1; apply Rabs_le_inv in T2.
  apply Rabs_le_inv in Mt; apply Rabs_le_inv in Exact.
  replace (m1 * (3 * tiny * u * X)) with (3 * tiny * u * (m1 * X)) in T1 by ring.
  replace (m2 * (3 * tiny * u * Y)) with (3 * tiny * u * (m2 * Y)) in T2 by ring.
  replace (m1 * (t1 - (x0 + x1 + x2))) with (m1 * t1 - m1 * (x0 + x1 + x2)) in T1 by ring.
  replace (m2 * (t2 - (y0 + y1 + y2))) with (m2 * t2 - m2 * (y0 + y1 + y2)) in T2 by ring.
  assert (S1 : - (m1 * X) <= m1 * (x0 + x1 + x2) <= m1 * X).
  { apply Rabs_le_inv; rewrite Rabs_mult, (Rabs_pos_eq m1) by lra; apply Rmult_le_compat_l; [lra |].
    unfold X; eapply Rle_trans; [apply Rabs_triang |]; apply Rplus_le_compat_r, Rabs_triang. }
  assert (S2 : - (m2 * Y) <= m2 * (y0 + y1 + y2) <= m2 * Y).
  { apply Rabs_le_inv; rewrite Rabs_mult, (Rabs_pos_eq m2) by lra; apply Rmult_le_compat_l; [lra |].
    unfold Y; eapply Rle_trans; [apply Rabs_triang |]; apply Rplus_le_compat_r, Rabs_triang. }
  unfold taken in *; set (sx := m1 * (x0 + x1 + x2)) in *; set (sy := m2 * (y0 + y1 + y2)) in *.
  set (mx := m1 * X) in *; set (my := m2 * Y) in *; set (a1 := m1 * t1) in *.
  set (a2 := m2 * t2) in *; set (bc := before + change) in *.
  replace (before + owed + change) with (bc + owed) by (unfold bc; ring).
  clearbody sx sy mx my a1 a2 bc after; clear - T1 T2 Mt Exact S1 S2 X0 Y0 Mx K0.
  unfold tiny, u in *; size owed o.
  round_off a1 (1001 / 1000 * mx) l1; round_off a2 (1001 / 1000 * my) l2.
  round_off (a1 - l1 + (a2 - l2)) (1002 / 1000 * (mx + my)) l3.
  round_off (owed + (a1 - l1 + (a2 - l2) - l3)) (o + 1003 / 1000 * (mx + my)) l4; bound.
Qed.
End Kick.
