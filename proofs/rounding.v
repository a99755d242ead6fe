(* products: x y z s *)
(* SPDX-License-Identifier: MIT *)
(* Rounding to 53 bits without bounds of the exponents (powers of two are taken out), and what it
   leaves behind, low x = x - rnd x, which is what two_sum and two_prod keep.  What is rounded is a
   number of known size; what that loses is named, and what is to be proved of it is linear then.
   First order: u^2 (1 + 2^-40), not u^2. *)
From Coq Require Import Reals ZArith Lra.
From Flocq Require Import Core Relative Sterbenz.
Open Scope R_scope.

Definition u := / 9007199254740992. (* 2^-53 *)
Definition fexp := FLX_exp 53.
Definition rnd := round radix2 fexp ZnearestE.
Definition low x := x - rnd x.
Definition tiny := 1 + / 1099511627776. (* 1 + 2^-40 *)

Global Instance precision : Prec_gt_0 53. Proof. now red. Qed.

(* A number of at most m in size is rounded by at most u m. *)
Lemma low_small x m : - m <= x <= m -> - (u * m) <= low x <= u * m.
Proof.
intros H.
assert (E := relative_error_N_FLX radix2 53 precision (fun n => negb (Z.even n)) x).
fold fexp in E; fold rnd in E; change (round radix2 fexp (Znearest _) x) with (rnd x) in E.
assert (U : / 2 * bpow radix2 (- (53) + 1) = u) by (unfold u; simpl; lra).
rewrite U in E.
assert (A : Rabs x <= m) by (apply Rabs_le; lra).
assert (B : Rabs (low x) <= u * m).
{ unfold low; rewrite Rabs_minus_sym; eapply Rle_trans; [exact E |].
  apply Rmult_le_compat_l; [unfold u; lra | exact A]. }
apply Rabs_le_inv in B; lra.
Qed.

Lemma rounded x : rnd x = x - low x. Proof. unfold low; ring. Qed.

(* Names what the rounding of e loses, which is no more than u m. *)
Ltac round_off e m l := let H := fresh in let P := fresh in
  assert (P : - (m) <= e <= m) by lra; assert (H := low_small e m P); unfold u in H;
  rewrite ?(rounded e); set (l := low e) in *; clearbody l; clear P.

(* Names |x|. *)
Ltac size x p := let H := fresh in
  assert (H := conj (Rle_abs x) (Rle_abs (- x))); rewrite Rabs_Ropp in H;
  set (p := Rabs x) in *; clearbody p.

Ltac bound := apply Rabs_le; lra.

(* A little more than 1: of what was rounded a few times. *)
Notation g := (35184372088833 / 35184372088832). (* 1 + 2^-45 *)

Lemma low_own x : - (u * Rabs x) <= low x <= u * Rabs x.
Proof.
apply low_small; generalize (Rle_abs x) (Rle_abs (- x)); rewrite Rabs_Ropp; lra.
Qed.

(* What is to be nonlinear is a product of what is bounded. *)
Lemma product x y X Y : - X <= x <= X -> - Y <= y <= Y -> - (X * Y) <= x * y <= X * Y.
Proof.
intros HX HY; apply Rabs_le_inv; rewrite Rabs_mult.
apply Rmult_le_compat; try apply Rabs_pos; apply Rabs_le; assumption.
Qed.

Lemma square_le x y : 0 <= y -> x * x <= y * y -> x <= y.
Proof. intros; apply Rsqr_incr_0_var; assumption. Qed.

(* What two_sum keeps of a difference of two that are near one another. *)
Lemma exact_difference a b : generic_format radix2 fexp a -> generic_format radix2 fexp b ->
  b / 2 <= a <= 2 * b -> low (a - b) = 0.
Proof.
intros Fa Fb H; unfold low, rnd; rewrite round_generic; [ring | typeclasses eauto |].
apply sterbenz; try assumption; typeclasses eauto.
Qed.

Lemma rnd_rnd x : rnd (rnd x) = rnd x.
Proof. apply round_generic; [| apply generic_format_round]; typeclasses eauto. Qed.

(* A sum of three products without fma: 3u of the sum of their sizes. *)
Definition dot_plain x y z := rnd (rnd (rnd x + rnd y) + rnd z).

Lemma dot_plain_error x y z :
  Rabs (dot_plain x y z - (x + y + z)) <= 3 * tiny * u * (Rabs x + Rabs y + Rabs z).
Proof.
unfold dot_plain, tiny, u; size x p; size y q; size z r.
round_off x p l1; round_off y q l2; round_off z r l3.
round_off (x - l1 + (y - l2)) (g * (p + q)) l4.
round_off (x - l1 + (y - l2) - l4 + (z - l3)) (g * (p + q + r)) l5.
bound.
Qed.

Lemma dot_plain_rel x y z : 0 <= x -> 0 <= y -> 0 <= z ->
  - (3 * tiny * u * (x + y + z)) <= dot_plain x y z - (x + y + z) <= 3 * tiny * u * (x + y + z).
Proof.
intros; apply Rabs_le_inv; eapply Rle_trans; [apply dot_plain_error |].
rewrite !Rabs_right by lra; unfold tiny, u; lra.
Qed.

(* The sum of the sizes of three, themselves rounded. *)
Definition size_plain x y z := rnd (rnd (Rabs (rnd x) + Rabs (rnd y)) + Rabs (rnd z)).

Lemma size_plain_rel x y z :
  (1 - 4 * u) * (Rabs x + Rabs y + Rabs z) <= size_plain x y z <=
  (1 + 4 * u) * (Rabs x + Rabs y + Rabs z).
Proof.
assert (A : forall t, (1 - u) * Rabs t <= Rabs (rnd t) <= (1 + u) * Rabs t).
{ intro t; assert (L := low_own t); rewrite (rounded t); revert L.
  unfold u, Rabs; repeat destruct Rcase_abs; lra. }
unfold size_plain; assert (X := A x); assert (Y := A y); assert (Z := A z).
set (p := Rabs (rnd x)) in *; set (q := Rabs (rnd y)) in *; set (r := Rabs (rnd z)) in *.
assert (0 <= Rabs x) by apply Rabs_pos; assert (0 <= Rabs y) by apply Rabs_pos.
assert (0 <= Rabs z) by apply Rabs_pos.
set (a := Rabs x) in *; set (b := Rabs y) in *; set (c := Rabs z) in *.
clearbody p q r a b c; clear - X Y Z H H0 H1; unfold u in *.
round_off (p + q) (g * (a + b)) l1.
round_off (p + q - l1 + r) (g * (a + b + c)) l2; lra.
Qed.
