(* SPDX-License-Identifier: MIT *)
(* with: event_time.v *)
(* What a pair does at a step, in real numbers: the expressions of impulse.c
   keep momentum and, to the rise crossed, energy; for any two masses, wherever
   the pair was put. *)
From Coq Require Import Reals Psatz.
From Brink Require Import event_time.
Open Scope R_scope.

Section Pair.
Variables (r : vector) (m1 m2 : R).
Hypotheses (M1 : 0 < m1) (M2 : 0 < m2).

Definition kinetic (v1 v2 : vector) := m1 * dot v1 v1 / 2 + m2 * dot v2 v2 / 2.
Definition momentum (v1 v2 : vector) := add (times m1 v1) (times m2 v2).

(* pair_make() *)
Definition k1 := m2 / (m1 + m2).
Definition k2 := m1 / (m1 + m2).
Definition mu := k1 * m1.
Definition rr := dot r r.
Definition speed (v1 v2 : vector) := dot r (sub v1 v2). (* b *)

(* The energy of the radial motion, as impulse.h has it. *)
Definition radial_energy (b : R) := mu * b * b / (2 * rr).

(* pair_kick() *)
Definition kick1 (w v1 : vector) := add v1 (times k1 w).
Definition kick2 (w v2 : vector) := add v2 (times (- k2) w).

Theorem mu_is_reduced_mass : mu = m1 * m2 / (m1 + m2) /\ 0 < mu.
Proof.
split; unfold mu, k1; [field; lra|].
apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat|]; lra.
Qed.

(* Whatever w, momentum is kept, and w is what the relative velocity changes
   by. *)
Theorem kick_keeps_momentum w v1 v2 :
  momentum (kick1 w v1) (kick2 w v2) = momentum v1 v2 /\
  sub (kick1 w v1) (kick2 w v2) = add (sub v1 v2) w.
Proof.
split; unfold momentum, kick1, kick2, sub, add, times, k1, k2; simpl;
  f_equal; field; lra.
Qed.

Theorem kick_changes_energy w v1 v2 :
  kinetic (kick1 w v1) (kick2 w v2)
  = kinetic v1 v2 + mu * (dot w (sub v1 v2) + dot w w / 2).
Proof.
unfold kinetic, kick1, kick2, mu, k1, k2, dot, sub, add, times; simpl.
field; lra.
Qed.

(* --- Along the line of centres ---------------------------------------------- *)

Hypothesis Apart : rr <> 0. (* there is a line of centres: r is not 0 *)

Lemma rr_pos : 0 < rr.
Proof. unfold rr, dot in *; nra. Qed.

(* pair_change(): w for a change of b. *)
Definition along (change : R) := times (change / rr) r.
Definition change1 (change : R) := kick1 (along change).
Definition change2 (change : R) := kick2 (along change).

(* b becomes b + change, the radial energy with it and no other; the angular
   momentum is kept, and r.dp is mu change. *)
Theorem change_is_radial change v1 v2 :
  let b := speed v1 v2 in
  speed (change1 change v1) (change2 change v2) = b + change /\
  kinetic (change1 change v1) (change2 change v2)
    = kinetic v1 v2 + radial_energy (b + change) - radial_energy b /\
  cross r (sub (change1 change v1) (change2 change v2)) = cross r (sub v1 v2) /\
  dot r (times m1 (sub (change1 change v1) v1)) = mu * change.
Proof.
pose proof rr_pos; intro b.
unfold change1, change2; rewrite (proj2 (kick_keeps_momentum _ _ _)).
assert (dot r (along change) = change) as Along.
{ replace (dot r (along change)) with (change / rr * rr); [field; lra|].
  unfold along; generalize (change / rr); intro k.
  unfold rr, dot, times; simpl; ring. }
repeat split.
- unfold speed, change1, change2; rewrite (proj2 (kick_keeps_momentum _ _ _)).
  transitivity (b + dot r (along change)); [|rewrite Along; ring].
  generalize (along change); intro w.
  unfold b, speed, dot, sub, add, times; simpl; ring.
- rewrite kick_changes_energy.
  replace (dot (along change) (sub v1 v2)) with (change / rr * b)
    by (unfold along, b, speed; generalize (change / rr); intro k;
        unfold dot, times; simpl; ring).
  replace (dot (along change) (along change))
    with (change / rr * dot r (along change))
    by (unfold along; generalize (change / rr); intro k;
        unfold dot, times; simpl; ring).
  rewrite Along.
  unfold radial_energy; field; lra.
- unfold along; generalize (change / rr); intro k.
  unfold cross, sub, add, times; simpl; f_equal; ring.
- transitivity (mu * dot r (along change)); [|rewrite Along; ring].
  generalize (along change); intro w.
  unfold kick1, mu, dot, sub, add, times; simpl; ring.
Qed.

(* --- What is owed ----------------------------------------------------------- *)

(* pair_pay(): the change of a speed that is `after` without it. *)
Definition gain (owed : R) := 2 * owed * rr / mu.
Definition is_paid (owed after : R) := Rabs (gain owed) < / 2 ^ 20 * (after *
  after).
Definition payment (owed after : R) :=
  gain owed / (after + sqrt (after * after + gain owed)).

(* Paid, it is in the radial energy, to the last of it. *)
Theorem payment_pays owed after : 0 < after -> is_paid owed after ->
  radial_energy (after + payment owed after) = radial_energy after + owed /\
  0 < after + payment owed after.
Proof.
intros A Paid; pose proof rr_pos; pose proof (proj2 mu_is_reduced_mass).
unfold is_paid in Paid; apply Rabs_def2 in Paid.
assert (0 < after * after + gain owed) as P by nra.
pose proof (sqrt_lt_R0 _ P); pose proof (sqrt_sqrt _ (Rlt_le _ _ P)) as S.
assert (after + payment owed after = sqrt (after * after + gain owed)) as E.
{ unfold payment; set (s := sqrt _) in *.
  replace (gain owed) with (s * s - after * after) by lra; field; lra. }
rewrite E; split; [|lra].
unfold radial_energy; rewrite !Rmult_assoc, S; unfold gain; field; lra.
Qed.

(* --- Core, bounce, crossing ------------------------------------------------- *)

Variable way : R. (* 1: outward, -1: inward *)
Hypothesis Way : way = 1 \/ way = -1.

Lemma way_square : way * way = 1.
Proof. destruct Way as [-> | ->]; ring. Qed.

(* Both as the code has them, with what is paid in p (0 where nothing is). *)
Definition reflection (b p : R) :=
  if Rlt_dec 0 (b * way) then -2 * b + - way * p else 0.

Definition loss (rise : R) := rr * (2 * rise) / mu.
Definition crosses (rise b : R) := 0 < b * way * (b * way) - loss rise.
Definition after (rise b : R) := sqrt (b * way * (b * way) - loss rise).
Definition crossing (rise b p : R) :=
  let s := b * way in
  ((if Rlt_dec 0 s then - loss rise / (after rise b + s) else after rise b - s)
    + p)
  * way.

(* exact_surplus(): the pair crosses if its radial energy suffices. *)
Theorem crosses_if_energy_suffices rise b :
  (crosses rise b <-> rise < radial_energy b) /\
  (crosses rise b <-> 0 < m1 * m2 * (b * b) - 2 * rise * rr * (m1 + m2)).
Proof.
pose proof rr_pos; pose proof (proj2 mu_is_reduced_mass).
unfold crosses.
replace (b * way * (b * way) - loss rise) with (b * b - loss rise)
  by (pose proof way_square; nra).
split.
- replace (b * b - loss rise) with ((radial_energy b - rise) * (2 * rr / mu))
    by (unfold loss, radial_energy; field; lra).
  assert (0 < 2 * rr / mu) by (apply Rdiv_lt_0_compat; lra).
  split; intro; nra.
- replace (b * b - loss rise)
    with ((m1 * m2 * (b * b) - 2 * rise * rr * (m1 + m2)) * / (m1 * m2))
    by (unfold loss, mu, k1; field; lra).
  assert (0 < / (m1 * m2)) by (apply Rinv_0_lt_compat; nra).
  split; intro; nra.
Qed.

(* A reflection: b goes against `way` afterwards, with the radial energy it had
   and what is paid. *)
Theorem reflection_keeps_energy b p :
  (b * way <= 0 -> reflection b p = 0) /\
  (0 < b * way -> b + reflection b p = - way * (b * way + p)).
Proof.
pose proof way_square as W.
unfold reflection; split; intro; destruct (Rlt_dec 0 (b * way)); try lra.
replace (- way * (b * way + p)) with (- (way * way * b) - way * p) by ring.
rewrite W; ring.
Qed.

(* A crossing: b is along `way` afterwards, with the radial energy less the
   rise and what is paid. *)
Theorem crossing_costs_the_rise rise b p : crosses rise b ->
  b + crossing rise b p = way * (after rise b + p) /\ 0 < after rise b /\
  radial_energy (after rise b) = radial_energy b - rise.
Proof.
intro C; pose proof rr_pos; pose proof (proj2 mu_is_reduced_mass).
pose proof way_square as W; unfold crossing.
pose proof (sqrt_lt_R0 _ C) as P; pose proof (sqrt_sqrt _ (Rlt_le _ _ C)) as S.
fold (after rise b) in P, S; set (x := after rise b) in *; clearbody x.
split; [|split; [exact P|]].
- assert (b = b * way * way) as E by (rewrite Rmult_assoc, W; ring).
  rewrite E at 1; clear E; set (s := b * way) in *; clearbody s.
  destruct (Rlt_dec 0 s); [|ring].
  replace (- loss rise) with (x * x - s * s) by lra; field; lra.
- unfold radial_energy; rewrite !Rmult_assoc, S.
  replace (b * way * (b * way)) with (b * b * (way * way)) by ring.
  rewrite W; unfold loss; field; lra.
Qed.

(* The whole account.  Energy after and owed after are energy before and owed
   before, less the rise where it was crossed; what is not paid stays owed. *)
Definition paid (owed after : R) :=
  if Rlt_dec (Rabs (gain owed)) (/ 2 ^ 20 * (after * after))
  then payment owed after else 0.
Definition owed_after (owed after : R) :=
  if Rlt_dec (Rabs (gain owed)) (/ 2 ^ 20 * (after * after)) then 0 else owed.

Lemma paid_and_owed owed x : 0 < x ->
  radial_energy (x + paid owed x) + owed_after owed x = radial_energy x + owed /\
  0 < x + paid owed x.
Proof.
intro X; unfold paid, owed_after; destruct (Rlt_dec _ _) as [P|P].
- destruct (payment_pays owed x X P); split; lra.
- rewrite Rplus_0_r; split; lra.
Qed.

Lemma radial_energy_of_way s : radial_energy (way * s) = radial_energy s.
Proof.
unfold radial_energy; replace (mu * (way * s) * (way * s))
  with (mu * s * s * (way * way)) by ring.
rewrite way_square; f_equal; ring.
Qed.

Theorem step_balances rise owed v1 v2 : let b := speed v1 v2 in
  crosses rise b ->
  let x := after rise b in let change := crossing rise b (paid owed x) in
  let v1' := change1 change v1 in let v2' := change2 change v2 in
  kinetic v1' v2' + owed_after owed x = kinetic v1 v2 + owed - rise /\
  momentum v1' v2' = momentum v1 v2 /\ 0 < speed v1' v2' * way.
Proof.
intros b C x change v1' v2'; pose proof way_square as W.
destruct (change_is_radial change v1 v2) as (B & E & _ & _).
destruct (crossing_costs_the_rise rise b (paid owed x) C) as (S & X & R).
destruct (paid_and_owed owed x X) as [P Q].
assert (b + change = way * (x + paid owed x)) as S' by exact S.
unfold v1', v2'; split; [|split; [apply kick_keeps_momentum|]].
- fold b in E; rewrite E, S', radial_energy_of_way; unfold x in *; lra.
- rewrite B; fold b; rewrite S'; nra.
Qed.

(* A core is met inward. *)
Theorem reflection_balances owed v1 v2 : let b := speed v1 v2 in
  0 < b * way ->
  let s := b * way in let change := reflection b (paid owed s) in
  let v1' := change1 change v1 in let v2' := change2 change v2 in
  kinetic v1' v2' + owed_after owed s = kinetic v1 v2 + owed /\
  momentum v1' v2' = momentum v1 v2 /\ speed v1' v2' * way < 0.
Proof.
intros b S s change v1' v2'; pose proof way_square as W.
destruct (change_is_radial change v1 v2) as (B & E & _ & _).
destruct (paid_and_owed owed s S) as [P Q].
assert (b + change = - way * (s + paid owed s)) as S'
  by exact (proj2 (reflection_keeps_energy b (paid owed s)) S).
replace (- way * (s + paid owed s))
  with (way * - (s + paid owed s)) in S' by ring.
unfold v1', v2'; split; [|split; [apply kick_keeps_momentum|]].
- fold b in E; rewrite E, S', radial_energy_of_way.
  assert (radial_energy b = radial_energy s) as ->.
  { unfold s; rewrite (Rmult_comm b); symmetry; apply radial_energy_of_way. }
  replace (radial_energy (- (s + paid owed s)))
    with (radial_energy (s + paid owed s))
    by (unfold radial_energy; f_equal; ring).
  lra.
- rewrite B; fold b; rewrite S'; nra.
Qed.

(* --- The rim rule ----------------------------------------------------------- *)

Definition angle := / 2 ^ 24. (* BRINK_RIM_ANGLE *)

Variables v1 v2 : vector.
Let v := sub v1 v2.
Let vv := dot v v.
Let b := dot r v.

Definition rim := sqrt (rr * vv) * angle.
Definition stretch := sqrt ((vv - rim * rim / rr) / (vv - b * b / rr)).
Definition rim_change :=
  let tangent := sub v (times (b / rr) r) in
  sub (add (times stretch tangent) (times (- (rim / rr)) r)) v.

(* The relative velocity is turned inward to just that angle to the tangent,
   its magnitude kept, hence the energy; the angular momentum changes to first
   order by angle^2 / 2, never by more than 2^-49 + 2^-97 of itself. *)
Theorem rim_keeps_energy : Rabs b < rim ->
  let v1' := kick1 rim_change v1 in let v2' := kick2 rim_change v2 in
  let v' := sub v1' v2' in
  kinetic v1' v2' = kinetic v1 v2 /\ momentum v1' v2' = momentum v1 v2 /\
  dot v' v' = vv /\ dot r v' = - (sqrt (rr * vv) * angle) /\
  cross r v' = times stretch (cross r v) /\
  0 <= 1 - stretch <= / 2 ^ 49 + / 2 ^ 97.
Proof.
intros B v1' v2' v'; pose proof rr_pos as RR.
assert (0 <= vv) as VV by (unfold vv, dot; nra).
assert (0 <= rr * vv) as RV by nra.
assert (rim * rim = rr * vv * (angle * angle)) as Rim.
{ unfold rim; rewrite <- (sqrt_sqrt _ RV) at 3; ring. }
assert (angle * angle = / 2 ^ 48) as Angle by (unfold angle; lra).
rewrite Angle in Rim.
assert (b * b < rim * rim) as BB.
{ destruct (Rabs_def2 _ _ B); nra. }
assert (0 < vv) as V by (pose proof (Rle_0_sqr b); unfold Rsqr in *; nra).
assert (rim * rim / rr = vv * / 2 ^ 48) as E1 by (rewrite Rim; field; lra).
assert (b * b / rr < rim * rim / rr) as E2.
{ apply Rmult_lt_compat_r; [apply Rinv_0_lt_compat|]; lra. }
assert (0 <= b * b / rr) as E3.
{ apply Rmult_le_pos; [apply Rle_0_sqr|].
  apply Rlt_le, Rinv_0_lt_compat; lra. }
set (q := b * b / rr) in *.
assert (0 < vv - q) as Q by lra.
set (z := (vv - rim * rim / rr) / (vv - q)).
assert (z * (vv - q) = vv - vv * / 2 ^ 48) as Z
  by (unfold z; rewrite E1; field; lra).
assert (1 - / 2 ^ 48 <= z < 1) as Z' by (split; nra).
assert (stretch * stretch = z) as S by (apply sqrt_sqrt; lra).
assert (0 <= stretch) as S0 by apply sqrt_pos.
assert (v' = add v rim_change) as Turned by apply kick_keeps_momentum.
assert (dot v' v' = vv) as Same.
{ rewrite Turned.
  replace (dot (add v rim_change) (add v rim_change))
    with (stretch * stretch * (vv - 2 * (b / rr) * b + b / rr * (b / rr) * rr)
          - 2 * stretch * (rim / rr) * (b - b / rr * rr)
          + rim / rr * (rim / rr) * rr)
    by (unfold rim_change; generalize (b / rr) (rim / rr) stretch; intros k l e;
        unfold vv, b, rr, dot, add, sub, times; simpl; ring).
  rewrite S.
  replace (vv - 2 * (b / rr) * b + b / rr * (b / rr) * rr) with (vv - q)
    by (unfold q; field; lra).
  replace (b - b / rr * rr) with 0 by (field; lra).
  replace (rim / rr * (rim / rr) * rr) with (rim * rim / rr) by (field; lra).
  lra. }
split; [|split; [apply kick_keeps_momentum|split; [exact Same|split; [|split]]]].
- unfold v1', v2'; rewrite kick_changes_energy; fold v.
  replace (dot rim_change v + dot rim_change rim_change / 2)
    with ((dot (add v rim_change) (add v rim_change) - vv) / 2)
    by (unfold vv; generalize rim_change v; intros w y;
        unfold dot, add; simpl; field).
  rewrite <- Turned, Same; field.
- rewrite Turned; fold rim.
  replace (dot r (add v rim_change))
    with (stretch * (b - b / rr * rr) - rim / rr * rr)
    by (unfold rim_change; generalize (b / rr) (rim / rr) stretch; intros k l e;
        unfold b, rr, dot, add, sub, times; simpl; ring).
  field; lra.
- rewrite Turned; unfold rim_change.
  generalize (b / rr) (rim / rr) stretch; intros k l e.
  unfold cross, add, sub, times; simpl; f_equal; ring.
- assert (stretch < 1) by nra; split; [lra|].
  assert (stretch >= z) by nra.
  assert ((1 - stretch) * (1 + stretch) = 1 - z) by (rewrite <- S; ring).
  assert ((1 - stretch) * (2 - / 2 ^ 48) <= / 2 ^ 48) by nra.
  lra.
Qed.
End Pair.

(* --- What rounding takes ---------------------------------------------------- *)

(* pair_kick(): a velocity x + y is rounded to x, |y| <= u |x|.  The account
   puts down m x y; what that leaves out of the energy is m y^2 / 2, u^2 of it.
   *)
Theorem account_of_rounding m x y u : 0 < m -> 0 <= u -> Rabs y <= u * Rabs x ->
  0 <= m * (x + y) * (x + y) / 2 - (m * x * x / 2 + m * (x * y))
  <= u * u * (m * x * x / 2).
Proof.
intros M U Y.
replace (m * (x + y) * (x + y) / 2 - (m * x * x / 2 + m * (x * y)))
  with (m * (y * y) / 2) by field.
assert (y * y <= u * u * (x * x)).
{ pose proof (Rabs_pos y); pose proof (Rsqr_abs x); pose proof (Rsqr_abs y).
  unfold Rsqr in *; nra. }
pose proof (Rle_0_sqr y); unfold Rsqr in *; split; nra.
Qed.
