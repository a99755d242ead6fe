(* with: rounding.v event_time_sums.v event_time_path.v *)
(* SPDX-License-Identifier: MIT *)
(* event_time_fast.h: at a fast time that is one of the surface, the pair is within
   BRINK_EVENT_TIME_GAP 8 eps (sigma + |v| t), 16u, of it.  Unbounded exponents. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding event_time_sums event_time_path.
Open Scope R_scope.

Definition cross p q := rnd (q - rnd p). (* fma(r1, v2, -(r2 v1)), p = r2 v1, q = r1 v2 *)

Lemma cross_error p q : Rabs (cross p q - (q - p)) <= 101 / 100 * u * Rabs p + u * Rabs (q - p).
Proof.
assert (L := low_own p); unfold cross; rewrite (rounded p).
assert (L2 := low_own (q - (p - low p))); rewrite (rounded (q - _)).
set (l := low p) in *; set (l2 := low (q - (p - l))) in *; clearbody l l2.
revert L L2; unfold u, Rabs; repeat destruct Rcase_abs; intros; lra.
Qed.

Section Fast.
Variables r0 r1 r2 v0 v1 v2 sigma : R.
Hypothesis Hs : 0 <= sigma.
Let A := v0 * v0 + v1 * v1 + v2 * v2.
Let B := r0 * v0 + r1 * v1 + r2 * v2.
Let V := len v0 v1 v2.
Let Rn := len r0 r1 r2.
Let W := len (r1 * v2 - r2 * v1) (r2 * v0 - r0 * v2) (r0 * v1 - r1 * v0).
Let a := dot_rounded (v0 * v0) (v1 * v1) (v2 * v2).
Let b := dot_rounded (r0 * v0) (r1 * v1) (r2 * v2).
Hypothesis Moves : 0 < A.

(* Where rho and G are together as far as the surface but for q of its square's u. *)
Lemma radius rho G q : 0 <= rho -> 0 <= q <= 17 ->
  - (q * u * (sigma * sigma * A)) <= rho * rho + G * G - sigma * sigma * A <=
    q * u * (sigma * sigma * A) ->
  Rabs (len rho G 0 - sigma * V) <= (q + / 10) / 2 * u * (sigma * V) /\
  rho <= 11 / 10 * (sigma * V).
Proof.
intros R0 Hq H; assert (VP := V_pos v0 v1 v2 Moves); fold V in VP.
assert (SV : 0 <= sigma * V) by (apply Rmult_le_pos; lra).
set (K := len rho G 0).
assert (K2 : K * K = rho * rho + G * G) by (unfold K; rewrite len_square; ring).
assert (SA : sigma * V * (sigma * V) = sigma * sigma * A)
  by (unfold A; rewrite <- (V2 v0 v1 v2); fold V; ring).
rewrite <- K2, <- SA in H; set (m := sigma * V) in *.
assert (K0 : 0 <= K) by apply len_pos; assert (M2 : 0 <= m * m) by apply Rle_0_sqr.
assert (QM : 0 <= q * (m * m) <= 17 * (m * m))
  by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
assert (Up : K <= (1 + 9 * u) * m).
{ apply square_le; [unfold u; lra |].
  replace ((1 + 9 * u) * m * ((1 + 9 * u) * m)) with ((1 + 18 * u + 81 * u * u) * (m * m)) by ring.
  unfold u in *; lra. }
assert (Dn : (1 - 9 * u) * m <= K).
{ apply square_le; [exact K0 |].
  replace ((1 - 9 * u) * m * ((1 - 9 * u) * m)) with ((1 - 18 * u + 81 * u * u) * (m * m)) by ring.
  unfold u in *; lra. }
assert (G0 : 0 <= G * G) by apply Rle_0_sqr.
assert (Rk : rho <= K) by (apply square_le; [exact K0 |]; lra).
split; [| unfold u in *; lra].
destruct SV as [Pm | Zm].
- apply (Rmult_le_reg_r (K + m)); [lra |].
  rewrite <- (Rabs_pos_eq (K + m)) at 1 by lra; rewrite <- Rabs_mult.
  replace ((K - m) * (K + m)) with (K * K - m * m) by ring.
  apply Rle_trans with (u * (q * (m * m))); [apply Rabs_le; unfold u in *; lra |].
  replace ((q + / 10) / 2 * u * m * (K + m)) with
    (u * (/ 2 * (q * (m * K)) + / 20 * (m * K) + / 2 * (q * (m * m)) + / 20 * (m * m))) by field.
  apply Rmult_le_compat_l; [unfold u; lra |].
  assert (MK : m * ((1 - 9 * u) * m) <= m * K) by (apply Rmult_le_compat_l; lra).
  assert (QK : q * (m * ((1 - 9 * u) * m)) <= q * (m * K)) by (apply Rmult_le_compat_l; lra).
  replace (q * (m * ((1 - 9 * u) * m))) with ((1 - 9 * u) * (q * (m * m))) in QK by ring.
  replace (m * ((1 - 9 * u) * m)) with ((1 - 9 * u) * (m * m)) in MK by ring.
  unfold u in *; lra.
- rewrite <- Zm in *; rewrite !Rmult_0_r in *; rewrite Rminus_0_r; apply Rabs_le; lra.
Qed.

(* --- Meeting, and the later root of a far pair ------------------------------ *)

Let x := cross (r2 * v1) (r1 * v2).
Let y := cross (r0 * v2) (r2 * v0).
Let z := cross (r1 * v0) (r0 * v1).
Let G := len x y z.

Lemma cross_close : Rabs (G - W) <= 22 / 10 * u * (Rn * V).
Proof.
apply Rle_trans with (1 := len_minus _ _ _ _ _ _).
set (p := 101 / 100 * u); assert (Up : 0 <= p /\ 0 <= u) by (unfold p, u; lra).
apply Rle_trans with (len (p * Rabs (r2 * v1) + u * Rabs (r1 * v2 - r2 * v1))
  (p * Rabs (r0 * v2) + u * Rabs (r2 * v0 - r0 * v2))
  (p * Rabs (r1 * v0) + u * Rabs (r0 * v1 - r1 * v0))).
{ apply len_le; apply cross_error. }
apply Rle_trans with (1 := triangle _ _ _ _ _ _); rewrite !len_scaled by lra.
assert (RV : 0 <= Rn * V) by (apply Rmult_le_pos; apply len_pos).
assert (E : Rn * V * (Rn * V) = (r0 * r0 + r1 * r1 + r2 * r2) * A)
  by (rewrite <- len_square; fold Rn; unfold A; rewrite <- (V2 v0 v1 v2); fold V; ring).
assert (S : forall m n, Rabs (m * n) * Rabs (m * n) = m * m * (n * n)).
{ intros; rewrite <- Rabs_mult, Rabs_pos_eq; [ring | apply Rle_0_sqr]. }
assert (N1 : len (Rabs (r2 * v1)) (Rabs (r0 * v2)) (Rabs (r1 * v0)) <= Rn * V).
{ apply square_le; [exact RV |]; rewrite len_square, !S, E; unfold A.
  assert (Q : forall m n, 0 <= m * m * (n * n))
    by (intros; apply Rmult_le_pos; apply Rle_0_sqr).
  generalize (Q r0 v0) (Q r1 v1) (Q r2 v2) (Q r0 v1) (Q r1 v2) (Q r2 v0) (Q r0 v2) (Q r1 v0)
    (Q r2 v1).
  lra. }
assert (N2 : len (Rabs (r1 * v2 - r2 * v1)) (Rabs (r2 * v0 - r0 * v2)) (Rabs (r0 * v1 - r1 * v0))
  <= Rn * V).
{ apply square_le; [exact RV |]; rewrite len_square, <- !Rabs_mult, !Rabs_pos_eq by apply Rle_0_sqr.
  rewrite <- len_square; rewrite E, <- len_square; unfold A.
  rewrite <- (lagrange r0 r1 r2 v0 v1 v2).
  apply Rle_trans with (W * W); [right; reflexivity |].
  generalize (Rle_0_sqr B); unfold Rsqr, W, B; lra. }
apply Rle_trans with (p * (Rn * V) + u * (Rn * V)).
- apply Rplus_le_compat; apply Rmult_le_compat_l; lra.
- unfold p, u in *; lra.
Qed.


Let w := rnd (x * x + rnd (y * y + rnd (z * z))).
Let minus_d := rnd (w - rnd (sigma * sigma) * a).

Lemma outline : minus_d < 0 ->
  - (73 / 10 * u * (sigma * sigma * A)) <= - minus_d + G * G - sigma * sigma * A <=
    73 / 10 * u * (sigma * sigma * A).
Proof.
intro Meets; assert (G2 : G * G = x * x + y * y + z * z) by apply len_square.
assert (Ra := a_close v0 v1 v2 Moves); fold a A in Ra; apply Rabs_le_inv in Ra.
assert (X := Rle_0_sqr x); assert (Y := Rle_0_sqr y); assert (Z := Rle_0_sqr z).
assert (S := Rle_0_sqr sigma); unfold Rsqr in *.
assert (Cw : - (31 / 10 * u * (G * G)) <= w - G * G <= 31 / 10 * u * (G * G)).
{ rewrite G2; unfold w, u; set (xx := x * x) in *; set (yy := y * y) in *; set (zz := z * z) in *.
  clear G2; clearbody xx yy zz; clear - X Y Z.
  round_off zz zz l1; round_off (yy + (zz - l1)) (g * (yy + zz)) l2.
  round_off (xx + (yy + (zz - l1) - l2)) (g * (xx + yy + zz)) l3; lra. }
assert (Cs : - (41 / 10 * u * (sigma * sigma * A)) <= rnd (sigma * sigma) * a - sigma * sigma * A <=
  41 / 10 * u * (sigma * sigma * A)).
{ assert (L := low_small (sigma * sigma) (sigma * sigma) ltac:(lra)).
  rewrite (rounded (sigma * sigma)); set (l := low (sigma * sigma)) in *; clearbody l.
  assert (P1 := product _ _ _ _ L Ra).
  assert (P2 := product l A _ A L ltac:(lra)).
  assert (P3 := product (sigma * sigma) (a - A) (sigma * sigma) _ ltac:(lra) Ra).
  replace ((sigma * sigma - l) * a - sigma * sigma * A) with
    (sigma * sigma * (a - A) - l * A - l * (a - A)) by ring.
  assert (0 <= sigma * sigma * A) by (apply Rmult_le_pos; lra); unfold u in *; lra. }
assert (D := low_own (w - rnd (sigma * sigma) * a)).
assert (Dm : minus_d = w - rnd (sigma * sigma) * a - low (w - rnd (sigma * sigma) * a))
  by exact (rounded _).
set (l := low (w - _)) in *; clearbody l.
assert (M : w - rnd (sigma * sigma) * a < 0).
{ revert D; unfold u, Rabs; destruct Rcase_abs; intro; lra. }
rewrite Rabs_left in D by exact M; assert (G0 : 0 <= G * G) by apply Rle_0_sqr.
clear - D Dm Cw Cs G0 M Meets; set (q := sigma * sigma * A) in *.
set (s := rnd (sigma * sigma) * a) in *; set (gg := G * G) in *.
clearbody q s gg w minus_d; unfold u in *; lra.
Qed.

(* meeting_time_fast (sg = -1): |b + root| / a where that is negative; and the root of a far pair in
   parting_time_fast (sg = 1): 5.3 eps. *)
Theorem fast_gap sg : sg = 1 \/ sg = - 1 -> minus_d < 0 ->
  let num := rnd (sg * rnd (sqrt (- minus_d)) - b) in let t := rnd (num / a) in 0 < num ->
  0 <= t /\ Rabs (len (r0 + v0 * t) (r1 + v1 * t) (r2 + v2 * t) - sigma) <=
    106 / 10 * u * (sigma + V * t).
Proof.
intros Sg Meets num t Later; set (rho := sqrt (- minus_d)) in *.
assert (R0 : 0 <= rho) by apply sqrt_pos.
assert (R2 : rho * rho = - minus_d) by (apply sqrt_sqrt; lra).
destruct (along_close r0 r1 r2 v0 v1 v2 Moves sg rho Sg R0 Later) as [T0 Al].
split; [exact T0 |].
assert (O := outline Meets); rewrite <- R2 in O.
destruct (radius rho G (73 / 10) R0 ltac:(lra) O) as [Rc Rr].
assert (Rc' : Rabs (len rho G 0 - sigma * V) <= 37 / 10 * u * (sigma * V)) by lra.
assert (Gp := gap r0 r1 r2 v0 v1 v2 Moves sigma sg rho G t (52 / 10) (37 / 10) Hs Sg T0 ltac:(lra)
  ltac:(lra) Rr Al cross_close Rc').
fold V in Gp; assert (VP := V_pos v0 v1 v2 Moves); fold V in VP.
assert (0 <= V * t) by (apply Rmult_le_pos; [apply Rlt_le, VP | exact T0]).
unfold u in *; lra.
Qed.

(* --- The later root of a near pair ------------------------------------------ *)

Let rr := dot_rounded (r0 * r0) (r1 * r1) (r2 * r2).
Let ss := rnd (sigma * sigma).
Let c := rnd (rr - ss).
Hypothesis Near : rr <= rnd (least_far * ss). (* not is_far *)

Lemma near_sizes : Rn * Rn <= 1002 / 1000 * (sigma * sigma) /\
  Rabs (rr - Rn * Rn) <= 31 / 10 * u * (Rn * Rn) /\ Rabs c <= 1002 / 1000 * (sigma * sigma) /\
  Rabs (c - (Rn * Rn - sigma * sigma)) <= 51 / 10 * u * (sigma * sigma).
Proof.
assert (R2 : Rn * Rn = r0 * r0 + r1 * r1 + r2 * r2) by apply len_square.
assert (H := dot_rounded_error (r0 * r0) (r1 * r1) (r2 * r2)); fold rr in H.
assert (X := Rle_0_sqr r0); assert (Y := Rle_0_sqr r1); assert (Z := Rle_0_sqr r2).
assert (S := Rle_0_sqr sigma); unfold Rsqr in *.
rewrite (Rabs_pos_eq _ X), (Rabs_pos_eq _ Y), (Rabs_pos_eq _ Z), <- R2 in H.
assert (R0 : 0 <= Rn * Rn) by lra; clear X Y Z R2; set (q := Rn * Rn) in *; clearbody q.
apply Rabs_le_inv in H; unfold c; unfold ss in *; set (s2 := sigma * sigma) in *; clearbody s2 rr.
assert (L1 := low_small s2 s2 ltac:(lra)); rewrite (rounded s2) in *.
set (l1 := low s2) in *; clearbody l1; unfold tiny, least_far, u in *.
assert (L2 := low_small (1025 / 1024 * (s2 - l1)) (1002 / 1000 * s2) ltac:(lra)).
rewrite (rounded (1025 / 1024 * (s2 - l1))) in Near.
set (l2 := low (1025 / 1024 * _)) in *; clearbody l2; unfold u in *.
assert (Q : q <= 1002 / 1000 * s2) by lra.
assert (L3 := low_small (rr - (s2 - l1)) (1001 / 1000 * s2) ltac:(lra)).
rewrite (rounded (rr - (s2 - l1))); set (l3 := low (rr - _)) in *; clearbody l3; unfold u in *.
repeat split; try lra; apply Rabs_le; lra.
Qed.

(* b^2 - a c of the rounded, of numbers off by f from it, is as far as the surface. *)
Lemma near_radius f :
  - (202 / 100 * u * (sigma * sigma * A)) <= f <= 202 / 100 * u * (sigma * sigma * A) ->
  - (162 / 10 * u * (sigma * sigma * A)) <= b * b - a * c + f + W * W - sigma * sigma * A <=
    162 / 10 * u * (sigma * sigma * A).
Proof.
intro F; destruct near_sizes as (Q1 & _ & Q2 & Q3).
apply Rabs_le_inv in Q2; apply Rabs_le_inv in Q3.
assert (Ra := a_close v0 v1 v2 Moves); fold a A in Ra; apply Rabs_le_inv in Ra.
assert (Rb := b_close r0 r1 r2 v0 v1 v2); fold b B Rn V in Rb; apply Rabs_le_inv in Rb.
assert (RV : 0 <= Rn * V) by (apply Rmult_le_pos; apply len_pos).
assert (Lg : W * W + B * B = Rn * Rn * A) by apply lagrange.
assert (W0 : 0 <= W * W) by apply Rle_0_sqr; assert (S := Rle_0_sqr sigma); unfold Rsqr in S.
assert (RA : Rn * V * (Rn * V) = Rn * Rn * A)
  by (unfold A; rewrite <- (V2 v0 v1 v2); fold V; ring).
assert (Bl : Rabs B <= Rn * V).
{ apply square_le; [exact RV |]; rewrite <- Rabs_mult, Rabs_pos_eq by apply Rle_0_sqr; lra. }
apply Rabs_le_inv in Bl.
assert (P1 := product (b - B) (b + B) _ (2001 / 1000 * (Rn * V)) Rb ltac:(unfold u in *; lra)).
replace (3001 / 1000 * u * (Rn * V) * (2001 / 1000 * (Rn * V))) with
  (3001 / 1000 * 2001 / 1000 * u * (Rn * V * (Rn * V))) in P1 by field; rewrite RA in P1.
assert (P2 := product (a - A) c _ _ Ra Q2).
assert (P3 := product A (c - (Rn * Rn - sigma * sigma)) A _ ltac:(lra) Q3).
assert (QA : Rn * Rn * A <= 1002 / 1000 * (sigma * sigma) * A) by (apply Rmult_le_compat_r; lra).
replace (b * b - a * c + f + W * W - sigma * sigma * A) with
  ((b - B) * (b + B) - (a - A) * c - A * (c - (Rn * Rn - sigma * sigma)) + f) by
  (replace (W * W) with (Rn * Rn * A - B * B) by lra; ring).
assert (0 <= sigma * sigma * A) by (apply Rmult_le_pos; lra).
unfold u in *; lra.
Qed.

(* Of root_of_chord and later_root: b <= 0, from outside or inside. *)
Let d := rnd (b * b - rnd (a * c)).

Lemma near_discriminant : 0 < d ->
  - (202 / 100 * u * (sigma * sigma * A)) <= d - (b * b - a * c) <=
    202 / 100 * u * (sigma * sigma * A).
Proof.
intro D; destruct near_sizes as (Q1 & _ & Q2 & _); apply Rabs_le_inv in Q2.
assert (Ra := a_close v0 v1 v2 Moves); fold a A in Ra; apply Rabs_le_inv in Ra.
assert (S := Rle_0_sqr sigma); unfold Rsqr in S.
assert (SA : 0 <= sigma * sigma * A) by (apply Rmult_le_pos; lra).
assert (Pa := product a c (1001 / 1000 * A) _ ltac:(unfold u in *; lra) Q2).
assert (F : - (162 / 10 * u * (sigma * sigma * A)) <=
  b * b - a * c + 0 + W * W - sigma * sigma * A <= 162 / 10 * u * (sigma * sigma * A)) by (apply near_radius; unfold u; lra).
assert (W0 : 0 <= W * W) by apply Rle_0_sqr; assert (B0 : 0 <= b * b) by apply Rle_0_sqr.
unfold d in *; set (ac := a * c) in *; set (bb := b * b) in *; set (q := sigma * sigma * A) in *.
replace (1001 / 1000 * A * (1002 / 1000 * (sigma * sigma))) with (1003002 / 1000000 * q) in Pa
  by (unfold q; field).
clearbody ac bb q; assert (L1 := low_small ac (1003002 / 1000000 * q) Pa).
rewrite (rounded ac) in *; set (l1 := low ac) in *; clearbody l1.
assert (Lo := low_own (bb - (ac - l1))); rewrite (rounded (bb - (ac - l1))) in *.
set (l2 := low (bb - _)) in *; clearbody l2.
assert (P : 0 < bb - (ac - l1)).
{ revert Lo; unfold u, Rabs; destruct Rcase_abs; intro; lra. }
rewrite Rabs_pos_eq in Lo by lra; unfold u in *; lra.
Qed.

Theorem near_gap : 0 < d -> b <= 0 ->
  let num := rnd (rnd (sqrt d) + Rabs b) in let t := rnd (num / a) in 0 < num ->
  0 <= t /\ Rabs (len (r0 + v0 * t) (r1 + v1 * t) (r2 + v2 * t) - sigma) <=
    15 * u * (sigma + V * t).
Proof.
intros D Neg; cbv zeta; rewrite (Rabs_left1 b) by exact Neg.
replace (rnd (sqrt d) + - b) with (1 * rnd (sqrt d) - b) by ring.
intro Later; set (rho := sqrt d) in *; set (t := rnd (rnd (1 * rnd rho - b) / a)).
assert (R0 : 0 <= rho) by apply sqrt_pos; assert (R2 : rho * rho = d) by (apply sqrt_sqrt; lra).
assert (Sg : 1 = 1 \/ 1 = - 1) by (left; reflexivity).
destruct (along_close r0 r1 r2 v0 v1 v2 Moves 1 rho Sg R0 Later) as [T0 Al].
split; [exact T0 |].
assert (O := near_radius _ (near_discriminant D)).
replace (b * b - a * c + (d - (b * b - a * c))) with (rho * rho) in O by (rewrite R2; ring).
destruct (radius rho W (162 / 10) R0 ltac:(lra) O) as [Rc Rr].
assert (Rc' : Rabs (len rho W 0 - sigma * V) <= 82 / 10 * u * (sigma * V)).
{ apply Rle_trans with (1 := Rc); apply Rmult_le_compat_r.
  - apply Rmult_le_pos; [exact Hs | apply len_pos].
  - unfold u; lra. }
assert (Zw : Rabs (W - W) <= 22 / 10 * u * (Rn * V)).
{ rewrite Rminus_diag_eq, Rabs_R0 by reflexivity.
  repeat apply Rmult_le_pos; try apply len_pos; unfold u; lra. }
assert (Gp := gap r0 r1 r2 v0 v1 v2 Moves sigma 1 rho W t (52 / 10) (82 / 10) Hs Sg T0 ltac:(lra)
  ltac:(lra) Rr Al Zw Rc').
fold V in Gp; assert (VP := V_pos v0 v1 v2 Moves); fold V in VP.
assert (0 <= V * t) by (apply Rmult_le_pos; [apply Rlt_le, VP | exact T0]).
unfold u in *; lra.
Qed.

(* b > 0, inside. *)
Theorem near_gap_leaving : 0 < b -> c < 0 ->
  let t := rnd (- c / rnd (rnd (sqrt d) + b)) in
  0 <= t /\ Rabs (len (r0 + v0 * t) (r1 + v1 * t) (r2 + v2 * t) - sigma) <=
    15 * u * (sigma + V * t).
Proof.
intros Pb Nc t.
assert (Ra := a_close v0 v1 v2 Moves); fold a A in Ra; apply Rabs_le_inv in Ra.
assert (Pa : 0 < a) by (unfold u in *; lra).
assert (Ac : a * c < 0) by (assert (0 < a * - c) by (apply Rmult_lt_0_compat; lra); lra).
assert (B2 : 0 < b * b) by (apply Rmult_lt_0_compat; exact Pb).
set (s := sqrt (b * b - a * c)); assert (s2 : s * s = b * b - a * c) by (apply sqrt_sqrt; lra).
assert (Ps : 0 < s) by (apply sqrt_lt_R0; lra).
assert (D : - (201 / 100 * u * (s * s)) <= d - s * s <= 201 / 100 * u * (s * s)).
{ unfold d; rewrite s2; set (ac := a * c) in *; set (bb := b * b) in *; clearbody ac bb; unfold u.
  round_off ac (- ac) l1; round_off (bb - (ac - l1)) (1001 / 1000 * (bb - ac)) l2; lra. }
assert (S0 : 0 < s * s) by (apply Rmult_lt_0_compat; exact Ps).
set (e := sqrt d) in *; assert (X2 : e * e = d) by (apply sqrt_sqrt; unfold u in *; lra).
assert (X0 : 0 <= e) by apply sqrt_pos.
assert (X1 : (1 - 102 / 100 * u) * s <= e <= (1 + 102 / 100 * u) * s).
{ split; apply square_le; try exact X0; try (unfold u; lra); rewrite X2.
  - replace ((1 - 102 / 100 * u) * s * ((1 - 102 / 100 * u) * s)) with
      ((1 - 204 / 100 * u + 102 / 100 * 102 / 100 * u * u) * (s * s)) by field.
    unfold u in *; lra.
  - replace ((1 + 102 / 100 * u) * s * ((1 + 102 / 100 * u) * s)) with
      ((1 + 204 / 100 * u + 102 / 100 * 102 / 100 * u * u) * (s * s)) by field.
    unfold u in *; lra. }
(* the sum, and the quotient, off by 3.1u and 4.2u of t' = (s - b) / a *)
assert (Sm : - (31 / 10 * u * (s + b)) <= rnd (rnd e + b) - (s + b) <= 31 / 10 * u * (s + b)).
{ clear - X1 Ps Pb; clearbody e s b; unfold u in *.
  round_off e (1001 / 1000 * s) l1; round_off (e - l1 + b) (1001 / 1000 * (s + b)) l2; lra. }
unfold t; set (sum := rnd (rnd e + b)) in *; clearbody sum.
assert (SP : 0 < sum) by (unfold u in *; lra).
set (t' := (s - b) / a); assert (E' : - c = t' * (s + b)).
{ unfold t'; apply (Rmult_eq_reg_l a); [| lra].
  replace (a * ((s - b) / a * (s + b))) with (s * s - b * b) by (field; lra); lra. }
assert (at' : a * t' = s - b) by (unfold t'; field; lra).
assert (T' : 0 < t').
{ apply (Rmult_lt_reg_r (s + b)); [lra |]; rewrite <- E'; lra. }
set (q := - c / sum); assert (Qs : q * sum = t' * (s + b)) by (unfold q; rewrite E'; field; lra).
assert (Q : (1 - 32 / 10 * u) * t' <= q <= (1 + 32 / 10 * u) * t').
{ split; apply (Rmult_le_reg_r sum); try exact SP; rewrite Qs.
  - apply Rle_trans with ((1 - 32 / 10 * u) * t' * ((1 + 31 / 10 * u) * (s + b))).
    + apply Rmult_le_compat_l; [apply Rmult_le_pos; unfold u |]; lra.
    + replace ((1 - 32 / 10 * u) * t' * ((1 + 31 / 10 * u) * (s + b))) with
        ((1 - 32 / 10 * u) * (1 + 31 / 10 * u) * (t' * (s + b))) by ring.
      assert (0 < t' * (s + b)) by (apply Rmult_lt_0_compat; lra); unfold u in *; lra.
  - apply Rle_trans with ((1 + 32 / 10 * u) * t' * ((1 - 31 / 10 * u) * (s + b))).
    + replace ((1 + 32 / 10 * u) * t' * ((1 - 31 / 10 * u) * (s + b))) with
        ((1 + 32 / 10 * u) * (1 - 31 / 10 * u) * (t' * (s + b))) by ring.
      assert (0 < t' * (s + b)) by (apply Rmult_lt_0_compat; lra); unfold u in *; lra.
    + apply Rmult_le_compat_l; [apply Rmult_le_pos; unfold u |]; lra. }
assert (L3 := low_small q (1001 / 1000 * t') ltac:(unfold u in *; lra)).
assert (Tq : (1 - 43 / 10 * u) * t' <= rnd q <= (1 + 43 / 10 * u) * t')
  by (rewrite (rounded q); unfold u in *; lra).
set (tt := rnd q) in *; assert (T0 : 0 <= tt) by (unfold u in *; lra); clearbody tt.
split; [exact T0 |].
assert (Sg : 1 = 1 \/ 1 = - 1) by (left; reflexivity).
assert (Rb := b_close r0 r1 r2 v0 v1 v2); fold b B Rn V in Rb; apply Rabs_le_inv in Rb.
assert (VA : V * (V * tt) = A * tt) by (unfold A; rewrite <- (V2 v0 v1 v2); fold V; ring).
assert (Al : Rabs (A * tt + B - 1 * s) <= u * (V * (75 / 10 * (V * tt) + 31 / 10 * Rn) + s)).
{ replace (V * (75 / 10 * (V * tt) + 31 / 10 * Rn)) with (75 / 10 * (A * tt) + 31 / 10 * (Rn * V))
    by (rewrite <- VA; ring).
  assert (P1 := product (A - a) t' (3001 / 1000 * u * A) t' ltac:(lra) ltac:(lra)).
  assert (P2 := product A (tt - t') A (43 / 10 * u * t') ltac:(lra) ltac:(lra)).
  assert (P3 : A * t' <= A * ((1 + 5 * u) * tt)) by (apply Rmult_le_compat_l; unfold u in *; lra).
  replace (A * tt + B - 1 * s) with (A * (tt - t') + (A - a) * t' + (B - b))
    by (replace s with (a * t' + b) by lra; ring).
  assert (0 <= A * t') by (apply Rmult_le_pos; lra).
  assert (0 <= Rn * V) by (apply Rmult_le_pos; apply len_pos).
  apply Rabs_le; unfold u in *; lra. }
assert (SA : 0 <= sigma * sigma * A) by (apply Rmult_le_pos; [apply Rle_0_sqr | lra]).
assert (O := near_radius 0 ltac:(unfold u; lra)); rewrite Rplus_0_r, <- s2 in O.
destruct (radius s W (162 / 10) (Rlt_le _ _ Ps) ltac:(lra) O) as [Rc Rr].
assert (Rc' : Rabs (len s W 0 - sigma * V) <= 82 / 10 * u * (sigma * V)).
{ apply Rle_trans with (1 := Rc); apply Rmult_le_compat_r.
  - apply Rmult_le_pos; [exact Hs | apply len_pos].
  - unfold u; lra. }
assert (Zw : Rabs (W - W) <= 22 / 10 * u * (Rn * V)).
{ rewrite Rminus_diag_eq, Rabs_R0 by reflexivity.
  repeat apply Rmult_le_pos; try apply len_pos; unfold u; lra. }
assert (Gp := gap r0 r1 r2 v0 v1 v2 Moves sigma 1 s W tt (75 / 10) (82 / 10) Hs Sg T0 ltac:(lra)
  ltac:(lra) Rr Al Zw Rc').
fold V in Gp; assert (VP := V_pos v0 v1 v2 Moves); fold V in VP.
assert (0 <= V * tt) by (apply Rmult_le_pos; [apply Rlt_le, VP | exact T0]).
unfold u in *; lra.
Qed.
End Fast.
