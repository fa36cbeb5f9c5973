(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   The checker's rule for the side of a level on which all of a simplex lies, for modes of either
   sign and for mode 0, with points of the level itself below: what it answers is true. *)
From TensorTopo Require Import Tensors Mode Polynomials Kernel ModeOnSimplex.
Require Import Reals Psatz Ring Field ZArith List Bool Lia.
Import ListNotations.
Open Scope R_scope.

(* All coefficients positive, not negative, negative, not positive. *)
Definition pos V p := all_positive V p.
Definition nonneg p := nonnegative p.
Definition neg V p := all_positive V (poly_scale (-1) p).
Definition nonpos p := nonnegative (poly_scale (-1) p).

Definition lies_above V num den m :=
  let q := det_form m in let f := level_form num den m in
  match Z.compare num 0 with
  | Eq => pos V q
  | Gt => pos V q && pos V f
  | Lt => nonneg q || neg V f
  end.
Definition lies_below V num den m :=
  let q := det_form m in let f := level_form num den m in
  match Z.compare num 0 with
  | Eq => nonpos q
  | Gt => nonpos q || nonpos f
  | Lt => neg V q && nonneg f
  end.

Section Values.
Variables (V : nat) (m : list corner) (w : list R).
Hypothesis C : in_cone V w.
Lemma pos_value p : pos V p = true -> 0 < value p w.
Proof. intros H. apply (all_positive_value V); assumption. Qed.
Lemma nonneg_value p : nonneg p = true -> 0 <= value p w.
Proof. intros H. apply nonnegative_value; [apply C|exact H]. Qed.
Lemma neg_value p : neg V p = true -> value p w < 0.
Proof.
  intros H. assert (K := all_positive_value V _ w H C). rewrite poly_scale_value in K. lra.
Qed.
Lemma nonpos_value p : nonpos p = true -> value p w <= 0.
Proof.
  intros H. assert (K := nonnegative_value _ w (proj1 C) H). rewrite poly_scale_value in K. lra.
Qed.
End Values.

(* The signs of the two forms say what those of the mode and of mode^2 - mu^2 are. *)
Lemma form_signs num den m w : (0 < den)%Z -> field m w <> zero ->
  let mu := IZR num / IZR den in let x := mode (field m w) in
  exists k l, 0 < k /\ 0 < l /\ x = k * value (det_form m) w /\
    value (level_form num den m) w = l * (x * x - mu * mu) /\ mu * IZR den = IZR num.
Proof.
  intros D F mu x. apply IZR_lt in D. assert (P := norm2_positive _ F).
  assert (M := mode_squared _ F). destruct (mode_det _ F) as [k [K E]].
  assert (MuE : mu * IZR den = IZR num) by (unfold mu; field; lra).
  set (t := field m w) in *. set (p := norm2 t * norm2 t * norm2 t) in *.
  exists k, (p * (IZR den * IZR den)). split; [exact K|]. split.
  - unfold p. repeat apply Rmult_lt_0_compat; assumption.
  - split; [rewrite det_form_value; exact E|]. split; [|exact MuE].
    rewrite level_form_value. fold t. fold p. rewrite <- MuE.
    transitivity (IZR den * IZR den * (54 * (det t * det t)) - mu * IZR den * (mu * IZR den) * p); [ring|].
    rewrite <- M. fold x. ring.
Qed.

Theorem lies_above_is_right V num den m w : (0 < den)%Z -> in_cone V w -> field m w <> zero ->
  lies_above V num den m = true -> IZR num / IZR den < mode (field m w).
Proof.
  intros D C F H. destruct (form_signs num den m w D F) as [k [l [K [L [X [Y MuE]]]]]].
  apply IZR_lt in D. set (mu := IZR num / IZR den) in *. set (x := mode (field m w)) in *.
  set (q := value (det_form m) w) in *. set (f := value (level_form num den m) w) in *.
  unfold lies_above in H. destruct (Z.compare_spec num 0) as [Z|Z|Z].
  - apply (pos_value V w C) in H. fold q in H. rewrite Z in MuE.
    assert (mu = 0) by (apply (Rmult_eq_reg_r (IZR den)); lra).
    assert (0 < k * q) by (apply Rmult_lt_0_compat; assumption). lra.
  - apply IZR_lt in Z. assert (Mu : mu < 0) by nra. apply orb_prop in H. destruct H as [H|H].
    + apply (nonneg_value V w C) in H. fold q in H. assert (0 <= k * q) by (apply Rmult_le_pos; lra). lra.
    + apply (neg_value V w C) in H. fold f in H. rewrite Y in H.
      assert (x * x - mu * mu < 0) by nra. nra.
  - apply IZR_lt in Z. assert (Mu : 0 < mu) by nra. apply andb_prop in H. destruct H as [H1 H2].
    apply (pos_value V w C) in H1. apply (pos_value V w C) in H2. fold q in H1. fold f in H2.
    assert (0 < k * q) by (apply Rmult_lt_0_compat; assumption). rewrite Y in H2.
    assert (0 < x * x - mu * mu) by nra. nra.
Qed.

Theorem lies_below_is_right V num den m w : (0 < den)%Z -> in_cone V w -> field m w <> zero ->
  lies_below V num den m = true -> mode (field m w) <= IZR num / IZR den.
Proof.
  intros D C F H. destruct (form_signs num den m w D F) as [k [l [K [L [X [Y MuE]]]]]].
  apply IZR_lt in D. set (mu := IZR num / IZR den) in *. set (x := mode (field m w)) in *.
  set (q := value (det_form m) w) in *. set (f := value (level_form num den m) w) in *.
  unfold lies_below in H. destruct (Z.compare_spec num 0) as [Z|Z|Z].
  - apply (nonpos_value V w C) in H. fold q in H. rewrite Z in MuE.
    assert (mu = 0) by (apply (Rmult_eq_reg_r (IZR den)); lra).
    assert (0 <= k * - q) by (apply Rmult_le_pos; lra). lra.
  - apply IZR_lt in Z. assert (Mu : mu < 0) by nra. apply andb_prop in H. destruct H as [H1 H2].
    apply (neg_value V w C) in H1. apply (nonneg_value V w C) in H2. fold q in H1. fold f in H2.
    assert (0 < k * - q) by (apply Rmult_lt_0_compat; lra). rewrite Y in H2.
    assert (0 <= x * x - mu * mu) by nra. nra.
  - apply IZR_lt in Z. assert (Mu : 0 < mu) by nra. apply orb_prop in H. destruct H as [H|H].
    + apply (nonpos_value V w C) in H. fold q in H. assert (0 <= k * - q) by (apply Rmult_le_pos; lra). lra.
    + apply (nonpos_value V w C) in H. fold f in H. rewrite Y in H.
      assert (x * x - mu * mu <= 0) by nra. nra.
Qed.
