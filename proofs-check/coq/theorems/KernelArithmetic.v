(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   What the checker computes on one simplex is what it means: the coefficients of P and Q are those
   of the squared norm and the determinant, the form `increase` has the sign of the mode's
   derivative, the form of degree six that of the difference of squared modes, and the forms of a
   part of the simplex are those of the whole. *)
From TensorTopo Require Import Tensors Mode Polynomials Kernel ModeOnSimplex.
Require Import Reals Psatz Ring Field ZArith List Lia.
Import ListNotations.
Open Scope R_scope.

Theorem forms_are_invariants m w :
  value (norm_form m) w = norm2 (field m w) /\ value (det_form m) w = det (field m w).
Proof. split; [apply norm_form_value|apply det_form_value]. Qed.

(* The derivative of the mode is a positive multiple of the form. *)
Theorem increase_is_derivative m d w t : field m (move w t d) <> zero -> exists k, 0 < k /\
  derivable_pt_lim (fun t => mode (field m (move w t d))) t
    (k * value (increase_form m d) (move w t d)).
Proof.
  intros N. assert (D := mode_derivative_value m d w t N). unfold mode_derivative in D.
  set (v := move w t d) in *. assert (P := norm_positive _ N). assert (P2 := norm2_positive _ N).
  assert (S := sqrt6_positive).
  exists (3 * sqrt 6 / (2 * norm (field m v) * (norm2 (field m v) * norm2 (field m v)))). split.
  - apply Rdiv_lt_0_compat; [lra|]. repeat apply Rmult_lt_0_compat; lra.
  - replace (_ * value _ _) with (3 * sqrt 6 * (value (increase_form m d) v
      / (2 * norm (field m v) * (norm2 (field m v) * norm2 (field m v))))); [exact D|].
    unfold Rdiv. ring.
Qed.

(* Coefficients of one sign decide on which side of a level all of a simplex lies. *)
Theorem sides_by_signs V num den m w : (0 < num)%Z -> (0 < den)%Z -> in_cone V w ->
  field m w <> zero -> let mu := IZR num / IZR den in
  (all_positive V (det_form m) = true -> all_positive V (level_form num den m) = true ->
    mu < mode (field m w)) /\
  (all_positive V (poly_scale (-1) (det_form m)) = true -> mode (field m w) < mu) /\
  (all_positive V (poly_scale (-1) (level_form num den m)) = true -> mode (field m w) < mu).
Proof.
  intros N D C F mu. apply IZR_lt in N. apply IZR_lt in D.
  assert (M := mode_squared _ F). assert (P := norm2_positive _ F).
  destruct (mode_det _ F) as [k [K E]].
  assert (Mu : 0 < mu) by (apply Rdiv_lt_0_compat; assumption).
  assert (MuE : mu * IZR den = IZR num) by (unfold mu; field; lra).
  set (t := field m w) in *. set (x := mode t) in *.
  assert (P3 : 0 < norm2 t * norm2 t * norm2 t) by (repeat apply Rmult_lt_0_compat; exact P).
  set (p := norm2 t * norm2 t * norm2 t) in *.
  assert (L : value (level_form num den m) w = (x * x - mu * mu) * (p * (IZR den * IZR den))).
  { rewrite level_form_value. fold t. fold p. rewrite <- MuE.
    transitivity (IZR den * IZR den * (54 * (det t * det t)) - mu * IZR den * (mu * IZR den) * p); [ring|].
    rewrite <- M. ring. }
  assert (Q : 0 < p * (IZR den * IZR den)) by (repeat apply Rmult_lt_0_compat; assumption).
  split; [|split].
  - intros H1 H2. apply all_positive_value with (w := w) in H1; [|exact C].
    apply all_positive_value with (w := w) in H2; [|exact C].
    rewrite det_form_value in H1. fold t in H1. rewrite L in H2.
    assert (X : 0 < x) by (rewrite E; apply Rmult_lt_0_compat; assumption).
    assert (0 < x * x - mu * mu).
    { apply Rnot_le_lt. intros Z. assert (0 <= (mu * mu - x * x) * (p * (IZR den * IZR den))).
      { apply Rmult_le_pos; lra. } lra. }
    nra.
  - intros H1. apply all_positive_value with (w := w) in H1; [|exact C].
    rewrite poly_scale_value, det_form_value in H1. fold t in H1.
    assert (0 < k * - det t) by (apply Rmult_lt_0_compat; lra). lra.
  - intros H1. apply all_positive_value with (w := w) in H1; [|exact C].
    rewrite poly_scale_value, L in H1.
    assert (0 < mu * mu - x * x).
    { apply Rnot_le_lt. intros Z. assert (0 <= (x * x - mu * mu) * (p * (IZR den * IZR den))).
      { apply Rmult_le_pos; lra. } lra. }
    nra.
Qed.

(* The forms of a part, whose corners have the given weights, at the weights w are those of the
   whole at the weights that these corners combine to. *)
Theorem forms_of_part m rows w : let part := map (point m) rows in
  let whole := whole_weights (length m) rows w in
  value (norm_form part) w = value (norm_form m) whole /\
  value (det_form part) w = value (det_form m) whole.
Proof.
  intros part whole. rewrite !norm_form_value, !det_form_value. unfold part, whole.
  rewrite part_field. split; reflexivity.
Qed.
