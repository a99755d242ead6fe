(* with: rounding.v *)
(* SPDX-License-Identifier: MIT *)
(* For event_time_near.v: the later root t of a x^2 + 2 b x + c as it is rounded, with its two
   branches; of what the coefficients are off see event_time_root.v.  Unbounded exponents. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding.
Open Scope R_scope.

Section Rounded.
Variables a b c s t : R.
Hypotheses (Ha : 0 < a) (Hs : 0 < s) (Ht : 0 < t).
Hypotheses (es : s * s = b * b - a * c) (et : a * t = s - b).

Lemma last_coefficient : c = - (t * (s + b)).
Proof.
apply (Rmult_eq_reg_l a); [| lra].
replace (a * - (t * (s + b))) with (- (a * t * (s + b))) by ring; rewrite et.
replace (a * c) with (b * b - s * s) by lra; ring.
Qed.

Let y := Rabs b.
Hypothesis Hy : y <= 1156 / 1000 * s.

Lemma size_of_b : 0 <= y /\ - y <= b <= y.
Proof. split; [apply Rabs_pos | apply Rabs_le_inv, Rle_refl]. Qed.

Let d := rnd (rnd (b * b) - a * c).
Let root := rnd (sqrt d).
Let sum := rnd (root + y).

Lemma rounded_discriminant :
  - (10001 / 10000 * u * (y * y + s * s)) <= d - s * s <= 10001 / 10000 * u * (y * y + s * s).
Proof.
assert (Y : y * y = b * b) by (unfold y; rewrite <- Rabs_mult; apply Rabs_pos_eq, Rle_0_sqr).
unfold d; assert (0 <= b * b) by apply Rle_0_sqr; assert (0 <= s * s) by apply Rle_0_sqr.
replace (a * c) with (b * b - s * s) by lra; rewrite Y.
set (bb := b * b) in *; set (ss := s * s) in *; clearbody bb ss; unfold u.
round_off bb bb l1; round_off (bb - l1 - (bb - ss)) (ss + bb / 1000000) l2; lra.
Qed.

Lemma rounded_sum : Rabs (sum - (s + y)) * s <=
  (s + y) * (u * (15015 / 10000 * s - 427 / 1000 * y + 1001 / 1000 * s)).
Proof.
destruct size_of_b as [Y0 _]; assert (E := rounded_discriminant).
assert (Ss : 0 < s * s) by (apply Rmult_lt_0_compat; lra).
assert (Ys : y * y <= 134 / 100 * (s * s)).
{ apply Rle_trans with (1156 / 1000 * s * (1156 / 1000 * s)); [apply Rmult_le_compat |]; lra. }
assert (0 < d) by (unfold u in *; lra).
set (x := sqrt d) in *; assert (X2 : x * x = d) by (apply sqrt_sqrt; lra).
assert (Xp : 0 < x) by (apply sqrt_lt_R0; assumption).
assert (X1 : (1 - 3 * u) * s <= x).
{ apply square_le; [lra |]; rewrite X2.
  replace ((1 - 3 * u) * s * ((1 - 3 * u) * s)) with ((1 - 6 * u + 9 * u * u) * (s * s)) by ring.
  unfold u in *; lra. }
assert (Q1 : Rabs (x - s) * (s * (19999 / 10000)) <= 10001 / 10000 * u * (y * y + s * s)).
{ apply Rle_trans with (Rabs (x - s) * (x + s)).
  - apply Rmult_le_compat_l; [apply Rabs_pos |]; unfold u in *; lra.
  - rewrite <- (Rabs_pos_eq (x + s)) at 1 by lra; rewrite <- Rabs_mult.
    replace ((x - s) * (x + s)) with (d - s * s) by (rewrite <- X2; ring); apply Rabs_le; exact E. }
assert (Q2 : Rabs (x - s) * s <= 5002 / 10000 * u * (y * y + s * s)).
{ assert (0 <= y * y) by apply Rle_0_sqr; set (k := Rabs (x - s) * s).
  replace (Rabs (x - s) * (s * (19999 / 10000))) with (19999 / 10000 * k) in Q1
    by (unfold k; field).
  clearbody k; unfold u in *; lra. }
assert (Rx : Rabs (root - x) <= u * x).
{ assert (L := low_small x x ltac:(lra)); unfold root; rewrite (rounded x).
  apply Rabs_le; unfold u in *; lra. }
assert (Up : x <= 20001 / 20000 * s).
{ assert (K : Rabs (x - s) * s <= / 20000 * s * s) by (unfold u in *; lra).
  apply Rmult_le_reg_r in K; [| lra]; generalize (Rle_abs (x - s)); lra. }
assert (Q3 : Rabs (root - s) * s <= u * (5002 / 10000 * (y * y + s * s) + 10002 / 10000 * (s * s))).
{ assert (Rabs (root - s) <= Rabs (root - x) + Rabs (x - s)).
  { replace (root - s) with (root - x + (x - s)) by ring; apply Rabs_triang. }
  apply Rle_trans with ((u * (10001 / 10000 * s) + Rabs (x - s)) * s).
  - apply Rmult_le_compat_r; [lra |]; unfold u in *; lra.
  - unfold u in *; lra. }
assert (Q4 : Rabs (root - s) * s <= u * ((15014 / 10000 * s - 427 / 1000 * y) * (s + y))).
{ apply Rle_trans with (1 := Q3), Rmult_le_compat_l; [unfold u; lra |].
  assert (y * y <= 1156 / 1000 * (s * y)).
  { replace (1156 / 1000 * (s * y)) with (1156 / 1000 * s * y) by ring.
    apply Rmult_le_compat_r; lra. }
  assert (0 <= s * y) by (apply Rmult_le_pos; lra); lra. }
assert (Sm : Rabs (sum - (root + y)) <= u * (10001 / 10000 * (s + y))).
{ assert (Gr := Rabs_le_inv _ _ Rx).
  assert (L := low_small (root + y) (10001 / 10000 * (s + y)) ltac:(unfold u in *; lra)).
  unfold sum; rewrite (rounded (root + y)); apply Rabs_le; unfold u in *; lra. }
apply Rle_trans with ((Rabs (sum - (root + y)) + Rabs (root - s)) * s).
- apply Rmult_le_compat_r; [lra |].
  replace (sum - (s + y)) with (sum - (root + y) + (root - s)) by ring; apply Rabs_triang.
- assert (K : Rabs (sum - (root + y)) * s <= u * (10001 / 10000 * (s + y)) * s)
    by (apply Rmult_le_compat_r; lra).
  assert (0 <= s * y) by (apply Rmult_le_pos; lra); unfold u in *; lra.
Qed.

Let answer := if Rlt_dec 0 b then rnd (- c / sum) else rnd (sum / a).

Lemma rounded_root : Rabs (answer - t) * s <=
  t * (u * (1502 / 1000 * s - 427 / 1000 * y + 2003 / 1000 * s)).
Proof.
destruct size_of_b as [Y0 Yb]; assert (K := rounded_sum).
set (v := 15015 / 10000 * s - 427 / 1000 * y + 1001 / 1000 * s) in *.
assert (V : 0 <= v <= 3 * s) by (unfold v; lra).
assert (G : Rabs (sum - (s + y)) <= 3 * u * (s + y)).
{ apply (Rmult_le_reg_r s); [lra |]; apply Rle_trans with (1 := K).
  replace (3 * u * (s + y) * s) with ((s + y) * (u * (3 * s))) by ring.
  apply Rmult_le_compat_l; [lra |]; apply Rmult_le_compat_l; [unfold u |]; lra. }
assert (G' := Rabs_le_inv _ _ G).
assert (SP : 0 < sum) by (unfold u in *; lra).
(* the quotient before it is rounded *)
assert (Q : exists q, answer = rnd q /\ Rabs (q - t) * s <= (1 + 4 * u) * (t * (u * v))).
{ unfold answer; destruct (Rlt_dec 0 b) as [P | N].
  - exists (- c / sum); split; [reflexivity |].
    assert (y = b) by (unfold y; apply Rabs_pos_eq; lra).
    replace (- c / sum - t) with (t / sum * - (sum - (s + y)))
      by (rewrite last_coefficient; rewrite <- H; field; lra).
    rewrite Rabs_mult, Rabs_Ropp, Rabs_pos_eq by (apply Rlt_le, Rdiv_lt_0_compat; lra).
    apply (Rmult_le_reg_r sum); [exact SP |].
    replace (t / sum * Rabs (sum - (s + y)) * s * sum) with (t * (Rabs (sum - (s + y)) * s))
      by (field; lra).
    apply Rle_trans with (t * ((s + y) * (u * v))); [apply Rmult_le_compat_l; lra |].
    replace ((1 + 4 * u) * (t * (u * v)) * sum) with (t * ((1 + 4 * u) * sum * (u * v))) by ring.
    apply Rmult_le_compat_l; [lra |]; apply Rmult_le_compat_r.
    + apply Rmult_le_pos; [unfold u |]; lra.
    + unfold u in *; lra.
  - exists (sum / a); split; [reflexivity |].
    assert (y = - b) by (unfold y; apply Rabs_left1; lra).
    replace (sum / a - t) with ((sum - (s + y)) / a)
      by (replace t with ((s + y) / a); [field; lra |];
          apply (Rmult_eq_reg_l a); [| lra]; rewrite et, H; field; lra).
    unfold Rdiv; rewrite Rabs_mult, (Rabs_pos_eq (/ a))
      by (apply Rlt_le, Rinv_0_lt_compat, Ha).
    apply (Rmult_le_reg_l a); [exact Ha |].
    replace (a * (Rabs (sum - (s + y)) * / a * s)) with (Rabs (sum - (s + y)) * s) by (field; lra).
    replace (a * ((1 + 4 * u) * (t * (u * v)))) with ((1 + 4 * u) * (a * t * (u * v))) by ring.
    replace (a * t) with (s + y) by lra.
    assert (0 <= (s + y) * (u * v)).
    { apply Rmult_le_pos; [lra |]; apply Rmult_le_pos; [unfold u |]; lra. }
    unfold u in *; lra. }
destruct Q as (q & -> & Q).
assert (Tv : t * (u * v) <= t * (u * (3 * s))).
{ apply Rmult_le_compat_l; [lra |]; apply Rmult_le_compat_l; [unfold u |]; lra. }
assert (Ts : 0 < t * s) by (apply Rmult_lt_0_compat; lra).
assert (Near : Rabs (q - t) <= / 1000 * t).
{ apply (Rmult_le_reg_r s); [lra |]; apply Rle_trans with (1 := Q).
  replace (t * (u * (3 * s))) with (3 * u * (t * s)) in Tv by ring; unfold u in *; lra. }
apply Rabs_le_inv in Near.
assert (L := low_small q (1001 / 1000 * t) ltac:(lra)).
assert (L' : Rabs (rnd q - q) <= u * (1001 / 1000 * t))
  by (rewrite (rounded q); apply Rabs_le; lra).
apply Rle_trans with ((Rabs (rnd q - q) + Rabs (q - t)) * s).
- apply Rmult_le_compat_r; [lra |].
  replace (rnd q - t) with (rnd q - q + (q - t)) by ring; apply Rabs_triang.
- assert (K1 : Rabs (rnd q - q) * s <= u * (1001 / 1000 * t) * s)
    by (apply Rmult_le_compat_r; lra).
  replace (t * (u * (1502 / 1000 * s - 427 / 1000 * y + 2003 / 1000 * s)))
    with (t * (u * v) + 10025 / 10000 * u * (t * s)) by (unfold v; field).
  replace (t * (u * (3 * s))) with (3 * u * (t * s)) in Tv by ring.
  set (m := t * (u * v)) in *; clearbody m; unfold u in *; lra.
Qed.
End Rounded.
