(* with: computed.v computed_dd.v *)
(* refutes: kick_keeps_energy *)
(* SPDX-License-Identifier: MIT *)
(* Masses 1, at rest, kicked by 2 + 3u/2: either goes with 1 and leaves 3u/4, energies of 1/2 instead of
   1/2 + 3u/4. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding exact_dd_products impulse_dd impulse_sums impulse_kick.
From Brink Require Import computed computed_dd.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of kick_keeps_energy in exact (T -> False)).
Proof.
intro H; assert (F1 : is_double 1) by written; set (a := Dd 2 (3 * bpow radix2 (-54))).
assert (O : is_dd (Dd 0 0)) by (unfold is_dd; cbn [hi lo]; rewrite Rabs_R0; lra).
assert (A : is_dd a)
  by (unfold is_dd, a, u; cbn [hi lo]; rewrite !Rabs_pos_eq by (simpl; lra); simpl; lra).
assert (S : share 1 1 = Dd (/ 2) 0) by (unfold share; is_pair).
assert (G := H 1 1 F1 F1 ltac:(lra) ltac:(lra) a (Dd 0 0) (Dd 0 0) 0 0 0 0 0 0 0 A O O).
cbv zeta in G; unfold first0, first1, first2, second0, second1, second2, kicked in G.
rewrite S in G; unfold a in G; revert G; work_out_dd; unfold total; cbn [hi lo]; simpl bpow; intro G.
destruct (G (1 / 2)) as [E _]; [lra .. |].
rewrite Rabs_left in E by lra; unfold u in E; lra.
Qed.
