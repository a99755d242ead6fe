(* with: rounding.v event_time_sums.v *)
(* SPDX-License-Identifier: MIT *)
(* event_time_sums.h, discriminant_of: d = b^2 - a c of a, b, c as unevaluated sums of two doubles.
   Q = A R >= P^2, P = sum |r_i v_i|, R = r.r + sigma^2.  Unbounded exponents. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding event_time_sums.
Open Scope R_scope.

(* The discriminant as it is computed: what comes before its last two roundings, *)
Definition rest_of ah al bh bl ch cl :=
  rnd (2 * bh * bl + rnd (rnd (low (bh * bh) - low (ah * ch)) - rnd (ah * cl + rnd (al * ch)))).
(* and all of it. *)
Definition discriminant_of ah al bh bl ch cl :=
  rnd (rnd (rnd (bh * bh) - rnd (ah * ch)) + rest_of ah al bh bl ch cl).

(* What is known of a, b, c: their leading parts to a few u, and what the second parts make good. *)
Section Discriminant.
Variables A B C P R ah al bh bl ch cl : R.
Hypotheses (HA : 0 <= A) (HR : 0 <= R) (HP : 0 <= P) (PQ : P * P <= A * R).
Hypotheses (HB : - P <= B <= P) (HC : - R <= C <= R).
Hypotheses (Ha : - (31 / 10 * u * A) <= ah - A <= 31 / 10 * u * A)
  (Ha2 : - (71 / 10 * u * u * A) <= ah + al - A <= 71 / 10 * u * u * A).
Hypotheses (Hb : - (31 / 10 * u * P) <= bh - B <= 31 / 10 * u * P)
  (Hb2 : - (71 / 10 * u * u * P) <= bh + bl - B <= 71 / 10 * u * u * P).
Hypotheses (Hc : - (5 * u * R) <= ch - C <= 5 * u * R)
  (Hc2 : - (111 / 10 * u * u * R) <= ch + cl - C <= 111 / 10 * u * u * R).

Let D := B * B - A * C.
Let Q := A * R.

(* What is left over of the leading parts is off by less than 150u^2 Q, and less than 20u Q. *)
Lemma rest_error :
  - (150 * u * u * Q) <= bh * bh - low (bh * bh) - (ah * ch - low (ah * ch)) +
    rest_of ah al bh bl ch cl - D <= 150 * u * u * Q /\
  - (20 * u * Q) <= rest_of ah al bh bl ch cl <= 20 * u * Q.
Proof.
unfold u in *; set (v := / 9007199254740992) in *.
assert (V : v = / 9007199254740992) by reflexivity; clearbody v.
set (ea := ah + al - A) in *; set (eb := bh + bl - B) in *; set (ec := ch + cl - C) in *.
assert (Ba : - (g * A) <= ah <= g * A) by (subst v; lra).
assert (Bb : - (g * P) <= bh <= g * P) by (subst v; lra).
assert (Bc : - (g * R) <= ch <= g * R) by (subst v; lra).
assert (La : - (32 / 10 * v * A) <= al <= 32 / 10 * v * A) by (subst ea v; lra).
assert (Lb : - (32 / 10 * v * P) <= bl <= 32 / 10 * v * P) by (subst eb v; lra).
assert (Lc : - (51 / 10 * v * R) <= cl <= 51 / 10 * v * R) by (subst ec v; lra).
assert (P1 := product _ _ _ _ Bb Bb); assert (P2 := product _ _ _ _ Ba Bc).
assert (P3 := product _ _ _ _ Bb Lb); assert (P4 := product _ _ _ _ Ba Lc).
assert (P5 := product _ _ _ _ La Bc); assert (P6 := product _ _ _ _ Lb Lb).
assert (P7 := product _ _ _ _ La Lc).
assert (P8 := product eb (bh + bl + B) _ (3 * P) Hb2 ltac:(subst v; lra)).
assert (P9 := product ea C _ _ Ha2 HC).
assert (P10 := product (ah + al) ec (11 / 10 * A) _ ltac:(subst ea v; lra) Hc2).
assert (E : D = bh * bh + 2 * bh * bl + bl * bl - eb * (bh + bl + B)
  - (ah * ch + ah * cl + al * ch + al * cl) + ea * C + (ah + al) * ec)
  by (unfold D, ea, eb, ec; ring).
clearbody D; subst D; unfold Q; clear - P1 P2 P3 P4 P5 P6 P7 P8 P9 P10 PQ V.
set (t1 := eb * (bh + bl + B)) in *; set (t2 := ea * C) in *; set (t3 := (ah + al) * ec) in *.
unfold rest_of; replace (2 * bh * bl) with (2 * (bh * bl)) by ring.
set (bb := bh * bh) in *; set (ac := ah * ch) in *; set (bl2 := bh * bl) in *.
set (m1 := ah * cl) in *; set (m2 := al * ch) in *; set (m3 := bl * bl) in *.
set (m4 := al * cl) in *.
set (Q := A * R) in *; set (PP := P * P) in *.
replace (g * P * (g * P)) with (g * g * PP) in P1 by (unfold PP; ring).
replace (g * A * (g * R)) with (g * g * Q) in P2 by (unfold Q; ring).
replace (g * P * (32 / 10 * v * P)) with (g * 32 / 10 * v * PP) in P3 by (unfold PP; field).
replace (g * A * (51 / 10 * v * R)) with (g * 51 / 10 * v * Q) in P4 by (unfold Q; field).
replace (32 / 10 * v * A * (g * R)) with (g * 32 / 10 * v * Q) in P5 by (unfold Q; field).
replace (32 / 10 * v * P * (32 / 10 * v * P)) with (1024 / 100 * v * v * PP) in P6
  by (unfold PP; field).
replace (32 / 10 * v * A * (51 / 10 * v * R)) with (1632 / 100 * v * v * Q) in P7
  by (unfold Q; field).
replace (71 / 10 * v * v * P * (3 * P)) with (213 / 10 * v * v * PP) in P8 by (unfold PP; field).
replace (71 / 10 * v * v * A * R) with (71 / 10 * v * v * Q) in P9 by (unfold Q; field).
replace (11 / 10 * A * (111 / 10 * v * v * R)) with (1221 / 100 * v * v * Q) in P10
  by (unfold Q; field).
clearbody t1 t2 t3 bb ac bl2 m1 m2 m3 m4 Q PP; subst v.
assert (0 <= Q) by lra.
round_off bb (g * g * g * Q) l1; round_off ac (g * g * g * Q) l2.
round_off m2 (33 / 10 / 9007199254740992 * Q) l3.
round_off (m1 + (m2 - l3)) (85 / 10 / 9007199254740992 * Q) l4.
round_off (l1 - l2) (21 / 10 / 9007199254740992 * Q) l5.
round_off (l1 - l2 - l5 - (m1 + (m2 - l3) - l4)) (11 / 9007199254740992 * Q) l6.
round_off (2 * bl2 + (l1 - l2 - l5 - (m1 + (m2 - l3) - l4) - l6)) (18 / 9007199254740992 * Q) l7.
split; lra.
Qed.

Lemma size_of_difference : 0 <= Q /\ - (2 * Q) <= D <= 2 * Q.
Proof.
assert (0 <= P * P) by apply Rle_0_sqr.
assert (H1 := product _ _ _ _ HB HB).
assert (H2 := product A C A R ltac:(lra) HC); unfold D, Q; lra.
Qed.

(* d is off by 2 roundings of itself, and 200u^2 Q: *)
Lemma discriminant_error :
  let d := discriminant_of ah al bh bl ch cl in
  Rabs (d - D) <= 2001 / 1000 * u * Rabs D + 200 * u * u * Q.
Proof.
destruct rest_error as [E S]; destruct size_of_difference as [HQ HD].
unfold discriminant_of; cbv zeta; rewrite (rounded (bh * bh)), (rounded (ah * ch)).
set (rest := rest_of ah al bh bl ch cl) in *.
set (x := bh * bh - low (bh * bh) - (ah * ch - low (ah * ch))) in *.
clearbody rest x D Q; clear - E S HQ HD; unfold u in *; size D z.
round_off x (z + 21 / 9007199254740992 * Q) l1.
round_off (x - l1 + rest) (10000000001 / 10000000000 * z + 22 / 9007199254740992 * Q) l2.
bound.
Qed.
End Discriminant.

(* Where d is larger than what it is compared with, 2^-44 Q and an absolute term, it is within 2.4u;
   and where it is less than -2^-90 Q the exact one is negative. *)
Theorem certain_discriminant A B C P R ah al bh bl ch cl size t :
  0 <= A -> 0 <= R -> 0 <= P -> P * P <= A * R -> - P <= B <= P -> - R <= C <= R ->
  - (31 / 10 * u * A) <= ah - A <= 31 / 10 * u * A ->
  - (71 / 10 * u * u * A) <= ah + al - A <= 71 / 10 * u * u * A ->
  - (31 / 10 * u * P) <= bh - B <= 31 / 10 * u * P ->
  - (71 / 10 * u * u * P) <= bh + bl - B <= 71 / 10 * u * u * P ->
  - (5 * u * R) <= ch - C <= 5 * u * R ->
  - (111 / 10 * u * u * R) <= ch + cl - C <= 111 / 10 * u * u * R ->
  - (5 * u * R) <= size - R <= 5 * u * R -> 0 <= t ->
  let d := discriminant_of ah al bh bl ch cl in let D := B * B - A * C in
  (rnd (/ 17592186044416 * ah * size + t) < d -> (* 2^-44 *)
    0 < D /\ A * R <= 2 * 17592186044416 * D /\ Rabs (d - D) <= 24 / 10 * u * D) /\
  (d < - rnd (/ 1237940039285380274899124224 * rnd (ah * size) + t) -> (* 2^-90 *)
    D < 0).
Proof.
intros HA HR HP PQ HB HC Ha Ha2 Hb Hb2 Hc Hc2 Hs Ht d D.
assert (Er := discriminant_error A B C P R ah al bh bl ch cl HA HR HP PQ HB HC Ha Ha2 Hb Hb2
  Hc Hc2).
destruct (size_of_difference A B C P R HA PQ HB HC) as [HQ _].
cbv zeta in Er; fold d D in Er; set (Q := A * R) in *.
assert (L : (1 - 9 * u) * Q <= ah * size).
{ apply Rle_trans with ((1 - 31 / 10 * u) * A * ((1 - 5 * u) * R)).
  - replace ((1 - 31 / 10 * u) * A * ((1 - 5 * u) * R))
      with ((1 - 31 / 10 * u) * (1 - 5 * u) * Q) by (unfold Q; ring).
    apply Rmult_le_compat_r; [exact HQ | unfold u; lra].
  - apply Rmult_le_compat; try (apply Rmult_le_pos; [unfold u; lra | assumption]);
      unfold u in *; lra. }
apply Rabs_le_inv in Er.
replace (/ 17592186044416 * ah * size) with (/ 17592186044416 * (ah * size)) by ring.
set (as_ := ah * size) in *; clearbody as_ Q D d; clear - HQ L Er Ht; unfold u in *.
assert (0 <= as_) by lra.
assert (M := low_own as_); rewrite (rounded as_).
assert (M1 := low_own (/ 17592186044416 * as_ + t)); rewrite (rounded (_ + _)).
set (l1 := low (/ 17592186044416 * as_ + t)) in *.
set (l2 := low as_) in *; clearbody l1 l2; unfold u in *.
rewrite Rabs_pos_eq in M, M1 by lra.
assert (M2 := low_own (/ 1237940039285380274899124224 * (as_ - l2) + t)); rewrite (rounded (_ + _)).
set (l3 := low _) in *; clearbody l3; unfold u in *.
rewrite Rabs_pos_eq in M2 by lra.
split; intro Big; revert Er; unfold Rabs; repeat destruct Rcase_abs; repeat split; lra.
Qed.

(* Cauchy and Schwarz, of the sizes of the products. *)
Lemma product_of_sums a b c x y z :
  (Rabs (a * x) + Rabs (b * y) + Rabs (c * z)) * (Rabs (a * x) + Rabs (b * y) + Rabs (c * z)) <=
  (x * x + y * y + z * z) * (a * a + b * b + c * c).
Proof.
rewrite !Rabs_mult; assert (S : forall t, t * t = Rabs t * Rabs t).
{ intro t; rewrite <- Rabs_mult, Rabs_pos_eq; [ring | apply Rle_0_sqr]. }
rewrite (S a), (S b), (S c), (S x), (S y), (S z).
set (p := Rabs a); set (q := Rabs b); set (r := Rabs c).
set (k := Rabs x); set (l := Rabs y); set (m := Rabs z).
assert (H1 := Rle_0_sqr (p * l - q * k)); assert (H2 := Rle_0_sqr (p * m - r * k)).
assert (H3 := Rle_0_sqr (q * m - r * l)); unfold Rsqr in *.
assert (E : (k * k + l * l + m * m) * (p * p + q * q + r * r) -
  (p * k + q * l + r * m) * (p * k + q * l + r * m) = (p * l - q * k) * (p * l - q * k) +
  (p * m - r * k) * (p * m - r * k) + (q * m - r * l) * (q * m - r * l)) by ring.
lra.
Qed.

Lemma leading_c x y z s : 0 <= x -> 0 <= y -> 0 <= z -> 0 <= s ->
  - (5 * u * (x + y + z + s)) <= rnd (dot_plain x y z - rnd s) - (x + y + z - s) <=
    5 * u * (x + y + z + s) /\
  - (5 * u * (x + y + z + s)) <= rnd (dot_plain x y z + rnd s) - (x + y + z + s) <=
    5 * u * (x + y + z + s).
Proof.
intros X Y Z S; assert (H := dot_plain_rel x y z X Y Z).
set (rr := dot_plain x y z) in *; clearbody rr; unfold tiny, u in *.
round_off s s l1.
round_off (rr - (s - l1)) (g * (x + y + z + s)) l2.
round_off (rr + (s - l1)) (g * (x + y + z + s)) l3; split; lra.
Qed.

(* All of it for a pair: what sums_of hands to discriminant_of. *)
Theorem discriminant_of_pair r0 r1 r2 v0 v1 v2 sigma t : 0 <= t ->
  let A := v0 * v0 + v1 * v1 + v2 * v2 in let B := r0 * v0 + r1 * v1 + r2 * v2 in
  let rr := r0 * r0 + r1 * r1 + r2 * r2 in let ss := sigma * sigma in
  let D := B * B - A * (rr - ss) in
  let ah := dot_plain (v0 * v0) (v1 * v1) (v2 * v2) in
  let al := dot_of (v0 * v0) (v1 * v1) (v2 * v2) - ah in
  let bh := dot_plain (r0 * v0) (r1 * v1) (r2 * v2) in
  let bl := dot_of (r0 * v0) (r1 * v1) (r2 * v2) - bh in
  let rh := dot_plain (r0 * r0) (r1 * r1) (r2 * r2) in let ch := rnd (rh - rnd ss) in
  let cl := c_of (r0 * r0) (r1 * r1) (r2 * r2) ss - ch in let size := rnd (rh + rnd ss) in
  let d := discriminant_of ah al bh bl ch cl in
  (rnd (/ 17592186044416 * ah * size + t) < d ->
    0 < D /\ A * (rr + ss) <= 2 * 17592186044416 * D /\ Rabs (d - D) <= 24 / 10 * u * D) /\
  (d < - rnd (/ 1237940039285380274899124224 * rnd (ah * size) + t) -> D < 0).
Proof.
intros Ht A B rr ss D ah al bh bl rh ch cl size d.
assert (X := Rle_0_sqr r0); assert (Y := Rle_0_sqr r1); assert (Z := Rle_0_sqr r2).
assert (X' := Rle_0_sqr v0); assert (Y' := Rle_0_sqr v1); assert (Z' := Rle_0_sqr v2).
assert (S := Rle_0_sqr sigma); unfold Rsqr in *.
set (P := Rabs (r0 * v0) + Rabs (r1 * v1) + Rabs (r2 * v2)).
assert (0 <= P) by (unfold P; generalize (Rabs_pos (r0 * v0)) (Rabs_pos (r1 * v1))
  (Rabs_pos (r2 * v2)); lra).
destruct (leading_c _ _ _ _ X Y Z S) as [Hc Hs]; fold rh in Hc, Hs; fold ss in Hc, Hs.
assert (Ha := dot_plain_rel _ _ _ X' Y' Z').
assert (Ha2 := dot_of_error (v0 * v0) (v1 * v1) (v2 * v2)); apply Rabs_le_inv in Ha2.
rewrite !Rabs_pos_eq in Ha2 by assumption.
assert (Hb := dot_plain_error (r0 * v0) (r1 * v1) (r2 * v2)); apply Rabs_le_inv in Hb.
assert (Hb2 := dot_of_error (r0 * v0) (r1 * v1) (r2 * v2)); apply Rabs_le_inv in Hb2.
assert (Hc2 := c_of_error _ _ _ _ X Y Z S); apply Rabs_le_inv in Hc2; fold ss in Hc2.
fold P in Hb, Hb2.
assert (CS := product_of_sums r0 r1 r2 v0 v1 v2); fold P A in CS.
assert (0 <= A) by (unfold A; lra).
assert (A * rr <= A * (rr + ss)) by (apply Rmult_le_compat_l; unfold ss; lra).
apply (certain_discriminant A B (rr - ss) P (rr + ss) ah al bh bl ch cl size t);
  unfold tiny, u in *; try assumption; try (unfold rr, ss; lra).
- fold rr in CS; lra.
- unfold B, P; generalize (Rle_abs (r0 * v0)) (Rle_abs (r1 * v1)) (Rle_abs (r2 * v2))
    (Rle_abs (- (r0 * v0))) (Rle_abs (- (r1 * v1))) (Rle_abs (- (r2 * v2))).
  rewrite !Rabs_Ropp; lra.
- unfold A, ah; lra.
- unfold al; replace (ah + (dot_of (v0 * v0) (v1 * v1) (v2 * v2) - ah))
    with (dot_of (v0 * v0) (v1 * v1) (v2 * v2)) by ring; unfold A; lra.
- unfold bh, B; lra.
- unfold bl; replace (bh + (dot_of (r0 * v0) (r1 * v1) (r2 * v2) - bh))
    with (dot_of (r0 * v0) (r1 * v1) (r2 * v2)) by ring; unfold B; lra.
- unfold cl; replace (ch + (c_of (r0 * r0) (r1 * r1) (r2 * r2) ss - ch))
    with (c_of (r0 * r0) (r1 * r1) (r2 * r2) ss) by ring; unfold rr; lra.
Qed.
