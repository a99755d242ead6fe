(* SPDX-License-Identifier: MIT *)
(* For counterexamples: what a formula of numbers that are written out comes to, with every rounding
   in it, to the nearest in any format, computed with integers. *)
From Coq Require Import Reals ZArith Lra Lia.
From Flocq Require Import Core Bracket Calc.Operations Calc.Round Calc.Div Calc.Sqrt.
Open Scope R_scope.

Inductive formula :=
  | Integer (m : Z)
  | Power (e : Z) (* of 2 *)
  | Sum (f g : formula)
  | Product (f g : formula)
  | Opposite (f : formula)
  | Size (f : formula)
  | Inverse (f : formula) (* of a power of two *)
  | Rounded (f : formula)
  | Quotient (f g : formula) (* by what is > 0, rounded; and a root *)
  | Root (f : formula).

Section Computed.
Variable fexp : Z -> Z.
Context {valid : Valid_exp fexp}.
Notation rnd := (round radix2 fexp ZnearestE).

Fixpoint meaning f :=
  match f with
  | Integer m => IZR m
  | Power e => bpow radix2 e
  | Sum f g => meaning f + meaning g
  | Product f g => meaning f * meaning g
  | Opposite f => - meaning f
  | Size f => Rabs (meaning f)
  | Inverse f => / meaning f
  | Rounded f => rnd (meaning f)
  | Quotient f g => rnd (meaning f / meaning g)
  | Root f => rnd (sqrt (meaning f))
  end.

Definition nearest (t : Z * Z * location) :=
  let '(m, e, l) := truncate radix2 fexp t in
  Float radix2 (cond_incr (round_N (negb (Z.even m)) l) m) e.

(* What is odd, from what it is of numbers >= 0. *)
Definition by_sign f (x : float radix2) :=
  if (Fnum x <? 0)%Z then Fopp (f (Fopp x)) else f x : float radix2.
Definition round_number := by_sign (fun x => nearest (Fnum x, Fexp x, loc_Exact)).
Definition divide x y :=
  by_sign (fun x => if (Fnum x =? 0)%Z then x else nearest (Fdiv fexp x y)) x.

Definition both (f : float radix2 -> float radix2 -> float radix2) x y :=
  match x, y with Some x, Some y => Some (f x y) | _, _ => None end.

Fixpoint computed f :=
  match f with
  | Integer m => Some (Float radix2 m 0)
  | Power e => Some (Float radix2 1 e)
  | Sum f g => both (@Fplus radix2) (computed f) (computed g)
  | Product f g => both (@Fmult radix2) (computed f) (computed g)
  | Opposite f => option_map (@Fopp radix2) (computed f)
  | Size f => option_map (@Fabs radix2) (computed f)
  | Inverse f => match computed f with
    | Some (Float _ m e) =>
      if (m =? 2 ^ Z.log2 m)%Z then Some (Float radix2 1 (- (Z.log2 m + e))) else None
    | None => None
    end
  | Rounded f => option_map round_number (computed f)
  | Quotient f g =>
    match computed f, computed g with
    | Some x, Some y => if (0 <? Fnum y)%Z then Some (divide x y) else None
    | _, _ => None
    end
  | Root f => match computed f with
    | Some x => if (0 <? Fnum x)%Z then Some (nearest (Fsqrt fexp x)) else None
    | None => None
    end
  end.

Lemma nearest_is_rounded x m e l : 0 <= x -> (e <= cexp radix2 fexp x)%Z \/ l = loc_Exact ->
  inbetween_float radix2 m e x l -> rnd x = F2R (nearest (m, e, l)).
Proof.
intros P E I; rewrite (round_trunc_NE_correct' radix2 fexp x m e l P I E); unfold nearest.
destruct (truncate radix2 fexp (m, e, l)) as [[m' e'] l']; reflexivity.
Qed.

Lemma positive (x : float radix2) : (0 <? Fnum x)%Z = true -> 0 < F2R x.
Proof. destruct x as [m e]; intro H; apply Z.ltb_lt in H; apply F2R_gt_0, H. Qed.

Lemma by_sign_is (g : R -> R) f x : (forall r, g (- r) = - g r) ->
  (forall y : float radix2, (0 <= Fnum y)%Z -> g (F2R y) = F2R (f y)) ->
  g (F2R x) = F2R (by_sign f x).
Proof.
intros Odd P; unfold by_sign; destruct (Z.ltb_spec (Fnum x) 0) as [N | N]; [| apply P, N].
rewrite F2R_opp, <- P, F2R_opp, Odd; [ring | destruct x; cbn in *; lia].
Qed.

Lemma round_number_is_rounded x : rnd (F2R x) = F2R (round_number x).
Proof.
apply by_sign_is; [apply round_NE_opp |]; intros [m e] P.
apply nearest_is_rounded; [apply F2R_ge_0; exact P | right; reflexivity | constructor; reflexivity].
Qed.

Lemma divide_is_rounded x y : 0 < F2R y -> rnd (F2R x / F2R y) = F2R (divide x y).
Proof.
intro Y; apply (by_sign_is (fun r => rnd (r / F2R y))).
- intro r; rewrite <- round_NE_opp; f_equal; unfold Rdiv; ring.
- intros [m e] P; cbn [Fnum] in *; destruct (Z.eqb_spec m 0) as [-> | N].
  + rewrite F2R_0; unfold Rdiv; rewrite Rmult_0_l; apply round_0; typeclasses eauto.
  + assert (X : 0 < F2R (Float radix2 m e)) by (apply F2R_gt_0; cbn; lia).
    assert (C := Fdiv_correct fexp _ _ X Y); destruct (Fdiv _ _ _) as [[m' e'] l].
    apply nearest_is_rounded; [apply Rlt_le, Rdiv_lt_0_compat; assumption | left |]; apply C.
Qed.

Theorem comes_to f : forall x, computed f = Some x -> meaning f = F2R x.
Proof.
induction f as [m | e | f IF g IG | f IF g IG | f IF | f IF | f IF | f IF | f IF g IG | f IF];
  cbn [computed meaning]; unfold both, option_map; intros x H;
  repeat match goal with
  | H : match computed ?f with _ => _ end = Some _ |- _ => destruct (computed f); [| discriminate]
  end;
  repeat match goal with I : forall y, Some ?z = Some y -> _ |- _ =>
    specialize (I z eq_refl); rewrite I; clear I end;
  try injection H as <-.
- unfold F2R; simpl; ring.
- unfold F2R; simpl; ring.
- symmetry; apply F2R_plus.
- symmetry; apply F2R_mult.
- symmetry; apply F2R_opp.
- symmetry; apply F2R_abs.
- destruct f0 as [m e]; destruct (Z.eqb_spec m (2 ^ Z.log2 m)) as [E | E]; [| discriminate].
  injection H as <-; unfold F2R; cbn [Fnum Fexp]; rewrite Rmult_1_l, bpow_opp, bpow_plus.
  rewrite E at 1; f_equal; f_equal; apply (IZR_Zpower radix2), Z.log2_nonneg.
- apply round_number_is_rounded.
- destruct (0 <? _)%Z eqn:E; [| discriminate]; injection H as <-.
  apply divide_is_rounded, positive, E.
- destruct (0 <? _)%Z eqn:E; [| discriminate]; injection H as <-; apply positive in E.
  assert (C := Fsqrt_correct fexp _ E); destruct (Fsqrt _ _) as [[m e] l].
  apply nearest_is_rounded; [apply sqrt_pos | left |]; apply C.
Qed.
End Computed.

Ltac formula_of t :=
  lazymatch t with
  | IZR ?m => constr:(Integer m)
  | bpow radix2 ?e => constr:(Power e)
  | ?a + ?b => let f := formula_of a in let g := formula_of b in constr:(Sum f g)
  | ?a - ?b => let f := formula_of a in let g := formula_of b in constr:(Sum f (Opposite g))
  | ?a * ?b => let f := formula_of a in let g := formula_of b in constr:(Product f g)
  | - ?a => let f := formula_of a in constr:(Opposite f)
  | Rabs ?a => let f := formula_of a in constr:(Size f)
  | / ?a => let f := formula_of a in constr:(Inverse f)
  | round radix2 _ ZnearestE (?a / ?b) =>
    let f := formula_of a in let g := formula_of b in constr:(Quotient f g)
  | ?a / ?b => let f := formula_of a in let g := formula_of b in constr:(Product f (Inverse g))
  | round radix2 _ ZnearestE (sqrt ?a) => let f := formula_of a in constr:(Root f)
  | round radix2 _ ZnearestE ?a => let f := formula_of a in constr:(Rounded f)
  end.

(* E: t is this number.  A size is rounded nowhere: of any format. *)
Ltac value_of fexp t E :=
  let f := formula_of t in let v := eval vm_compute in (computed fexp f) in
  lazymatch v with Some (Float _ ?m ?e) =>
    assert (E : t = IZR m * bpow radix2 e)
      by exact (comes_to fexp f (Float radix2 m e) ltac:(vm_compute; reflexivity))
  end.

(* All roundings and sizes of numbers that are written out. *)
Ltac work_out :=
  repeat match goal with
  | |- context [round radix2 ?fexp ZnearestE ?written] => let E := fresh in
    value_of fexp (round radix2 fexp ZnearestE written) E; rewrite E; clear E
  | |- context [Rabs ?written] => let E := fresh in
    value_of (FIX_exp 0) (Rabs written) E; rewrite E; clear E
  end; simpl bpow.
Ltac work_out_in H := revert H; work_out; intro H.

(* A number that is written out, of a format. *)
Ltac written := match goal with |- generic_format radix2 ?fexp ?number =>
  replace number with (round radix2 fexp ZnearestE number) by (work_out; lra);
  apply generic_format_round; typeclasses eauto end.
