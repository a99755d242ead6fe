(* with: computed.v *)
(* refutes: dd_add_d_is_close *)
(* SPDX-License-Identifier: MIT *)
(* 1 and 2^-60, added to 0, become 1. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Brink Require Import exact exact_dd computed.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of dd_add_d_is_close in exact (T -> False)).
Proof.
assert (U : ulp 1 = pow (-52)) by (change 1 with (pow 0); rewrite ulp_bpow; reflexivity).
intro H; destruct (H (Dd 1 (pow (-60))) 0) as [_ F]; [| apply generic_format_0 |].
- split; [cbn [hi]; written |]; split; [cbn [lo]; written |]; cbn [hi lo]; rewrite U; work_out; lra.
- unfold total, dd_add_d, two_sum, fast_two_sum, plus, minus in F; cbv zeta in F; cbn [hi lo] in F.
  work_out_in F; lra.
Qed.
