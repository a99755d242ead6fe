(* with: computed.v computed_dd.v *)
(* refutes: crossing_keeps_energy *)
(* SPDX-License-Identifier: MIT *)
(* Masses 1 and b = 2^-300 - 2^-106, of which double-double sees 2^-300: an energy a third more than the
   rise (tests/impulse.wc), and next to 2^87 for the loss divided by that. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding exact_dd_products impulse_dd impulse_sums impulse_kick.
From Brink Require Import impulse_decision impulse_change impulse_payment impulse_crossing.
From Brink Require Import computed computed_dd.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of crossing_keeps_energy in exact (T -> False)).
Proof.
intro H; assert (F1 : is_double 1) by written.
set (p1 := bpow radix2 (-53)); set (p2 := - (1 + bpow radix2 (-52))).
set (q0 := - (bpow radix2 (-53) - bpow radix2 (-106))); set (q2 := - bpow radix2 (-300)).
set (high := bpow radix2 (-216)); set (fast := - bpow radix2 86).
assert (Low : high <= 4) by (apply (bpow_le radix2 (-216) 2); easy).
assert (B : b 1 1 1 1 p1 p2 q0 0 q2 = Dd (bpow radix2 (-300)) 0).
{ unfold b, v0, v1, v2, sum3, zero, p1, p2, q0, q2; is_pair. }
assert (S : s 1 1 1 1 p1 p2 q0 0 q2 1 = Dd (bpow radix2 (-300)) 0)
  by (unfold s; rewrite B; cbn [hi lo]; f_equal; lra).
assert (R : rr 1 1 1 = Dd 3 0) by (unfold rr, sum3, zero; is_pair).
assert (M : mu 1 1 = Dd (/ 2) 0) by (unfold mu, k1, mass; is_pair).
assert (L : loss 1 1 1 1 1 high 4 = Dd (12 * high) 0)
  by (unfold loss; rewrite R, M, Rmin_left by exact Low; unfold high; is_pair).
eassert (T : rest 1 1 1 1 p1 p2 q0 0 q2 1 1 1 high 4 = Dd _ _)
  by (unfold rest, ss; rewrite S, L; unfold high; work_out_dd; reflexivity).
set (x := Dd _ _) in T; assert (X : ~ 0 < hi x) by (unfold x; cbn [hi]; simpl bpow; lra).
assert (P : paid 1 1 1 1 p1 p2 q0 0 q2 1 1 1 high 4 0 = 0 /\
  left 1 1 1 1 p1 p2 q0 0 q2 1 1 1 high 4 0 = 0).
{ unfold paid, left, payment, left_owed, left_of; cbv zeta; rewrite T.
  destruct (Rlt_dec 0 (hi x)) as [N | _]; [contradiction |].
  unfold gain, zero; rewrite R, M; cbn [hi]; destruct Rlt_dec as [N | _];
    [| split; reflexivity].
  exfalso; revert N; unfold rnd; work_out; lra. }
destruct P as [P O].
assert (C : crossed 1 1 1 1 p1 p2 q0 0 q2 1 1 1 high 4 0 = Dd (3 * fast) 0).
{ unfold crossed, changed; rewrite P; unfold along; rewrite T.
  destruct (Rlt_dec 0 (hi x)) as [N | _]; [contradiction |]; rewrite S, L; cbn [hi].
  destruct Rlt_dec as [_ | N]; [| exfalso; apply N, bpow_gt_0].
  unfold zero, high, fast; work_out_dd; cbn [hi lo]; f_equal; simpl bpow; lra. }
assert (K : share 1 1 = Dd (/ 2) 0) by (unfold share; is_pair).
assert (W0 : w0 1 1 1 (Dd (3 * fast) 0) = Dd fast 0)
  by (unfold w0, slope, fast; rewrite R; is_pair).
assert (W1 : w1 1 1 1 (Dd (3 * fast) 0) = Dd fast 0)
  by (unfold w1, slope, fast; rewrite R; is_pair).
assert (W2 : w2 1 1 1 (Dd (3 * fast) 0) = Dd fast 0)
  by (unfold w2, slope, fast; rewrite R; is_pair).
assert (G := H 1 1 1 1 p1 p2 q0 0 q2 1 1 1 high 4 0 F1 F1 ltac:(lra) ltac:(lra) ltac:(lra)
  (or_introl eq_refl)).
cbv zeta in G; unfold surplus, first0, first1, first2, second0, second1, second2, kicked in G.
rewrite C, W0, W1, W2, O, K in G.
revert G; unfold p1, p2, q0, q2, high, fast; work_out_dd; cbn [hi]; simpl bpow; intro G.
destruct (G ltac:(lra) ltac:(lra) (2 ^ 171)) as [E _]; [lra .. |].
rewrite Rabs_pos_eq, (Rabs_pos_eq (0 - 0)) in E by lra; unfold u in E; lra.
Qed.
