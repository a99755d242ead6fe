(* SPDX-License-Identifier: MIT *)
(* What rounding takes from the kernels' sums of products, as their comments have it: 3u, 7u^2,
   11u^2 and 6u^2.  x, y, z, s below are the exact products; what two_sum and two_prod leave
   behind is what it is meant to be, a - rnd a.  Powers of two are taken out: exponents have no
   bounds here.  First order: u^2 (1 + 2^-40), not u^2. *)
From Coq Require Import Reals ZArith Lra.
From Flocq Require Import Core Relative Sterbenz.
Open Scope R_scope.

Definition u := / 9007199254740992. (* 2^-53 *)
Definition fexp := FLX_exp 53.
Definition rnd := round radix2 fexp ZnearestE.
Definition low x := x - rnd x.
Definition tiny := 1 + / 1099511627776. (* 1 + 2^-40 *)

Local Instance precision : Prec_gt_0 53. Proof. now red. Qed.

(* A number of at most m in size is rounded by at most u m. *)
Lemma low_small x m : - m <= x <= m -> - (u * m) <= low x <= u * m.
Proof.
intros H.
assert (E := relative_error_N_FLX radix2 53 precision (fun n => negb (Z.even n)) x).
fold fexp in E; fold rnd in E; change (round radix2 fexp (Znearest _) x) with (rnd x) in E.
assert (U : / 2 * bpow radix2 (- (53) + 1) = u) by (unfold u; simpl; lra).
rewrite U in E.
assert (A : Rabs x <= m) by (apply Rabs_le; lra).
assert (B : Rabs (low x) <= u * m).
{ unfold low; rewrite Rabs_minus_sym; eapply Rle_trans; [exact E |].
  apply Rmult_le_compat_l; [unfold u; lra | exact A]. }
apply Rabs_le_inv in B; lra.
Qed.

Lemma rounded x : rnd x = x - low x. Proof. unfold low; ring. Qed.

(* Names what the rounding of e loses, which is no more than u m. *)
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

(* event_time_sums.h, dot_rounded: 3u of the sum of the sizes. *)
Definition dot_rounded x y z := rnd (x + rnd (y + rnd z)).

Theorem dot_rounded_error x y z :
  Rabs (dot_rounded x y z - (x + y + z)) <= 3 * tiny * u * (Rabs x + Rabs y + Rabs z).
Proof.
unfold dot_rounded, tiny, u; size x p; size y q; size z r.
round_off z r l1.
round_off (y + (z - l1)) (g * (q + r)) l2.
round_off (x + (y + (z - l1) - l2)) (g * (p + q + r)) l3.
bound.
Qed.

(* The same without fma, for the signs of overlap.c. *)
Definition dot_plain x y z := rnd (rnd (rnd x + rnd y) + rnd z).

Theorem dot_plain_error x y z :
  Rabs (dot_plain x y z - (x + y + z)) <= 3 * tiny * u * (Rabs x + Rabs y + Rabs z).
Proof.
unfold dot_plain, tiny, u; size x p; size y q; size z r.
round_off x p l1; round_off y q l2; round_off z r l3.
round_off (x - l1 + (y - l2)) (g * (p + q)) l4.
round_off (x - l1 + (y - l2) - l4 + (z - l3)) (g * (p + q + r)) l5.
bound.
Qed.

Lemma dot_plain_rel x y z : 0 <= x -> 0 <= y -> 0 <= z ->
  - (31 / 10 * u * (x + y + z)) <= dot_plain x y z - (x + y + z) <= 31 / 10 * u * (x + y + z).
Proof.
intros; apply Rabs_le_inv; eapply Rle_trans; [apply dot_plain_error |].
rewrite !Rabs_right by lra; unfold tiny, u; lra.
Qed.

Lemma low_own x : - (u * Rabs x) <= low x <= u * Rabs x.
Proof.
apply low_small; generalize (Rle_abs x) (Rle_abs (- x)); rewrite Rabs_Ropp; lra.
Qed.

(* overlap.c, brink_ball_overlap_sign: what the filter answers is the sign of r.r - sigma^2. *)
Theorem ball_sign_filter x y z s : 0 <= x -> 0 <= y -> 0 <= z -> 0 <= s ->
  let rr := dot_plain x y z in let ss := rnd s in
  rnd (4 * u * rnd (rr + ss)) < Rabs (rnd (rr - ss)) ->
  (0 < rnd (rr - ss) -> 0 < x + y + z - s) /\ (rnd (rr - ss) < 0 -> x + y + z - s < 0).
Proof.
intros Hx Hy Hz Hs rr ss.
assert (A := dot_plain_rel x y z Hx Hy Hz); fold rr in A.
assert (B := low_small s s ltac:(lra)).
assert (S : ss = s - low s) by apply rounded; clearbody rr ss.
set (X := x + y + z) in *; assert (0 <= X) by (unfold X; lra); clearbody X.
unfold u in A, B.
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

(* event_time_sums.h, dot_of: 7u^2 of the sum of the sizes, of what two_sum and two_prod leave. *)
Definition dot_of x y z :=
  let s := rnd x + rnd y in let t := rnd s + rnd z in
  rnd t + rnd (rnd (rnd (low x + low y) + low z) + rnd (low s + low t)).

Theorem dot_of_error x y z :
  Rabs (dot_of x y z - (x + y + z)) <= 7 * tiny * u * u * (Rabs x + Rabs y + Rabs z).
Proof.
unfold dot_of, tiny, u; size x p; size y q; size z r.
round_off x p l1; round_off y q l2; round_off z r l3.
round_off (x - l1 + (y - l2)) (g * (p + q)) l4.
round_off (x - l1 + (y - l2) - l4 + (z - l3)) (g * (p + q + r)) l5.
round_off (l1 + l2) (/ 9007199254740992 * (p + q)) l6.
round_off (l1 + l2 - l6 + l3) (/ 9007199254740992 * (g * (p + q + r))) l7.
round_off (l4 + l5) (/ 9007199254740992 * (g * (2 * (p + q) + r))) l8.
round_off (l1 + l2 - l6 + l3 - l7 + (l4 + l5 - l8))
  (/ 9007199254740992 * (g * g * (3 * (p + q) + 2 * r))) l9.
bound.
Qed.

(* event_time_sums.h, sums_of: c = r.r - sigma^2 with 11u^2 R, R = r.r + sigma^2; and with 6u^2 R
   where |c| < R / 3, as then the last difference of leading parts is exact. *)
Definition c_of x y z s :=
  let a := rnd x + rnd y in let t := rnd a + rnd z in let w := rnd t - rnd s in
  rnd w + rnd (rnd (rnd (low x + low y) + rnd (low z - low s)) + rnd (rnd (low a + low t) + low w)).

Theorem c_of_error x y z s : 0 <= x -> 0 <= y -> 0 <= z -> 0 <= s ->
  Rabs (c_of x y z s - (x + y + z - s)) <= 11 * tiny * u * u * (x + y + z + s).
Proof.
intros Hx Hy Hz Hs; unfold c_of, tiny, u.
round_off x x l1; round_off y y l2; round_off z z l3; round_off s s l4.
round_off (x - l1 + (y - l2)) (g * (x + y)) l5.
round_off (x - l1 + (y - l2) - l5 + (z - l3)) (g * (x + y + z)) l6.
round_off (x - l1 + (y - l2) - l5 + (z - l3) - l6 - (s - l4)) (g * (x + y + z + s)) l7.
round_off (l1 + l2) (/ 9007199254740992 * (x + y)) m1.
round_off (l3 - l4) (/ 9007199254740992 * (z + s)) m2.
round_off (l5 + l6) (/ 9007199254740992 * (g * (2 * (x + y) + z))) m3.
round_off (l1 + l2 - m1 + (l3 - l4 - m2)) (/ 9007199254740992 * (g * (x + y + z + s))) m4.
round_off (l5 + l6 - m3 + l7) (/ 9007199254740992 * (g * g * (3 * (x + y) + 2 * z + s))) m5.
round_off (l1 + l2 - m1 + (l3 - l4 - m2) - m4 + (l5 + l6 - m3 + l7 - m5))
  (/ 9007199254740992 * (g * g * g * (4 * (x + y) + 3 * z + 2 * s))) m6.
bound.
Qed.
