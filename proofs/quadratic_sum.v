(* SPDX-License-Identifier: MIT *)
(* with: exact.v quadratic.v *)
(* For quadratic_roots.v: how far the sum s = h + sqrt(d) is off, and what its quotients are.  An
   ulp is that of the exact root.  Before the quotient is rounded a root is off by 2.5u, which are
   2.5 ulp at most, and the rounding adds half an ulp.  But where a power of two is between the
   root and the quotient it adds a whole one of the root's ulp: there, as the quotient is one of
   doubles and so not very near the power, the root is, within one ulp, and 2.5u are too many. *)
From Coq Require Import ZArith Reals Psatz Lia.
From Flocq Require Import Core Relative Mult_error.
From Brink Require Import exact quadratic.
Open Scope R_scope.

Notation u := (/ 9007199254740992). (* 2^-53 *)
Notation succ := (succ radix2 exponent).
Notation pred := (pred radix2 exponent).

Lemma u_is_pow : pow (-53) = u. Proof. simpl; lra. Qed.

Lemma half_ulp x : Rabs (rnd x - x) <= / 2 * ulp x.
Proof. apply error_le_half_ulp; auto with typeclass_instances. Qed.

Lemma relative x : pow (-1022) <= Rabs x -> Rabs (rnd x - x) <= u * Rabs x.
Proof.
intro N; assert (H := relative_error_N_FLT radix2 emin prec ltac:(easy)
  (fun n => negb (Z.even n)) x N).
replace (/ 2 * pow (- prec + 1)) with u in H by (simpl; lra); exact H.
Qed.

Lemma ulp_of_itself x : pow (-1022) <= Rabs x -> ulp x <= 2 * u * Rabs x.
Proof.
intro N; assert (H := ulp_FLT_le radix2 emin prec x N).
replace (pow (1 - prec)) with (2 * u) in H by (simpl; lra); lra.
Qed.

(* A double times a power of two, if it is not too small, is a double. *)
Lemma scaled_is_double x e : is_double x -> pow (-1022) <= Rabs (x * pow e) ->
  is_double (x * pow e).
Proof.
intros X N; apply generic_format_FLT_FLX; [exact N |].
apply mult_bpow_exact_FLX, generic_format_FLX_FLT with emin; exact X.
Qed.

(* --- The quotient ----------------------------------------------------------- *)

(* y = rnd (n / m) beside x > 0: where n / m is within 2.5u of x and, if a power of two parts
   them, x is either all but the power or n / m just the power. *)
Lemma quotient_is_close x q : 0 < x -> 0 < q ->
  q - x <= 5 / 2 * u * q -> x - q <= 5 / 2 * u * x ->
  (forall e, x < pow e <= q -> q = pow e \/ (1 - u) * pow e <= x) ->
  Rabs (rnd q - x) <= 3 * ulp x.
Proof.
intros X Q Up Down Across.
set (e := mag radix2 x : Z).
assert (E : pow (e - 1) <= x < pow e).
{ assert (H := bpow_mag_gt radix2 x); assert (L := bpow_mag_le radix2 x ltac:(lra)).
  rewrite Rabs_pos_eq in H, L by lra; split; assumption. }
assert (U : ulp x = pow (Z.max (e - 53) emin)) by (rewrite ulp_neq_0 by lra; reflexivity).
assert (Ue : u * pow e <= ulp x).
{ rewrite U, <- u_is_pow, <- bpow_plus; apply bpow_le; lia. }
assert (H := half_ulp q).
destruct (Rlt_or_le q (pow e)) as [Same | Above].
{ assert (ulp q <= ulp x).
  { rewrite U, ulp_neq_0 by lra; apply bpow_le; unfold cexp, FLT_exp, prec.
    assert (mag radix2 q <= e)%Z; [| lia].
    apply mag_le_bpow; [lra | rewrite Rabs_pos_eq; lra]. }
  apply Rabs_le_inv in H; apply Rabs_le; lra. }
assert (Q2 : q < pow (e + 1)) by (rewrite bpow_plus; simpl (pow 1); lra).
destruct (Z_lt_le_dec (e - 53) emin) as [Low | High].
{ assert (ulp q <= ulp x).
  { rewrite U, ulp_neq_0 by lra; apply bpow_le; unfold cexp, FLT_exp, prec.
    assert (mag radix2 q <= e + 1)%Z; [| lia].
    apply mag_le_bpow; [lra | rewrite Rabs_pos_eq; lra]. }
  assert (2 * u * pow e <= ulp x).
  { rewrite U, <- u_is_pow; change 2 with (pow 1); rewrite <- !bpow_plus.
    apply bpow_le; lia. }
  rewrite bpow_plus in Q2; simpl (pow 1) in Q2.
  apply Rabs_le_inv in H; apply Rabs_le; lra. }
assert (D : is_double (pow e)) by (apply generic_format_bpow; unfold FLT_exp, emin, prec in *; lia).
destruct (Across e (conj (proj2 E) Above)) as [-> | Near].
{ rewrite rnd_of_double by exact D; rewrite Rabs_pos_eq; lra. }
set (y := IZR (2 ^ 52 + 1) * pow (e - 52)).
assert (Ey : y = (1 + 2 * u) * pow e).
{ unfold y, Zminus; rewrite bpow_plus; replace (2 ^ 52 + 1)%Z with 4503599627370497%Z by easy.
  simpl (pow (- (52))); lra. }
assert (Y : is_double y) by (apply few_bits; [lia | unfold emin in *; lia]).
assert (rnd q <= y).
{ apply round_N_le_midp; auto with typeclass_instances.
  rewrite succ_eq_pos by (rewrite Ey; lra).
  assert (S : 2 * u * pow e <= ulp y).
  { rewrite ulp_neq_0 by lra; rewrite <- u_is_pow; change 2 with (pow 1).
    rewrite <- !bpow_plus; apply bpow_le; unfold cexp, FLT_exp, prec.
    assert (e + 1 <= mag radix2 y)%Z; [| lia].
    apply mag_ge_bpow; replace (e + 1 - 1)%Z with e by lia; rewrite Rabs_pos_eq; lra. }
  rewrite Ey in S |- *; lra. }
assert (pow e <= rnd q).
{ rewrite <- (rnd_of_double _ D); apply round_le; auto with typeclass_instances. }
apply Rabs_le; lra.
Qed.

(* --- The sum ---------------------------------------------------------------- *)

Lemma pred_above x : is_double x -> 0 < x -> x - pred x = ulp (pred x) /\ 0 <= pred x.
Proof.
intros X P; assert (0 <= pred x) by (apply pred_ge_0; auto with typeclass_instances).
assert (B := succ_pred radix2 exponent x X); rewrite succ_eq_pos in B by assumption.
split; lra.
Qed.

(* Rounded up it is off by no more than half the step below. *)
Lemma half_step_up x : 0 < rnd x -> rnd x - x <= / 2 * ulp (pred (rnd x)).
Proof.
intro P; assert (D := rnd_is_double x); destruct (pred_above _ D P) as [E _].
rewrite <- E; apply Rnot_lt_le; intro L.
assert (B := pred_lt_id radix2 exponent (rnd x) ltac:(lra)).
assert (rnd x <= pred (rnd x)); [| lra].
apply round_N_le_midp; auto with typeclass_instances.
- apply generic_format_pred; auto with typeclass_instances.
- rewrite succ_pred by auto with typeclass_instances; lra.
Qed.

Lemma half_step_down x : x - rnd x <= / 2 * ulp (rnd x).
Proof.
assert (H := error_le_half_ulp_round radix2 exponent (fun n => negb (Z.even n)) x).
apply Rabs_le_inv in H; lra.
Qed.

(* s = h + root, rounded, h >= 0 and root the rounded root of d: where that of d is off from R by
   beta S before, s is off by that and a step. *)
Section Sum.
Variables h x R beta : R. (* x = sqrt d *)
Hypotheses (Hh : 0 <= h) (Hx : pow (-300) <= x) (HR : 0 < R).
Let S := h + R.
Hypothesis (Close : Rabs (x - R) <= beta * S).
Let root := rnd x.
Let s := rnd (h + root).

Lemma root_is_large : pow (-300) <= root.
Proof.
apply round_ge_generic; auto with typeclass_instances.
apply generic_format_bpow; unfold FLT_exp, emin, prec; lia.
Qed.

Lemma root_below_sum : root <= s.
Proof.
rewrite <- (rnd_of_double root) by apply rnd_is_double.
apply round_le; auto with typeclass_instances; lra.
Qed.

Lemma sum_is_large : pow (-300) <= s.
Proof. apply Rle_trans with (1 := root_is_large), root_below_sum. Qed.

Lemma sum_up : s - S <= beta * S + ulp (pred s).
Proof.
assert (P := bpow_gt_0 radix2 (-300)); assert (L := root_is_large); assert (M := root_below_sum).
assert (A : s - (h + root) <= / 2 * ulp (pred s)) by (apply half_step_up; fold s; lra).
assert (B : root - x <= / 2 * ulp (pred root)) by (apply half_step_up; fold root; lra).
assert (C : ulp (pred root) <= ulp (pred s)).
{ apply ulp_le_pos; auto with typeclass_instances.
  - apply (pred_above root); [apply rnd_is_double | lra].
  - apply pred_le; auto with typeclass_instances; try apply rnd_is_double; exact M. }
apply Rabs_le_inv in Close; unfold S in *; lra.
Qed.

Lemma sum_down : S - s <= beta * S + ulp s.
Proof.
assert (P := bpow_gt_0 radix2 (-300)); assert (L := root_is_large); assert (M := root_below_sum).
assert (A := half_step_down (h + root)); fold s in A.
assert (B := half_step_down x); fold root in B.
assert (C : ulp root <= ulp s) by (apply ulp_le_pos; auto with typeclass_instances; lra).
apply Rabs_le_inv in Close; unfold S in *; lra.
Qed.

Lemma ulp_of_sum : ulp s <= 2 * u * s.
Proof.
assert (L := sum_is_large); assert (P := bpow_gt_0 radix2 (-300)).
assert (H := ulp_of_itself s); rewrite Rabs_pos_eq in H by lra; apply H.
apply Rle_trans with (2 := L), bpow_le; lia.
Qed.

(* By the sizes of its parts, so within 2.5u: where nothing cancels beta is u / 2, and where
   something does the root is less than 3/5 of the sum. *)
Hypothesis Parts : 0 <= beta <= / 2 * u * (1 + 12 / 5 * u) \/
  0 <= beta <= 4 / 5 * u /\ root <= 3 / 5 * s.

Lemma sum_is_close : s - S <= 5 / 2 * u * s /\ S - s <= 5 / 2 * u * S.
Proof.
assert (P := bpow_gt_0 radix2 (-300)); assert (L := sum_is_large).
assert (SP : 0 < S) by (unfold S; lra).
assert (Us := ulp_of_sum); assert (D := sum_down).
assert (Up := sum_up).
assert (ulp (pred s) <= ulp s).
{ apply ulp_le_pos; auto with typeclass_instances.
  - apply (pred_above s); [apply rnd_is_double | lra].
  - apply pred_le_id. }
destruct Parts as [[B0 B] | [[B0 B] Few]].
- assert (beta * S <= / 2 * u * (1 + 12 / 5 * u) * S) by (apply Rmult_le_compat_r; lra).
  split; [| lra].
  destruct (Rle_or_lt (s - S) (5 / 2 * u * S)); lra.
- assert (beta * S <= 4 / 5 * u * S) by (apply Rmult_le_compat_r; lra).
  assert (LR := root_is_large).
  assert (A := relative (h + root)); fold s in A.
  assert (pow (-1022) <= pow (-300)) by (apply bpow_le; lia).
  assert (C := relative x); fold root in C.
  rewrite Rabs_pos_eq in A, C by lra; specialize (A ltac:(lra)); specialize (C ltac:(lra)).
  apply Rabs_le_inv in A; apply Rabs_le_inv in C; apply Rabs_le_inv in Close.
  unfold S in *; split; lra.
Qed.

(* The quotients with a double c of either place beside a power of two. *)
Lemma below_pred m e : is_double m -> 0 < m -> s / 2 <= m * pow e < s -> m * pow e <= pred s.
Proof.
intros M Pm H; apply pred_ge_gt; auto with typeclass_instances; try apply rnd_is_double; [| lra].
apply scaled_is_double; [exact M |].
assert (L := sum_is_large); assert (P := bpow_gt_0 radix2 e).
rewrite Rabs_pos_eq by (apply Rmult_le_pos; lra).
apply Rle_trans with (pow (-1) * pow (-300)); [rewrite <- bpow_plus; apply bpow_le; lia |].
simpl (pow (-1)); lra.
Qed.

Lemma above_succ m e : is_double m -> 0 < m -> s < m * pow e -> s + ulp s <= m * pow e.
Proof.
intros M Pm H; assert (L := sum_is_large); assert (P := bpow_gt_0 radix2 (-300)).
rewrite <- succ_eq_pos by lra.
apply succ_le_lt; auto with typeclass_instances; try apply rnd_is_double.
apply scaled_is_double; [exact M |].
rewrite Rabs_pos_eq by lra.
apply Rle_trans with (2 := Rlt_le _ _ H), Rle_trans with (2 := L), bpow_le; lia.
Qed.

Lemma root_over a : is_double a -> 0 < a -> Rabs (rnd (s / a) - S / a) <= 3 * ulp (S / a).
Proof.
intros A Pa; assert (L := sum_is_large); assert (P := bpow_gt_0 radix2 (-300)).
assert (SP : 0 < S) by (unfold S; lra).
destruct sum_is_close as [Up Down]; assert (Step := sum_up).
assert (I : 0 < / a) by (apply Rinv_0_lt_compat, Pa).
apply quotient_is_close.
- apply Rdiv_lt_0_compat; lra.
- apply Rdiv_lt_0_compat; lra.
- unfold Rdiv at 1 2 4; rewrite <- Rmult_minus_distr_r, <- Rmult_assoc.
  apply Rmult_le_compat_r; lra.
- unfold Rdiv at 1 2 4; rewrite <- Rmult_minus_distr_r, <- Rmult_assoc.
  apply Rmult_le_compat_r; lra.
- intros e [B1 B2].
  assert (C1 : S < pow e * a) by (apply (Rmult_lt_reg_r (/ a)); [lra |];
    rewrite Rmult_assoc, Rinv_r, Rmult_1_r by lra; exact B1).
  assert (C2 : pow e * a <= s) by (apply (Rmult_le_reg_r (/ a)); [lra |];
    rewrite Rmult_assoc, Rinv_r, Rmult_1_r by lra; exact B2).
  destruct C2 as [C2 | <-]; [right | left; field; lra].
  assert (Q : a * pow e <= pred s) by (apply below_pred; try assumption; lra).
  destruct (pred_above s) as [E _]; [apply rnd_is_double | lra |].
  assert (beta * S <= u * S) by (apply Rmult_le_compat_r; lra).
  apply (Rmult_le_reg_r a); [exact Pa |].
  unfold Rdiv; rewrite (Rmult_assoc S), Rinv_l, Rmult_1_r by lra; lra.
Qed.

Lemma root_under c : is_double c -> 0 < c -> Rabs (rnd (c / s) - c / S) <= 3 * ulp (c / S).
Proof.
intros C Pc; assert (L := sum_is_large); assert (P := bpow_gt_0 radix2 (-300)).
assert (SP : 0 < S) by (unfold S; lra).
destruct sum_is_close as [Up Down]; assert (Step := sum_down).
assert (X : 0 < c / S) by (apply Rdiv_lt_0_compat; lra).
assert (Q : 0 < c / s) by (apply Rdiv_lt_0_compat; lra).
assert (K : 0 < c / (s * S)) by (apply Rdiv_lt_0_compat; [lra | apply Rmult_lt_0_compat; lra]).
assert (E1 : c / S = c / (s * S) * s) by (field; lra).
assert (E2 : c / s = c / (s * S) * S) by (field; lra).
apply quotient_is_close; try assumption.
- rewrite E1, E2; set (k := c / (s * S)) in *.
  replace (k * S - k * s) with (k * (S - s)) by ring.
  replace (5 / 2 * u * (k * S)) with (k * (5 / 2 * u * S)) by ring.
  apply Rmult_le_compat_l; lra.
- rewrite E1, E2; set (k := c / (s * S)) in *.
  replace (k * s - k * S) with (k * (s - S)) by ring.
  replace (5 / 2 * u * (k * s)) with (k * (5 / 2 * u * s)) by ring.
  apply Rmult_le_compat_l; lra.
- intros e [B1 B2].
  assert (Pe := bpow_gt_0 radix2 e).
  assert (C1 : c < pow e * S) by (apply (Rmult_lt_reg_r (/ S)); [apply Rinv_0_lt_compat; lra |];
    rewrite Rmult_assoc, Rinv_r, Rmult_1_r by lra; exact B1).
  assert (C2 : pow e * s <= c) by (apply (Rmult_le_reg_r (/ s)); [apply Rinv_0_lt_compat; lra |];
    rewrite Rmult_assoc, Rinv_r, Rmult_1_r by lra; exact B2).
  destruct C2 as [C2 | <-]; [right | left; field; lra].
  assert (Ee : pow (- e) * pow e = 1) by (rewrite <- bpow_plus; f_equal; simpl; 
    replace (- e + e)%Z with 0%Z by lia; reflexivity).
  assert (Pn := bpow_gt_0 radix2 (- e)).
  assert (M : s < c * pow (- e)).
  { apply (Rmult_lt_reg_r (pow e)); [exact Pe |].
    rewrite Rmult_assoc, Ee; lra. }
  assert (N := above_succ c (- e) C Pc M).
  assert (beta * S <= u * S) by (apply Rmult_le_compat_r; lra).
  assert ((1 - u) * S <= c * pow (- e)) by lra.
  apply (Rmult_le_reg_r S); [exact SP |].
  unfold Rdiv; rewrite (Rmult_assoc c), Rinv_l, Rmult_1_r by lra.
  replace c with (c * pow (- e) * pow e) by (rewrite Rmult_assoc, Ee; ring).
  replace ((1 - u) * pow e * S) with ((1 - u) * S * pow e) by ring.
  apply Rmult_le_compat_r; lra.
Qed.
End Sum.
