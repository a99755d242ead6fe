(* SPDX-License-Identifier: MIT *)
(* with: exact.v *)
(* Double-double sums of exact.h in binary64, and what fine_c makes of them: gradual underflow
   included, as no sum of doubles underflows; overflow excluded. *)
From Coq Require Import ZArith Reals Psatz Lia.
From Flocq Require Import Core Relative Sterbenz Plus_error.
From Brink Require Import exact.
Open Scope R_scope.

Notation ulp := (ulp radix2 exponent).
Notation u := (/ 9007199254740992). (* 2^-53 *)

Definition total (x : dd) := hi x + lo x.
(* What two_sum and fast_two_sum leave: hi is the sum, rounded. *)
Definition is_dd x := is_double (hi x) /\ is_double (lo x) /\ Rabs (lo x) <= / 2 * ulp (hi x).

Lemma half_ulp x : Rabs (rnd x - x) <= / 2 * ulp x.
Proof. apply error_le_half_ulp; auto with typeclass_instances. Qed.

Lemma half_ulp_of_rounded x : Rabs (rnd x - x) <= / 2 * ulp (rnd x).
Proof. apply error_le_half_ulp_round; auto with typeclass_instances. Qed.

Lemma two_sum_is_dd a b : is_double a -> is_double b -> is_dd (two_sum a b) /\
  total (two_sum a b) = a + b.
Proof.
intros A B; assert (E := two_sum_is_exact a b A B); split; [| exact E].
split; [apply rnd_is_double |]; split; [apply rnd_is_double |].
replace (lo (two_sum a b)) with (- (rnd (a + b) - (a + b)))
  by (change (rnd (a + b)) with (hi (two_sum a b)); lra).
rewrite Rabs_Ropp; apply half_ulp_of_rounded.
Qed.

Lemma fast_two_sum_is_dd a b : is_double a -> is_double b -> Rabs b <= Rabs a \/ a = 0 ->
  is_dd (fast_two_sum a b) /\ total (fast_two_sum a b) = a + b.
Proof.
intros A B L; assert (E := fast_two_sum_is_exact a b A B L); split; [| exact E].
split; [apply rnd_is_double |]; split; [apply rnd_is_double |].
replace (lo (fast_two_sum a b)) with (- (rnd (a + b) - (a + b)))
  by (change (rnd (a + b)) with (hi (fast_two_sum a b)); lra).
rewrite Rabs_Ropp; apply half_ulp_of_rounded.
Qed.

Lemma ulp_below x k : Rabs x < pow k -> ulp x <= pow (Z.max (k - 53) emin).
Proof.
intro X; destruct (Req_dec x 0) as [-> | N].
- rewrite ulp_FLT_small; [apply bpow_le; lia | easy |].
  rewrite Rabs_R0; apply bpow_gt_0.
- rewrite ulp_neq_0 by exact N; apply bpow_le; unfold cexp, FLT_exp, prec.
  assert (mag radix2 x <= k)%Z by (apply mag_le_bpow; assumption); lia.
Qed.

Lemma sum_relative a b : is_double a -> is_double b ->
  Rabs (rnd (a + b) - (a + b)) <= u * Rabs (a + b).
Proof.
intros A B; destruct (FLT_plus_error_N_ex radix2 emin prec (fun x => negb (Z.even x)) a b A B)
  as (eps & Small & ->).
replace ((a + b) * (1 + eps) - (a + b)) with (eps * (a + b)) by ring; rewrite Rabs_mult.
apply Rmult_le_compat_r; [apply Rabs_pos |]; apply Rle_trans with (1 := Small).
unfold u_ro; simpl; lra.
Qed.

(* Up to 2^k a number is rounded by at most half the last place below. *)
Lemma up_to_power x k : (emin <= k - 53)%Z -> Rabs x <= pow k -> Rabs (rnd x - x) <= pow (k - 54).
Proof.
intros K [L | E].
- assert (U := ulp_below x k L); rewrite Z.max_l in U by lia; assert (H := half_ulp x).
  replace (k - 53)%Z with (1 + (k - 54))%Z in U by lia; rewrite bpow_plus in U.
  simpl (pow 1) in U; lra.
- assert (F : is_double x).
  { assert (P : is_double (pow k))
      by (apply generic_format_bpow; unfold FLT_exp, prec, emin in *; lia).
    revert E; unfold Rabs; destruct Rcase_abs; intro E; [| rewrite E; exact P].
    replace x with (- pow k) by lra; apply generic_format_opp, P. }
  rewrite (rnd_of_double _ F), Rminus_diag_eq, Rabs_R0 by reflexivity; apply bpow_ge_0.
Qed.

(* fast_two_sum where b is larger, but has not more than 53 bits from a's last one on. *)
Lemma fast_two_sum_of_multiples m n g : (Z.abs m <= Z.abs n)%Z -> (Z.abs n <= 2 ^ 53 - 1)%Z ->
  (emin <= g)%Z -> let a := IZR m * pow g in let b := IZR n * pow g in
  is_double a -> is_double b -> hi (fast_two_sum a b) + lo (fast_two_sum a b) = a + b.
Proof.
intros M N G a b A B; cbn [fast_two_sum hi lo]; unfold plus, minus.
assert (Few : forall k, (Z.abs k <= 2 ^ 53)%Z -> is_double (IZR k * pow g)) by
  (intros; apply few_bits; assumption).
assert (S : a + b = IZR (m + n) * pow g) by (unfold a, b; rewrite plus_IZR; ring).
destruct (Z_le_gt_dec (Z.abs (m + n)) (2 ^ 53)) as [Small | Large].
{ assert (D : is_double (a + b)) by (rewrite S; apply Few, Small).
  rewrite (rnd_of_double _ D); replace (a + b - a) with b by ring.
  rewrite (rnd_of_double b B), Rminus_diag_eq, round_0 by auto with typeclass_instances; ring. }
(* the sum is rounded to an even one, and what is left has few bits *)
set (l := (m + n)%Z) in *; assert (Pg := bpow_gt_0 radix2 g).
assert (L : Rabs (a + b) = IZR (Z.abs l) * pow g).
{ rewrite S, Rabs_mult, (Rabs_pos_eq (pow g)), <- abs_IZR by lra; reflexivity. }
assert (Up : Rabs (a + b) < pow (54 + g)).
{ rewrite L, bpow_plus; apply Rmult_lt_compat_r; [lra |].
  change (pow 54) with (IZR (2 ^ 54)); apply IZR_lt; lia. }
assert (Down : pow (53 + g) <= Rabs (a + b)).
{ rewrite L, bpow_plus; apply Rmult_le_compat_r; [lra |].
  change (pow 53) with (IZR (2 ^ 53)); apply IZR_le; lia. }
assert (C : cexp radix2 exponent (a + b) = (1 + g)%Z).
{ unfold cexp, FLT_exp; rewrite (mag_unique radix2 (a + b) (54 + g)); [unfold prec; lia |].
  replace (54 + g - 1)%Z with (53 + g)%Z by lia; split; assumption. }
assert (N0 : a + b <> 0).
{ intro Z; rewrite Z, Rabs_R0 in Down; generalize (bpow_gt_0 radix2 (53 + g)); lra. }
assert (H := half_ulp (a + b)); rewrite ulp_neq_0, C, bpow_plus in H by exact N0.
simpl (pow 1) in H.
assert (E : exists k, rnd (a + b) = IZR k * pow g).
{ exists (ZnearestE (scaled_mantissa radix2 exponent (a + b)) * 2)%Z.
  unfold round, F2R; cbn [Fnum Fexp]; rewrite C, mult_IZR, bpow_plus; change (pow 1) with 2; ring. }
destruct E as [k E]; rewrite E, S, <- Rmult_minus_distr_r, Rabs_mult, (Rabs_pos_eq (pow g)),
  <- minus_IZR, <- abs_IZR in H by lra.
assert (K : (Z.abs (k - l) <= 1)%Z).
{ apply le_IZR, (Rmult_le_reg_r (pow g)); lra. }
rewrite E; replace (IZR k * pow g - a) with (IZR (k - m) * pow g)
  by (unfold a; rewrite minus_IZR; ring).
rewrite (rnd_of_double (IZR (k - m) * _)) by (apply Few; unfold l in K; lia).
replace (b - IZR (k - m) * pow g) with (IZR (n - (k - m)) * pow g)
  by (unfold b; rewrite !minus_IZR; ring).
rewrite (rnd_of_double (IZR (n - (k - m)) * _)) by (apply Few; unfold l in K; lia).
rewrite S; unfold l; rewrite !minus_IZR, !plus_IZR; ring.
Qed.

(* Where it is exact fast_two_sum leaves what two_sum does. *)
Lemma as_two_sum a b : is_double a -> is_double b ->
  hi (fast_two_sum a b) + lo (fast_two_sum a b) = a + b -> fast_two_sum a b = two_sum a b.
Proof.
intros A B E; assert (F := two_sum_is_exact a b A B).
assert (H : hi (fast_two_sum a b) = hi (two_sum a b)) by reflexivity.
assert (L : lo (fast_two_sum a b) = lo (two_sum a b)) by lra.
destruct (fast_two_sum a b), (two_sum a b); cbn in H, L; subst; reflexivity.
Qed.

Lemma two_sum_swaps a b : is_double a -> is_double b -> two_sum a b = two_sum b a.
Proof.
intros A B; assert (E := two_sum_is_exact a b A B); assert (F := two_sum_is_exact b a B A).
assert (H : hi (two_sum a b) = hi (two_sum b a))
  by (cbn; unfold plus; rewrite Rplus_comm; reflexivity).
assert (L : lo (two_sum a b) = lo (two_sum b a)) by lra.
destruct (two_sum a b), (two_sum b a); cbn in H, L; subst; reflexivity.
Qed.

Definition dd_add_d (x : dd) (y : R) :=
  let s := two_sum (hi x) y in fast_two_sum (hi s) (plus (lo x) (lo s)).

(* Where two doubles do not cancel, their sum is as large as half of either; where they do, it is
   exact, and some halves of a last place. *)
Lemma cancels_or_not a b : is_double a -> is_double b -> Rabs a <= 2 * Rabs (a + b) \/
  (is_double (a + b) /\ exists m, a + b = IZR m * (/ 2 * ulp a)).
Proof.
intros A B; destruct (Rle_or_lt (Rabs a) (2 * Rabs (a + b))) as [L | L]; [left; exact L | right].
assert (Lb : / 2 * Rabs a <= Rabs b <= 2 * Rabs a).
{ revert L; unfold Rabs; repeat destruct Rcase_abs; lra. }
assert (NB : is_double (- b)) by (apply generic_format_opp, B).
split.
- replace (a + b) with (a - - b) by ring; destruct (Rle_or_lt 0 a) as [P | N].
  + apply sterbenz; auto with typeclass_instances.
    revert L; rewrite (Rabs_pos_eq a) by exact P; unfold Rabs; destruct Rcase_abs; intro; lra.
  + replace (a - - b) with (- (- a - b)) by ring; apply generic_format_opp.
    apply sterbenz; auto with typeclass_instances; [apply generic_format_opp, A |].
    revert L; rewrite (Rabs_left a) by exact N; unfold Rabs; destruct Rcase_abs; intro; lra.
- assert (A0 : a <> 0) by (intros ->; rewrite Rabs_R0 in L; generalize (Rabs_pos (0 + b)); lra).
  rewrite ulp_neq_0 by exact A0; set (k := (cexp radix2 exponent a - 1)%Z).
  assert (E : / 2 * pow (cexp radix2 exponent a) = pow k).
  { unfold k, Zminus; rewrite bpow_plus; simpl (pow (- (1))); lra. }
  rewrite E; unfold generic_format, F2R in A, B; cbn [Fnum Fexp] in A, B.
  assert (Kb : (k <= cexp radix2 exponent b)%Z).
  { unfold k, cexp, FLT_exp, prec.
    assert (mag radix2 a - 1 <= mag radix2 b)%Z; [| lia].
    apply mag_ge_bpow; apply Rle_trans with (2 := proj1 Lb).
    replace (mag radix2 a - 1 - 1)%Z with (-1 + (mag radix2 a - 1))%Z by lia; rewrite bpow_plus.
    assert (M := bpow_mag_le radix2 a A0); simpl (pow (-1)); lra. }
  set (m := Ztrunc (scaled_mantissa radix2 exponent a)) in *.
  set (n := Ztrunc (scaled_mantissa radix2 exponent b)) in *.
  exists (m * 2 + n * 2 ^ (cexp radix2 exponent b - k))%Z.
  rewrite plus_IZR, !mult_IZR, (IZR_Zpower radix2) by lia.
  transitivity (IZR m * pow (cexp radix2 exponent a) + IZR n * pow (cexp radix2 exponent b));
    [f_equal; assumption |].
  rewrite Rmult_plus_distr_r; f_equal.
  + replace (cexp radix2 exponent a) with (1 + k)%Z by (unfold k; lia).
    rewrite bpow_plus; change (pow 1) with 2; ring.
  + rewrite Rmult_assoc, <- bpow_plus; do 2 f_equal; lia.
Qed.

(* Some of anything are none, or no less than one. *)
Lemma some_of m x : 0 <= x -> IZR m * x = 0 \/ x <= Rabs (IZR m * x).
Proof.
intro P; destruct (Z.eq_dec m 0) as [-> | N]; [left; ring | right].
rewrite Rabs_mult, (Rabs_pos_eq x P), <- abs_IZR, <- (Rmult_1_l x) at 1.
apply Rmult_le_compat_r; [exact P | apply (IZR_le 1); lia].
Qed.

Lemma sum_is_exact a b : is_double a -> is_double b -> Rabs (a + b) <= pow (prec + emin) ->
  rnd (a + b) = a + b.
Proof.
intros A B S; apply rnd_of_double, FLT_format_plus_small; auto with typeclass_instances.
Qed.

(* A sum that is not 0 is no less than the least double. *)
Lemma sum_is_no_less a b : is_double a -> is_double b -> a + b <> 0 -> pow emin <= Rabs (a + b).
Proof.
intros A B N; destruct (Rle_or_lt (pow emin) (Rabs (a + b))) as [L | L]; [exact L |].
exfalso; assert (E : rnd (a + b) = a + b).
{ apply sum_is_exact; try assumption; apply Rlt_le, Rlt_le_trans with (1 := L), bpow_le; easy. }
assert (G := generic_format_ge_bpow radix2 exponent emin).
assert (pow emin <= Rabs (a + b)); [| lra].
apply G.
- intro e; unfold FLT_exp; lia.
- apply Rabs_pos_lt, N.
- apply generic_format_abs; rewrite <- E; apply rnd_is_double.
Qed.

(* dd_add_d: the one rounding that is not made good, of what is below 3u of the sum, and 2u^2. *)
Theorem dd_add_d_is_close x y : is_dd x -> is_double y -> is_dd (dd_add_d x y) /\
  Rabs (total (dd_add_d x y) - (total x + y)) <= 2 * u * u * Rabs (hi x + y).
Proof.
intros (H & L & N) Y; unfold dd_add_d.
destruct (two_sum_is_dd (hi x) y H Y) as [(Sh & Sl & Sn) E]; unfold total in E.
assert (Hs : hi (two_sum (hi x) y) = rnd (hi x + y)) by reflexivity.
assert (Hl : Rabs (lo (two_sum (hi x) y)) <= / 2 * ulp (hi x + y)).
{ replace (lo (two_sum (hi x) y)) with (- (rnd (hi x + y) - (hi x + y))) by lra.
  rewrite Rabs_Ropp; apply half_ulp. }
set (s := two_sum (hi x) y) in *; set (v := plus (lo x) (lo s)).
assert (V : is_double v) by apply rnd_is_double.
enough (K : (Rabs v <= Rabs (hi s) \/ hi s = 0) /\
  Rabs (v - (lo x + lo s)) <= 2 * u * u * Rabs (hi x + y)).
{ destruct (fast_two_sum_is_dd (hi s) v Sh V (proj1 K)) as [D T]; split; [exact D |].
  rewrite T; unfold total; replace (hi s + v - (hi x + lo x + y)) with (v - (lo x + lo s)) by lra.
  exact (proj2 K). }
assert (Zp := Rabs_pos (hi x + y)).
destruct (cancels_or_not (hi x) y H Y) as [Big | [Ex (m & Least)]].
2: { (* the sum is exact, and so is what is left *)
  assert (Lo : lo s = 0) by (rewrite Hs, rnd_of_double in E by exact Ex; lra).
  assert (Hv : v = lo x) by (unfold v, plus; rewrite Lo, Rplus_0_r; apply rnd_of_double, L).
  split; [| rewrite Hv, Lo, Rplus_0_r, Rminus_diag_eq, Rabs_R0 by reflexivity; lra].
  rewrite Hs, rnd_of_double, Hv by exact Ex; assert (U := ulp_ge_0 radix2 exponent (hi x)).
  destruct (some_of m (/ 2 * ulp (hi x)) ltac:(lra)); rewrite <- Least in *; [right | left]; lra. }
set (z := hi x + y) in *; set (t := lo x + lo s) in *.
destruct (Req_dec z 0) as [Z | Z].
{ assert (X0 : ulp (hi x) = pow emin).
  { apply ulp_FLT_small; [easy |].
    apply Rle_lt_trans with (1 := Big); rewrite Z, Rabs_R0, Rmult_0_r; apply bpow_gt_0. }
  assert (Lo : lo s = 0).
  { rewrite Hs, Z, round_0 in E by auto with typeclass_instances; lra. }
  assert (Hv : v = lo x) by (unfold v, plus; rewrite Lo, Rplus_0_r; apply rnd_of_double, L).
  split; [right; rewrite Hs, Z; apply round_0; auto with typeclass_instances |].
  unfold t; rewrite Hv, Lo, Rplus_0_r, Rminus_diag_eq, Rabs_R0 by reflexivity; lra. }
set (e := mag radix2 z : BinNums.Z).
assert (M1 := bpow_mag_le radix2 z Z); assert (M2 := bpow_mag_gt radix2 z); fold e in M1, M2.
assert (U1 := ulp_below z e M2).
assert (U2 := ulp_below (hi x) (e + 1) ltac:(rewrite bpow_plus; simpl (pow 1); lra)).
assert (T : Rabs t <= / 2 * ulp (hi x) + / 2 * ulp z).
{ unfold t; apply Rle_trans with (1 := Rabs_triang _ _); lra. }
destruct (Z_le_gt_dec emin (e - 53)) as [Normal | Low].
- rewrite Z.max_l in U1, U2 by lia.
  replace (e + 1 - 53)%Z with (1 + (e - 53))%Z in U2 by lia; rewrite bpow_plus in U2.
  simpl (pow 1) in U2; assert (P := bpow_gt_0 radix2 (e - 53)).
  assert (T2 : Rabs t < pow (e - 52)).
  { replace (e - 52)%Z with (1 + (e - 53))%Z by lia; rewrite bpow_plus; simpl (pow 1); lra. }
  split.
  + left; apply Rle_trans with (pow (e - 1)).
    * apply abs_round_le_generic; auto with typeclass_instances.
      -- apply generic_format_bpow; unfold FLT_exp, emin, prec in *; lia.
      -- apply Rlt_le, Rlt_le_trans with (1 := T2), bpow_le; lia.
    * rewrite Hs; apply abs_round_ge_generic; auto with typeclass_instances.
      apply generic_format_bpow; unfold FLT_exp, emin, prec in *; lia.
  + destruct (Z_le_gt_dec emin (e - 105)) as [Far | Near].
    * apply Rle_trans with (/ 2 * ulp t); [apply half_ulp |].
      assert (U3 := ulp_below t (e - 52) T2); rewrite Z.max_l in U3 by lia.
      replace (e - 52 - 53)%Z with (-104 + (e - 1))%Z in U3 by lia; rewrite bpow_plus in U3.
      assert (pow (-104) = 4 * u * u) by (simpl; lra).
      rewrite H0 in U3; lra.
    * assert (v = t) as ->.
      { apply sum_is_exact; try assumption.
        apply Rlt_le, Rlt_le_trans with (1 := T2), bpow_le; unfold prec; lia. }
      rewrite Rminus_diag_eq, Rabs_R0 by reflexivity; lra.
- rewrite Z.max_r in U1, U2 by lia.
  assert (T2 : Rabs t <= pow emin) by lra.
  assert (v = t) as ->.
  { apply sum_is_exact; try assumption; apply Rle_trans with (1 := T2), bpow_le; easy. }
  split; [left | rewrite Rminus_diag_eq, Rabs_R0 by reflexivity; lra].
  apply Rle_trans with (1 := T2); rewrite Hs.
  apply abs_round_ge_generic; auto with typeclass_instances.
  + apply generic_format_bpow; unfold FLT_exp, emin, prec in *; lia.
  + apply sum_is_no_less; assumption.
Qed.

(* hi is no less than half of a double-double. *)
Lemma leading x : is_dd x -> Rabs (hi x) <= 2 * Rabs (total x).
Proof.
intros (H & L & N); unfold total; destruct (Req_dec (hi x) 0) as [Z | Z].
- rewrite Z, Rabs_R0; generalize (Rabs_pos (0 + lo x)); lra.
- assert (U := ulp_le_abs radix2 exponent (hi x) Z H).
  assert (T := Rabs_triang_inv (hi x) (- lo x)); rewrite Rabs_Ropp in T.
  replace (hi x - - lo x) with (hi x + lo x) in T by ring; lra.
Qed.

(* One more part: what is summed is off by F of S, and at most 1.01 times it in size. *)
Lemma one_more x y X S F : is_dd x -> is_double y -> Rabs (total x - X) <= F -> Rabs X <= S ->
  F <= S / 100 -> is_dd (dd_add_d x y) /\
  Rabs (total (dd_add_d x y) - (X + y)) <= F + 5 * u * u * (S + Rabs y) /\
  Rabs (X + y) <= S + Rabs y.
Proof.
intros D Y E B Le; destruct (dd_add_d_is_close x y D Y) as [G H]; split; [exact G |].
assert (L := leading x D); assert (A := Rabs_triang (hi x) y); assert (C := Rabs_triang X y).
assert (T : Rabs (total x) <= 101 / 100 * S).
{ replace (total x) with (total x - X + X) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _); lra. }
split; [| lra].
replace (total (dd_add_d x y) - (X + y)) with
  (total (dd_add_d x y) - (total x + y) + (total x - X)) by ring.
apply Rle_trans with (1 := Rabs_triang _ _).
assert (P1 := Rabs_pos y); assert (P2 := Rabs_pos X); lra.
Qed.

(* event_time_sums.h, fine_c: the parts of c summed, the largest at last: 2u^2 of c itself, and of
   the others, which are u smaller than R, 50u^2. *)
Definition fine_sum a b c d e f g h :=
  dd_add_d (dd_add_d (dd_add_d (dd_add_d (dd_add_d (dd_add_d (two_sum a b) c) d) e) f) g) h.

Theorem fine_sum_is_close a b c d e f g h : is_double a -> is_double b -> is_double c ->
  is_double d -> is_double e -> is_double f -> is_double g -> is_double h ->
  let L := Rabs a + Rabs b + Rabs c + Rabs d + Rabs e + Rabs f + Rabs g in
  let C := a + b + c + d + e + f + g + h in
  Rabs (total (fine_sum a b c d e f g h) - C) <= 2 * u * u * Rabs C + 50 * u * u * L.
Proof.
intros A B C D E F G H L Sum; unfold fine_sum.
destruct (two_sum_is_dd a b A B) as [D1 T1]; set (x1 := two_sum a b) in *.
generalize (Rabs_pos a) (Rabs_pos b) (Rabs_pos c) (Rabs_pos d) (Rabs_pos e) (Rabs_pos f)
  (Rabs_pos g); intros.
assert (E1 : Rabs (total x1 - (a + b)) <= 0) by (rewrite T1, Rminus_diag_eq, Rabs_R0; lra).
destruct (one_more x1 c _ _ _ D1 C E1 (Rabs_triang a b) ltac:(lra)) as (D2 & E2 & B2).
destruct (one_more _ d _ _ _ D2 D E2 B2 ltac:(lra)) as (D3 & E3 & B3).
destruct (one_more _ e _ _ _ D3 E E3 B3 ltac:(lra)) as (D4 & E4 & B4).
destruct (one_more _ f _ _ _ D4 F E4 B4 ltac:(lra)) as (D5 & E5 & B5).
destruct (one_more _ g _ _ _ D5 G E5 B5 ltac:(lra)) as (D6 & E6 & B6).
set (x6 := dd_add_d _ g) in *; fold L in B6.
set (X := a + b + c + d + e + f + g) in *.
assert (K : Rabs (total x6 - X) <= 26 * u * u * L) by (unfold L; lra); clear E1 E2 E3 E4 E5 E6.
assert (L0 : 0 <= L) by (unfold L; lra).
destruct (dd_add_d_is_close x6 h D6 H) as [_ Last].
assert (Hi := leading x6 D6).
assert (T6 : Rabs (total x6) <= 101 / 100 * L).
{ replace (total x6) with (total x6 - X + X) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _); lra. }
assert (Z : Rabs (hi x6 + h) <= Rabs Sum + 4 * L).
{ replace (hi x6 + h) with (Sum + (hi x6 - X)) by (unfold Sum, X; ring).
  apply Rle_trans with (1 := Rabs_triang _ _); apply Rplus_le_compat_l.
  apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; lra. }
replace (total (dd_add_d x6 h) - Sum) with
  (total (dd_add_d x6 h) - (total x6 + h) + (total x6 - X)) by (unfold Sum, X; ring).
apply Rle_trans with (1 := Rabs_triang _ _); lra.
Qed.
