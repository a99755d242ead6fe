(* with: numbers.v *)
(* refutes: told_is_nearest *)
(* SPDX-License-Identifier: MIT *)
(* 1 and a little less than half an ulp stand for a little more. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Brink Require Import exact numbers.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of told_is_nearest in exact (T -> False)).
Proof.
intro H; set (l := pow (-53) - pow (-73)); set (x := 1 + l + pow (-71)).
destruct (numbers.exact 1 1 0) as [D1 _]; [simpl; lra | lia | lia |].
assert (S : rnd (1 + l) = 1) by (apply beside_1; [reflexivity | unfold l; simpl; lra]).
assert (E : rnd x = 1 + pow (-52)).
{ replace (1 + pow (-52)) with (IZR (2 ^ 52 + 1) * pow (-52)) by (simpl; lra).
  apply rounds_to; [lia | reflexivity |]; right; split; [| lia].
  unfold x, l; simpl; lra. }
specialize (H (Dd 1 l) x D1); unfold is_told, plus in H; cbn [hi lo] in H.
rewrite Rplus_comm, E in H; assert (1 + pow (-52) = 1); [| simpl in *; lra].
apply H; [exact S |].
replace (1 + l - x) with (- pow (-71)) by (unfold x; ring).
rewrite Rabs_Ropp, (Rabs_pos_eq 1), Rabs_pos_eq by (simpl; lra); simpl; lra.
Qed.
