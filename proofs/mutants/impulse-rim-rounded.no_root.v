(* with: computed.v computed_dd.v *)
(* refutes: rim_rule_keeps_energy *)
(* SPDX-License-Identifier: MIT *)
(* Masses 1, one at rest, the other passes by with 1 at its closest approach: it is given 2^-24 inward
   and 2^-48 is taken from the rest of it instead of a half of that, an energy of 2^-50. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding exact_dd_products impulse_dd impulse_sums impulse_kick.
From Brink Require Import impulse_decision impulse_change impulse_rim_parts impulse_rim.
From Brink Require Import computed computed_dd.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of rim_rule_keeps_energy in exact (T -> False)).
Proof.
intro H; assert (F1 : is_double 1) by written; set (a := / 16777216).
assert (B : b 1 0 0 0 1 0 0 0 0 = Dd 0 0) by (unfold b, v0, v1, v2, sum3, zero; is_pair).
assert (R : rr 1 0 0 = Dd 1 0) by (unfold rr, sum3, zero; is_pair).
assert (V0 : v0 0 0 = Dd 0 0) by (unfold v0; is_pair).
assert (V1 : v1 1 0 = Dd 1 0) by (unfold v1; is_pair).
assert (V2 : v2 0 0 = Dd 0 0) by (unfold v2; is_pair).
assert (V : vv 0 1 0 0 0 0 = Dd 1 0)
  by (unfold vv, sum3, zero; rewrite V0, V1, V2; is_pair).
assert (M : rim 1 0 0 0 1 0 0 0 0 = Dd a 0)
  by (unfold rim, root, a; rewrite V, R; is_pair).
assert (K : along 1 0 0 0 1 0 0 0 0 = Dd 0 0) by (unfold along; rewrite B, R; is_pair).
assert (I : inward 1 0 0 0 1 0 0 0 0 = Dd (- a) 0)
  by (unfold inward, a; rewrite M, R; unfold a; is_pair).
assert (Z : stretch 1 0 0 0 1 0 0 0 0 = Dd (1 - a * a) 0)
  by (unfold stretch, share_left, rim2, bb; rewrite V, M, B, R; unfold a; is_pair).
assert (T0 : t0 1 0 0 0 1 0 0 0 0 = Dd (- a) 0)
  by (unfold t0, turned; rewrite Z, K, I, V0; unfold a; is_pair).
assert (T1 : t1 1 0 0 0 1 0 0 0 0 = Dd (- (a * a)) 0)
  by (unfold t1, turned; rewrite Z, K, I, V1; unfold a; is_pair).
assert (T2 : t2 1 0 0 0 1 0 0 0 0 = Dd 0 0)
  by (unfold t2, turned; rewrite Z, K, I, V2; unfold a; is_pair).
assert (S : share 1 1 = Dd (/ 2) 0) by (unfold share; is_pair).
assert (G := H 1 0 0 0 1 0 0 0 0 1 1 0 F1 F1 ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)).
cbv zeta in G; rewrite M, B in G; cbn [hi] in G; rewrite Rabs_R0 in G.
specialize (G ltac:(unfold a; lra)).
unfold first0, first1, first2, second0, second1, second2, kicked in G.
rewrite T0, T1, T2, S in G; unfold a in G.
revert G; work_out_dd; cbn [hi]; simpl bpow; intro G.
destruct (G (51 / 100)) as [E _]; [lra .. |].
rewrite Rabs_left in E by lra; unfold u in E; lra.
Qed.
