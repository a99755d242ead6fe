(* SPDX-License-Identifier: MIT *)
(* with: exact.v exact_dd.v *)
(* dd_add of exact.h in binary64, Joldes, Muller and Popescu's accurate sum (2017): 3u^2 / (1 - 4u)
   of the sum, whatever cancels.  Gradual underflow included; overflow excluded. *)
From Coq Require Import ZArith Reals Psatz Lia.
From Flocq Require Import Core Relative Plus_error.
From Brink Require Import exact exact_dd.
Open Scope R_scope.

Definition dd_add (x y : dd) :=
  let s := two_sum (hi x) (hi y) in let t := two_sum (lo x) (lo y) in
  let v := fast_two_sum (hi s) (plus (lo s) (hi t)) in
  fast_two_sum (hi v) (plus (lo t) (lo v)).

Definition is_close x y := is_dd (dd_add x y) /\
  Rabs (total (dd_add x y) - (total x + total y)) * (1 - 4 * u) <=
    3 * u * u * Rabs (total x + total y).

Section Sum.
Variables x y : dd.
Hypotheses (X : is_dd x) (Y : is_dd y) (Order : Rabs (hi y) <= Rabs (hi x)).
Let z := hi x + hi y.
Let s := two_sum (hi x) (hi y).
Let t := two_sum (lo x) (lo y).
Let c := plus (lo s) (hi t).
Let v := fast_two_sum (hi s) c.
Let w := plus (lo t) (lo v).

Let Xh : is_double (hi x). Proof. apply X. Qed.
Let Xl : is_double (lo x). Proof. apply X. Qed.
Let Yh : is_double (hi y). Proof. apply Y. Qed.
Let Yl : is_double (lo y). Proof. apply Y. Qed.

Lemma s_sum : is_dd s /\ hi s + lo s = z. Proof. exact (two_sum_is_dd _ _ Xh Yh). Qed.
Lemma t_sum : is_dd t /\ hi t + lo t = lo x + lo y. Proof. exact (two_sum_is_dd _ _ Xl Yl). Qed.

(* All that is left to be said of a case: both fast_two_sums are exact, and what is lost. *)
Lemma finish e : hi v + lo v = hi s + c -> Rabs w <= Rabs (hi v) \/ hi v = 0 ->
  Rabs (c - (lo s + hi t)) + Rabs (w - (lo t + lo v)) <= e ->
  e * (1 - 4 * u) <= 3 * u * u * Rabs (total x + total y) -> is_close x y.
Proof.
intros V W E B; destruct s_sum as [_ S], t_sum as [_ T].
assert (Vd : is_double (hi v)) by apply rnd_is_double.
destruct (fast_two_sum_is_dd (hi v) w Vd (rnd_is_double _) W) as [D Sum].
change (fast_two_sum (hi v) w) with (dd_add x y) in D, Sum; split; [exact D |].
rewrite Sum; apply Rle_trans with (2 := B); apply Rmult_le_compat_r; [lra |].
apply Rle_trans with (2 := E); unfold total.
replace (hi v + w - (hi x + lo x + (hi y + lo y))) with (c - (lo s + hi t) + (w - (lo t + lo v)))
  by (unfold z in S; lra).
apply Rabs_triang.
Qed.

(* What is left of z is nothing: all that is lost is in w. *)
Lemma z_exact : is_double z -> hi s = z /\ lo s = 0 /\ c = hi t.
Proof.
intro Z; destruct s_sum as [_ S].
assert (H : hi s = z) by (change (hi s) with (rnd z); apply rnd_of_double, Z).
assert (L : lo s = 0) by lra; split; [exact H |]; split; [exact L |].
unfold c, plus; rewrite L, Rplus_0_l; apply rnd_of_double, rnd_is_double.
Qed.

Lemma v_lo : hi v + lo v = hi s + c -> Rabs (lo v) <= u * Rabs (hi v).
Proof.
intro E; unfold v in *; rewrite as_two_sum; try assumption; try apply rnd_is_double.
assert (H := sums_are_normalized (hi s) c ltac:(apply rnd_is_double) ltac:(apply rnd_is_double)).
replace (pow (-53)) with u in H by (simpl; lra); exact H.
Qed.

Lemma t_lo : Rabs (lo t) <= u * Rabs (hi t).
Proof.
assert (H := sums_are_normalized (lo x) (lo y) Xl Yl).
replace (pow (-53)) with u in H by (simpl; lra); exact H.
Qed.

(* Where one of the two is 0 nothing is lost. *)
Lemma nothing_lost : c = lo s + hi t -> hi v + lo v = hi s + c -> lo t = 0 \/ lo v = 0 ->
  Rabs (lo t) <= Rabs (hi v) \/ hi v = 0 -> is_close x y.
Proof.
intros C V Zero Small; assert (Lv := v_lo V).
assert (W : w = lo t + lo v).
{ unfold w, plus; destruct Zero as [-> | ->]; [rewrite Rplus_0_l | rewrite Rplus_0_r];
    apply rnd_of_double, rnd_is_double. }
apply (finish 0); [exact V | | |].
- rewrite W; destruct Small as [Small | Z]; [left | right; exact Z].
  assert (P := Rabs_pos (hi v)).
  destruct Zero as [-> | ->]; [rewrite Rplus_0_l; lra | rewrite Rplus_0_r; exact Small].
- rewrite W, C, !Rminus_diag_eq, !Rabs_R0 by reflexivity; lra.
- rewrite Rmult_0_l; generalize (Rabs_pos (total x + total y)); lra.
Qed.

(* Where z is exact, and no less than half of the last place of x. *)
Lemma close_where_exact : is_double z -> (exists m, z = IZR m * (/ 2 * ulp (hi x))) -> is_close x y.
Proof.
intros Z (m & M); destruct (z_exact Z) as (S & L & C); destruct t_sum as [(Th & Tl & Tn) T].
assert (P : 0 <= / 2 * ulp (hi x)) by (generalize (ulp_ge_0 radix2 exponent (hi x)); lra).
assert (D : is_double (ulp (hi x))) by (apply generic_format_ulp; auto with typeclass_instances).
(* the low parts are no more than one last place of x *)
assert (Low : Rabs (lo x + lo y) <= ulp (hi x)).
{ assert (ulp (hi y) <= ulp (hi x)) by (apply ulp_le; auto with typeclass_instances).
  apply Rle_trans with (1 := Rabs_triang _ _); destruct X as (_ & _ & X1), Y as (_ & _ & Y1); lra. }
assert (T2 : Rabs (hi t) <= ulp (hi x))
  by (apply abs_round_le_generic; auto with typeclass_instances).
assert (First : hi v + lo v = hi s + c /\ (lo v = 0 -> Rabs (lo t) <= Rabs (hi v) \/ hi v = 0)).
{ unfold v; rewrite S, C.
  assert (Size : ulp (hi x) = pow emin \/ hi x <> 0 /\ (emin < cexp radix2 exponent (hi x))%Z).
  { destruct (Req_dec (hi x) 0) as [-> | N].
    - left; apply ulp_FLT_small; [easy | rewrite Rabs_R0; apply bpow_gt_0].
    - destruct (Z_le_gt_dec (cexp radix2 exponent (hi x)) emin) as [Least | More].
      + left; rewrite ulp_neq_0 by exact N; f_equal.
        apply Z.le_antisymm; [exact Least | apply Z.le_max_r].
      + right; split; [exact N | lia]. }
  destruct Size as [U | [N More]].
  - (* as small as doubles can be *)
    assert (E : rnd (lo x + lo y) = lo x + lo y).
    { apply sum_is_exact; try assumption; apply Rle_trans with (1 := Low); rewrite U.
      apply bpow_le; easy. }
    change (rnd (lo x + lo y)) with (hi t) in E.
    replace (lo t) with 0 by lra; split; [| left; rewrite Rabs_R0; apply Rabs_pos].
    apply fast_two_sum_is_exact; try assumption.
    destruct (Req_dec z 0) as [Z0 | Z0]; [right; exact Z0 | left].
    apply Rle_trans with (1 := T2); rewrite U; apply sum_is_no_less; assumption.
  - set (k := (cexp radix2 exponent (hi x) - 1)%Z) in *.
    assert (U : ulp (hi x) = 2 * pow k).
    { rewrite ulp_neq_0 by exact N.
      replace (cexp radix2 exponent (hi x)) with (1 + k)%Z by (unfold k; lia).
      rewrite bpow_plus; reflexivity. }
    destruct (Req_dec (hi t) 0) as [T0 | T0].
    { assert (H := t_lo); rewrite T0, Rabs_R0, Rmult_0_r in H; rewrite T0.
      split; [| left; apply Rle_trans with (1 := H), Rabs_pos].
      apply fast_two_sum_is_exact; [exact Z | apply generic_format_0 |].
      left; rewrite Rabs_R0; apply Rabs_pos. }
    set (g := cexp radix2 exponent (hi t)).
    assert (G : (g <= k)%Z).
    { unfold g, cexp, FLT_exp; assert (mag radix2 (hi t) <= k + 2)%Z; [| unfold k, prec in *; lia].
      apply mag_le_bpow; [exact T0 |]; apply Rle_lt_trans with (1 := T2); rewrite U.
      replace (k + 2)%Z with (2 + k)%Z by lia; rewrite bpow_plus; generalize (bpow_gt_0 radix2 k).
      simpl (pow 2); lra. }
    assert (Ge : (emin <= g)%Z) by (unfold g, cexp, FLT_exp; lia).
    assert (Hn : exists n, hi t = IZR n * pow g /\ (Z.abs n <= 2 ^ 53 - 1)%Z).
    { exists (Ztrunc (scaled_mantissa radix2 exponent (hi t))); split; [exact Th |].
      assert (F := scaled_mantissa_generic radix2 exponent (hi t) Th).
      assert (B := scaled_mantissa_lt_bpow radix2 exponent (hi t)); rewrite F, <- abs_IZR in B.
      assert (IZR (Z.abs (Ztrunc (scaled_mantissa radix2 exponent (hi t)))) < IZR (2 ^ 53)) as B2.
      { apply Rlt_le_trans with (1 := B); change (IZR (2 ^ 53)) with (pow 53); apply bpow_le.
        unfold cexp, FLT_exp, prec; lia. }
      apply lt_IZR in B2; lia. }
    destruct Hn as (n & En & N53).
    assert (Em : z = IZR (m * 2 ^ (k - g)) * pow g).
    { rewrite M, U, mult_IZR, (IZR_Zpower radix2), Rmult_assoc, <- bpow_plus by lia.
      f_equal; replace (k - g + g)%Z with k by lia; lra. }
    set (m' := (m * 2 ^ (k - g))%Z) in *.
    assert (Sum : hi (fast_two_sum z (hi t)) + lo (fast_two_sum z (hi t)) = z + hi t).
    { destruct (Z_le_gt_dec (Z.abs m') (Z.abs n)) as [Le | Gt].
      - rewrite Em, En; apply fast_two_sum_of_multiples; try assumption; [rewrite <- Em; exact Z |].
        rewrite <- En; exact Th.
      - apply fast_two_sum_is_exact; try assumption; left.
        rewrite Em, En, !Rabs_mult, <- !abs_IZR; apply Rmult_le_compat_r; [apply Rabs_pos |].
        apply IZR_le; lia. }
    split; [exact Sum |]; intro V0; rewrite V0, Rplus_0_r in Sum; rewrite Sum.
    assert (E : z + hi t = IZR (m' + n) * pow g) by (rewrite plus_IZR, Em, En; ring).
    destruct (some_of (m' + n) (pow g) (bpow_ge_0 _ _)) as [O | O]; rewrite <- E in O;
      [right; exact O | left].
    apply Rle_trans with (1 := Tn), Rle_trans with (2 := O).
    rewrite ulp_neq_0 by exact T0; fold g; generalize (bpow_gt_0 radix2 g); lra. }
destruct First as [V Rest]; assert (Vl := v_lo V).
assert (C0 : c = lo s + hi t) by (rewrite L, C; ring).
destruct (cancels_or_not (hi t) z Th Z) as [Big | [Ex _]].
2: { assert (V0 : lo v = 0).
  { assert (H : hi v = hi s + c).
    { change (hi v) with (rnd (hi s + c)); apply rnd_of_double.
      rewrite S, C, Rplus_comm; exact Ex. }
    lra. }
  apply nothing_lost; auto. }
assert (Tl' := t_lo); rewrite Rplus_comm in Big; rewrite S, C in V; rewrite <- V in Big.
assert (A := Rabs_triang (hi v) (lo v)); set (p := Rabs (hi v)) in *.
assert (W : Rabs (w - (lo t + lo v)) <= u * Rabs (lo t + lo v)).
{ apply sum_relative; [exact Tl | apply rnd_is_double]. }
assert (Q : Rabs (lo t + lo v) <= (3 * u + 2 * u * u) * p).
{ apply Rle_trans with (1 := Rabs_triang _ _); lra. }
assert (P0 : 0 <= p) by apply Rabs_pos.
apply (finish (u * ((3 * u + 2 * u * u) * p))).
- rewrite S, C; exact V.
- left; fold p; replace w with (w - (lo t + lo v) + (lo t + lo v)) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _); lra.
- replace (c - (lo s + hi t)) with 0 by lra; rewrite Rabs_R0; lra.
- assert (B : p - (3 * u + 2 * u * u) * p <= Rabs (total x + total y)).
  { replace (total x + total y) with (hi v - - (lo t + lo v)) by (unfold total, z in *; lra).
    assert (K := Rabs_triang_inv (hi v) (- (lo t + lo v))); rewrite Rabs_Ropp in K.
    fold p in K; lra. }
  lra.
Qed.

(* Where they do not cancel. *)
Lemma close_otherwise : z <> 0 -> Rabs (hi x) <= 2 * Rabs z -> is_close x y.
Proof.
intros Z0 Big; destruct s_sum as [(Sh & Sl & _) S], t_sum as [(Th & Tl & Tn) T].
assert (Yz : Rabs (hi y) <= Rabs z).
{ revert Order Big; unfold z, Rabs; repeat destruct Rcase_abs; lra. }
set (e := mag radix2 z : BinNums.Z).
assert (M1 := bpow_mag_le radix2 z Z0); assert (M2 := bpow_mag_gt radix2 z); fold e in M1, M2.
assert (Uz := ulp_below z e M2).
assert (Ux := ulp_below (hi x) (e + 1) ltac:(rewrite bpow_plus; simpl (pow 1); lra)).
assert (Uy := ulp_below (hi y) e ltac:(lra)).
assert (X1 := proj2 (proj2 X)); assert (Y1 := proj2 (proj2 Y)).
assert (S1 : Rabs (lo s) <= / 2 * ulp z).
{ replace (lo s) with (- (rnd z - z)) by (change (rnd z) with (hi s); lra).
  rewrite Rabs_Ropp; apply half_ulp. }
assert (Tt := Rabs_triang (lo x) (lo y)).
assert (Ct := Rabs_triang (lo s) (hi t)).
destruct (Z_le_gt_dec (emin + 106) e) as [Normal | Low].
2: { (* sums of doubles as small as these are exact *)
  assert (F : pow (Z.max (e + 1 - 53) emin) <= pow (prec + emin))
    by (apply bpow_le; unfold prec, emin in *; lia).
  assert (F2 : 2 * pow (Z.max (e - 53) emin) <= pow (prec + emin)).
  { change 2 with (pow 1); rewrite <- bpow_plus; apply bpow_le; unfold prec, emin in *; lia. }
  assert (P := bpow_gt_0 radix2 (prec + emin)).
  assert (T1 : rnd (lo x + lo y) = lo x + lo y).
  { apply sum_is_exact; try assumption; lra. }
  change (rnd (lo x + lo y)) with (hi t) in T1.
  assert (T0 : lo t = 0) by lra.
  assert (C1 : rnd (lo s + hi t) = lo s + hi t).
  { apply sum_is_exact; try assumption; rewrite T1 in Ct |- *; lra. }
  change (rnd (lo s + hi t)) with c in C1.
  assert (V : hi v + lo v = hi s + c).
  { apply fast_two_sum_is_exact; try assumption; [apply rnd_is_double | left].
    rewrite C1, T1; rewrite T1 in Ct.
    destruct (Z_le_gt_dec emin (e - 53)) as [N | N].
    - rewrite Z.max_l in Uz, Ux, Uy by lia.
      apply Rle_trans with (pow (e - 1)).
      + replace (e + 1 - 53)%Z with (-51 + (e - 1))%Z in Ux by lia.
        replace (e - 53)%Z with (-52 + (e - 1))%Z in Uz, Uy by lia.
        rewrite bpow_plus in Ux, Uy, Uz; generalize (bpow_gt_0 radix2 (e - 1)).
        simpl (pow (-51)) in Ux; simpl (pow (-52)) in Uy, Uz; lra.
      + apply abs_round_ge_generic; auto with typeclass_instances.
        apply generic_format_bpow; unfold FLT_exp, emin, prec in *; lia.
    - rewrite Z.max_r in Uz, Ux, Uy by lia.
      assert (Zx : rnd z = z).
      { apply sum_is_exact; try assumption.
        apply Rlt_le, Rlt_le_trans with (1 := M2), bpow_le; unfold prec; lia. }
      change (rnd z) with (hi s) in Zx; assert (lo s = 0) as -> by lra.
      rewrite Zx, Rplus_0_l; apply Rle_trans with (pow emin); [lra |].
      apply sum_is_no_less; assumption. }
  apply nothing_lost; auto; rewrite T0, Rabs_R0; left; apply Rabs_pos. }
set (a := pow (e - 54)); assert (A0 : 0 < a) by apply bpow_gt_0.
assert (Pw : forall n, pow (e - 54 + n) = a * pow n) by (intro; apply bpow_plus).
rewrite !Z.max_l in Uz, Ux, Uy by (unfold emin in *; lia).
replace (e - 53)%Z with (e - 54 + 1)%Z in Uz, Uy by lia.
replace (e + 1 - 53)%Z with (e - 54 + 2)%Z in Ux by lia.
rewrite Pw in Uz, Uy, Ux; simpl (pow 1) in *; simpl (pow 2) in *.
replace (e - 1)%Z with (e - 54 + 53)%Z in M1 by lia; rewrite Pw in M1; simpl (pow 53) in M1.
assert (L3 : Rabs (lo x + lo y) <= 3 * a) by lra.
assert (Th3 : Rabs (hi t) <= 3 * a).
{ apply abs_round_le_generic; auto with typeclass_instances.
  apply (few_bits 3); unfold emin in *; lia. }
assert (R2 : forall r, Rabs r <= 2 * a -> Rabs (rnd r - r) <= u * a).
{ intros r Hr; replace (u * a) with (pow (e - 53 - 54)).
  - apply up_to_power; [unfold emin in *; lia |].
    replace (e - 53)%Z with (e - 54 + 1)%Z by lia; rewrite Pw; simpl (pow 1); lra.
  - replace (e - 53 - 54)%Z with (e - 54 + -53)%Z by lia; rewrite Pw; simpl (pow (-53)); lra. }
assert (R4 : forall r, Rabs r <= 4 * a -> Rabs (rnd r - r) <= 2 * u * a).
{ intros r Hr; replace (2 * u * a) with (pow (e - 52 - 54)).
  - apply up_to_power; [unfold emin in *; lia |].
    replace (e - 52)%Z with (e - 54 + 2)%Z by lia; rewrite Pw; simpl (pow 2); lra.
  - replace (e - 52 - 54)%Z with (e - 54 + -52)%Z by lia; rewrite Pw; simpl (pow (-52)); lra. }
assert (T1 : Rabs (lo t) <= 2 * u * a).
{ replace (lo t) with (- (rnd (lo x + lo y) - (lo x + lo y)))
    by (change (rnd (lo x + lo y)) with (hi t); lra).
  rewrite Rabs_Ropp; apply R4; lra. }
assert (D1 : Rabs (c - (lo s + hi t)) <= 2 * u * a) by (apply R4; lra).
assert (C4 : Rabs c <= 4 * a).
{ apply abs_round_le_generic; auto with typeclass_instances; [| lra].
  apply (few_bits 4); unfold emin in *; lia. }
assert (Sh1 : 9007199254740992 * a <= Rabs (hi s)).
{ apply abs_round_ge_generic; auto with typeclass_instances; [| fold z; lra].
  replace (9007199254740992 * a) with (pow (e - 54 + 53)) by (rewrite Pw; simpl (pow 53); lra).
  apply generic_format_bpow; unfold FLT_exp, emin, prec in *; lia. }
assert (Sh2 : Rabs (hi s) <= 18014398509481984 * a).
{ apply abs_round_le_generic; auto with typeclass_instances.
  - replace (18014398509481984 * a) with (pow (e - 54 + 54)) by (rewrite Pw; simpl (pow 54); lra).
    apply generic_format_bpow; unfold FLT_exp, emin, prec in *; lia.
  - fold z; replace e with (e - 54 + 54)%Z in M2 by lia; rewrite Pw in M2.
    simpl (pow 54) in M2; lra. }
assert (V : hi v + lo v = hi s + c).
{ apply fast_two_sum_is_exact; try apply rnd_is_double; left; lra. }
assert (Vl : lo v = - (rnd (hi s + c) - (hi s + c))) by (change (rnd (hi s + c)) with (hi v); lra).
assert (Va : Rabs (lo v) = Rabs (rnd (hi s + c) - (hi s + c))) by (rewrite Vl; apply Rabs_Ropp).
assert (Vh : 4503599627370496 * a <= Rabs (hi v)).
{ apply abs_round_ge_generic; auto with typeclass_instances.
  - replace (4503599627370496 * a) with (pow (e - 54 + 52)) by (rewrite Pw; simpl (pow 52); lra).
    apply generic_format_bpow; unfold FLT_exp, emin, prec in *; lia.
  - assert (K := Rabs_triang_inv (hi s) (- c)); rewrite Rabs_Ropp in K.
    replace (hi s - - c) with (hi s + c) in K by ring; lra. }
assert (Sum : total x + total y = z + (lo x + lo y)) by (unfold total, z; ring).
assert (W := Rabs_triang (lo t) (lo v)).
destruct (Rle_or_lt (Rabs (hi s + c)) (18014398509481984 * a)) as [In | Out].
- assert (Vs : Rabs (lo v) <= a).
  { rewrite Va; replace a with (pow (e - 54 + 54 - 54)) by (unfold a; f_equal; lia).
    apply up_to_power; [unfold emin in *; lia |]; rewrite Pw; simpl (pow 54); lra. }
  assert (D2 : Rabs (w - (lo t + lo v)) <= u * a) by (apply R2; lra).
  apply (finish (3 * u * a)); [exact V | left | lra |].
  + replace w with (w - (lo t + lo v) + (lo t + lo v)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _); lra.
  + rewrite Sum; assert (K := Rabs_triang_inv z (- (lo x + lo y))); rewrite Rabs_Ropp in K.
    replace (z - - (lo x + lo y)) with (z + (lo x + lo y)) in K by ring; lra.
- assert (Vs : Rabs (lo v) <= 2 * a).
  { rewrite Va; replace (2 * a) with (pow (e - 54 + 55 - 54))
      by (replace (e - 54 + 55 - 54)%Z with (e - 54 + 1)%Z by lia; rewrite Pw; simpl (pow 1); lra).
    apply up_to_power; [unfold emin in *; lia |]; rewrite Pw; simpl (pow 55).
    apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  assert (D2 : Rabs (w - (lo t + lo v)) <= 2 * u * a) by (apply R4; lra).
  apply (finish (4 * u * a)); [exact V | left | lra |].
  + replace w with (w - (lo t + lo v) + (lo t + lo v)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _); lra.
  + replace (total x + total y) with (hi s + c - (c - (lo s + hi t) - lo t))
      by (unfold total, z in *; lra).
    assert (K := Rabs_triang_inv (hi s + c) (c - (lo s + hi t) - lo t)).
    assert (K2 : Rabs (c - (lo s + hi t) - lo t) <= 4 * u * a).
    { apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; lra. }
    lra.
Qed.
End Sum.

Lemma dd_add_swaps x y : is_dd x -> is_dd y -> dd_add x y = dd_add y x.
Proof.
intros (A & B & _) (C & D & _); unfold dd_add.
rewrite (two_sum_swaps (hi x) (hi y) A C), (two_sum_swaps (lo x) (lo y) B D); reflexivity.
Qed.

(* Of any two double-doubles. *)
Theorem dd_add_is_close x y : is_dd x -> is_dd y -> is_dd (dd_add x y) /\
  Rabs (total (dd_add x y) - (total x + total y)) * (1 - 4 * u) <=
    3 * u * u * Rabs (total x + total y).
Proof.
assert (Ordered : forall x y, is_dd x -> is_dd y -> Rabs (hi y) <= Rabs (hi x) -> is_close x y).
{ intros a b A B O; destruct (Req_dec (hi a + hi b) 0) as [Z | Z].
  - apply close_where_exact; try assumption; [rewrite Z; apply generic_format_0 |].
    exists 0%Z; rewrite Z; ring.
  - destruct (cancels_or_not (hi a) (hi b) (proj1 A) (proj1 B)) as [Big | [Ex M]].
    + apply close_otherwise; assumption.
    + apply close_where_exact; assumption. }
intros X Y; destruct (Rle_or_lt (Rabs (hi y)) (Rabs (hi x))) as [O | O];
  [apply Ordered; assumption |].
rewrite (dd_add_swaps x y X Y), (Rplus_comm (total x)); apply Ordered; try assumption; lra.
Qed.
