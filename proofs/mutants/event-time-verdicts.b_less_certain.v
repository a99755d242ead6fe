(* with: numbers.v *)
(* refutes: b_is_certain *)
(* SPDX-License-Identifier: MIT *)
(* b = 2^-109 of terms as large as 1, which are off by 2^-108. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Brink Require Import rounding event_time_verdicts numbers.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of b_is_certain in exact (T -> False)).
Proof.
intro H; set (w := pow (-109)).
assert (W : 0 < w) by apply bpow_gt_0.
assert (W2 : 2 * w <= 71 / 10 * u * u) by (unfold w, u; simpl; lra).
assert (P : forall e, rnd (pow e) = pow e)
  by (intro e; apply exact_unbounded with 1%Z e; [ring | lia]).
assert (F : is_b_certain 1 w 1 0).
{ unfold is_b_certain; replace (1 * 1) with (pow 0) by (simpl; lra); rewrite (P 0%Z).
  match goal with |- rnd ?x < _ => replace x with (pow (-220)) by (simpl; lra) end.
  replace (w * w) with (pow (-218)) by (unfold w; rewrite <- bpow_plus; reflexivity).
  rewrite !P; apply bpow_lt; lia. }
destruct (H 1 (- w) 1 1 1 1 w 0) as [G _]; try lra.
- rewrite Rabs_pos_eq; lra.
- unfold w; rewrite (P (-109)%Z); exact F.
- unfold w in G; rewrite (P (-109)%Z) in G; fold w in G; lra.
Qed.
