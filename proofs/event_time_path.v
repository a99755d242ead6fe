(* with: rounding.v event_time_sums.v *)
(* SPDX-License-Identifier: MIT *)
(* For event_time_fast.v: where a time puts a pair.  In the plane of its path: so far along from the
   closest approach, and so far off it; both are off a little, and by no more than they is the
   distance, by the triangle's inequality.  Unbounded exponents. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding event_time_sums.
Open Scope R_scope.

(* --- Lengths ---------------------------------------------------------------- *)

Definition len x y z := sqrt (x * x + y * y + z * z).

Lemma len_pos x y z : 0 <= len x y z. Proof. apply sqrt_pos. Qed.

Lemma len_square x y z : len x y z * len x y z = x * x + y * y + z * z.
Proof.
apply sqrt_sqrt; generalize (Rle_0_sqr x) (Rle_0_sqr y) (Rle_0_sqr z); unfold Rsqr; lra.
Qed.

Lemma cauchy x y z a b c : x * a + y * b + z * c <= len x y z * len a b c.
Proof.
apply square_le; [apply Rmult_le_pos; apply len_pos |].
replace (len x y z * len a b c * (len x y z * len a b c))
  with ((len x y z * len x y z) * (len a b c * len a b c)) by ring; rewrite !len_square.
assert (H1 := Rle_0_sqr (x * b - y * a)); assert (H2 := Rle_0_sqr (x * c - z * a)).
assert (H3 := Rle_0_sqr (y * c - z * b)); unfold Rsqr in *; lra.
Qed.

Lemma triangle x y z a b c : len (x + a) (y + b) (z + c) <= len x y z + len a b c.
Proof.
apply square_le; [generalize (len_pos x y z) (len_pos a b c); lra |].
assert (H := cauchy x y z a b c); assert (A := len_square x y z); assert (B := len_square a b c).
rewrite len_square.
replace ((len x y z + len a b c) * (len x y z + len a b c)) with
  (len x y z * len x y z + 2 * (len x y z * len a b c) + len a b c * len a b c) by ring; lra.
Qed.

Lemma len_le x y z a b c : Rabs x <= a -> Rabs y <= b -> Rabs z <= c -> len x y z <= len a b c.
Proof.
intros; apply square_le; [apply len_pos |]; rewrite !len_square.
assert (S : forall p q, Rabs p <= q -> p * p <= q * q).
{ intros p q L; replace (p * p) with (Rabs p * Rabs p)
    by (rewrite <- Rabs_mult; apply Rabs_pos_eq, Rle_0_sqr).
  apply Rmult_le_compat; try apply Rabs_pos; exact L. }
generalize (S x a H) (S y b H0) (S z c H1); lra.
Qed.

Lemma len_scaled k x y z : 0 <= k -> len (k * x) (k * y) (k * z) = k * len x y z.
Proof.
intro K; apply Rle_antisym; apply square_le; try apply len_pos;
  try (apply Rmult_le_pos; [exact K | apply len_pos]);
  replace (k * len x y z * (k * len x y z)) with (k * k * (len x y z * len x y z)) by ring;
  rewrite !len_square; right; ring.
Qed.

Lemma len_minus x y z a b c : Rabs (len x y z - len a b c) <= len (x - a) (y - b) (z - c).
Proof.
assert (H1 := triangle (x - a) (y - b) (z - c) a b c).
assert (H2 := triangle (a - x) (b - y) (c - z) x y z).
replace (len (a - x) (b - y) (c - z)) with (len (x - a) (y - b) (z - c)) in H2
  by (unfold len; f_equal; ring).
replace (x - a + a) with x in H1 by ring; replace (y - b + b) with y in H1 by ring.
replace (z - c + c) with z in H1 by ring; replace (a - x + x) with a in H2 by ring.
replace (b - y + y) with b in H2 by ring; replace (c - z + z) with c in H2 by ring.
apply Rabs_le; lra.
Qed.

Lemma len_flat p q : len p q 0 <= Rabs p + Rabs q.
Proof.
apply square_le; [generalize (Rabs_pos p) (Rabs_pos q); lra |]; rewrite len_square.
assert (0 <= Rabs p * Rabs q) by (apply Rmult_le_pos; apply Rabs_pos).
assert (S : forall p, p * p = Rabs p * Rabs p)
  by (intro; rewrite <- Rabs_mult; symmetry; apply Rabs_pos_eq, Rle_0_sqr).
rewrite (S p), (S q); lra.
Qed.

Lemma off_by x m : - m <= x <= m -> Rabs (rnd x - x) <= u * m.
Proof. intro H; assert (L := low_small x m H); rewrite (rounded x); apply Rabs_le; lra. Qed.

(* --- The path --------------------------------------------------------------- *)

Section Path.
Variables r0 r1 r2 v0 v1 v2 : R.
Let A := v0 * v0 + v1 * v1 + v2 * v2.
Let B := r0 * v0 + r1 * v1 + r2 * v2.
Let V := len v0 v1 v2.
Let Rn := len r0 r1 r2.
Let W := len (r1 * v2 - r2 * v1) (r2 * v0 - r0 * v2) (r0 * v1 - r1 * v0).
Let a := dot_rounded (v0 * v0) (v1 * v1) (v2 * v2).
Let b := dot_rounded (r0 * v0) (r1 * v1) (r2 * v2).
Hypothesis Moves : 0 < A.

Lemma V2 : V * V = A. Proof. apply len_square. Qed.
Lemma V_pos : 0 < V. Proof. apply sqrt_lt_R0, Moves. Qed.

Lemma a_close : Rabs (a - A) <= 3001 / 1000 * u * A.
Proof.
assert (H := dot_rounded_error (v0 * v0) (v1 * v1) (v2 * v2)); fold a A in H.
assert (X := Rle_0_sqr v0); assert (Y := Rle_0_sqr v1); assert (Z := Rle_0_sqr v2).
unfold Rsqr in *.
rewrite (Rabs_pos_eq _ X), (Rabs_pos_eq _ Y), (Rabs_pos_eq _ Z) in H; fold A in H.
unfold tiny, u in *; lra.
Qed.

Lemma sizes_of_products : Rabs (r0 * v0) + Rabs (r1 * v1) + Rabs (r2 * v2) <= Rn * V.
Proof.
rewrite !Rabs_mult.
assert (H := cauchy (Rabs r0) (Rabs r1) (Rabs r2) (Rabs v0) (Rabs v1) (Rabs v2)).
assert (E : forall p q s, len (Rabs p) (Rabs q) (Rabs s) = len p q s).
{ intros; unfold len; rewrite <- !Rabs_mult, !Rabs_pos_eq by apply Rle_0_sqr; reflexivity. }
rewrite !E in H; exact H.
Qed.

Lemma b_close : Rabs (b - B) <= 3001 / 1000 * u * (Rn * V).
Proof.
assert (H := dot_rounded_error (r0 * v0) (r1 * v1) (r2 * v2)); fold b B in H.
assert (P := sizes_of_products); unfold tiny, u in *.
generalize (Rabs_pos (r0 * v0)) (Rabs_pos (r1 * v1)) (Rabs_pos (r2 * v2)); lra.
Qed.

Lemma lagrange : W * W + B * B = Rn * Rn * A.
Proof. unfold W, Rn; rewrite !len_square; unfold A, B; ring. Qed.

(* Along it: the time from num = sg rho - b, rho of either sign, is off by 5.2u of itself, and by
   what b and rho are. *)
Section Along.
Variables sg rho : R.
Hypotheses (Sg : sg = 1 \/ sg = - 1) (R0 : 0 <= rho).
Let root := rnd rho.
Let num := rnd (sg * root - b).
Let t := rnd (num / a).
Hypothesis Later : 0 < num.

Lemma along_close : 0 <= t /\ Rabs (A * t + B - sg * rho) <=
  u * (V * (52 / 10 * (V * t) + 31 / 10 * Rn) + rho).
Proof.
assert (Ra := a_close); apply Rabs_le_inv in Ra.
assert (Rb := b_close); apply Rabs_le_inv in Rb; assert (VP := V_pos).
assert (Pa : 0 < a) by (unfold u in *; lra).
assert (Lr := low_small rho rho ltac:(lra)).
assert (Er : root = rho - low rho) by exact (rounded rho).
assert (Ln := low_own (sg * root - b)).
assert (En : num = sg * root - b - low (sg * root - b)) by exact (rounded _).
assert (Lt := low_own (num / a)); assert (Et : t = num / a - low (num / a)) by exact (rounded _).
set (l1 := low rho) in *; set (l2 := low (sg * root - b)) in *; set (l3 := low (num / a)) in *.
assert (Q : 0 < num / a) by (apply Rdiv_lt_0_compat; assumption).
rewrite (Rabs_pos_eq (num / a)) in Lt by lra.
assert (T0 : 0 <= t) by (clearbody l3; unfold u in *; lra).
split; [exact T0 |].
assert (N : num = a * t + a * l3).
{ rewrite Et; field; lra. }
assert (L3 : - (101 / 100 * u * (a * t)) <= a * l3 <= 101 / 100 * u * (a * t)).
{ assert (H : num / a <= 1001 / 1000 * t) by (clearbody l3; unfold u in *; lra).
  assert (P := product a l3 a (u * (1001 / 1000 * t)) ltac:(lra)
    ltac:(clearbody l3; unfold u in *; lra)).
  assert (0 <= a * t) by (apply Rmult_le_pos; lra); unfold u in *; lra. }
assert (L2 : - (101 / 100 * u * num) <= l2 <= 101 / 100 * u * num).
{ clear - Ln En Later; clearbody l2 num; revert Ln.
  unfold u, Rabs; destruct Rcase_abs; intro; lra. }
assert (At : a * t <= 1001 / 1000 * (A * t)).
{ replace (1001 / 1000 * (A * t)) with (1001 / 1000 * A * t) by ring.
  apply Rmult_le_compat_r; [exact T0 | unfold u in *; lra]. }
assert (Da : - (3001 / 1000 * u * (A * t)) <= (a - A) * t <= 3001 / 1000 * u * (A * t)).
{ replace (3001 / 1000 * u * (A * t)) with (3001 / 1000 * u * A * t) by ring; split.
  - replace (- (3001 / 1000 * u * A * t)) with (- (3001 / 1000 * u * A) * t) by ring.
    apply Rmult_le_compat_r; lra.
  - apply Rmult_le_compat_r; lra. }
replace (V * (52 / 10 * (V * t) + 31 / 10 * Rn)) with (52 / 10 * (A * t) + 31 / 10 * (Rn * V))
  by (rewrite <- V2; ring).
assert (Eq : A * t + B - sg * rho = - ((a - A) * t) - a * l3 - l2 - sg * l1 - (b - B)).
{ assert (E1 : sg * rho = num + l2 + b + sg * l1) by (rewrite En, Er; ring).
  rewrite E1, N; ring. }
rewrite Eq; assert (0 <= A * t) by (apply Rmult_le_pos; lra).
assert (0 <= Rn * V) by (apply Rmult_le_pos; apply len_pos).
assert (L1 : - (u * rho) <= sg * l1 <= u * rho).
{ clear - Lr Sg; clearbody l1; destruct Sg as [-> | ->]; unfold u in *; lra. }
set (q1 := (a - A) * t) in *; set (q2 := a * l3) in *; set (q3 := sg * l1) in *.
clearbody q1 q2 q3 l2; apply Rabs_le; unfold u in *; lra.
Qed.
End Along.

(* Off it: a time t for which the pair is near sg rho along and G off its path, which are together
   as far as the surface. *)
Lemma gap sigma sg rho G t alpha kappa : 0 <= sigma -> sg = 1 \/ sg = - 1 -> 0 <= t ->
  0 <= alpha <= 10 -> 0 <= kappa <= 10 -> rho <= 11 / 10 * (sigma * V) ->
  Rabs (A * t + B - sg * rho) <= u * (V * (alpha * (V * t) + 31 / 10 * Rn) + rho) ->
  Rabs (G - W) <= 22 / 10 * u * (Rn * V) ->
  Rabs (len rho G 0 - sigma * V) <= kappa * u * (sigma * V) ->
  Rabs (len (r0 + v0 * t) (r1 + v1 * t) (r2 + v2 * t) - sigma) <=
    u * ((alpha + 54 / 10) * (V * t) + (kappa + 65 / 10) * sigma).
Proof.
intros Hs Sg T0 Ha Hk Hr Al Cc Rc; assert (VP := V_pos).
set (L := A * t + B) in *; set (K := len rho G 0) in *.
set (P := len (r0 + v0 * t) (r1 + v1 * t) (r2 + v2 * t)).
assert (E : P * V = len L W 0).
{ assert (S : P * V * (P * V) = len L W 0 * len L W 0).
  { rewrite len_square; replace (P * V * (P * V)) with (P * P * (V * V)) by ring.
    unfold P; rewrite len_square, V2; unfold L.
    replace (W * W) with (Rn * Rn * A - B * B) by (generalize lagrange; lra).
    unfold Rn; rewrite len_square; unfold A, B; ring. }
  apply Rle_antisym; apply square_le; try lra; try apply len_pos.
  apply Rmult_le_pos; [apply len_pos | lra]. }
assert (K' : K = len (sg * rho) G 0).
{ unfold K, len; f_equal; destruct Sg as [-> | ->]; ring. }
assert (D : Rabs (len L W 0 - K) <= Rabs (L - sg * rho) + Rabs (G - W)).
{ rewrite K'; apply Rle_trans with (1 := len_minus _ _ _ _ _ _); rewrite Rminus_0_r.
  rewrite (Rabs_minus_sym G W); apply len_flat. }
assert (Tr : Rn <= P + V * t).
{ assert (H := triangle (r0 + v0 * t) (r1 + v1 * t) (r2 + v2 * t) (t * - v0) (t * - v1) (t * - v2)).
  rewrite len_scaled in H by exact T0.
  replace (len (- v0) (- v1) (- v2)) with V in H by (unfold V, len; f_equal; ring).
  replace (r0 + v0 * t + t * - v0) with r0 in H by ring.
  replace (r1 + v1 * t + t * - v1) with r1 in H by ring.
  replace (r2 + v2 * t + t * - v2) with r2 in H by ring; fold P Rn in H; lra. }
assert (Tot : Rabs (P - sigma) * V <=
  u * (alpha * (V * t) + 53 / 10 * Rn + (kappa + 11 / 10) * sigma) * V).
{ rewrite <- (Rabs_pos_eq V) at 1 by lra; rewrite <- Rabs_mult.
  replace ((P - sigma) * V) with (len L W 0 - K + (K - sigma * V)) by (rewrite <- E; ring).
  apply Rle_trans with (1 := Rabs_triang _ _); unfold u in *; lra. }
apply Rmult_le_reg_r in Tot; [| exact VP].
assert (VT : 0 <= V * t) by (apply Rmult_le_pos; lra); assert (0 <= Rn) by apply len_pos.
assert (AT : 0 <= alpha * (V * t) <= 10 * (V * t))
  by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
assert (KS : 0 <= kappa * sigma <= 10 * sigma)
  by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
apply Rabs_le_inv in Tot; apply Rabs_le; unfold u in *; split; lra.
Qed.
End Path.
