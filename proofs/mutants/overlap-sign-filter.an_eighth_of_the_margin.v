(* with: numbers.v *)
(* refutes: ball_sign_filter *)
(* SPDX-License-Identifier: MIT *)
(* x = 1 + 7/8 u, y = z = 7/8 u, of which 1 is left; sigma^2 = 1 + 9/8 u, which becomes 1 + 2u. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core.
From Brink Require Import underflow overlap numbers.
Open Scope R_scope.

Theorem is_false : ltac:(let T := type of ball_sign_filter in exact (T -> False)).
Proof.
intro H; set (y := 7 / 8 * u); set (s := 1 + 9 / 8 * u).
assert (X : rnd (1 + y) = 1) by (apply beside_1; [reflexivity | unfold y, u; simpl; lra]).
assert (Y : rnd y = y)
  by (apply (exact y 7 (-56)); [unfold y, u; simpl; lra | lia | lia]).
assert (S : rnd s = 1 + 2 * u).
{ assert (E : 1 + 2 * u = IZR (2 ^ 52 + 1) * pow (-52)) by (unfold u; simpl; lra).
  rewrite E; apply rounds_to; [lia | reflexivity |]; right; split; [| lia].
  unfold s, u; simpl; lra. }
assert (D : dot_plain (1 + y) y y = 1) by (unfold dot_plain; rewrite X, Y, X, X; reflexivity).
assert (F : ball_difference (1 + y) y y s = - (2 * u)).
{ unfold ball_difference; rewrite D, S; replace (1 - (1 + 2 * u)) with (- (2 * u)) by ring.
  apply (exact (- (2 * u)) (-1) (-52)); [unfold u; simpl; lra | lia | lia]. }
assert (T : 0 < eta < u * u / 1000).
{ split; [apply eta_pos |]; apply Rlt_trans with (pow (-200)); [apply bpow_lt; lia |].
  unfold u; simpl; lra. }
assert (G : ball_error (1 + y) y y s < 2 * u).
{ unfold ball_error; rewrite D, S.
  assert (pow (-1000) <= u * u / 1000)
    by (apply Rle_trans with (pow (-200)); [apply bpow_le; lia | unfold u; simpl; lra]).
  assert (0 < pow (-1000)) by apply bpow_gt_0; set (w := pow (-1000)) in *; clearbody w.
  unfold u in *; round_off (1 + (1 + 2 * / 9007199254740992)) 3 l1.
  round_off (/ 2 * / 9007199254740992 * (1 + (1 + 2 * / 9007199254740992) - l1))
    (2 / 9007199254740992) l2.
  round_off (/ 2 * / 9007199254740992 * (1 + (1 + 2 * / 9007199254740992) - l1) - l2 + w)
    (2 / 9007199254740992) l3; lra. }
destruct (H (1 + y) y y s) as [_ E]; try (unfold y, s, u; lra).
- rewrite F, Rabs_Ropp, Rabs_pos_eq by (unfold u; lra); exact G.
- rewrite F in E; unfold y, s, u in E; lra.
Qed.
