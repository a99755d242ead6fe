(* with: rounding.v *)
(* SPDX-License-Identifier: MIT *)
(* event_time_meeting.h: a verdict that is certain is right.  Whether a pair comes or goes is the
   sign of b, whether it is inside that of c.  A, B, C are exact, P = sum |r_i v_i|, P^2 <= A R.
   Unbounded exponents; t stands for an absolute term. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding.
Open Scope R_scope.

(* Where b^2 is more than a part k of A R, the sums' size P is no more than b over its root. *)
Lemma size_by_b A P R a size b k m t : 0 <= A -> 0 <= R -> 0 <= P -> P * P <= A * R -> 0 <= t ->
  99 / 100 * A <= a -> 99 / 100 * R <= size -> 0 < k -> 0 < m -> 11 / 10 <= k * (m * m) ->
  rnd (k * rnd (a * size) + t) < rnd (b * b) -> P <= m * Rabs b.
Proof.
intros HA HR HP Q T Ha Hs Hk Hm Km F.
apply square_le; [apply Rmult_le_pos; [lra | apply Rabs_pos] |].
assert (Bb : Rabs b * Rabs b = b * b) by (rewrite <- Rabs_mult; apply Rabs_pos_eq, Rle_0_sqr).
replace (m * Rabs b * (m * Rabs b)) with (m * m * (Rabs b * Rabs b)) by ring; rewrite Bb.
assert (S : 98 / 100 * (A * R) <= a * size).
{ apply Rle_trans with (99 / 100 * A * (99 / 100 * R)); [| apply Rmult_le_compat; lra].
  assert (0 <= A * R) by (apply Rmult_le_pos; assumption); lra. }
assert (AR : 0 <= A * R) by (apply Rmult_le_pos; assumption).
assert (B0 : 0 <= b * b) by apply Rle_0_sqr.
assert (L1 := low_own (a * size)); rewrite (rounded (a * size)) in F.
rewrite Rabs_pos_eq in L1 by lra; set (l1 := low (a * size)) in *; clearbody l1.
assert (S1 : 97 / 100 * (A * R) <= a * size - l1) by (unfold u in *; lra).
assert (K1 : k * (97 / 100 * (A * R)) <= k * (a * size - l1)) by (apply Rmult_le_compat_l; lra).
assert (K0 : 0 <= k * (A * R)) by (apply Rmult_le_pos; lra).
assert (L2 := low_own (k * (a * size - l1) + t)); rewrite (rounded (_ + t)) in F.
rewrite Rabs_pos_eq in L2 by lra; set (l2 := low _) in *; clearbody l2.
assert (L3 := low_own (b * b)); rewrite (rounded (b * b)) in F.
rewrite Rabs_pos_eq in L3 by lra; set (l3 := low (b * b)) in *; clearbody l3.
assert (F1 : 96 / 100 * (k * (A * R)) <= b * b) by (unfold u in *; lra).
assert (F2 : m * m * (96 / 100 * (k * (A * R))) <= m * m * (b * b))
  by (apply Rmult_le_compat_l; [apply Rle_0_sqr | exact F1]).
assert (F3 : 11 / 10 * (A * R) <= k * (m * m) * (A * R)) by (apply Rmult_le_compat_r; assumption).
replace (m * m * (96 / 100 * (k * (A * R)))) with (96 / 100 * (k * (m * m) * (A * R))) in F2 by ring.
lra.
Qed.

(* A sign is that of the exact number, where a sum is off by less than half of it. *)
Lemma same_sign x X : Rabs (x - X) <= / 2 * Rabs x -> (0 < x -> 0 < X) /\ (x < 0 -> X < 0).
Proof. intro H; split; intro; revert H; unfold Rabs; repeat destruct Rcase_abs; intros; lra. Qed.

(* meeting_of: is_b_certain, t for an absolute term, what c is beside its error, and
   is_certain_to_miss: parts. *)
Definition is_b_certain a b size t := (* 2^-200 *)
  rnd (/ 1606938044258990275541962092341162602522202993782792835301376 * rnd (a * size) + t) <
  rnd (b * b).
Definition is_inside c e := c < - (2 * e).
Definition is_known c e := rnd (3166593487994880 * e) < c. (* 1.40625 2^51 *)
Definition parts a b rr := (* 2^-100 *)
  rnd (/ 1267650600228229401496703205376 * rnd (a * rr) + 0) < rnd (b * b).

(* is_b_certain: b was rounded from a sum that is off by 7u^2 P. *)
Theorem b_is_certain A B P R a size bs t : 0 <= A -> 0 <= R -> 0 <= P -> P * P <= A * R -> 0 <= t ->
  99 / 100 * A <= a -> 99 / 100 * R <= size -> Rabs (bs - B) <= 71 / 10 * u * u * P ->
  let b := rnd bs in is_b_certain a b size t -> (0 < b -> 0 < B) /\ (b < 0 -> B < 0).
Proof.
intros HA HR HP Q T Ha Hs Kb b F.
assert (S := size_by_b A P R a size b
  (/ 1606938044258990275541962092341162602522202993782792835301376)
  2535301200456458802993406410752 t HA HR HP Q T Ha Hs
  ltac:(lra) ltac:(lra) ltac:(lra) F).
apply same_sign; assert (L := low_own bs); assert (E := rounded bs); fold b in E.
replace (b - B) with (bs - B + - low bs) by lra.
apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp.
assert (Rabs (low bs) <= 2 * u * Rabs b).
{ set (l := low bs) in *; clearbody l b; revert L; rewrite E.
  unfold u, Rabs; repeat destruct Rcase_abs; intros; lra. }
generalize (Rabs_pos b); unfold u in *; lra.
Qed.

(* is_certain_to_miss, parts: b of dot_rounded, off by 3u P. *)
Theorem parts_is_certain A B P rr a r2 b : 0 <= A -> 0 <= rr -> 0 <= P -> P * P <= A * rr ->
  99 / 100 * A <= a -> 99 / 100 * rr <= r2 -> Rabs (b - B) <= 3 * tiny * u * P -> 0 < b ->
  parts a b r2 -> 0 < B.
Proof.
intros HA HR HP Q Ha Hs Kb Pb F.
assert (S := size_by_b A P rr a r2 b (/ 1267650600228229401496703205376)
  1200000000000000 0 HA HR HP Q (Rle_refl 0) Ha Hs
  ltac:(lra) ltac:(lra) ltac:(lra) F).
apply (same_sign b B); [| exact Pb]; unfold tiny, u in *; generalize (Rabs_pos b); lra.
Qed.

(* c: inside where it is below -2 of what its sum is off by, outside where it is known. *)
Theorem c_is_certain C cs e : 0 <= e -> Rabs (cs - C) <= e + 3 * u * u * Rabs cs ->
  let c := rnd cs in (is_inside c e -> C < 0) /\ (is_known c e -> 0 < C).
Proof.
intros E H c; unfold is_inside, is_known.
assert (L := low_own cs); assert (Q := rounded cs); fold c in Q.
set (l := low cs) in *; clearbody l c.
assert (M := low_own (3166593487994880 * e)); rewrite (rounded (_ * e)).
set (m := low _) in *; clearbody m; rewrite (Rabs_pos_eq (_ * e)) in M by lra.
revert L H; unfold u in *; unfold Rabs; repeat destruct Rcase_abs; intros; split; intros; lra.
Qed.

(* later: where c is known and d certain, D > 0 and Q < 2^45 D, b < 0 is enough. *)
Theorem coming_is_certain A B C P R bs : 0 < A -> 0 < C -> 0 <= P -> P * P <= A * R ->
  A * R <= 2 * 17592186044416 * (B * B - A * C) -> Rabs (bs - B) <= 71 / 10 * u * u * P ->
  rnd bs < 0 -> B < 0.
Proof.
intros HA HC HP Q D Kb Neg.
assert (0 < A * C) by (apply Rmult_lt_0_compat; assumption).
assert (S : P <= 8388608 * Rabs B).
{ apply square_le; [apply Rmult_le_pos; [lra | apply Rabs_pos] |].
  replace (8388608 * Rabs B * (8388608 * Rabs B)) with (70368744177664 * (Rabs B * Rabs B)) by ring.
  rewrite <- Rabs_mult, (Rabs_pos_eq (B * B)) by apply Rle_0_sqr.
  generalize (Rle_0_sqr B); unfold Rsqr; lra. }
assert (bs < 0).
{ apply Rnot_le_lt; intro N; assert (0 <= rnd bs); [| lra].
  unfold rnd; rewrite <- (round_0 radix2 fexp ZnearestE); apply round_le; try typeclasses eauto.
  exact N. }
assert (B <> 0) by (intros ->; rewrite Rmult_0_l in D; generalize (Rle_0_sqr P); unfold Rsqr; lra).
revert Kb S; unfold u, Rabs; repeat destruct Rcase_abs; intros; lra.
Qed.
