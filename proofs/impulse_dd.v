(* with: rounding.v *)
(* SPDX-License-Identifier: MIT *)
(* exact.h's double-double as the impulses use it: what each operation is off by.  What fast_two_sum
   leaves behind is as it is meant to be; unbounded exponents. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding.
Open Scope R_scope.

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

(* 6.1u^2, and fast_two_sum's condition. *)
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

(* dd_div: q and what is left over of it. *)
Definition dd_div (x y : dd) :=
  let q := rnd (hi x / hi y) in let p := hi y * q in
  let r := rnd p + rnd (lo y * q + low p) in
  normal (q + rnd (rnd (rnd (hi x - rnd r) + rnd (lo x - low r)) / hi y)).

Theorem dd_div_is_close x y z : is_dd x -> Rabs (lo x) <= z -> 0 < hi y -> is_dd y ->
  Rabs (total (dd_div x y) * total y - total x) <=
    13 * u * u * Rabs (hi x) + 41 / 10 * u * z.
Proof.
destruct x as [x xl], y as [h l]; unfold is_dd, total at 2 3; cbn [hi lo]; intros X Z H D.
unfold dd_div; cbn [hi lo]; cbv zeta.
match goal with |- Rabs (total (normal ?s) * _ - _) <= _ => destruct (normal_is_dd s) as [_ ->] end.
rewrite (Rabs_pos_eq h) in D by lra; apply Rabs_le_inv in D.
set (T := x / h); assert (ET : h * T = x) by (unfold T; field; lra).
set (t := Rabs T); assert (Et : h * t = Rabs x).
{ unfold t; rewrite <- ET, Rabs_mult, (Rabs_pos_eq h) by lra; reflexivity. }
assert (PT : - t <= T <= t) by (apply Rabs_le_inv, Rle_refl).
assert (PX : - Rabs x <= x <= Rabs x) by (apply Rabs_le_inv, Rle_refl).
assert (T0 : 0 <= t) by apply Rabs_pos; assert (X0 := Rabs_pos x).
assert (Zx : - z <= xl <= z) by (apply Rabs_le_inv, Z).
apply Rabs_le_inv in X.
assert (Z' : exists m, - m <= xl <= m /\ 0 <= m <= 1001 / 1000 * u * Rabs x /\ m <= z).
{ exists (Rabs xl); repeat split; try exact Z; try apply Rabs_pos;
    try apply (Rabs_le_inv xl _ (Rle_refl _)); apply Rabs_le; exact X. }
destruct Z' as (m & Hm & Mx & Mz).
set (X' := Rabs x) in *; clearbody X'; clear X Z Zx.
assert (L0 := low_small T t PT); rewrite (rounded T).
set (l0 := low T) in *; clearbody l0; clearbody T t.
assert (M0 := product h l0 h _ ltac:(lra) L0).
assert (N0 := product l (T - l0) _ (1001 / 1000 * t) D ltac:(unfold u in *; lra)).
replace (h * (u * t)) with (u * X') in M0 by (rewrite <- Et; ring).
replace (1001 / 1000 * u * h * (1001 / 1000 * t)) with (1001 / 1000 * 1001 / 1000 * u * X') in N0
  by (rewrite <- Et; field).
replace (h * (T - l0)) with (x - h * l0) by (rewrite <- ET; ring).
set (m0 := h * l0) in *; set (n0 := l * (T - l0)) in *.
assert (Em : h * l0 = m0) by reflexivity; assert (En : l * (T - l0) = n0) by reflexivity.
clearbody m0 n0; unfold u in *.
round_off (x - m0) (1001 / 1000 * X') l1.
round_off (n0 + l1) (2004 / 1000 / 9007199254740992 * X') l2.
round_off (x - m0 - l1 + (n0 + l1 - l2)) (1001 / 1000 * X') l3.
round_off (x - (x - m0 - l1 + (n0 + l1 - l2) - l3)) (31 / 10 / 9007199254740992 * X') l4.
round_off (xl - l3) (1002 / 1000 / 9007199254740992 * X' + m) l7.
round_off (x - (x - m0 - l1 + (n0 + l1 - l2) - l3) - l4 + (xl - l3 - l7))
  (21 / 10 / 9007199254740992 * X' + 1001 / 1000 * m) l5.
set (d := x - (x - m0 - l1 + (n0 + l1 - l2) - l3) - l4 + (xl - l3 - l7) - l5) in *.
assert (Dd : - (22 / 10 / 9007199254740992 * X' + 1002 / 1000 * m) <= d <=
  22 / 10 / 9007199254740992 * X' + 1002 / 1000 * m) by (unfold d; lra).
set (k := m / h); assert (Ek : h * k = m) by (unfold k; field; lra); clearbody k.
assert (K0 : 0 <= k).
{ apply (Rmult_le_reg_l h); [exact H |]; rewrite Ek; lra. }
assert (Ed : d / h * h = d) by (field; lra).
assert (Df : - (22 / 10 / 9007199254740992 * t + 1002 / 1000 * k) <= d / h <=
  22 / 10 / 9007199254740992 * t + 1002 / 1000 * k).
{ split; apply (Rmult_le_reg_r h); try exact H; rewrite Ed; lra. }
set (f := d / h) in *; clearbody f.
round_off f (22 / 10 / 9007199254740992 * t + 1002 / 1000 * k) l6.
assert (Q1 := product l6 h
  (/ 9007199254740992 * (22 / 10 / 9007199254740992 * t + 1002 / 1000 * k)) h
  ltac:(lra) ltac:(lra)).
assert (Q2 := product l (f - l6) _ (23 / 10 / 9007199254740992 * t + 1003 / 1000 * k)
  D ltac:(lra)).
replace (/ 9007199254740992 * (22 / 10 / 9007199254740992 * t + 1002 / 1000 * k) * h) with
  (/ 9007199254740992 * (22 / 10 / 9007199254740992 * X' + 1002 / 1000 * m)) in Q1
  by (rewrite <- Et, <- Ek; field).
replace (1001 / 1000 * / 9007199254740992 * h *
  (23 / 10 / 9007199254740992 * t + 1003 / 1000 * k)) with
  (1001 / 1000 / 9007199254740992 * (23 / 10 / 9007199254740992 * X' + 1003 / 1000 * m)) in Q2
  by (rewrite <- Et, <- Ek; field).
replace ((T - l0 + (f - l6)) * (h + l) - (x + xl)) with
  (- m0 + n0 + d - xl - l6 * h + l * (f - l6)) by (rewrite <- Em, <- En, <- ET, <- Ed; ring).
set (k1 := l6 * h) in *; set (k2 := l * (f - l6)) in *; clearbody k1 k2.
unfold d; bound.
Qed.

Lemma dd_div_of_double x y : 0 < x -> 0 < hi y -> is_dd y -> is_dd (dd_div (Dd x 0) y) /\
  Rabs (total (dd_div (Dd x 0) y) * total y - x) <= 13 * u * u * x.
Proof.
intros X F Y; split; [apply normal_is_dd |].
assert (Z : is_dd (Dd x 0)).
{ unfold is_dd; cbn [hi lo]; rewrite Rabs_R0; apply Rmult_le_pos; [unfold u; lra |].
  apply Rabs_pos. }
assert (K := dd_div_is_close (Dd x 0) y 0 Z ltac:(cbn [lo]; rewrite Rabs_R0; lra) F Y).
cbn [hi] in K; rewrite (Rabs_pos_eq x) in K by lra.
replace (total (Dd x 0)) with x in K by (unfold total; cbn [hi lo]; ring); lra.
Qed.

Definition dd_sqrt (x : dd) := let s := rnd (sqrt (hi x)) in
  normal (s + rnd (rnd (rnd (hi x - s * s) + lo x) / (2 * s))).

Theorem dd_sqrt_is_close x : 0 < hi x -> is_dd x -> 0 < total (dd_sqrt x) /\
  Rabs (total (dd_sqrt x) * total (dd_sqrt x) - total x) <= 11 * u * u * hi x.
Proof.
destruct x as [h l]; unfold is_dd, total at 4; cbn [hi lo]; intros H D.
unfold dd_sqrt; cbn [hi lo]; cbv zeta.
match goal with |- 0 < total (normal ?s) /\ _ => destruct (normal_is_dd s) as [_ ->] end.
rewrite (Rabs_pos_eq h) in D by lra; apply Rabs_le_inv in D.
assert (S0 := sqrt_lt_R0 _ H); assert (SS := sqrt_sqrt h ltac:(lra)).
set (q := sqrt h) in *; clearbody q; subst h.
assert (L0 := low_small q q ltac:(lra)); rewrite (rounded q); set (e := low q) in *; clearbody e.
set (s := q - e) in *.
assert (E1 := product q e q _ ltac:(lra) L0); assert (E2 := product e e _ _ L0 L0).
replace (q * (u * q)) with (u * (q * q)) in E1 by ring.
replace (u * q * (u * q)) with (u * u * (q * q)) in E2 by ring.
assert (Es : s * s = q * q - 2 * (q * e) + e * e) by (unfold s; ring); rewrite Es.
set (x1 := q * e) in *; set (x2 := e * e) in *; clearbody x1 x2.
assert (Sp : 999 / 1000 * q <= s <= 1001 / 1000 * q) by (unfold s, u in *; lra).
clearbody s; clear L0; set (h := q * q) in *; unfold u in *.
round_off (h - (h - 2 * x1 + x2)) (2001 / 1000 / 9007199254740992 * h) l1.
round_off (h - (h - 2 * x1 + x2) - l1 + l) (301 / 100 / 9007199254740992 * h) l2.
set (d := h - (h - 2 * x1 + x2) - l1 + l - l2) in *.
assert (Dd : - (302 / 100 / 9007199254740992 * h) <= d <= 302 / 100 / 9007199254740992 * h)
  by (unfold d; lra).
assert (Ed : d / (2 * s) * (2 * s) = d) by (field; lra).
assert (Df : - (152 / 100 / 9007199254740992 * q) <= d / (2 * s) <=
  152 / 100 / 9007199254740992 * q).
{ assert (2 * (999 / 1000 * q) * q <= 2 * s * q) by (apply Rmult_le_compat_r; lra).
  fold h in H0; unfold h in *.
  split; apply (Rmult_le_reg_r (2 * s)); try lra; rewrite Ed; lra. }
set (f := d / (2 * s)) in *; clearbody f.
round_off f (152 / 100 / 9007199254740992 * q) l3.
assert (F2 := product f f _ _ Df Df).
assert (G := product (2 * s + 2 * f - l3) l3 (21 / 10 * q)
  (153 / 100 / 9007199254740992 / 9007199254740992 * q) ltac:(lra) ltac:(lra)).
replace (21 / 10 * q * (153 / 100 / 9007199254740992 / 9007199254740992 * q)) with
  (21 / 10 * 153 / 100 / 9007199254740992 / 9007199254740992 * h) in G by (unfold h; field).
replace (152 / 100 / 9007199254740992 * q * (152 / 100 / 9007199254740992 * q)) with
  (152 / 100 * 152 / 100 / 9007199254740992 / 9007199254740992 * h) in F2 by (unfold h; field).
split; [lra |].
replace ((s + (f - l3)) * (s + (f - l3)) - (h + l)) with
  (s * s - (h + l) + f * (2 * s) + f * f - (2 * s + 2 * f - l3) * l3) by ring.
rewrite Ed, Es; set (x3 := f * f) in *; set (x4 := (2 * s + 2 * f - l3) * l3) in *.
clearbody x3 x4 h; unfold d; bound.
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

Lemma dd_div_near x y : is_dd x -> 0 < hi y -> is_dd y ->
  near (172 / 10) (total (dd_div x y) * total y) (total x).
Proof.
intros X P Y; assert (E := dd_div_is_close x y _ X (Rle_refl _) P Y).
destruct (dd_size x X) as [H L]; assert (N := Rabs_pos (total x)); unfold near, u in *; lra.
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
