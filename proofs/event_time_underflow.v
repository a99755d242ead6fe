(* with: underflow.v *)
(* products: x y z s *)
(* SPDX-License-Identifier: MIT *)
(* The sums of event_time_sums.v once more, gradual underflow included: what they are off by, and a
   few of eta = 2^-1075, half of the smallest double.  That is nothing where R >= 2^-900.  x, y, z,
   s are the exact products; what is rest of them is rounded as well. *)
From Coq Require Import Reals Lra Lia.
From Flocq Require Import Core Mult_error.
From Brink Require Import underflow.
Open Scope R_scope.

(* The second part that two_prod gives. *)
Definition rest x := rnd (low x).

Definition is_product x := exists a b, is_double a /\ is_double b /\ x = a * b.

(* It is exact, but where the product is so small that it has bits below the smallest double. *)
Lemma rest_is_close x : is_product x -> low x - 3 * eta <= rest x <= low x + 3 * eta.
Proof.
intros (a & b & A & B & E); assert (T := eta_pos).
destruct (Rle_or_lt (pow (-969)) (Rabs x)) as [L | S].
- unfold rest, rnd; rewrite round_generic; [lra | typeclasses eauto |].
  unfold low; rewrite <- Ropp_minus_distr; apply generic_format_opp.
  rewrite E in L |- *; apply mult_error_FLT; auto with typeclass_instances.
- assert (U : u * pow (-1021) = 2 * eta).
  { unfold eta, u; change (/ 9007199254740992) with (pow (-53)); rewrite <- bpow_plus.
    change 2 with (pow 1); rewrite <- bpow_plus; reflexivity. }
  assert (P : 2 * pow (-1022) = pow (-1021))
    by (change 2 with (pow 1); rewrite <- bpow_plus; reflexivity).
  assert (Q : u * pow (-969) = pow (-1022))
    by (change u with (pow (-53)); rewrite <- bpow_plus; reflexivity).
  assert (K : eta <= pow (-1022)) by (apply bpow_le; lia).
  assert (X : - pow (-969) <= x <= pow (-969)) by (apply Rabs_le_inv; lra).
  assert (H := low_small x _ X); rewrite Q in H.
  assert (H' := low_small (low x) (pow (-1021)) ltac:(lra)); rewrite U in H'.
  unfold rest; rewrite (rounded (low x)); lra.
Qed.

Ltac rest_of x k := let H := fresh in
  assert (H : low x - 3 * eta <= rest x <= low x + 3 * eta) by (apply rest_is_close; assumption);
  set (k := rest x) in *; clearbody k.

(* event_time_sums.h, dot_rounded: 3u of the sum of the sizes. *)
Definition dot_rounded x y z := rnd (x + rnd (y + rnd z)).

Theorem dot_rounded_error x y z :
  Rabs (dot_rounded x y z - (x + y + z)) <= 3 * tiny * u * (Rabs x + Rabs y + Rabs z) + 4 * eta.
Proof.
assert (T := eta_pos); unfold dot_rounded, tiny, u; size x p; size y q; size z r.
round_off z r l1.
round_off (y + (z - l1)) (g * (q + r) + 2 * eta) l2.
round_off (x + (y + (z - l1) - l2)) (g * (p + q + r) + 4 * eta) l3.
bound.
Qed.

(* event_time_sums.h, dot_of: 7u^2 of the sum of the sizes. *)
Definition dot_of x y z :=
  let s := rnd x + rnd y in let t := rnd s + rnd z in
  rnd t + rnd (rnd (rnd (rest x + rest y) + rest z) + rnd (low s + low t)).

Theorem dot_of_error x y z : is_product x -> is_product y -> is_product z ->
  Rabs (dot_of x y z - (x + y + z)) <=
  7 * tiny * u * u * (Rabs x + Rabs y + Rabs z) + 16 * eta.
Proof.
intros X Y Z; assert (T := eta_pos); unfold dot_of, tiny, u; cbv zeta.
rest_of x k1; rest_of y k2; rest_of z k3; size x p; size y q; size z r.
round_off x p l1; round_off y q l2; round_off z r l3.
round_off (x - l1 + (y - l2)) (g * (p + q) + 2 * eta) l4.
round_off (x - l1 + (y - l2) - l4 + (z - l3)) (g * (p + q + r) + 6 * eta) l5.
round_off (k1 + k2) (/ 9007199254740992 * (p + q) + 8 * eta) l6.
round_off (k1 + k2 - l6 + k3) (/ 9007199254740992 * (g * (p + q + r)) + 14 * eta) l7.
round_off (l4 + l5) (/ 9007199254740992 * (g * (2 * (p + q) + r)) + 4 * eta) l8.
round_off (k1 + k2 - l6 + k3 - l7 + (l4 + l5 - l8))
  (/ 9007199254740992 * (g * g * (3 * (p + q) + 2 * r)) + 24 * eta) l9.
bound.
Qed.

(* event_time_sums.h, sums_of: c = r.r - sigma^2 with 11u^2 R, R = r.r + sigma^2. *)
Definition c_of x y z s :=
  let a := rnd x + rnd y in let t := rnd a + rnd z in let w := rnd t - rnd s in
  rnd w +
  rnd (rnd (rnd (rest x + rest y) + rnd (rest z - rest s)) + rnd (rnd (low a + low t) + low w)).

Theorem c_of_error x y z s : is_product x -> is_product y -> is_product z -> is_product s ->
  0 <= x -> 0 <= y -> 0 <= z -> 0 <= s ->
  Rabs (c_of x y z s - (x + y + z - s)) <= 11 * tiny * u * u * (x + y + z + s) + 24 * eta.
Proof.
intros X Y Z S Hx Hy Hz Hs; assert (T := eta_pos); unfold c_of, tiny, u; cbv zeta.
rest_of x k1; rest_of y k2; rest_of z k3; rest_of s k4.
round_off x x l1; round_off y y l2; round_off z z l3; round_off s s l4.
round_off (x - l1 + (y - l2)) (g * (x + y) + 2 * eta) l5.
round_off (x - l1 + (y - l2) - l5 + (z - l3)) (g * (x + y + z) + 6 * eta) l6.
round_off (x - l1 + (y - l2) - l5 + (z - l3) - l6 - (s - l4)) (g * (x + y + z + s) + 10 * eta) l7.
round_off (k1 + k2) (/ 9007199254740992 * (x + y) + 8 * eta) m1.
round_off (k3 - k4) (/ 9007199254740992 * (z + s) + 8 * eta) m2.
round_off (l5 + l6) (/ 9007199254740992 * (g * (2 * (x + y) + z)) + 4 * eta) m3.
round_off (k1 + k2 - m1 + (k3 - k4 - m2)) (/ 9007199254740992 * (g * (x + y + z + s)) + 20 * eta)
  m4.
round_off (l5 + l6 - m3 + l7)
  (/ 9007199254740992 * (g * g * (3 * (x + y) + 2 * z + s)) + 8 * eta) m5.
round_off (k1 + k2 - m1 + (k3 - k4 - m2) - m4 + (l5 + l6 - m3 + l7 - m5))
  (/ 9007199254740992 * (g * g * g * (4 * (x + y) + 3 * z + 2 * s)) + 32 * eta) m6.
bound.
Qed.

(* So where R >= 2^-900, as the guards of the paths have it, the bounds with unbounded exponents are
   not left: 24 eta are less than 2^-60 of u^2 R. *)
Theorem nothing_beside_R R : pow (-900) <= R -> 24 * eta <= pow (-60) * (u * u * R).
Proof.
intro H; apply Rle_trans with (pow (-1070)); [unfold eta |].
- replace (pow (-1070)) with (32 * pow (-1075))
    by (change 32 with (pow 5); rewrite <- bpow_plus; reflexivity).
  generalize (bpow_gt_0 radix2 (-1075)); lra.
- change u with (pow (-53)); rewrite <- !Rmult_assoc, <- !bpow_plus.
  apply Rle_trans with (pow (-60 + -53 + -53) * pow (-900)).
  + rewrite <- bpow_plus; apply bpow_le; lia.
  + apply Rmult_le_compat_l; [apply bpow_ge_0 | exact H].
Qed.
