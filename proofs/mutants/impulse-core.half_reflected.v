(* with: computed.v computed_dd.v *)
(* refutes: core_keeps_energy *)
(* SPDX-License-Identifier: MIT *)
(* Masses 1, one at rest, the other comes with 1: they go on together, with half of the energy. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding exact_dd_products impulse_dd impulse_sums impulse_kick.
From Brink Require Import impulse_decision impulse_change impulse_payment impulse_core.
From Brink Require Import computed computed_dd.
Open Scope R_scope.
Theorem is_false : ltac:(let T := type of core_keeps_energy in exact (T -> False)).
Proof.
intro H; assert (F1 : is_double 1) by written.
assert (B : b 1 0 0 (-1) 0 0 0 0 0 = Dd (-1) 0).
{ unfold b, v0, v1, v2, sum3, zero; is_pair. }
assert (R : rr 1 0 0 = Dd 1 0) by (unfold rr, sum3, zero; is_pair).
assert (M : mu 1 1 = Dd (/ 2) 0) by (unfold mu, k1, mass; is_pair).
assert (K : kept 1 0 0 (-1) 0 0 0 0 0 (-1) = 1)
  by (unfold kept; rewrite B; cbn [hi]; unfold rnd; work_out; lra).
assert (P : rnd (- -1 * paid 1 0 0 (-1) 0 0 0 0 0 1 1 (-1) 0) = 0).
{ unfold paid, payment, gain; cbv zeta; rewrite K, R, M; cbn [hi].
  destruct Rlt_dec; unfold rnd; work_out; lra. }
assert (L : left_owed (hi (rr 1 0 0)) (hi (mu 1 1)) 0 (kept 1 0 0 (-1) 0 0 0 0 0 (-1)) = 0).
{ unfold left_owed; destruct Rlt_dec; lra. }
assert (W : reflection 1 0 0 (-1) 0 0 0 0 0 1 1 (-1) 0 = Dd 1 0)
  by (unfold reflection; rewrite P, B; is_pair).
assert (S : share 1 1 = Dd (/ 2) 0) by (unfold share; is_pair).
assert (W0 : w0 1 0 0 (Dd 1 0) = Dd 1 0) by (unfold w0, slope; rewrite R; is_pair).
assert (W1 : w1 1 0 0 (Dd 1 0) = Dd 0 0) by (unfold w1, slope; rewrite R; is_pair).
assert (W2 : w2 1 0 0 (Dd 1 0) = Dd 0 0) by (unfold w2, slope; rewrite R; is_pair).
assert (G := H 1 0 0 (-1) 0 0 0 0 0 1 1 (-1) 0 F1 F1 ltac:(lra) ltac:(lra) ltac:(lra)
  (or_intror eq_refl)). cbv zeta in G; rewrite K in G; specialize (G ltac:(lra)).
unfold first0, first1, first2, second0, second1, second2, kicked, left in G.
rewrite W, W0, W1, W2, L, S in G.
revert G; work_out_dd; cbn [hi]; simpl bpow; intro G.
destruct (G (1 / 2)) as [E _]; [lra .. |].
rewrite Rabs_left, (Rabs_pos_eq (0 - 0)) in E by lra; unfold u in E; lra.
Qed.
