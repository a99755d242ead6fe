(* SPDX-License-Identifier: MIT *)
(* For counterexamples: what double-doubles that are written out come to. *)
From Coq Require Import Reals Lra.
From Flocq Require Import Core.
From Brink Require Import rounding exact_dd_products impulse_dd computed.
Open Scope R_scope.

Ltac parts_of t := eval cbv beta zeta iota delta
  [dd_add dd_mul dd_div dd_sqrt dd_mul_d dd_add_d dd_negate normal low rnd hi lo] in t.

(* An operation on what is written out: as it comes out, in the goal. *)
Ltac comes_out t :=
  let h := parts_of (hi t) in let l := parts_of (lo t) in
  let E := fresh in let F := fresh in value_of fexp h E; value_of fexp l F;
  rewrite (f_equal2 Dd E F : t = Dd _ _); clear E F.
Ltac work_out_dd :=
  repeat match goal with
  | |- context [dd_add (Dd ?a ?b) (Dd ?c ?d)] => comes_out (dd_add (Dd a b) (Dd c d))
  | |- context [dd_mul (Dd ?a ?b) (Dd ?c ?d)] => comes_out (dd_mul (Dd a b) (Dd c d))
  | |- context [dd_div (Dd ?a ?b) (Dd ?c ?d)] => comes_out (dd_div (Dd a b) (Dd c d))
  | |- context [dd_mul_d (Dd ?a ?b) ?c] => comes_out (dd_mul_d (Dd a b) c)
  | |- context [dd_add_d (Dd ?a ?b) ?c] => comes_out (dd_add_d (Dd a b) c)
  | |- context [dd_sqrt (Dd ?a ?b)] => comes_out (dd_sqrt (Dd a b))
  | |- context [dd_negate (Dd ?a ?b)] => comes_out (dd_negate (Dd a b))
  | |- context [normal ?s] => comes_out (normal s)
  end.
(* That is this pair. *)
Ltac is_pair := work_out_dd; f_equal; simpl bpow; lra.
