(* refutes: sign_of_lower_root *)
(* SPDX-License-Identifier: MIT *)
(* Of t^2 - 1 the lower root is -1, and more than -2. *)
From Coq Require Import Reals Lra Psatz.
From Flocq Require Import Core.
From Brink Require Import root.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of sign_of_lower_root in exact (T -> False)).
Proof.
intro H; specialize (H 1 0 (-1) (-2) (-1)); unfold poly in H.
specialize (H ltac:(lra) ltac:(lra) ltac:(intros; nra)).
unfold lower_minus, up, slope in H; destruct (Req_EM_T 1 0); [lra |].
destruct (sign_cases 1) as [[_ S] | [[? _] | [? _]]]; try lra; rewrite S in H.
destruct (sign_cases (1 * -2 + 0)) as [[? _] | [[_ T] | [? _]]]; try lra; rewrite T in H.
destruct (sign_cases (-1 - -2)) as [[_ U] | [[? _] | [? _]]]; try lra; rewrite U in H.
destruct (Rlt_dec (1 * -1) 0); lra.
Qed.
