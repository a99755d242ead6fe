(* products: x y z s *)
(* SPDX-License-Identifier: MIT *)
(* rounding.v with gradual underflow: rounding to a double, barring overflow, and what it leaves
   behind.  That is u of what is rounded and eta, half of the smallest double, more; of a sum of
   doubles it is u of it alone.  And where the two are one: on the grid of the smallest double. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core Relative Plus_error.
Open Scope R_scope.

Notation pow := (bpow radix2).

Definition u := / 9007199254740992. (* 2^-53 *)
Definition eta := pow (-1075).
Definition fexp := FLT_exp (-1074) 53.
Definition rnd := round radix2 fexp ZnearestE.
Definition low x := x - rnd x.
Definition tiny := 1 + / 1099511627776. (* 1 + 2^-40 *)
Notation is_double := (generic_format radix2 fexp).

Global Instance precision : Prec_gt_0 53. Proof. now red. Qed.

Lemma eta_pos : 0 < eta. Proof. apply bpow_gt_0. Qed.

Lemma rounded x : rnd x = x - low x. Proof. unfold low; ring. Qed.

Lemma low_own x : - (u * Rabs x + eta) <= low x <= u * Rabs x + eta.
Proof.
destruct (error_N_FLT radix2 (-1074) 53 ltac:(easy) (fun n => negb (Z.even n)) x)
  as (d & e & D & E & _ & Q).
assert (L : low x = - (x * d) - e) by (unfold low, rnd, fexp; rewrite Q; ring).
assert (U : / 2 * pow (- (53) + 1) = u) by (unfold u; simpl; lra).
assert (T : / 2 * pow (-1074) = eta)
  by (change (/ 2) with (pow (-1)); rewrite <- bpow_plus; reflexivity).
rewrite U in D; rewrite T in E; apply Rabs_le_inv; rewrite L.
assert (M : Rabs (x * d) <= u * Rabs x).
{ rewrite Rabs_mult, (Rmult_comm u); apply Rmult_le_compat_l; [apply Rabs_pos | exact D]. }
replace (- (x * d) - e) with (- (x * d + e)) by ring; rewrite Rabs_Ropp.
apply Rle_trans with (1 := Rabs_triang _ _); lra.
Qed.

(* A number of at most m in size is rounded by at most u m and eta. *)
Lemma low_small x m : - m <= x <= m -> - (u * m + eta) <= low x <= u * m + eta.
Proof.
intros H; assert (L := low_own x); assert (A : Rabs x <= m) by (apply Rabs_le; lra).
unfold u in *; lra.
Qed.

Lemma double_minus x : is_double x -> is_double (- x).
Proof. apply generic_format_opp. Qed.

(* A difference of doubles is never rounded by more than u of itself. *)
Lemma low_difference x y : is_double x -> is_double y -> Rabs (low (x - y)) <= u * Rabs (x - y).
Proof.
intros X Y.
destruct (FLT_plus_error_N_ex radix2 (-1074) 53 (fun n => negb (Z.even n)) x (- y) X
  (double_minus y Y)) as (d & D & Q).
assert (U : u_ro radix2 53 = u) by (unfold u_ro, u; simpl; lra).
assert (D' : Rabs d <= u).
{ apply Rle_trans with (1 := D); rewrite U; unfold u; lra. }
replace (low (x - y)) with (- ((x - y) * d))
  by (unfold low, rnd, fexp, Rminus in *; rewrite Q; ring).
rewrite Rabs_Ropp, Rabs_mult, Rmult_comm.
apply Rmult_le_compat_r; [apply Rabs_pos | exact D'].
Qed.

(* Names what the rounding of e loses, which is no more than u m and eta. *)
Ltac round_off e m l := let H := fresh in let P := fresh in
  assert (P : - (m) <= e <= m) by lra; assert (H := low_small e m P); unfold u in H;
  rewrite ?(rounded e); set (l := low e) in *; clearbody l; clear P.

(* Names |x|. *)
Ltac size x p := let H := fresh in
  assert (H := conj (Rle_abs x) (Rle_abs (- x))); rewrite Rabs_Ropp in H;
  set (p := Rabs x) in *; clearbody p.

Ltac bound := apply Rabs_le; lra.

(* A little more than 1: of what was rounded a few times. *)
Notation g := (35184372088833 / 35184372088832). (* 1 + 2^-45 *)

(* A sum of three products without fma: 3u of the sum of their sizes, and 6 eta. *)
Definition dot_plain x y z := rnd (rnd (rnd x + rnd y) + rnd z).

Lemma dot_plain_error x y z :
  Rabs (dot_plain x y z - (x + y + z)) <= 3 * tiny * u * (Rabs x + Rabs y + Rabs z) + 6 * eta.
Proof.
assert (E := eta_pos); unfold dot_plain, tiny, u; size x p; size y q; size z r.
round_off x p l1; round_off y q l2; round_off z r l3.
round_off (x - l1 + (y - l2)) (g * (p + q) + 2 * eta) l4.
round_off (x - l1 + (y - l2) - l4 + (z - l3)) (g * (p + q + r) + 5 * eta) l5.
bound.
Qed.

Lemma dot_plain_rel x y z : 0 <= x -> 0 <= y -> 0 <= z ->
  - (3 * tiny * u * (x + y + z) + 6 * eta) <= dot_plain x y z - (x + y + z) <=
    3 * tiny * u * (x + y + z) + 6 * eta.
Proof.
intros; apply Rabs_le_inv; eapply Rle_trans; [apply dot_plain_error |].
rewrite !Rabs_right by lra; unfold tiny, u; lra.
Qed.

(* The sum of the sizes of three, themselves rounded. *)
Definition size_plain x y z := rnd (rnd (Rabs (rnd x) + Rabs (rnd y)) + Rabs (rnd z)).

Lemma size_plain_rel x y z : let S := Rabs x + Rabs y + Rabs z in
  (1 - 4 * u) * S - 6 * eta <= size_plain x y z <= (1 + 4 * u) * S + 6 * eta.
Proof.
assert (E := eta_pos).
assert (A : forall t, (1 - u) * Rabs t - eta <= Rabs (rnd t) <= (1 + u) * Rabs t + eta).
{ intro t; assert (L := low_own t); rewrite (rounded t); revert L.
  unfold u, Rabs; repeat destruct Rcase_abs; lra. }
unfold size_plain; assert (X := A x); assert (Y := A y); assert (Z := A z).
set (p := Rabs (rnd x)) in *; set (q := Rabs (rnd y)) in *; set (r := Rabs (rnd z)) in *.
assert (P := Rabs_pos (rnd x)); assert (Q := Rabs_pos (rnd y)); assert (R := Rabs_pos (rnd z)).
assert (P' := Rabs_pos x); assert (Q' := Rabs_pos y); assert (R' := Rabs_pos z).
fold p in P; fold q in Q; fold r in R.
set (a := Rabs x) in *; set (b := Rabs y) in *; set (c := Rabs z) in *.
clearbody p q r a b c; clear A; unfold u in *.
round_off (p + q) (g * (a + b) + 2 * eta) l1.
round_off (p + q - l1 + r) (g * (a + b + c) + 5 * eta) l2; lra.
Qed.

(* --- Where exponents might as well have no bounds --------------------------- *)

(* A multiple of the smallest double. *)
Definition on_grid x := exists m, x = IZR m * pow (-1074).

(* It is rounded as with unbounded exponents: either it is normal, or a double. *)
Theorem grid_is_rounded_alike x : on_grid x -> rnd x = round radix2 (FLX_exp 53) ZnearestE x.
Proof.
intros (m & ->); destruct (Rle_or_lt (pow (-1022)) (Rabs (IZR m * pow (-1074)))) as [L | S].
- exact (round_FLT_FLX radix2 (-1074) 53 ZnearestE _ L).
- assert (M : (Z.abs m < 2 ^ 53)%Z).
  { apply lt_IZR; rewrite abs_IZR; apply Rmult_lt_reg_r with (1 := bpow_gt_0 radix2 (-1074)).
    rewrite Rabs_mult, (Rabs_pos_eq (pow _)) in S by apply bpow_ge_0; apply Rlt_trans with (1 := S).
    change (IZR (2 ^ 53)) with (pow 53); rewrite <- bpow_plus; apply bpow_lt; reflexivity. }
  unfold rnd; rewrite !round_generic; try typeclasses eauto; try reflexivity.
  + apply generic_format_FLX; exists (Float radix2 m (-1074)); [reflexivity | exact M].
  + apply generic_format_FLT; exists (Float radix2 m (-1074)); [reflexivity | exact M | easy].
Qed.

(* All doubles are on it, and it is not left by sums, differences and roundings. *)
Theorem doubles_are_on_grid x : is_double x -> on_grid x.
Proof.
intro D; apply FLT_format_generic in D; [| easy]; destruct D as [[m e] -> M E].
exists (m * 2 ^ (e + 1074))%Z; unfold F2R; cbn [Fnum Fexp] in *.
rewrite mult_IZR, (IZR_Zpower radix2), Rmult_assoc by lia; rewrite <- bpow_plus.
f_equal; f_equal; lia.
Qed.

Theorem grid_sum x y : on_grid x -> on_grid y -> on_grid (x + y).
Proof. intros (m & ->) (n & ->); exists (m + n)%Z; rewrite plus_IZR; ring. Qed.

Theorem grid_minus x : on_grid x -> on_grid (- x).
Proof. intros (m & ->); exists (- m)%Z; rewrite opp_IZR; ring. Qed.

Theorem grid_round x : on_grid (rnd x).
Proof. apply doubles_are_on_grid, generic_format_round; typeclasses eauto. Qed.

Theorem grid_low x : on_grid x -> on_grid (low x).
Proof. intro; apply grid_sum; [assumption | apply grid_minus, grid_round]. Qed.

(* A product of doubles is on it if both are 0 or at least 2^-485, and then two_prod is exact. *)
Theorem grid_product x y : is_double x -> is_double y -> x = 0 \/ pow (-485) <= Rabs x ->
  y = 0 \/ pow (-485) <= Rabs y -> on_grid (x * y).
Proof.
assert (H : forall x, is_double x -> x = 0 \/ pow (-485) <= Rabs x ->
  exists m, x = IZR m * pow (-537)).
{ intros z D [-> | L]; [exists 0%Z; ring |].
  assert (K : (-484 <= mag radix2 z)%Z) by (apply mag_ge_bpow; exact L).
  red in D; set (n := Ztrunc _) in D; rewrite D; unfold F2R; cbn [Fnum Fexp].
  assert (C : (-537 <= cexp radix2 fexp z)%Z) by (unfold cexp, fexp, FLT_exp; lia).
  exists (n * 2 ^ (cexp radix2 fexp z + 537))%Z.
  rewrite mult_IZR, (IZR_Zpower radix2), Rmult_assoc by lia; rewrite <- bpow_plus.
  f_equal; f_equal; lia. }
intros X Y Lx Ly; destruct (H x X Lx) as (m & ->); destruct (H y Y Ly) as (n & ->).
exists (m * n)%Z; rewrite mult_IZR; change (-1074)%Z with (-537 + -537)%Z; rewrite bpow_plus; ring.
Qed.
