(* with: rounding.v exact_dd_products.v impulse_dd.v *)
(* SPDX-License-Identifier: MIT *)
(* impulse.c, pair_kick: what a pair's momentum is off by, from the masses' shares k1 and k2 on.
   Unbounded exponents.
   BRINK_IMPULSE_MOMENTUM_ULP 2, but for its 2^-46th part. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding exact_dd_products impulse_dd.
Open Scope R_scope.

(* pair_kick(): hi is the velocity, lo what its rounding takes. *)
Definition kicked (k w : dd) (v : R) := dd_add_d (dd_mul k w) v.

(* A velocity v of mass m, changed by k w: before it is rounded at last, it is off by some u^2 of
   what the momentum was and is. *)
Lemma one_mass_kicked m mu k w v : 0 < m -> 0 < mu -> is_dd k -> is_dd w ->
  Rabs (m * total k - mu) <= 132 / 10 * u * u * mu ->
  let y := kicked k w v in
  Rabs (m * total y - m * v - mu * total w) <= 25 * u * u * (m * Rabs (hi y) + m * Rabs v) /\
  Rabs (lo y) <= u * (1 + 2 * u) * Rabs (hi y).
Proof.
intros M Mu K W E y; set (n := hi y); unfold kicked in y.
destruct (dd_mul_is_close k w K W) as [C D].
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
  assert (Rabs (m * kt - mu) * Rabs om <= 132 / 10 * u * u * mu * Rabs om)
    by (apply Rmult_le_compat_r; [apply Rabs_pos | apply Rabs_le; exact E]).
  unfold Om, u in *; lra. }
(* the sum and its rounding *)
set (t := rnd (hi x + v) + rnd (lo x + low (hi x + v))).
assert (T := dd_add_d_is_close x v D); unfold dd_add_d in T.
rewrite (proj2 (normal_is_dd _)) in T; fold t in T.
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
split; [| exact Ln]; unfold y, dd_add_d; rewrite (proj2 (normal_is_dd _)); fold t.
replace (m * t - m * v - mu * om) with (m * total x - mu * om + m * (t - (total x + v))) by ring.
apply Rle_trans with (1 := Rabs_triang _ _); unfold u in *; lra.
Qed.

(* And as it is rounded. *)
Lemma one_mass m mu k w v : 0 < m -> 0 < mu -> is_dd k -> is_dd w ->
  Rabs (m * total k - mu) <= 132 / 10 * u * u * mu ->
  let n := hi (kicked k w v) in
  Rabs (m * n - m * v - mu * total w) <=
    u * (m * Rabs n) + 30 * u * u * (m * Rabs n + m * Rabs v).
Proof.
intros M Mu K W E n; destruct (one_mass_kicked m mu k w v M Mu K W E) as [T L]; fold n in T, L.
set (l := lo (kicked k w v)) in *; unfold total at 1 in T; fold n l in T.
replace (m * n - m * v - mu * total w) with (m * (n + l) - m * v - mu * total w + - (m * l))
  by ring.
apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq m) by lra.
apply (Rmult_le_compat_l m) in L; [| lra].
assert (0 <= m * Rabs n) by (apply Rmult_le_pos; [lra | apply Rabs_pos]).
assert (0 <= m * Rabs v) by (apply Rmult_le_pos; [lra | apply Rabs_pos]).
unfold u in *; lra.
Qed.

(* pair_make()'s k1 and k2. *)
Definition share (m other : R) := dd_div (Dd other 0) (normal (m + other)).

Lemma share_is_close m o : is_double o -> 0 < m -> 0 < o -> let mu := m * o / (m + o) in
  0 < mu /\ is_dd (share m o) /\ Rabs (m * total (share m o) - mu) <= 132 / 10 * u * u * mu.
Proof.
intros F M O mu; destruct (normal_is_dd (m + o)) as [Ds Ts]; set (sum := normal (m + o)) in *.
assert (Fs : 0 < hi sum) by (apply (dd_sign sum Ds); lra).
destruct (dd_div_of_double o sum F O Fs Ds) as [D E]; fold (share m o) in D, E; rewrite Ts in E.
assert (Mm : 0 < m * o) by (apply Rmult_lt_0_compat; assumption).
assert (Mu : 0 < mu) by (apply Rdiv_lt_0_compat; lra); repeat split; try assumption.
apply (Rmult_le_reg_r (m + o)); [lra |].
rewrite <- (Rabs_pos_eq (m + o)) at 1 by lra; rewrite <- Rabs_mult.
replace ((m * total (share m o) - mu) * (m + o)) with (m * (total (share m o) * (m + o) - o))
  by (unfold mu; field; lra).
replace (132 / 10 * u * u * mu * (m + o)) with (m * (132 / 10 * u * u * o))
  by (unfold mu; field; lra).
rewrite Rabs_mult, (Rabs_pos_eq m) by lra; apply Rmult_le_compat_l; [lra | exact E].
Qed.

(* pair_make's k1, k2 and pair_kick's velocities, a component: the pair's momentum is off by 2u of
   the larger m |v|, before or after, but for 2^-46 of that. *)
Theorem momentum m1 m2 w v1 v2 Z : is_double m1 -> is_double m2 -> 0 < m1 -> 0 < m2 -> is_dd w ->
  let k1 := share m1 m2 in let k2 := share m2 m1 in
  let n1 := hi (kicked k1 w v1) in
  let n2 := hi (kicked k2 (dd_negate w) v2) in
  m1 * Rabs v1 <= Z -> m1 * Rabs n1 <= Z -> m2 * Rabs v2 <= Z -> m2 * Rabs n2 <= Z ->
  Rabs (m1 * n1 + m2 * n2 - (m1 * v1 + m2 * v2)) <= 2 * u * (1 + / 70368744177664) * Z.
Proof.
intros F1 F2 M1 M2 W k1 k2 n1 n2 V1 N1 V2 N2.
destruct (share_is_close m1 m2 F2 M1 M2) as (Mu & D1 & S1).
destruct (share_is_close m2 m1 F1 M2 M1) as (_ & D2 & S2).
replace (m2 * m1 / (m2 + m1)) with (m1 * m2 / (m1 + m2)) in S2 by (field; lra).
set (mu := m1 * m2 / (m1 + m2)) in *.
assert (Dw := dd_negate_is_dd w W).
assert (O1 := one_mass m1 mu k1 w v1 M1 Mu D1 W S1).
assert (O2 := one_mass m2 mu k2 (dd_negate w) v2 M2 Mu D2 Dw S2).
cbv zeta in O1, O2; fold k1 in O1; fold k2 in O2; fold n1 in O1; fold n2 in O2.
rewrite dd_negate_total in O2.
replace (m1 * n1 + m2 * n2 - (m1 * v1 + m2 * v2)) with
  (m1 * n1 - m1 * v1 - mu * total w + (m2 * n2 - m2 * v2 - mu * - total w)) by ring.
eapply Rle_trans; [apply Rabs_triang |].
assert (0 <= m1 * Rabs v1) by (apply Rmult_le_pos; [lra | apply Rabs_pos]).
unfold u in *; lra.
Qed.
