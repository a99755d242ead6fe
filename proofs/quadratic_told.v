(* with: rounding.v quadratic_told_sum.v *)
(* SPDX-License-Identifier: MIT *)
(* roots_told of quadratic.c: how near x + y, which lanes_are_told is asked about, is to each root,
   nearly double ones too: h >= 0, of which h < 0 is the mirror.  Unbounded exponents. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding quadratic_told_sum.
Open Scope R_scope.

(* s / a and c / s: a quotient by the inverse, and what its residual adds. *)
Definition upper a s := rnd (s * rnd (1 / a)).
Definition upper_more a s l := rnd (rnd (l + rnd (s - upper a s * a)) * rnd (1 / a)).
Definition lower c s := rnd (c * rnd (1 / s)).
Definition lower_more c s l := rnd (rnd (rnd (c - lower c s * s) - lower c s * l) * rnd (1 / s)).

Lemma low_times w a b : - b <= w * a <= b -> - (u * b) <= low w * a <= u * b.
Proof.
intro B; assert (L := low_own w); apply Rabs_le_inv; rewrite Rabs_mult.
apply Rle_trans with (u * Rabs w * Rabs a).
- apply Rmult_le_compat_r; [apply Rabs_pos | apply Rabs_le, L].
- rewrite Rmult_assoc, <- Rabs_mult; apply Rmult_le_compat_l; [unfold u; lra | apply Rabs_le, B].
Qed.

Lemma inverse_times a : a <> 0 -> exists i, rnd (1 / a) * a = 1 - i /\ - u <= i <= u.
Proof.
intro N; exists (low (1 / a) * a); split.
- rewrite (rounded (1 / a)); field; exact N.
- assert (E : 1 / a * a = 1) by (field; exact N).
  assert (L := low_times (1 / a) a 1 ltac:(lra)); lra.
Qed.

(* v divided by that inverse, rounded, times a is v but for 2u. *)
Lemma divided v a b : a <> 0 -> - b <= v <= b ->
  - (2001 / 1000 * u * b) <= v - rnd (v * rnd (1 / a)) * a <= 2001 / 1000 * u * b.
Proof.
intros N B; destruct (inverse_times a N) as (i & E & I); set (r := rnd (1 / a)) in *.
assert (Vi := product v i b u B I).
assert (W : v * r * a = v - v * i) by (rewrite Rmult_assoc, E; ring).
assert (L := low_times (v * r) a ((1 + u) * b) ltac:(lra)).
rewrite (rounded (v * r)), Rmult_minus_distr_r, W; unfold u in *; lra.
Qed.

Lemma close_times p r q k : q <> 0 -> Rabs (p * q - r) <= k * Rabs r ->
  Rabs (p - r / q) <= k * Rabs (r / q).
Proof.
intros N B; assert (P := Rabs_pos_lt q N); apply (Rmult_le_reg_r (Rabs q)); [exact P |].
rewrite Rmult_assoc, <- !Rabs_mult; replace (r / q * q) with r by (field; exact N).
replace ((p - r / q) * q) with (p * q - r) by (field; exact N); exact B.
Qed.

Lemma smaller_times p r q : q <> 0 -> Rabs (p * q) <= Rabs (r * q) -> Rabs p <= Rabs r.
Proof.
intros N; rewrite !Rabs_mult; apply Rmult_le_reg_r, Rabs_pos_lt, N.
Qed.

Section Roots.
Variables s l S : R.
Hypotheses (Ps : 0 < s) (Small : - (5 * u * s) <= l <= 5 * u * s)
  (Near : - (/ 75557863725914323419136 * S) <= s + l - S <= / 75557863725914323419136 * S).

Notation close := (3 / 4 / 37778931862957161709568). (* 3/4 2^-75 *)

Lemma upper_is_told a : a <> 0 -> let x := upper a s in let y := upper_more a s l in
  Rabs (x + y - S / a) <= close * Rabs (S / a) /\ Rabs y <= Rabs x.
Proof.
intros N x y; assert (X := divided s a s N ltac:(lra)); fold (upper a s) in X; fold x in X.
unfold y, upper_more; fold x; set (z := s - x * a) in *.
assert (Ex : x * a = s - z) by (unfold z; ring); clearbody z; unfold u in *.
round_off z (2001 / 1000 / 9007199254740992 * s) l2.
round_off (l + (z - l2)) (71 / 10 / 9007199254740992 * s) l3.
set (v := l + (z - l2) - l3) in *.
assert (V : - (72 / 10 / 9007199254740992 * s) <= v <= 72 / 10 / 9007199254740992 * s)
  by (unfold v; lra).
assert (Y := divided v a _ N V); set (y' := rnd (v * rnd (1 / a))) in *; unfold u in Y.
split.
- apply close_times; [exact N |]; rewrite (Rabs_pos_eq S) by lra.
  replace ((x + y') * a) with (x * a + y' * a) by ring.
  rewrite Ex; unfold v in *; apply Rabs_le; lra.
- apply (smaller_times _ _ a N); rewrite Ex; unfold Rabs; repeat destruct Rcase_abs; lra.
Qed.

Lemma lower_is_told c : let x := lower c s in let y := lower_more c s l in
  Rabs (x + y - c / S) <= close * Rabs (c / S) /\ Rabs y <= Rabs x.
Proof.
intros x y; assert (PS : 0 < S) by (unfold u in *; lra).
assert (N : s <> 0) by lra; assert (B := conj (Rle_abs c) (Rle_abs (- c))).
rewrite Rabs_Ropp in B; set (b := Rabs c) in *; assert (Eb : Rabs c = b) by reflexivity.
clearbody b.
assert (X := divided c s b N ltac:(lra)); fold (lower c s) in X; fold x in X.
unfold y, lower_more; fold x; set (z := c - x * s) in *.
assert (Ex : x * s = c - z) by (unfold z; ring); clearbody z.
set (k := l / s); assert (Ek : s * k = l) by (unfold k; field; lra).
assert (K : - (5 * u) <= k <= 5 * u).
{ split; apply (Rmult_le_reg_r s); try exact Ps; unfold k, Rdiv;
    rewrite Rmult_assoc, Rinv_l by lra; lra. }
assert (Xl : x * l = (c - z) * k) by (rewrite <- Ek, <- Ex; ring); rewrite Xl.
assert (Zk := product (c - z) k (1001 / 1000 * b) _ ltac:(unfold u in *; lra) K).
set (w := (c - z) * k) in *; assert (Ew : w = (c - z) * k) by reflexivity; clearbody w.
unfold u in *.
round_off z (2001 / 1000 / 9007199254740992 * b) l2.
round_off (z - l2 - w) (71 / 10 / 9007199254740992 * b) l3.
set (v := z - l2 - w - l3) in *.
assert (V : - (72 / 10 / 9007199254740992 * b) <= v <= 72 / 10 / 9007199254740992 * b)
  by (unfold v; lra).
assert (Y := divided v s _ N V); set (y' := rnd (v * rnd (1 / s))) in *; unfold u in Y.
set (t := v - y' * s) in *; assert (Ey : y' * s = v - t) by (unfold t; ring); clearbody t y'.
assert (Yk := product (v - t) k (73 / 10 / 9007199254740992 * b) _ ltac:(lra) K).
split.
- (* times S: s + l, and what it is off by *)
  set (m := (S - (s + l)) / s); assert (Em : s * m = S - (s + l)) by (unfold m; field; lra).
  assert (M : - (101 / 100 / 75557863725914323419136) <= m <= 101 / 100 / 75557863725914323419136).
  { split; apply (Rmult_le_reg_r s); try exact Ps; rewrite (Rmult_comm m), Em; lra. }
  assert (XM := product (c - z + (v - t)) m (1001 / 1000 * b) _ ltac:(lra) M).
  apply close_times; [lra |].
  assert (E : (x + y') * S = x * s + y' * s + (x * s * k + y' * s * k) + (x * s + y' * s) * m).
  { replace S with (s + s * k + s * m) by (rewrite Ek, Em; ring); ring. }
  rewrite E, Ex, Ey, <- Ew, Eb.
  set (p := (v - t) * k) in *; set (q := (c - z + (v - t)) * m) in *; clearbody p q.
  unfold v in *; apply Rabs_le; lra.
- apply (smaller_times _ _ s N); rewrite Ex, Ey; revert Eb; clear - X V Yk Y Ex Ey N B.
  unfold Rabs; repeat destruct Rcase_abs; lra.
Qed.
End Roots.

(* What is asked of d, where nothing cancels. *)
Definition discriminant h a c := rnd (rnd (h * h - rnd (a * c)) - low (a * c)).

Lemma certain_of_sum h a c : a * c <= 0 ->
  Rabs (discriminant h a c - (h * h - a * c)) <= 3 * u * discriminant h a c.
Proof.
intro N; unfold discriminant; assert (P : 0 <= h * h) by apply Rle_0_sqr.
set (x := h * h) in *; set (y := a * c) in *; clearbody x y; unfold u in *.
round_off y (- y) l0; round_off (x - (y - l0)) (1001 / 1000 * (x - y)) l1.
round_off (x - (y - l0) - l1 - l0) (1001 / 1000 * (x - y)) l2.
apply Rabs_le; lra.
Qed.

(* What lanes_are_told is asked about, as near to the roots as it has to be. *)
Theorem roots_are_told h a c : is_double h -> is_double a -> is_double c -> 0 <= h -> a <> 0 ->
  let d := discriminant h a c in let D := h * h - a * c in let S := h + sqrt D in
  let s := s_hi h d in let l := s_lo h a c d in
  0 < d -> (0 < a * c -> Rabs (d - D) <= 3 * u * d) ->
  forall x y X, x = upper a s /\ y = upper_more a s l /\ X = S / a \/
                x = lower c s /\ y = lower_more c s l /\ X = c / S ->
  Rabs (x + y - X) <= / 37778931862957161709568 * Rabs (rnd (x + y)) /\ Rabs y <= Rabs x.
Proof.
intros H A C Hh A0 d D S s l Pd Cancels x y X Which.
assert (Certain : Rabs (d - D) <= 3 * u * d).
{ destruct (Rle_or_lt (a * c) 0); [apply certain_of_sum; assumption | auto]. }
assert (Near := sum_told h a c d H A C Hh Pd Certain); cbv zeta in Near.
fold D in Near; fold S in Near; fold s in Near; fold l in Near.
destruct (root_near h a c d Pd Certain) as (Pr & _ & R); fold D in R.
destruct (exact_positive h a c d Pd Certain) as [PD _]; fold D in PD.
assert (Py := sqrt_lt_R0 D PD).
assert (L := low_small (h + rnd (sqrt d)) (h + rnd (sqrt d)) ltac:(lra)).
assert (Es : s = h + rnd (sqrt d) - low (h + rnd (sqrt d))) by apply rounded.
set (r := rnd (sqrt d)) in *; set (l0 := low (h + r)) in *; clearbody r l0 l.
assert (Ps : 0 < s) by (unfold u in *; lra).
assert (Small : - (5 * u * s) <= l <= 5 * u * s) by (unfold S, u in *; lra).
assert (Told : Rabs (x + y - X) <= 3 / 4 / 37778931862957161709568 * Rabs X /\ Rabs y <= Rabs x).
{ destruct Which as [(-> & -> & ->) | (-> & -> & ->)].
  - exact (upper_is_told s l S Ps Small Near a A0).
  - exact (lower_is_told s l S Ps Small Near c). }
destruct Told as [T Le]; split; [| exact Le].
assert (K := low_own (x + y)); assert (E := rounded (x + y)).
set (q := low (x + y)) in *; clearbody q; rewrite E; clear - T K.
set (p := x + y) in *; clearbody p; unfold u in *; revert T K.
unfold Rabs; repeat destruct Rcase_abs; intros; lra.
Qed.
