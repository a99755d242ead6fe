(* with: rounding.v exact_dd_products.v impulse_dd.v impulse_sums.v impulse_kick.v *)
(* with: impulse_decision.v impulse_change.v impulse_rim_parts.v *)
(* SPDX-License-Identifier: MIT *)
(* impulse.c, brink_rim_impulse_balanced from end to end: BRINK_IMPULSE_ENERGY_ULP 4 but for its
   2^-46th part, and BRINK_IMPULSE_BALANCE 0x1p-96 of the larger kinetic energy, and 1.001u of what
   was owed.  Unbounded exponents. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding exact_dd_products impulse_dd impulse_decision impulse_sums.
From Brink Require Import impulse_kick impulse_change impulse_rim_parts.
Open Scope R_scope.

Definition turned (stretch along inward v : dd) (r : R) :=
  let tangent := dd_add v (dd_negate (dd_mul_d along r)) in
  dd_add (dd_add (dd_mul stretch tangent) (dd_mul_d inward r)) (dd_negate v).

(* A component of it.  k and l: what is along r, before and after, times |r|; n is that of r / |r|,
   and W is |v|. *)
Lemma one_turned stretch along inward v r R W : is_dd stretch -> is_dd along -> is_dd inward ->
  is_dd v -> 0 < R -> 0 <= W -> 0 < total stretch <= 1001 / 1000 ->
  let k := total along * R in let l := total inward * R in let n := r / R in
  Rabs k <= / 8000000 * W -> Rabs l <= / 8000000 * W ->
  let o := total stretch * (total v - k * n) + l * n - total v in
  let w := total (turned stretch along inward v r) in
  Rabs (2 * w * total v + w * w - (2 * o * total v + o * o)) <=
    u * u * (41 * (total v * total v) + W * W * (n * n)).
Proof.
intros Ds Da Di Dv R0 W0 Sg k l n Hk Hl o w.
assert (Dr : is_dd (dd_mul_d along r)) by apply normal_is_dd.
assert (N1 := dd_mul_d_near along r Da); assert (N4 := dd_mul_d_near inward r Di).
replace (total along * r) with (k * n) in N1 by (unfold k, n; field; lra).
replace (total inward * r) with (l * n) in N4 by (unfold l, n; field; lra).
set (radial := dd_mul_d along r) in *; set (back := dd_mul_d inward r) in *.
assert (Db : is_dd back) by apply normal_is_dd.
assert (N2 := dd_add_sizes v (dd_negate radial) Dv (dd_negate_is_dd _ Dr)).
rewrite dd_negate_total, Rabs_Ropp in N2; set (t := dd_add v (dd_negate radial)) in *.
assert (Dt : is_dd t) by apply normal_is_dd; assert (N3 := dd_mul_near stretch t Ds Dt).
set (y3 := dd_mul stretch t) in *; assert (D3 : is_dd y3) by apply normal_is_dd.
assert (N5 := dd_add_sizes y3 back D3 Db); set (y5 := dd_add y3 back) in *.
assert (D5 : is_dd y5) by apply normal_is_dd.
assert (N6 := dd_add_sizes y5 (dd_negate v) D5 (dd_negate_is_dd _ Dv)).
rewrite dd_negate_total, Rabs_Ropp in N6; change (dd_add y5 (dd_negate v)) with
  (turned stretch along inward v r) in N6; fold w in N6.
(* all as parts of |v| and of z *)
set (z := / 8000000 * W * Rabs n).
assert (Z0 : 0 <= z) by (unfold z; repeat apply Rmult_le_pos; try apply Rabs_pos; lra).
assert (Kz : Rabs (k * n) <= z /\ Rabs (l * n) <= z).
{ unfold z; rewrite !Rabs_mult; split; apply Rmult_le_compat_r; try apply Rabs_pos; assumption. }
destruct Kz as [Kz Lz]; unfold near in *; set (s := total stretch) in *.
set (kn := k * n) in *; set (ln := l * n) in *; set (x := total v) in *.
assert (Q0 := Rabs_pos x); set (q := Rabs x) in *.
assert (X : - q <= x <= q) by (apply Rabs_le_inv, Rle_refl).
assert (E1 : Rabs (total radial - kn) <= 22 / 10 * u * u * z) by (unfold u in *; lra).
assert (E2 : Rabs (total t - (x - kn)) <= u * u * (321 / 100 * q + 55 / 10 * z)).
{ assert (Rabs (total radial) <= 1001 / 1000 * z).
  { apply Rabs_le_inv in E1; apply Rabs_le_inv in Kz; apply Rabs_le; unfold u in *; lra. }
  replace (total t - (x - kn)) with (total t - (x + - total radial) + - (total radial - kn)) by ring.
  eapply Rle_trans; [apply Rabs_triang |]; rewrite Rabs_Ropp; unfold u in *; lra. }
assert (T : Rabs (total t) <= 1001 / 1000 * (q + z)).
{ apply Rabs_le_inv in E2; apply Rabs_le_inv in Kz; apply Rabs_le; unfold u in *; lra. }
assert (Ss : forall y m, Rabs y <= m -> Rabs (s * y) <= 1001 / 1000 * m).
{ intros y m Y; rewrite Rabs_mult, (Rabs_pos_eq s) by lra.
  apply Rmult_le_compat; try apply Rabs_pos; lra. }
assert (T3 := Ss _ _ T); assert (S2 := Ss _ _ E2).
replace (s * (total t - (x - kn))) with (s * total t - s * (x - kn)) in S2 by ring.
assert (E3 : Rabs (total y3 - s * (x - kn)) <= u * u * (96 / 10 * q + 12 * z)).
{ replace (total y3 - s * (x - kn)) with
    (total y3 - s * total t + (s * total t - s * (x - kn))) by ring.
  eapply Rle_trans; [apply Rabs_triang |]; unfold u in *; lra. }
assert (T2 : Rabs (x - kn) <= q + z).
{ apply Rabs_le_inv in Kz; apply Rabs_le; lra. }
assert (Sv := Ss _ _ T2); set (sv := s * (x - kn)) in *.
assert (Y3 : Rabs (total y3) <= 1002 / 1000 * (q + z)).
{ apply Rabs_le_inv in E3; apply Rabs_le_inv in Sv; apply Rabs_le; unfold u in *; lra. }
assert (E4 : Rabs (total back - ln) <= 22 / 10 * u * u * z) by (unfold u in *; lra).
assert (Y4 : Rabs (total back) <= 1001 / 1000 * z).
{ apply Rabs_le_inv in E4; apply Rabs_le_inv in Lz; apply Rabs_le; unfold u in *; lra. }
assert (Y5 : Rabs (total y5) <= 1003 / 1000 * q + 2006 / 1000 * z).
{ assert (Rabs (total y5) <= Rabs (total y5 - (total y3 + total back)) +
    Rabs (total y3) + Rabs (total back)) by (unfold Rabs; repeat destruct Rcase_abs; lra).
  unfold u in *; lra. }
assert (E : Rabs (w - o) <= u * u * (197 / 10 * q + 30 * z)).
{ replace (w - o) with (w - (total y5 + - x) + (total y5 - (total y3 + total back)) +
    (total y3 - sv) + (total back - ln)) by (unfold o; ring).
  eapply Rle_trans; [apply Rabs_triang |]; rewrite Rplus_comm.
  assert (A := Rabs_triang (w - (total y5 + - x) + (total y5 - (total y3 + total back)))
    (total y3 - sv)).
  assert (A' := Rabs_triang (w - (total y5 + - x)) (total y5 - (total y3 + total back))).
  unfold u in *; lra. }
assert (O : Rabs (x + o) <= 1001 / 1000 * q + 2002 / 1000 * z).
{ replace (x + o) with (sv + ln) by (unfold o; ring).
  eapply Rle_trans; [apply Rabs_triang |]; lra. }
set (e := w - o) in *; replace w with (o + e) by (unfold e; ring).
replace (2 * (o + e) * x + (o + e) * (o + e) - (2 * o * x + o * o)) with (e * (2 * (x + o) + e))
  by ring.
assert (B : Rabs (2 * (x + o) + e) <= 2003 / 1000 * q + 4005 / 1000 * z).
{ eapply Rle_trans; [apply Rabs_triang |]; rewrite Rabs_mult, (Rabs_pos_eq 2) by lra.
  unfold u in *; lra. }
assert (F : Rabs (e * (2 * (x + o) + e)) <=
  u * u * (197 / 10 * q + 30 * z) * (2003 / 1000 * q + 4005 / 1000 * z))
  by (rewrite Rabs_mult; apply Rmult_le_compat; try apply Rabs_pos; assumption).
apply Rle_trans with (1 := F).
assert (Qq : q * q = x * x)
  by (unfold q; rewrite <- Rabs_mult; apply Rabs_pos_eq, Rle_0_sqr).
set (c := W * Rabs n); assert (Zc : z = / 8000000 * c) by (unfold z, c; ring).
assert (Cc : c * c = W * W * (n * n)).
{ unfold c; replace (W * Rabs n * (W * Rabs n)) with (W * W * (Rabs n * Rabs n)) by ring.
  rewrite <- Rabs_mult, (Rabs_pos_eq (n * n)) by apply Rle_0_sqr; reflexivity. }
rewrite <- Qq, <- Cc, Zc; assert (0 <= (q - c) * (q - c)) by apply Rle_0_sqr.
assert (0 <= c * c) by apply Rle_0_sqr; assert (0 <= q * q) by apply Rle_0_sqr.
assert (0 <= q * c) by (apply Rmult_le_pos; [exact Q0 | apply Rmult_le_pos; [lra | apply Rabs_pos]]).
clearbody c q; clear - H H0 H1 H2; unfold u; lra.
Qed.

Section Rim.
Variables r0 r1 r2 p0 p1 p2 q0 q1 q2 m1 m2 owed : R.
Hypotheses (F1 : is_double m1) (F2 : is_double m2) (M1 : 0 < m1) (M2 : 0 < m2).
Let B := r0 * (p0 - q0) + r1 * (p1 - q1) + r2 * (p2 - q2).
Let Q := r0 * r0 + r1 * r1 + r2 * r2.
Let V := (p0 - q0) * (p0 - q0) + (p1 - q1) * (p1 - q1) + (p2 - q2) * (p2 - q2).
Hypotheses (Apart : 0 < Q) (Moving : 0 < V). (* else there is no rim *)
Let speed := b r0 r1 r2 p0 p1 p2 q0 q1 q2.
Let most := rim r0 r1 r2 p0 p1 p2 q0 q1 q2.
Let stretched := stretch r0 r1 r2 p0 p1 p2 q0 q1 q2.
Let outward := along r0 r1 r2 p0 p1 p2 q0 q1 q2.
Let back := inward r0 r1 r2 p0 p1 p2 q0 q1 q2.
Hypothesis Slow : Rabs (hi speed) < hi most.

Definition t0 := turned stretched outward back (v0 p0 q0) r0.
Definition t1 := turned stretched outward back (v1 p1 q1) r1.
Definition t2 := turned stretched outward back (v2 p2 q2) r2.

(* |r| and |v|; and the speed along r. *)
Let R := sqrt Q.
Let W := sqrt V.
Let beta := B / R.

(* What the kick does in real numbers: next to nothing. *)
Let Mu := m1 * m2 / (m1 + m2).
Let change := Mu * (total t0 * (p0 - q0) + total t0 * total t0 / 2 +
  (total t1 * (p1 - q1) + total t1 * total t1 / 2) +
  (total t2 * (p2 - q2) + total t2 * total t2 / 2)).

Lemma change_is_nothing : Rabs change <= 53 * u * u * (Mu * V).
Proof.
destruct (lengths r0 r1 r2 p0 p1 p2 q0 q1 q2 Apart Moving) as (R0 & R2 & W0 & W2).
destruct (stretch_is_close r0 r1 r2 p0 p1 p2 q0 q1 q2 Apart Moving Slow) as (Ds & S & Cs).
destruct (along_is_close r0 r1 r2 p0 p1 p2 q0 q1 q2 Apart Moving Slow) as (Ck & Hb & Cl).
fold Q R in R0, R2, Ck, Hb, Cl, Cs; fold V W in W0, W2, Ck, Hb, Cl, Cs.
fold B beta in Ck, Hb, Cs; fold outward in Ck; fold back in Cl; fold stretched in Ds, S, Cs.
set (s := total stretched) in *; set (k := total outward * R) in *; set (l := total back * R) in *.
assert (Hk : Rabs k <= / 8000000 * W).
{ apply Rabs_le_inv in Ck; apply Rabs_le_inv in Hb; apply Rabs_le; unfold u in *; lra. }
assert (Hl : Rabs l <= / 8000000 * W).
{ apply Rabs_le_inv in Cl; apply Rabs_le; unfold u in *; lra. }
assert (One : forall p q r, let v := normal (p - q) in let n := r / R in
  let o := s * (p - q - k * n) + l * n - (p - q) in
  let w := total (turned stretched outward back v r) in
  Rabs (2 * w * (p - q) + w * w - (2 * o * (p - q) + o * o)) <=
    u * u * (41 * ((p - q) * (p - q)) + W * W * (n * n))).
{ intros p q r v n; destruct (normal_is_dd (p - q)) as [D E]; rewrite <- E; fold v.
  apply one_turned; try assumption; [apply normal_is_dd | apply dd_negate_is_dd, normal_is_dd | lra]. }
assert (O0 := One p0 q0 r0); assert (O1 := One p1 q1 r1); assert (O2 := One p2 q2 r2).
cbv zeta in O0, O1, O2.
change (turned stretched outward back (normal (p0 - q0)) r0) with t0 in O0.
change (turned stretched outward back (normal (p1 - q1)) r1) with t1 in O1.
change (turned stretched outward back (normal (p2 - q2)) r2) with t2 in O2.
set (w0 := total t0) in *; set (w1 := total t1) in *; set (w2 := total t2) in *.
set (n0 := r0 / R) in *; set (n1 := r1 / R) in *; set (n2 := r2 / R) in *.
set (x0 := p0 - q0) in *; set (x1 := p1 - q1) in *; set (x2 := p2 - q2) in *.
assert (Nn : n0 * n0 + n1 * n1 + n2 * n2 = 1).
{ unfold n0, n1, n2; replace (r0 / R * (r0 / R) + r1 / R * (r1 / R) + r2 / R * (r2 / R)) with
    (Q / (R * R)) by (unfold Q; field; lra); rewrite R2; field; lra. }
assert (Nb : x0 * n0 + x1 * n1 + x2 * n2 = beta)
  by (unfold beta, B, n0, n1, n2; fold x0 x1 x2; field; lra).
set (o0 := s * (x0 - k * n0) + l * n0 - x0) in *.
set (o1 := s * (x1 - k * n1) + l * n1 - x1) in *.
set (o2 := s * (x2 - k * n2) + l * n2 - x2) in *.
(* as it is meant *)
assert (M : 2 * o0 * x0 + o0 * o0 + (2 * o1 * x1 + o1 * o1) + (2 * o2 * x2 + o2 * o2) =
  s * s * (V - beta * beta) + s * s * ((k - beta) * (k - beta)) - 2 * (s * (l * (k - beta))) +
  l * l - V).
{ transitivity (s * s * (V - 2 * k * (x0 * n0 + x1 * n1 + x2 * n2) +
    k * k * (n0 * n0 + n1 * n1 + n2 * n2)) + 2 * s * l * (x0 * n0 + x1 * n1 + x2 * n2 -
    k * (n0 * n0 + n1 * n1 + n2 * n2)) + l * l * (n0 * n0 + n1 * n1 + n2 * n2) - V).
  - unfold o0, o1, o2, V; fold x0 x1 x2; ring.
  - rewrite Nn, Nb; ring. }
assert (V0 := Moving); set (d := k - beta) in *.
assert (S2 : Rabs (s * s) <= 1003 / 1000).
{ rewrite Rabs_mult, (Rabs_pos_eq s) by lra.
  apply Rle_trans with (1001 / 1000 * (1001 / 1000)); [apply Rmult_le_compat |]; lra. }
assert (E1 : Rabs (s * s * (d * d)) <= / 1000 * u * u * V).
{ rewrite Rabs_mult; assert (Rabs (d * d) <= 13 * u * u * W * (13 * u * u * W)).
  { rewrite Rabs_mult; apply Rmult_le_compat; try apply Rabs_pos; exact Ck. }
  assert (Rabs (s * s) * Rabs (d * d) <= 1003 / 1000 * (13 * u * u * W * (13 * u * u * W)))
    by (apply Rmult_le_compat; try apply Rabs_pos; assumption).
  rewrite <- W2 in *; unfold u in *; lra. }
assert (E2 : Rabs (s * (l * d)) <= / 1000 * u * u * V).
{ rewrite !Rabs_mult, (Rabs_pos_eq s) by lra.
  assert (Rabs l * Rabs d <= / 8000000 * W * (13 * u * u * W))
    by (apply Rmult_le_compat; try apply Rabs_pos; assumption).
  assert (s * (Rabs l * Rabs d) <= 1001 / 1000 * (/ 8000000 * W * (13 * u * u * W))).
  { apply Rmult_le_compat; try lra; apply Rmult_le_pos; apply Rabs_pos. }
  rewrite <- W2 in *; unfold u in *; lra. }
assert (E3 : Rabs (l * l - / 281474976710656 * V) <= / 1000 * u * u * V).
{ rewrite <- W2 in *; replace (l * l - / 281474976710656 * (W * W)) with
    ((l + / 16777216 * W) * (l - / 16777216 * W)) by field.
  rewrite Rabs_mult.
  assert (Rabs (l + / 16777216 * W) * Rabs (l - / 16777216 * W) <=
    / 100000 * u * u * W * (/ 1000 * W)).
  { apply Rmult_le_compat; try apply Rabs_pos; [exact Cl |].
    apply Rabs_le_inv in Hl; apply Rabs_le; lra. }
  unfold u in *; lra. }
assert (Dv : x0 * x0 + x1 * x1 + x2 * x2 = V) by reflexivity.
assert (T : Rabs (2 * w0 * x0 + w0 * w0 + (2 * w1 * x1 + w1 * w1) + (2 * w2 * x2 + w2 * w2)) <=
  105 * u * u * V).
{ set (e0 := _ - _) in O0; set (e1 := _ - _) in O1; set (e2 := _ - _) in O2.
  set (f := s * s * (V - beta * beta) - _) in Cs.
  replace (2 * w0 * x0 + w0 * w0 + (2 * w1 * x1 + w1 * w1) + (2 * w2 * x2 + w2 * w2)) with
    (e0 + e1 + e2 + (f + s * s * (d * d) - 2 * (s * (l * d)) + (l * l - / 281474976710656 * V)))
    by (unfold e0, e1, e2, f; lra).
  apply Rabs_le_inv in O0; apply Rabs_le_inv in O1; apply Rabs_le_inv in O2.
  apply Rabs_le_inv in E1; apply Rabs_le_inv in E2; apply Rabs_le_inv in E3.
  apply Rabs_le_inv in Cs; rewrite W2 in O0, O1, O2.
  assert (Vn : V * (n0 * n0) + V * (n1 * n1) + V * (n2 * n2) = V).
  { transitivity (V * (n0 * n0 + n1 * n1 + n2 * n2)); [ring | rewrite Nn; ring]. }
  set (a0 := x0 * x0) in *; set (a1 := x1 * x1) in *; set (a2 := x2 * x2) in *.
  set (c0 := V * (n0 * n0)) in *; set (c1 := V * (n1 * n1)) in *; set (c2 := V * (n2 * n2)) in *.
  set (g1 := s * s * (d * d)) in *; set (g2 := s * (l * d)) in *; set (g3 := l * l - _) in *.
  clearbody e0 e1 e2 f a0 a1 a2 c0 c1 c2 g1 g2 g3 V.
  clear - O0 O1 O2 E1 E2 E3 Cs Vn Dv; apply Rabs_le; unfold u in *; lra. }
unfold change; assert (Mp := Mu_pos m1 m2 M1 M2); fold Mu in Mp.
replace (Mu * _) with (Mu * (2 * w0 * x0 + w0 * w0 + (2 * w1 * x1 + w1 * w1) +
  (2 * w2 * x2 + w2 * w2)) / 2) by field.
apply (Rmult_le_compat_l Mu) in T; [| lra]; unfold Rdiv.
assert (0 < Mu * V) by (apply Rmult_lt_0_compat; assumption).
rewrite !Rabs_mult, (Rabs_pos_eq Mu), (Rabs_pos_eq (/ 2)) by lra; unfold u in *; lra.
Qed.

Let kinetic m x y z := m * (x * x + y * y + z * z) / 2.
Let f0 := first0 m1 m2 t0 p0.
Let f1 := first1 m1 m2 t1 p1.
Let f2 := first2 m1 m2 t2 p2.
Let g0 := second0 m1 m2 t0 q0.
Let g1 := second1 m1 m2 t1 q1.
Let g2 := second2 m1 m2 t2 q2.
Let before := kinetic m1 p0 p1 p2 + kinetic m2 q0 q1 q2.
Let after := kinetic m1 (hi f0) (hi f1) (hi f2) + kinetic m2 (hi g0) (hi g1) (hi g2).

Theorem rim_rule_keeps_energy K :
  kinetic m1 p0 p1 p2 <= K -> kinetic m2 q0 q1 q2 <= K ->
  kinetic m1 (hi f0) (hi f1) (hi f2) <= K -> kinetic m2 (hi g0) (hi g1) (hi g2) <= K ->
  Rabs (after - before) <= 4 * u * (1 + / 70368744177664) * K /\
  Rabs (after + owed_after m1 m2 t0 t1 t2 p0 p1 p2 q0 q1 q2 owed - (before + owed)) <=
    512 * u * u * K + u * (1 + / 1000) * Rabs owed.
Proof.
intros B1 B2 A1 A2.
assert (D0 : is_dd t0) by apply normal_is_dd; assert (D1 : is_dd t1) by apply normal_is_dd.
assert (D2 : is_dd t2) by apply normal_is_dd.
destruct (kick_keeps_energy m1 m2 F1 F2 M1 M2 t0 t1 t2 p0 p1 p2 q0 q1 q2 owed D0 D1 D2 K B1 B2
  A1 A2) as [E F].
fold Mu change in E, F; set (o := owed_after _ _ _ _ _ _ _ _ _ _ _ _) in *.
change (Rabs (after - (before + change)) <= 4 * u * (1 + / 140737488355328) * K) in E.
change (Rabs (after + o - (before + owed + change)) <=
  256 * u * u * K + u * (1 + / 1000) * Rabs owed) in F.
assert (C := change_is_nothing).
assert (Vb : Mu * V / 2 <= before) by now apply relative_energy.
assert (Bk : before <= 2 * K) by (unfold before; lra).
assert (O : 0 <= Rabs owed) by apply Rabs_pos.
apply Rabs_le_inv in E; apply Rabs_le_inv in F; apply Rabs_le_inv in C.
set (x := Mu * V) in *; clearbody change after before o x.
clear - E F C Vb Bk O; split; apply Rabs_le; unfold u in *; lra.
Qed.
End Rim.
