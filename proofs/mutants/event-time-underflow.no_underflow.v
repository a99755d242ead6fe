(* with: numbers.v *)
(* refutes: dot_of_error *)
(* SPDX-License-Identifier: MIT *)
(* 2^-538 times itself becomes 0, and nothing is left of it. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Brink Require Import underflow event_time_underflow numbers.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of dot_of_error in exact (T -> False)).
Proof.
intro H; set (h := pow (-538)); set (x := pow (-1076)).
destruct (exact 0 0 0) as [D0 Z]; [simpl; lra | lia | lia |].
destruct (exact h 1 (-538)) as [Dh _]; [unfold h; ring | lia | lia |].
assert (X : rnd x = 0).
{ unfold rnd, round, F2R, scaled_mantissa, cexp, x; rewrite mag_bpow; cbn [Fnum Fexp].
  change (fexp (-1076 + 1)) with (-1074)%Z.
  rewrite (Znearest_imp _ _ 0); [apply Rmult_0_l |].
  rewrite <- bpow_plus, Rminus_0_r, Rabs_pos_eq by apply bpow_ge_0; simpl; lra. }
assert (Zero : rnd 0 = 0) by exact Z.
assert (D : dot_of x 0 0 = 0).
{ unfold dot_of, rest, low; cbv zeta; repeat first [rewrite X | rewrite Zero | rewrite Rplus_0_r |
    rewrite Rminus_0_r]; reflexivity. }
specialize (H x 0 0); rewrite D in H; assert (P : 0 < x) by apply bpow_gt_0.
replace (0 - (x + 0 + 0)) with (- x) in H by ring.
rewrite Rabs_Ropp, Rabs_R0, Rabs_pos_eq in H by lra.
assert (x <= 7 * tiny * u * u * (x + 0 + 0) + 0 * eta); [| unfold tiny, u in *; lra].
apply H; [exists h, h | exists 0, 0 | exists 0, 0]; repeat split; try assumption; try ring.
unfold x, h; rewrite <- bpow_plus; reflexivity.
Qed.
