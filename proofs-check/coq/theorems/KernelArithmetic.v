(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   What the checker computes on one simplex is what it means: the coefficients of P and Q are those
   of the squared norm and the determinant, the form `increase` has the sign of the mode's
   derivative, and the forms of a part of the simplex are those of the whole. *)
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
