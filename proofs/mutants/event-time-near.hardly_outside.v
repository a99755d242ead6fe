(* with: numbers.v *)
(* refutes: already_parted *)
(* SPDX-License-Identifier: MIT *)
(* c = 3/4 of a sum that may be off by 1, and is: C = -1/4. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Brink Require Import rounding event_time_near numbers.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of already_parted in exact (T -> False)).
Proof.
intro H; assert (E1 : rnd 1 = 1) by (apply exact_unbounded with 1%Z 0%Z; [simpl; lra | lia]).
assert (E2 : rnd (3 / 4) = 3 / 4) by (apply exact_unbounded with 3%Z (-2)%Z; [simpl; lra | lia]).
destruct (H 1 1 (- / 4) 0 1 1 1 (3 / 4) 1 1) as [_ F]; try lra; rewrite ?E1, ?E2.
- rewrite Rminus_eq_0, Rabs_R0; unfold tiny, u; lra.
- rewrite Rminus_eq_0, Rabs_R0; lra.
- rewrite (Rabs_pos_eq (_ - _)) by lra; unfold u; generalize (Rabs_pos (3 / 4)); lra.
- lra.
- unfold is_outside; lra.
- unfold is_leaving; replace (1 * 1) with 1 by ring; rewrite E1, !Rmult_1_r.
  unfold rnd, fexp; rewrite (exact_unbounded (/ _) 1 (-200)) by (simpl; lra || lia); lra.
Qed.
