(* SPDX-License-Identifier: MIT *)
(* with: exact.v quadratic.v quadratic_sum.v *)
(* The roots of quadratic.c in binary64, within BRINK_QUADRATIC_ULP 3 of the exact ones: how far
   the discriminant is off, and its root; quadratic_sum.v has the rest. *)
From Coq Require Import ZArith Reals Psatz Lia.
From Flocq Require Import Core Relative.
From Brink Require Import exact quadratic quadratic_sum.
Open Scope R_scope.

(* --- The discriminant ------------------------------------------------------- *)

Lemma root_close x y E B : 0 < x -> 0 < y -> Rabs (x * x - y * y) <= E -> E <= B * (x + y) ->
  Rabs (x - y) <= B.
Proof.
intros X Y H1 H2; apply (Rmult_le_reg_r (x + y)); [lra |].
rewrite <- (Rabs_pos_eq (x + y)) at 1 by lra; rewrite <- Rabs_mult.
replace ((x - y) * (x + y)) with (x * x - y * y) by ring; lra.
Qed.

Lemma square_le x y : 0 <= y -> x * x <= y * y -> x <= y.
Proof. intros; apply Rsqr_incr_0_var; assumption. Qed.

(* Where something may cancel, and d is off by 3u. *)
Lemma root_of_difference h x R : 0 <= h -> 0 < x -> 0 < R ->
  Rabs (x * x - R * R) <= 3 * u * (x * x) -> R * R <= (1 + / 1024) * (h * h) ->
  Rabs (x - R) <= 4 / 5 * u * (h + R) /\ R <= 1001 / 1000 * h /\ x <= 1001 / 1000 * R.
Proof.
intros Hh X HR H Le; assert (H' := H); apply Rabs_le_inv in H'.
assert (A : (1 - 3 * u) * x <= R).
{ apply square_le; [lra |].
  assert (0 < x * x) by (apply Rmult_lt_0_compat; lra).
  replace ((1 - 3 * u) * x * ((1 - 3 * u) * x)) with ((1 - 3 * u) * (1 - 3 * u) * (x * x)) by ring.
  apply Rle_trans with ((1 - 3 * u) * (x * x)); [apply Rmult_le_compat_r; lra | lra]. }
assert (B : R <= 1001 / 1000 * h).
{ apply square_le; [lra |]; apply Rle_trans with (1 := Le).
  assert (0 <= h * h) by (apply Rle_0_sqr); lra. }
assert (C : x <= 10001 / 10000 * R) by lra.
split; [| split; lra].
apply (root_close _ _ _ _ X HR H).
replace (3 * u * (x * x)) with (3 * u * x * x) by ring.
apply Rle_trans with (3 * u * x * (5001 / 10000 * (x + R))).
- apply Rmult_le_compat_l; lra.
- replace (3 * u * x * (5001 / 10000 * (x + R))) with (15003 / 10000 * u * x * (x + R)) by field.
  apply Rmult_le_compat_r; lra.
Qed.

(* Where nothing cancels. *)
Lemma root_of_sum h x R : 0 <= h -> h <= R -> 0 < x -> 0 < R ->
  Rabs (x * x - R * R) <= u * (1 + 101 / 100 * u) * (R * R + h * h) ->
  Rabs (x - R) <= / 2 * u * (1 + 12 / 5 * u) * (h + R).
Proof.
intros Hh Hr X HR H; assert (H' := H); apply Rabs_le_inv in H'.
assert (hh : h * h <= h * R) by (apply Rmult_le_compat_l; lra).
assert (hR : h * R <= R * R) by (apply Rmult_le_compat_r; lra).
assert (A : (1 - 6 / 5 * u) * R <= x).
{ apply square_le; [lra |].
  assert (0 < R * R) by (apply Rmult_lt_0_compat; lra).
  replace ((1 - 6 / 5 * u) * R * ((1 - 6 / 5 * u) * R))
    with ((1 - 12 / 5 * u + 36 / 25 * u * u) * (R * R)) by field.
  lra. }
apply (root_close _ _ _ _ X HR H).
apply Rle_trans with (u * (1 + 101 / 100 * u) * (R * (h + R))).
- apply Rmult_le_compat_l; lra.
- replace (u * (1 + 101 / 100 * u) * (R * (h + R)))
    with (u * (1 + 101 / 100 * u) * R * (h + R)) by ring.
  replace (/ 2 * u * (1 + 12 / 5 * u) * (h + R) * (x + R))
    with (/ 2 * u * (1 + 12 / 5 * u) * (x + R) * (h + R)) by ring.
  apply Rmult_le_compat_r; lra.
Qed.

Definition discriminant_of h (q : dd) := rnd (rnd (h * h - Rmax (hi q) (lo q)) - Rmin (hi q) (lo q)).

Lemma relative_and_more x : Rabs (rnd x - x) <= u * Rabs x + pow (-1075).
Proof.
destruct (Rle_or_lt (pow (-1022)) (Rabs x)) as [L | S].
- assert (H := relative x L); assert (P := bpow_gt_0 radix2 (-1075)); lra.
- assert (H := half_ulp x); rewrite ulp_FLT_small in H
    by (easy || (apply Rlt_le_trans with (1 := S), bpow_le; easy)).
  replace (pow (-1075)) with (/ 2 * pow emin)
    by (change (/ 2) with (pow (-1)); rewrite <- bpow_plus; reflexivity).
  assert (0 <= u * Rabs x) by (apply Rmult_le_pos; [lra | apply Rabs_pos]); lra.
Qed.

Section Discriminant.
Variables h a c : R.
Hypotheses (H : is_double h) (A : is_double a) (C : is_double c) (Hh : 0 <= h).
Let q := two_prod a c.
Let d := discriminant_of h q.
Let D := h * h - a * c.
Hypothesis Moderate : pow (-512) <= d.

(* a c > 0, not too small: Kahan's way. *)
Lemma product_positive : pow (-960) <= a * c -> Rabs (d - D) <= 3 * u * d /\ D <= h * h.
Proof.
intro L; assert (P := bpow_gt_0 radix2 (-960)).
assert (Lo := lo_is_small a c A C L); fold q in Lo; rewrite u_is_pow in Lo.
assert (Pp := p_pos a c L); fold q in Pp; apply Rabs_le_inv in Lo.
assert (E : d = discriminant h a c).
{ unfold d, discriminant_of, discriminant; fold q.
  rewrite Rmax_left, Rmin_right by lra; reflexivity. }
assert (K := discriminant_within_3_halves_ulp h a c H A C L); rewrite <- E in K; fold D in K.
assert (U := ulp_of_itself d); rewrite Rabs_pos_eq in U
  by (apply Rle_trans with (2 := Moderate), bpow_ge_0).
assert (pow (-1022) <= d) by (apply Rle_trans with (2 := Moderate), bpow_le; lia).
specialize (U ltac:(assumption)); unfold D in *; lra.
Qed.

(* a c is nothing beside h^2. *)
Lemma product_tiny : Rabs (a * c) < pow (-960) ->
  Rabs (d - D) <= 3 * u * d /\ D <= (1 + / 1024) * (h * h).
Proof.
intro L; set (w := pow (-960)) in *; assert (W : 0 < w) by apply bpow_gt_0.
assert (Wd : is_double w) by (apply generic_format_bpow; unfold FLT_exp, emin, prec; lia).
assert (Within : forall x, Rabs x <= w -> Rabs (rnd x) <= w).
{ intros x B; apply abs_round_le_generic; auto with typeclass_instances. }
assert (Hi : Rabs (hi q) <= w) by (apply Within; lra).
assert (Lo : Rabs (lo q) <= 2 * w).
{ assert (is_double (2 * w)).
  { replace (2 * w) with (pow (-959)) by (unfold w; change 2 with (pow 1);
      rewrite <- bpow_plus; reflexivity).
    apply generic_format_bpow; unfold FLT_exp, emin, prec; lia. }
  change (lo q) with (rnd (a * c + - hi q)).
  apply abs_round_le_generic; auto with typeclass_instances.
  eapply Rle_trans; [apply Rabs_triang |]; rewrite Rabs_Ropp; lra. }
assert (M : w <= pow (-400) * pow (-512)) by (unfold w; rewrite <- bpow_plus; apply bpow_le; lia).
assert (V : 0 < pow (-512)) by apply bpow_gt_0.
assert (T : pow (-1075) <= w) by (apply bpow_le; lia).
assert (T2 : pow (-400) <= u * u * u).
{ rewrite <- u_is_pow, <- !bpow_plus; apply bpow_le; lia. }
assert (w <= u * u * u * d).
{ apply Rle_trans with (1 := M); apply Rmult_le_compat; try assumption; apply bpow_ge_0. }
unfold d, discriminant_of in *.
set (m1 := Rmax (hi q) (lo q)) in *; set (m2 := Rmin (hi q) (lo q)) in *.
apply Rabs_le_inv in Hi; apply Rabs_le_inv in Lo; apply Rabs_def2 in L.
assert (M1 : - (2 * w) <= m1 <= 2 * w) by (unfold m1, Rmax; destruct Rle_dec; lra).
assert (M2 : - (2 * w) <= m2 <= 2 * w) by (unfold m2, Rmin; destruct Rle_dec; lra).
clearbody m1 m2.
assert (E1 := relative_and_more (h * h - m1)).
assert (E2 := relative_and_more (rnd (h * h - m1) - m2)).
set (f := rnd (h * h - m1)) in *; set (e := rnd (f - m2)) in *; clearbody e f.
assert (0 <= h * h) by apply Rle_0_sqr; unfold D.
revert E1 E2; unfold Rabs; repeat destruct Rcase_abs; lra.
Qed.

(* a c < 0: nothing cancels, and each of the two roundings is one of its own size. *)
Lemma product_negative : a * c <= - pow (-960) ->
  Rabs (d - D) <= u * (1 + 101 / 100 * u) * (D + h * h) /\ h * h <= D.
Proof.
intro L; set (w := pow (-960)) in *; assert (W : 0 < w) by apply bpow_gt_0.
assert (Ab : Rabs (a * c) = - (a * c)) by (apply Rabs_left; lra).
assert (X : hi q + lo q = a * c).
{ apply two_prod_is_exact; try assumption; right; rewrite Ab.
  apply Rle_trans with w; [apply bpow_le; lia | lra]. }
assert (B : Rabs (hi q - a * c) <= u * Rabs (a * c)).
{ apply relative; rewrite Ab; apply Rle_trans with w; [apply bpow_le; lia | lra]. }
rewrite Ab in B; apply Rabs_le_inv in B.
set (Q := - (a * c)) in *; set (m := lo q) in *; set (n := hi q) in *.
assert (T : pow (-1075) <= u * u * Q / 128).
{ apply Rle_trans with (pow (-113) * w).
  - unfold w; rewrite <- bpow_plus; apply bpow_le; lia.
  - assert (pow (-113) = u * u / 128) as -> by (simpl; lra).
    unfold Q; nra. }
unfold d, discriminant_of; change (hi q) with n; change (lo q) with m.
rewrite Rmax_right, Rmin_left by (unfold Q in *; lra).
assert (E1 := relative_and_more (h * h - m)); assert (0 <= h * h) by apply Rle_0_sqr.
assert (E2 : Rabs (rnd (rnd (h * h - m) - n) - (rnd (h * h - m) - n))
  <= u * Rabs (rnd (h * h - m) - n)).
{ apply relative; revert E1; unfold Rabs; unfold Q in *.
  assert (pow (-1022) <= u * w)
    by (rewrite <- u_is_pow; unfold w; rewrite <- bpow_plus; apply bpow_le; lia).
  repeat destruct Rcase_abs; lra. }
set (f := rnd (h * h - m)) in *; set (e := rnd (f - n)) in *; clearbody e f.
assert (D = h * h + Q) by (unfold D, Q; ring).
assert (m = - Q - n /\ a * c = - Q) by (unfold Q; lra).
clearbody D Q m n; clear X Moderate.
revert E1 E2; unfold Rabs; repeat destruct Rcase_abs; split; lra.
Qed.
End Discriminant.

(* --- The roots -------------------------------------------------------------- *)

(* What is asked of the square root's error, however d came about. *)
Lemma root_is_close h a c : is_double h -> is_double a -> is_double c -> 0 <= h ->
  let d := discriminant_of h (two_prod a c) in let D := h * h - a * c in
  let x := sqrt d in let R := sqrt D in
  pow (-512) <= d -> pow (-300) <= x /\ 0 < R /\ exists beta, Rabs (x - R) <= beta * (h + R) /\
  (0 <= beta <= / 2 * u * (1 + 12 / 5 * u) \/
   0 <= beta <= 4 / 5 * u /\ rnd x <= 3 / 5 * rnd (h + rnd x)).
Proof.
intros H A C Hh d D x R M.
assert (P := bpow_gt_0 radix2 (-512)).
assert (X2 : x * x = d) by (apply sqrt_sqrt; lra).
assert (X : pow (-256) <= x).
{ apply square_le; [apply sqrt_pos |]; rewrite X2, <- bpow_plus; exact M. }
assert (Px := bpow_gt_0 radix2 (-256)).
assert (pow (-300) <= x) by (apply Rle_trans with (2 := X), bpow_le; lia).
split; [assumption |].
assert (Two : (Rabs (d - D) <= 3 * u * d /\ D <= (1 + / 1024) * (h * h)) \/
   (Rabs (d - D) <= u * (1 + 101 / 100 * u) * (D + h * h) /\ h * h <= D)).
{ destruct (Rlt_or_le (Rabs (a * c)) (pow (-960))) as [Tiny | Large].
  - left; exact (product_tiny h a c M Tiny).
  - destruct (Rle_or_lt 0 (a * c)) as [Pos | Neg].
    + rewrite Rabs_pos_eq in Large by exact Pos; left.
      destruct (product_positive h a c H A C M Large) as [E B].
      assert (0 <= h * h) by apply Rle_0_sqr; split; [exact E |].
      fold D in B; lra.
    + rewrite Rabs_left in Large by exact Neg; right.
      apply product_negative; try assumption; lra. }
assert (DP : 0 < D).
{ assert (0 <= h * h) by apply Rle_0_sqr.
  destruct Two as [[E _] | [E B]]; apply Rabs_le_inv in E; lra. }
assert (RP : 0 < R) by (apply sqrt_lt_R0, DP).
assert (R2 : R * R = D) by (apply sqrt_sqrt; lra).
split; [exact RP |].
destruct Two as [[E B] | [E B]]; rewrite <- X2, <- R2 in E; rewrite <- R2 in B.
- destruct (root_of_difference h x R Hh ltac:(lra) RP E B) as (E1 & E2 & E3).
  exists (4 / 5 * u); split; [exact E1 | right; split; [lra |]].
  assert (pow (-1022) <= pow (-256)) by (apply bpow_le; lia).
  assert (C1 := relative x); rewrite Rabs_pos_eq in C1 by lra; specialize (C1 ltac:(lra)).
  apply Rabs_le_inv in C1.
  assert (C2 := relative (h + rnd x)); rewrite Rabs_pos_eq in C2 by lra.
  specialize (C2 ltac:(lra)); apply Rabs_le_inv in C2; lra.
- exists (/ 2 * u * (1 + 12 / 5 * u)); split; [| left; lra].
  apply root_of_sum; try assumption; [| lra].
  apply square_le; lra.
Qed.

(* roots_of(): for doubles a, h, c, a not 0, and d of at least 2^-512 (what is less is scaled
   first), h >= 0 or, with sg = -1, h <= 0. *)
Definition sum_of h sg d := rnd (h + sg * rnd (sqrt d)).

Lemma minus_rnd x : rnd (- x) = - rnd x.
Proof. apply round_NE_opp. Qed.

Lemma either_sign (P : R -> Prop) x : (0 < x -> P x) -> (0 < - x -> P x) -> (x = 0 -> P x) -> P x.
Proof. intros; destruct (Rtotal_order x 0) as [|[|]]; [apply H0 | apply H1 | apply H]; lra. Qed.

Lemma minus_close x y : Rabs (rnd x - y) <= 3 * ulp y -> Rabs (rnd (- x) - - y) <= 3 * ulp (- y).
Proof.
intro N; rewrite minus_rnd, ulp_opp, <- Rabs_Ropp.
replace (- (- rnd x - - y)) with (rnd x - y) by ring; exact N.
Qed.

Lemma roots_of_positive h a c : is_double h -> is_double a -> is_double c -> 0 <= h -> a <> 0 ->
  let d := discriminant_of h (two_prod a c) in let S := h + sqrt (h * h - a * c) in
  let s := rnd (h + rnd (sqrt d)) in pow (-512) <= d -> 0 < s /\ 0 < S /\
  Rabs (rnd (s / a) - S / a) <= 3 * ulp (S / a) /\ Rabs (rnd (c / s) - c / S) <= 3 * ulp (c / S).
Proof.
intros H A C Hh A0 d S s M.
destruct (root_is_close h a c H A C Hh M) as (X & RP & beta & Close & Parts).
fold d in X, Close, Parts.
assert (SP : 0 < S) by (unfold S; lra).
assert (sP : 0 < s).
{ assert (L := sum_is_large h (sqrt d) Hh X); fold s in L.
  assert (P := bpow_gt_0 radix2 (-300)); lra. }
split; [exact sP |]; split; [exact SP |]; split.
- apply (either_sign (fun a => Rabs (rnd (s / a) - S / a) <= 3 * ulp (S / a))); [| | lra].
  + intro; exact (root_over h _ _ beta Hh X RP Close Parts a A ltac:(assumption)).
  + intro; replace (s / a) with (- (s / - a)) by (field; lra).
    replace (S / a) with (- (S / - a)) by (field; lra); apply minus_close.
    exact (root_over h _ _ beta Hh X RP Close Parts (- a) (generic_format_opp _ _ _ A)
      ltac:(assumption)).
- apply (either_sign (fun c => Rabs (rnd (c / s) - c / S) <= 3 * ulp (c / S))).
  + intro; exact (root_under h _ _ beta Hh X RP Close Parts c C ltac:(assumption)).
  + intro; replace (c / s) with (- (- c / s)) by (field; lra).
    replace (c / S) with (- (- c / S)) by (field; lra); apply minus_close.
    exact (root_under h _ _ beta Hh X RP Close Parts (- c) (generic_format_opp _ _ _ C)
      ltac:(assumption)).
  + intros ->; unfold Rdiv; rewrite !Rmult_0_l, round_0, Rminus_0_r, Rabs_R0
      by auto with typeclass_instances.
    assert (U := ulp_ge_0 radix2 exponent 0); lra.
Qed.

Theorem roots_are_within_3_ulp h a c sg : is_double h -> is_double a -> is_double c -> a <> 0 ->
  sg = 1 \/ sg = - 1 -> 0 <= sg * h ->
  let d := discriminant_of h (two_prod a c) in let S := h + sg * sqrt (h * h - a * c) in
  let s := sum_of h sg d in pow (-512) <= d ->
  Rabs (rnd (s / a) - S / a) <= 3 * ulp (S / a) /\ Rabs (rnd (c / s) - c / S) <= 3 * ulp (c / S).
Proof.
intros H A C A0 [-> | ->] Hh; unfold sum_of.
- cbv zeta; rewrite !Rmult_1_l; intro M.
  apply (roots_of_positive h a c); try assumption; lra.
- assert (H' : is_double (- h)) by (apply generic_format_opp, H).
  assert (B := roots_of_positive (- h) a c H' A C ltac:(lra) A0).
  revert B; unfold discriminant_of; cbv zeta.
  replace (- h * - h) with (h * h) by ring.
  set (d := rnd (rnd (h * h - Rmax (hi (two_prod a c)) (lo (two_prod a c))) -
    Rmin (hi (two_prod a c)) (lo (two_prod a c)))).
  set (R := sqrt (h * h - a * c)); intros B M; destruct (B M) as (P1 & P2 & B1 & B2).
  replace (h + -1 * rnd (sqrt d)) with (- (- h + rnd (sqrt d))) by ring; rewrite minus_rnd.
  replace (h + -1 * R) with (- (- h + R)) by ring.
  set (s := rnd (- h + rnd (sqrt d))) in *; set (S := - h + R) in *.
  replace (- s / a) with (- (s / a)) by (field; lra).
  replace (- S / a) with (- (S / a)) by (field; lra).
  replace (c / - s) with (- (c / s)) by (field; lra).
  replace (c / - S) with (- (c / S)) by (field; lra).
  split; apply minus_close; assumption.
Qed.

(* The two that they are close to are the roots. *)
Theorem they_are_the_roots h a c sg : a <> 0 -> sg = 1 \/ sg = - 1 -> 0 <= sg * h ->
  0 < h * h - a * c -> let S := h + sg * sqrt (h * h - a * c) in
  forall x, a * x * x - 2 * h * x + c = a * (x - S / a) * (x - c / S).
Proof.
intros A0 Sg Hh P S x; set (R := sqrt (h * h - a * c)) in *.
assert (R2 : R * R = h * h - a * c) by (apply sqrt_sqrt; lra).
assert (RP : 0 < R) by (apply sqrt_lt_R0, P).
assert (S0 : S <> 0) by (unfold S; destruct Sg as [-> | ->]; lra).
assert (E : S * S = 2 * h * S - a * c).
{ unfold S; replace ((h + sg * R) * (h + sg * R)) with (h * h + 2 * sg * h * R + sg * sg * (R * R))
    by ring; rewrite R2; destruct Sg as [-> | ->]; ring. }
assert (E2 : S + a * c / S = 2 * h).
{ apply (Rmult_eq_reg_r S); [| exact S0].
  replace ((S + a * c / S) * S) with (S * S + a * c) by (field; exact S0); lra. }
replace (a * (x - S / a) * (x - c / S)) with (a * x * x - (S + a * c / S) * x + c)
  by (field; split; assumption).
rewrite E2; ring.
Qed.
