(* SPDX-License-Identifier: MIT *)
(* For counterexamples: what numbers that are written out are rounded to. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
Open Scope R_scope.

Notation pow := (bpow radix2).

Section Rounded.
Variables (fexp : Z -> Z) (m e : Z).
Hypotheses (M : (2 ^ 52 <= m < 2 ^ 53)%Z) (E : fexp (e + 53)%Z = e).

(* To m 2^e what is nearer to it than to any other. *)
Lemma rounds_to x : IZR m * pow e <= x < (IZR m + / 2) * pow e \/
  (IZR m - / 2) * pow e < x <= IZR m * pow e /\ (2 ^ 52 < m)%Z ->
  round radix2 fexp ZnearestE x = IZR m * pow e.
Proof.
intro H; assert (P := bpow_gt_0 radix2 e).
assert (ML : 4503599627370496 <= IZR m <= 9007199254740991) by (split; apply IZR_le; lia).
assert (B : 4503599627370496 * pow e <= x < 9007199254740992 * pow e /\
  Rabs (x - IZR m * pow e) < / 2 * pow e).
{ destruct H as [H | [H L]].
  - split; [split; nra |]; apply Rabs_def1; nra.
  - assert (4503599627370497 <= IZR m) by (apply IZR_le; lia).
    split; [split; nra |]; apply Rabs_def1; nra. }
destruct B as [B N].
assert (C : cexp radix2 fexp x = e).
{ unfold cexp; rewrite (mag_unique radix2 x (e + 53)); [exact E |].
  rewrite Rabs_pos_eq by nra; replace (e + 53 - 1)%Z with (52 + e)%Z by lia.
  rewrite (Z.add_comm e), !bpow_plus; simpl (pow 52); simpl (pow 53); lra. }
unfold round, F2R, scaled_mantissa; cbn [Fnum Fexp]; rewrite C; do 2 f_equal.
apply Znearest_imp; rewrite bpow_opp.
apply Rmult_lt_reg_r with (1 := P); rewrite <- (Rabs_pos_eq (pow e)) at 2 by lra.
rewrite <- Rabs_mult; replace ((x * / pow e - IZR m) * pow e) with (x - IZR m * pow e)
  by (field; lra); exact N.
Qed.
End Rounded.

(* What is nothing beside 1. *)
Lemma beside_1 fexp x : fexp 1%Z = (-52)%Z -> 1 <= x < 1 + pow (-53) ->
  round radix2 fexp ZnearestE x = 1.
Proof.
intros F H; assert (E : 1 = IZR (2 ^ 52) * pow (-52)) by (simpl; lra).
rewrite E; apply rounds_to; [lia | exact F |]; left; simpl in *; lra.
Qed.

(* What has few bits is a double. *)
Lemma exact_unbounded x m e : x = IZR m * pow e -> (Z.abs m < 2 ^ 53)%Z ->
  round radix2 (FLX_exp 53) ZnearestE x = x.
Proof.
intros -> L; apply round_generic; [typeclasses eauto |].
apply generic_format_FLX; exists (Float radix2 m e); [reflexivity | exact L].
Qed.

Lemma exact x m e : x = IZR m * pow e -> (Z.abs m < 2 ^ 53)%Z -> (-1074 <= e)%Z ->
  generic_format radix2 (FLT_exp (-1074) 53) x /\
  round radix2 (FLT_exp (-1074) 53) ZnearestE x = x.
Proof.
intros -> L M; split; [| apply round_generic; [typeclasses eauto |]];
  apply generic_format_FLT; exists (Float radix2 m e); try assumption; reflexivity.
Qed.
