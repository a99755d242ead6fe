(* with: rounding.v *)
(* SPDX-License-Identifier: MIT *)
(* For quadratic_told.v: how near the sum s = h + sqrt(d) of roots_told is to the exact one, where d
   is all but 0 too.  Unbounded exponents. *)
From Coq Require Import Reals ZArith Lia Lra.
From Flocq Require Import Core.
From Brink Require Import rounding.
Open Scope R_scope.

Notation is_double := (generic_format radix2 fexp).
Notation pow := (bpow radix2).

(* No double is nearer than the one that is rounded to. *)
Lemma low_nearest v f : is_double f -> Rabs (low v) <= Rabs (v - f).
Proof.
intro F; destruct (round_N_pt radix2 fexp (fun n => negb (Z.even n)) v) as [_ N].
unfold low, rnd; rewrite (Rabs_minus_sym v), (Rabs_minus_sym v); apply N, F.
Qed.

Lemma few_bits n g : (Z.abs n <= 2 ^ 53)%Z -> is_double (IZR n * pow g).
Proof.
intro N; destruct (Z.eq_dec (Z.abs n) (2 ^ 53)) as [T | T].
- assert (P : is_double (pow (53 + g))) by (apply generic_format_bpow; unfold fexp, FLX_exp; lia).
  rewrite bpow_plus in P; change (pow 53) with (IZR (2 ^ 53)) in P.
  assert (n = 2 ^ 53 \/ n = - 2 ^ 53)%Z as [-> | ->] by lia; [exact P |].
  rewrite opp_IZR, Ropp_mult_distr_l_reverse; apply generic_format_opp, P.
- apply generic_format_FLX; exists (Float radix2 n g); [reflexivity |].
  cbn [Fnum]; change (radix2 ^ 53)%Z with (2 ^ 53)%Z; lia.
Qed.

(* Two doubles' product is so many of the 106th binary place below its leading one, and what is
   lost of it when it is rounded as well. *)
Lemma product_in_places x y k : is_double x -> is_double y ->
  (k <= mag radix2 x + mag radix2 y)%Z ->
  exists n, x * y = IZR n * pow (k - 106).
Proof.
intros X Y K; unfold generic_format, F2R in X, Y; cbn [Fnum Fexp] in X, Y.
set (m := Ztrunc _) in X; set (n := Ztrunc _) in Y; unfold cexp, fexp, FLX_exp in X, Y.
set (i := mag radix2 x : Z) in *; set (j := mag radix2 y : Z) in *.
exists (m * n * 2 ^ (i + j - k))%Z; rewrite !mult_IZR, (IZR_Zpower radix2) by lia.
transitivity (IZR m * pow (i - 53) * (IZR n * pow (j - 53))); [f_equal; assumption |].
replace (IZR m * pow (i - 53) * (IZR n * pow (j - 53))) with
  (IZR m * IZR n * (pow (i - 53) * pow (j - 53))) by ring.
rewrite !(Rmult_assoc (IZR m)), !(Rmult_assoc (IZR n)), <- !bpow_plus; do 3 f_equal; lia.
Qed.

Lemma low_in_places x y k : is_double x -> is_double y -> pow (k - 1) <= x * y < pow k ->
  exists n, low (x * y) = IZR n * pow (k - 106) /\ Rabs (low (x * y)) <= pow (k - 54).
Proof.
intros X Y B; assert (P := bpow_gt_0 radix2 (k - 1)).
assert (M : mag radix2 (x * y) = k :> Z) by (apply mag_unique; rewrite Rabs_pos_eq; lra).
assert (N : x * y <> 0) by lra.
destruct (product_in_places x y k X Y) as [n En].
{ rewrite <- M; apply mag_mult_le || (rewrite mag_mult; lia) || idtac.
  apply mag_le_bpow; [exact N |]; rewrite Rabs_mult, bpow_plus.
  apply Rmult_le_0_lt_compat; try apply Rabs_pos; apply bpow_mag_gt. }
assert (C : cexp radix2 fexp (x * y) = (k - 53)%Z) by (unfold cexp; rewrite M; reflexivity).
set (r := ZnearestE (scaled_mantissa radix2 fexp (x * y))).
assert (Er : rnd (x * y) = IZR (r * 2 ^ 53) * pow (k - 106)).
{ unfold rnd, round, F2R; cbn [Fnum Fexp]; rewrite C; fold r.
  rewrite mult_IZR; change (IZR (2 ^ 53)) with (pow 53); rewrite Rmult_assoc, <- bpow_plus.
  do 2 f_equal; lia. }
exists (n - r * 2 ^ 53)%Z; split.
- unfold low; rewrite Er, En, minus_IZR; ring.
- unfold low; rewrite Rabs_minus_sym.
  assert (H := error_le_half_ulp radix2 fexp (fun n => negb (Z.even n)) (x * y)).
  change (round radix2 fexp (Znearest _) (x * y)) with (rnd (x * y)) in H.
  rewrite ulp_neq_0, C in H by exact N.
  replace (k - 53)%Z with (1 + (k - 54))%Z in H by lia; rewrite bpow_plus in H.
  change (pow 1) with 2 in H; lra.
Qed.

(* Of two products near one another, a c the less, what they lose is the less by a double; or a
   power of two is between them, and it is no more than their difference. *)
Lemma difference_of_lows h a c : is_double h -> is_double a -> is_double c ->
  0 < h * h -> 0 < h * h - a * c <= h * h / 4 ->
  Rabs (low (low (h * h) - low (a * c))) <= u * (h * h - a * c).
Proof.
intros H A C Hh D; set (k := mag radix2 (h * h) : Z).
assert (M1 := bpow_mag_le radix2 (h * h) ltac:(lra)); assert (M2 := bpow_mag_gt radix2 (h * h)).
rewrite Rabs_pos_eq in M1, M2 by lra; fold k in M1, M2.
assert (U : 0 < u) by (unfold u; lra).
destruct (Rle_or_lt (pow (k - 1)) (a * c)) as [Same | Between].
- destruct (low_in_places h h k H H ltac:(split; assumption)) as (m & Em & Bm).
  destruct (low_in_places a c k A C ltac:(split; [exact Same | lra])) as (n & En & Bn).
  assert (F : is_double (low (h * h) - low (a * c))).
  { rewrite Em, En, <- Rmult_minus_distr_r, <- minus_IZR; apply few_bits.
    apply le_IZR; rewrite abs_IZR; apply (Rmult_le_reg_r (pow (k - 106))); [apply bpow_gt_0 |].
    rewrite <- (Rabs_pos_eq (pow (k - 106))) at 1 by apply bpow_ge_0.
    rewrite <- Rabs_mult, minus_IZR, Rmult_minus_distr_r, <- Em, <- En.
    apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp.
    change (IZR (2 ^ 53)) with (pow 53); rewrite <- bpow_plus.
    replace (53 + (k - 106))%Z with (1 + (k - 54))%Z by lia; rewrite bpow_plus.
    change (pow 1) with 2; lra. }
  unfold low at 1, rnd; rewrite round_generic, Rminus_diag_eq, Rabs_R0
    by (reflexivity || typeclasses eauto || exact F).
  apply Rmult_le_pos; lra.
- assert (P : is_double (pow (k - 1))) by (apply generic_format_bpow; unfold fexp, FLX_exp; lia).
  assert (L1 := low_nearest (h * h) _ P); assert (L2 := low_nearest (a * c) _ P).
  rewrite (Rabs_pos_eq (_ - _)) in L1 by lra; rewrite (Rabs_left (_ - _)) in L2 by lra.
  apply Rabs_le, low_small; apply Rabs_le_inv.
  apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; lra.
Qed.

(* The sum s = h + sqrt(d), h >= 0, as it is put right: what is left of d behind root^2, over
   2 root. *)
Section Sum.
Variables h a c d : R.
Let root := rnd (sqrt d).
Let t := rnd (rnd (h * h) - rnd (a * c)).
Let rest := rnd (low (rnd (h * h) - rnd (a * c)) + rnd (low (h * h) - low (a * c))).
Let gap := rnd (rnd (t - root * root) + rest).
Definition s_hi := rnd (h + root).
Definition s_lo := rnd (gap * rnd (/ 2 / root) + low (h + root)).

Hypotheses (H : is_double h) (A : is_double a) (C : is_double c) (Hh : 0 <= h).
Let D := h * h - a * c.
Let e := D - root * root.
Hypotheses (Pd : 0 < d) (Certain : Rabs (d - D) <= 3 * u * d).

Lemma exact_positive : 0 < D /\ d <= (1 + 4 * u) * D.
Proof. apply Rabs_le_inv in Certain; unfold u in *; lra. Qed.

Lemma root_near : 0 < root /\ - (51 / 10 * u * D) <= e <= 51 / 10 * u * D /\
  - (26 / 10 * u * sqrt D) <= sqrt D - root <= 26 / 10 * u * sqrt D.
Proof.
destruct exact_positive as [PD Le]; assert (Cd := Rabs_le_inv _ _ Certain).
assert (X := sqrt_lt_R0 d Pd); assert (X2 := sqrt_sqrt d (Rlt_le _ _ Pd)).
assert (Y := sqrt_lt_R0 D PD); assert (Y2 := sqrt_sqrt D (Rlt_le _ _ PD)).
assert (L := low_small (sqrt d) (sqrt d) ltac:(lra)).
assert (Er : root = sqrt d - low (sqrt d)) by apply rounded.
set (x := sqrt d) in *; set (l := low x) in *; clearbody l.
assert (Xl := product x l x (u * x) ltac:(lra) L).
assert (Ll := product l l (u * x) (u * x) L L).
replace (x * (u * x)) with (u * d) in Xl by (rewrite <- X2; ring).
replace (u * x * (u * x)) with (u * u * d) in Ll by (rewrite <- X2; ring).
assert (P : 0 < root) by (rewrite Er; unfold u in *; lra).
assert (Ee : e = D - d + 2 * (x * l) - l * l) by (unfold e; rewrite Er, <- X2; ring).
assert (B : - (51 / 10 * u * D) <= e <= 51 / 10 * u * D) by (unfold u in *; lra).
split; [exact P |]; split; [exact B |].
set (y := sqrt D) in *.
assert (F : (y - root) * (y + root) = e) by (unfold e; rewrite <- Y2; ring).
(* first root >= 0.99 y *)
assert (Big : 99 / 100 * y <= root).
{ apply square_le; [lra |]; unfold e in B; unfold u in *.
  replace (99 / 100 * y * (99 / 100 * y)) with (9801 / 10000 * (y * y)) by field; rewrite Y2; lra. }
apply Rabs_le_inv; apply (Rmult_le_reg_r (y + root)); [lra |].
rewrite <- (Rabs_pos_eq (y + root)) at 1 by lra; rewrite <- Rabs_mult, F.
apply Rabs_le; assert (Q : 26 / 10 * u * y * (199 / 100 * y) <= 26 / 10 * u * y * (y + root)).
{ apply Rmult_le_compat_l; [unfold u; lra | lra]. }
replace (26 / 10 * u * y * (199 / 100 * y)) with (5174 / 1000 * u * (y * y)) in Q by field.
rewrite Y2 in Q; unfold u in *; lra.
Qed.

(* Of any: 16u^2 of the terms' size. *)
Lemma gap_far :
  - (16 * u * u * (h * h + Rabs (a * c))) <= gap - e <= 16 * u * u * (h * h + Rabs (a * c)).
Proof.
destruct root_near as (_ & E & _); destruct exact_positive as [PD _].
assert (S := conj (Rle_abs (a * c)) (Rle_abs (- (a * c)))); rewrite Rabs_Ropp in S.
assert (Eq : root * root = h * h - a * c - e) by (unfold e, D; ring).
assert (Hp : 0 <= h * h) by apply Rle_0_sqr.
unfold gap, t, rest; rewrite Eq; unfold D in *; clearbody e; clear Certain Eq.
set (b := Rabs (a * c)) in *; set (x := h * h) in *; set (y := a * c) in *; clearbody b x y.
unfold u in *.
round_off x x la; round_off y b lb.
round_off (x - la - (y - lb)) (1001 / 1000 * (x + b)) l1.
round_off (la - lb) (/ 9007199254740992 * (x + b)) l2.
round_off (l1 + (la - lb - l2)) (21 / 10 / 9007199254740992 * (x + b)) l3.
round_off (x - la - (y - lb) - l1 - (x - y - e)) (72 / 10 / 9007199254740992 * (x + b)) l4.
round_off (x - la - (y - lb) - l1 - (x - y - e) - l4 + (l1 + (la - lb - l2) - l3))
  (52 / 10 / 9007199254740992 * (x + b)) l5.
lra.
Qed.

(* Where h^2 and a c are near one another: as near as root^2 is, and u of d. *)
Lemma gap_near : D <= h * h / 1024 -> - (72 / 10 * u * D) <= gap - e <= 72 / 10 * u * D.
Proof.
intro Near; destruct root_near as (_ & E & _); destruct exact_positive as [PD _].
assert (Hp : 0 < h * h) by (assert (0 <= h * h) by apply Rle_0_sqr; unfold D in *; lra).
assert (Rest := difference_of_lows h a c H A C Hp ltac:(unfold D in *; lra)).
apply Rabs_le_inv in Rest; fold D in Rest.
assert (T0 : low (rnd (h * h) - rnd (a * c)) = 0).
{ apply exact_difference; try (apply generic_format_round; typeclasses eauto).
  assert (La := low_small (h * h) (h * h) ltac:(lra)).
  assert (Lb := low_small (a * c) (h * h) ltac:(unfold D in *; lra)).
  rewrite (rounded (h * h)), (rounded (a * c)); unfold D, u in *; lra. }
assert (Er : rest = low (h * h) - low (a * c) - low (low (h * h) - low (a * c))).
{ unfold rest; rewrite T0, Rplus_0_l, rnd_rnd; apply rounded. }
assert (Et : t = h * h - low (h * h) - (a * c - low (a * c))).
{ unfold t; rewrite (rounded (rnd _ - rnd _)), T0, (rounded (h * h)), (rounded (a * c)); ring. }
assert (Fr : is_double (- rest)).
{ apply generic_format_opp; unfold rest; apply generic_format_round; typeclasses eauto. }
set (z := low (low (h * h) - low (a * c))) in *.
assert (Ev : t - root * root - - rest = e - z).
{ rewrite Et, Er; unfold e, D; ring. }
assert (L := low_nearest (t - root * root) _ Fr); rewrite Ev in L.
unfold gap; rewrite (rounded (t - root * root)).
set (l := low (t - root * root)) in *; clearbody l.
replace (t - root * root - l + rest) with (e - z - l) by lra.
assert (L2 : - (61 / 10 * u * D) <= l <= 61 / 10 * u * D).
{ apply Rabs_le_inv; apply Rle_trans with (1 := L); apply Rabs_le; unfold u in *; lra. }
clearbody z e; unfold u in *.
round_off (e - z - l) (122 / 10 / 9007199254740992 * D) l5; lra.
Qed.

(* What is left over 2 root, within k of s. *)
Lemma sum_from_gap k : 0 <= k <= / 1048576 ->
  - (2 * k * (root * (h + sqrt D))) <= gap - e <= 2 * k * (root * (h + sqrt D)) ->
  - ((k + k / 1024 + 20 * u * u) * (h + sqrt D)) <= s_hi + s_lo - (h + sqrt D) <=
    (k + k / 1024 + 20 * u * u) * (h + sqrt D).
Proof.
intros K Gap; destruct root_near as (P & E & Near); destruct exact_positive as [PD _].
assert (Y := sqrt_lt_R0 D PD); assert (Y2 := sqrt_sqrt D (Rlt_le _ _ PD)).
unfold s_hi, s_lo; rewrite (rounded (h + root)).
assert (L0 := low_small (h + root) (h + root) ltac:(lra)).
set (l0 := low (h + root)) in *; clearbody l0.
set (i := / 2 / root); assert (Ei : i * root = / 2) by (unfold i; field; lra).
assert (Pi : 0 < i) by (unfold i; apply Rdiv_lt_0_compat; lra).
assert (L1 := low_small i i ltac:(lra)); rewrite (rounded i).
set (l1 := low i) in *; clearbody l1.
set (y := sqrt D) in *; set (S := h + y) in *.
(* e i, of the exact (y - root) *)
assert (F : (y - root) * (y + root) = e) by (unfold e; rewrite <- Y2; ring).
set (w := y - root) in *.
assert (Ey : y = root + w) by (unfold w; ring).
assert (Eei : e * i = w + w * w * i).
{ rewrite <- F, Ey.
  replace (w * (root + w + root) * i) with (2 * w * (i * root) + w * w * i) by ring.
  rewrite Ei; field. }
assert (Wi : - (27 / 10 * u * / 2) <= w * i <= 27 / 10 * u * / 2).
{ assert (Near2 : - (27 / 10 * u * root) <= w <= 27 / 10 * u * root) by (unfold u in *; lra).
  assert (Q := product w i (27 / 10 * u * root) i Near2 ltac:(lra)).
  replace (27 / 10 * u * root * i) with (27 / 10 * u * / 2) in Q by (rewrite <- Ei; ring).
  exact Q. }
assert (Wwi := product w (w * i) _ _ Near Wi).
replace (w * (w * i)) with (w * w * i) in Wwi by ring.
(* (gap - e) i *)
assert (Gi := product (gap - e) i (2 * k * (root * S)) i Gap ltac:(lra)).
replace (2 * k * (root * S) * i) with (k * S) in Gi
  by (replace (2 * k * (root * S) * i) with (2 * k * S * (i * root)) by ring; rewrite Ei; field).
assert (Egi : gap * i = w + w * w * i + (gap - e) * i) by (rewrite <- Eei; ring).
assert (PS : 0 < S) by (unfold S; lra).
assert (Ys : y <= S) by (unfold S; lra).
assert (Kq : 0 <= k * S) by (apply Rmult_le_pos; lra).
assert (KS : k * S <= / 1048576 * S) by (apply Rmult_le_compat_r; lra).
set (q := w * w * i) in *; set (v := (gap - e) * i) in *; set (kS := k * S) in *.
assert (G1 : - (26 / 10 * u * S + u * S + kS) <= gap * i <= 26 / 10 * u * S + u * S + kS).
{ rewrite Egi; unfold u in *; lra. }
assert (Gl : - (u * (26 / 10 * u * S + u * S + kS)) <= gap * l1 <=
  u * (26 / 10 * u * S + u * S + kS)).
{ assert (Q := product (gap * i) (l1 / i) _ u G1).
  replace (gap * i * (l1 / i)) with (gap * l1) in Q by (field; lra).
  assert (- u <= l1 / i <= u).
  { split; apply (Rmult_le_reg_r i); try exact Pi; unfold Rdiv;
      rewrite Rmult_assoc, Rinv_l by lra; lra. }
  specialize (Q ltac:(assumption)); lra. }
replace (gap * (i - l1) + l0) with (w + q + v - gap * l1 + l0)
  by (rewrite Rmult_minus_distr_l, Egi; ring).
set (gl := gap * l1) in *.
replace ((k + k / 1024 + 20 * u * u) * S) with (kS + kS / 1024 + 20 * u * u * S)
  by (unfold kS; field).
assert (Hr : h + root = S - w) by (unfold S, w; ring).
rewrite Hr in *; clearbody q v kS gl w S y; clear Eei Egi Wi F Gap G1 E L1 Y2 PD Certain Hr.
unfold u in *.
round_off (w + q + v - gl + l0) (4 / 9007199254740992 * S + 2 * kS) l2; lra.
Qed.

(* Together: 2^-76 of the sum, near roots and far ones. *)
Theorem sum_told : let S := h + sqrt D in
  - (/ 75557863725914323419136 * S) <= s_hi + s_lo - S <= / 75557863725914323419136 * S.
Proof.
cbv zeta; destruct root_near as (P & E & Near); destruct exact_positive as [PD Le].
assert (Y := sqrt_lt_R0 D PD); assert (Y2 := sqrt_sqrt D (Rlt_le _ _ PD)).
assert (Lr : (1 - 3 * u) * sqrt D <= root) by (unfold u in *; lra).
set (y := sqrt D) in *; assert (Hp : 0 <= h * h) by apply Rle_0_sqr.
assert (Hy : 0 <= h * y) by (apply Rmult_le_pos; lra).
assert (Rs : (1 - 3 * u) * (h * y + D) <= root * (h + y)).
{ rewrite <- Y2; replace ((1 - 3 * u) * (h * y + y * y)) with ((1 - 3 * u) * y * (h + y)) by ring.
  apply Rmult_le_compat_r; lra. }
destruct (Rle_or_lt h (33554432 * y)) as [Far | Close].
- (* 16u^2 (2 h^2 + d) over 2 root *)
  assert (G := gap_far).
  assert (N : h * h + Rabs (a * c) <= 2 * (h * h) + D).
  { unfold D in *; unfold Rabs; destruct Rcase_abs; lra. }
  assert (Hh2 : h * h <= 33554432 * (h * y)).
  { replace (33554432 * (h * y)) with (h * (33554432 * y)) by ring; apply Rmult_le_compat_l; lra. }
  assert (B := sum_from_gap (17 * u * u * 33554432) ltac:(unfold u; lra)).
  fold y in B; assert (B' : - (2 * (17 * u * u * 33554432) * (root * (h + y))) <= gap - e <=
    2 * (17 * u * u * 33554432) * (root * (h + y))) by (unfold u in *; lra).
  specialize (B B'); unfold u in *; lra.
- assert (Hh2 : 33554432 * (h * y) <= h * h).
  { replace (33554432 * (h * y)) with (h * (33554432 * y)) by ring; apply Rmult_le_compat_l; lra. }
  assert (Yy : 33554432 * D <= h * y).
  { rewrite <- Y2; replace (33554432 * (y * y)) with (33554432 * y * y) by ring.
    apply Rmult_le_compat_r; lra. }
  assert (G := gap_near ltac:(lra)).
  assert (B := sum_from_gap (37 / 10 * u * / 33554432) ltac:(unfold u; lra)).
  fold y in B; assert (B' : - (2 * (37 / 10 * u * / 33554432) * (root * (h + y))) <= gap - e <=
    2 * (37 / 10 * u * / 33554432) * (root * (h + y))) by (unfold u in *; lra).
  specialize (B B'); unfold u in *; lra.
Qed.
End Sum.
