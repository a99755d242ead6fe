(* with: rounding.v *)
(* products: x y z s *)
(* SPDX-License-Identifier: MIT *)
(* The filters of the signs; what stands before 4u is exact there.  Powers of two are taken out:
   exponents have no bounds here. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding.
Open Scope R_scope.

(* overlap.c, brink_ball_overlap_sign: what the filter answers is the sign of r.r - sigma^2. *)
Definition ball_difference x y z s := rnd (dot_plain x y z - rnd s).
Definition ball_error x y z s := rnd (4 * u * rnd (dot_plain x y z + rnd s)).

Theorem ball_sign_filter x y z s : 0 <= x -> 0 <= y -> 0 <= z -> 0 <= s ->
  let f := ball_difference x y z s in ball_error x y z s < Rabs f ->
  (0 < f -> 0 < x + y + z - s) /\ (f < 0 -> x + y + z - s < 0).
Proof.
intros Hx Hy Hz Hs; unfold ball_error, ball_difference.
set (rr := dot_plain x y z); set (ss := rnd s).
assert (A := dot_plain_rel x y z Hx Hy Hz); fold rr in A.
assert (B := low_small s s ltac:(lra)).
assert (S : ss = s - low s) by apply rounded; clearbody rr ss.
set (X := x + y + z) in *; assert (0 <= X) by (unfold X; lra); clearbody X.
unfold u, tiny in A, B.
assert (C := low_small (rr + ss) (g * (X + s)) ltac:(lra)); unfold u in C.
rewrite (rounded (rr + ss)); set (l1 := low (rr + ss)) in *; clearbody l1.
assert (D := low_small (4 * u * (rr + ss - l1)) (5 * u * (X + s)) ltac:(unfold u; lra)).
rewrite (rounded (4 * u * (rr + ss - l1))).
set (l2 := low (4 * u * (rr + ss - l1))) in *; clearbody l2; unfold u in D |- *.
assert (E := low_own (rr - ss)); rewrite (rounded (rr - ss)).
set (l3 := low (rr - ss)) in *; clearbody l3; unfold u in E.
intro F; split; intro G; [rewrite Rabs_right in F by lra | rewrite Rabs_left in F by lra];
  revert E; unfold Rabs; destruct Rcase_abs; intro E; lra.
Qed.

(* overlap.c, brink_ball_overlap_rate_sign: likewise of x + y + z, products of either sign. *)
Definition rate_error x y z := rnd (4 * u * size_plain x y z).

Theorem rate_sign_filter x y z :
  rate_error x y z < Rabs (dot_plain x y z) ->
  (0 < dot_plain x y z -> 0 < x + y + z) /\ (dot_plain x y z < 0 -> x + y + z < 0).
Proof.
unfold rate_error; assert (E := dot_plain_error x y z); apply Rabs_le_inv in E.
set (f := dot_plain x y z) in *; clearbody f.
set (S := Rabs x + Rabs y + Rabs z) in *.
assert (N := size_plain_rel x y z); fold S in N.
assert (0 <= S) by (unfold S; generalize (Rabs_pos x) (Rabs_pos y) (Rabs_pos z); lra).
set (n := size_plain x y z) in *; clearbody n S; unfold u, tiny in *.
assert (D := low_small (4 * / 9007199254740992 * n) (5 / 9007199254740992 * S) ltac:(lra)).
rewrite (rounded (4 * / 9007199254740992 * n)).
set (l := low (4 * / 9007199254740992 * n)) in *; clearbody l; unfold u in D.
intro F; split; intro G; [rewrite Rabs_right in F by lra | rewrite Rabs_left in F by lra]; lra.
Qed.

(* overlap.c, brink_halfspace_overlap_sign: likewise of n.(r - c), its differences rounded. *)
Theorem plane_sign_filter n0 n1 n2 d0 d1 d2 : let x := n0 * rnd d0 in let y := n1 * rnd d1 in
  let z := n2 * rnd d2 in rnd (8 * u * size_plain x y z) < Rabs (dot_plain x y z) ->
  (0 < dot_plain x y z -> 0 < n0 * d0 + n1 * d1 + n2 * d2) /\
  (dot_plain x y z < 0 -> n0 * d0 + n1 * d1 + n2 * d2 < 0).
Proof.
intros x y z.
assert (A : forall n d, Rabs (n * d - n * rnd d) <= 2 * u * Rabs (n * rnd d)).
{ intros n d; replace (n * d - n * rnd d) with (n * low d) by (unfold low; ring).
  rewrite !Rabs_mult, (Rmult_comm (2 * u)), Rmult_assoc.
  apply Rmult_le_compat_l; [apply Rabs_pos |].
  assert (H := low_own d); rewrite (rounded d); set (l := low d) in *; clearbody l; revert H.
  unfold u, Rabs; repeat destruct Rcase_abs; lra. }
assert (X := A n0 d0); assert (Y := A n1 d1); assert (Z := A n2 d2); clear A.
fold x in X; fold y in Y; fold z in Z.
apply Rabs_le_inv in X; apply Rabs_le_inv in Y; apply Rabs_le_inv in Z.
set (F := n0 * d0 + n1 * d1 + n2 * d2).
assert (E := dot_plain_error x y z); apply Rabs_le_inv in E.
assert (N := size_plain_rel x y z); set (S := Rabs x + Rabs y + Rabs z) in *.
assert (- (6 * u * S) <= dot_plain x y z - F <= 6 * u * S).
{ unfold F, S, tiny, u in *.
  generalize (Rabs_pos x) (Rabs_pos y) (Rabs_pos z); intros; split; lra. }
assert (0 <= S) by (unfold S; generalize (Rabs_pos x) (Rabs_pos y) (Rabs_pos z); lra).
set (f := dot_plain x y z) in *; set (n := size_plain x y z) in *; clearbody f n F S.
clear X Y Z E; unfold u in *.
assert (D := low_small (8 * / 9007199254740992 * n) (9 / 9007199254740992 * S) ltac:(lra)).
rewrite (rounded (8 * / 9007199254740992 * n)).
set (l := low (8 * / 9007199254740992 * n)) in *; clearbody l; unfold u in D.
intro G; split; intro K; [rewrite Rabs_right in G by lra | rewrite Rabs_left in G by lra]; lra.
Qed.
