(* SPDX-License-Identifier: MIT *)
(* with: exact.v quadratic.v quadratic_sum.v quadratic_roots.v *)
(* Whether there are roots, of any a, b, c, and what is made of those that are out of range
   (roots_rescued), which is within BRINK_QUADRATIC_ULP 3: gradual underflow included, overflow
   excluded. *)
From Coq Require Import ZArith Reals Psatz Lia.
From Flocq Require Import Core Relative.
From Brink Require Import exact quadratic quadratic_sum quadratic_roots.
Open Scope R_scope.

(* What is less than half of the least double is rounded to 0. *)
Lemma least_is_zero x : Rabs x <= pow (-1076) -> rnd x = 0.
Proof.
intro S; destruct (Req_dec (rnd x) 0) as [Z | N]; [exact Z | exfalso].
assert (G := generic_format_ge_bpow radix2 exponent emin ltac:(intro; unfold FLT_exp; lia)
  (Rabs (rnd x)) (Rabs_pos_lt _ N) (generic_format_abs _ _ _ (rnd_is_double x))).
assert (H := half_ulp x); rewrite ulp_FLT_small in H
  by (easy || (apply Rle_lt_trans with (1 := S), bpow_lt; easy)).
assert (pow emin = 4 * pow (-1076)).
{ replace emin with (2 + -1076)%Z by easy; rewrite bpow_plus; change (pow 2) with 4; ring. }
assert (P := bpow_gt_0 radix2 (-1076)).
assert (T := Rabs_triang (rnd x - x) x); replace (rnd x - x + x) with (rnd x) in T by ring; lra.
Qed.

(* is_rootless(): of any doubles at all, also where a c underflows and h, half of b, as well; where
   it says that there is no root there is none. *)
Definition half b := rnd (- / 2 * b).
Definition is_rootless h a c := rnd (h * h - hi (two_prod a c)) < lo (two_prod a c).

Theorem rootless_has_no_root a b c : is_double a -> is_double b -> is_double c ->
  is_rootless (half b) a c -> b * b / 4 < a * c.
Proof.
unfold is_rootless; set (h := half b); set (q := two_prod a c).
intros A B C Less; apply Rnot_le_lt; intro Le; apply (Rlt_irrefl (lo q)).
apply Rle_lt_trans with (2 := Less); clear Less.
assert (L : lo q = rnd (a * c - hi q)) by reflexivity.
assert (Sq : 0 <= h * h) by apply Rle_0_sqr.
destruct (Rle_or_lt (pow (-1022)) (Rabs (b * pow (-1)))) as [Normal | Small].
{ (* b / 2 is a double *)
  assert (H : is_double (b * pow (-1))) by (apply scaled_is_double; assumption).
  assert (E : h = - (b * pow (-1))).
  { unfold h, half; replace (- / 2 * b) with (- (b * pow (-1))) by (change (pow (-1)) with (/ 2); ring).
    apply rnd_of_double, generic_format_opp, H. }
  rewrite L; apply round_le; auto with typeclass_instances.
  rewrite E; change (pow (-1)) with (/ 2); lra. }
destruct (Rle_or_lt (a * c) 0) as [Neg | Pos].
- assert (P : hi q <= 0).
  { change (hi q) with (rnd (a * c)); rewrite <- (round_0 radix2 exponent ZnearestE).
    apply round_le; auto with typeclass_instances. }
  rewrite L; apply round_le; auto with typeclass_instances; lra.
- assert (T : Rabs (a * c) <= pow (-1076)).
  { rewrite Rabs_pos_eq by lra; apply Rle_trans with (1 := Le).
    replace (b * b / 4) with (b * pow (-1) * (b * pow (-1)))
      by (change (pow (-1)) with (/ 2); field).
    rewrite <- (Rabs_pos_eq (_ * _)) by apply Rle_0_sqr; rewrite Rabs_mult.
    apply Rle_trans with (pow (-1022) * pow (-1022)).
    - apply Rmult_le_compat; try apply Rabs_pos; lra.
    - rewrite <- bpow_plus; apply bpow_le; easy. }
  assert (Z : hi q = 0) by (apply least_is_zero, T).
  rewrite L, Z, !Rminus_0_r, (least_is_zero _ T), <- (round_0 radix2 exponent ZnearestE).
  apply round_le; auto with typeclass_instances.
Qed.

(* balance(): with x = y 2^unit and all of it divided by c's power of two the polynomial is the
   same, and a is of order 1 as c is. *)
Definition unit_of ea ec := Z.quot (ec - ea) 2.

Theorem balance_is_exact ma mb mc ea eb ec y :
  let unit := unit_of ea ec in let x := y * pow unit in
  ma * pow (ea + 2 * unit - ec) * y * y + mb * pow (eb + unit - ec) * y + mc =
    pow (- ec) * (ma * pow ea * x * x + mb * pow eb * x + mc * pow ec) /\
  (-1 <= ea + 2 * unit - ec <= 1)%Z.
Proof.
intros unit x; split.
- unfold x; replace (pow (- ec) * (ma * pow ea * (y * pow unit) * (y * pow unit) +
    mb * pow eb * (y * pow unit) + mc * pow ec)) with
    (ma * (pow ea * pow unit * pow unit * pow (- ec)) * y * y +
     mb * (pow eb * pow unit * pow (- ec)) * y + mc * (pow ec * pow (- ec))) by ring.
  rewrite <- !bpow_plus, Z.add_opp_diag_r; simpl (pow 0).
  replace (ea + unit + unit + - ec)%Z with (ea + 2 * unit - ec)%Z by lia.
  replace (eb + unit + - ec)%Z with (eb + unit - ec)%Z by lia; ring.
- unfold unit, unit_of; assert (E := Z.quot_rem' (ec - ea) 2).
  assert (B : (-2 < Z.rem (ec - ea) 2 < 2)%Z).
  { destruct (Z_le_gt_dec 0 (ec - ea)).
    - assert (H := Z.rem_bound_pos (ec - ea) 2 ltac:(lia) ltac:(lia)); lia.
    - assert (H := Z.rem_bound_pos_neg (ec - ea) 2 ltac:(lia) ltac:(lia)); lia. }
  lia.
Qed.

(* A double is some of the last places of what it is no less than. *)
Lemma in_places x e : is_double x -> (emin + 53 <= e)%Z -> pow e <= Rabs x ->
  exists n, x = IZR n * pow (e - 52).
Proof.
intros X E L; exists (Ztrunc (scaled_mantissa radix2 exponent x) *
  2 ^ (cexp radix2 exponent x - (e - 52)))%Z.
assert (N : x <> 0) by (intros ->; rewrite Rabs_R0 in L; generalize (bpow_gt_0 radix2 e); lra).
assert (C : (e - 52 <= cexp radix2 exponent x)%Z).
{ unfold cexp, FLT_exp, prec; assert (e + 1 <= mag radix2 x)%Z; [| lia].
  apply mag_ge_bpow; replace (e + 1 - 1)%Z with e by lia; exact L. }
rewrite mult_IZR, (IZR_Zpower radix2), Rmult_assoc, <- bpow_plus by lia.
replace (cexp radix2 exponent x - (e - 52) + (e - 52))%Z with (cexp radix2 exponent x) by lia.
exact X.
Qed.

(* Of what is balanced the discriminant's sign is the exact one's, and if it is not 0 it is in range
   (2^-109 and more), as `quadratic-roots` wants it. *)
Theorem balanced_discriminant h a c : is_double h -> is_double a -> is_double c ->
  / 2 <= Rabs a -> 1 <= Rabs c ->
  let d := discriminant_of h (two_prod a c) in
  (d < 0 <-> h * h < a * c) /\ (d = 0 <-> h * h = a * c) /\ (0 < d -> pow (-512) <= d).
Proof.
intros H A C La Lc d; set (q := two_prod a c) in *.
assert (Lac : / 2 <= Rabs (a * c)).
{ rewrite Rabs_mult; replace (/ 2) with (/ 2 * 1) by ring.
  apply Rmult_le_compat; lra. }
assert (W : pow (-960) <= / 2) by (change (/ 2) with (pow (-1)); apply bpow_le; easy).
assert (V : pow (-512) <= / 4) by (change (/ 4) with (pow (-2)); apply bpow_le; easy).
assert (Sq : 0 <= h * h) by apply Rle_0_sqr.
destruct (Rle_or_lt 0 (a * c)) as [Pos | Neg].
- rewrite Rabs_pos_eq in Lac by exact Pos; assert (L : pow (-960) <= a * c) by lra.
  assert (Lo := lo_is_small a c A C L); fold q in Lo; rewrite u_is_pow in Lo.
  assert (Pp := p_pos a c L); fold q in Pp; apply Rabs_le_inv in Lo.
  assert (E : d = discriminant h a c).
  { unfold d, discriminant_of, discriminant; fold q.
    rewrite Rmax_left, Rmin_right by lra; reflexivity. }
  destruct (discriminant_sign_is_exact h a c H A C L) as [S0 S1].
  assert (K := discriminant_within_3_halves_ulp h a c H A C L); rewrite <- E in *.
  split; [exact S0 |]; split; [exact S1 |]; intro Pd.
  (* h^2 - a c is some of 2^-108 *)
  assert (More : a * c < h * h).
  { destruct (Rtotal_order (h * h) (a * c)) as [T | [T | T]]; [| | exact T].
    - apply S0 in T; lra.
    - apply S1 in T; lra. }
  assert (Lh : / 4 <= Rabs h).
  { apply Rnot_lt_le; intro T; assert (h * h < / 4 * / 4); [| lra].
    rewrite <- (Rabs_pos_eq (h * h)) by exact Sq; rewrite Rabs_mult.
    apply Rmult_le_0_lt_compat; try apply Rabs_pos; exact T. }
  destruct (in_places a (-1) A ltac:(easy) La) as [m Em].
  destruct (in_places c 0 C ltac:(easy) Lc) as [n En].
  destruct (in_places h (-2) H ltac:(easy) Lh) as [k Ek].
  assert (D : h * h - a * c = IZR (k * k - m * n * 2 ^ 3) * pow (-108)).
  { assert (E1 : pow (-2 - 52) * pow (-2 - 52) = pow (-108))
      by (rewrite <- bpow_plus; reflexivity).
    assert (E2 : pow (-1 - 52) * pow (0 - 52) = pow 3 * pow (-108))
      by (rewrite <- !bpow_plus; reflexivity).
    rewrite minus_IZR, !mult_IZR; change (IZR (2 ^ 3)) with (pow 3).
    transitivity (IZR k * IZR k * (pow (-2 - 52) * pow (-2 - 52)) -
      IZR m * IZR n * (pow (-1 - 52) * pow (0 - 52))); [| rewrite E1, E2; ring].
    rewrite Em, En, Ek; ring. }
  assert (P := bpow_gt_0 radix2 (-108)).
  assert (One : pow (-108) <= h * h - a * c).
  { assert (I : (1 <= k * k - m * n * 2 ^ 3)%Z).
    { enough (0 < k * k - m * n * 2 ^ 3)%Z by lia.
      apply lt_IZR, (Rmult_lt_reg_r (pow (-108))); [exact P |]; rewrite <- D; lra. }
    apply IZR_le in I; rewrite D, <- (Rmult_1_l (pow (-108))) at 1.
    apply Rmult_le_compat_r; lra. }
  apply Rnot_lt_le; intro T.
  assert (U : ulp d <= pow (-512)).
  { apply Rle_trans with (ulp (pow (-512))).
    - apply ulp_le_pos; auto with typeclass_instances; lra.
    - rewrite ulp_bpow; apply bpow_le; easy. }
  assert (pow (-512) <= / 16 * pow (-108)).
  { change (/ 16) with (pow (-4)); rewrite <- bpow_plus; apply bpow_le; easy. }
  apply Rabs_le_inv in K; lra.
- rewrite Rabs_left in Lac by exact Neg.
  assert (Half : is_double (/ 2)) by (apply (generic_format_bpow radix2 exponent (-1)); easy).
  assert (Q : hi q <= - / 2).
  { change (hi q) with (rnd (a * c)); rewrite <- (rnd_of_double (- / 2))
      by (apply generic_format_opp, Half); apply round_le; auto with typeclass_instances; lra. }
  assert (E : hi q + lo q = a * c).
  { apply two_prod_is_exact; try assumption; right; rewrite Rabs_left by exact Neg.
    apply Rle_trans with (2 := Lac); change (/ 2) with (pow (-1)); apply bpow_le; easy. }
  assert (B : Rabs (hi q - a * c) <= u * Rabs (a * c)).
  { apply relative; rewrite Rabs_left by exact Neg; apply Rle_trans with (2 := Lac).
    change (/ 2) with (pow (-1)); apply bpow_le; easy. }
  rewrite (Rabs_left (a * c)) in B by exact Neg; apply Rabs_le_inv in B.
  assert (Pd : / 4 <= d).
  { unfold d, discriminant_of; rewrite Rmax_right, Rmin_left by lra.
    assert (Qt : is_double (/ 4)) by (apply (generic_format_bpow radix2 exponent (-2)); easy).
    apply round_ge_generic; auto with typeclass_instances.
    assert (F : hi q / 2 <= rnd (h * h - lo q)).
    { assert (Hq : is_double (hi q / 2)).
      { replace (hi q / 2) with (hi q * pow (-1)) by (change (pow (-1)) with (/ 2); field).
        apply scaled_is_double; [apply rnd_is_double |].
        rewrite Rabs_left by (change (pow (-1)) with (/ 2); lra).
        apply Rle_trans with (/ 4); [change (/ 4) with (pow (-2)); apply bpow_le; easy |].
        change (pow (-1)) with (/ 2); lra. }
      apply round_ge_generic; auto with typeclass_instances; lra. }
    lra. }
  repeat split; intro; lra.
Qed.

(* A root y that is scaled into the subnormal numbers is rounded once more there, and the bound
   holds all the same: of what it was off by before, and both roundings. *)
Lemma scaled_root q Y k : pow (-400) <= Rabs Y -> Rabs (q - Y) <= 26 / 10 * u * Rabs Y ->
  Rabs (rnd q - Y) <= 3 * ulp Y -> Rabs (rnd (rnd q * pow k) - Y * pow k) <= 3 * ulp (Y * pow k).
Proof.
intros L Near Three; assert (P := bpow_gt_0 radix2 k); assert (P4 := bpow_gt_0 radix2 (-400)).
assert (N : Y <> 0) by (intros ->; rewrite Rabs_R0 in L; lra).
destruct (Rle_or_lt (pow (-1022)) (Rabs (rnd q * pow k))) as [Normal | Small].
- rewrite rnd_of_double by (apply scaled_is_double; [apply rnd_is_double | exact Normal]).
  rewrite <- Rmult_minus_distr_r, Rabs_mult, (Rabs_pos_eq (pow k)) by lra.
  apply Rle_trans with (3 * ulp Y * pow k); [apply Rmult_le_compat_r; lra |].
  rewrite Rmult_assoc; apply Rmult_le_compat_l; [lra |].
  assert (M : (-399 <= mag radix2 Y)%Z) by (apply mag_ge_bpow; exact L).
  rewrite !ulp_neq_0; [| apply Rmult_integral_contrapositive_currified; lra | exact N].
  unfold cexp; rewrite mag_mult_bpow by exact N; rewrite <- bpow_plus; apply bpow_le.
  unfold FLT_exp, emin, prec; lia.
- assert (H := half_ulp (rnd q * pow k)); rewrite ulp_FLT_small in H
    by (easy || (apply Rlt_le_trans with (1 := Small), bpow_le; easy)).
  assert (U : pow emin <= ulp (Y * pow k)).
  { rewrite ulp_neq_0 by (apply Rmult_integral_contrapositive_currified; lra).
    apply bpow_le; unfold cexp, FLT_exp; lia. }
  assert (E : pow emin = 2 * u * pow (-1022)).
  { rewrite <- u_is_pow; change 2 with (pow 1); rewrite <- !bpow_plus; reflexivity. }
  assert (Q : Rabs (rnd q - q) <= u * Rabs q).
  { apply relative; assert (T := Rabs_triang_inv Y (Y - q)).
    replace (Y - (Y - q)) with q in T by ring; rewrite (Rabs_minus_sym Y q) in T.
    assert (pow (-1022) <= / 2 * pow (-400)).
    { change (/ 2) with (pow (-1)); rewrite <- bpow_plus; apply bpow_le; easy. }
    lra. }
  (* all of it in units of 2^-1022 *)
  rewrite Rabs_mult, (Rabs_pos_eq (pow k)) in Small by lra.
  assert (T1 : Rabs Y <= (1 + 4 * u) * Rabs (rnd q)).
  { revert Q Near; unfold Rabs; repeat destruct Rcase_abs; lra. }
  assert (T2 : Rabs (rnd q - Y) <= 365 / 100 * u * Rabs (rnd q)).
  { revert Q Near T1; unfold Rabs; repeat destruct Rcase_abs; lra. }
  assert (T3 : Rabs ((rnd q - Y) * pow k) <= 365 / 100 * u * pow (-1022)).
  { rewrite Rabs_mult, (Rabs_pos_eq (pow k)) by lra.
    apply Rle_trans with (365 / 100 * u * Rabs (rnd q) * pow k);
      [apply Rmult_le_compat_r; lra | lra]. }
  replace (rnd (rnd q * pow k) - Y * pow k) with
    (rnd (rnd q * pow k) - rnd q * pow k + (rnd q - Y) * pow k) by ring.
  assert (G := bpow_gt_0 radix2 (-1022)).
  apply Rle_trans with (1 := Rabs_triang _ _); lra.
Qed.

(* The sum of what is balanced, and its quotients, scaled. *)
Theorem rescued_roots_within_3_ulp h a c k : is_double h -> is_double a -> is_double c ->
  0 <= h <= pow 200 -> / 2 <= Rabs a < 4 -> 1 <= Rabs c < 2 ->
  let d := discriminant_of h (two_prod a c) in let S := h + sqrt (h * h - a * c) in
  let s := rnd (h + rnd (sqrt d)) in 0 <= d ->
  Rabs (rnd (rnd (s / a) * pow k) - S / a * pow k) <= 3 * ulp (S / a * pow k) /\
  Rabs (rnd (rnd (c / s) * pow k) - c / S * pow k) <= 3 * ulp (c / S * pow k).
Proof.
intros H A C Hh La Lc d S s Pd.
destruct (balanced_discriminant h a c H A C (proj1 La) (proj1 Lc)) as (_ & Zero & Range).
fold d in Zero, Range.
assert (A0 : a <> 0) by (intros ->; rewrite Rabs_R0 in La; lra).
assert (C0 : c <> 0) by (intros ->; rewrite Rabs_R0 in Lc; lra).
assert (Sum : 0 < s /\ pow (-301) <= S /\ Rabs (s - S) <= 251 / 100 * u * s /\
  Rabs (rnd (s / a) - S / a) <= 3 * ulp (S / a) /\ Rabs (rnd (c / s) - c / S) <= 3 * ulp (c / S)).
{ destruct Pd as [Pd | Z].
  - specialize (Range Pd).
    destruct (root_is_close h a c H A C (proj1 Hh) Range) as (X & RP & beta & Cl & Pt).
    fold d in X, Cl, Pt.
    destruct (sum_is_close h (sqrt d) _ beta (proj1 Hh) X RP Cl Pt) as [Up Down].
    fold s in Up, Down; fold S in Up, Down.
    assert (Ls := sum_is_large h (sqrt d) (proj1 Hh) X); fold s in Ls.
    assert (P3 := bpow_gt_0 radix2 (-300)).
    assert (Half : pow (-301) = / 2 * pow (-300)).
    { change (/ 2) with (pow (-1)); rewrite <- bpow_plus; reflexivity. }
    destruct (roots_of_positive h a c H A C (proj1 Hh) A0 Range) as (Q1 & Q2 & R1 & R2).
    fold S in Q2; repeat split; [lra | lra | | exact R1 | exact R2].
    apply Rabs_le; lra.
  - symmetry in Z; assert (E := proj1 Zero Z).
    assert (Es : s = h).
    { unfold s; rewrite Z, sqrt_0, round_0, Rplus_0_r by auto with typeclass_instances.
      apply rnd_of_double, H. }
    assert (ES : S = h) by (unfold S; rewrite E, Rminus_diag_eq, sqrt_0 by reflexivity; ring).
    assert (Lh : / 2 <= h).
    { apply square_le; [lra |]; rewrite E.
      assert (0 <= h * h) by apply Rle_0_sqr.
      rewrite <- (Rabs_pos_eq (a * c)) by lra; rewrite Rabs_mult.
      apply Rle_trans with (/ 2 * 1); [lra | apply Rmult_le_compat; lra]. }
    assert (T : forall x, Rabs (rnd x - x) <= 3 * ulp x).
    { intro x; assert (K := half_ulp x); assert (G := ulp_ge_0 radix2 exponent x); lra. }
    rewrite Es, ES; repeat split; [lra | | | apply T | apply T].
    + apply Rle_trans with (2 := Lh); change (/ 2) with (pow (-1)); apply bpow_le; easy.
    + rewrite Rminus_diag_eq, Rabs_R0 by reflexivity; lra. }
destruct Sum as (Ps & LS & Near & R1 & R2); assert (P3 := bpow_gt_0 radix2 (-301)).
assert (US : S <= pow 202).
{ assert (sqrt (h * h - a * c) <= pow 201).
  { apply square_le; [apply bpow_ge_0 |].
    assert (Hs : h * h <= pow 200 * pow 200) by (apply Rmult_le_compat; lra).
    assert (Ac : Rabs (a * c) <= 8).
    { rewrite Rabs_mult; apply Rle_trans with (4 * 2); [| lra].
      apply Rmult_le_compat; try apply Rabs_pos; lra. }
    assert (E : pow 201 * pow 201 = 4 * (pow 200 * pow 200)).
    { change 4 with (pow 2); rewrite <- !bpow_plus; reflexivity. }
    assert (B : 8 <= pow 200 * pow 200).
    { change 8 with (pow 3); rewrite <- bpow_plus; apply bpow_le; easy. }
    destruct (Rle_or_lt 0 (h * h - a * c)) as [G | G].
    - rewrite sqrt_sqrt by exact G; apply Rabs_le_inv in Ac; lra.
    - rewrite sqrt_neg_0 by lra; lra. }
  assert (E : pow 202 = 2 * pow 201) by (change 2 with (pow 1); rewrite <- bpow_plus; reflexivity).
  assert (E2 : pow 201 = 2 * pow 200) by (change 2 with (pow 1); rewrite <- bpow_plus; reflexivity).
  unfold S; lra. }
assert (Small : pow (-400) <= / 4 * pow (-301)).
{ change (/ 4) with (pow (-2)); rewrite <- bpow_plus; apply bpow_le; easy. }
split; apply scaled_root; try assumption.
- unfold Rdiv; rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq S) by lra.
  assert (I : / 4 <= / Rabs a) by (apply Rinv_le_contravar; lra).
  rewrite Rmult_comm; apply Rle_trans with (1 := Small); apply Rmult_le_compat; lra.
- unfold Rdiv; rewrite <- Rmult_minus_distr_r, !Rabs_mult, <- Rmult_assoc, (Rabs_pos_eq S) by lra.
  apply Rmult_le_compat_r; [apply Rabs_pos |]; apply Rabs_le_inv in Near; apply Rabs_le; lra.
- unfold Rdiv; rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq S) by lra.
  assert (I : / pow 202 <= / S) by (apply Rinv_le_contravar; lra).
  rewrite <- bpow_opp in I; change (- (202))%Z with (-202)%Z in I.
  assert (pow (-400) <= pow (-202)) by (apply bpow_le; easy).
  assert (G := bpow_gt_0 radix2 (-202)).
  apply Rle_trans with (1 * pow (-202)); [lra | apply Rmult_le_compat; lra].
- assert (E : c / s - c / S = c / S * ((S - s) / s)) by (field; lra).
  rewrite E, Rabs_mult, (Rmult_comm (_ * _)); apply Rmult_le_compat_l; [apply Rabs_pos |].
  unfold Rdiv; rewrite Rabs_mult, Rabs_inv, (Rabs_pos_eq s), Rabs_minus_sym by lra.
  apply (Rmult_le_reg_r s); [exact Ps |]; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra; lra.
Qed.
