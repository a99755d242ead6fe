(* with: rounding.v *)
(* SPDX-License-Identifier: MIT *)
(* impulse.c, pair_pay: what is owed, paid as a change d of the speed that a pair goes on with.  That
   adds what it should to the speed's square, to 9u of itself, so to BRINK_IMPULSE_BALANCE's 2^-49 of
   what was owed; whatever that speed came from, to some u^2 of the pair's energy.
   Unbounded exponents. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding.
Open Scope R_scope.

(* q and m: r.r and mu, rounded; h: the speed without what is paid, times |r|, rounded. *)
Definition gain (q m owed : R) := rnd (rnd (2 * owed * q) / m).
Definition payment (q m owed h : R) :=
  let square := rnd (h * h) in let gained := gain q m owed in
  if Rlt_dec (Rabs gained) (/ 1048576 * square)
  then rnd (gained / rnd (h + rnd (sqrt (rnd (square + gained))))) else 0.
Definition left_owed (q m owed h : R) :=
  let square := rnd (h * h) in
  if Rlt_dec (Rabs (gain q m owed)) (/ 1048576 * square) then 0 else owed.

Lemma gain_is_close q m owed Q Mu : 0 < Q -> 0 < Mu ->
  Rabs (q - Q) <= 1002 / 1000 * u * Q -> Rabs (m - Mu) <= 1002 / 1000 * u * Mu ->
  let G := 2 * owed * Q / Mu in Rabs (gain q m owed - G) <= 401 / 100 * u * Rabs G.
Proof.
intros Q0 M0 Hq Hm G; unfold gain.
assert (G1 : G * Mu = 2 * owed * Q) by (unfold G; field; lra).
assert (Z : Rabs (2 * owed * q - G * Mu) <= 1002 / 1000 * u * (Rabs G * Mu)).
{ rewrite <- (Rabs_pos_eq Mu) at 2 by lra; rewrite <- Rabs_mult, G1.
  replace (2 * owed * q - 2 * owed * Q) with (2 * owed * (q - Q)) by ring.
  rewrite !(Rabs_mult (2 * owed)), (Rabs_pos_eq Q) by lra.
  replace (1002 / 1000 * u * (Rabs (2 * owed) * Q)) with
    (Rabs (2 * owed) * (1002 / 1000 * u * Q)) by ring.
  apply Rmult_le_compat_l; [apply Rabs_pos | exact Hq]. }
assert (T : - (Rabs G * Mu) <= G * Mu <= Rabs G * Mu).
{ apply Rabs_le_inv; rewrite Rabs_mult, (Rabs_pos_eq Mu) by lra; apply Rle_refl. }
assert (T0 : 0 <= Rabs G * Mu) by (apply Rmult_le_pos; [apply Rabs_pos | lra]).
set (z := 2 * owed * q) in *; set (t := Rabs G * Mu) in *; set (gm := G * Mu) in *.
apply Rabs_le_inv in Z; apply Rabs_le_inv in Hm.
assert (L1 := low_small z ((1 + 2 * u) * t) ltac:(unfold u in *; lra)); rewrite (rounded z).
set (l1 := low z) in *; clearbody l1; set (n := z - l1) in *.
assert (N : Rabs (n - gm) <= 2003 / 1000 * u * t).
{ apply Rabs_le; unfold n, u in *; lra. }
assert (m0 : 0 < m) by (unfold u in *; lra).
assert (F : n / m * m = n) by (field; lra); set (f := n / m) in *; clearbody f.
assert (L2 := low_own f); rewrite (rounded f); set (l2 := low f) in *; clearbody l2.
assert (L2m : Rabs (l2 * m) <= u * Rabs n).
{ rewrite <- F, !Rabs_mult; rewrite (Rabs_pos_eq m) by lra.
  apply Rabs_le in L2; apply Rmult_le_compat_r with (r := m) in L2; [lra | lra]. }
assert (D : Rabs ((f - l2) * (Mu - m)) <= 1003 / 1000 * u * (Rabs n * (1 + 2 * u))).
{ rewrite Rabs_mult; assert (Rabs (Mu - m) <= 10025 / 10000 * u * m).
  { apply Rabs_le; unfold u in *; lra. }
  assert (Rabs (f - l2) * m <= (1 + u) * Rabs n).
  { rewrite <- (Rabs_pos_eq m) at 1 by lra; rewrite <- Rabs_mult.
    replace ((f - l2) * m) with (n - l2 * m) by (rewrite <- F; ring).
    eapply Rle_trans; [apply Rabs_triang |]; rewrite Rabs_Ropp; lra. }
  assert (Rabs (f - l2) * Rabs (Mu - m) <= Rabs (f - l2) * (10025 / 10000 * u * m))
    by (apply Rmult_le_compat_l; [apply Rabs_pos | assumption]).
  generalize (Rabs_pos n); unfold u in *; lra. }
apply (Rmult_le_reg_r Mu); [exact M0 |].
rewrite <- (Rabs_pos_eq Mu) at 1 by lra; rewrite <- Rabs_mult.
replace ((f - l2 - G) * Mu) with (n - gm + - (l2 * m) + (f - l2) * (Mu - m))
  by (unfold gm; rewrite <- F; ring).
assert (Nt : Rabs n <= (1 + 3 * u) * t).
{ apply Rabs_le_inv in N; apply Rabs_le; unfold u in *; lra. }
eapply Rle_trans; [apply Rabs_triang |].
assert (E := Rabs_triang (n - gm) (- (l2 * m))); rewrite Rabs_Ropp in E.
replace (401 / 100 * u * Rabs G * Mu) with (401 / 100 * u * t) by (unfold t; ring).
unfold u in *; lra.
Qed.

(* What is gained, of a speed h that goes on as h + d. *)
Lemma payment_is_close h gained : 0 < h -> Rabs gained < / 1048576 * rnd (h * h) ->
  let d := rnd (gained / rnd (h + rnd (sqrt (rnd (rnd (h * h) + gained))))) in
  Rabs (d * (2 * h + d) - gained) <= 32 / 10 * u * Rabs gained /\
  Rabs d * h <= 51 / 100 * Rabs gained /\ Rabs gained <= 96 / 100000000 * (h * h).
Proof.
intros H C d; assert (A0 : 0 < h * h) by (apply Rmult_lt_0_compat; exact H).
assert (L0 := low_small (h * h) (h * h) ltac:(lra)); unfold d; rewrite (rounded (h * h)) in *.
set (A := h * h) in *; set (l0 := low A) in *; clearbody l0.
assert (G0 := Rabs_pos gained); assert (Gi := Rabs_le_inv _ _ (Rle_refl (Rabs gained))).
set (e := Rabs gained) in *.
assert (Ga : e <= 96 / 100000000 * A) by (unfold u in *; lra).
assert (L1 := low_small (A - l0 + gained) (1001 / 1000 * A) ltac:(unfold u in *; lra)).
rewrite (rounded (A - l0 + gained)); set (l1 := low (A - l0 + gained)) in *; clearbody l1.
set (z := A - l0 + gained - l1).
assert (Z : 999 / 1000 * A <= z <= 1001 / 1000 * A) by (unfold z, u in *; lra).
assert (Y0 : 0 < sqrt z) by (apply sqrt_lt_R0; lra).
assert (Y2 := sqrt_sqrt z ltac:(lra)); set (y := sqrt z) in *.
assert (L2 := low_small y y ltac:(lra)); rewrite (rounded y); set (l2 := low y) in *.
clearbody l2; set (w := y - l2).
assert (W2 : Rabs (w * w - A - gained) <= 402 / 100 * u * A).
{ assert (P1 := product y l2 y _ ltac:(lra) L2); assert (P2 := product l2 l2 _ _ L2 L2).
  replace (y * (u * y)) with (u * z) in P1 by (rewrite <- Y2; ring).
  replace (u * y * (u * y)) with (u * u * z) in P2 by (rewrite <- Y2; ring).
  replace (w * w - A - gained) with (- l0 - l1 - 2 * (y * l2) + l2 * l2)
    by (unfold w; replace ((y - l2) * (y - l2)) with (z - 2 * (y * l2) + l2 * l2)
          by (rewrite <- Y2; ring); unfold z; ring).
  apply Rabs_le; unfold u in *; lra. }
assert (Wp : 0 < w) by (unfold w, u in *; lra).
assert (Wa : 999 / 1000 * h <= w <= 1001 / 1000 * h).
{ apply Rabs_le_inv in W2; split; (apply square_le; [lra |]).
  - replace (999 / 1000 * h * (999 / 1000 * h)) with (998001 / 1000000 * A) by (unfold A; field).
    unfold u in *; lra.
  - replace (1001 / 1000 * h * (1001 / 1000 * h)) with (1002001 / 1000000 * A)
      by (unfold A; field); unfold u in *; lra. }
assert (L3 := low_small (h + w) (h + w) ltac:(lra)); rewrite (rounded (h + w)).
set (l3 := low (h + w)) in *; clearbody l3; set (D := h + w - l3).
assert (D0 : 1998 / 1000 * h <= D <= 2002 / 1000 * h) by (unfold D, u in *; lra).
assert (F : gained / D * D = gained) by (field; lra); set (f := gained / D) in *; clearbody f.
assert (L4 := low_own f); rewrite (rounded f); set (l4 := low f) in *; clearbody l4.
fold e; set (x := f - l4).
assert (Fd : Rabs f * D = e) by (rewrite <- (Rabs_pos_eq D) by lra; rewrite <- Rabs_mult, F;
  reflexivity).
assert (Ld : Rabs (l4 * D) <= u * e).
{ rewrite Rabs_mult, (Rabs_pos_eq D), <- Fd by lra; apply Rabs_le in L4.
  rewrite <- Rmult_assoc; apply Rmult_le_compat_r; lra. }
assert (Xh : Rabs x * h <= 501 / 1000 * e).
{ assert (Rabs x <= (1 + u) * Rabs f).
  { unfold x; apply Rabs_le in L4; eapply Rle_trans; [apply Rabs_triang |].
    rewrite Rabs_Ropp; lra. }
  assert (Rabs f * (1998 / 1000 * h) <= Rabs f * D)
    by (apply Rmult_le_compat_l; [apply Rabs_pos | lra]).
  assert (Rabs x * h <= (1 + u) * Rabs f * h) by (apply Rmult_le_compat_r; lra).
  unfold u in *; lra. }
assert (X0 := Rabs_pos x).
assert (Xl : Rabs (x * l3) <= 1005 / 1000 * u * e).
{ rewrite Rabs_mult; assert (Rabs x * Rabs l3 <= Rabs x * (u * (2001 / 1000 * h))).
  { apply Rmult_le_compat_l; [exact X0 |]; apply Rabs_le; unfold u in *; lra. }
  unfold u in *; lra. }
assert (N : Rabs (x - (w - h)) <= 202 / 100 * u * h).
{ apply (Rmult_le_reg_r (h + w)); [lra |].
  rewrite <- (Rabs_pos_eq (h + w)) at 1 by lra; rewrite <- Rabs_mult.
  replace ((x - (w - h)) * (h + w)) with (- (l4 * D) + x * l3 + - (w * w - A - gained))
    by (unfold x; replace ((f - l4 - (w - h)) * (h + w)) with
          (f * D + (f - l4) * l3 - l4 * D - (w * w - A)) by (unfold D, A; ring);
        rewrite F; ring).
  eapply Rle_trans; [apply Rabs_triang |]; rewrite Rabs_Ropp.
  assert (E := Rabs_triang (- (l4 * D)) (x * l3)); rewrite Rabs_Ropp in E.
  assert (202 / 100 * u * h * (1999 / 1000 * h) <= 202 / 100 * u * h * (h + w)).
  { apply Rmult_le_compat_l; [unfold u; lra | lra]. }
  replace (202 / 100 * u * h * (1999 / 1000 * h)) with (202 / 100 * 1999 / 1000 * u * A) in H0
    by (unfold A; field).
  unfold u in *; lra. }
split; [| split; [lra | exact Ga]].
replace (x * (2 * h + x) - gained) with (- (l4 * D) + x * l3 + x * (x - (w - h)))
  by (rewrite <- F; unfold x, D; ring).
eapply Rle_trans; [apply Rabs_triang |].
assert (E := Rabs_triang (- (l4 * D)) (x * l3)); rewrite Rabs_Ropp in E.
assert (Rabs (x * (x - (w - h))) <= Rabs x * (202 / 100 * u * h)).
{ rewrite Rabs_mult; apply Rmult_le_compat_l; assumption. }
unfold u in *; lra.
Qed.

(* Either all of it is paid or nothing. *)
Theorem payment_pays q m owed h Q Mu : 0 < Q -> 0 < Mu -> 0 <= h ->
  Rabs (q - Q) <= 1002 / 1000 * u * Q -> Rabs (m - Mu) <= 1002 / 1000 * u * Mu ->
  let d := payment q m owed h in let left := left_owed q m owed h in
  let G := 2 * (owed - left) * Q / Mu in
  Rabs (d * (2 * h + d) - G) <= 73 / 10 * u * Rabs G /\ Rabs d * h <= 52 / 100 * Rabs G /\
  Rabs G <= 97 / 100000000 * (h * h) /\ (left = 0 \/ left = owed).
Proof.
intros Q0 M0 H Hq Hm d left G; assert (C := gain_is_close q m owed Q Mu Q0 M0 Hq Hm).
unfold G, d, left, payment, left_owed; cbv zeta in *; destruct Rlt_dec as [P | P].
- assert (Hp : 0 < h).
  { destruct H as [H | H]; [exact H | exfalso]; subst h.
    rewrite Rmult_0_l in P; unfold rnd in P; rewrite round_0 in P by typeclasses eauto.
    generalize (Rabs_pos (gain q m owed)); lra. }
  destruct (payment_is_close h (gain q m owed) Hp P) as (E & D & S).
  rewrite Rminus_0_r; set (g' := gain q m owed) in *; set (x := rnd (g' / _)) in *.
  set (g0 := 2 * owed * Q / Mu) in *.
  assert (N : Rabs g' <= (1 + 5 * u) * Rabs g0 /\ Rabs g0 <= (1 + 5 * u) * Rabs g').
  { clear - C; revert C; unfold u, Rabs; repeat destruct Rcase_abs; lra. }
  assert (0 <= Rabs g0) by apply Rabs_pos; assert (0 <= h * h) by apply Rle_0_sqr.
  repeat split; try (left; reflexivity); try (unfold u in *; lra).
  replace (x * (2 * h + x) - g0) with (x * (2 * h + x) - g' + (g' - g0)) by ring.
  eapply Rle_trans; [apply Rabs_triang |]; unfold u in *; lra.
- assert (Z : 2 * (owed - owed) * Q / Mu = 0) by (unfold Rdiv; ring); rewrite Z.
  replace (0 * (2 * h + 0) - 0) with 0 by ring; rewrite !Rabs_R0, Rmult_0_l.
  assert (0 <= h * h) by apply Rle_0_sqr.
  repeat split; try (right; reflexivity); lra.
Qed.

(* --- What a pair goes on with --------------------------------------------------- *)

(* Its speed S changes by x, so that it goes on with a: S^2 becomes S^2 - L, to some u^2 of g^2. *)
Definition goes_on S L g x a :=
  Rabs (x * (2 * S + x) + L) <= 150 * u * u * (g * g) /\ Rabs x <= 2003 / 1000 * g /\
  a * Rabs (S + x - a) <= 60 * u * u * (g * g) /\ Rabs x * Rabs (S + x) <= 202 / 100 * (g * g) /\
  Rabs (S + x) <= 2006 / 1000 * g.

(* And with what is paid beside it, d for G, as y. *)
Lemma with_payment S L g x a h d G y : goes_on S L g x a -> 0 <= a <= 1001 / 1000 * g ->
  Rabs (h - a) <= 1002 / 1000 * u * a ->
  Rabs (d * (2 * h + d) - G) <= 73 / 10 * u * Rabs G -> Rabs d * h <= 52 / 100 * Rabs G ->
  Rabs G <= 97 / 100000000 * (h * h) ->
  Rabs (y - (x + d)) <= u * u * (29 * Rabs x + 25 * Rabs d) ->
  Rabs (y * (2 * S + y) + L - G) <= 270 * u * u * (g * g) + 9 * u * Rabs G /\
  Rabs y <= 201 / 100 * g /\ Rabs G <= / 1000000 * (g * g).
Proof.
intros (E & X & Xa & Xs & Sx) A Ha D Dh Gh Y.
assert (G0 : 0 <= g) by (generalize (Rabs_pos x); lra).
apply Rabs_le_inv in Ha; assert (H0 : 0 <= h) by (unfold u in *; lra).
assert (Hg : 999 / 1000 * a <= h <= 1002 / 1000 * g) by (unfold u in *; lra).
assert (Hh : h * h <= 1002 / 1000 * g * (1002 / 1000 * g)) by (apply Rmult_le_compat; lra).
assert (D0 := Rabs_pos d).
(* h is 0 and nothing paid, or d is a small part of it *)
assert (Ds : Rabs d <= 52 / 100000000 * h).
{ destruct (Req_dec h 0) as [Z | Z].
  - assert (G = 0).
    { rewrite Z, Rmult_0_l, Rmult_0_r in Gh; generalize (Rabs_pos G); intro.
      destruct (Req_dec G 0) as [F | F]; [exact F | apply Rabs_pos_lt in F; lra]. }
    subst G; rewrite Z, Rabs_R0, !Rmult_0_r, Rplus_0_l, Rminus_0_r in D.
    rewrite Rabs_mult in D.
    destruct (Req_dec d 0) as [F | F]; [rewrite F, Rabs_R0; lra |].
    apply Rabs_pos_lt in F; assert (0 < Rabs d * Rabs d) by (apply Rmult_lt_0_compat; exact F).
    lra.
  - apply (Rmult_le_reg_r h); [lra |]; assert (0 <= h * h) by apply Rle_0_sqr; lra. }
assert (G2 : 0 <= g * g) by (apply Rmult_le_pos; exact G0).
set (e := y - (x + d)) in *; assert (Ey : y = x + d + e) by (unfold e; ring).
assert (Eg : Rabs e <= 59 * u * u * g) by (unfold u in *; lra).
assert (T1 : Rabs (d * (2 * a + d) - G) <= 84 / 10 * u * Rabs G).
{ replace (d * (2 * a + d) - G) with (d * (2 * h + d) - G + d * (2 * (a - h))) by ring.
  eapply Rle_trans; [apply Rabs_triang |].
  assert (Rabs (d * (2 * (a - h))) <= Rabs d * (2007 / 1000 * u * h)).
  { rewrite Rabs_mult; apply Rmult_le_compat_l; [exact D0 |].
    apply Rabs_le; unfold u in *; lra. }
  generalize (Rabs_pos G); unfold u in *; lra. }
assert (T2 : Rabs (2 * (d * (S + x - a))) <= / 1000 * u * u * (g * g)).
{ rewrite !Rabs_mult, (Rabs_pos_eq 2) by lra.
  assert (Rabs d * Rabs (S + x - a) <= / 1000000 * a * Rabs (S + x - a)).
  { apply Rmult_le_compat_r; [apply Rabs_pos |]; unfold u in *; lra. }
  unfold u in *; lra. }
assert (T3 : Rabs (2 * (e * (S + x))) <= 1172 / 10 * u * u * (g * g)).
{ rewrite !Rabs_mult, (Rabs_pos_eq 2) by lra.
  assert (Rabs e * Rabs (S + x) <= u * u * (29 * Rabs x + 25 * Rabs d) * Rabs (S + x))
    by (apply Rmult_le_compat_r; [apply Rabs_pos | exact Y]).
  assert (Rabs d * Rabs (S + x) <= 53 / 100000000 * g * (2006 / 1000 * g))
    by (apply Rmult_le_compat; try apply Rabs_pos; lra).
  set (xs := Rabs x * Rabs (S + x)) in *; set (ds := Rabs d * Rabs (S + x)) in *.
  replace (u * u * (29 * Rabs x + 25 * Rabs d) * Rabs (S + x)) with
    (u * u * (29 * xs + 25 * ds)) in H by (unfold xs, ds; ring).
  unfold u in *; lra. }
assert (T4 : Rabs (e * (2 * d + e)) <= / 1000 * u * u * (g * g)).
{ rewrite Rabs_mult; assert (Rabs (2 * d + e) <= 107 / 100000000 * g).
  { eapply Rle_trans; [apply Rabs_triang |]; rewrite Rabs_mult, (Rabs_pos_eq 2) by lra.
    unfold u in *; lra. }
  assert (Rabs e * Rabs (2 * d + e) <= 59 * u * u * g * (107 / 100000000 * g))
    by (apply Rmult_le_compat; try apply Rabs_pos; assumption).
  unfold u in *; lra. }
split.
2: { split; [| lra]; rewrite Ey.
  assert (Rabs (x + d + e) <= Rabs x + Rabs d + Rabs e).
  { eapply Rle_trans; [apply Rabs_triang |]; apply Rplus_le_compat_r, Rabs_triang. }
  unfold u in *; lra. }
replace (y * (2 * S + y) + L - G) with (x * (2 * S + x) + L + (d * (2 * a + d) - G) +
  2 * (d * (S + x - a)) + 2 * (e * (S + x)) + e * (2 * d + e)) by (rewrite Ey; ring).
set (t0 := x * _ + L) in *; set (t1 := d * _ - G) in *; set (t2 := 2 * (d * _)) in *.
set (t3 := 2 * (e * _)) in *; set (t4 := e * _) in *; set (gg := g * g) in *.
assert (0 <= Rabs G) by apply Rabs_pos.
apply Rabs_le_inv in E; apply Rabs_le_inv in T1; apply Rabs_le_inv in T2.
apply Rabs_le_inv in T3; apply Rabs_le_inv in T4; clearbody t0 t1 t2 t3 t4 gg.
apply Rabs_le; unfold u in *; lra.
Qed.
