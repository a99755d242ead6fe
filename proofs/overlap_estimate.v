(* with: rounding.v *)
(* SPDX-License-Identifier: MIT *)
(* For overlap_value.v: what is_precise and is_certain let through, and sums that carry their
   rounding errors along.  Unbounded exponents; what two_sum and two_prod leave behind is what it
   is meant to be. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Brink Require Import rounding.
Open Scope R_scope.

Definition pow98 := / 316912650057057350374175801344.
Definition pow97 := / 158456325028528675187087900672.
Definition pow43 := / 8796093022208.

(* --- What is let through ---------------------------------------------------- *)

Notation pow := (bpow radix2).
Notation ulp := (ulp radix2 fexp).

Lemma rnd_le x y : x <= y -> rnd x <= rnd y.
Proof. apply round_le; typeclasses eauto. Qed.

Lemma rnd_minus x : rnd (- x) = - rnd x.
Proof. apply round_NE_opp. Qed.

Lemma rnd_pow e : rnd (pow e) = pow e.
Proof.
apply round_generic; [typeclasses eauto |].
apply generic_format_bpow; unfold fexp, FLX_exp; lia.
Qed.

(* An estimate w > 0 that is off by a little more than a quarter of u of itself. *)
Lemma value_above w f : 0 < f -> Rabs (w - f) <= 26 / 100 * u * f -> Rabs (rnd w - f) <= ulp f.
Proof.
intros F H; apply Rabs_le_inv in H; unfold u in H; set (e := mag radix2 f : Z).
assert (E : f < pow e).
{ assert (G := bpow_mag_gt radix2 f); rewrite Rabs_pos_eq in G by lra; exact G. }
assert (U : ulp f = u * pow e).
{ rewrite ulp_neq_0 by lra; unfold cexp, fexp, FLX_exp; fold e; unfold Zminus; rewrite bpow_plus.
  unfold u; simpl (pow (- (53))); lra. }
rewrite U; unfold u; destruct (Rlt_or_le w (pow e)) as [L | L].
- assert (N := error_le_half_ulp radix2 fexp (fun n => negb (Z.even n)) w); fold rnd in N.
  change (round radix2 fexp (Znearest (fun n => negb (Z.even n))) w) with (rnd w) in N.
  assert (Uw : ulp w <= u * pow e).
  { rewrite ulp_neq_0 by lra; unfold u.
    replace (/ 9007199254740992 * pow e) with (pow (e - 53))
      by (unfold Zminus; rewrite bpow_plus; simpl (pow (- (53))); lra).
    apply bpow_le; unfold cexp, fexp, FLX_exp.
    assert (mag radix2 w <= e)%Z; [| lia].
    apply mag_le_bpow; [lra | rewrite Rabs_pos_eq; lra]. }
  unfold u in Uw; apply Rabs_le_inv in N; apply Rabs_le; lra.
- assert (B : pow e <= rnd w) by (rewrite <- rnd_pow; apply rnd_le, L).
  assert (D : rnd w <= pow e).
  { apply round_N_le_midp; try typeclasses eauto.
    - apply generic_format_bpow; unfold fexp, FLX_exp; lia.
    - rewrite succ_eq_pos by apply bpow_ge_0; rewrite ulp_bpow.
      assert (P : pow (fexp (e + 1)) = 2 * u * pow e).
      { unfold fexp, FLX_exp; replace (e + 1 - 53)%Z with (-52 + e)%Z by lia; rewrite bpow_plus.
        unfold u; simpl (pow (-52)); lra. }
      rewrite P; unfold u; lra. }
  apply Rabs_le; lra.
Qed.

Lemma value_close w f : Rabs (w - f) <= 26 / 100 * u * Rabs f -> Rabs (rnd w - f) <= ulp f.
Proof.
intro H; destruct (Rtotal_order f 0) as [N | [Z | P]].
- rewrite (Rabs_left f) in H by exact N.
  assert (G := value_above (- w) (- f) ltac:(lra)).
  replace (- w - - f) with (- (w - f)) in G by ring.
  rewrite Rabs_Ropp, rnd_minus, ulp_opp in G; specialize (G ltac:(lra)).
  replace (- rnd w - - f) with (- (rnd w - f)) in G by ring; rewrite Rabs_Ropp in G; exact G.
- subst f; rewrite Rabs_R0, Rmult_0_r, Rminus_0_r in H.
  assert (W : w = 0) by (apply Rabs_eq_R0; generalize (Rabs_pos w); lra).
  rewrite W; unfold rnd; rewrite round_0 by typeclasses eauto; rewrite Rminus_0_r, Rabs_R0.
  apply ulp_ge_0.
- rewrite (Rabs_pos_eq f) in H by lra; exact (value_above w f P H).
Qed.

(* is_precise, where t stands for the absolute term. *)
Lemma precise w f size t : 0 <= size -> 0 <= t -> Rabs (w - f) <= pow98 * size ->
  rnd (pow43 * size + t) < Rabs (rnd w) -> Rabs (rnd w - f) <= ulp f.
Proof.
intros S T H L; apply value_close; unfold pow98, pow43, u in *.
assert (A := low_own (/ 8796093022208 * size + t)); rewrite rounded in L.
set (l1 := low _) in *; clearbody l1; rewrite Rabs_pos_eq in A by lra.
assert (B := low_own w); rewrite rounded in L; set (l2 := low w) in *; clearbody l2.
unfold u in *; revert H L B; unfold Rabs; repeat destruct Rcase_abs; lra.
Qed.

(* is_certain. *)
Lemma certain w f size t : 0 <= size -> 0 <= t -> Rabs (w - f) <= pow98 * size ->
  rnd (pow97 * size + t) < Rabs (rnd w) -> (0 < rnd w -> 0 < f) /\ (rnd w < 0 -> f < 0).
Proof.
intros S T H L; unfold pow98, pow97 in *.
assert (A := low_own (/ 158456325028528675187087900672 * size + t)); rewrite (rounded (_ + _)) in L.
set (l1 := low _) in *; clearbody l1; rewrite Rabs_pos_eq in A by lra.
assert (B := low_own w); rewrite (rounded w) in *; set (l2 := low w) in *; clearbody l2.
unfold u in *; revert H L B; unfold Rabs; repeat destruct Rcase_abs; split; lra.
Qed.

(* --- The estimates ---------------------------------------------------------- *)

Definition gather (a b : R * R) :=
  (rnd (fst a + fst b), rnd (snd a + rnd (low (fst a + fst b) + snd b))).
Definition total (x : R * R) := fst x + snd x.
Definition two_sum a b := (rnd (a + b), low (a + b)).
Definition two_prod a b := (rnd (a * b), low (a * b)).
Definition times n (x : R * R) := (rnd (n * fst x), rnd (n * snd x + low (n * fst x))).
Definition square (x : R * R) := (rnd (fst x * fst x), rnd (2 * fst x * snd x + low (fst x * fst x))).

(* x stands for a number X of a size S, off by E, its second part at most L. *)
Definition near (x : R * R) X S E L :=
  - E <= total x - X <= E /\ - L <= snd x <= L /\ - S <= X <= S.

Lemma gather_near a b X Y S T E F L M : near a X S E L -> near b Y T F M ->
  L <= 20 * u * S -> M <= 20 * u * T -> E <= u * S -> F <= u * T ->
  near (gather a b) (X + Y) (S + T)
    (E + F + 101 / 100 * u * (L + 2 * M + 2 * u * (S + T))) (L + M + 101 / 100 * u * (S + T)).
Proof.
destruct a as [a1 a2], b as [b1 b2]; unfold near, total, gather; cbn [fst snd].
intros (H1 & H2 & H3) (K1 & K2 & K3) BL BM BE BF; unfold u in *.
assert (0 <= S) by lra; assert (0 <= T) by lra.
round_off (a1 + b1) (10001 / 10000 * (S + T)) l1.
round_off (l1 + b2) (10001 / 10000 / 9007199254740992 * (S + T) + M) l2.
round_off (a2 + (l1 + b2 - l2))
  (L + 10002 / 10000 / 9007199254740992 * (S + T) + 10001 / 10000 * M) l3.
repeat split; lra.
Qed.

Lemma weaker x X S E L E' L' : near x X S E L -> E <= E' -> L <= L' -> near x X S E' L'.
Proof. unfold near; intros (H1 & H2 & H3); repeat split; lra. Qed.

Lemma two_sum_near a b : near (two_sum a b) (a + b) (Rabs a + Rabs b) 0 (u * (Rabs a + Rabs b)).
Proof.
unfold near, total, two_sum; cbn [fst snd]; size a p; size b q; rewrite (rounded (a + b)).
assert (H1 := low_small (a + b) (p + q) ltac:(lra)); repeat split; lra.
Qed.

Lemma two_prod_near a b : near (two_prod a b) (a * b) (Rabs (a * b)) 0 (u * Rabs (a * b)).
Proof.
unfold near, total, two_prod; cbn [fst snd]; rewrite (rounded (a * b)).
assert (H := low_own (a * b)).
size (a * b) p; repeat split; lra.
Qed.

(* n x, of an x that gather or two_sum has made. *)
Lemma times_near n x X S : near x X S (5 * u * u * S) (3 * u * S) ->
  near (times n x) (n * X) (Rabs n * S) (10 * u * u * (Rabs n * S)) (5 * u * (Rabs n * S)).
Proof.
destruct x as [h l]; unfold near, total, times; cbn [fst snd]; intros (H1 & H2 & H3).
unfold u in *.
assert (N : - Rabs n <= n <= Rabs n) by (apply Rabs_le_inv, Rle_refl).
set (e := h + l - X) in *.
assert (P1 := product _ _ _ _ N H1); assert (P2 := product _ _ _ _ N H2).
assert (P3 := product _ _ _ _ N H3).
replace (n * h) with (n * X - n * l + n * e) by (unfold e; ring).
set (N' := Rabs n) in *; set (T := N' * S); assert (0 <= T) by (unfold T in *; lra).
replace (N' * (5 * / 9007199254740992 * / 9007199254740992 * S))
  with (5 * / 9007199254740992 * / 9007199254740992 * T) in P1 by (unfold T; ring).
replace (N' * (3 * / 9007199254740992 * S)) with (3 * / 9007199254740992 * T) in P2
  by (unfold T; ring).
fold T in P3; set (nx := n * X) in *; set (ne := n * e) in *; set (nl := n * l) in *.
clearbody nx ne nl T; clear H1 H2 H3.
round_off (nx - nl + ne) (10001 / 10000 * T) l1.
round_off (nl + l1) (41 / 10 / 9007199254740992 * T) l2.
repeat split; lra.
Qed.

Lemma square_near x X S : near x X S (5 * u * u * S) (3 * u * S) ->
  near (square x) (X * X) (S * S) (28 * u * u * (S * S)) (8 * u * (S * S)).
Proof.
destruct x as [h l]; unfold near, total, square; cbn [fst snd]; intros (H1 & H2 & H3).
unfold u in *.
set (e := h + l - X) in *.
assert (H4 : - (1001 / 1000 * S) <= h <= 1001 / 1000 * S) by (unfold e in H1; lra).
assert (P1 := product _ _ _ _ H4 H4); assert (P2 := product _ _ _ _ H4 H2).
assert (P3 := product _ _ _ _ H3 H3); assert (P4 := product _ _ _ _ H2 H2).
assert (P5 := product e (h + l + X) _ (2001 / 1000 * S) H1 ltac:(unfold e in H1; lra)).
assert (E : X * X = h * h + 2 * (h * l) + l * l - e * (h + l + X)) by (unfold e; ring).
replace (2 * h * l) with (2 * (h * l)) by ring.
set (T := S * S); assert (0 <= T) by apply Rle_0_sqr.
replace (1001 / 1000 * S * (1001 / 1000 * S)) with (1002001 / 1000000 * T) in P1
  by (unfold T; field).
replace (1001 / 1000 * S * (3 * / 9007199254740992 * S))
  with (3003 / 1000 / 9007199254740992 * T) in P2 by (unfold T; field).
fold T in P3.
replace (3 * / 9007199254740992 * S * (3 * / 9007199254740992 * S))
  with (9 / 9007199254740992 / 9007199254740992 * T) in P4 by (unfold T; field).
replace (5 * / 9007199254740992 * / 9007199254740992 * S * (2001 / 1000 * S))
  with (10005 / 1000 / 9007199254740992 / 9007199254740992 * T) in P5 by (unfold T; field).
set (xx := X * X) in *; set (hh := h * h) in *; set (hl := h * l) in *; set (ll := l * l) in *.
set (k := e * (h + l + X)) in *; clearbody xx hh hl ll k T; clear H1 H2 H3 H4; subst xx.
round_off hh (1002001 / 1000000 * T) l1.
round_off (2 * hl + l1) (71 / 10 / 9007199254740992 * T) l2.
repeat split; lra.
Qed.

(* Three and four of them gathered. *)
Lemma three_near a b c X Y Z S T V : 
  near a X S (28 * u * u * S) (8 * u * S) -> near b Y T (28 * u * u * T) (8 * u * T) ->
  near c Z V (28 * u * u * V) (8 * u * V) ->
  near (gather (gather a b) c) (X + Y + Z) (S + T + V) (82 * u * u * (S + T + V))
    (12 * u * (S + T + V)).
Proof.
intros A B C.
assert (0 <= S) by (unfold near in A; lra); assert (0 <= T) by (unfold near in B; lra).
assert (0 <= V) by (unfold near in C; lra).
assert (G := gather_near _ _ _ _ _ _ _ _ _ _ A B ltac:(unfold u; lra) ltac:(unfold u; lra)
  ltac:(unfold u; lra) ltac:(unfold u; lra)).
assert (G' := weaker _ _ _ _ _ (55 * u * u * (S + T)) (10 * u * (S + T)) G
  ltac:(unfold u; lra) ltac:(unfold u; lra)).
apply (weaker _ _ _ _ _ _ _ (gather_near _ _ _ _ _ _ _ _ _ _ G' C ltac:(unfold u; lra)
  ltac:(unfold u; lra) ltac:(unfold u; lra) ltac:(unfold u; lra))); unfold u; lra.
Qed.

Lemma four_near x a W X S V : near x X S (82 * u * u * S) (12 * u * S) ->
  near a W V 0 (u * V) -> - (98 * u * u * (S + V)) <= total (gather x a) - (X + W) <=
    98 * u * u * (S + V).
Proof.
intros A B.
assert (0 <= S) by (unfold near in A; lra); assert (0 <= V) by (unfold near in B; lra).
apply (weaker _ _ _ _ _ (98 * u * u * (S + V)) (20 * u * (S + V)) (gather_near _ _ _ _ _ _ _ _ _ _
  A B ltac:(unfold u; lra) ltac:(unfold u; lra) ltac:(unfold u; lra) ltac:(unfold u; lra)));
  unfold u; lra.
Qed.

Lemma within size w f S : - (98 * u * u * S) <= w - f <= 98 * u * u * S ->
  S <= 101 / 100 * size -> Rabs (w - f) <= pow98 * size.
Proof. intros; apply Rabs_le; unfold pow98, u in *; lra. Qed.

Lemma three_within a b c X Y Z S T V size :
  near a X S (28 * u * u * S) (8 * u * S) -> near b Y T (28 * u * u * T) (8 * u * T) ->
  near c Z V (28 * u * u * V) (8 * u * V) -> S + T + V <= 101 / 100 * size ->
  Rabs (total (gather (gather a b) c) - (X + Y + Z)) <= pow98 * size.
Proof.
intros A B C L; apply (within _ _ _ (S + T + V)); [| exact L].
assert (0 <= S) by (unfold near in A; lra); assert (0 <= T) by (unfold near in B; lra).
assert (0 <= V) by (unfold near in C; lra).
destruct (three_near _ _ _ _ _ _ _ _ _ A B C) as (G & _ & _); unfold u in *; lra.
Qed.

Lemma exact_near a b : near (two_prod a b) (a * b) (Rabs (a * b)) (28 * u * u * Rabs (a * b))
  (8 * u * Rabs (a * b)).
Proof.
apply (weaker _ _ _ _ _ _ _ (two_prod_near a b)); generalize (Rabs_pos (a * b)); unfold u; lra.
Qed.
