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
specialize (H x 0 0); unfold dot_of, rest, low in H; cbv zeta in H.
rewrite X, Z, !Rminus_0_r, !X, !Rplus_0_r, !Z, !Rplus_0_r, !Z in H.
assert (P : 0 < x) by apply bpow_gt_0.
assert (Rabs (0 - x) <= 7 * tiny * u * u * (Rabs x + Rabs 0 + Rabs 0) + 0 * eta).
{ match type of H with _ -> _ -> _ -> Rabs ?e <= _ => replace (0 - x) with e by
    (rewrite ?Rminus_0_r, ?Rplus_0_r, ?Z, ?Rminus_eq_0, ?Rplus_0_r, ?Z; ring) end.
  apply H; [exists h, h | exists 0, 0 | exists 0, 0]; repeat split; try assumption; try ring.
  unfold x, h; rewrite <- bpow_plus; reflexivity. }
rewrite Rabs_minus_sym, Rminus_0_r, Rabs_R0, Rabs_pos_eq in H0 by lra; unfold tiny, u in H0; lra.
Qed.
