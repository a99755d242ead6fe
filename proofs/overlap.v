(* with: event_time_sums.v *)
(* products: x y z s *)
(* SPDX-License-Identifier: MIT *)
(* The filters of the signs; what stands before 4u is exact there.  Powers of two are taken out:
   exponents have no bounds here. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import event_time_sums.
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
Definition size_plain x y z := rnd (rnd (Rabs (rnd x) + Rabs (rnd y)) + Rabs (rnd z)).

Definition rate_error x y z := rnd (4 * u * size_plain x y z).

Theorem rate_sign_filter x y z :
  rate_error x y z < Rabs (dot_plain x y z) ->
  (0 < dot_plain x y z -> 0 < x + y + z) /\ (dot_plain x y z < 0 -> x + y + z < 0).
Proof.
unfold rate_error; assert (E := dot_plain_error x y z); apply Rabs_le_inv in E.
set (f := dot_plain x y z) in *; clearbody f.
set (S := Rabs x + Rabs y + Rabs z) in *.
assert (N : (1 - 4 * u) * S <= size_plain x y z <= (1 + 4 * u) * S).
{ assert (A : forall t, (1 - u) * Rabs t <= Rabs (rnd t) <= (1 + u) * Rabs t).
  { intro t; assert (L := low_own t); rewrite (rounded t); revert L.
    unfold u, Rabs; repeat destruct Rcase_abs; lra. }
  unfold size_plain, S; assert (X := A x); assert (Y := A y); assert (Z := A z).
  set (p := Rabs (rnd x)) in *; set (q := Rabs (rnd y)) in *; set (r := Rabs (rnd z)) in *.
  assert (0 <= Rabs x) by apply Rabs_pos; assert (0 <= Rabs y) by apply Rabs_pos.
  assert (0 <= Rabs z) by apply Rabs_pos.
  set (a := Rabs x) in *; set (b := Rabs y) in *; set (c := Rabs z) in *.
  clearbody p q r a b c; clear - X Y Z H H0 H1; unfold u in *.
  round_off (p + q) (g * (a + b)) l1.
  round_off (p + q - l1 + r) (g * (a + b + c)) l2; lra. }
assert (0 <= S) by (unfold S; generalize (Rabs_pos x) (Rabs_pos y) (Rabs_pos z); lra).
set (n := size_plain x y z) in *; clearbody n S; unfold u, tiny in *.
assert (D := low_small (4 * / 9007199254740992 * n) (5 / 9007199254740992 * S) ltac:(lra)).
rewrite (rounded (4 * / 9007199254740992 * n)).
set (l := low (4 * / 9007199254740992 * n)) in *; clearbody l; unfold u in D.
intro F; split; intro G; [rewrite Rabs_right in F by lra | rewrite Rabs_left in F by lra]; lra.
Qed.
