(* SPDX-License-Identifier: MIT *)
(* with: exact.v *)
(* The discriminant h^2 - a c of quadratic.c in binary64: its sign is exact,
   and it is off by at most 1.5 ulp where a c > 0 (Kahan's way; the bound is
   that of Jeannerod, Louvet, Muller 2013).  Where a c < 0 nothing cancels. *)
From Coq Require Import ZArith Reals Psatz Lia.
From Flocq Require Import Core Relative Plus_error.
From Brink Require Import exact.
Open Scope R_scope.

Notation ulp := (ulp radix2 exponent).

Section Product.
Variables h a c : R.
Hypotheses (H : is_double h) (A : is_double a) (C : is_double c).

Let q := two_prod a c.
Let p := hi q.
Let z := h * h - p.
Let f := rnd z. (* fma(h, h, -q.hi) *)

Section Positive.
Hypothesis Large : pow (-960) <= a * c.

Lemma p_is_double : is_double p.
Proof. apply rnd_is_double. Qed.

Lemma p_is_large : pow (-960) <= p.
Proof.
apply round_ge_generic; auto with typeclass_instances.
apply generic_format_bpow; unfold FLT_exp, emin, prec; lia.
Qed.

Lemma p_pos : 0 < p.
Proof. apply Rlt_le_trans with (2 := p_is_large), bpow_gt_0. Qed.

Lemma q_is_exact : p + lo q = a * c.
Proof.
apply two_prod_is_exact; try assumption; right.
rewrite Rabs_pos_eq; [|apply Rle_trans with (2 := Large), bpow_ge_0].
apply Rle_trans with (2 := Large), bpow_le; lia.
Qed.

Lemma lo_below_half_ulp : Rabs (lo q) <= / 2 * ulp p.
Proof.
replace (lo q) with (- (p - a * c)) by (pose proof q_is_exact; lra).
rewrite Rabs_Ropp; apply error_le_half_ulp_round; auto with typeclass_instances.
Qed.

Lemma ulp_below k : p < pow k -> (-1021 <= k)%Z -> ulp p <= pow (k - 53).
Proof.
intros P K; rewrite ulp_neq_0; [|pose proof p_pos; lra].
apply bpow_le; unfold cexp, FLT_exp, emin, prec.
assert (mag radix2 p <= k)%Z; [|lia].
apply mag_le_bpow; [pose proof p_pos; lra|].
rewrite Rabs_pos_eq; [exact P | pose proof p_pos; lra].
Qed.

Lemma lo_is_small : Rabs (lo q) <= pow (-53) * p.
Proof.
apply Rle_trans with (1 := lo_below_half_ulp).
assert (ulp p <= Rabs p * pow (1 - 53)) as U.
{ apply ulp_FLT_le; auto with typeclass_instances.
  rewrite Rabs_pos_eq by (pose proof p_pos; lra).
  apply Rle_trans with (2 := p_is_large), bpow_le; unfold emin, prec; lia. }
rewrite Rabs_pos_eq in U by (pose proof p_pos; lra).
simpl in U |- *; lra.
Qed.

(* Where h^2 is near p their difference has few bits, or is so large that lo is
   less than half of it. *)
Lemma near z' : z' = z -> Rabs z' <= pow (-51) * p ->
  exists k, (emin <= k)%Z /\ h * h <= (2 ^ 53 - 1) * (2 ^ 53 - 1) * pow k /\
            (is_double z' \/ (2 ^ 53 + 1) * pow k <= Rabs z').
Proof.
intros -> Near; pose proof p_is_large; pose proof p_pos.
destruct (taken_apart h H) as (m & e & Eh & M & E).
destruct (taken_apart p p_is_double) as (n & g & Ep & N & G).
assert (IZR (Z.abs m) <= 2 ^ 53 - 1) as Mr
  by (apply IZR_le in M; simpl in M |- *; lra).
assert (IZR (Z.abs n) <= 2 ^ 53 - 1) as Nr
  by (apply IZR_le in N; simpl in N |- *; lra).
assert (h * h = IZR m * IZR m * pow (e + e)) as Hh
  by (rewrite bpow_plus, Eh; ring).
pose proof (bpow_gt_0 radix2 (e + e)); pose proof (bpow_gt_0 radix2 g).
assert (h * h <= (2 ^ 53 - 1) * (2 ^ 53 - 1) * pow (e + e)) as Bound.
{ rewrite Hh; apply Rmult_le_compat_r; [lra|].
  rewrite <- (Rabs_pos_eq (IZR m * IZR m)) by nra.
  rewrite Rabs_mult, <- abs_IZR; apply Rmult_le_compat; try assumption;
    rewrite abs_IZR; apply Rabs_pos. }
assert (emin <= e + e)%Z as Low.
{ apply Rabs_le_inv in Near.
  assert (p / 2 <= h * h) by (unfold z in Near; simpl in Near; lra).
  apply Znot_lt_ge || apply Z.nlt_ge; intro L.
  assert (pow (e + e) <= pow (-1075)) as Le
    by (apply bpow_le; unfold emin in L; lia).
  assert (pow (-960) = pow 115 * pow (-1075)) as Split
    by (rewrite <- bpow_plus; reflexivity).
  pose proof (bpow_gt_0 radix2 (-1075)).
  simpl (pow 115) in Split; nra. }
exists (e + e)%Z; split; [exact Low|]; split; [exact Bound|].
destruct (Z_le_gt_dec g (e + e)) as [Less|More].
- (* a multiple of 2^g, and less than 4 of them *)
  left; assert (z = IZR (m * m * 2 ^ (e + e - g) - n) * pow g) as Ez.
  { unfold z; rewrite Hh, Ep, minus_IZR, !mult_IZR.
    rewrite (IZR_Zpower radix2) by lia.
    replace (pow (e + e)) with (pow (e + e - g) * pow g)
      by (rewrite <- bpow_plus; f_equal; lia); ring. }
  rewrite Ez; apply few_bits; [|exact G].
  apply le_IZR; rewrite abs_IZR.
  apply Rmult_le_reg_r with (pow g); [assumption|].
  rewrite <- (Rabs_pos_eq (pow g)) at 1 by lra.
  rewrite <- Rabs_mult, <- Ez; apply Rle_trans with (1 := Near).
  rewrite Ep; apply Rle_trans with (pow (-51) * (IZR (Z.abs n) * pow g)).
  + apply Rmult_le_compat_l; [apply bpow_ge_0|]; apply Rmult_le_compat_r; [lra|].
    rewrite abs_IZR; apply Rle_abs.
  + simpl (pow (-51)); nra.
- (* a multiple of 2^(2e) *)
  assert (z = IZR (m * m - n * 2 ^ (g - (e + e))) * pow (e + e)) as Ez.
  { unfold z; rewrite Hh, Ep, minus_IZR, !mult_IZR.
    rewrite (IZR_Zpower radix2) by lia.
    replace (pow g) with (pow (g - (e + e)) * pow (e + e))
      by (rewrite <- bpow_plus; f_equal; lia); ring. }
  set (w := (m * m - n * 2 ^ (g - (e + e)))%Z) in *.
  rewrite Ez; destruct (Z_le_gt_dec (Z.abs w) (2 ^ 53)) as [Few|Many].
  + left; apply few_bits; assumption.
  + right; rewrite Rabs_mult, (Rabs_pos_eq (pow (e + e))) by lra.
    apply Rmult_le_compat_r; [lra|]; rewrite <- abs_IZR.
    assert (2 ^ 53 + 1 <= Z.abs w)%Z as I by lia.
    apply IZR_le in I; simpl in I |- *; lra.
Qed.

(* h^2 - p is exact, or f so large beside lo that f - lo is in the binade next
   to f's at the lowest. *)
Lemma exact_or_large : is_double z \/ pow (mag radix2 f - 2) <= Rabs (f - lo q).
Proof.
pose proof p_pos as P; pose proof p_is_large as PL; pose proof lo_is_small as Lo.
assert (forall x, is_double x -> x <> 0 -> x <= Rabs z -> x <= Rabs f) as Mono.
{ intros x X _ Le; unfold f; apply abs_round_ge_generic;
    auto with typeclass_instances. }
assert (forall x, Rabs x <= Rabs f / 2 -> f <> 0 ->
        pow (mag radix2 f - 2) <= Rabs (f - x)) as Half.
{ intros x Le N; pose proof (bpow_mag_le radix2 f N) as B.
  replace (mag radix2 f - 2)%Z with (-1 + (mag radix2 f - 1))%Z by lia.
  rewrite bpow_plus; pose proof (Rabs_triang_inv f x); simpl (pow (-1)); lra. }
destruct (Rle_or_lt (Rabs z) (pow (-51) * p)) as [Near|Far].
- destruct (near z eq_refl Near) as (k & K & Bound & [Exact|Many]); [left;
    exact Exact|].
  right; pose proof (bpow_gt_0 radix2 k) as Kp.
  assert (pow (53 + k) <= Rabs f) as F1.
  { apply Mono; [|pose proof (bpow_gt_0 radix2 (53 + k)); lra|].
    - apply generic_format_bpow; unfold FLT_exp, emin, prec in *; lia.
    - rewrite bpow_plus; simpl (pow 53); simpl in Many; lra. }
  assert (f <> 0) as F0.
  { intro Z; rewrite Z, Rabs_R0 in F1; pose proof (bpow_gt_0 radix2 (53 + k));
      lra. }
  pose proof lo_below_half_ulp as LoU.
  destruct (Rlt_or_le p (pow (106 + k))) as [Below|Above].
  + apply Half; [|exact F0].
    pose proof (ulp_below (106 + k) Below ltac:(unfold emin in K; lia)) as U.
    replace (106 + k - 53)%Z with (53 + k)%Z in U by lia; lra.
  + assert (p < pow (107 + k)) as Below.
    { apply Rabs_le_inv in Near; unfold z in Near.
      rewrite bpow_plus; simpl (pow 107); simpl in Near, Bound; lra. }
    pose proof (ulp_below (107 + k) Below ltac:(unfold emin in K; lia)) as U.
    replace (107 + k - 53)%Z with (54 + k)%Z in U by lia.
    assert ((2 ^ 54 - 1) * pow k <= Rabs z) as Zl.
    { rewrite bpow_plus in Above; rewrite <- Rabs_Ropp.
      apply Rle_trans with (2 := Rle_abs _); unfold z.
      simpl (pow 106) in Above; simpl in Bound |- *; lra. }
    assert (IZR (2 ^ 53 - 1) * pow (1 + k) <= Rabs f) as F2.
    { assert (0 < pow (1 + k)) by apply bpow_gt_0.
      apply Mono.
      - apply few_bits; [lia | unfold emin in *; lia].
      - simpl (IZR _); nra.
      - rewrite bpow_plus; simpl (IZR _); simpl (pow 1); simpl in Zl; lra. }
    rewrite bpow_plus in U, F2; simpl (pow 54) in U; simpl (pow 1) in F2.
    simpl (IZR _) in F2.
    destruct (Rlt_or_le (Rabs f) (pow (54 + k))) as [In|Out].
    * assert (mag radix2 f <= 54 + k)%Z as Mag by (apply mag_le_bpow; assumption).
      apply Rle_trans with (pow (52 + k)); [apply bpow_le; lia|].
      pose proof (Rabs_triang_inv f (lo q)).
      rewrite bpow_plus; simpl (pow 52); lra.
    * apply Half; [|exact F0]; rewrite bpow_plus in Out; simpl (pow 54) in Out;
        lra.
- right; assert (Rabs (f - z) <= / 2 * pow (- (53) + 1) * Rabs z) as Rel.
  { apply relative_error_N_FLT; [easy|].
    apply Rle_trans with (pow (-51) * pow (-960)).
    - rewrite <- bpow_plus; apply bpow_le; unfold emin, prec; lia.
    - apply Rle_trans with (2 := Rlt_le _ _ Far); apply Rmult_le_compat_l;
        [apply bpow_ge_0 | exact PL]. }
  pose proof (Rabs_triang_inv z f) as T; rewrite Rabs_minus_sym in Rel.
  simpl (pow _) in Rel; simpl (pow _) in Far; simpl (pow _) in Lo.
  apply Half; [lra|].
  intro Z; rewrite Z, Rminus_0_r in Rel; lra.
Qed.

(* fma(h, h, -q.hi) compares with q.lo as h^2 does with a c. *)
Lemma compares_as_exact :
  (f < lo q <-> h * h < a * c) /\ (f = lo q <-> h * h = a * c).
Proof.
pose proof q_is_exact as E.
assert (is_double (lo q)) as L by apply rnd_is_double.
assert (z - lo q = h * h - a * c) as D by (unfold z; lra).
assert (z < lo q -> f <= lo q) as Down.
{ intro; rewrite <- (rnd_of_double _ L); apply round_le;
    auto with typeclass_instances; lra. }
assert (lo q < z -> lo q <= f) as Up.
{ intro; rewrite <- (rnd_of_double _ L); apply round_le;
    auto with typeclass_instances; lra. }
assert (z = lo q -> f = lo q) as Same
  by (intro Z; unfold f; rewrite Z; apply rnd_of_double, L).
assert (f = lo q -> z = lo q) as Equal.
{ intro F; destruct exact_or_large as [Exact|Large'].
  - rewrite <- F; symmetry; apply rnd_of_double, Exact.
  - rewrite F, Rminus_diag_eq, Rabs_R0 in Large' by reflexivity.
    pose proof (bpow_gt_0 radix2 (mag radix2 (lo q) - 2)); lra. }
assert (z < lo q -> f < lo q) as Below.
{ intro O; destruct (Down O) as [|Eq]; [assumption | specialize (Equal Eq);
    lra]. }
assert (lo q < z -> lo q < f) as Beyond.
{ intro O; destruct (Up O) as [|Eq]; [assumption|].
  symmetry in Eq; specialize (Equal Eq); lra. }
destruct (Rtotal_order z (lo q)) as [O|[O|O]];
  [specialize (Below O) | specialize (Same O) | specialize (Beyond O)];
  repeat split; intro; lra.
Qed.

(* discriminant_of() where a c > 0: larger(q.hi, q.lo) is q.hi. *)
Definition discriminant := rnd (f - lo q).

Lemma sign_is_exact : (discriminant < 0 <-> h * h < a * c) /\
  (discriminant = 0 <-> h * h = a * c).
Proof.
destruct compares_as_exact as [Less Same].
assert (is_double (lo q)) as L by apply rnd_is_double.
assert (is_double f) as F by apply rnd_is_double.
assert (f - lo q <> 0 -> discriminant <> 0) as Not.
{ apply round_plus_neq_0; auto with typeclass_instances;
    apply generic_format_opp, L. }
assert (f - lo q = 0 -> discriminant = 0) as Zero.
{ intro Z; unfold discriminant; rewrite Z; apply round_0;
    auto with typeclass_instances. }
assert (f - lo q <= 0 -> discriminant <= 0) as Down.
{ intro; rewrite <- (round_0 radix2 exponent ZnearestE); apply round_le;
    auto with typeclass_instances. }
assert (0 <= f - lo q -> 0 <= discriminant) as Up.
{ intro; rewrite <- (round_0 radix2 exponent ZnearestE); apply round_le;
    auto with typeclass_instances. }
destruct (Rtotal_order f (lo q)) as [O|[O|O]].
- pose proof (proj1 Less O); specialize (Not ltac:(lra));
    specialize (Down ltac:(lra)).
  split; split; intro; lra.
- pose proof (proj1 Same O); specialize (Zero ltac:(lra)); split; split; intro;
    lra.
- assert (a * c < h * h).
  { destruct (Rtotal_order (h * h) (a * c)) as [T|[T|T]]; [ | | exact T].
    - pose proof (proj2 Less T); lra.
    - pose proof (proj2 Same T); lra. }
  specialize (Not ltac:(lra)); specialize (Up ltac:(lra)); split; split; intro;
    lra.
Qed.

Lemma error_is_small :
  Rabs (discriminant - (h * h - a * c)) <= 3 / 2 * ulp discriminant.
Proof.
pose proof q_is_exact as E.
assert (is_double (lo q)) as L by apply rnd_is_double.
assert (is_double f) as F by apply rnd_is_double.
assert (Rabs (discriminant - (f - lo q)) <= / 2 * ulp discriminant) as Last
  by (apply error_le_half_ulp_round; auto with typeclass_instances).
assert (Rabs (f - z) <= / 2 * ulp f) as First
  by (apply error_le_half_ulp_round; auto with typeclass_instances).
replace (discriminant - (h * h - a * c))
  with ((discriminant - (f - lo q)) + (f - z))
  by (unfold z; lra).
apply Rle_trans with (1 := Rabs_triang _ _).
pose proof (ulp_ge_0 radix2 exponent discriminant).
destruct exact_or_large as [Exact|Far].
{ assert (f - z = 0) as -> by (unfold f; rewrite (rnd_of_double _ Exact); ring).
  rewrite Rabs_R0; lra. }
enough (ulp f <= 2 * ulp discriminant) by lra.
destruct (Req_dec f 0) as [Z|N].
{ rewrite Z; assert (ulp 0 <= ulp discriminant)
    by (apply ulp_ge_ulp_0; auto with typeclass_instances); lra. }
(* the discriminant's binade is f's, or the next one down, or higher *)
assert (discriminant <> 0) as D.
{ apply round_plus_neq_0; auto with typeclass_instances;
    [apply generic_format_opp, L|].
  intro Z; pose proof (bpow_gt_0 radix2 (mag radix2 f - 2)).
  unfold Rminus in Far; rewrite Z, Rabs_R0 in Far; lra. }
rewrite !ulp_neq_0 by assumption; change 2 with (pow 1) at 1;
  rewrite <- bpow_plus.
apply bpow_le; unfold cexp, FLT_exp.
destruct (Z_le_gt_dec (mag radix2 f - 53) emin) as [Low|High]; [unfold prec;
  lia|].
assert (mag radix2 f - 1 <= mag radix2 discriminant)%Z; [|unfold prec; lia].
apply mag_ge_bpow; apply abs_round_ge_generic; auto with typeclass_instances.
- apply generic_format_bpow; unfold FLT_exp, emin, prec in *; lia.
- replace (mag radix2 f - 1 - 1)%Z with (mag radix2 f - 2)%Z by lia; exact Far.
Qed.
End Positive.

(* is_rootless(): of any doubles, where a c is 0 or at least 2^-960, whatever
   h. *)
Theorem is_rootless_is_exact : a * c = 0 \/ pow (-960) <= Rabs (a * c) ->
  (f < lo q <-> h * h < a * c).
Proof.
intro Range; destruct (Rle_or_lt (a * c) 0) as [Neg|Pos].
- pose proof (Rle_0_sqr h) as Square; unfold Rsqr in Square.
  split; intro Less; [exfalso|lra].
  assert (p <= 0) as P.
  { unfold p, q; simpl; unfold mult;
      rewrite <- (round_0 radix2 exponent ZnearestE).
    apply round_le; auto with typeclass_instances. }
  assert (is_double (lo q)) as L by apply rnd_is_double.
  assert (is_double p) as D by apply rnd_is_double.
  assert (lo q <= - p) as Lo.
  { replace (lo q) with (rnd (a * c + - p)) by reflexivity.
    apply Rle_trans with (rnd (- p)).
    - apply round_le; auto with typeclass_instances; lra.
    - right; apply rnd_of_double, generic_format_opp, D. }
  assert (lo q <= f); [|lra].
  rewrite <- (rnd_of_double _ L); apply round_le; auto with typeclass_instances.
  unfold z; lra.
- apply compares_as_exact; destruct Range as [Z|Large]; [lra|].
  rewrite Rabs_pos_eq in Large by lra; exact Large.
Qed.

(* Kahan's discriminant where a c >= 2^-960: its sign is that of h^2 - a c, it
   is 0 only where that is 0, *)
Theorem discriminant_sign_is_exact : pow (-960) <= a * c ->
  (discriminant < 0 <-> h * h < a * c) /\ (discriminant = 0 <-> h * h = a * c).
Proof. exact sign_is_exact. Qed.

(* and it is off by no more than 1.5 ulp. *)
Theorem discriminant_within_3_halves_ulp : pow (-960) <= a * c ->
  Rabs (discriminant - (h * h - a * c)) <= 3 / 2 * ulp discriminant.
Proof. exact error_is_small. Qed.
End Product.
