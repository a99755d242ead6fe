(* SPDX-License-Identifier: MIT *)
(* Correct rounding by the sign of the polynomial at a midpoint: root.c. *)
From Coq Require Import ZArith Znumtheory Zpow_facts Reals Psatz Lia.
From Flocq Require Import Core.
Open Scope R_scope.

Notation pow := (bpow radix2).

(* --- No root is a midpoint -------------------------------------------------- *)

(* A number of 53 bits, of any exponent: every double is one. *)
Definition has_53_bits (x : R) :=
  exists m e, x = IZR m * pow e /\ (Z.abs m < 2 ^ 53)%Z.

(* Halfway between two adjacent doubles with all their bits, m 2^e and (m + 1)
   2^e. *)
Definition is_midpoint (x : R) :=
  exists m e, (2 ^ 52 <= Z.abs m)%Z /\ (2 ^ 52 <= Z.abs (m + 1))%Z /\
              x = IZR (2 * m + 1) * pow (e - 1).

Lemma odd_divides n m k :
  (0 <= k)%Z -> Z.Odd n -> (n | m * 2 ^ k)%Z -> (n | m)%Z.
Proof.
intros K [h E] D; apply Gauss with (2 ^ k)%Z; [rewrite Z.mul_comm; exact D|].
apply rel_prime_Zpower_r; [exact K|].
apply bezout_rel_prime, Bezout_intro with 1%Z (- h)%Z; lia.
Qed.

Lemma too_large_to_divide n m :
  (n | m)%Z -> (Z.abs m < Z.abs n)%Z -> m = 0%Z.
Proof.
intros D L; destruct (Z.eq_dec m 0) as [Z|N]; [exact Z|].
pose proof (Zdivide_bounds n m D N); lia.
Qed.

(* Of a x^2 + b x + c with doubles a, b, c, not all 0, no midpoint is a root: its
   odd part, of 54 bits, would divide c, so c = 0; then b, and a.  (Where the
   root is below 2^-1022 a midpoint has fewer bits, and may be one.) *)
Theorem root_is_no_midpoint a b c x :
  has_53_bits a -> has_53_bits b -> has_53_bits c -> is_midpoint x ->
  a * x * x + b * x + c = 0 -> a = 0 /\ b = 0 /\ c = 0.
Proof.
intros (A & ea & -> & La) (B & eb & -> & Lb) (C & ec & -> & Lc).
intros (m & e & Large & Large' & ->) Root.
set (n := (2 * m + 1)%Z) in *; set (g := (e - 1)%Z) in *.
assert (Z.Odd n) as Odd by (exists m; reflexivity).
assert (2 ^ 53 <= Z.abs n)%Z as Bits
  by (change (2 ^ 53)%Z with (2 * 2 ^ 52)%Z; unfold n; lia).
clearbody n g; clear m Large Large'.
set (k := Z.min (ea + 2 * g) (Z.min (eb + g) ec)).
set (i := (ea + 2 * g - k)%Z); set (j := (eb + g - k)%Z); set (l := (ec - k)%Z).
assert (0 <= i /\ 0 <= j /\ 0 <= l)%Z as (I & J & L) by (unfold i, j, l, k; lia).
assert (A * 2 ^ i * n * n + B * 2 ^ j * n + C * 2 ^ l = 0)%Z as E.
{ apply eq_IZR; rewrite !plus_IZR, !mult_IZR.
  rewrite !(IZR_Zpower radix2) by assumption.
  rewrite <- (Rmult_0_l (pow (- k))), <- Root.
  replace (pow i) with (pow ea * pow g * pow g * pow (- k))
    by (rewrite <- !bpow_plus; f_equal; unfold i; lia).
  replace (pow j) with (pow eb * pow g * pow (- k))
    by (rewrite <- !bpow_plus; f_equal; unfold j; lia).
  replace (pow l) with (pow ec * pow (- k))
    by (rewrite <- !bpow_plus; f_equal; unfold l; lia).
  ring. }
assert (C = 0)%Z as ->.
{ apply too_large_to_divide with n; [|lia].
  apply odd_divides with l; try assumption.
  exists (- (A * 2 ^ i * n + B * 2 ^ j))%Z; lia. }
assert (A * 2 ^ i * n + B * 2 ^ j = 0)%Z as E'.
{ apply Z.mul_reg_r with n; lia. }
assert (B = 0)%Z as ->.
{ apply too_large_to_divide with n; [|lia].
  apply odd_divides with j; try assumption.
  exists (- (A * 2 ^ i))%Z; lia. }
assert (A = 0)%Z as ->.
{ assert (2 ^ i <> 0)%Z by (apply Z.pow_nonzero; lia).
  assert (A * 2 ^ i = 0)%Z by (apply Z.mul_reg_r with n; lia).
  apply Z.mul_reg_r with (2 ^ i)%Z; lia. }
repeat split; ring.
Qed.

(* --- The sign at the midpoint ----------------------------------------------- *)

Definition sign (x : R) : R :=
  if Rlt_dec 0 x then 1 else if Rlt_dec x 0 then -1 else 0.

Lemma sign_cases y :
  (0 < y /\ sign y = 1) \/ (y < 0 /\ sign y = -1) \/ (y = 0 /\ sign y = 0).
Proof.
unfold sign; destruct (Rlt_dec 0 y); [left; auto|].
destruct (Rlt_dec y 0); [right; left; auto | right; right; split; lra].
Qed.

Lemma sign_of_product k y : sign (k * y) = sign k * sign y.
Proof.
destruct (sign_cases k) as [[K ->]|[[K ->]|[K ->]]];
  destruct (sign_cases y) as [[Y ->]|[[Y ->]|[Y ->]]];
  destruct (sign_cases (k * y)) as [[P ->]|[[P ->]|[P ->]]]; try lra; nra.
Qed.

(* What tells, of a parabola that opens upward, by half its slope s, where that
   is s0 at the root: s0 <= 0 at the lower root, s0 >= 0 at the upper one. *)
Lemma lower_by_slope s s0 : s0 <= 0 ->
  (if Rlt_dec 0 (sign s) then -1 else sign (s * s - s0 * s0)) = sign (s0 - s).
Proof.
intro N; destruct (sign_cases s) as [[S ->]|[[S ->]|[S ->]]];
  destruct (Rlt_dec 0 _); try lra;
  destruct (sign_cases (s0 - s)) as [[D ->]|[[D ->]|[D ->]]]; try lra;
  destruct (sign_cases (s * s - s0 * s0)) as [[V ->]|[[V ->]|[V ->]]]; try lra;
    nra.
Qed.

Lemma upper_by_slope s s0 : 0 <= s0 ->
  (if Rlt_dec (sign s) 0 then 1 else - sign (s * s - s0 * s0)) = sign (s0 - s).
Proof.
intro N; destruct (sign_cases s) as [[S ->]|[[S ->]|[S ->]]];
  destruct (Rlt_dec _ 0); try lra;
  destruct (sign_cases (s0 - s)) as [[D ->]|[[D ->]|[D ->]]]; try lra;
  destruct (sign_cases (s * s - s0 * s0)) as [[V ->]|[[V ->]|[V ->]]]; try lra;
    nra.
Qed.

Section Root.
Variables a b c x : R.

Definition poly (t : R) := a * t * t + 2 * b * t + c.

(* root_minus() *)
Definition slope := a * x + b.
Definition value := (slope + b) * x + c.
Definition up := if Req_EM_T a 0 then sign b else sign a.
Definition lower_minus := if Rlt_dec 0 (up * sign slope) then -1 else up * sign
  value.
Definition upper_minus := if Rlt_dec (up * sign slope) 0 then 1 else - up * sign
  value.

(* Half the slope at a root, and what the polynomial is by it. *)
Lemma by_slope root : a <> 0 -> poly root = 0 -> let s0 := a * root + b in
  a * value = slope * slope - s0 * s0 /\ a * (root - x) = s0 - slope /\
  poly (- 2 * b / a - root) = 0 /\ a * (- 2 * b / a - root - root) = - 2 * s0.
Proof.
intros A Root s0; repeat split.
- replace (s0 * s0) with (s0 * s0 - a * poly root) by (rewrite Root; ring).
  unfold s0, value, slope, poly; ring.
- unfold s0, slope; ring.
- rewrite <- Root; unfold poly; field; exact A.
- unfold s0; field; exact A.
Qed.

(* The sign of root - x, for the lower and the upper root; *)
Theorem sign_of_lower_root root : a <> 0 ->
  poly root = 0 -> (forall t, poly t = 0 -> root <= t) ->
  lower_minus = sign (root - x).
Proof.
intros A Root Least; destruct (by_slope root A Root) as (V & D & Other & O).
specialize (Least _ Other); set (s0 := a * root + b) in *; clearbody s0.
apply (f_equal sign) in V, D; rewrite sign_of_product in V, D.
unfold lower_minus, up; destruct (Req_EM_T a 0); [contradiction|].
destruct (sign_cases a) as [[P S]|[[P S]|[P S]]]; [| |lra];
  rewrite S in V, D |- *.
- rewrite Rmult_1_l in V, D; rewrite !Rmult_1_l, V, D.
  apply lower_by_slope; nra.
- assert (sign value = - sign (slope * slope - s0 * s0)) as -> by lra.
  assert (sign (root - x) = - sign (s0 - slope)) as -> by lra.
  rewrite <- (upper_by_slope slope s0) by nra.
  destruct (Rlt_dec 0 (-1 * sign slope)); destruct (Rlt_dec (sign slope) 0); lra.
Qed.

Theorem sign_of_upper_root root : a <> 0 ->
  poly root = 0 -> (forall t, poly t = 0 -> t <= root) ->
  upper_minus = sign (root - x).
Proof.
intros A Root Most; destruct (by_slope root A Root) as (V & D & Other & O).
specialize (Most _ Other); set (s0 := a * root + b) in *; clearbody s0.
apply (f_equal sign) in V, D; rewrite sign_of_product in V, D.
unfold upper_minus, up; destruct (Req_EM_T a 0); [contradiction|].
destruct (sign_cases a) as [[P S]|[[P S]|[P S]]]; [| |lra];
  rewrite S in V, D |- *.
- rewrite Rmult_1_l in V, D; rewrite Rmult_1_l, V, D.
  rewrite <- (upper_by_slope slope s0) by nra.
  destruct (Rlt_dec (sign slope) 0); lra.
- assert (sign value = - sign (slope * slope - s0 * s0)) as -> by lra.
  assert (sign (root - x) = - sign (s0 - slope)) as -> by lra.
  rewrite <- (lower_by_slope slope s0) by nra.
  destruct (Rlt_dec (-1 * sign slope) 0); destruct (Rlt_dec 0 (sign slope)); lra.
Qed.

(* and for a quotient, the root of 2 b x + c, asked for as an upper one. *)
Theorem sign_of_quotient root : a = 0 -> b <> 0 -> poly root = 0 ->
  upper_minus = sign (root - x).
Proof.
intros A B Root.
assert (value = - 2 * b * (root - x)) as V.
{ rewrite <- (Rminus_0_r value), <- Root; unfold value, slope, poly.
  rewrite A; ring. }
assert (slope = b) as S by (unfold slope; rewrite A; ring).
unfold upper_minus, up; rewrite S, V, !sign_of_product.
destruct (Req_EM_T a 0); [|contradiction].
assert (sign (- 2) = -1) as -> by (destruct (sign_cases (- 2)) as [[]|[[]|[]]];
  lra).
destruct (sign_cases b) as [[P ->]|[[P ->]|[P ->]]];
  destruct (Rlt_dec _ 0); lra.
Qed.
End Root.

(* --- The last place --------------------------------------------------------- *)

(* round_root(), in units of the last place: y is t to 2^-43, m what of y is
   whole, `below` the 32 bits that follow. *)
Section Cut.
Variables t y : R.
Hypothesis Near : Rabs (t - y) <= pow (-43).

Definition m := Zfloor y.
Definition below := Zfloor ((y - IZR m) * pow 32).
Definition middle := IZR m + / 2.

(* Asked only where below is 2^31 or 2^31 - 1: by its sign at the midpoint. *)
Definition away : bool :=
  if orb (below =? 2 ^ 31)%Z (below =? 2 ^ 31 - 1)%Z
  then if Rlt_dec 0 (sign (t - middle)) then true
       else if Req_EM_T (sign (t - middle)) 0 then negb (Z.even m) else false
  else (2 ^ 31 <=? below)%Z.

Definition rounded := (if away then m + 1 else m)%Z.

(* The integer nearest to t, ties to even. *)
Theorem rounded_is_nearest : rounded = ZnearestE t.
Proof.
assert (IZR m <= y < IZR m + 1) as [M1 M2] by (split;
  [apply Zfloor_lb | apply Zfloor_ub]).
assert (IZR below <= (y - IZR m) * pow 32 < IZR below + 1) as [B1 B2]
  by (split; [apply Zfloor_lb | apply Zfloor_ub]).
apply Rabs_le_inv in Near; simpl (pow _) in Near, B1, B2.
unfold rounded, away.
set (w := below) in *; clearbody w; set (n := m) in *.
assert (middle = IZR n + / 2) as Mid by reflexivity.
assert (forall k, (w <= k)%Z -> IZR w <= IZR k) as Up by (intros; apply IZR_le;
  assumption).
assert (forall k, (k <= w)%Z -> IZR k <= IZR w) as Lo by (intros; apply IZR_le;
  assumption).
change (2 ^ 31)%Z with 2147483648%Z.
change (2147483648 - 1)%Z with 2147483647%Z.
destruct (Z.eqb_spec w 2147483648) as [W|W];
  [|destruct (Z.eqb_spec w 2147483647) as [W'|W']];
  simpl orb; cbv iota.
1, 2: assert (IZR n < t < IZR n + 1) as [T1 T2]
  by (subst w; simpl in B1, B2; split; lra).
1, 2: destruct (sign_cases (t - middle)) as [[S ->]|[[S ->]|[S ->]]].
1, 2, 3, 4, 5, 6: destruct (Rlt_dec 0 _); try lra.
1, 4: symmetry; apply Znearest_imp; rewrite plus_IZR; apply Rabs_def1; lra.
1, 3: destruct (Req_EM_T (-1) 0); [lra|];
  symmetry; apply Znearest_imp; apply Rabs_def1; lra.
1, 2: destruct (Req_EM_T 0 0); [|lra].
1, 2: assert (Zfloor t = n) as F by (apply Zfloor_imp; rewrite plus_IZR; lra).
1, 2: unfold Znearest; rewrite F, Rcompare_Eq by lra;
  destruct (Z.even n); simpl; [reflexivity|];
  symmetry; apply Zceil_imp; rewrite minus_IZR, plus_IZR; simpl; lra.
destruct (Z.leb_spec 2147483648 w) as [L|L].
- assert (2147483649 <= w)%Z as L' by lia; specialize (Lo _ L'); simpl in Lo.
  symmetry; apply Znearest_imp; rewrite plus_IZR; apply Rabs_def1; lra.
- assert (w <= 2147483646)%Z as L' by lia; specialize (Up _ L'); simpl in Up.
  symmetry; apply Znearest_imp; apply Rabs_def1; lra.
Qed.
End Cut.

(* So the result is the root rounded, where the last place is the root's own. *)
Theorem root_is_rounded root y :
  let last := cexp radix2 (FLT_exp (-1074) 53) root in
  Rabs (root * pow (- last) - y) <= pow (-43) ->
  IZR (rounded (root * pow (- last)) y) * pow last
  = round radix2 (FLT_exp (-1074) 53) ZnearestE root.
Proof.
intros last Near; rewrite (rounded_is_nearest _ _ Near); reflexivity.
Qed.
