(* SPDX-License-Identifier: MIT *)
(* When a pair meets a sphere or leaves it, in real numbers: the functions that
   the kernels evaluate are the moments that event_time.h promises. *)
From Coq Require Import Reals Psatz.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

(* --- Vectors ---------------------------------------------------------------- *)

Record vector := Vector { x1 : R; x2 : R; x3 : R }.

Definition add (p q : vector) := Vector (x1 p + x1 q) (x2 p + x2 q) (x3 p + x3 q).
Definition times (k : R) (p : vector) := Vector (k * x1 p) (k * x2 p) (k * x3 p).
Definition sub (p q : vector) := add p (times (-1) q).
Definition dot (p q : vector) := x1 p * x1 q + x2 p * x2 q + x3 p * x3 q.
Definition cross (p q : vector) :=
  Vector (x2 p * x3 q - x3 p * x2 q) (x3 p * x1 q - x1 p * x3 q)
         (x1 p * x2 q - x2 p * x1 q).

(* The smallest t >= 0 with a property. *)
Definition first (P : R -> Prop) (t : R) :=
  0 <= t /\ P t /\ forall s, 0 <= s < t -> ~ P s.

(* What a time means: the first t >= 0 with the property, +inf where there is
   none. *)
Definition means (P : R -> Prop) (time : Rbar) :=
  match time with
  | Finite t => first P t
  | p_infty => forall t, 0 <= t -> ~ P t
  | m_infty => False
  end.

(* --- A pair in free flight -------------------------------------------------- *)

Section Pair.
Variables (r v : vector) (sigma : R).

Definition at_time (t : R) := add r (times t v).

(* overlap.h *)
Definition ball_overlap (r : vector) := dot r r - sigma * sigma.
Definition ball_overlap_rate (r v : vector) := dot r v.

Definition f (t : R) := ball_overlap (at_time t).

(* event_time_sums.h *)
Definition a := dot v v.
Definition b := dot r v.
Definition c := dot r r - sigma * sigma.
Definition d := b * b - a * c.

(* d as the filters and the double-double path form it: Lagrange's identity. *)
Theorem d_is_cross : d = sigma * sigma * a - dot (cross r v) (cross r v).
Proof. unfold d, a, b, c, dot, cross; simpl; ring. Qed.

Theorem f_is_polynomial t : f t = a * t * t + 2 * b * t + c.
Proof. unfold f, ball_overlap, at_time, a, b, c, dot, add, times; simpl;
  ring. Qed.

(* The derivative is the derivative: f' = 2 (b + a t), and twice the overlap
   rate at the place where the pair is then. *)
Theorem f_derives t : is_derive f t (2 * (b + a * t)).
Proof.
apply is_derive_ext with (fun t => a * t * t + 2 * b * t + c).
- intro s; symmetry; apply f_is_polynomial.
- auto_derive; [exact I | ring].
Qed.

Theorem rate_is_derivative t :
  Derive f t = 2 * ball_overlap_rate (at_time t) v.
Proof.
rewrite (is_derive_unique _ _ _ (f_derives t)).
unfold ball_overlap_rate, at_time, a, b, dot, add, times; simpl; ring.
Qed.

Lemma derivative t : Derive f t = 2 * (b + a * t).
Proof. apply is_derive_unique, f_derives. Qed.

Lemma a_nonneg : 0 <= a.
Proof. unfold a, dot; nra. Qed.

(* A pair at rest stays where it is. *)
Lemma at_rest : a = 0 -> b = 0.
Proof.
unfold a, b, dot; intro Z.
assert (x1 v = 0 /\ x2 v = 0 /\ x3 v = 0) as (-> & -> & ->)
  by (repeat split; nra).
ring.
Qed.

(* f against its roots: a f = (a t + b)^2 - d. *)
Lemma completed_square t : a * f t = (a * t + b) * (a * t + b) - d.
Proof. rewrite f_is_polynomial; unfold d; ring. Qed.

(* --- Intersection ----------------------------------------------------------- *)

(* Inside or on the sphere, and still approaching [S16 eq. 3]. *)
Definition meets (t : R) := f t <= 0 /\ Derive f t < 0.

(* The function that every path of brink_intersection_time evaluates. *)
Definition intersection_time : Rbar :=
  if Rle_dec 0 b then p_infty
  else if Rle_dec c 0 then Finite 0
  else if Rle_dec d 0 then p_infty
  else Finite (c / (sqrt d - b)).

(* Its quotient is the earlier root of f; its denominator adds two numbers of one
   sign. *)
Theorem earlier_root : b < 0 -> 0 <= d -> 0 < a ->
  c / (sqrt d - b) = (- b - sqrt d) / a /\ 0 <= sqrt d /\ 0 < - b.
Proof.
intros B D A.
pose proof (sqrt_pos d); pose proof (sqrt_sqrt d D) as S.
split; [|lra].
apply Rmult_eq_reg_l with (a * (sqrt d - b)); [|nra].
replace (a * (sqrt d - b) * (c / (sqrt d - b))) with (a * c) by (field; lra).
replace (a * (sqrt d - b) * ((- b - sqrt d) / a))
  with (b * b - sqrt d * sqrt d) by (field; lra).
rewrite S; unfold d; ring.
Qed.

Theorem intersection_time_is_right : means meets intersection_time.
Proof.
pose proof a_nonneg as A; pose proof at_rest as Rest.
unfold intersection_time, means.
destruct (Rle_dec 0 b) as [B|B].
{ intros t T [_ M]; rewrite derivative in M; nra. }
assert (0 < a) by (destruct A as [A|A]; [exact A | specialize (Rest (eq_sym A));
  lra]).
destruct (Rle_dec c 0) as [C|C].
{ split; [lra|]; split; [|intros; lra]; split.
  - rewrite f_is_polynomial; lra.
  - rewrite derivative; lra. }
destruct (Rle_dec d 0) as [D|D].
{ intros t T [M1 M2]; rewrite derivative in M2.
  pose proof (completed_square t); nra. }
assert (0 <= d) as D0 by lra.
destruct (earlier_root ltac:(lra) D0 ltac:(assumption)) as (E & S0 & _).
pose proof (sqrt_sqrt d D0) as S; pose proof (sqrt_lt_R0 d ltac:(lra)).
assert (a * (c / (sqrt d - b)) = - b - sqrt d) as E' by (rewrite E; field; lra).
set (t := c / (sqrt d - b)) in *.
assert (0 < t) by (apply Rdiv_lt_0_compat; lra).
split; [lra|]; split; [split|].
- pose proof (completed_square t); nra.
- rewrite derivative; nra.
- intros s [S1 S2] [M _].
  pose proof (completed_square s).
  assert (a * s < a * t) by nra.
  nra.
Qed.

(* --- Disjoint --------------------------------------------------------------- *)

(* From then on outside and parting. *)
Definition is_apart_from (t : R) := forall s, t < s -> 0 < f s /\ 0 < Derive f s.

(* The function that every path of brink_disjoint_time evaluates: later_root() and
   passing_time() of event_time_parting.h. *)
Definition disjoint_time : Rbar :=
  if Req_EM_T a 0 then p_infty
  else if Rle_dec d 0 then Finite (Rmax 0 (- b) / a)
  else if Rlt_dec 0 b then Finite (Rmax 0 (- c) / (sqrt d + b))
  else Finite ((sqrt d - b) / a).

(* In both branches the quotient is the later root of f, or 0 where that is past;
   each adds numbers of one sign. *)
Theorem later_root : 0 < a -> 0 < d ->
  (0 < b -> Rmax 0 (- c) / (sqrt d + b) = Rmax 0 ((sqrt d - b) / a)) /\
  (b <= 0 -> 0 <= - b /\ (sqrt d - b) / a = Rmax 0 ((sqrt d - b) / a)).
Proof.
intros A D.
pose proof (sqrt_lt_R0 d D); pose proof (sqrt_sqrt d ltac:(lra)) as S.
split; intro B.
- assert (- c / (sqrt d + b) = (sqrt d - b) / a) as <-.
  { apply Rmult_eq_reg_l with (a * (sqrt d + b)); [|nra].
    replace (a * (sqrt d + b) * (- c / (sqrt d + b))) with (- (a * c))
      by (field; lra).
    replace (a * (sqrt d + b) * ((sqrt d - b) / a))
      with (sqrt d * sqrt d - b * b) by (field; lra).
    rewrite S; unfold d; ring. }
  assert (0 < / (sqrt d + b)) by (apply Rinv_0_lt_compat; lra).
  unfold Rmax, Rdiv.
  destruct (Rle_dec 0 (- c)); destruct (Rle_dec 0 (- c * _)); nra.
- split; [lra|].
  symmetry; apply Rmax_right, Rlt_le, Rdiv_lt_0_compat; lra.
Qed.

(* Behind the closest approach and not inside: apart from then on; and not before,
   if that is now, or the closest approach, or the later root. *)
Lemma first_apart t : 0 < a -> 0 <= t -> 0 <= a * t + b ->
  d <= (a * t + b) * (a * t + b) ->
  t = 0 \/ (a * t + b) * (a * t + b) = Rmax d 0 -> first is_apart_from t.
Proof.
intros A T B D Now; split; [exact T | split].
- intros s S; rewrite derivative; pose proof (completed_square s).
  assert (a * t < a * s) by nra; split; nra.
- intros s [S1 S2] Apart.
  destruct (Apart ((s + t) / 2)) as [M1 M2]; [lra|].
  rewrite derivative in M2; pose proof (completed_square ((s + t) / 2)).
  set (h := (s + t) / 2) in *; assert (h < t) by (unfold h; lra).
  assert (a * h < a * t) by nra.
  destruct Now as [Now|Now]; [lra|].
  unfold Rmax in Now; destruct (Rle_dec d 0); nra.
Qed.

Theorem disjoint_time_is_right : means is_apart_from disjoint_time.
Proof.
pose proof a_nonneg as A; pose proof at_rest as Rest.
unfold disjoint_time, means.
destruct (Req_EM_T a 0) as [Z|Z].
{ intros t T Apart; destruct (Apart (t + 1)) as [_ M]; [lra|].
  rewrite derivative, (Rest Z), Z in M; lra. }
assert (0 < a) by lra.
destruct (Rle_dec d 0) as [D|D].
{ destruct (Rle_dec 0 (- b)) as [B|B].
  - rewrite Rmax_right by exact B.
    assert (a * (- b / a) + b = 0) as E by (field; lra).
    apply first_apart; rewrite ?E; try lra; [apply Rdiv_le_0_compat; lra|].
    right; rewrite Rmax_right; lra.
  - rewrite Rmax_left by lra.
    replace (0 / a) with 0 by (field; lra).
    apply first_apart; try lra; apply Rle_trans with 0;
      [exact D | apply Rle_0_sqr]. }
pose proof (sqrt_lt_R0 d ltac:(lra)); pose proof (sqrt_sqrt d ltac:(lra)) as S.
destruct (later_root ltac:(lra) ltac:(lra)) as [Ahead Behind].
assert (a * ((sqrt d - b) / a) = sqrt d - b) as E by (field; lra).
assert (first is_apart_from (Rmax 0 ((sqrt d - b) / a))).
{ set (t := (sqrt d - b) / a) in *.
  unfold Rmax at 1; destruct (Rle_dec 0 t) as [T|T].
  - apply first_apart; rewrite ?E; rewrite ?(Rmax_left d 0); try lra; nra.
  - assert (a * t < 0) by nra; apply first_apart; try lra; nra. }
destruct (Rlt_dec 0 b) as [B|B].
- rewrite (Ahead B); assumption.
- rewrite (proj2 (Behind ltac:(lra))); assumption.
Qed.

(* As event_time.h has it: never +inf but at rest. *)
Theorem disjoint_time_is_finite : disjoint_time = p_infty <-> v = Vector 0 0 0.
Proof.
split.
- unfold disjoint_time; destruct (Req_EM_T a 0) as [Z|_].
  + intros _; unfold a, dot in Z.
    assert (x1 v = 0 /\ x2 v = 0 /\ x3 v = 0) as (X & Y & W)
      by (repeat split; nra).
    destruct v; simpl in *; congruence.
  + destruct (Rle_dec d 0); [|destruct (Rlt_dec 0 b)]; discriminate.
- intro Z; unfold disjoint_time, a; rewrite Z; unfold dot; simpl.
  destruct (Req_EM_T _ 0) as [_|N]; [reflexivity | contradict N; ring].
Qed.
End Pair.

(* --- Half-space ------------------------------------------------------------- *)

Section Plane.
Variables (r v n c : vector).

(* overlap.h [S16 eq. 4], along the flight *)
Definition f_plane (t : R) := dot n (sub (add r (times t v)) c).

Theorem f_plane_derives t : is_derive f_plane t (dot n v).
Proof.
unfold f_plane, dot, sub, add, times; simpl.
auto_derive; [exact I | ring].
Qed.

Definition meets_plane (t : R) := f_plane t <= 0 /\ Derive f_plane t < 0.

(* The function that brink_halfspace_time evaluates. *)
Definition halfspace_time : Rbar :=
  if Rle_dec 0 (dot n v) then p_infty
  else if Rle_dec (f_plane 0) 0 then Finite 0
  else Finite (f_plane 0 / - dot n v).

Theorem halfspace_time_is_right : means meets_plane halfspace_time.
Proof.
assert (forall t, Derive f_plane t = dot n v) as Rate
  by (intro t; apply is_derive_unique, f_plane_derives).
assert (forall t, f_plane t = f_plane 0 + t * dot n v) as Line
  by (intro t; unfold f_plane, dot, sub, add, times; simpl; ring).
unfold halfspace_time, means.
destruct (Rle_dec 0 (dot n v)) as [N|N].
{ intros t T [_ M]; rewrite Rate in M; lra. }
destruct (Rle_dec (f_plane 0) 0) as [F|F].
{ split; [lra|]; split; [split; [exact F | rewrite Rate; lra] | intros; lra]. }
set (t := f_plane 0 / - dot n v).
assert (t * dot n v = - f_plane 0) as E by (unfold t; field; lra).
split; [apply Rlt_le, Rdiv_lt_0_compat; lra|].
split; [split; [rewrite Line; lra | rewrite Rate; lra]|].
intros s [S1 S2] [M _]; rewrite Line in M; nra.
Qed.
End Plane.
