(* with: computed.v *)
(* refutes: dd_add_is_close *)
(* SPDX-License-Identifier: MIT *)
(* 1 + 2^-60 and -1 + 2^-120 become 2^-60. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Brink Require Import exact exact_dd exact_dd_add computed.
Open Scope R_scope.

Ltac sum := unfold two_sum, fast_two_sum, plus, minus; cbv zeta; work_out; f_equal; lra.

Theorem is_false : ltac:(let T := type of dd_add_is_close in exact (T -> False)).
Proof.
assert (U : ulp 1 = pow (-52)) by (change 1 with (pow 0); rewrite ulp_bpow; reflexivity).
set (x := Dd 1 (pow (-60))); set (y := Dd (- 1) (pow (-120))).
assert (S : two_sum 1 (- 1) = Dd 0 0) by sum.
assert (T : two_sum (pow (-60)) (pow (-120)) = Dd (pow (-60)) (pow (-120))) by sum.
assert (V : fast_two_sum 0 (plus 0 (pow (-60))) = Dd (pow (-60)) 0) by sum.
assert (W : fast_two_sum (pow (-60)) (plus (0 * pow (-120)) 0) = Dd (pow (-60)) 0) by sum.
assert (E : dd_add x y = Dd (pow (-60)) 0).
{ unfold dd_add, x, y; cbn [hi lo]; rewrite S, T; cbn [hi lo]; rewrite V; exact W. }
intro H; destruct (H x y) as [_ F].
- split; [unfold x; cbn [hi]; written |]; split; [unfold x; cbn [lo]; written |].
  cbn [hi lo x]; rewrite U, Rabs_pos_eq by apply bpow_ge_0; simpl; lra.
- split; [unfold y; cbn [hi]; written |]; split; [unfold y; cbn [lo]; written |].
  cbn [hi lo y]; replace (ulp (- 1)) with (ulp 1) by (symmetry; apply ulp_opp).
  rewrite U, Rabs_pos_eq by apply bpow_ge_0; simpl; lra.
- rewrite E in F; unfold total in F; cbn [hi lo x y] in F; work_out_in F; lra.
Qed.
