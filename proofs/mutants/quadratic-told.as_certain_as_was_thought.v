(* with: computed.v *)
(* refutes: roots_are_told *)
(* SPDX-License-Identifier: MIT *)
(* Of nearly double roots the later one is 3.87 2^-82 off. *)
From Coq Require Import Reals ZArith Lra.
From Flocq Require Import Core.
From Brink Require Import rounding quadratic_told_sum quadratic_told computed.
Open Scope R_scope.

Notation pow := (bpow radix2).
Definition h := 2302472662025617 * pow (-51).
Definition a := 8035234196005321 * pow (-52).
Definition c := 659766751043907 * pow (-50).

Lemma discriminant_here : discriminant h a c = 142819743800771 * pow (-101).
Proof. unfold discriminant, low, rnd, h, a, c; work_out; lra. Qed.

Lemma sum_here : s_hi h (discriminant h a c) = 4604945357852979 * pow (-52) /\
  s_lo h a c (discriminant h a c) = - 14531751 * pow (-78).
Proof.
rewrite discriminant_here; unfold s_hi, s_lo, low, rnd, h, a, c; split; work_out; lra.
Qed.

Lemma upper_here : let s := 4604945357852979 * pow (-52) in
  upper a s = 2580986402113629 * pow (-52) /\
  upper_more a s (- 14531751 * pow (-78)) = - 2783956824300665 * pow (-106).
Proof. unfold upper_more, upper, rnd, a; split; work_out; lra. Qed.

Lemma root_here : 9742689613520847448834832 * pow (-110) <= sqrt (h * h - a * c) <=
  9742689613520847448834833 * pow (-110).
Proof.
split; apply Rsqr_incr_0_var; unfold Rsqr; rewrite ?sqrt_sqrt; try apply sqrt_pos;
  unfold a, h, c; simpl; lra.
Qed.

Theorem is_false : ltac:(let T := type of roots_are_told in exact (T -> False)).
Proof.
destruct sum_here as [S L]; destruct upper_here as [X Y].
intro H; destruct (H h a c) with (x := upper a (s_hi h (discriminant h a c)))
  (y := upper_more a (s_hi h (discriminant h a c)) (s_lo h a c (discriminant h a c)))
  (X := (h + sqrt (h * h - a * c)) / a) as [F _].
- unfold h; written.
- unfold a; written.
- unfold c; written.
- unfold h; simpl; lra.
- unfold a; simpl; lra.
- rewrite discriminant_here; simpl; lra.
- intros _; rewrite discriminant_here; unfold h, a, c, u; work_out; lra.
- left; auto.
- rewrite S, L, X, Y in F; assert (R := root_here).
  set (r := sqrt (h * h - a * c)) in *; clearbody r; set (q := (h + r) / a) in *.
  assert (E : q * a = h + r) by (unfold q; field; unfold a; simpl; lra).
  unfold rnd in F; clearbody q; unfold h, a in E; work_out_in F.
  revert F; unfold Rabs; destruct Rcase_abs; simpl in *; lra.
Qed.
