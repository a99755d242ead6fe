(* with: rounding.v event_time_root_rounded.v event_time_root.v *)
(* SPDX-License-Identifier: MIT *)
(* event_time_parting.h, near pairs: the later root of discriminant_near and later_root is within
   8u, so within BRINK_EVENT_TIME_ULP 8, and 0 only where it is.  Unbounded exponents. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding event_time_root_rounded event_time_root.
Open Scope R_scope.

(* discriminant_near: d, *)
Definition near_d a b c := rnd (rnd (b * b) - a * c).
(* and what makes it certain: inside, as c is known; coming, and d large beside b^2 and what c is
   off by; or outside and leaving. *)
Definition is_inside c e := rnd (3166593487994880 * e) < - c. (* 1.40625 2^51 *)
Definition is_large b d := rnd (3 / 4 * rnd (b * b)) < d.
Definition is_large_beside_c a d e := rnd (36028797018963968 * a * e) < d. (* 2^55 *)
Definition is_outside c e := 2 * e < c.
Definition is_leaving a b size := (* 2^-200 *)
  rnd (/ 1606938044258990275541962092341162602522202993782792835301376 * a * size) < rnd (b * b).
(* later_root, of the root of d. *)
Definition near_root a b c d :=
  let sum := rnd (rnd (sqrt d) + Rabs b) in
  if Rlt_dec 0 b then rnd (- c / sum) else rnd (sum / a).

(* b, rounded from a sum that is off by 7u^2 P; where P^2 < 2^90 d that is nothing beside the
   root. *)
Lemma known_b B bs P s : 0 <= P -> 0 < s -> P * P <= 1237940039285380274899124224 * (s * s) ->
  Rabs (bs - B) <= 71 / 10 * u * u * P -> let b := rnd bs in
  - (u * (1002 / 1000 * Rabs b + 31 / 1000 * s)) <= B - b <=
    u * (1002 / 1000 * Rabs b + 31 / 1000 * s).
Proof.
intros P0 S0 Q H b; apply Rabs_le_inv in H.
assert (Ps : P <= 35184372088832 * s).
{ apply square_le; [lra |].
  replace (35184372088832 * s * (35184372088832 * s))
    with (1237940039285380274899124224 * (s * s)) by ring; exact Q. }
assert (L := low_own bs); assert (E := rounded bs); fold b in E.
set (l := low bs) in *; clearbody l; clearbody b; clear Q; revert L.
unfold u in *; unfold Rabs; repeat destruct Rcase_abs; intro L; split; lra.
Qed.

(* a, of dot_rounded. *)
Lemma known_a A a : 0 < A -> Rabs (a - A) <= 3 * tiny * u * A -> 0 < a /\
  - (3002 / 1000 * u * a) <= A - a <= 3002 / 1000 * u * a.
Proof. intros HA H; apply Rabs_le_inv in H; unfold tiny, u in *; repeat split; lra. Qed.

(* c from a sum that is off by e, where is_known says that it is, or by as much in all: where
   |c| >= R / 3 a leading difference was rounded, by 1u. *)
Lemma known_c C cs e : 0 <= e -> let c := rnd cs in
  Rabs (cs - C) <= e + 3 * u * u * Rabs cs -> is_inside c e ->
  Rabs (C - c) <= 3850 / 1000 * u * Rabs c /\ c < 0 /\ e <= / 3166593487994880 * (11 / 10 * - c).
Proof.
intros E c H K; apply Rabs_le_inv in H; unfold is_inside in K.
assert (L := low_own cs); assert (Q := rounded cs); fold c in Q.
assert (M := low_own (3166593487994880 * e)); rewrite (rounded (_ * e)) in K.
set (l := low cs) in *; set (m := low _) in *; clearbody l m c.
rewrite (Rabs_pos_eq (_ * e)) in M by lra.
assert (0 <= 3166593487994880 * e - m) by (unfold u in *; lra).
assert (c < 0) by lra; rewrite (Rabs_left c) by assumption.
revert L H; unfold u in *; unfold Rabs; repeat destruct Rcase_abs; intros; repeat split; lra.
Qed.

Lemma negative x y : 0 < x -> y < 0 -> x * y < 0.
Proof. intros; assert (0 < x * - y) by (apply Rmult_lt_0_compat; lra); lra. Qed.

(* Inside: c < 0, known, b of either sign. *)
Theorem later_root_inside A B C P a bs c : 0 < A -> 0 <= P ->
  Rabs (a - A) <= 3 * tiny * u * A -> Rabs (bs - B) <= 71 / 10 * u * u * P -> c < 0 ->
  Rabs (C - c) <= 3850 / 1000 * u * Rabs c ->
  let b := rnd bs in P * P <= 1237940039285380274899124224 * (b * b - a * c) ->
  let T := (sqrt (B * B - A * C) - B) / A in
  Rabs (near_root a b c (near_d a b c) - T) <= 8 * u * T.
Proof.
intros HA HP Ka Kb Hc Kc b Q T; unfold near_root, near_d; cbv zeta.
destruct (known_a A a HA Ka) as [Ha Da].
assert (Pc : a * c < 0) by (apply negative; lra).
assert (Pb := Rle_0_sqr b); unfold Rsqr in Pb.
set (s := sqrt (b * b - a * c)); assert (es : s * s = b * b - a * c) by (apply sqrt_sqrt; lra).
assert (Hs : 0 < s) by (apply sqrt_lt_R0; lra).
rewrite <- es in Q; assert (Db := known_b B bs P s HP Hs Q Kb); fold b in Db; cbv zeta in Db.
rewrite (Rabs_left c) in Kc by exact Hc; apply Rabs_le_inv in Kc.
assert (HC : C < 0) by (unfold u in *; lra).
assert (PC : A * C < 0) by (apply negative; lra).
assert (PB := Rle_0_sqr B); unfold Rsqr in PB.
set (S := sqrt (B * B - A * C)) in *; assert (ES : S * S = B * B - A * C) by (apply sqrt_sqrt; lra).
assert (HS : 0 < S) by (apply sqrt_lt_R0; lra).
assert (Yb : Rabs b < s).
{ apply Rnot_le_lt; intro N; assert (s * s <= Rabs b * Rabs b) by (apply Rmult_le_compat; lra).
  rewrite <- Rabs_mult, Rabs_pos_eq in H by lra; lra. }
assert (YB : Rabs B < S).
{ apply Rnot_le_lt; intro N; assert (S * S <= Rabs B * Rabs B) by (apply Rmult_le_compat; lra).
  rewrite <- Rabs_mult, Rabs_pos_eq in H by lra; lra. }
assert (Bb := Rabs_le_inv b _ (Rle_refl _)); assert (BB := Rabs_le_inv B _ (Rle_refl _)).
set (t := (s - b) / a); assert (et : a * t = s - b) by (unfold t; field; lra).
assert (ET : A * T = S - B) by (unfold T; field; lra).
assert (Ht : 0 < t) by (apply Rdiv_lt_0_compat; lra).
assert (HT : 0 < T) by (apply Rdiv_lt_0_compat; lra).
assert (Zs : Rabs (s + b) = s + b) by (apply Rabs_pos_eq; lra).
assert (Ec : c = - (t * (s + b))) by (apply (last_coefficient a b c s t Ha es et)).
assert (Dc : - (t * (u * (3850 / 1000 * Rabs (s + b) + 0 * s))) <= C - c <=
  t * (u * (3850 / 1000 * Rabs (s + b) + 0 * s))).
{ rewrite Zs; replace (t * (u * (3850 / 1000 * (s + b) + 0 * s)))
    with (3850 / 1000 * u * - c) by (rewrite Ec; ring); lra. }
apply (within_8u A B C S T a b c s t HA HS HT Ha Hs Ht ES ET es et (3850 / 1000) 0); try lra;
  try assumption.
now apply rounded_root; try lra.
Qed.

(* The same where is_known says so, of a sum that is off by e of at least 2^-141 R. *)
Theorem later_root_known A B C P R a bs cs e : 0 < A -> 0 <= P -> 0 <= e ->
  Rabs (a - A) <= 3 * tiny * u * A -> Rabs (bs - B) <= 71 / 10 * u * u * P ->
  Rabs (cs - C) <= e + 3 * u * u * Rabs cs -> P * P <= A * R ->
  R <= 2 * 1393796574908163946345982392040522594123776 * e -> (* 2^141 *)
  let b := rnd bs in let c := rnd cs in is_inside c e ->
  let T := (sqrt (B * B - A * C) - B) / A in
  Rabs (near_root a b c (near_d a b c) - T) <= 8 * u * T.
Proof.
intros HA HP He Ka Kb Kc Q1 Q2 b c K.
destruct (known_c C cs e He Kc K) as (Dc & Hc & Ee); fold c in Dc, Hc, Ee.
apply (later_root_inside A B C P a bs c HA HP Ka Kb Hc Dc).
destruct (known_a A a HA Ka) as [Ha Da].
assert (0 <= rnd bs * rnd bs) by apply Rle_0_sqr.
assert (A * R <= A * (2 * 1393796574908163946345982392040522594123776 *
  (/ 3166593487994880 * (11 / 10 * - c)))) by (apply Rmult_le_compat_l; lra).
assert (A * - c <= 1001 / 1000 * a * - c)
  by (apply Rmult_le_compat_r; [lra | unfold u in *; lra]).
assert (0 <= a * - c) by (apply Rmult_le_pos; lra).
lra.
Qed.

(* Outside or hardly inside, b < 0, and the discriminant large: of whatever sign c is. *)
Theorem later_root_near A B C P R a bs c e : 0 < A -> 0 <= P -> 0 <= e ->
  Rabs (a - A) <= 3 * tiny * u * A -> Rabs (bs - B) <= 71 / 10 * u * u * P ->
  Rabs (C - c) <= 201 / 100 * u * Rabs c + e ->
  P * P <= A * R -> R <= 2 * 1393796574908163946345982392040522594123776 * e -> (* 2^141 *)
  let b := rnd bs in let d := near_d a b c in b < 0 -> is_large b d -> is_large_beside_c a d e ->
  let T := (sqrt (B * B - A * C) - B) / A in Rabs (near_root a b c d - T) <= 8 * u * T.
Proof.
intros HA HP He Ka Kb Kc Q1 Q2 b d Neg D1 D2 T; unfold is_large, is_large_beside_c in D1, D2.
set (bb := rnd (b * b)) in *; change d with (rnd (bb - a * c)) in *; clear d.
set (d := rnd (bb - a * c)) in *; unfold near_root; cbv zeta.
set (sum := rnd (rnd (sqrt d) + Rabs b)).
destruct (known_a A a HA Ka) as [Ha Da].
assert (Pb : 0 < b * b) by (replace (b * b) with (- b * - b) by ring; apply Rmult_lt_0_compat; lra).
assert (Ae : 0 <= a * e) by (apply Rmult_le_pos; lra).
assert (L1 := low_own (b * b)); assert (E1 := rounded (b * b)); fold bb in E1.
rewrite (Rabs_pos_eq (b * b)) in L1 by lra.
assert (L2 := low_own (bb - a * c)); assert (E2 := rounded (bb - a * c)); fold d in E2.
assert (L3 := low_own (3 / 4 * bb)); rewrite (rounded (3 / 4 * bb)) in D1.
rewrite Rmult_assoc in D2.
assert (L4 := low_own (36028797018963968 * (a * e))); rewrite (rounded (_ * (a * e))) in D2.
rewrite (Rabs_pos_eq (_ * (a * e))) in L4 by lra.
set (l1 := low (b * b)) in *; set (l2 := low (bb - a * c)) in *; set (l3 := low (3 / 4 * bb)) in *.
set (l4 := low _) in *.
rewrite (Rabs_pos_eq (3 / 4 * bb)) in L3 by (unfold u in *; lra).
assert (Big : 7499 / 10000 * (b * b) <= b * b - a * c /\
  a * e <= 10001 / 10000 * / 36028797018963968 * (b * b - a * c)).
{ clear - L1 L2 L3 L4 E1 E2 D1 D2 Pb Ae; clearbody l1 l2 l3 l4 bb d.
  revert L2; unfold u in *; unfold Rabs; destruct Rcase_abs; intro; split; lra. }
destruct Big as [B1 B2].
set (s := sqrt (b * b - a * c)); assert (es : s * s = b * b - a * c) by (apply sqrt_sqrt; lra).
assert (Hs : 0 < s) by (apply sqrt_lt_R0; lra); rewrite <- es in B1, B2.
assert (Yb : Rabs b = - b) by (apply Rabs_left; exact Neg).
assert (Hy : Rabs b <= 1156 / 1000 * s).
{ apply square_le; [lra |]; rewrite Yb; lra. }
set (t := (s - b) / a); assert (et : a * t = s - b) by (unfold t; field; lra).
assert (Ht : 0 < t) by (apply Rdiv_lt_0_compat; lra).
assert (Et : e <= t * (u * (26 / 100 * s))).
{ apply (Rmult_le_reg_l a); [exact Ha |]; apply Rle_trans with (1 := B2).
  replace (a * (t * (u * (26 / 100 * s)))) with (26 / 100 * u * (a * t * s)) by ring; rewrite et.
  assert (s * s <= (s - b) * s) by (apply Rmult_le_compat_r; lra); unfold u; lra. }
assert (Ec : Rabs c = t * Rabs (s + b)).
{ rewrite (last_coefficient a b c s t Ha es et), Rabs_Ropp, Rabs_mult, (Rabs_pos_eq t) by lra.
  reflexivity. }
assert (Dc : - (t * (u * (201 / 100 * Rabs (s + b) + 26 / 100 * s))) <= C - c <=
  t * (u * (201 / 100 * Rabs (s + b) + 26 / 100 * s))).
{ rewrite Ec in Kc; apply Rabs_le_inv in Kc.
  replace (t * (u * (201 / 100 * Rabs (s + b) + 26 / 100 * s))) with
    (201 / 100 * u * (t * Rabs (s + b)) + t * (u * (26 / 100 * s))) by ring; lra. }
assert (Q : P * P <= 1237940039285380274899124224 * (s * s)).
{ apply Rle_trans with (1 := Q1).
  assert (A * R <= A * (2 * 1393796574908163946345982392040522594123776 * e))
    by (apply Rmult_le_compat_l; lra).
  assert (A * e <= 2 * (a * e)).
  { replace (2 * (a * e)) with (2 * a * e) by ring.
    apply Rmult_le_compat_r; [exact He | unfold u in *; lra]. }
  lra. }
assert (Db := known_b B bs P s HP Hs Q Kb); fold b in Db; cbv zeta in Db.
assert (Di := discriminants A B C a b c s t HA Ha Hs Ht es et (201 / 100) (26 / 100) ltac:(lra)
  ltac:(lra) Hy Da Db Dc).
assert (Ss : 0 < s * s) by (apply Rmult_lt_0_compat; lra).
set (S := sqrt (B * B - A * C)) in *.
assert (ES : S * S = B * B - A * C) by (apply sqrt_sqrt; unfold u in *; lra).
assert (HS : 0 < S) by (apply sqrt_lt_R0; unfold u in *; lra).
assert (SB : / 2 * s <= S) by (apply square_le; [lra |]; rewrite ES; unfold u in *; lra).
assert (ET : A * T = S - B) by (unfold T; field; lra).
assert (HT : 0 < T) by (apply Rdiv_lt_0_compat; [rewrite Yb in Db; unfold u in *; lra | lra]).
assert (W := within_8u A B C S T a b c s t HA HS HT Ha Hs Ht ES ET es et (201 / 100) (26 / 100)
  ltac:(lra) ltac:(lra) Hy Da Db Dc _ (rounded_root a b c s t Ha Hs Ht es et Hy)).
destruct (Rlt_dec 0 b) as [F | _]; [lra |]; apply W.
rewrite Yb in *; unfold Rabs; destruct (Rcase_abs (s + b)); lra.
Qed.

(* Outside and leaving: both are certain, so the root is behind, and 0 the answer. *)
Theorem already_parted A B C P R a bs cs e size : 0 < A -> 0 <= P -> 0 <= e -> 0 <= R ->
  Rabs (a - A) <= 3 * tiny * u * A -> Rabs (bs - B) <= 71 / 10 * u * u * P ->
  Rabs (cs - C) <= e + 3 * u * u * Rabs cs -> P * P <= A * R -> R / 2 <= size ->
  let b := rnd bs in let c := rnd cs in 0 < b -> is_outside c e -> is_leaving a b size ->
  0 < B /\ 0 < C.
Proof.
intros HA HP He HR Ka Kb Kc Q Hz b c Pb Pc K; unfold is_outside, is_leaving in Pc, K.
destruct (known_a A a HA Ka) as [Ha Da]; apply Rabs_le_inv in Kb; apply Rabs_le_inv in Kc.
assert (Eb := rounded bs); assert (Ec := rounded cs); fold b in Eb; fold c in Ec.
assert (Lb := low_own bs); assert (Lc := low_own cs).
set (l1 := low bs) in *; set (l2 := low cs) in *; clearbody l1 l2 b c; split.
- assert (Lk := low_own (b * b)); rewrite (rounded (b * b)) in K.
  assert (0 < b * b) by (apply Rmult_lt_0_compat; lra).
  rewrite (Rabs_pos_eq (b * b)) in Lk by lra; rewrite Rmult_assoc in K.
  assert (Ar : / 3 * (A * R) <= a * size).
  { replace (/ 3 * (A * R)) with (2 / 3 * A * (R / 2)) by field.
    apply Rmult_le_compat; try lra; unfold u in *; lra. }
  assert (0 <= A * R) by (apply Rmult_le_pos; lra).
  set (q := / 1606938044258990275541962092341162602522202993782792835301376 * (a * size)) in *.
  assert (Lq := low_own q); rewrite (rounded q) in K; set (l3 := low q) in *; clearbody l3.
  rewrite (Rabs_pos_eq q) in Lq by (unfold q; lra).
  assert (P * P <= 6427752177035961102167848369364650410088811975131171341205504 * (b * b))
    by (set (l4 := low (b * b)) in *; clearbody l4; unfold q, u in *; lra).
  assert (P <= 2535301200456458802993406410752 * b).
  { apply square_le; [lra |]; lra. }
  revert Lb; unfold u in *; unfold Rabs; destruct Rcase_abs; intro; lra.
- revert Lc Kc; unfold u in *; unfold Rabs; destruct Rcase_abs; intros; lra.
Qed.
