(* with: rounding.v *)
(* SPDX-License-Identifier: MIT *)
(* dd_mul, dd_div and dd_sqrt of exact.h, with unbounded exponents and what fast_two_sum leaves
   behind as it is meant to be.  Of what is divided or has a root: of numbers > 0, as another sign
   is the mirror. *)
From Coq Require Import Reals ZArith Lra.
From Flocq Require Import Core Div_sqrt_error.
From Brink Require Import rounding.
Open Scope R_scope.

Notation is_double := (generic_format radix2 fexp).

Record dd := Dd { hi : R; lo : R }.
(* As two_sum leaves it. *)
Definition is_dd (x : dd) := Rabs (lo x) <= 1001 / 1000 * u * Rabs (hi x).
Definition total (x : dd) := hi x + lo x.
Definition normal s := Dd (rnd s) (low s). (* fast_two_sum of what sums up to s *)

Lemma normal_is_dd s : is_dd (normal s) /\ total (normal s) = s.
Proof.
unfold is_dd, total, normal; cbn [hi lo]; assert (H := low_own s); rewrite (rounded s).
set (l := low s) in *; clearbody l; split; [| ring].
revert H; unfold u, Rabs; repeat destruct Rcase_abs; intros; lra.
Qed.

Definition dd_mul (x y : dd) := let p := hi x * hi y in
  normal (rnd p + rnd (low p +
    rnd (lo x * hi y + rnd (hi x * lo y + rnd (lo x * lo y))))).

(* 6.2u^2 of the leading parts' product. *)
Theorem dd_mul_is_close x y : is_dd x -> is_dd y ->
  Rabs (total (dd_mul x y) - total x * total y) <= 62 / 10 * u * u * Rabs (hi x * hi y) /\
  is_dd (dd_mul x y).
Proof.
destruct x as [xh xl], y as [yh yl]; unfold dd_mul, is_dd at 1 2, total at 2 3; cbn [hi lo].
intros X Y; set (s := rnd (xh * yh) + _); destruct (normal_is_dd s) as [N ->]; split; [| exact N].
unfold s; clear s N.
assert (Hx : - (1001 / 1000 * u * Rabs xh) <= xl <= 1001 / 1000 * u * Rabs xh)
  by (apply Rabs_le_inv, X).
assert (Hy : - (1001 / 1000 * u * Rabs yh) <= yl <= 1001 / 1000 * u * Rabs yh)
  by (apply Rabs_le_inv, Y).
assert (Sx := Rabs_le_inv xh _ (Rle_refl _)); assert (Sy := Rabs_le_inv yh _ (Rle_refl _)).
assert (P1 := product _ _ _ _ Sx Sy); assert (P2 := product _ _ _ _ Sx Hy).
assert (P3 := product _ _ _ _ Hx Sy); assert (P4 := product _ _ _ _ Hx Hy).
rewrite Rabs_mult; set (T := Rabs xh * Rabs yh) in *.
replace (Rabs xh * (1001 / 1000 * u * Rabs yh)) with (1001 / 1000 * u * T) in P2
  by (unfold T; ring).
replace (1001 / 1000 * u * Rabs xh * Rabs yh) with (1001 / 1000 * u * T) in P3 by (unfold T; ring).
replace (1001 / 1000 * u * Rabs xh * (1001 / 1000 * u * Rabs yh)) with
  (1001 / 1000 * 1001 / 1000 * u * u * T) in P4 by (unfold T; field).
replace ((xh + xl) * (yh + yl)) with (xh * yh + xh * yl + xl * yh + xl * yl) by ring.
set (hh := xh * yh) in *; set (hl := xh * yl) in *; set (lh := xl * yh) in *.
set (ll := xl * yl) in *; clearbody hh hl lh ll T; clear X Y Hx Hy Sx Sy; unfold u in *.
round_off hh T l0; round_off ll (11 / 10 / 9007199254740992 / 9007199254740992 * T) l1.
round_off (hl + (ll - l1)) (1002 / 1000 / 9007199254740992 * T) l2.
round_off (lh + (hl + (ll - l1) - l2)) (2004 / 1000 / 9007199254740992 * T) l3.
round_off (l0 + (lh + (hl + (ll - l1) - l2) - l3)) (3006 / 1000 / 9007199254740992 * T) l4.
bound.
Qed.

Definition dd_div (x y : dd) :=
  let q := rnd (hi x / hi y) in let p := hi y * q in
  let r := rnd p + rnd (lo y * q + low p) in
  normal (q + rnd (rnd (rnd (hi x - rnd r) + rnd (lo x - low r)) / hi y)).

(* 13.2u^2 of the quotient z: z y is as near to x. *)
Theorem dd_div_is_close x y : is_double (hi x) -> 0 < hi x -> 0 < hi y -> is_dd x -> is_dd y ->
  is_dd (dd_div x y) /\
  Rabs (total (dd_div x y) * total y - total x) <= 132 / 10 * u * u * total x.
Proof.
destruct x as [x xl], y as [h l]; unfold is_dd at 1 2, total at 2 3 4; cbn [hi lo].
intros F X H Dx D; unfold dd_div; cbn [hi lo]; cbv zeta.
set (s := rnd (x / h) + _); destruct (normal_is_dd s) as [N ->]; split; [exact N |].
unfold s; clear s N; rewrite (Rabs_pos_eq h) in D by lra; rewrite (Rabs_pos_eq x) in Dx by lra.
apply Rabs_le_inv in D; apply Rabs_le_inv in Dx.
set (T := x / h); assert (ET : h * T = x) by (unfold T; field; lra).
assert (PT : 0 < T) by (apply Rdiv_lt_0_compat; assumption).
assert (L0 := low_small T T ltac:(lra)); rewrite (rounded T).
set (l0 := low T) in *; clearbody l0; clearbody T.
assert (M0 := product h l0 h _ ltac:(lra) L0).
assert (N0 := product l (T - l0) _ (1001 / 1000 * T) D ltac:(unfold u in *; lra)).
replace (h * (u * T)) with (u * x) in M0 by (rewrite <- ET; ring).
replace (1001 / 1000 * u * h * (1001 / 1000 * T)) with (1001 / 1000 * 1001 / 1000 * u * x) in N0
  by (rewrite <- ET; field).
replace (h * (T - l0)) with (x - h * l0) by (rewrite <- ET; ring).
set (m0 := h * l0) in *; set (n0 := l * (T - l0)) in *.
assert (Em : h * l0 = m0) by reflexivity; assert (En : l * (T - l0) = n0) by reflexivity.
clearbody m0 n0; unfold u in *.
round_off (x - m0) (1001 / 1000 * x) l1.
round_off (n0 + l1) (2004 / 1000 / 9007199254740992 * x) l2.
set (r := x - m0 - l1 + (n0 + l1 - l2)) in *.
assert (Er : r = x - m0 + n0 - l2) by (unfold r; ring); clearbody r.
(* x is near r, so their difference is exact *)
assert (Fr : is_double (rnd r)) by (apply generic_format_round; typeclasses eauto).
assert (Lr := low_small r (1001 / 1000 * x) ltac:(lra)); unfold u in Lr.
assert (Exact : low (x - rnd r) = 0).
{ apply exact_difference; try assumption; rewrite (rounded r); lra. }
rewrite (rounded (x - rnd r)), Exact, Rminus_0_r, (rounded r).
set (l3 := low r) in *; clearbody l3; clear Exact Fr.
round_off (xl - l3) (2003 / 1000 / 9007199254740992 * x) l4.
round_off (x - (r - l3) + (xl - l3 - l4)) (3006 / 1000 / 9007199254740992 * x) l5.
set (d := x - (r - l3) + (xl - l3 - l4) - l5) in *.
assert (Dd : - (3007 / 1000 / 9007199254740992 * x) <= d <= 3007 / 1000 / 9007199254740992 * x)
  by (unfold d; lra).
assert (Ed : d / h * h = d) by (field; lra).
assert (Df : - (3007 / 1000 / 9007199254740992 * T) <= d / h <= 3007 / 1000 / 9007199254740992 * T).
{ split; apply (Rmult_le_reg_r h); try exact H; rewrite Ed; lra. }
set (f := d / h) in *; clearbody f.
round_off f (3007 / 1000 / 9007199254740992 * T) l6.
assert (Q1 := product l6 h (3007 / 1000 / 9007199254740992 / 9007199254740992 * T) h ltac:(lra)
  ltac:(lra)).
assert (Q2 := product l (f - l6) _ (3008 / 1000 / 9007199254740992 * T) D ltac:(lra)).
replace (3007 / 1000 / 9007199254740992 / 9007199254740992 * T * h) with
  (3007 / 1000 / 9007199254740992 / 9007199254740992 * x) in Q1 by (rewrite <- ET; field).
replace (1001 / 1000 * / 9007199254740992 * h * (3008 / 1000 / 9007199254740992 * T)) with
  (1001 / 1000 * 3008 / 1000 / 9007199254740992 / 9007199254740992 * x) in Q2
  by (rewrite <- ET; field).
replace ((T - l0 + (f - l6)) * (h + l) - (x + xl)) with
  (- m0 + n0 + d - l6 * h + l * (f - l6) - xl) by (rewrite <- Em, <- En, <- ET, <- Ed; ring).
set (k1 := l6 * h) in *; set (k2 := l * (f - l6)) in *; clearbody k1 k2.
unfold d; rewrite Er; bound.
Qed.

Definition dd_sqrt (x : dd) :=
  let s := rnd (sqrt (hi x)) in
  normal (s + rnd (rnd (rnd (hi x - s * s) + lo x) / (2 * s))).

(* 4.2u^2 of the root. *)
Theorem dd_sqrt_is_close x : is_double (hi x) -> 0 < hi x -> is_dd x -> is_dd (dd_sqrt x) /\
  Rabs (total (dd_sqrt x) - sqrt (total x)) <= 42 / 10 * u * u * sqrt (total x).
Proof.
destruct x as [h l]; unfold is_dd at 1, total at 2 3; cbn [hi lo]; intros F H D.
unfold dd_sqrt; cbn [hi lo]; cbv zeta.
set (z := rnd (sqrt h) + _); destruct (normal_is_dd z) as [N ->]; split; [exact N |].
unfold z; clear z N; rewrite (Rabs_pos_eq h) in D by lra; apply Rabs_le_inv in D.
assert (X := sqrt_lt_R0 h H); assert (X2 := sqrt_sqrt h (Rlt_le _ _ H)).
(* what is left of h is a double *)
assert (Exact : rnd (h - rnd (sqrt h) * rnd (sqrt h)) = h - rnd (sqrt h) * rnd (sqrt h)).
{ apply round_generic; [typeclasses eauto |].
  exact (sqrt_error_FLX_N radix2 53 (fun n => negb (Z.even n)) ltac:(easy) h F). }
rewrite Exact; clear Exact.
assert (L0 := low_small (sqrt h) (sqrt h) ltac:(lra)); rewrite (rounded (sqrt h)).
set (y := sqrt h) in *; set (l0 := low y) in *; clearbody l0.
assert (Y0 := product y l0 y _ ltac:(lra) L0); assert (L00 := product l0 l0 _ _ L0 L0).
replace (y * (u * y)) with (u * h) in Y0 by (rewrite <- X2; ring).
replace (u * y * (u * y)) with (u * u * h) in L00 by (rewrite <- X2; ring).
replace (h - (y - l0) * (y - l0)) with (2 * (y * l0) - l0 * l0) by (rewrite <- X2; ring).
assert (Es : (y - l0) * (y - l0) = h - 2 * (y * l0) + l0 * l0) by (rewrite <- X2; ring).
set (s := y - l0) in *; set (m := y * l0) in *; set (n := l0 * l0) in *.
assert (Ps : 0 < s) by (unfold s, u in *; lra).
assert (Sy : (1 - u) * y <= s <= (1 + u) * y) by (unfold s, u in *; lra).
clearbody m n; unfold u in *.
round_off (2 * m - n + l) (3002 / 1000 / 9007199254740992 * h) l1.
set (d := 2 * m - n + l - l1) in *.
assert (Dd : - (3003 / 1000 / 9007199254740992 * h) <= d <= 3003 / 1000 / 9007199254740992 * h)
  by (unfold d; lra).
assert (Ed : d / (2 * s) * s = d / 2) by (field; lra).
set (f := d / (2 * s)) in *.
assert (Df : - (1502 / 1000 / 9007199254740992 * s) <= f <= 1502 / 1000 / 9007199254740992 * s).
{ split; apply (Rmult_le_reg_r s); try exact Ps; rewrite Ed.
  - replace (- (1502 / 1000 / 9007199254740992 * s) * s) with
      (- (1502 / 1000 / 9007199254740992 * (s * s))) by ring; rewrite Es; lra.
  - replace (1502 / 1000 / 9007199254740992 * s * s) with
      (1502 / 1000 / 9007199254740992 * (s * s)) by ring; rewrite Es; lra. }
clearbody f.
round_off f (1502 / 1000 / 9007199254740992 * s) l2.
(* the square of what is given, beside h + l *)
set (Z := sqrt (h + l)); assert (PZ : 0 < Z) by (apply sqrt_lt_R0; lra).
assert (Z2 : Z * Z = h + l) by (apply sqrt_sqrt; lra).
assert (Ff := product f f _ _ Df Df).
assert (Lf := product l2 (2 * s + 2 * f - l2) (1502 / 1000 / 9007199254740992 / 9007199254740992 * s)
  (2001 / 1000 * s) ltac:(lra) ltac:(lra)).
assert (Ss : s * s <= 1001 / 1000 * (Z * Z)) by (rewrite Es, Z2; lra).
assert (Sq : (s + (f - l2)) * (s + (f - l2)) - Z * Z = f * f - l1 - l2 * (2 * s + 2 * f - l2)).
{ rewrite Z2; replace ((s + (f - l2)) * (s + (f - l2))) with
    (s * s + 2 * (f * s) + f * f - l2 * (2 * s + 2 * f - l2)) by ring.
  rewrite Ed, Es; unfold d; field. }
assert (E : Rabs ((s + (f - l2)) * (s + (f - l2)) - Z * Z) <=
  834 / 100 / 9007199254740992 / 9007199254740992 * (Z * Z)).
{ rewrite Sq; assert (S1 := Rmult_le_pos s s (Rlt_le _ _ Ps) (Rlt_le _ _ Ps)); apply Rabs_le; lra. }
assert (G : 999 / 1000 * Z <= s + (f - l2)).
{ assert (999 / 1000 * Z <= 9995 / 10000 * s); [| lra].
  apply square_le; [lra |]; replace (999 / 1000 * Z * (999 / 1000 * Z)) with
    (998001 / 1000000 * (Z * Z)) by field; rewrite Z2.
  replace (9995 / 10000 * s * (9995 / 10000 * s)) with (99900025 / 100000000 * (s * s)) by field.
  rewrite Es; lra. }
set (w := s + (f - l2)) in *.
apply (Rmult_le_reg_r (w + Z)); [lra |].
rewrite <- (Rabs_pos_eq (w + Z)) at 1 by lra; rewrite <- Rabs_mult.
replace ((w - Z) * (w + Z)) with (w * w - Z * Z) by ring; apply Rle_trans with (1 := E).
replace (42 / 10 * / 9007199254740992 * / 9007199254740992 * Z * (w + Z)) with
  (42 / 10 / 9007199254740992 / 9007199254740992 * Z * (w + Z)) by field.
apply Rle_trans with (42 / 10 / 9007199254740992 / 9007199254740992 * Z * (1999 / 1000 * Z)).
- assert (0 <= Z * Z) by (apply Rmult_le_pos; lra).
  replace (42 / 10 / 9007199254740992 / 9007199254740992 * Z * (1999 / 1000 * Z)) with
    (42 / 10 * 1999 / 1000 / 9007199254740992 / 9007199254740992 * (Z * Z)) by field; lra.
- apply Rmult_le_compat_l; lra.
Qed.
