(* with: numbers.v *)
(* refutes: passes_filter *)
(* SPDX-License-Identifier: MIT *)
(* a = b = 1, and c = 1 is taken for 1 + 2^-41, 4096u more. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Brink Require Import event_time_sums numbers.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of passes_filter in exact (T -> False)).
Proof.
intro H; set (c := 1 + 4096 * u).
assert (C : rnd (1 * c) = c)
  by (rewrite Rmult_1_l; apply exact_unbounded with (2 ^ 41 + 1)%Z (-41)%Z;
      [unfold c, u; simpl; lra | lia]).
assert (Four : rnd (2 * 1 * (2 * 1)) = 4)
  by (unfold rnd, fexp; rewrite (exact_unbounded _ 4 0) by (simpl; lra || lia); ring).
assert (More : rnd (4 + pow (-40)) = 4 + pow (-40))
  by (apply exact_unbounded with (2 ^ 42 + 1)%Z (-40)%Z; [simpl; lra | lia]).
assert (F : passes 1 1 c).
{ unfold passes; cbv zeta; rewrite C, Four.
  apply Rlt_le_trans with (4 + pow (-40)); [simpl; lra |]; rewrite <- More.
  apply round_le; try typeclasses eauto; unfold c, u; simpl; lra. }
assert (1 * 1 < 1 * 1); [| lra].
apply (H 1 1 c 1 1 1 1 1); try lra; try exact F.
- rewrite Rminus_eq_0, Rabs_R0; unfold u; lra.
- rewrite Rminus_eq_0, Rabs_R0; unfold u; lra.
- unfold c; rewrite Rabs_pos_eq; unfold u; lra.
Qed.
