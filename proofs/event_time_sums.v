(* with: rounding.v *)
(* SPDX-License-Identifier: MIT *)
(* What rounding takes from the kernels' sums of products, as their comments have it: 3u, 7u^2,
   11u^2 and 6u^2.  x, y, z, s below are the exact products; what two_sum and two_prod leave
   behind is what it is meant to be, a - rnd a.  Powers of two are taken out: exponents have no
   bounds here.  First order: u^2 (1 + 2^-40), not u^2. *)
(* products: x y z s *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Export rounding.
Open Scope R_scope.

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

(* event_time_sums.h, is_far: c of a far pair is off by less than 4200u of itself, and r.r is less
   than 1026 c. *)
Definition least_far := 1025 / 1024. (* 1 + 2^-10 *)
Definition is_far rr ss := rnd (least_far * ss) < rr.

Theorem far_error x y z s : 0 <= x -> 0 <= y -> 0 <= z -> 0 <= s ->
  let rr := dot_plain x y z in let ss := rnd s in
  is_far rr ss ->
  Rabs (rnd (rr - ss) - (x + y + z - s)) <= 4200 * u * (x + y + z - s) /\
  x + y + z <= 1026 * (x + y + z - s).
Proof.
intros Hx Hy Hz Hs rr ss; unfold is_far.
assert (A := dot_plain_rel x y z Hx Hy Hz); fold rr in A.
assert (B := low_small s s ltac:(lra)).
assert (S : ss = s - low s) by apply rounded; clearbody rr ss.
set (X := x + y + z) in *; assert (0 <= X) by (unfold X; lra); clearbody X.
unfold u, tiny in A, B.
assert (C := low_small (least_far * ss) (1026 / 1024 * s) ltac:(unfold least_far; lra)).
rewrite (rounded (least_far * ss)); set (l1 := low (least_far * ss)) in *; clearbody l1.
unfold u, least_far in *; intro F.
assert (E := low_small (rr - ss) (1001 / 1000 * (X - s)) ltac:(lra)); unfold u in E.
rewrite (rounded (rr - ss)); set (l2 := low (rr - ss)) in *; clearbody l2.
split; [apply Rabs_le |]; lra.
Qed.

(* event_time_sums.h, passes: where the filter says that a far pair passes by, b^2 < a c of the
   exact a, b, c: A, B, C.  P is the sum of the sizes in b, and P^2 <= A r.r.  Of b <= 0: others
   part, and twice is 0. *)
Definition passes a b c :=
  let twice := 2 * b in rnd (twice * twice) < rnd ((4 - / 68719476736) * rnd (a * c)).

Theorem passes_filter a b c A B C P X : 0 < A -> 0 < C -> 0 <= P ->
  Rabs (a - A) <= 31 / 10 * u * A -> Rabs (b - B) <= 31 / 10 * u * P ->
  Rabs (c - C) <= 4200 * u * C -> X <= 1026 * C -> P * P <= A * X ->
  passes a b c -> B * B < A * C.
Proof.
unfold passes; intros HA HC HP Ha Hb Hc HX HQ.
apply Rabs_le_inv in Ha; apply Rabs_le_inv in Hc.
set (T := A * C); assert (HT : 0 < T) by (apply Rmult_lt_0_compat; assumption).
assert (Hac : 0 <= a * c <= (1 + 4300 * u) * T).
{ assert (0 <= a <= (1 + 31 / 10 * u) * A) by (unfold u in *; lra).
  assert (0 <= c <= (1 + 4200 * u) * C) by (unfold u in *; lra).
  split; [apply Rmult_le_pos; lra |].
  apply Rle_trans with ((1 + 31 / 10 * u) * A * ((1 + 4200 * u) * C)).
  - apply Rmult_le_compat; lra.
  - replace ((1 + 31 / 10 * u) * A * ((1 + 4200 * u) * C))
      with ((1 + 31 / 10 * u) * (1 + 4200 * u) * T) by (unfold T; ring).
    apply Rmult_le_compat_r; [lra | unfold u; lra]. }
assert (L := low_small (a * c) (2 * T) ltac:(unfold u in *; lra)).
rewrite (rounded (a * c)); set (l1 := low (a * c)) in *; clearbody l1.
set (m := (4 - / 68719476736) * (a * c - l1)).
assert (M := low_small m (5 * T) ltac:(unfold m, u in *; lra)).
rewrite (rounded m); set (l2 := low m) in *; clearbody l2; unfold m; clear m.
set (bb := b * b); replace (2 * b * (2 * b)) with (4 * bb) by (unfold bb; ring).
assert (N := low_own (4 * bb)); rewrite (rounded (4 * bb)).
assert (0 <= bb) by (unfold bb; apply Rle_0_sqr).
rewrite Rabs_right in N by lra.
set (l3 := low (4 * bb)) in *; clearbody l3; intro F.
assert (Hbb : bb <= (1 - / 549755813888) * T) by (unfold u in *; lra). (* 1 - 2^-39 *)
set (R := sqrt T); assert (HR : 0 < R) by (apply sqrt_lt_R0; exact HT).
assert (RR : R * R = T) by (apply sqrt_sqrt; lra).
assert (Hb1 : Rabs b <= R).
{ rewrite <- (Rabs_right R) by lra; apply Rsqr_le_abs_0; unfold Rsqr; fold bb; lra. }
assert (HP1 : P <= 33 * R).
{ apply Rsqr_incr_0_var; [| lra]; unfold Rsqr.
  replace (33 * R * (33 * R)) with (1089 * T) by (rewrite <- RR; ring).
  apply Rle_trans with (1 := HQ); apply Rle_trans with (A * (1026 * C)).
  - apply Rmult_le_compat_l; lra.
  - unfold T in *; lra. }
assert (HB : Rabs B <= Rabs b + 103 * u * R).
{ replace B with (b - (b - B)) by ring; eapply Rle_trans; [apply Rabs_triang |].
  rewrite Rabs_Ropp; unfold u in *; lra. }
assert (Rabs B * Rabs B <= (Rabs b + 103 * u * R) * (Rabs b + 103 * u * R)).
{ apply Rmult_le_compat; try apply Rabs_pos; assumption. }
assert (E1 : Rabs B * Rabs B = B * B)
  by (rewrite <- Rabs_mult; apply Rabs_right, Rle_ge, Rle_0_sqr).
assert (E2 : Rabs b * Rabs b = bb)
  by (rewrite <- Rabs_mult; apply Rabs_right, Rle_ge, Rle_0_sqr).
assert (E3 : Rabs b * R <= T) by (rewrite <- RR; apply Rmult_le_compat_r; lra).
assert (E4 : (Rabs b + 103 * u * R) * (Rabs b + 103 * u * R) =
   bb + 206 * u * (Rabs b * R) + 10609 * u * u * T) by (rewrite <- E2, <- RR; ring).
unfold u in *; lra.
Qed.

(* sums_of again: 6u^2 R where |c| < R / 3. *)
Theorem c_of_error_near x y z s : 0 <= x -> 0 <= y -> 0 <= z -> 0 <= s ->
  let R := x + y + z + s in 3 * Rabs (x + y + z - s) <= (1 - / 1000000) * R ->
  Rabs (c_of x y z s - (x + y + z - s)) <= 6 * tiny * u * u * R.
Proof.
intros Hx Hy Hz Hs R N; unfold R in *; clear R; unfold c_of, tiny, u.
assert (NN : x + y + z <= 2 * s * (9999999 / 10000000) /\
             s <= 2 * (x + y + z) * (9999999 / 10000000))
  by (revert N; unfold Rabs; destruct Rcase_abs; lra); clear N.
assert (W : low (rnd (rnd (rnd x + rnd y) + rnd z) - rnd s) = 0).
{ apply exact_difference; try (apply generic_format_round; typeclasses eauto).
  round_off x x l1; round_off y y l2; round_off z z l3; round_off s s l4.
  round_off (x - l1 + (y - l2)) (g * (x + y)) l5.
  round_off (x - l1 + (y - l2) - l5 + (z - l3)) (g * (x + y + z)) l6; lra. }
rewrite W, (rounded (rnd (rnd (rnd x + rnd y) + rnd z) - rnd s)), W, Rplus_0_r, rnd_rnd; clear W.
round_off x x l1; round_off y y l2; round_off z z l3; round_off s s l4.
round_off (x - l1 + (y - l2)) (g * (x + y)) l5.
round_off (x - l1 + (y - l2) - l5 + (z - l3)) (g * (x + y + z)) l6.
round_off (l1 + l2) (/ 9007199254740992 * (x + y)) m1.
round_off (l3 - l4) (/ 9007199254740992 * (z + s)) m2.
round_off (l5 + l6) (/ 9007199254740992 * (g * (2 * (x + y) + z))) m3.
round_off (l1 + l2 - m1 + (l3 - l4 - m2)) (/ 9007199254740992 * (g * (x + y + z + s))) m4.
round_off (l1 + l2 - m1 + (l3 - l4 - m2) - m4 + (l5 + l6 - m3))
  (/ 9007199254740992 * (g * g * (3 * (x + y) + 2 * z + s))) m5.
bound.
Qed.

(* event_time_parting.h, near_sums_of: before it is rounded to one double, c is off by 7u^2 R
   where |c| < R / 3. *)
Definition near_c x y z s :=
  let a := rnd x + rnd y in let t := rnd a + rnd z in
  let rest := rnd (rnd (rnd (low x + low y) + low z) + rnd (low a + low t)) in
  rnd (rnd t - rnd s) + rnd (rest - low s).

Theorem near_c_error x y z s : 0 <= x -> 0 <= y -> 0 <= z -> 0 <= s ->
  let R := x + y + z + s in 3 * Rabs (x + y + z - s) <= (1 - / 1000000) * R ->
  Rabs (near_c x y z s - (x + y + z - s)) <= 7 * tiny * u * u * R.
Proof.
intros Hx Hy Hz Hs R N; unfold R in *; clear R; unfold near_c, tiny, u.
assert (NN : x + y + z <= 2 * s * (9999999 / 10000000) /\
             s <= 2 * (x + y + z) * (9999999 / 10000000))
  by (revert N; unfold Rabs; destruct Rcase_abs; lra); clear N.
assert (W : low (rnd (rnd (rnd x + rnd y) + rnd z) - rnd s) = 0).
{ apply exact_difference; try (apply generic_format_round; typeclasses eauto).
  round_off x x l1; round_off y y l2; round_off z z l3; round_off s s l4.
  round_off (x - l1 + (y - l2)) (g * (x + y)) l5.
  round_off (x - l1 + (y - l2) - l5 + (z - l3)) (g * (x + y + z)) l6; lra. }
rewrite (rounded (rnd (rnd (rnd x + rnd y) + rnd z) - rnd s)), W; clear W.
round_off x x l1; round_off y y l2; round_off z z l3; round_off s s l4.
round_off (x - l1 + (y - l2)) (g * (x + y)) l5.
round_off (x - l1 + (y - l2) - l5 + (z - l3)) (g * (x + y + z)) l6.
round_off (l1 + l2) (/ 9007199254740992 * (x + y)) m1.
round_off (l1 + l2 - m1 + l3) (/ 9007199254740992 * (g * (x + y + z))) m2.
round_off (l5 + l6) (/ 9007199254740992 * (g * (2 * (x + y) + z))) m3.
round_off (l1 + l2 - m1 + l3 - m2 + (l5 + l6 - m3))
  (/ 9007199254740992 * (g * g * (3 * (x + y) + 2 * z))) m4.
round_off (l1 + l2 - m1 + l3 - m2 + (l5 + l6 - m3) - m4 - l4)
  (/ 9007199254740992 * (g * g * g * (3 * (x + y) + 2 * z + s))) m5.
bound.
Qed.

(* And otherwise by that difference's rounding, u of itself. *)
Theorem near_c_error_large x y z s : 0 <= x -> 0 <= y -> 0 <= z -> 0 <= s ->
  let C := x + y + z - s in x + y + z + s <= 4 * Rabs C ->
  Rabs (near_c x y z s - C) <= 1001 / 1000 * u * Rabs C.
Proof.
intros Hx Hy Hz Hs C N; unfold near_c, u; size C q; unfold C in *.
round_off x x l1; round_off y y l2; round_off z z l3; round_off s s l4.
round_off (x - l1 + (y - l2)) (g * (x + y)) l5.
round_off (x - l1 + (y - l2) - l5 + (z - l3)) (g * (x + y + z)) l6.
round_off (x - l1 + (y - l2) - l5 + (z - l3) - l6 - (s - l4)) (g * q) l7.
round_off (l1 + l2) (/ 9007199254740992 * (x + y)) m1.
round_off (l1 + l2 - m1 + l3) (/ 9007199254740992 * (g * (x + y + z))) m2.
round_off (l5 + l6) (/ 9007199254740992 * (g * (2 * (x + y) + z))) m3.
round_off (l1 + l2 - m1 + l3 - m2 + (l5 + l6 - m3))
  (/ 9007199254740992 * (g * g * (3 * (x + y) + 2 * z))) m4.
round_off (l1 + l2 - m1 + l3 - m2 + (l5 + l6 - m3) - m4 - l4)
  (/ 9007199254740992 * (g * g * g * (3 * (x + y) + 2 * z + s))) m5.
bound.
Qed.
