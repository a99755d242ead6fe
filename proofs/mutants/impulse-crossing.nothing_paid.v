(* with: computed.v computed_dd.v *)
(* refutes: crossing_keeps_energy *)
(* SPDX-License-Identifier: MIT *)
(* Masses 2, one at rest, the other comes with 2 and is let in over a rise of 3/2, with 1 left.  The
   2^-22 that are owed to them are lost. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding exact_dd_products impulse_dd impulse_sums impulse_kick.
From Brink Require Import impulse_decision impulse_change impulse_payment impulse_crossing.
From Brink Require Import computed computed_dd.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of crossing_keeps_energy in exact (T -> False)).
Proof.
intro H; assert (F2 : is_double 2) by written; set (w := bpow radix2 (-22)).
assert (B : b 1 0 0 2 0 0 0 0 0 = Dd 2 0) by (unfold b, v0, v1, v2, sum3, zero; is_pair).
assert (S : s 1 0 0 2 0 0 0 0 0 1 = Dd 2 0) by (unfold s; rewrite B; cbn [hi lo]; f_equal; lra).
assert (R : rr 1 0 0 = Dd 1 0) by (unfold rr, sum3, zero; is_pair).
assert (M : mu 2 2 = Dd 1 0) by (unfold mu, k1, mass; is_pair).
assert (L : loss 1 0 0 2 2 (3 / 2) 4 = Dd 3 0)
  by (unfold loss; rewrite R, M, Rmin_left by lra; is_pair).
assert (T : rest 1 0 0 2 0 0 0 0 0 2 2 1 (3 / 2) 4 = Dd 1 0)
  by (unfold rest, ss; rewrite S, L; is_pair).
assert (O : left 1 0 0 2 0 0 0 0 0 2 2 1 (3 / 2) 4 w = 0).
{ unfold left, left_of, left_owed, gain; cbv zeta; rewrite T, R, M; cbn [hi].
  destruct (Rlt_dec 0 1) as [_ | N]; [| lra]; replace (dd_sqrt (Dd 1 0)) with (Dd 1 0).
  2: { symmetry; is_pair. }
  destruct Rlt_dec as [_ | N]; [reflexivity | exfalso; apply N; clear N].
  cbn [hi]; unfold rnd, w; work_out; lra. }
assert (C : crossed 1 0 0 2 0 0 0 0 0 2 2 1 (3 / 2) 4 = Dd (-1) 0).
{ unfold crossed, changed, along; rewrite T, S, L; cbn [hi].
  destruct (Rlt_dec 0 1) as [_ | N]; [| lra]; destruct (Rlt_dec 0 2) as [_ | N]; [| lra].
  work_out_dd; cbn [hi lo]; f_equal; simpl bpow; lra. }
assert (K : share 2 2 = Dd (/ 2) 0) by (unfold share; is_pair).
assert (W0 : w0 1 0 0 (Dd (-1) 0) = Dd (-1) 0) by (unfold w0, slope; rewrite R; is_pair).
assert (W1 : w1 1 0 0 (Dd (-1) 0) = Dd 0 0) by (unfold w1, slope; rewrite R; is_pair).
assert (W2 : w2 1 0 0 (Dd (-1) 0) = Dd 0 0) by (unfold w2, slope; rewrite R; is_pair).
assert (G := H 1 0 0 2 0 0 0 0 0 2 2 1 (3 / 2) 4 w F2 F2 ltac:(lra) ltac:(lra) ltac:(lra)
  (or_introl eq_refl) ltac:(unfold surplus; lra) ltac:(lra)); cbv zeta in G.
unfold first0, first1, first2, second0, second1, second2, kicked in G.
rewrite C, W0, W1, W2, O, K in G.
revert G; work_out_dd; cbn [hi]; simpl bpow; intro G.
destruct (G 4) as [E _]; [lra .. |].
rewrite Rabs_left, (Rabs_pos_eq (w - 0)) in E by (unfold w; simpl; lra).
unfold u, w in E; simpl in E; lra.
Qed.
