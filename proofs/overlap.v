(* with: underflow.v *)
(* products: x y z s *)
(* SPDX-License-Identifier: MIT *)
(* The filters of the signs, gradual underflow included: 4u and 8u of the sizes, and 2^-1000, are
   more than what rounding takes. *)
From Coq Require Import Reals Lra Lia.
From Flocq Require Import Core.
From Brink Require Import underflow.
Open Scope R_scope.

(* What underflows is nothing beside the absolute part: 2^75 eta. *)
Lemma floor_is : pow (-1000) = 37778931862957161709568 * eta.
Proof.
unfold eta; change 37778931862957161709568 with (pow 75); rewrite <- bpow_plus; reflexivity.
Qed.

(* overlap.c, brink_ball_overlap_sign: what the filter answers is the sign of r.r - sigma^2. *)
Definition ball_difference x y z s := rnd (dot_plain x y z - rnd s).
Definition ball_error x y z s :=
  rnd (rnd (4 * u * rnd (dot_plain x y z + rnd s)) + pow (-1000)).

Theorem ball_sign_filter x y z s : 0 <= x -> 0 <= y -> 0 <= z -> 0 <= s ->
  let f := ball_difference x y z s in ball_error x y z s < Rabs f ->
  (0 < f -> 0 < x + y + z - s) /\ (f < 0 -> x + y + z - s < 0).
Proof.
intros Hx Hy Hz Hs; unfold ball_error, ball_difference; rewrite floor_is.
assert (T := eta_pos); set (rr := dot_plain x y z); set (ss := rnd s).
assert (A := dot_plain_rel x y z Hx Hy Hz); fold rr in A.
assert (B := low_small s s ltac:(lra)).
assert (S : ss = s - low s) by apply rounded; clearbody rr ss.
set (X := x + y + z) in *; assert (0 <= X) by (unfold X; lra); clearbody X.
unfold u, tiny in *.
round_off (rr + ss) (g * (X + s) + 8 * eta) l1.
round_off (4 * / 9007199254740992 * (rr + ss - l1)) (5 / 9007199254740992 * (X + s) + eta) l2.
round_off (4 * / 9007199254740992 * (rr + ss - l1) - l2 + 37778931862957161709568 * eta)
  (6 / 9007199254740992 * (X + s) + 37778931862957161709570 * eta) l3.
assert (E := low_own (rr - ss)); rewrite (rounded (rr - ss)).
set (l4 := low (rr - ss)) in *; clearbody l4; unfold u in E.
intro F; split; intro G; [rewrite Rabs_right in F by lra | rewrite Rabs_left in F by lra];
  revert E; unfold Rabs; destruct Rcase_abs; intro E; lra.
Qed.

(* overlap.c, brink_ball_overlap_rate_sign: likewise of x + y + z, products of either sign. *)
Definition rate_error x y z := rnd (rnd (4 * u * size_plain x y z) + pow (-1000)).

Theorem rate_sign_filter x y z :
  rate_error x y z < Rabs (dot_plain x y z) ->
  (0 < dot_plain x y z -> 0 < x + y + z) /\ (dot_plain x y z < 0 -> x + y + z < 0).
Proof.
unfold rate_error; rewrite floor_is; assert (T := eta_pos).
assert (E := dot_plain_error x y z); apply Rabs_le_inv in E.
set (f := dot_plain x y z) in *; clearbody f.
assert (N := size_plain_rel x y z); set (S := Rabs x + Rabs y + Rabs z) in *; cbv zeta in N.
assert (0 <= S) by (unfold S; generalize (Rabs_pos x) (Rabs_pos y) (Rabs_pos z); lra).
set (n := size_plain x y z) in *; clearbody n S; unfold u, tiny in *.

round_off (4 * / 9007199254740992 * n) (5 / 9007199254740992 * S + eta) l1.
round_off (4 * / 9007199254740992 * n - l1 + 37778931862957161709568 * eta)
  (6 / 9007199254740992 * S + 37778931862957161709570 * eta) l2.
intro F; split; intro G; [rewrite Rabs_right in F by lra | rewrite Rabs_left in F by lra]; lra.
Qed.

(* overlap.c, brink_halfspace_overlap_sign: likewise of n.(r - c), its differences rounded. *)
Definition plane_sum n0 n1 n2 r0 r1 r2 c0 c1 c2 :=
  dot_plain (n0 * rnd (r0 - c0)) (n1 * rnd (r1 - c1)) (n2 * rnd (r2 - c2)).
Definition plane_error n0 n1 n2 r0 r1 r2 c0 c1 c2 :=
  rnd (rnd (8 * u * size_plain (n0 * rnd (r0 - c0)) (n1 * rnd (r1 - c1)) (n2 * rnd (r2 - c2))) +
    pow (-1000)).

Theorem plane_sign_filter n0 n1 n2 r0 r1 r2 c0 c1 c2 :
  is_double r0 -> is_double r1 -> is_double r2 -> is_double c0 -> is_double c1 -> is_double c2 ->
  let f := plane_sum n0 n1 n2 r0 r1 r2 c0 c1 c2 in
  let F := n0 * (r0 - c0) + n1 * (r1 - c1) + n2 * (r2 - c2) in
  plane_error n0 n1 n2 r0 r1 r2 c0 c1 c2 < Rabs f -> (0 < f -> 0 < F) /\ (f < 0 -> F < 0).
Proof.
intros R0 R1 R2 C0 C1 C2 f0 F0; unfold f0, F0, plane_sum, plane_error; clear f0 F0.
rewrite floor_is; assert (T := eta_pos).
assert (A : forall n r c, is_double r -> is_double c ->
  Rabs (n * (r - c) - n * rnd (r - c)) <= 2 * u * Rabs (n * rnd (r - c))).
{ intros n r c R C; replace (n * (r - c) - n * rnd (r - c)) with (n * low (r - c))
    by (unfold low; ring).
  rewrite !Rabs_mult, (Rmult_comm (2 * u)), Rmult_assoc.
  apply Rmult_le_compat_l; [apply Rabs_pos |].
  assert (H := low_difference r c R C); rewrite (rounded (r - c)).
  set (l := low (r - c)) in *; clearbody l; revert H; unfold u, Rabs.
  repeat destruct Rcase_abs; lra. }
assert (X := A n0 r0 c0 R0 C0); assert (Y := A n1 r1 c1 R1 C1); assert (Z := A n2 r2 c2 R2 C2).
clear A; set (x := n0 * rnd (r0 - c0)) in *; set (y := n1 * rnd (r1 - c1)) in *.
set (z := n2 * rnd (r2 - c2)) in *.
apply Rabs_le_inv in X; apply Rabs_le_inv in Y; apply Rabs_le_inv in Z.
set (F := n0 * (r0 - c0) + n1 * (r1 - c1) + n2 * (r2 - c2)).
assert (E := dot_plain_error x y z); apply Rabs_le_inv in E.
assert (N := size_plain_rel x y z); set (S := Rabs x + Rabs y + Rabs z) in *; cbv zeta in N.
assert (- (6 * u * S + 6 * eta) <= dot_plain x y z - F <= 6 * u * S + 6 * eta).
{ unfold F, S, tiny, u in *.
  generalize (Rabs_pos x) (Rabs_pos y) (Rabs_pos z); intros; split; lra. }
assert (0 <= S) by (unfold S; generalize (Rabs_pos x) (Rabs_pos y) (Rabs_pos z); lra).
set (f := dot_plain x y z) in *; set (n := size_plain x y z) in *; clearbody f n F S.
clear X Y Z E; unfold u in *.
round_off (8 * / 9007199254740992 * n) (9 / 9007199254740992 * S + eta) l1.
round_off (8 * / 9007199254740992 * n - l1 + 37778931862957161709568 * eta)
  (10 / 9007199254740992 * S + 37778931862957161709570 * eta) l2.
intro G; split; intro K; [rewrite Rabs_right in G by lra | rewrite Rabs_left in G by lra]; lra.
Qed.
