(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   The function Q - mu P sqrt(P/54) of P = tr(M^2) and Q = det(M), which has the sign of the mode less
   mu: on a simplex, its derivative dQ - (3/2) mu sqrt(P/54) dP along a direction, and its continuity.
   With a linear form in the place of the root the derivative is a quadratic form in the weights. *)
From TensorTopo Require Import Tensors Mode Polynomials Kernel ModeOnSimplex Dual RealForms Calculus
  IncreasingFunction.
Require Import Reals Psatz Ring Field ZArith List Lia.
Import ListNotations.
Open Scope R_scope.

Definition root t := sqrt (norm2 t / 54).
Definition level_value mu t := det t - mu * (norm2 t * root t).

Lemma root_nonneg t : 0 <= root t.
Proof. apply sqrt_pos. Qed.
Lemma root_squared t : root t * root t = norm2 t / 54.
Proof. apply sqrt_sqrt. assert (H := norm2_nonneg t). lra. Qed.
Lemma root_positive t : t <> zero -> 0 < root t.
Proof. intros H. apply sqrt_lt_R0. assert (P := norm2_positive t H). lra. Qed.
Lemma root_of_norm t : root t = norm t / (3 * sqrt 6).
Proof.
  assert (S := sqrt6_positive). assert (N := norm_nonneg t).
  assert (X : 0 <= norm t / (3 * sqrt 6)).
  { unfold Rdiv. apply Rmult_le_pos; [exact N|]. left. apply Rinv_0_lt_compat. lra. }
  unfold root. rewrite <- (sqrt_square (norm t / (3 * sqrt 6))) by exact X. f_equal.
  transitivity (norm t * norm t / (9 * (sqrt 6 * sqrt 6))); [|field; lra].
  rewrite norm_squared, sqrt6. field.
Qed.
Lemma level_value_sign mu t : t <> zero -> exists k, 0 < k /\ level_value mu t = k * (mode t - mu).
Proof.
  intros N. assert (P := norm2_positive t N). assert (R := root_positive t N).
  assert (S := sqrt6_positive). assert (L := norm_positive t N).
  exists (norm2 t * root t). split; [apply Rmult_lt_0_compat; assumption|].
  unfold level_value. assert (E : norm2 t * root t * mode t = det t).
  { unfold mode. rewrite root_of_norm, <- norm_squared. field. lra. }
  rewrite <- E. ring.
Qed.
Lemma level_value_side mu t : t <> zero ->
  (0 < level_value mu t <-> mu < mode t) /\ (level_value mu t < 0 <-> mode t < mu) /\
  (level_value mu t = 0 <-> mode t = mu).
Proof.
  intros N. destruct (level_value_sign mu t N) as [k [K E]]. rewrite E.
  assert (X : k * (mode t - mu) = k * mode t - k * mu) by ring.
  repeat split; intros H; nra.
Qed.

(* The norm is convex. *)
Lemma le_of_squares x y : 0 <= y -> x * x <= y * y -> x <= y.
Proof. intros Y H. apply Rnot_lt_le. intros L. nra. Qed.
Lemma inner_root a b : inner a b <= 54 * (root a * root b).
Proof.
  assert (A := root_nonneg a). assert (B := root_nonneg b). assert (C := cauchy a b).
  apply le_of_squares; [assert (0 <= root a * root b) by (apply Rmult_le_pos; assumption); lra|].
  replace (54 * (root a * root b) * (54 * (root a * root b)))
    with (54 * (root a * root a) * (54 * (root b * root b))) by ring.
  rewrite !root_squared. replace (54 * (norm2 a / 54)) with (norm2 a) by field.
  replace (54 * (norm2 b / 54)) with (norm2 b) by field. exact C.
Qed.
Lemma root_triangle a b : root (add a b) <= root a + root b.
Proof.
  assert (A := root_nonneg a). assert (B := root_nonneg b). apply le_of_squares; [lra|].
  rewrite root_squared. assert (I := inner_root a b).
  replace (norm2 (add a b)) with (norm2 a + 2 * inner a b + norm2 b)
    by (unfold norm2, inner, add; cbn; ring).
  assert (Ea := root_squared a). assert (Eb := root_squared b). nra.
Qed.
Lemma root_scale k t : 0 <= k -> root (scale k t) = k * root t.
Proof. intros K. rewrite !root_of_norm, norm_scale, Rabs_pos_eq by exact K. unfold Rdiv. ring. Qed.

(* The derivatives of P and Q along d, by the tensor that d is a multiple of. *)
Definition step m d := field m (map IZR d).
Definition norm_slope m d w := value (poly_derivative (norm_form m) d) w.
Definition det_slope m d w := value (poly_derivative (det_form m) d) w.

Lemma field_move m w t d : field m (move w t d) = add (field m w) (scale t (step m d)).
Proof.
  unfold step. revert w d. induction m as [|c m IH]; intros w d; cbn [field].
  - tensor_ring.
  - destruct d as [|z d]; cbn [move map hd tl].
    + assert (E := IH (tl w) []). cbn [move map] in E.
      transitivity (add (scale (hd 0 w) (corner_tensor c)) (add (field m (tl w)) (scale t (field m [])))).
      * f_equal. exact E.
      * generalize (field m (tl w)) (field m []) (corner_tensor c) (hd 0 w). clear. intros. tensor_ring.
    + rewrite IH. generalize (field m (tl w)) (field m (map IZR d)) (corner_tensor c).
      intros u v x. generalize (hd 0 w) (IZR z). intros y s. tensor_ring.
Qed.
Lemma at_start m w d : field m (move w 0 d) = field m w.
Proof. rewrite field_move. generalize (step m d) (field m w). intros a b. tensor_ring. Qed.
Lemma slopes m d w : norm_slope m d w = 2 * inner (field m w) (step m d) /\
  det_slope m d w = det_linear (field m w) (step m d).
Proof.
  unfold norm_slope, det_slope. set (a := field m w). set (u := step m d).
  split; rewrite <- (value_at_start _ w d) by apply continuous_value.
  - assert (D := cubic_derivative (norm2 a) (2 * inner a u) (norm2 u) 0 0).
    apply (uniqueness_limite _ _ _ _ (norm_derivative m d w 0)).
    replace (2 * inner a u) with (2 * inner a u + 2 * norm2 u * 0 + 3 * 0 * (0 * 0)) by ring.
    intros eps E. destruct (D eps E) as [delta K]. exists delta. intros h H1 H2.
    rewrite !field_move. fold a u. rewrite !norm2_line. exact (K h H1 H2).
  - assert (D := cubic_derivative (det a) (det_linear a u) (det_linear u a) (det u) 0).
    apply (uniqueness_limite _ _ _ _ (det_derivative m d w 0)).
    replace (det_linear a u) with (det_linear a u + 2 * det_linear u a * 0 + 3 * det u * (0 * 0)) by ring.
    intros eps E. destruct (D eps E) as [delta K]. exists delta. intros h H1 H2.
    rewrite !field_move. fold a u. rewrite !det_line. exact (K h H1 H2).
Qed.

(* The derivative of the function, with x in the place of the root. *)
Definition level_slope mu m d x w := det_slope m d w - 3 / 2 * mu * x * norm_slope m d w.

Lemma level_derivative mu m d w t : field m (move w t d) <> zero ->
  derivable_pt_lim (fun t => level_value mu (field m (move w t d))) t
    (level_slope mu m d (root (field m (move w t d))) (move w t d)).
Proof.
  intros N. assert (P := norm2_positive _ N). assert (R := root_positive _ N).
  assert (E := root_squared (field m (move w t d))).
  assert (Dp := norm_derivative m d w t). assert (Dq := det_derivative m d w t).
  fold (norm_slope m d (move w t d)) in Dp. fold (det_slope m d (move w t d)) in Dq.
  set (p := fun t => norm2 (field m (move w t d))) in *.
  assert (Dh := derivable_pt_lim_scal p (/ 54) t _ Dp).
  assert (Pos : 0 < mult_real_fct (/ 54) p t) by (unfold mult_real_fct, p; lra).
  assert (Dr := derivable_pt_lim_comp _ _ _ _ _ Dh (derivable_pt_lim_sqrt _ Pos)).
  assert (D := derivable_pt_lim_minus _ _ _ _ _ Dq
    (derivable_pt_lim_scal _ mu _ _ (derivable_pt_lim_mult _ _ _ _ _ Dp Dr))).
  assert (Same : forall s, comp sqrt (mult_real_fct (/ 54) p) s = root (field m (move w s d))).
  { intros s. unfold comp, mult_real_fct, root, p. f_equal. unfold Rdiv. ring. }
  assert (Eq : sqrt (mult_real_fct (/ 54) p t) = root (field m (move w t d))) by apply Same.
  rewrite Eq, Same in D.
  replace (level_slope mu m d (root (field m (move w t d))) (move w t d)) with
    (det_slope m d (move w t d) - mu * (norm_slope m d (move w t d) * root (field m (move w t d))
      + p t * (/ (2 * root (field m (move w t d))) * (/ 54 * norm_slope m d (move w t d))))).
  - intros eps H. destruct (D eps H) as [delta K]. exists delta. intros h H1 H2.
    assert (L := K h H1 H2). unfold minus_fct, mult_fct, mult_real_fct in L.
    fold (mult_real_fct (/ 54) p) in L. rewrite !Same in L. exact L.
  - unfold level_slope. assert (Ep : p t = 54 * (root (field m (move w t d)) * root (field m (move w t d))))
      by (rewrite E; unfold p; field).
    rewrite Ep. field. lra.
Qed.

Lemma continuous_level mu m w : continuous_at (fun v => level_value mu (field m v)) w.
Proof.
  assert (P : continuous_at (fun v => norm2 (field m v)) w)
    by (apply (continuous_extensional (value (norm_form m))); [apply norm_form_value|apply continuous_value]).
  assert (Q : continuous_at (fun v => det (field m v)) w)
    by (apply (continuous_extensional (value (det_form m))); [apply det_form_value|apply continuous_value]).
  assert (R : continuous_at (fun v => root (field m v)) w).
  { apply (continuous_compose (fun v => norm2 (field m v) * / 54) sqrt).
    - apply continuity_pt_sqrt. assert (H := norm2_nonneg (field m w)). lra.
    - apply continuous_mult; [exact P|apply continuous_constant]. }
  apply (continuous_extensional (fun v => det (field m v) + - mu * (norm2 (field m v) * root (field m v)))).
  - intros v. unfold level_value. ring.
  - apply continuous_plus; [exact Q|]. apply continuous_mult; [apply continuous_constant|].
    apply continuous_mult; [exact P|exact R].
Qed.

(* The form of the checker: den dQ - (3/2) num s dP with a linear form s. *)
Definition rise_form num den m d s :=
  merge (multiple den (poly_derivative (det_form m) d)
    ++ real_mul (real_linear s) (multiple (- (3 / 2 * num)) (poly_derivative (norm_form m) d))).
Lemma rise_form_value num den m d s w : 0 < den ->
  real_value (rise_form num den m d s) w = den * level_slope (num / den) m d (real_sum s w) w.
Proof.
  intros D. unfold rise_form, level_slope.
  rewrite merge_value, real_append_value, real_mul_value, !multiple_value, real_linear_value.
  fold (norm_slope m d w) (det_slope m d w). field. lra.
Qed.

(* Where the slope is positive for two numbers, with the root between them, the field is not zero
   and the function increases. *)
Definition level_rises V m d mu := (forall w, in_cone V w -> field m w <> zero) /\
  increases_along V d (fun w => level_value mu (field m w)).

Lemma slope_between mu m d w x y z : x <= y <= z ->
  0 < level_slope mu m d x w -> 0 < level_slope mu m d z w -> 0 < level_slope mu m d y w.
Proof.
  unfold level_slope. intros [A B] X Z. set (k := 3 / 2 * mu * norm_slope m d w).
  replace (3 / 2 * mu * x * norm_slope m d w) with (k * x) in X by (unfold k; ring).
  replace (3 / 2 * mu * z * norm_slope m d w) with (k * z) in Z by (unfold k; ring).
  replace (3 / 2 * mu * y * norm_slope m d w) with (k * y) by (unfold k; ring).
  destruct (Rle_dec 0 k); nra.
Qed.
Lemma slope_at_zero mu m d x w : field m w = zero -> level_slope mu m d x w = 0.
Proof.
  intros Z. unfold level_slope. destruct (slopes m d w) as [P Q]. rewrite P, Q, Z.
  generalize (step m d). intros u. unfold det_linear. coordinates. field.
Qed.
Lemma rises_if_slopes V m d mu low up : (forall w, in_cone V w ->
    low w <= root (field m w) <= up w /\
    0 < level_slope mu m d (low w) w /\ 0 < level_slope mu m d (up w) w) ->
  level_rises V m d mu.
Proof.
  intros H. assert (N : forall w, in_cone V w -> field m w <> zero).
  { intros w C Z. destruct (H w C) as [_ [S _]]. rewrite slope_at_zero in S by exact Z. lra. }
  split; [exact N|]. intros w a b L A B.
  assert (Pos : forall t, a <= t <= b ->
    0 < level_slope mu m d (root (field m (move w t d))) (move w t d)).
  { intros t T. assert (K : in_cone V (move w t d)) by (apply (between_in_cone V w d a t b); assumption).
    destruct (H _ K) as [X [Y Z]]. apply (slope_between mu m d _ _ _ _ X Y Z). }
  apply (derivative_increases (fun t => level_value mu (field m (move w t d)))
    (fun t => level_slope mu m d (root (field m (move w t d))) (move w t d)) a b L).
  - intros t T. apply level_derivative, N. apply (between_in_cone V w d a t b); assumption.
  - intros t T. left. apply Pos, T.
  - intros t T. apply Pos. lra.
Qed.
