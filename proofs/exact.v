(* SPDX-License-Identifier: MIT *)
(* Error-free transforms of exact.h in binary64, round to nearest even: the double
   format with gradual underflow and, above, no bound: overflow is excluded. *)
From Coq Require Import ZArith Reals Psatz Lia.
From Flocq Require Import Core Mult_error Plus_error Relative Pff2Flocq.
Open Scope R_scope.

Definition emin := (-1074)%Z.
Definition prec := 53%Z.
Global Instance prec_is_positive : Prec_gt_0 prec.
Proof. now red. Qed.

Notation exponent := (FLT_exp emin prec).
Notation rnd := (round radix2 exponent ZnearestE).
Notation is_double := (generic_format radix2 exponent).
Notation pow := (bpow radix2).

Definition plus x y := rnd (x + y).
Definition minus x y := rnd (x - y).
Definition mult x y := rnd (x * y).
Definition fma x y z := rnd (x * y + z).

Lemma rnd_is_double x : is_double (rnd x).
Proof. apply generic_format_round; auto with typeclass_instances. Qed.

Lemma rnd_of_double x : is_double x -> rnd x = x.
Proof. apply round_generic; auto with typeclass_instances. Qed.

Lemma to_even_is_odd x : negb (Z.even x) = negb (negb (Z.even (- (x + 1)))).
Proof. rewrite Z.even_opp, Z.even_add; simpl; destruct (Z.even x);
  reflexivity. Qed.

(* m 2^e is a double if m has no more than 53 bits, or is 2^53. *)
Lemma few_bits m e :
  (Z.abs m <= 2 ^ 53)%Z -> (emin <= e)%Z -> is_double (IZR m * pow e).
Proof.
intros M E.
destruct (Z.eq_dec (Z.abs m) (2 ^ 53)) as [T|T].
- assert (is_double (pow (53 + e))) as P
    by (apply generic_format_bpow; unfold FLT_exp, emin, prec in *; lia).
  assert (IZR m * pow e = pow (53 + e) \/ IZR m * pow e = - pow (53 + e))
    as [-> | ->].
  { rewrite bpow_plus; assert (m = 2 ^ 53 \/ m = - 2 ^ 53)%Z as [-> | ->] by lia;
      [left; change (2 ^ 53)%Z with 9007199254740992%Z
      | right; change (- 2 ^ 53)%Z with (-9007199254740992)%Z]; simpl (pow 53);
        lra. }
  + exact P.
  + apply generic_format_opp, P.
- apply generic_format_FLT; exists (Float radix2 m e); simpl; try easy.
  change (Z.pow_pos 2 53) with (2 ^ 53)%Z; lia.
Qed.

Lemma taken_apart x : is_double x ->
  exists m e, x = IZR m * pow e /\ (Z.abs m <= 2 ^ 53 - 1)%Z /\ (emin <= e)%Z.
Proof.
intro X; destruct (FLT_format_generic radix2 emin prec x X) as [[m e] E M L].
exists m, e; simpl in *; repeat split; try assumption.
change (Z.pow_pos 2 53) with (2 ^ 53)%Z in M; lia.
Qed.

(* --- two_sum, fast_two_sum, two_prod ---------------------------------------- *)

Record dd := Dd { hi : R; lo : R }.

Definition two_sum (a b : R) :=
  let s := plus a b in let t := minus s a in
  Dd s (plus (minus a (minus s t)) (minus b t)).

Definition fast_two_sum (a b : R) :=
  let s := plus a b in Dd s (minus b (minus s a)).

Definition two_prod (a b : R) :=
  let p := mult a b in Dd p (fma a b (- p)).

(* hi + lo = a + b, exactly: no condition on a and b, gradual underflow
   included. *)
Theorem two_sum_is_exact a b : is_double a -> is_double b ->
  hi (two_sum a b) + lo (two_sum a b) = a + b.
Proof.
intros A B.
apply (TwoSum_correct emin prec (fun x => negb (Z.even x))); try easy.
exact to_even_is_odd.
Qed.

(* The same with one step less, where |a| >= |b| or a = 0. *)
Theorem fast_two_sum_is_exact a b : is_double a -> is_double b ->
  Rabs b <= Rabs a \/ a = 0 ->
  hi (fast_two_sum a b) + lo (fast_two_sum a b) = a + b.
Proof.
intros A B [Larger | ->].
- rewrite <- (Fast2Sum_correct emin prec (fun x => negb (Z.even x)) ltac:(easy)
    ltac:(easy) to_even_is_odd a b A B Larger); simpl; f_equal.
  unfold minus, plus; f_equal; unfold Rminus; f_equal.
  rewrite <- round_NE_opp; f_equal; ring.
- simpl; unfold plus, minus; rewrite Rplus_0_l, Rminus_0_r.
  rewrite !(rnd_of_double b B), Rminus_eq_0, round_0;
    auto with typeclass_instances.
  ring.
Qed.

(* hi + lo = a b, exactly, where a b is 0 or so large that it has no bits below
   2^-1074: 2^-969 is enough. *)
Theorem two_prod_is_exact a b : is_double a -> is_double b ->
  a * b = 0 \/ pow (-969) <= Rabs (a * b) ->
  hi (two_prod a b) + lo (two_prod a b) = a * b.
Proof.
intros A B Large; simpl; unfold mult, fma.
rewrite (rnd_of_double (a * b + - rnd (a * b))); [ring|].
replace (a * b + - rnd (a * b)) with (- (rnd (a * b) - a * b)) by ring.
apply generic_format_opp, mult_error_FLT; auto with typeclass_instances.
intro N; destruct Large as [Z|Large]; [contradiction | exact Large].
Qed.

(* In all three lo is no more than half an ulp, u = 2^-53 of hi. *)
Theorem sums_are_normalized a b : is_double a -> is_double b ->
  Rabs (lo (two_sum a b)) <= pow (-53) * Rabs (hi (two_sum a b)).
Proof.
intros A B; pose proof (two_sum_is_exact a b A B) as E.
set (x := two_sum a b) in *.
assert (hi x = rnd (a + b)) as H by reflexivity.
destruct (FLT_plus_error_N_round_ex radix2 emin prec (fun x => negb (Z.even x))
  a b A B)
  as (eps & Small & S).
replace (lo x) with (hi x * eps) by (rewrite H; rewrite H in E; lra).
rewrite Rabs_mult, Rmult_comm; apply Rmult_le_compat_r; [apply Rabs_pos|].
apply Rle_trans with (1 := Small); unfold u_ro; simpl; lra.
Qed.

(* --- is_told ---------------------------------------------------------------- *)

Lemma told_by_more k t x : (1 <= k)%Z -> is_double (hi t) ->
  fma (lo t) (1 + pow (- k)) (hi t) = hi t ->
  Rabs (hi t + lo t - x) <= pow (- k) * Rabs (lo t) -> rnd x = hi t.
Proof.
intros K H Told Near; unfold fma in Told.
assert (0 <= pow (- k) <= 1 / 2) as Small.
{ split; [apply bpow_ge_0|]; apply Rle_trans with (pow (-1));
    [apply bpow_le; lia | simpl; lra]. }
apply Rabs_le_inv in Near; set (more := pow (- k)) in *.
(* x lies between hi and hi + lo (1 + 2^-k), which both round to hi. *)
apply Rle_antisym.
- destruct (Rle_or_lt 0 (lo t)).
  + rewrite <- Told; apply round_le; auto with typeclass_instances.
    rewrite Rabs_pos_eq in Near by assumption; lra.
  + rewrite <- (rnd_of_double _ H); apply round_le; auto with typeclass_instances.
    rewrite Rabs_left in Near by assumption; nra.
- destruct (Rle_or_lt 0 (lo t)).
  + rewrite <- (rnd_of_double _ H) at 1; apply round_le;
      auto with typeclass_instances.
    rewrite Rabs_pos_eq in Near by assumption; nra.
  + rewrite <- Told at 1; apply round_le; auto with typeclass_instances.
    rewrite Rabs_left in Near by assumption; lra.
Qed.

(* No midpoint is nearer to a double than 2^-54 of it, but for less than
   2^-106. *)
Lemma near_is_nearest_pos h x : is_double h -> 0 < h ->
  Rabs (x - h) <= (pow (-55) + pow (-70)) * h -> rnd x = h.
Proof.
intros H P Near; apply Rabs_le_inv in Near.
pose proof (ulp_FLT_gt radix2 emin prec h) as Up;
  rewrite Rabs_pos_eq in Up by lra.
pose proof (succ_pred radix2 exponent h H) as Back.
assert (0 <= pred radix2 exponent h) as P0
  by (apply pred_ge_0; auto with typeclass_instances).
rewrite succ_eq_pos in Back by exact P0.
pose proof (ulp_FLT_gt radix2 emin prec (pred radix2 exponent h)) as Down.
rewrite Rabs_pos_eq in Down by exact P0.
simpl in Near, Up, Down.
apply Rle_antisym.
- apply round_N_le_midp; auto with typeclass_instances.
  rewrite succ_eq_pos; lra.
- apply round_N_ge_midp; auto with typeclass_instances; lra.
Qed.

Lemma near_is_nearest h x : is_double h -> h <> 0 ->
  Rabs (x - h) <= (pow (-55) + pow (-70)) * Rabs h -> rnd x = h.
Proof.
intros H N Near; destruct (Rle_or_lt 0 h) as [P|P].
- rewrite (Rabs_pos_eq h P) in Near; apply near_is_nearest_pos; try assumption;
    lra.
- rewrite (Rabs_left h P) in Near.
  rewrite <- (Ropp_involutive x), round_NE_opp, <- (Ropp_involutive h); f_equal.
  apply near_is_nearest_pos; [apply generic_format_opp, H | lra |].
  rewrite <- Rabs_Ropp; replace (- (- x - - h)) with (x - h) by ring; exact Near.
Qed.

(* is_told(): hi stays what it is when lo is added to it a little larger than
   it is. Then hi is the double nearest to what hi + lo stands for, where that
   is known to 2^-70: of any magnitude, barring overflow. *)
Definition is_told (x : dd) := fma (lo x) (1 + pow (-15)) (hi x) = hi x.

Lemma told_by_k k t x : (15 <= k)%Z -> is_double (hi t) ->
  fma (lo t) (1 + pow (- k)) (hi t) = hi t ->
  Rabs (hi t + lo t - x) <= pow (- k - 55) * Rabs (hi t) -> rnd x = hi t.
Proof.
intros K H Told Near; pose proof (Rabs_pos (hi t)) as P.
destruct (Rle_or_lt (pow (-55) * Rabs (hi t)) (Rabs (lo t))) as [Large|Little].
- apply told_by_more with k; try assumption; [lia|].
  apply Rle_trans with (1 := Near); unfold Zminus; rewrite bpow_plus, Rmult_assoc.
  apply Rmult_le_compat_l; [apply bpow_ge_0 | exact Large].
- assert (pow (- k - 55) <= pow (-70)) by (apply bpow_le; lia).
  assert (pow (- k - 55) * Rabs (hi t) <= pow (-70) * Rabs (hi t))
    by (apply Rmult_le_compat_r; assumption).
  apply near_is_nearest; try assumption.
  + intro Z; rewrite Z, Rabs_R0, Rmult_0_r in Little;
      pose proof (Rabs_pos (lo t)); lra.
  + replace (x - hi t) with (lo t - (hi t + lo t - x)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; lra.
Qed.

Theorem told_is_nearest t x : is_double (hi t) -> is_told t ->
  Rabs (hi t + lo t - x) <= pow (-70) * Rabs (hi t) -> rnd x = hi t.
Proof. exact (told_by_k 15 t x ltac:(lia)). Qed.

(* lanes_are_told(), a lane of it: the same of x + y, |y| <= |x|, where it is
   known to 2^-75. *)
Definition is_told_in_lane (x y : R) := let h := plus x y in
  fma (minus y (minus h x)) (1 + pow (-20)) h = h.

Theorem told_in_lane_is_nearest x y z : is_double x -> is_double y ->
  Rabs y <= Rabs x -> is_told_in_lane x y ->
  Rabs (x + y - z) <= pow (-75) * Rabs (rnd (x + y)) -> rnd z = rnd (x + y).
Proof.
intros X Y L Told Near; set (t := fast_two_sum x y).
pose proof (fast_two_sum_is_exact x y X Y (or_introl L)) as E; fold t in E.
apply (told_by_k 20 t); [lia | apply rnd_is_double | exact Told |].
rewrite E; exact Near.
Qed.

(* --- Double-double times double --------------------------------------------- *)

Definition dd_mul_d (x : dd) (y : R) :=
  let p := two_prod (hi x) y in fast_two_sum (hi p) (fma (lo x) y (lo p)).

(* What the one rounding that is not made good leaves: 2u^2 of |hi y|. *)
Theorem dd_mul_d_is_close x y : is_double (hi x) -> is_double y ->
  Rabs (lo x) <= pow (-53) * Rabs (hi x) -> pow (-960) <= Rabs (hi x * y) ->
  Rabs (hi (dd_mul_d x y) + lo (dd_mul_d x y) - (hi x + lo x) * y)
  <= pow (-105) * Rabs (hi x * y).
Proof.
intros H Y L Large.
assert (pow (-969) <= Rabs (hi x * y)) as Large'
  by (apply Rle_trans with (2 := Large), bpow_le; lia).
pose proof (two_prod_is_exact _ _ H Y (or_intror Large')) as P.
set (p := two_prod (hi x) y) in *; set (e := Rabs (hi x * y)) in *.
assert (Rabs (hi p - hi x * y) <= / 2 * pow (- (53) + 1) * e) as Rel.
{ apply relative_error_N_FLT; [easy|].
  apply Rle_trans with (2 := Large), bpow_le; unfold emin, prec; lia. }
assert (Rabs (lo p) <= pow (-53) * e) as Lp.
{ replace (lo p) with (- (hi p - hi x * y)) by lra; rewrite Rabs_Ropp.
  simpl (pow _) in Rel |- *; lra. }
assert (Rabs (lo x * y) <= pow (-53) * e) as Lx.
{ unfold e; rewrite !Rabs_mult, <- Rmult_assoc.
  apply Rmult_le_compat_r; [apply Rabs_pos | exact L]. }
assert (0 < e) as E by (apply Rlt_le_trans with (2 := Large), bpow_gt_0).
set (z := lo x * y + lo p).
assert (Rabs z <= pow (-52) * e) as Z.
{ apply Rle_trans with (1 := Rabs_triang _ _).
  simpl (pow _) in Lp, Lx |- *; lra. }
assert (Rabs (rnd z - z) <= pow (-105) * e) as Last.
{ apply Rle_trans with (/ 2 * ulp radix2 exponent (pow (-52) * e)).
  - apply Rle_trans with (/ 2 * ulp radix2 exponent z).
    + apply error_le_half_ulp; auto with typeclass_instances.
    + apply Rmult_le_compat_l; [lra|]; apply ulp_le;
        auto with typeclass_instances.
      rewrite (Rabs_pos_eq (pow (-52) * e)); [exact Z|].
      pose proof (bpow_gt_0 radix2 (-52)); nra.
  - assert (ulp radix2 exponent (pow (-52) * e)
            <= Rabs (pow (-52) * e) * pow (1 - 53)) as U.
    { apply ulp_FLT_le; auto with typeclass_instances.
      rewrite Rabs_pos_eq by (pose proof (bpow_gt_0 radix2 (-52)); nra).
      apply Rle_trans with (pow (-52) * pow (-960)).
      - rewrite <- bpow_plus; apply bpow_le; unfold emin, prec; lia.
      - apply Rmult_le_compat_l; [apply bpow_ge_0 | exact Large]. }
    rewrite Rabs_pos_eq in U by (pose proof (bpow_gt_0 radix2 (-52)); nra).
    simpl (pow _) in U |- *; lra. }
assert (hi (dd_mul_d x y) + lo (dd_mul_d x y) = hi p + rnd z) as ->.
{ apply fast_two_sum_is_exact; try apply rnd_is_double; left.
  change (fma (lo x) y (lo p)) with (rnd z).
  pose proof (Rabs_triang (rnd z - z) z) as T1.
  replace (rnd z - z + z) with (rnd z) in T1 by ring.
  pose proof (Rabs_triang_inv (hi x * y) (hi p)) as T2.
  rewrite Rabs_minus_sym in T2; fold e in T2.
  simpl (pow _) in Last, Z, Rel; lra. }
replace (hi p + rnd z - (hi x + lo x) * y) with (rnd z - z) by (unfold z; lra).
exact Last.
Qed.
