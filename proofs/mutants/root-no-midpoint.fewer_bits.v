(* refutes: root_is_no_midpoint *)
(* SPDX-License-Identifier: MIT *)
(* x - (2^53 - 1) = 0: its root would be halfway between 2^53 - 2 and 2^53. *)
From Coq Require Import ZArith Reals Lra Lia.
From Flocq Require Import Core.
From Brink Require Import root.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of root_is_no_midpoint in exact (T -> False)).
Proof.
intro H; destruct (H 0 1 (IZR (- (2 ^ 53 - 1))) (IZR (2 ^ 53 - 1))) as (_ & B & _); [| | | | | lra].
- exists 0%Z, 0%Z; split; [simpl; ring | easy].
- exists 1%Z, 0%Z; split; [simpl; ring | easy].
- exists (- (2 ^ 53 - 1))%Z, 0%Z; split; [simpl; ring | easy].
- exists (2 ^ 52 - 1)%Z, 1%Z; repeat split; try (vm_compute; discriminate); simpl; ring.
- rewrite opp_IZR; ring.
Qed.
