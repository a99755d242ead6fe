(* with: rounding.v exact_dd_products.v impulse_dd.v impulse_payment.v *)
(* SPDX-License-Identifier: MIT *)
(* impulse.c, crossed(), in numbers that are a little off: how a speed S changes, or all but, that
   S^2 - L is left of the square of. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding exact_dd_products impulse_dd impulse_payment.
Open Scope R_scope.

(* What is computed of S and L is t and l, and T of t^2 - l; x is how s changes then. *)
Section Crossed.
Variables S L P g t l T : R.
Hypotheses (Sp : Rabs S <= P) (Pg : P <= g) (Lg : Rabs L <= g * g).
Hypothesis Crosses : 0 < S * S - L <= g * g.
Hypotheses (St : Rabs (t - S) <= 12 * u * u * P) (Ll : near 41 l L).
Hypothesis Tl : Rabs (T - (t * t - l)) <= u * u * (96 / 10 * (t * t) + 33 / 10 * Rabs l).

Lemma sizes : 0 <= g /\ Rabs t <= 10001 / 10000 * g /\ 0 <= t * t <= 10001 / 10000 * (g * g) /\
  Rabs l <= 10001 / 10000 * (g * g) /\ T <= 10001 / 10000 * (g * g) /\
  Rabs (t * t - l - (S * S - L)) <= 66 * u * u * (g * g).
Proof.
unfold near in Ll.
assert (G0 : 0 <= g) by (generalize (Rabs_pos S); lra).
assert (A : Rabs t <= 100001 / 100000 * g).
{ assert (Rabs t <= Rabs (t - S) + Rabs S) by (unfold Rabs; repeat destruct Rcase_abs; lra).
  unfold u in *; lra. }
assert (Tt : Rabs t * Rabs t = t * t) by (rewrite <- Rabs_mult; apply Rabs_pos_eq, Rle_0_sqr).
assert (t * t <= 100001 / 100000 * g * (100001 / 100000 * g))
  by (rewrite <- Tt; apply Rmult_le_compat; try apply Rabs_pos; exact A).
assert (0 <= g * g) by (apply Rmult_le_pos; exact G0).
assert (D : Rabs (t * t - S * S) <= 12 * u * u * g * (2001 / 1000 * g)).
{ replace (t * t - S * S) with ((t - S) * (t + S)) by ring; rewrite Rabs_mult.
  apply Rmult_le_compat; try apply Rabs_pos; [unfold u in *; lra |].
  apply Rle_trans with (1 := Rabs_triang _ _); lra. }
assert (Al : Rabs l <= Rabs (l - L) + Rabs L) by (unfold Rabs; repeat destruct Rcase_abs; lra).
assert (0 <= t * t) by apply Rle_0_sqr.
assert (E : Rabs (t * t - l - (S * S - L)) <= 66 * u * u * (g * g)).
{ replace (t * t - l - (S * S - L)) with (t * t - S * S + - (l - L)) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; unfold u in *; lra. }
repeat split; try assumption; try (unfold u in *; lra).
apply Rabs_le_inv in Tl; apply Rabs_le_inv in E.
assert (Rabs l <= 10001 / 10000 * (g * g)) by (unfold u in *; lra).
assert (t * t <= 10001 / 10000 * (g * g)) by lra.
set (tt := t * t) in *; set (gg := g * g) in *; set (ss := S * S) in *.
clearbody tt gg ss; unfold u in *; lra.
Qed.

Lemma difference x : Rabs x <= 201 / 100 * g ->
  Rabs (2 * x * (S - t) + (L - l)) <= (2 * 12 * 201 / 100 + 41) * u * u * (g * g).
Proof.
intro X; unfold near in Ll; destruct sizes as (G0 & _).
apply Rle_trans with (1 := Rabs_triang _ _); rewrite !Rabs_mult, (Rabs_pos_eq 2) by lra.
rewrite (Rabs_minus_sym S), (Rabs_minus_sym L).
assert (Rabs x * Rabs (t - S) <= 201 / 100 * g * (12 * u * u * g)).
{ apply Rmult_le_compat; try apply Rabs_pos; [exact X | unfold u in *; lra]. }
unfold u in *; lra.
Qed.

Variable a : R.
Hypothesis A : 0 < a.
Hypothesis Root : Rabs (a * a - T) <= 85 / 10 * u * u * T.

Lemma balance : Rabs (a * a - t * t + l) <= 22 * u * u * (g * g).
Proof.
destruct sizes as (G0 & _ & T2 & L2 & Tg & _).
replace (a * a - t * t + l) with (a * a - T + (T - (t * t - l))) by ring.
apply Rle_trans with (1 := Rabs_triang _ _).
set (tt := t * t) in *; set (gg := g * g) in *; clearbody tt gg; unfold u in *; lra.
Qed.

Lemma root_size : 0 < T -> a <= 1001 / 1000 * g.
Proof.
intro Tp; destruct sizes as (G0 & Tg & T2 & L2 & Tgg & _).
apply square_le; [lra |]; apply Rabs_le_inv in Root.
set (gg := g * g) in *; replace (1001 / 1000 * g * (1001 / 1000 * g)) with
  (1001 / 1000 * 1001 / 1000 * gg) by (unfold gg; field); unfold u in *; lra.
Qed.

(* As it was meant to go on, with a. *)
Lemma late x : 0 < T -> a * Rabs (x - (a - t)) <= 40 * u * u * (g * g) ->
  a * Rabs (S + x - a) <= 60 * u * u * (g * g).
Proof.
intros Tp X; assert (Ag := root_size Tp); destruct sizes as (G0 & _).
replace (S + x - a) with (x - (a - t) + - (t - S)) by ring.
assert (E := Rabs_triang (x - (a - t)) (- (t - S))); rewrite Rabs_Ropp in E.
apply (Rmult_le_compat_l a) in E; [| lra].
assert (a * Rabs (t - S) <= 1001 / 1000 * g * (12 * u * u * g))
  by (apply Rmult_le_compat; try apply Rabs_pos; unfold u in *; lra).
assert (0 <= g * g) by (apply Rmult_le_pos; exact G0); unfold u in *; lra.
Qed.

Lemma by_quotient x : 0 < T -> 0 < t -> near 17 (x * (a + t)) (- l) -> goes_on S L g x a.
Proof.
intros Tp Tt X; destruct sizes as (G0 & _ & T2 & L2 & Tg & _); assert (Ba := balance).
unfold near in X; rewrite Rabs_Ropp in X; set (n := a + t) in *.
assert (N0 : 0 < n) by (unfold n; lra).
assert (N2 : a * a <= n * n /\ t * t <= n * n).
{ unfold n; assert (0 < a * t) by (apply Rmult_lt_0_compat; lra).
  assert (0 <= a * a) by apply Rle_0_sqr; lra. }
assert (Ln : Rabs l <= 1001 / 1000 * (n * n)).
{ apply Rabs_le_inv in Tl; apply Rabs_le_inv in Root.
  assert (0 <= a * a) by apply Rle_0_sqr.
  set (tt := t * t) in *; set (nn := n * n) in *; set (aa := a * a) in *.
  clearbody tt nn aa; clear - Tl Root N2 H Tp T2; unfold u in *; revert Tl.
  unfold Rabs; destruct Rcase_abs; intros; lra. }
assert (Xl : Rabs x * n <= 1001 / 1000 * Rabs l).
{ rewrite <- (Rabs_pos_eq n) by lra; rewrite <- Rabs_mult.
  assert (Rabs (x * n) <= Rabs (x * n - - l) + Rabs l)
    by (unfold Rabs; repeat destruct Rcase_abs; lra).
  generalize (Rabs_pos l); unfold u in *; lra. }
assert (Xn : Rabs x <= 1003 / 1000 * n).
{ apply (Rmult_le_reg_r n); [exact N0 |]; lra. }
assert (X0 := Rabs_pos x).
assert (Xg : Rabs x <= 1005 / 1000 * g).
{ apply square_le; [lra |].
  assert (Rabs x * Rabs x <= Rabs x * (1003 / 1000 * n)) by (apply Rmult_le_compat_l; lra).
  set (gg := g * g) in *; replace (1005 / 1000 * g * (1005 / 1000 * g)) with
    (1005 / 1000 * 1005 / 1000 * gg) by (unfold gg; field); lra. }
assert (D := difference x ltac:(lra)).
assert (E : Rabs ((x - (a - t)) * n) <= 40 * u * u * (g * g)).
{ replace ((x - (a - t)) * n) with (x * n - - l + - (a * a - t * t + l)) by (unfold n; ring).
  apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp.
  set (gg := g * g) in *; clearbody gg; unfold u in *; lra. }
assert (F : Rabs (x * (x - (a - t))) <= 1003 / 1000 * (40 * u * u * (g * g))).
{ rewrite Rabs_mult in *; rewrite (Rabs_pos_eq n) in E by lra.
  assert (Rabs x * Rabs (x - (a - t)) <= 1003 / 1000 * n * Rabs (x - (a - t)))
    by (apply Rmult_le_compat_r; [apply Rabs_pos | exact Xn]).
  lra. }
assert (S2 : Rabs (S + x) <= 2006 / 1000 * g).
{ apply Rle_trans with (1 := Rabs_triang _ _); lra. }
repeat split; [| lra | | | exact S2].
- replace (x * (2 * S + x) + L) with
    (x * (x - (a - t)) + (x * n - - l) + (2 * x * (S - t) + (L - l))) by (unfold n; ring).
  apply Rle_trans with (1 := Rabs_triang _ _).
  assert (G := Rabs_triang (x * (x - (a - t))) (x * n - - l)).
  set (gg := g * g) in *; clearbody gg; unfold u in *; lra.
- apply late; [exact Tp |].
  rewrite Rabs_mult, (Rabs_pos_eq n), Rmult_comm in E by lra.
  assert (a * Rabs (x - (a - t)) <= n * Rabs (x - (a - t)))
    by (apply Rmult_le_compat_r; [apply Rabs_pos | unfold n; lra]).
  lra.
- assert (Rabs x * Rabs (S + x) <= 1005 / 1000 * g * (2005 / 1000 * g)).
  { apply Rmult_le_compat; try apply Rabs_pos; [exact Xg |].
    apply Rle_trans with (1 := Rabs_triang _ _); lra. }
  assert (0 <= g * g) by (apply Rmult_le_pos; exact G0); lra.
Qed.

Lemma by_difference x : 0 < T -> t <= 0 -> near 4 x (a - t) -> goes_on S L g x a.
Proof.
intros Tp Tt X; destruct sizes as (G0 & Tg & T2 & L2 & Tgg & _); assert (Ba := balance).
unfold near in X; rewrite (Rabs_pos_eq (a - t)) in X by lra.
rewrite (Rabs_left1 t) in Tg by lra; assert (Ag := root_size Tp).
assert (Cg : a - t <= 2002 / 1000 * g) by lra.
assert (Xg : Rabs x <= 2003 / 1000 * g).
{ apply Rabs_le_inv in X; apply Rabs_le; unfold u in *; lra. }
assert (D := difference x ltac:(lra)); unfold goes_on; set (gg := g * g) in *.
assert (Gg : 0 <= gg) by (apply Rmult_le_pos; exact G0).
assert (Sx : Rabs (S + x) <= 1002 / 1000 * g).
{ replace (S + x) with (x - (a - t) + - (t - S) + a) by ring.
  apply Rabs_le_inv in X; apply Rabs_le_inv in St; apply Rabs_le; unfold u in *; lra. }
repeat split; [| exact Xg | | | lra].
- assert (F : Rabs ((x - (a - t)) * (x + (a - t) + 2 * t)) <=
    4 * u * u * (2002 / 1000) * (2003 / 1000) * gg).
  { replace (4 * u * u * (2002 / 1000) * (2003 / 1000) * gg) with
      (4 * u * u * (2002 / 1000 * g) * (2003 / 1000 * g)) by (unfold gg; ring).
    rewrite Rabs_mult; apply Rmult_le_compat; try apply Rabs_pos; [unfold u in *; lra |].
    apply Rabs_le_inv in X; apply Rabs_le; unfold u in *; lra. }
  replace (x * (2 * S + x) + L) with
    ((x - (a - t)) * (x + (a - t) + 2 * t) + (a * a - t * t + l) + (2 * x * (S - t) + (L - l)))
    by ring.
  apply Rle_trans with (1 := Rabs_triang _ _).
  assert (G := Rabs_triang ((x - (a - t)) * (x + (a - t) + 2 * t)) (a * a - t * t + l)).
  clearbody gg; unfold u in *; lra.
- apply late; [exact Tp |]; fold gg.
  assert (a * Rabs (x - (a - t)) <= 1001 / 1000 * g * (4 * u * u * (2002 / 1000 * g)))
    by (apply Rmult_le_compat; try apply Rabs_pos; unfold u in *; lra).
  replace (1001 / 1000 * g * (4 * u * u * (2002 / 1000 * g))) with
    (1001 / 1000 * 4 * 2002 / 1000 * u * u * gg) in H by (unfold gg; field).
  unfold u in *; lra.
- assert (Rabs x * Rabs (S + x) <= 2003 / 1000 * g * (1002 / 1000 * g))
    by (apply Rmult_le_compat; try apply Rabs_pos; assumption).
  unfold gg in *; lra.
Qed.
End Crossed.

(* Where nothing is left of it. *)
Lemma stopped S L P g t l T x : Rabs S <= P -> P <= g -> Rabs L <= g * g ->
  0 < S * S - L <= g * g -> Rabs (t - S) <= 12 * u * u * P -> near 41 l L ->
  Rabs (T - (t * t - l)) <= u * u * (96 / 10 * (t * t) + 33 / 10 * Rabs l) ->
  T <= 0 -> near 4 x (- t) -> goes_on S L g x 0.
Proof.
intros Sp Pg Lg C St Ll Tl T0 X.
destruct (sizes S L P g t l T Sp Pg Lg C St Ll Tl) as (G0 & Tg & T2 & L2 & _ & E).
unfold near in X; rewrite Rabs_Ropp in X.
assert (Xg : Rabs x <= 1001 / 1000 * g).
{ assert (Rabs x <= Rabs (x - - t) + Rabs t) by (unfold Rabs; repeat destruct Rcase_abs; lra).
  unfold u in *; lra. }
assert (Xs : Rabs (x + S) <= / 1000 * u * g).
{ replace (x + S) with (x - - t + - (t - S)) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; unfold u in *; lra. }
assert (X2 : Rabs ((x + S) * (x + S)) <= / 1000 * u * g * (/ 1000 * u * g)).
{ rewrite Rabs_mult; apply Rmult_le_compat; try apply Rabs_pos; exact Xs. }
assert (Sx : Rabs (S + x) <= / 1000 * u * g) by (rewrite Rplus_comm; exact Xs).
assert (Xx : Rabs x * Rabs (S + x) <= 1001 / 1000 * g * (/ 1000 * u * g))
  by (apply Rmult_le_compat; try apply Rabs_pos; assumption).
assert (Gg : 0 <= g * g) by (apply Rmult_le_pos; exact G0).
repeat split; [| lra | rewrite Rmult_0_l | | ]; [| unfold u in *; lra ..].
replace (x * (2 * S + x) + L) with ((x + S) * (x + S) + - (S * S - L)) by ring.
apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp, (Rabs_pos_eq (_ - _)) by lra.
apply Rabs_le_inv in E; apply Rabs_le_inv in Tl.
set (gg := g * g) in *; replace (/ 1000 * u * g * (/ 1000 * u * g)) with
  (/ 1000 * / 1000 * u * u * gg) in X2 by (unfold gg; ring).
set (tt := t * t) in *; set (ss := S * S) in *; clearbody gg tt ss; unfold u in *; lra.
Qed.
