(* with: rounding.v event_time_root_rounded.v *)
(* SPDX-License-Identifier: MIT *)
(* For event_time_near.v: the later root of a x^2 + 2 b x + c, of coefficients that are off a little
   and an answer that is near it, as the rounded one is (event_time_root_rounded.v).  The errors of a
   and c are in the discriminant and in the quotient, and make up for one another; so not their parts
   are looked at but the root as a whole: that of the rounded a, b, c fulfils the exact equation but
   for what they are off.  Unbounded exponents. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding event_time_root_rounded.
Open Scope R_scope.

(* Of two polynomials the later roots: what the one leaves at the other's root. *)
Lemma later_roots A B C S T t : 0 < A -> S * S = B * B - A * C -> A * T = S - B -> T <= t ->
  (t - T) * (2 * S) <= A * (t * t) + 2 * B * t + C.
Proof.
intros HA HS HT Ht.
assert (Z : A * (T * T) + 2 * B * T + C = 0).
{ apply (Rmult_eq_reg_l A); [| lra].
  replace (A * (A * (T * T) + 2 * B * T + C)) with ((A * T) * (A * T) + 2 * B * (A * T) + A * C)
    by ring.
  rewrite HT; replace (A * C) with (B * B - S * S) by lra; ring. }
assert (E : A * (t * t) + 2 * B * t + C = A * ((t - T) * (t - T)) + (t - T) * (2 * S)).
{ replace S with (A * T + B) by lra.
  replace C with (- (A * (T * T) + 2 * B * T)) by lra; ring. }
assert (0 <= A * ((t - T) * (t - T))) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]); lra.
Qed.

Section Near.
(* The exact polynomial, and the one of its rounded coefficients. *)
Variables A B C S T a b c s t : R.
Hypotheses (HA : 0 < A) (HS : 0 < S) (HT : 0 < T) (Ha : 0 < a) (Hs : 0 < s) (Ht : 0 < t).
Hypotheses (ES : S * S = B * B - A * C) (ET : A * T = S - B).
Hypotheses (es : s * s = b * b - a * c) (et : a * t = s - b).
Let y := Rabs b.
Let z := Rabs (s + b).
Variables gamma zeta : R.
Hypotheses (Hg : 0 <= gamma <= 4) (Hz : 0 <= zeta <= 1) (Hy : y <= 1156 / 1000 * s).
Let ea := 3002 / 1000 * u * a.
Let eb := u * (1002 / 1000 * y + 31 / 1000 * s).
Let ec := t * (u * (gamma * z + zeta * s)).
Hypotheses (Da : - ea <= A - a <= ea) (Db : - eb <= B - b <= eb) (Dc : - ec <= C - c <= ec).

Lemma signs : 0 <= y /\ 0 <= z /\ - y <= b <= y /\ z <= s + y.
Proof.
assert (B1 := Rabs_pos b); assert (Z1 := Rabs_pos (s + b)); unfold y, z in *.
repeat split; try assumption; unfold Rabs; repeat destruct Rcase_abs; lra.
Qed.

Lemma in_numbers :
  - (3002 / 1000 * / 9007199254740992 * a) <= A - a <= 3002 / 1000 * / 9007199254740992 * a /\
  - (/ 9007199254740992 * (1002 / 1000 * y + 31 / 1000 * s)) <= B - b <=
    / 9007199254740992 * (1002 / 1000 * y + 31 / 1000 * s).
Proof. split; [exact Da | exact Db]. Qed.

(* The discriminants: 45u, and their roots. *)
Lemma discriminants :
  - (u * (45 * (s * s))) <= B * B - A * C - s * s <= u * (45 * (s * s)).
Proof.
destruct signs as (Y0 & Z0 & Yb & Zs); destruct in_numbers as [Da' Db'].
assert (Ss : 0 < s * s) by (apply Rmult_lt_0_compat; lra).
assert (EB : - (u * (5 * (s * s))) <= B * B - b * b <= u * (5 * (s * s))).
{ replace (B * B - b * b) with ((B - b) * (B + b)) by ring.
  assert (P := product (B - b) (B + b) eb (19 / 5 * s) Db ltac:(unfold u in *; lra)).
  replace (eb * (19 / 5 * s)) with (u * (19 / 5 * (1002 / 1000 * y + 31 / 1000 * s) * s)) in P
    by (unfold eb; ring).
  assert (19 / 5 * (1002 / 1000 * y + 31 / 1000 * s) * s <= 119 / 100 * 19 / 5 * s * s)
    by (apply Rmult_le_compat_r; lra).
  unfold u in *; lra. }
assert (AT : 0 <= a * t <= s + y) by (split; [apply Rmult_le_pos |]; lra).
assert (Sy : (s + y) * (s + y) <= 465 / 100 * (s * s)).
{ apply Rle_trans with (2156 / 1000 * s * (2156 / 1000 * s)); [apply Rmult_le_compat |]; lra. }
assert (Q : a * t * (s + y) <= 465 / 100 * (s * s)).
{ apply Rle_trans with (2 := Sy); apply Rmult_le_compat_r; lra. }
assert (EC : - (u * (40 * (s * s))) <= A * C - a * c <= u * (40 * (s * s))).
{ assert (Bc : - (t * (s + y)) <= c <= t * (s + y)).
  { rewrite (last_coefficient a b c s t Ha es et).
    assert (t * (s + b) <= t * (s + y)) by (apply Rmult_le_compat_l; lra).
    assert (t * - (s + y) <= t * (s + b)) by (apply Rmult_le_compat_l; lra); lra. }
  assert (Le : ec <= u * (t * (5 * (s + y)))).
  { unfold ec; replace (t * (u * (gamma * z + zeta * s))) with (u * (t * (gamma * z + zeta * s)))
      by ring.
    apply Rmult_le_compat_l; [unfold u; lra |]; apply Rmult_le_compat_l; [lra |].
    assert (gamma * z <= 4 * (s + y)) by (apply Rmult_le_compat; lra).
    assert (zeta * s <= 1 * s) by (apply Rmult_le_compat_r; lra); lra. }
  assert (P1 := product _ _ _ _ Da Bc).
  assert (P2 := product (A - a + a) (C - c) (1001 / 1000 * a) _ ltac:(unfold u in *; lra) Dc).
  replace (A * C - a * c) with ((A - a) * c + (A - a + a) * (C - c)) by ring.
  replace (ea * (t * (s + y))) with (3002 / 1000 * u * (a * t * (s + y))) in P1
    by (unfold ea; ring).
  assert (1001 / 1000 * a * ec <= 1001 / 1000 * a * (u * (t * (5 * (s + y)))))
    by (apply Rmult_le_compat_l; lra).
  replace (1001 / 1000 * a * (u * (t * (5 * (s + y)))))
    with (1001 / 1000 * 5 * u * (a * t * (s + y))) in H by ring.
  unfold u in *; lra. }
replace (s * s) with (b * b - a * c) at 2 4 by lra; unfold u in *; lra.
Qed.

Lemma roots_of_discriminants : (1 - 30 * u) * s <= S <= (1 + 30 * u) * s.
Proof.
assert (Di := discriminants); rewrite <- ES in Di; assert (0 <= s * s) by apply Rle_0_sqr.
split; apply square_le; try (unfold u; lra); try (apply Rmult_le_pos; unfold u; lra).
- replace ((1 - 30 * u) * s * ((1 - 30 * u) * s)) with ((1 - 60 * u + 900 * u * u) * (s * s))
    by ring.
  unfold u in *; lra.
- replace ((1 + 30 * u) * s * ((1 + 30 * u) * s)) with ((1 + 60 * u + 900 * u * u) * (s * s))
    by ring.
  unfold u in *; lra.
Qed.

(* What the exact polynomial can be at the other's root, over t. *)
Let M := 3002 / 1000 * (s - b) + 2 * (1002 / 1000 * y + 31 / 1000 * s) + gamma * z + zeta * s.

Lemma left_over x : 0 <= x <= (1 + 100 * u) * t ->
  Rabs (A - a) * (x * x) + 2 * Rabs (B - b) * x + Rabs (C - c) <= (1 + 201 * u) * (t * (u * M)).
Proof.
intro X; destruct signs as (Y0 & Z0 & Yb & Zs); destruct in_numbers as [Da' Db'].
assert (Pa : Rabs (A - a) <= ea) by (apply Rabs_le; exact Da).
assert (Pb : Rabs (B - b) <= eb) by (apply Rabs_le; exact Db).
assert (Pc : Rabs (C - c) <= ec) by (apply Rabs_le; exact Dc).
assert (E0 : 0 <= ea /\ 0 <= eb) by (unfold ea, eb, u; split; lra).
assert (Xx : x * x <= (1 + 201 * u) * (t * t)).
{ apply Rle_trans with ((1 + 100 * u) * t * ((1 + 100 * u) * t)); [apply Rmult_le_compat; lra |].
  replace ((1 + 100 * u) * t * ((1 + 100 * u) * t)) with ((1 + 100 * u) * (1 + 100 * u) * (t * t))
    by ring.
  apply Rmult_le_compat_r; [apply Rle_0_sqr | unfold u; lra]. }
assert (Q1 : Rabs (A - a) * (x * x) <= ea * ((1 + 201 * u) * (t * t))).
{ apply Rmult_le_compat; try assumption; [apply Rabs_pos | apply Rle_0_sqr]. }
replace (ea * ((1 + 201 * u) * (t * t))) with ((1 + 201 * u) * (t * (u * (3002 / 1000 * (a * t)))))
  in Q1 by (unfold ea; ring).
rewrite et in Q1.
assert (Q2 : Rabs (B - b) * x <= eb * ((1 + 201 * u) * t)).
{ apply Rmult_le_compat; try lra; [apply Rabs_pos |].
  apply Rle_trans with (1 := proj2 X), Rmult_le_compat_r; unfold u; lra. }
assert (Q3 : ec <= (1 + 201 * u) * ec).
{ assert (0 <= ec) by (generalize (Rabs_pos (C - c)); lra).
  assert (1 * ec <= (1 + 201 * u) * ec) by (apply Rmult_le_compat_r; [| unfold u]; lra); lra. }
replace ((1 + 201 * u) * (t * (u * M))) with
  ((1 + 201 * u) * (t * (u * (3002 / 1000 * (s - b)))) + 2 * (eb * ((1 + 201 * u) * t)) +
   (1 + 201 * u) * ec) by (unfold M, eb, ec; ring).
lra.
Qed.

(* T is not much more than t, from either of its forms. *)
Lemma not_much_more : T <= (1 + 100 * u) * t.
Proof.
destruct roots_of_discriminants as [S1 S2]; destruct signs as (Y0 & Z0 & Yb & Zs).
destruct in_numbers as [Da' Db'].
destruct (Rle_or_lt b 0) as [Neg | Pos].
- assert (y = - b) by (unfold y; apply Rabs_left1; lra).
  assert (A1 : (1 - 4 * u) * a <= A) by (unfold u in *; lra).
  assert (B1 : S - B <= (1 + 60 * u) * (s - b)) by (unfold u in *; lra).
  rewrite <- ET, <- et in B1.
  apply (Rmult_le_reg_l ((1 - 4 * u) * a)); [unfold u in *; lra |].
  assert ((1 - 4 * u) * a * T <= A * T) by (apply Rmult_le_compat_r; lra).
  assert (0 < a * t) by (apply Rmult_lt_0_compat; lra).
  unfold u in *; lra.
- assert (y = b) by (unfold y; apply Rabs_pos_eq; lra).
  assert (z = s + b) by (unfold z; apply Rabs_pos_eq; lra).
  assert (C1 : C = - (T * (S + B))).
  { apply (Rmult_eq_reg_l A); [| lra].
    replace (A * - (T * (S + B))) with (- (A * T * (S + B))) by ring; rewrite ET.
    replace (A * C) with (B * B - S * S) by lra; ring. }
  assert (L : (1 - 70 * u) * (s + b) <= S + B) by (unfold u in *; lra).
  assert (Lc : - C <= (1 + 6 * u) * (t * (s + b))).
  { assert (c = - (t * (s + b))) by exact (last_coefficient a b c s t Ha es et).
    assert (gamma * z <= 4 * (s + b)) by (rewrite H0; apply Rmult_le_compat_r; lra).
    assert (zeta * s <= 1 * (s + b)) by (apply Rmult_le_compat; lra).
    assert (ec <= t * (u * (5 * (s + b)))).
    { unfold ec; apply Rmult_le_compat_l; [lra |]; apply Rmult_le_compat_l; [unfold u |]; lra. }
    assert (0 < t * (s + b)) by (apply Rmult_lt_0_compat; lra).
    replace (t * (u * (5 * (s + b)))) with (5 * u * (t * (s + b))) in H4 by ring.
    unfold u in *; lra. }
  rewrite C1 in Lc.
  apply (Rmult_le_reg_r ((1 - 70 * u) * (s + b))); [unfold u; lra |].
  assert (T * ((1 - 70 * u) * (s + b)) <= T * (S + B)) by (apply Rmult_le_compat_l; lra).
  assert (0 < t * (s + b)) by (apply Rmult_lt_0_compat; lra).
  replace ((1 + 100 * u) * t * ((1 - 70 * u) * (s + b)))
    with ((1 + 100 * u) * (1 - 70 * u) * (t * (s + b))) by ring.
  unfold u in *; lra.
Qed.

Lemma perturbed : Rabs (t - T) * (2 * s) <= (1 + 300 * u) * (t * (u * M)).
Proof.
destruct roots_of_discriminants as [S1 S2]; assert (N := not_much_more).
assert (Part : forall p q, p * q <= Rabs p * Rabs q).
{ intros; rewrite <- Rabs_mult; apply Rle_abs. }
assert (Sum : forall x, 0 <= x -> forall e, e = 1 \/ e = - 1 ->
  e * (A - a) * (x * x) + 2 * (e * (B - b)) * x + e * (C - c) <=
  Rabs (A - a) * (x * x) + 2 * Rabs (B - b) * x + Rabs (C - c)).
{ intros x X e He.
  assert (F : forall p, e * p <= Rabs p).
  { intro p; destruct He as [-> | ->]; unfold Rabs; destruct Rcase_abs; lra. }
  assert (e * (A - a) * (x * x) <= Rabs (A - a) * (x * x))
    by (apply Rmult_le_compat_r; [apply Rle_0_sqr | apply F]).
  assert (e * (B - b) * x <= Rabs (B - b) * x) by (apply Rmult_le_compat_r; [exact X | apply F]).
  generalize (F (C - c)); lra. }
assert (M0 : 0 <= t * (u * M)).
{ assert (L := left_over 0 ltac:(unfold u; lra)).
  rewrite !Rmult_0_r, !Rplus_0_l in L; generalize (Rabs_pos (C - c)); unfold u in *; lra. }
assert (Zero : forall a b c s t, 0 < a -> s * s = b * b - a * c -> a * t = s - b ->
  a * (t * t) + 2 * b * t + c = 0).
{ intros a' b' c' s' t' H0 H1 H2; apply (Rmult_eq_reg_l a'); [| lra].
  replace (a' * (a' * (t' * t') + 2 * b' * t' + c'))
    with ((a' * t') * (a' * t') + 2 * b' * (a' * t') + a' * c') by ring.
  rewrite H2; replace (a' * c') with (b' * b' - s' * s') by lra; ring. }
destruct (Rle_or_lt T t) as [Le | Lt].
- rewrite Rabs_pos_eq by lra.
  assert (L := later_roots A B C S T t HA ES ET Le).
  assert (Z := Zero a b c s t Ha es et).
  assert (K := Sum t ltac:(lra) 1 ltac:(left; reflexivity)).
  assert (W := left_over t ltac:(unfold u; lra)).
  assert (V : (t - T) * (2 * S) <= (1 + 201 * u) * (t * (u * M))) by lra.
  assert (V2 : (t - T) * ((1 - 30 * u) * s) <= (t - T) * S) by (apply Rmult_le_compat_l; lra).
  set (m := t * (u * M)) in *; clearbody m; set (k := (t - T) * s) in *.
  assert (0 <= k) by (unfold k; apply Rmult_le_pos; lra).
  replace ((t - T) * ((1 - 30 * u) * s)) with ((1 - 30 * u) * k) in V2 by (unfold k; ring).
  replace ((t - T) * (2 * s)) with (2 * k) by (unfold k; ring).
  clearbody k; unfold u in *; lra.
- rewrite Rabs_left by lra.
  assert (L := later_roots a b c s t T Ha es et (Rlt_le _ _ Lt)).
  assert (Z := Zero A B C S T HA ES ET).
  assert (K := Sum T ltac:(lra) (-1) ltac:(right; reflexivity)).
  assert (W := left_over T ltac:(lra)).
  unfold u in *; lra.
Qed.

Lemma near_enough : M <= 20 * s /\ (1 - 11 * u) * t <= T.
Proof.
destruct signs as (Y0 & Z0 & Yb & Zs); assert (P := perturbed).
assert (Hm : M <= 20 * s).
{ unfold M; assert (gamma * z <= 4 * (s + y)) by (apply Rmult_le_compat; lra).
  assert (zeta * s <= 1 * s) by (apply Rmult_le_compat_r; lra); lra. }
split; [exact Hm |].
assert (Q : t * (u * M) <= t * (u * (20 * s))).
{ apply Rmult_le_compat_l; [lra |]; apply Rmult_le_compat_l; [unfold u |]; lra. }
apply (Rmult_le_reg_r (2 * s)); [lra |].
assert (N : (t - T) * (2 * s) <= Rabs (t - T) * (2 * s))
  by (apply Rmult_le_compat_r; [lra | apply Rle_abs]).
set (m := t * (u * M)) in *; clearbody m.
replace (t * (u * (20 * s))) with (20 * u * (t * s)) in Q by ring.
replace ((1 - 11 * u) * t * (2 * s)) with (2 * (1 - 11 * u) * (t * s)) by ring.
replace (T * (2 * s)) with (2 * (T * s)) by ring.
replace ((t - T) * (2 * s)) with (2 * (t * s) - 2 * (T * s)) in N by ring.
assert (0 < t * s) by (apply Rmult_lt_0_compat; lra).
unfold u in *; lra.
Qed.

(* Together with the answer's roundings, in units of u t s. *)
Lemma within_8u answer :
  Rabs (answer - t) * s <= t * (u * (1502 / 1000 * s - 427 / 1000 * y + 2003 / 1000 * s)) ->
  1502 / 1000 * s - 427 / 1000 * y + 2003 / 1000 * s + / 2 * M <= 799 / 100 * s ->
  Rabs (answer - T) <= 8 * u * T.
Proof.
intros Q Le; assert (P := perturbed); destruct near_enough as [M20 N].
assert (Ts : 0 < t * s) by (apply Rmult_lt_0_compat; lra).
apply (Rmult_le_reg_r s); [lra |].
apply Rle_trans with ((Rabs (answer - t) + Rabs (t - T)) * s).
- apply Rmult_le_compat_r; [lra |].
  replace (answer - T) with (answer - t + (t - T)) by ring; apply Rabs_triang.
- assert (F : t * (u * (1502 / 1000 * s - 427 / 1000 * y + 2003 / 1000 * s + / 2 * M)) <=
    t * (u * (799 / 100 * s))).
  { apply Rmult_le_compat_l; [lra |]; apply Rmult_le_compat_l; [unfold u |]; lra. }
  assert (F2 : t * (u * M) <= t * (u * (20 * s))).
  { apply Rmult_le_compat_l; [lra |]; apply Rmult_le_compat_l; [unfold u |]; lra. }
  replace (t * (u * (1502 / 1000 * s - 427 / 1000 * y + 2003 / 1000 * s + / 2 * M)))
    with (t * (u * (1502 / 1000 * s - 427 / 1000 * y + 2003 / 1000 * s)) + / 2 * (t * (u * M)))
    in F by ring.
  assert (W : (1 - 11 * u) * t * s <= T * s) by (apply Rmult_le_compat_r; lra).
  replace (t * (u * (799 / 100 * s))) with (799 / 100 * u * (t * s)) in F by ring.
  replace (t * (u * (20 * s))) with (20 * u * (t * s)) in F2 by ring.
  set (m := t * (u * M)) in *; set (n := t * (u * (1502 / 1000 * s - _ + _))) in *.
  clearbody m n; replace ((1 - 11 * u) * t * s) with ((1 - 11 * u) * (t * s)) in W by ring.
  set (ts := t * s) in *; clearbody ts.
  unfold u in *; lra.
Qed.
End Near.
