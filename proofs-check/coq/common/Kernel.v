(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   What the checker of certificates computes on one simplex, with the integers of Coq. The tensors
   of the corners have the entries 11, 22, 33, 23, 13, 12, as in the checker. *)
From TensorTopo Require Import Tensors Polynomials.
Require Import Reals Psatz Ring ZArith List Bool.
Import ListNotations.
Open Scope R_scope.

Record corner := Corner { c11 : Z; c22 : Z; c33 : Z; c23 : Z; c13 : Z; c12 : Z }.
Definition corner_tensor c :=
  Tensor (IZR (c11 c)) (IZR (c22 c)) (IZR (c33 c)) (IZR (c12 c)) (IZR (c23 c)) (IZR (c13 c)).

(* The tensor at the weights w. *)
Fixpoint field (m : list corner) (w : list R) : tensor :=
  match m with [] => zero | c :: m' => add (scale (hd 0 w) (corner_tensor c)) (field m' (tl w)) end.

(* P = tr(M^2), Q = det(M), and 2 P dQ - 3 Q dP, of the sign of the mode's derivative along d. *)
Definition entry (f : corner -> Z) (m : list corner) := linear_form (map f m).
Definition norm_form (m : list corner) : polynomial :=
  let sq f := poly_mul (entry f m) (entry f m) in
  poly_add (poly_add (sq c11) (poly_add (sq c22) (sq c33)))
           (poly_scale 2 (poly_add (sq c23) (poly_add (sq c13) (sq c12)))).
Definition det_form (m : list corner) : polynomial :=
  let x f := entry f m in
  let minor a b c d := poly_add (poly_mul (x a) (x b)) (poly_scale (-1) (poly_mul (x c) (x d))) in
  poly_add (poly_mul (x c11) (minor c22 c33 c23 c23))
    (poly_add (poly_mul (x c12) (minor c23 c13 c33 c12)) (poly_mul (x c13) (minor c12 c23 c22 c13))).
Definition increase_form (m : list corner) (d : list Z) : polynomial :=
  let p := norm_form m in let q := det_form m in
  poly_add (poly_scale 2 (poly_mul p (poly_derivative q d)))
           (poly_scale (-3) (poly_mul q (poly_derivative p d))).
(* 54 den^2 Q^2 - num^2 P^3: positive where the mode's square exceeds that of num / den. *)
Definition level_form (num den : Z) (m : list corner) : polynomial :=
  let p := norm_form m in let q := det_form m in
  poly_add (poly_scale (54 * den * den) (poly_mul q q))
           (poly_scale (- (num * num)) (poly_mul p (poly_mul p p))).

(* The corners of a part of the simplex: weights of the whole's corners. *)
Fixpoint weighted (f : corner -> Z) (m : list corner) (w : list Z) : Z :=
  match m with [] => 0%Z | c :: m' => (hd 0 w * f c + weighted f m' (tl w))%Z end.
Definition point (m : list corner) (w : list Z) : corner :=
  Corner (weighted c11 m w) (weighted c22 m w) (weighted c33 m w)
         (weighted c23 m w) (weighted c13 m w) (weighted c12 m w).

Lemma field_entries m w : field m w =
  Tensor (weighted_sum (map c11 m) w) (weighted_sum (map c22 m) w) (weighted_sum (map c33 m) w)
         (weighted_sum (map c12 m) w) (weighted_sum (map c23 m) w) (weighted_sum (map c13 m) w).
Proof. revert w. induction m as [|c m IH]; intros w; cbn; [reflexivity|]. rewrite IH. reflexivity. Qed.

Lemma entry_value f m w : value (entry f m) w = weighted_sum (map f m) w.
Proof. apply linear_form_value. Qed.

Ltac values := rewrite ?poly_add_value, ?poly_scale_value, ?poly_mul_value, ?entry_value.

Lemma norm_form_value m w : value (norm_form m) w = norm2 (field m w).
Proof.
  unfold norm_form. repeat (values; cbv beta). rewrite field_entries. unfold norm2, inner.
  cbn [xx yy zz xy yz xz]. ring.
Qed.
Lemma det_form_value m w : value (det_form m) w = det (field m w).
Proof.
  unfold det_form. repeat (values; cbv beta). rewrite field_entries. unfold det.
  cbn [xx yy zz xy yz xz]. ring.
Qed.
Lemma increase_form_value m d w : value (increase_form m d) w
  = 2 * norm2 (field m w) * value (poly_derivative (det_form m) d) w
    - 3 * det (field m w) * value (poly_derivative (norm_form m) d) w.
Proof.
  unfold increase_form. repeat values. rewrite norm_form_value, det_form_value. ring.
Qed.
Lemma level_form_value num den m w : value (level_form num den m) w
  = 54 * (IZR den * IZR den) * (det (field m w) * det (field m w))
    - IZR num * IZR num * (norm2 (field m w) * norm2 (field m w) * norm2 (field m w)).
Proof.
  unfold level_form. repeat values. rewrite norm_form_value, det_form_value.
  rewrite opp_IZR, !mult_IZR. ring.
Qed.

(* The derivatives along d are those of P and Q. *)
Lemma norm_derivative m d w t :
  derivable_pt_lim (fun t => norm2 (field m (move w t d))) t
    (value (poly_derivative (norm_form m) d) (move w t d)).
Proof.
  assert (H := poly_derivative_value (norm_form m) d w t). intros eps E.
  destruct (H eps E) as [delta D]. exists delta. intros h N S. assert (K := D h N S).
  rewrite !norm_form_value in K. exact K.
Qed.
Lemma det_derivative m d w t :
  derivable_pt_lim (fun t => det (field m (move w t d))) t
    (value (poly_derivative (det_form m) d) (move w t d)).
Proof.
  assert (H := poly_derivative_value (det_form m) d w t). intros eps E.
  destruct (H eps E) as [delta D]. exists delta. intros h N S. assert (K := D h N S).
  rewrite !det_form_value in K. exact K.
Qed.

(* A part's field is the whole's, at weights that the part's corners determine. *)
Fixpoint combine_weights (rows : list (list Z)) (w : list R) (i : nat) : R :=
  match rows with
  | [] => 0
  | row :: rows' => hd 0 w * IZR (nth i row 0%Z) + combine_weights rows' (tl w) i
  end.
Definition whole_weights n rows w := map (combine_weights rows w) (seq 0 n).

Fixpoint sum_below (n : nat) (g : nat -> R) : R :=
  match n with O => 0 | S n' => g O + sum_below n' (fun i => g (S i)) end.
Lemma sum_below_plus n g h k :
  sum_below n (fun i => k * g i + h i) = k * sum_below n g + sum_below n h.
Proof. revert g h. induction n as [|n IH]; intros g h; cbn; [ring|]. rewrite IH. ring. Qed.
Lemma sum_below_ext n g h : (forall i, g i = h i) -> sum_below n g = sum_below n h.
Proof. revert g h. induction n as [|n IH]; intros g h E; cbn; [reflexivity|]. rewrite E. f_equal. apply IH. auto. Qed.

Lemma weighted_sum_below (f : corner -> Z) m (g : nat -> R) k :
  weighted_sum (map f m) (map g (seq k (length m)))
  = sum_below (length m) (fun i => g (k + i)%nat * IZR (nth i (map f m) 0%Z)).
Proof.
  revert k. induction m as [|c m IH]; intros k; cbn; [reflexivity|].
  rewrite IH, Nat.add_0_r. f_equal. apply sum_below_ext. intros i. rewrite Nat.add_succ_r. reflexivity.
Qed.
Lemma weighted_below f m row :
  IZR (weighted f m row) = sum_below (length m) (fun i => IZR (nth i row 0%Z) * IZR (nth i (map f m) 0%Z)).
Proof.
  revert row. induction m as [|c m IH]; intros row; cbn; [reflexivity|].
  rewrite plus_IZR, mult_IZR, IH. f_equal; [destruct row; cbn; reflexivity|].
  apply sum_below_ext. intros i. destruct row as [|z row]; cbn; [destruct i; reflexivity|reflexivity].
Qed.
Lemma part_entry (f g : corner -> Z) m rows w : (forall row, g (point m row) = weighted f m row) ->
  weighted_sum (map g (map (point m) rows)) w
  = weighted_sum (map f m) (whole_weights (length m) rows w).
Proof.
  intros G. unfold whole_weights. rewrite weighted_sum_below. cbn [Nat.add]. revert w.
  induction rows as [|row rows IH]; intros w; cbn.
  - induction (length m) as [|n IHn] in |- *; [reflexivity|].
    transitivity (sum_below (S n) (fun _ => 0)); [|apply sum_below_ext; intros; ring].
    clear. generalize (S n). clear n. intros n. induction n as [|n IH]; cbn; [reflexivity|].
    rewrite <- IH. ring.
  - rewrite IH, G, weighted_below, <- sum_below_plus. apply sum_below_ext. intros i. ring.
Qed.
Lemma part_field m rows w :
  field (map (point m) rows) w = field m (whole_weights (length m) rows w).
Proof.
  rewrite !field_entries.
  rewrite (part_entry c11 c11), (part_entry c22 c22), (part_entry c33 c33),
    (part_entry c12 c12), (part_entry c23 c23), (part_entry c13 c13); reflexivity.
Qed.
