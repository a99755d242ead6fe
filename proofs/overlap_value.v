(* with: rounding.v overlap_estimate.v *)
(* SPDX-License-Identifier: MIT *)
(* overlap_value.c: its five estimates of overlaps and rates, now and at a later time, are off by
   2^-98 of their size before they are rounded; so values are within BRINK_OVERLAP_ULP 1 of the
   exact ones where is_precise lets them through, and signs are exact where is_certain does. *)
From Coq Require Import Reals ZArith Lra.
From Flocq Require Import Core.
From Brink Require Import rounding overlap_estimate.
Open Scope R_scope.

(* is_precise, where t stands for the absolute term. *)
Definition precise_from size t := rnd (pow43 * size + t).

Theorem precise_is_within_1_ulp w f size t : 0 <= size -> 0 <= t -> Rabs (w - f) <= pow98 * size ->
  precise_from size t < Rabs (rnd w) -> Rabs (rnd w - f) <= ulp f.
Proof. exact (precise w f size t). Qed.

(* is_certain. *)
Definition certain_from size t := rnd (pow97 * size + t).

Theorem certain_has_the_sign w f size t : 0 <= size -> 0 <= t -> Rabs (w - f) <= pow98 * size ->
  certain_from size t < Rabs (rnd w) -> (0 < rnd w -> 0 < f) /\ (rnd w < 0 -> f < 0).
Proof. exact (certain w f size t). Qed.

(* An estimate is the sum of its parts, rounded. *)
Definition value (parts : R * R) := rnd (total parts).

(* ball_now: r.r - sigma^2 *)
Definition ball_now_rr r0 r1 r2 :=
  gather (gather (two_prod r0 r0) (two_prod r1 r1)) (two_prod r2 r2).
Definition ball_now_parts r0 r1 r2 sigma :=
  gather (ball_now_rr r0 r1 r2) (two_prod (- sigma) sigma).
Definition ball_now_size r0 r1 r2 sigma :=
  rnd (fst (ball_now_rr r0 r1 r2) - fst (two_prod (- sigma) sigma)).

Theorem ball_now r0 r1 r2 sigma :
  Rabs (total (ball_now_parts r0 r1 r2 sigma) - (r0 * r0 + r1 * r1 + r2 * r2 - sigma * sigma)) <=
  pow98 * ball_now_size r0 r1 r2 sigma.
Proof.
unfold ball_now_parts; set (rr := ball_now_rr r0 r1 r2); set (s := two_prod (- sigma) sigma).
set (size := ball_now_size r0 r1 r2 sigma); change size with (rnd (fst rr - fst s)); clear size.
assert (P : forall x, 0 <= x -> near (rnd x, low x) x x (28 * u * u * x) (8 * u * x)).
{ intros x N; assert (H := low_small x x ltac:(lra)); unfold near, total; cbn [fst snd].
  rewrite rounded; unfold u in *; repeat split; lra. }
assert (X := Rle_0_sqr r0); assert (Y := Rle_0_sqr r1); assert (Z := Rle_0_sqr r2).
assert (S := Rle_0_sqr sigma); unfold Rsqr in *.
assert (T := three_near _ _ _ _ _ _ _ _ _ (P _ X) (P _ Y) (P _ Z)).
assert (N := two_prod_near (- sigma) sigma).
replace (- sigma * sigma) with (- (sigma * sigma)) in N by ring.
rewrite Rabs_Ropp, (Rabs_pos_eq _ S) in N.
apply (within _ _ _ _ (four_near _ _ _ _ _ _ T N)).
unfold s, two_prod; cbn [fst]; replace (- sigma * sigma) with (- (sigma * sigma)) by ring.
change (fst rr) with (dot_plain (r0 * r0) (r1 * r1) (r2 * r2)).
assert (D := dot_plain_rel _ _ _ X Y Z); set (d := dot_plain _ _ _) in *; clearbody d.
assert (M : rnd (- (sigma * sigma)) = - rnd (sigma * sigma)) by apply rnd_minus.
rewrite M; unfold tiny, u in D; set (q := r0 * r0 + r1 * r1 + r2 * r2) in *; clearbody q.
set (ss := sigma * sigma) in *; clearbody ss; assert (0 <= q) by lra.
clear - H S D; round_off ss ss l1; round_off (d - - (ss - l1)) (11 / 10 * (q + ss)) l2; lra.
Qed.

(* dot: r.v *)
Definition dot_parts r0 r1 r2 v0 v1 v2 :=
  gather (gather (two_prod r0 v0) (two_prod r1 v1)) (two_prod r2 v2).
Definition dot_size r0 r1 r2 v0 v1 v2 :=
  rnd (rnd (Rabs (rnd (r0 * v0)) + Rabs (rnd (r1 * v1))) + Rabs (rnd (r2 * v2))).

Theorem dot r0 r1 r2 v0 v1 v2 :
  Rabs (total (dot_parts r0 r1 r2 v0 v1 v2) - (r0 * v0 + r1 * v1 + r2 * v2)) <=
  pow98 * dot_size r0 r1 r2 v0 v1 v2.
Proof.
unfold dot_parts; set (size := dot_size r0 r1 r2 v0 v1 v2).
eapply three_within; try apply exact_near.
assert (N := size_plain_rel (r0 * v0) (r1 * v1) (r2 * v2)).
change (size_plain _ _ _) with size in N; unfold u in N.
generalize (Rabs_pos (r0 * v0)) (Rabs_pos (r1 * v1)) (Rabs_pos (r2 * v2)); lra.
Qed.

Lemma size_of_rounded n x : (1 - 2 * u) * Rabs (n * x) <= Rabs (n * rnd x).
Proof.
rewrite !Rabs_mult; assert (H := low_own x).
assert (G : (1 - 2 * u) * Rabs x <= Rabs (rnd x))
  by (rewrite (rounded x); revert H; unfold u, Rabs; repeat destruct Rcase_abs; lra).
apply Rmult_le_compat_l with (1 := Rabs_pos n) in G; lra.
Qed.

Lemma times_sum_near n a b : near (times n (two_sum a b)) (n * (a + b)) (Rabs (n * (a + b)))
  (28 * u * u * Rabs (n * (a + b))) (8 * u * Rabs (n * (a + b))).
Proof.
assert (H := low_own (a + b)); assert (P := Rabs_pos (a + b)).
assert (N : near (two_sum a b) (a + b) (Rabs (a + b)) (5 * u * u * Rabs (a + b))
  (3 * u * Rabs (a + b))).
{ unfold near, total, two_sum; cbn [fst snd]; rewrite (rounded (a + b)).
  size (a + b) q; unfold u in *; repeat split; lra. }
assert (Q := Rabs_pos (n * (a + b))).
assert (T := times_near n _ _ _ N); rewrite <- Rabs_mult in T.
apply (weaker _ _ _ _ _ _ _ T); unfold u; lra.
Qed.

(* plane_now: n.(r - c), and of sizes |n_i (r_i - c_i)|. *)
Definition now n r c := times n (two_sum r (- c)).
Definition plane_now_parts n0 n1 n2 r0 r1 r2 c0 c1 c2 :=
  gather (gather (now n0 r0 c0) (now n1 r1 c1)) (now n2 r2 c2).
Definition plane_now_size n0 n1 n2 r0 r1 r2 c0 c1 c2 :=
  rnd (rnd (Rabs (fst (now n0 r0 c0)) + Rabs (fst (now n1 r1 c1))) + Rabs (fst (now n2 r2 c2))).

Theorem plane_now n0 n1 n2 r0 r1 r2 c0 c1 c2 :
  Rabs (total (plane_now_parts n0 n1 n2 r0 r1 r2 c0 c1 c2) -
    (n0 * (r0 + - c0) + n1 * (r1 + - c1) + n2 * (r2 + - c2))) <=
  pow98 * plane_now_size n0 n1 n2 r0 r1 r2 c0 c1 c2.
Proof.
unfold plane_now_parts; set (size := plane_now_size n0 n1 n2 r0 r1 r2 c0 c1 c2).
eapply three_within; try apply times_sum_near.
assert (N := size_plain_rel (n0 * rnd (r0 + - c0)) (n1 * rnd (r1 + - c1)) (n2 * rnd (r2 + - c2))).
change (size_plain _ _ _) with size in N.
generalize (size_of_rounded n0 (r0 + - c0)) (size_of_rounded n1 (r1 + - c1))
  (size_of_rounded n2 (r2 + - c2)) (Rabs_pos (n0 * (r0 + - c0))) (Rabs_pos (n1 * (r1 + - c1)))
  (Rabs_pos (n2 * (r2 + - c2))); unfold u in *; lra.
Qed.

(* place_of: r + v t - c; little stands for 2^-960. *)
Definition place v r c t := gather (two_sum r (- c)) (two_prod v t).
Definition place_size v r c t little :=
  rnd (rnd (rnd (Rabs r + Rabs (rnd (v * t))) + Rabs c) + little).

Lemma place_near v r c t : let S := Rabs r + Rabs c + Rabs (v * t) in
  near (place v r c t) (r + - c + v * t) S (5 * u * u * S) (3 * u * S).
Proof.
intro S; generalize (Rabs_pos r) (Rabs_pos c) (Rabs_pos (v * t)); intros.
assert (A := two_sum_near r (- c)); assert (B := two_prod_near v t); rewrite Rabs_Ropp in A.
apply (weaker _ _ _ _ _ _ _ (gather_near _ _ _ _ _ _ _ _ _ _ A B ltac:(unfold u; lra)
  ltac:(unfold u; lra) ltac:(unfold u; lra) ltac:(unfold u; lra))); unfold S, u; lra.
Qed.

Lemma place_size_near v r c t little : 0 <= little ->
  let S := Rabs r + Rabs c + Rabs (v * t) in 0 <= S <= 1001 / 1000 * place_size v r c t little.
Proof.
intros L S; unfold place_size, S; assert (H := low_own (v * t)).
assert (G : (1 - 2 * u) * Rabs (v * t) <= Rabs (rnd (v * t)) <= 2 * Rabs (v * t))
  by (rewrite (rounded (v * t)); revert H; unfold u, Rabs; repeat destruct Rcase_abs; lra).
generalize (Rabs_pos r) (Rabs_pos c) (Rabs_pos (v * t)).
set (p := Rabs r); set (q := Rabs c); set (w := Rabs (v * t)) in *.
set (x := Rabs (rnd (v * t))) in *.
clearbody p q w x; clear H S; intros; unfold u in *.
round_off (p + x) (p + 2 * w) l1.
round_off (p + x - l1 + q) (2 * (p + q + 2 * w)) l2.
round_off (p + x - l1 + q - l2 + little) (4 * (p + q + 2 * w) + little) l3; lra.
Qed.

Lemma squares_le x y : 0 <= x <= y -> x * x <= y * y.
Proof. intros; apply Rmult_le_compat; lra. Qed.

(* ball: |r + v t|^2 - sigma^2 *)
Definition ball_parts r0 r1 r2 v0 v1 v2 sigma t :=
  gather (gather (gather (square (place v0 r0 0 t)) (square (place v1 r1 0 t)))
    (square (place v2 r2 0 t))) (two_prod (- sigma) sigma).
Definition ball_size r0 r1 r2 v0 v1 v2 sigma t little :=
  let sx := place_size v0 r0 0 t little in let sy := place_size v1 r1 0 t little in
  let sz := place_size v2 r2 0 t little in
  rnd (rnd (sx * sx + rnd (sy * sy + rnd (sz * sz))) - fst (two_prod (- sigma) sigma)).

Theorem ball r0 r1 r2 v0 v1 v2 sigma t little : 0 <= little ->
  let at_t r v := r + - 0 + v * t in
  Rabs (total (ball_parts r0 r1 r2 v0 v1 v2 sigma t) - (at_t r0 v0 * at_t r0 v0 +
    at_t r1 v1 * at_t r1 v1 + at_t r2 v2 * at_t r2 v2 - sigma * sigma)) <=
  pow98 * ball_size r0 r1 r2 v0 v1 v2 sigma t little.
Proof.
intros L at_t; unfold ball_parts, ball_size; cbv zeta.
set (x := place v0 r0 0 t); set (y := place v1 r1 0 t); set (z := place v2 r2 0 t).
set (sx := place_size v0 r0 0 t little); set (sy := place_size v1 r1 0 t little).
set (sz := place_size v2 r2 0 t little); set (s := two_prod (- sigma) sigma).
set (rr := gather (gather (square x) (square y)) (square z)).
set (size := rnd (_ - fst s)).
assert (X := square_near _ _ _ (place_near v0 r0 0 t)).
assert (Y := square_near _ _ _ (place_near v1 r1 0 t)).
assert (Z := square_near _ _ _ (place_near v2 r2 0 t)).
assert (SX := squares_le _ _ (place_size_near v0 r0 0 t little L)).
assert (SY := squares_le _ _ (place_size_near v1 r1 0 t little L)).
assert (SZ := squares_le _ _ (place_size_near v2 r2 0 t little L)).
fold x in X; fold y in Y; fold z in Z; fold sx in SX; fold sy in SY; fold sz in SZ.
fold (at_t r0 v0) in X; fold (at_t r1 v1) in Y; fold (at_t r2 v2) in Z.
set (S0 := Rabs r0 + Rabs 0 + Rabs (v0 * t)) in *.
set (S1 := Rabs r1 + Rabs 0 + Rabs (v1 * t)) in *.
set (S2 := Rabs r2 + Rabs 0 + Rabs (v2 * t)) in *.
assert (T := three_near _ _ _ _ _ _ _ _ _ X Y Z); fold rr in T.
assert (S := Rle_0_sqr sigma); unfold Rsqr in S.
assert (N := two_prod_near (- sigma) sigma).
replace (- sigma * sigma) with (- (sigma * sigma)) in N by ring.
rewrite Rabs_Ropp, (Rabs_pos_eq _ S) in N.
apply (within _ _ _ _ (four_near _ _ _ _ _ _ T N)).
unfold size, s, two_prod; cbn [fst]; replace (- sigma * sigma) with (- (sigma * sigma)) by ring.
assert (M : rnd (- (sigma * sigma)) = - rnd (sigma * sigma)) by apply rnd_minus.
rewrite M; clear - SX SY SZ S.
replace (1001 / 1000 * sx * (1001 / 1000 * sx)) with (1002001 / 1000000 * (sx * sx)) in SX
  by field.
replace (1001 / 1000 * sy * (1001 / 1000 * sy)) with (1002001 / 1000000 * (sy * sy)) in SY
  by field.
replace (1001 / 1000 * sz * (1001 / 1000 * sz)) with (1002001 / 1000000 * (sz * sz)) in SZ
  by field.
assert (A := Rle_0_sqr S0); assert (B := Rle_0_sqr S1); assert (C := Rle_0_sqr S2).
unfold Rsqr in *.
set (xx := sx * sx) in *; set (yy := sy * sy) in *; set (zz := sz * sz) in *.
set (ss := sigma * sigma) in *; set (a := S0 * S0) in *; set (b := S1 * S1) in *.
set (c := S2 * S2) in *; clearbody xx yy zz ss a b c.
round_off ss ss l0; round_off zz zz l1; round_off (yy + (zz - l1)) (2 * (yy + zz)) l2.
round_off (xx + (yy + (zz - l1) - l2)) (4 * (xx + yy + zz)) l3.
round_off (xx + (yy + (zz - l1) - l2) - l3 - - (ss - l0)) (8 * (xx + yy + zz + ss)) l4; lra.
Qed.

(* plane: n.(r + v t - c) *)
Definition plane_parts n0 n1 n2 r0 r1 r2 v0 v1 v2 c0 c1 c2 t :=
  gather (gather (times n0 (place v0 r0 c0 t)) (times n1 (place v1 r1 c1 t)))
    (times n2 (place v2 r2 c2 t)).
Definition plane_size n0 n1 n2 r0 r1 r2 v0 v1 v2 c0 c1 c2 t little :=
  let sx := place_size v0 r0 c0 t little in let sy := place_size v1 r1 c1 t little in
  let sz := place_size v2 r2 c2 t little in
  rnd (Rabs n0 * sx + rnd (Rabs n1 * sy + rnd (Rabs n2 * sz))).

Theorem plane n0 n1 n2 r0 r1 r2 v0 v1 v2 c0 c1 c2 t little : 0 <= little ->
  Rabs (total (plane_parts n0 n1 n2 r0 r1 r2 v0 v1 v2 c0 c1 c2 t) -
    (n0 * (r0 + - c0 + v0 * t) + n1 * (r1 + - c1 + v1 * t) + n2 * (r2 + - c2 + v2 * t))) <=
  pow98 * plane_size n0 n1 n2 r0 r1 r2 v0 v1 v2 c0 c1 c2 t little.
Proof.
intro L; unfold plane_parts, plane_size; cbv zeta.
set (x := place v0 r0 c0 t); set (y := place v1 r1 c1 t); set (z := place v2 r2 c2 t).
set (sx := place_size v0 r0 c0 t little); set (sy := place_size v1 r1 c1 t little).
set (sz := place_size v2 r2 c2 t little).
set (size := rnd (Rabs n0 * sx + _)).
assert (X := times_near n0 _ _ _ (place_near v0 r0 c0 t)).
assert (Y := times_near n1 _ _ _ (place_near v1 r1 c1 t)).
assert (Z := times_near n2 _ _ _ (place_near v2 r2 c2 t)).
destruct (place_size_near v0 r0 c0 t little L) as [PX SX].
destruct (place_size_near v1 r1 c1 t little L) as [PY SY].
destruct (place_size_near v2 r2 c2 t little L) as [PZ SZ].
fold x in X; fold y in Y; fold z in Z; fold sx in SX; fold sy in SY; fold sz in SZ.
set (S0 := Rabs r0 + _ + _) in *; set (S1 := Rabs r1 + _ + _) in *.
set (S2 := Rabs r2 + _ + _) in *.
apply Rmult_le_compat_l with (1 := Rabs_pos n0) in SX.
apply Rmult_le_compat_l with (1 := Rabs_pos n0) in PX.
apply Rmult_le_compat_l with (1 := Rabs_pos n1) in SY.
apply Rmult_le_compat_l with (1 := Rabs_pos n1) in PY.
apply Rmult_le_compat_l with (1 := Rabs_pos n2) in SZ.
apply Rmult_le_compat_l with (1 := Rabs_pos n2) in PZ.
rewrite Rmult_0_r in PX, PY, PZ.
eapply three_within.
- apply (weaker _ _ _ _ _ _ _ X); unfold u; lra.
- apply (weaker _ _ _ _ _ _ _ Y); unfold u; lra.
- apply (weaker _ _ _ _ _ _ _ Z); unfold u; lra.
- unfold size.
  replace (Rabs n0 * (1001 / 1000 * sx)) with (1001 / 1000 * (Rabs n0 * sx)) in SX by ring.
  replace (Rabs n1 * (1001 / 1000 * sy)) with (1001 / 1000 * (Rabs n1 * sy)) in SY by ring.
  replace (Rabs n2 * (1001 / 1000 * sz)) with (1001 / 1000 * (Rabs n2 * sz)) in SZ by ring.
  clear X Y Z; set (a := Rabs n0 * sx) in *; set (b := Rabs n1 * sy) in *.
  set (c := Rabs n2 * sz) in *.
  set (d := Rabs n0 * S0) in *; set (e := Rabs n1 * S1) in *; set (f := Rabs n2 * S2) in *.
  clearbody a b c d e f.
  round_off c c l1; round_off (b + (c - l1)) (2 * (b + c)) l2.
  round_off (a + (b + (c - l1) - l2)) (4 * (a + b + c)) l3; lra.
Qed.
