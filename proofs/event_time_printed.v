(* SPDX-License-Identifier: MIT *)
(* with: event_time.v *)
(* Algorithm 2 as [S16] prints it is refuted by exhibited pairs: with its
   branches the wrong way round it divides 0 by 0 in real numbers, and in
   binary64 answers NaN, or "now", or another time than when the pair leaves.
   *)
From Coq Require Import Reals Psatz ZArith.
From Coquelicot Require Import Coquelicot.
From Flocq Require Import Core BinarySingleNaN Binary Bits.
From Brink Require Import event_time.
Open Scope R_scope.

(* --- In real numbers -------------------------------------------------------- *)

(* A pair in the middle of its way through: on the sphere, going in. *)
Definition r0 := Vector (-1) 0 0.
Definition v0 := Vector 1 0 0.

(* b = -1, so the printed branch is -c / (sqrt d + b), and that is 0 / 0. *)
Theorem printed_divides_zero_by_zero :
  b r0 v0 < 0 /\ 0 < d r0 v0 1 /\
  - c r0 1 = 0 /\ sqrt (d r0 v0 1) + b r0 v0 = 0.
Proof.
assert (b r0 v0 = -1 /\ c r0 1 = 0 /\ d r0 v0 1 = 1) as (-> & -> & ->)
  by (unfold d, a, b, c, dot; simpl; lra).
rewrite sqrt_1; lra.
Qed.

(* The pair leaves at 2. *)
Theorem right_answer : disjoint_time r0 v0 1 = Finite 2.
Proof.
assert (a v0 = 1 /\ b r0 v0 = -1 /\ d r0 v0 1 = 1) as (A & B & D)
  by (unfold d, a, b, c, dot; simpl; lra).
unfold disjoint_time; rewrite A, B, D, sqrt_1.
destruct (Req_EM_T 1 0); [lra|].
destruct (Rle_dec 1 0); [lra|].
destruct (Rlt_dec 0 (-1)); [lra|].
f_equal; lra.
Qed.

(* That is all that is wrong of it in real numbers: where its divisor is not 0 the
   printed branch is the later root too. *)
Theorem printed_is_equal_elsewhere r v sigma :
  0 < a v -> 0 <= d r v sigma -> sqrt (d r v sigma) + b r v <> 0 ->
  - c r sigma / (sqrt (d r v sigma) + b r v) = (sqrt (d r v sigma) - b r v) / a v.
Proof.
intros A D N; pose proof (sqrt_sqrt _ D) as S.
set (s := sqrt (d r v sigma)) in *; unfold d in S.
apply Rmult_eq_reg_l with (a v * (s + b r v)).
- replace (a v * (s + b r v) * (- c r sigma / (s + b r v)))
    with (- (a v * c r sigma)) by (field; exact N).
  replace (a v * (s + b r v) * ((s - b r v) / a v))
    with (s * s - b r v * b r v) by (field; lra).
  rewrite S; ring.
- intro Z; apply Rmult_integral in Z; lra.
Qed.

(* --- In binary64 ------------------------------------------------------------ *)

(* Round to nearest even, as the processor computes; no step is left out. *)
Local Notation "x [+] y" := (b64_plus mode_NE x y) (at level 50, left
  associativity).
Local Notation "x [-] y" := (b64_minus mode_NE x y) (at level 50, left
  associativity).
Local Notation "x [*] y" := (b64_mult mode_NE x y) (at level 40, left
  associativity).
Local Notation "x [/] y" := (b64_div mode_NE x y) (at level 40, left
  associativity).
Local Notation root := (b64_sqrt mode_NE).

Definition dot64 (p q : binary64 * binary64 * binary64) :=
  let '(p1, p2, p3) := p in let '(q1, q2, q3) := q in
  p1 [*] q1 [+] p2 [*] q2 [+] p3 [*] q3.

Definition zero := b64_of_bits 0.
Definition is_more (x y : binary64) :=
  match b64_compare x y with Some Gt => true | _ => false end.

(* The quotient that [S16] prints, before max(0, .) is taken, for arg > 0. *)
Definition printed_quotient r v sigma :=
  let a := dot64 v v in
  let b := dot64 r v in
  let c := dot64 r r [-] sigma [*] sigma in
  let arg := b [*] b [-] a [*] c in
  if is_more b zero then (root arg [-] b) [/] a
  else b64_opp c [/] (root arg [+] b).

(* m 2^e *)
Definition double (m e : Z) : binary64 :=
  binary_normalize 53 1024 eq_refl eq_refl mode_NE m e false.
Definition value (x : binary64) := B2FF 53 1024 x.

Definition one := double 1 0.
Definition minus_one := double (-1) 0.
Definition small := double 1 (-26).
Definition little_more := double (1 + 2 ^ 51) (-51).

Theorem doubles_are_what_they_say :
  value one = F754_finite false (2 ^ 52) (-52) /\
  value minus_one = F754_finite true (2 ^ 52) (-52) /\
  value small = F754_finite false (2 ^ 52) (-78) /\
  value little_more = F754_finite false (2 ^ 52 + 2) (-52).
Proof. vm_compute; repeat split. Qed.

(* The pair above: not a number, which max(0, .) makes "now". *)
Theorem printed_is_not_a_number :
  is_nan 53 1024
    (printed_quotient (minus_one, zero, zero) (one, zero, zero) one) = true.
Proof. vm_compute; reflexivity. Qed.

(* r = (-1, 2^-26, 0), v = (1, 0, 0), sigma = 1 + 2^-51: it answers 3, and the
   pair is out a little after 2. *)
Theorem printed_is_three :
  value (printed_quotient (minus_one, small, zero) (one, zero, zero) little_more)
  = F754_finite false (3 * 2 ^ 51) (-51).
Proof. vm_compute; reflexivity. Qed.

Theorem where_it_is_just_after_two :
  exists t, disjoint_time (Vector (-1) (bpow radix2 (-26)) 0) v0
              (1 + bpow radix2 (-51)) = Finite t /\ 2 < t < 2 + bpow radix2 (-49).
Proof.
set (y := bpow radix2 (-26)); set (e := bpow radix2 (-51)).
assert (e = 2 * (y * y)) as E by (unfold e, y; simpl; lra).
assert (bpow radix2 (-49) = 4 * e) as -> by (unfold e; simpl; lra).
assert (0 < e < 1 / 8) as Small by (unfold e; simpl; lra).
clearbody y e.
set (r := Vector (-1) y 0).
assert (a v0 = 1 /\ b r v0 = -1 /\ d r v0 (1 + e) = 1 + 3 / 2 * e + e * e)
  as (A & B & D) by (unfold d, a, b, c, dot, r; simpl; nra).
unfold disjoint_time; rewrite A, B, D.
destruct (Req_EM_T 1 0); [lra|].
destruct (Rle_dec _ 0); [nra|].
destruct (Rlt_dec 0 (-1)); [lra|].
eexists; split; [reflexivity|].
assert (0 <= 1 + 3 / 2 * e + e * e) as P by nra.
pose proof (sqrt_sqrt _ P); pose proof (sqrt_pos (1 + 3 / 2 * e + e * e)).
set (s := sqrt _) in *; nra.
Qed.
