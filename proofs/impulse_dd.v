(* with: rounding.v exact_dd_products.v *)
(* SPDX-License-Identifier: MIT *)
(* exact.h's double-double as the impulses use it: its sums as parts of their terms, its products
   and quotients of any sign.  What fast_two_sum leaves behind is as it is meant to be; unbounded
   exponents. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding exact_dd_products.
Open Scope R_scope.

Definition dd_mul_d (x : dd) (y : R) :=
  normal (rnd (hi x * y) + rnd (lo x * y + low (hi x * y))).

Theorem dd_mul_d_is_close x y : is_dd x ->
  Rabs (total (dd_mul_d x y) - total x * y) <= 21 / 10 * u * u * Rabs (hi x * y).
Proof.
destruct x as [xh xl]; unfold dd_mul_d, is_dd, total at 2; cbn [hi lo]; intro X.
destruct (normal_is_dd (rnd (xh * y) + rnd (xl * y + low (xh * y)))) as [_ ->].
assert (Hx := Rabs_le_inv _ _ X); assert (Sy := Rabs_le_inv y _ (Rle_refl _)).
assert (P := product _ _ _ _ Hx Sy).
replace (1001 / 1000 * u * Rabs xh * Rabs y) with (1001 / 1000 * u * Rabs (xh * y)) in P
  by (rewrite Rabs_mult; ring).
replace ((xh + xl) * y) with (xh * y + xl * y) by ring.
set (l := xl * y) in *; set (h := xh * y) in *; clearbody l h; unfold u in *; size h p.
round_off h p l0; round_off (l + l0) (2002 / 1000 / 9007199254740992 * p) l1; bound.
Qed.

Definition dd_add (x y : dd) :=
  let s := normal (hi x + hi y) in let t := normal (lo x + lo y) in
  let v := normal (hi s + rnd (lo s + hi t)) in normal (hi v + rnd (lo t + lo v)).

(* Of the terms, not of the sum: so for any signs. *)
Theorem dd_add_is_close x y : is_dd x -> is_dd y ->
  Rabs (total (dd_add x y) - (total x + total y)) <=
    31 / 10 * u * u * (Rabs (hi x) + Rabs (hi y)).
Proof.
destruct x as [xh xl], y as [yh yl]; intros X Y; unfold dd_add; cbv zeta.
rewrite (proj2 (normal_is_dd _)); unfold is_dd, total, normal in *; cbn [hi lo] in *.
apply Rabs_le_inv in X; apply Rabs_le_inv in Y; unfold u in *; size xh p; size yh q.
round_off (xh + yh) (p + q) l0; round_off (xl + yl) (1001 / 1000 / 9007199254740992 * (p + q)) l1.
round_off (l0 + (xl + yl - l1)) (2002 / 1000 / 9007199254740992 * (p + q)) l2.
round_off (xh + yh - l0 + (l0 + (xl + yl - l1) - l2)) (1001 / 1000 * (p + q)) l3.
round_off (l1 + l3) (1002 / 1000 / 9007199254740992 * (p + q)) l4; bound.
Qed.

Definition dd_add_d (x : dd) (y : R) :=
  normal (rnd (hi x + y) + rnd (lo x + low (hi x + y))).

Theorem dd_add_d_is_close x y : is_dd x ->
  Rabs (total (dd_add_d x y) - (total x + y)) <=
    11 / 10 * u * u * (3 * Rabs (total x) + Rabs y).
Proof.
destruct x as [h l]; unfold is_dd, dd_add_d, total at 2 3; cbn [hi lo]; intro D.
match goal with |- Rabs (total (normal ?s) - _) <= _ => destruct (normal_is_dd s) as [_ ->] end.
assert (Xs : Rabs h <= 1001 / 1000 * Rabs (h + l)).
{ revert D; unfold u, Rabs; repeat destruct Rcase_abs; lra. }
set (s := Rabs (h + l)) in *; clearbody s; unfold u in *.
apply Rabs_le_inv in D; size h p; size y q.
round_off (h + y) (p + q) l1.
round_off (l + l1) (/ 9007199254740992 * (1001 / 1000 * p + p + q)) l2; bound.
Qed.

Definition dd_negate (x : dd) := Dd (- hi x) (- lo x).

Lemma dd_negate_total x : total (dd_negate x) = - total x.
Proof. unfold total, dd_negate; cbn [hi lo]; ring. Qed.

Lemma dd_negate_is_dd x : is_dd x -> is_dd (dd_negate x).
Proof. unfold is_dd, dd_negate; cbn [hi lo]; rewrite !Rabs_Ropp; easy. Qed.

Lemma normal_is_double s : is_double (hi (normal s)).
Proof. apply generic_format_round; typeclasses eauto. Qed.

Lemma rnd_negative x : rnd (- x) = - rnd x.
Proof. apply round_NE_opp. Qed.

Lemma low_negative x : low (- x) = - low x.
Proof. unfold low; rewrite rnd_negative; ring. Qed.

Lemma dd_div_negative x y : dd_div (dd_negate x) y = dd_negate (dd_div x y).
Proof.
destruct x as [h l], y as [k m]; unfold dd_div, dd_negate, normal; cbn [hi lo]; cbv zeta.
replace (- h / k) with (- (h / k)) by (unfold Rdiv; ring); rewrite rnd_negative.
set (q := rnd (h / k)); replace (k * - q) with (- (k * q)) by ring.
rewrite low_negative, rnd_negative.
replace (m * - q + - low (k * q)) with (- (m * q + low (k * q))) by ring; rewrite rnd_negative.
rewrite <- Ropp_plus_distr; set (r := rnd (k * q) + _); rewrite low_negative, rnd_negative.
replace (- h - - rnd r) with (- (h - rnd r)) by ring.
replace (- l - - low r) with (- (l - low r)) by ring; rewrite !rnd_negative.
rewrite <- Ropp_plus_distr, rnd_negative; set (d := rnd (rnd (h - rnd r) + _)).
replace (- d / k) with (- (d / k)) by (unfold Rdiv; ring); rewrite rnd_negative.
rewrite <- Ropp_plus_distr, rnd_negative, low_negative; reflexivity.
Qed.

(* --- To some u^2 of itself ---------------------------------------------------- *)

Definition near e x y := Rabs (x - y) <= e * u * u * Rabs y.

Lemma near_size e x y : near e x y -> 0 <= e <= 1000 ->
  (1 - / 1000 * u) * Rabs y <= Rabs x <= (1 + / 1000 * u) * Rabs y.
Proof.
unfold near; intros N E.
assert (e * u * u * Rabs y <= 1000 * u * u * Rabs y).
{ rewrite !Rmult_assoc; apply Rmult_le_compat_r; [| lra].
  repeat (apply Rmult_le_pos; [unfold u; lra |]); apply Rabs_pos. }
revert N H; generalize (e * u * u * Rabs y); intro z.
unfold u, Rabs; repeat destruct Rcase_abs; lra.
Qed.

Lemma near_trans a b x y z : near a x y -> near b y z -> 0 <= a <= 900 -> 0 <= b <= 900 ->
  near (a + b + / 1000) x z.
Proof.
intros X Y A B; assert (S := near_size b y z Y ltac:(lra)); unfold near in *.
assert (Z := Rabs_pos z); assert (a * Rabs y <= a * ((1 + / 1000 * u) * Rabs z))
  by (apply Rmult_le_compat_l; lra).
assert (a * Rabs z <= 900 * Rabs z) by (apply Rmult_le_compat_r; lra).
assert (T := Rabs_triang (x - y) (y - z)); replace (x - y + (y - z)) with (x - z) in T by ring.
replace (a * u * u * Rabs y) with (u * u * (a * Rabs y)) in X by ring.
replace (b * u * u * Rabs z) with (u * u * (b * Rabs z)) in Y by ring.
replace ((a + b + / 1000) * u * u * Rabs z) with
  (u * u * (a * Rabs z + b * Rabs z + / 1000 * Rabs z)) by ring.
replace (a * ((1 + / 1000 * u) * Rabs z)) with (a * Rabs z + / 1000 * u * (a * Rabs z)) in H
  by ring.
unfold u in *; lra.
Qed.

Lemma near_product a b x y X Y : near a x X -> near b y Y -> 0 <= a <= 400 -> 0 <= b <= 400 ->
  near (a + b + / 1000) (x * y) (X * Y).
Proof.
intros Hx Hy A B; apply (near_trans a b _ (X * y)); try lra; unfold near in *.
- replace (x * y - X * y) with ((x - X) * y) by ring; rewrite !Rabs_mult, <- Rmult_assoc.
  apply Rmult_le_compat_r; [apply Rabs_pos | exact Hx].
- replace (X * y - X * Y) with (X * (y - Y)) by ring; rewrite !Rabs_mult.
  replace (b * u * u * (Rabs X * Rabs Y)) with (Rabs X * (b * u * u * Rabs Y)) by ring.
  apply Rmult_le_compat_l; [apply Rabs_pos | exact Hy].
Qed.

(* A root, by its square. *)
Lemma near_root e x y : 0 <= x -> 0 < y -> near e (x * x) (y * y) -> near e x y.
Proof.
intros X Y; unfold near; replace (x * x - y * y) with ((x - y) * (x + y)) by ring.
rewrite !Rabs_mult, (Rabs_pos_eq y), (Rabs_pos_eq (x + y)) by lra; intro H.
apply (Rmult_le_reg_r y); [exact Y |].
assert (Rabs (x - y) * y <= Rabs (x - y) * (x + y))
  by (apply Rmult_le_compat_l; [apply Rabs_pos | lra]).
lra.
Qed.

(* A quotient q of x and m, both a little off. *)
Lemma near_quotient a b q m y n : near a (q * m) y -> near b m n ->
  0 <= a <= 400 -> 0 <= b <= 400 -> n <> 0 -> near (a + b + / 1000) q (y / n).
Proof.
intros Q M A B N; unfold near in *; apply (Rmult_le_reg_r (Rabs n)); [now apply Rabs_pos_lt |].
rewrite <- Rabs_mult, !Rmult_assoc, <- Rabs_mult.
replace ((q - y / n) * n) with (q * m - y - q * (m - n)) by (field; exact N).
replace (y / n * n) with y by (field; exact N).
assert (S := near_size a (q * m) y Q ltac:(lra)); assert (T := near_size b m n M ltac:(lra)).
assert (U : Rabs (q * (m - n)) <= b * (u * u) * ((1 + / 100 * u) * Rabs y)).
{ rewrite Rabs_mult; apply Rle_trans with (Rabs q * (b * u * u * Rabs n));
    [apply Rmult_le_compat_l; [apply Rabs_pos | exact M] |].
  replace (Rabs q * (b * u * u * Rabs n)) with (b * (u * u) * (Rabs q * Rabs n)) by ring.
  apply Rmult_le_compat_l; [repeat apply Rmult_le_pos; unfold u; lra |].
  rewrite Rabs_mult in S; assert (Q0 := Rabs_pos q).
  assert (Rabs q * ((1 - / 1000 * u) * Rabs n) <= Rabs q * Rabs m)
    by (apply Rmult_le_compat_l; lra).
  assert (0 <= Rabs q * Rabs n) by (apply Rmult_le_pos; [exact Q0 | apply Rabs_pos]).
  unfold u in *; lra. }
assert (Y := Rabs_pos y); assert (b * Rabs y <= 400 * Rabs y) by (apply Rmult_le_compat_r; lra).
replace (b * (u * u) * ((1 + / 100 * u) * Rabs y)) with
  (u * u * (b * Rabs y) + / 100 * u * u * u * (b * Rabs y)) in U by ring.
assert (V := Rabs_triang (q * m - y) (- (q * (m - n)))); rewrite Rabs_Ropp in V.
replace (a * u * u * Rabs y) with (u * u * (a * Rabs y)) in Q by ring.
replace ((a + b + / 1000) * (u * (u * Rabs y))) with
  (u * u * (a * Rabs y + b * Rabs y + / 1000 * Rabs y)) by ring.
unfold Rminus in *; unfold u in *; lra.
Qed.

Lemma dd_size x : is_dd x -> Rabs (hi x) <= 1001 / 1000 * Rabs (total x) /\
  Rabs (lo x) <= 1002 / 1000 * u * Rabs (total x).
Proof.
destruct x as [h l]; unfold is_dd, total; cbn [hi lo].
unfold u, Rabs; repeat destruct Rcase_abs; lra.
Qed.

(* The leading part alone, of what is > 0. *)
Lemma near_high e x y : is_dd x -> near e (total x) y -> 0 <= e <= 1000 -> 0 < y ->
  Rabs (hi x - y) <= 1002 / 1000 * u * y.
Proof.
destruct x as [h l]; unfold is_dd, near, total; cbn [hi lo]; intros D N E Y.
rewrite (Rabs_pos_eq y) in N by lra.
assert (e * (u * u * y) <= 1000 * (u * u * y)).
{ apply Rmult_le_compat_r; [| lra]; repeat apply Rmult_le_pos; unfold u; lra. }
assert (L : Rabs (h + l - y) <= 1000 * (u * u * y)) by lra; clear - D L Y.
revert D L; unfold u, Rabs; repeat destruct Rcase_abs; lra.
Qed.

Lemma dd_sign x : is_dd x -> (0 < hi x <-> 0 < total x) /\ (hi x < 0 <-> total x < 0) /\
  999 / 1000 * Rabs (hi x) <= Rabs (total x) /\ Rabs (total x) <= 1001 / 1000 * Rabs (hi x).
Proof.
destruct x as [h l]; unfold is_dd, total; cbn [hi lo]; intro D.
repeat split; revert D; unfold u, Rabs; repeat destruct Rcase_abs; lra.
Qed.

Lemma dd_mul_near x y : is_dd x -> is_dd y ->
  near (63 / 10) (total (dd_mul x y)) (total x * total y).
Proof.
intros X Y; destruct (dd_mul_is_close x y X Y) as [E _]; unfold near.
apply Rle_trans with (1 := E); rewrite !Rabs_mult.
assert (Rabs (hi x) * Rabs (hi y) <=
  1001 / 1000 * Rabs (total x) * (1001 / 1000 * Rabs (total y)))
  by (apply Rmult_le_compat; try apply Rabs_pos; now apply dd_size).
assert (0 <= Rabs (total x) * Rabs (total y)) by (apply Rmult_le_pos; apply Rabs_pos).
unfold u; lra.
Qed.

Lemma dd_mul_d_near x y : is_dd x -> near (22 / 10) (total (dd_mul_d x y)) (total x * y).
Proof.
intro X; assert (E := dd_mul_d_is_close x y X); unfold near.
apply Rle_trans with (1 := E); rewrite !Rabs_mult.
assert (Rabs (hi x) * Rabs y <= 1001 / 1000 * Rabs (total x) * Rabs y)
  by (apply Rmult_le_compat_r; [apply Rabs_pos | now apply dd_size]).
assert (0 <= Rabs (total x) * Rabs y) by (apply Rmult_le_pos; apply Rabs_pos).
unfold u; lra.
Qed.

Lemma dd_div_near x y : is_double (hi x) -> is_dd x -> 0 < hi y -> is_dd y ->
  near (132 / 10) (total (dd_div x y) * total y) (total x).
Proof.
assert (Pos : forall x, is_double (hi x) -> is_dd x -> 0 < hi x -> 0 < hi y -> is_dd y ->
  near (132 / 10) (total (dd_div x y) * total y) (total x)).
{ intros z F Z Pz Py Y; destruct (dd_div_is_close z y F Pz Py Z Y) as [_ E]; unfold near.
  rewrite (Rabs_pos_eq (total z)); [exact E |]; destruct (dd_sign z Z) as [[S _] _]; lra. }
intros F X P Y; destruct (Rtotal_order (hi x) 0) as [N | [Z | N]]; [| | now apply Pos].
- assert (E := Pos (dd_negate x) ltac:(apply generic_format_opp, F) (dd_negate_is_dd x X)
    ltac:(unfold dd_negate; cbn [hi]; lra) P Y).
  rewrite dd_div_negative, !dd_negate_total in E; unfold near in *; rewrite Rabs_Ropp in E.
  rewrite <- Rabs_Ropp.
  replace (- (total (dd_div x y) * total y - total x))
    with (- total (dd_div x y) * total y - - total x) by ring; exact E.
- destruct x as [h l]; cbn [hi] in Z; subst h; unfold is_dd in X; cbn [hi lo] in X.
  rewrite Rabs_R0, Rmult_0_r in X; assert (l = 0) as ->.
  { revert X; unfold Rabs; destruct Rcase_abs; lra. }
  assert (O : dd_negate (Dd 0 0) = Dd 0 0) by (unfold dd_negate; cbn [hi lo]; now rewrite Ropp_0).
  assert (D := dd_div_negative (Dd 0 0) y); rewrite O in D.
  assert (T := dd_negate_total (dd_div (Dd 0 0) y)); rewrite <- D in T.
  unfold near; replace (total (dd_div (Dd 0 0) y)) with 0 by lra.
  unfold total; cbn [hi lo]; rewrite Rmult_0_l, Rplus_0_r, Rminus_0_r, Rabs_R0; lra.
Qed.

Lemma dd_div_of_double x y : is_double x -> 0 < x -> 0 < hi y -> is_dd y ->
  is_dd (dd_div (Dd x 0) y) /\
  Rabs (total (dd_div (Dd x 0) y) * total y - x) <= 132 / 10 * u * u * x.
Proof.
intros F X P Y; assert (Z : is_dd (Dd x 0)).
{ unfold is_dd; cbn [hi lo]; rewrite Rabs_R0, Rabs_pos_eq by lra; unfold u; lra. }
destruct (dd_div_is_close (Dd x 0) y F X P Z Y) as [D E]; split; [exact D |].
replace (total (Dd x 0)) with x in E by (unfold total; cbn [hi lo]; ring); exact E.
Qed.

Lemma dd_sqrt_square x : is_double (hi x) -> is_dd x -> 0 < hi x -> is_dd (dd_sqrt x) /\
  0 < total (dd_sqrt x) /\ near (85 / 10) (total (dd_sqrt x) * total (dd_sqrt x)) (total x).
Proof.
intros F X H; destruct (dd_sqrt_is_close x F H X) as [D E]; split; [exact D |].
apply (dd_sign x X) in H; assert (Pz := sqrt_lt_R0 _ H); assert (Z := sqrt_sqrt _ (Rlt_le _ _ H)).
unfold near; rewrite (Rabs_pos_eq (total x)) by lra.
set (z := sqrt (total x)) in *; set (a := total (dd_sqrt x)) in *; clearbody z a.
apply Rabs_le_inv in E; split; [unfold u in *; lra |]; rewrite <- Z.
replace (a * a - z * z) with ((a - z) * (a + z)) by ring; rewrite Rabs_mult.
assert (Rabs (a - z) * Rabs (a + z) <= 42 / 10 * u * u * z * (2001 / 1000 * z)).
{ apply Rmult_le_compat; try apply Rabs_pos; apply Rabs_le; unfold u in *; lra. }
assert (0 <= z * z) by apply Rle_0_sqr; unfold u in *; lra.
Qed.

Lemma dd_add_sizes x y : is_dd x -> is_dd y ->
  Rabs (total (dd_add x y) - (total x + total y)) <=
    32 / 10 * u * u * (Rabs (total x) + Rabs (total y)).
Proof.
intros X Y; assert (E := dd_add_is_close x y X Y).
destruct (dd_size x X) as [H _], (dd_size y Y) as [H' _].
assert (N := Rabs_pos (total x)); assert (N' := Rabs_pos (total y)); unfold u in *; lra.
Qed.

Definition zero := Dd 0 0.
Definition sum3 (x y z : dd) := dd_add (dd_add (dd_add zero x) y) z.

Lemma sum3_is_close x y z : is_dd x -> is_dd y -> is_dd z ->
  Rabs (total (sum3 x y z) - (total x + total y + total z)) <=
    97 / 10 * u * u * (Rabs (total x) + Rabs (total y) + Rabs (total z)).
Proof.
intros X Y Z; unfold sum3.
assert (O : is_dd zero) by (unfold is_dd, zero; cbn [hi lo]; rewrite Rabs_R0; lra).
assert (A := dd_add_sizes zero x O X); assert (Dx : is_dd (dd_add zero x)) by apply normal_is_dd.
assert (B := dd_add_sizes _ y Dx Y); assert (Dy : is_dd (dd_add (dd_add zero x) y))
  by apply normal_is_dd.
assert (C := dd_add_sizes _ z Dy Z).
replace (total zero) with 0 in A by (unfold total, zero; cbn [hi lo]; ring).
rewrite Rabs_R0 in A; set (s := total (dd_add zero x)) in *.
set (t := total (dd_add (dd_add zero x) y)) in *.
set (w := total (dd_add (dd_add (dd_add zero x) y) z)) in *.
set (a := total x) in *; set (b := total y) in *; set (c := total z) in *.
clearbody s t w a b c; clear - A B C.
assert (S : Rabs s <= Rabs (s - (0 + a)) + Rabs a)
  by (unfold Rabs; repeat destruct Rcase_abs; lra).
assert (T : Rabs t <= Rabs (t - (s + b)) + Rabs s + Rabs b)
  by (unfold Rabs; repeat destruct Rcase_abs; lra).
assert (W : Rabs (w - (a + b + c)) <=
  Rabs (w - (t + c)) + Rabs (t - (s + b)) + Rabs (s - (0 + a)))
  by (unfold Rabs; repeat destruct Rcase_abs; lra).
assert (0 <= Rabs a) by apply Rabs_pos; assert (0 <= Rabs b) by apply Rabs_pos.
assert (0 <= Rabs c) by apply Rabs_pos; unfold u in *; lra.
Qed.
