(* with: rounding.v exact_dd_products.v *)
(* SPDX-License-Identifier: MIT *)
(* impulse.c, pair_kick: what a pair's momentum is off by, from the masses' shares k1 and k2 on.
   Double-double with what fast_two_sum leaves behind as it is meant to be; unbounded exponents.
   BRINK_IMPULSE_MOMENTUM_ULP 2, but for its 2^-46th part. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding exact_dd_products.
Open Scope R_scope.

(* dd_div of a double has a better bound: q and what is left over of it. *)
Definition dd_div (x : R) (y : dd) :=
  let q := rnd (x / hi y) in let p := hi y * q in
  let r := rnd p + rnd (lo y * q + low p) in
  normal (q + rnd (rnd (rnd (x - rnd r) - low r) / hi y)).

Theorem dd_div_is_close x y : 0 < x -> 0 < hi y -> is_dd y -> is_dd (dd_div x y) /\
  Rabs (total (dd_div x y) * total y - x) <= 13 * u * u * x.
Proof.
destruct y as [h l]; unfold is_dd at 1, total at 2; cbn [hi lo]; intros X H D.
unfold dd_div; cbn [hi lo]; cbv zeta.
set (s := rnd (x / h) + _); destruct (normal_is_dd s) as [N ->]; split; [exact N |].
unfold s; clear s N; rewrite (Rabs_pos_eq h) in D by lra; apply Rabs_le_inv in D.
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
round_off (x - m0 - l1 + (n0 + l1 - l2)) (1001 / 1000 * x) l3.
round_off (x - (x - m0 - l1 + (n0 + l1 - l2) - l3)) (31 / 10 / 9007199254740992 * x) l4.
round_off (x - (x - m0 - l1 + (n0 + l1 - l2) - l3) - l4 - l3) (21 / 10 / 9007199254740992 * x) l5.
set (d := x - (x - m0 - l1 + (n0 + l1 - l2) - l3) - l4 - l3 - l5) in *.
assert (Dd : - (22 / 10 / 9007199254740992 * x) <= d <= 22 / 10 / 9007199254740992 * x)
  by (unfold d; lra).
assert (Ed : d / h * h = d) by (field; lra).
assert (Df : - (22 / 10 / 9007199254740992 * T) <= d / h <= 22 / 10 / 9007199254740992 * T).
{ split; apply (Rmult_le_reg_r h); try exact H; rewrite Ed; lra. }
set (f := d / h) in *; clearbody f.
round_off f (22 / 10 / 9007199254740992 * T) l6.
assert (Q1 := product l6 h (22 / 10 / 9007199254740992 / 9007199254740992 * T) h ltac:(lra)
  ltac:(lra)).
assert (Q2 := product l (f - l6) _ (23 / 10 / 9007199254740992 * T) D ltac:(lra)).
replace (22 / 10 / 9007199254740992 / 9007199254740992 * T * h) with
  (22 / 10 / 9007199254740992 / 9007199254740992 * x) in Q1 by (rewrite <- ET; field).
replace (1001 / 1000 * / 9007199254740992 * h * (23 / 10 / 9007199254740992 * T)) with
  (1001 / 1000 * 23 / 10 / 9007199254740992 / 9007199254740992 * x) in Q2
  by (rewrite <- ET; field).
replace ((T - l0 + (f - l6)) * (h + l) - x) with
  (- m0 + n0 + d - l6 * h + l * (f - l6)) by (rewrite <- Em, <- En, <- ET, <- Ed; ring).
set (k1 := l6 * h) in *; set (k2 := l * (f - l6)) in *; clearbody k1 k2.
unfold d; bound.
Qed.

Definition dd_add_d (x : dd) (y : R) :=
  normal (rnd (hi x + y) + rnd (lo x + low (hi x + y))).
Definition dd_negate (x : dd) := Dd (- hi x) (- lo x).

(* A velocity v of mass m, changed by k w and rounded: m n is off by its last rounding, and by some
   u^2 of what the momentum was and is. *)
Lemma one_mass m mu k w v : 0 < m -> 0 < mu -> is_dd k -> is_dd w ->
  Rabs (m * total k - mu) <= 13 * u * u * mu ->
  let n := hi (dd_add_d (dd_mul k w) v) in
  Rabs (m * n - m * v - mu * total w) <=
    u * (m * Rabs n) + 30 * u * u * (m * Rabs n + m * Rabs v).
Proof.
intros M Mu K W E n; destruct (dd_mul_is_close k w K W) as [C D].
set (x := dd_mul k w) in *; set (om := total w) in *; set (kt := total k) in *.
apply Rabs_le_inv in E.
(* sizes, all as parts of mu |om| *)
set (Om := mu * Rabs om); assert (O0 : 0 <= Om) by (apply Rmult_le_pos; [lra | apply Rabs_pos]).
assert (Lk : Rabs (hi k) <= 1001 / 1000 * Rabs kt).
{ unfold kt, total, is_dd, u in *; revert K; unfold Rabs; repeat destruct Rcase_abs; lra. }
assert (Lw : Rabs (hi w) <= 1001 / 1000 * Rabs om).
{ unfold om, total, is_dd, u in *; revert W; unfold Rabs; repeat destruct Rcase_abs; lra. }
assert (Mk : Rabs (m * kt) <= 1001 / 1000 * mu) by (apply Rabs_le; unfold u in *; lra).
assert (MKO : m * Rabs (kt * om) <= 1001 / 1000 * Om).
{ replace (m * Rabs (kt * om)) with (Rabs (m * kt) * Rabs om)
    by (rewrite !Rabs_mult, (Rabs_pos_eq m) by lra; ring).
  unfold Om; rewrite <- Rmult_assoc; apply Rmult_le_compat_r; [apply Rabs_pos | exact Mk]. }
assert (MHH : m * Rabs (hi k * hi w) <= 1004 / 1000 * Om).
{ rewrite Rabs_mult; apply Rle_trans with (m * (1001 / 1000 * Rabs kt * (1001 / 1000 * Rabs om))).
  - apply Rmult_le_compat_l; [lra |]; apply Rmult_le_compat; try apply Rabs_pos; assumption.
  - rewrite Rabs_mult in MKO; lra. }
assert (Mx : Rabs (m * total x - mu * om) <= 20 * u * u * Om).
{ replace (m * total x - mu * om) with (m * (total x - kt * om) + (m * kt - mu) * om) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _); rewrite !Rabs_mult, (Rabs_pos_eq m) by lra.
  assert (m * Rabs (total x - kt * om) <= m * (62 / 10 * u * u * Rabs (hi k * hi w)))
    by (apply Rmult_le_compat_l; [lra | exact C]).
  assert (Rabs (m * kt - mu) * Rabs om <= 13 * u * u * mu * Rabs om)
    by (apply Rmult_le_compat_r; [apply Rabs_pos | apply Rabs_le; exact E]).
  unfold Om, u in *; lra. }
(* the sum and its rounding *)
assert (Xs : Rabs (hi x) <= 1001 / 1000 * Rabs (total x)).
{ clear - D; unfold total, is_dd, u in *; revert D; unfold Rabs; repeat destruct Rcase_abs; lra. }
set (t := rnd (hi x + v) + rnd (lo x + low (hi x + v))).
assert (T : Rabs (t - (total x + v)) <= 11 / 10 * u * u * (3 * Rabs (total x) + Rabs v)).
{ unfold t; clear - D Xs; unfold total, is_dd in *; set (h := hi x) in *; set (l := lo x) in *.
  clearbody h l; set (s := Rabs (h + l)) in *; clearbody s; unfold u in *.
  apply Rabs_le_inv in D; size h p; size v q.
  round_off (h + v) (p + q) l1.
  round_off (l + l1) (/ 9007199254740992 * (1001 / 1000 * p + p + q)) l2; bound. }
assert (N : n = t - low t) by exact (rounded t).
assert (Lt := low_own t); assert (Ln : Rabs (low t) <= u * (1 + 2 * u) * Rabs n).
{ rewrite N; set (l := low t) in *; clearbody l t; revert Lt.
  unfold u, Rabs; repeat destruct Rcase_abs; lra. }
replace (m * n - m * v - mu * om) with
  (m * total x - mu * om + (m * (t - (total x + v)) - m * low t)) by (rewrite N; ring).
assert (A1 : Rabs (m * (t - (total x + v))) <=
  11 / 10 * u * u * (3 * (m * Rabs (total x)) + m * Rabs v)).
{ rewrite Rabs_mult, (Rabs_pos_eq m) by lra.
  apply Rmult_le_compat_l with (1 := Rlt_le _ _ M) in T; lra. }
assert (A2 : Rabs (m * low t) <= u * (1 + 2 * u) * (m * Rabs n)).
{ rewrite Rabs_mult, (Rabs_pos_eq m) by lra.
  apply Rmult_le_compat_l with (1 := Rlt_le _ _ M) in Ln; lra. }
assert (A3 : m * Rabs (total x) <= 1001 / 1000 * Om).
{ replace (m * Rabs (total x)) with (Rabs (m * total x))
    by (rewrite Rabs_mult, (Rabs_pos_eq m); lra).
  replace (m * total x) with (m * total x - mu * om + mu * om) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _).
  replace (Rabs (mu * om)) with Om by (unfold Om; rewrite Rabs_mult, (Rabs_pos_eq mu); lra).
  unfold u in *; lra. }
(* so large is the change that the momenta let it be *)
assert (A4 : Om <= 1001 / 1000 * (m * Rabs n + m * Rabs v)).
{ assert (Q : Om = Rabs (m * n - m * v - (m * total x - mu * om) -
    (m * (t - (total x + v)) - m * low t))).
  { unfold Om; rewrite <- (Rabs_pos_eq mu) at 1 by lra; rewrite <- Rabs_mult; f_equal.
    rewrite N; ring. }
  assert (V : Rabs (m * n) = m * Rabs n /\ Rabs (m * v) = m * Rabs v)
    by (rewrite !Rabs_mult, (Rabs_pos_eq m) by lra; split; reflexivity).
  destruct V as [V1 V2]; rewrite <- V1, <- V2 in *.
  set (p := m * total x - mu * om) in *; set (q := m * (t - (total x + v))) in *.
  set (r := m * low t) in *; set (mn := m * n) in *; set (mv := m * v) in *.
  assert (Rabs (mn - mv - p - (q - r)) <= Rabs mn + Rabs mv + Rabs p + Rabs q + Rabs r)
    by (unfold Rabs; repeat destruct Rcase_abs; lra).
  rewrite <- Q in H; generalize (Rabs_pos mn) (Rabs_pos mv); unfold u in *; lra. }
assert (0 <= m * Rabs n) by (apply Rmult_le_pos; [lra | apply Rabs_pos]).
assert (0 <= m * Rabs v) by (apply Rmult_le_pos; [lra | apply Rabs_pos]).
eapply Rle_trans; [apply Rabs_triang |].
assert (Rabs (m * (t - (total x + v)) - m * low t) <=
  Rabs (m * (t - (total x + v))) + Rabs (m * low t)).
{ unfold Rminus at 1; eapply Rle_trans; [apply Rabs_triang |]; rewrite Rabs_Ropp; lra. }
unfold u in *; lra.
Qed.

(* pair_make's k1, k2 and pair_kick's velocities, a component: the pair's momentum is off by 2u of
   the larger m |v|, before or after, but for 2^-46 of that. *)
Theorem momentum m1 m2 w v1 v2 Z : 0 < m1 -> 0 < m2 -> is_dd w ->
  let sum := normal (m1 + m2) in let k1 := dd_div m2 sum in let k2 := dd_div m1 sum in
  let n1 := hi (dd_add_d (dd_mul k1 w) v1) in
  let n2 := hi (dd_add_d (dd_mul k2 (dd_negate w)) v2) in
  m1 * Rabs v1 <= Z -> m1 * Rabs n1 <= Z -> m2 * Rabs v2 <= Z -> m2 * Rabs n2 <= Z ->
  Rabs (m1 * n1 + m2 * n2 - (m1 * v1 + m2 * v2)) <= 2 * u * (1 + / 70368744177664) * Z.
Proof.
intros M1 M2 W sum k1 k2 n1 n2 V1 N1 V2 N2.
destruct (normal_is_dd (m1 + m2)) as [Ds Ts]; fold sum in Ds, Ts.
assert (Fs : 0 < hi sum).
{ unfold sum, normal; cbn [hi]; rewrite (rounded (m1 + m2)).
  assert (L := low_small (m1 + m2) (m1 + m2) ltac:(lra)); unfold u in *; lra. }
destruct (dd_div_is_close m2 sum M2 Fs Ds) as [D1 E1]; fold k1 in D1, E1; rewrite Ts in E1.
destruct (dd_div_is_close m1 sum M1 Fs Ds) as [D2 E2]; fold k2 in D2, E2; rewrite Ts in E2.
set (mu := m1 * m2 / (m1 + m2)).
assert (Mm : 0 < m1 * m2) by (apply Rmult_lt_0_compat; assumption).
assert (Mu : 0 < mu) by (apply Rdiv_lt_0_compat; lra).
assert (Share : forall m o k, 0 < m -> m * o = m1 * m2 ->
  Rabs (k * (m1 + m2) - o) <= 13 * u * u * o ->
  Rabs (m * k - mu) <= 13 * u * u * mu).
{ intros m o k Pm Eo H; apply (Rmult_le_reg_r (m1 + m2)); [lra |].
  rewrite <- (Rabs_pos_eq (m1 + m2)) at 1 by lra; rewrite <- Rabs_mult.
  replace ((m * k - mu) * (m1 + m2)) with (m * (k * (m1 + m2) - o))
    by (unfold mu; rewrite <- Eo; field; lra).
  replace (13 * u * u * mu * (m1 + m2)) with (m * (13 * u * u * o))
    by (unfold mu; rewrite <- Eo; field; lra).
  rewrite Rabs_mult, (Rabs_pos_eq m) by lra; apply Rmult_le_compat_l; [lra | exact H]. }
assert (Dw : is_dd (dd_negate w)).
{ unfold is_dd, dd_negate in *; cbn [hi lo]; rewrite !Rabs_Ropp; exact W. }
assert (O1 := one_mass m1 mu k1 w v1 M1 Mu D1 W (Share m1 m2 _ M1 eq_refl E1)).
assert (O2 := one_mass m2 mu k2 (dd_negate w) v2 M2 Mu D2 Dw
  (Share m2 m1 _ M2 (Rmult_comm _ _) E2)).
cbv zeta in O1, O2; fold n1 in O1; fold n2 in O2.
assert (Tn : total (dd_negate w) = - total w) by (unfold total, dd_negate; cbn [hi lo]; ring).
rewrite Tn in O2.
replace (m1 * n1 + m2 * n2 - (m1 * v1 + m2 * v2)) with
  (m1 * n1 - m1 * v1 - mu * total w + (m2 * n2 - m2 * v2 - mu * - total w)) by ring.
eapply Rle_trans; [apply Rabs_triang |].
assert (0 <= m1 * Rabs v1) by (apply Rmult_le_pos; [lra | apply Rabs_pos]).
unfold u in *; lra.
Qed.
