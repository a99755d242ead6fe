(* with: numbers.v *)
(* refutes: momentum *)
(* SPDX-License-Identifier: MIT *)
(* Masses 1 and 3, at rest, and a kick by 4 + 3u: the one velocity is 3 + 9u / 4, which becomes
   3 + 4u, the other -1 - 3u / 4, which becomes -1.  4u are more than u of 3. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Brink Require Import rounding exact_dd_products impulse_dd impulse_sums numbers.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of momentum in exact (T -> False)).
Proof.
intro H; assert (P : forall x m e, x = IZR m * pow e -> (Z.abs m < 2 ^ 53)%Z -> rnd x = x)
  by (intros x m e E L; apply (exact_unbounded x m e E L)).
assert (N0 : rnd 0 = 0) by (apply (P _ 0%Z 0%Z); [simpl; lra | lia]).
assert (N1 : rnd 1 = 1) by (apply (P _ 1%Z 0%Z); [simpl; lra | lia]).
assert (N3 : rnd 3 = 3) by (apply (P _ 3%Z 0%Z); [simpl; lra | lia]).
assert (N4 : rnd 4 = 4) by (apply (P _ 4%Z 0%Z); [simpl; lra | lia]).
assert (Q1 : rnd (1 / 4) = 1 / 4) by (apply (P _ 1%Z (-2)%Z); [simpl; lra | lia]).
assert (Q3 : rnd (3 / 4) = 3 / 4) by (apply (P _ 3%Z (-2)%Z); [simpl; lra | lia]).
assert (L : forall x, rnd x = x -> low x = 0) by (intros x E; unfold low; rewrite E; ring).
assert (Share : forall m o, m + o = 4 -> o = 1 \/ o = 3 -> share m o = Dd (o / 4) 0).
{ intros m o E O; unfold share, dd_div, normal; cbn [hi lo]; rewrite E, N4, (L 4 N4); cbv zeta.
  assert (Eo : rnd (o / 4) = o / 4) by (destruct O as [-> | ->]; assumption).
  assert (Eo' : rnd o = o) by (destruct O as [-> | ->]; assumption).
  rewrite Eo; replace (4 * (o / 4)) with o by field; rewrite Eo', (L o Eo'), Rmult_0_l, Rplus_0_r.
  rewrite N0, Rplus_0_r, Eo', (L o Eo'), !Rminus_eq_0, N0, Rplus_0_r, N0.
  replace (0 / 4) with 0 by field; rewrite N0, Rplus_0_r, Eo, (L _ Eo); reflexivity. }
(* k w of k = o / 4, added to 0 *)
set (w := Dd 4 (3 * u)).
assert (Kick : forall o s r, o = 1 \/ o = 3 -> s = 1 \/ s = -1 ->
  rnd (s * (o + o / 4 * (3 * u))) = r -> rnd r = r ->
  rnd (s * (o + o / 4 * (3 * u)) - r) = s * (o + o / 4 * (3 * u)) - r ->
  hi (kicked (Dd (o / 4) 0) (Dd (s * 4) (s * (3 * u))) 0) = r).
{ intros o s r O S R Rr Rl; unfold kicked, dd_mul, dd_add_d, normal; cbn [hi lo]; cbv zeta.
  replace (o / 4 * (s * 4)) with (s * o) by field.
  assert (So : rnd (s * o) = s * o).
  { destruct O as [-> | ->], S as [-> | ->];
      [apply (P _ 1%Z 0%Z) | apply (P _ (-1)%Z 0%Z) | apply (P _ 3%Z 0%Z) | apply (P _ (-3)%Z 0%Z)];
      try lia; simpl; lra. }
  assert (Sl : rnd (o / 4 * (s * (3 * u))) = o / 4 * (s * (3 * u))).
  { destruct O as [-> | ->], S as [-> | ->];
      [apply (P _ 3%Z (-55)%Z) | apply (P _ (-3)%Z (-55)%Z) | apply (P _ 9%Z (-55)%Z) |
       apply (P _ (-9)%Z (-55)%Z)]; try lia; unfold u; simpl; lra. }
  rewrite So, (L _ So), !Rmult_0_l, N0, !Rplus_0_r, Sl, !Rplus_0_l, Sl, Sl.
  replace (s * o + o / 4 * (s * (3 * u))) with (s * (o + o / 4 * (3 * u))) by field.
  rewrite R, Rr, (L r Rr), Rplus_0_r; unfold low; rewrite R, Rl.
  replace (r + (s * (o + o / 4 * (3 * u)) - r)) with (s * (o + o / 4 * (3 * u))) by ring; exact R. }
assert (W : is_dd w) by (unfold is_dd, w, u; cbn [hi lo]; rewrite !Rabs_pos_eq by lra; lra).
set (z := 3 + 4 * u).
assert (R3 : rnd (1 * (3 + 3 / 4 * (3 * u))) = z).
{ replace z with (IZR 6755399441055745 * pow (-51)) by (unfold z, u; simpl; lra).
  apply rounds_to; [lia | reflexivity |]; right; split; [| lia]; unfold u; simpl; lra. }
assert (R1 : rnd (-1 * (1 + 1 / 4 * (3 * u))) = -1).
{ replace (-1 * (1 + 1 / 4 * (3 * u))) with (- (1 + 1 / 4 * (3 * u))) by ring.
  assert (E : rnd (1 + 1 / 4 * (3 * u)) = 1)
    by (apply beside_1; [reflexivity |]; unfold u; simpl; lra).
  rewrite rnd_negative, E; lra. }
assert (K1 : hi (kicked (share 1 3) w 0) = z).
{ assert (K := Kick 3 1 z (or_intror eq_refl) (or_introl eq_refl) R3); rewrite !Rmult_1_l in K.
  rewrite (Share 1 3 ltac:(lra) (or_intror eq_refl)); apply K.
  - apply (P _ 6755399441055745%Z (-51)%Z); [unfold z, u; simpl; lra | lia].
  - apply (P _ (-7)%Z (-55)%Z); [unfold z, u; simpl; lra | lia]. }
assert (K2 : hi (kicked (share 3 1) (dd_negate w) 0) = -1).
{ assert (K := Kick 1 (-1) (-1) (or_introl eq_refl) (or_intror eq_refl) R1).
  rewrite (Share 3 1 ltac:(lra) (or_introl eq_refl)); unfold dd_negate, w; cbn [hi lo].
  replace (- (3 * u)) with (-1 * (3 * u)) by ring; replace (- (4)) with (-1 * 4) by ring; apply K.
  - apply (P _ (-1)%Z 0%Z); [simpl; lra | lia].
  - apply (P _ (-3)%Z (-55)%Z); [unfold u; simpl; lra | lia]. }
assert (F : forall m, m = 1 \/ m = 3 -> is_double m).
{ intros m [-> | ->]; [rewrite <- N1 | rewrite <- N3]; apply generic_format_round;
    typeclasses eauto. }
specialize (H 1 3 w 0 0 z (F 1 ltac:(lra)) (F 3 ltac:(lra)) ltac:(lra) ltac:(lra) W).
cbv zeta in H; rewrite K1, K2 in H; rewrite !Rabs_R0 in H.
rewrite (Rabs_pos_eq z), (Rabs_left (-1)) in H by (unfold z, u; lra).
assert (G := H ltac:(unfold z, u; lra) ltac:(lra) ltac:(unfold z, u; lra) ltac:(unfold z, u; lra)).
replace (1 * z + 3 * -1 - (1 * 0 + 3 * 0)) with (4 * u) in G by (unfold z; ring).
rewrite Rabs_pos_eq in G by (unfold u; lra); unfold z, u in G; lra.
Qed.
