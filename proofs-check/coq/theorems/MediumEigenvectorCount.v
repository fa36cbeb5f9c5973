(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   Theorem 1, counted: for 0 < s <= 1 the tensors of the field with parameter s and medium
   eigenvector v are, up to positive multiples, none, one or two as the boundary function is
   negative, zero or positive, unless N vanishes on the plane across v; then there is one for each
   direction. Points at infinity are counted. The eigenvectors of the asymmetric tensor A(v) are the
   dominant directions of these tensors. *)
From TensorTopo Require Import Tensors Frames Mode MediumEigenvector.
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

(* N maps each vector across v to a multiple of v. *)
Definition vanishes_across N v := forall a b, dot a v = 0 -> dot b v = 0 -> form N a b = 0.

Lemma vanishes_in_frame N e v f : orthonormal e v f -> trace N = 0 ->
  form N e e = 0 -> form N e f = 0 -> form N f f = 0 -> vanishes_across N v.
Proof.
  intros O T A B C a b Va Vb. rewrite (resolve e v f a O), form_combine, Va.
  rewrite (form_sym N e b), (form_sym N f b), (resolve e v f b O), !form_combine, Vb.
  rewrite (form_sym N f e), A, B, C. ring.
Qed.

(* Equal dominant directions, equal tensors; and the other way round. *)
Definition multiples a b := exists k, 0 < k /\ a = scale k b.

Lemma of_parameter_multiple k s u v w : 0 < k ->
  multiples (of_parameter k s u v w) (of_parameter 1 s u v w).
Proof.
  intros K. exists k. split; [exact K|]. unfold of_parameter. rewrite scale_spectral.
  f_equal; ring.
Qed.
Lemma parallel_units x y x' y' : x * x + y * y = 1 -> x' * x' + y' * y' = 1 ->
  x * y' - y * x' = 0 -> (x' = x /\ y' = y) \/ (x' = - x /\ y' = - y).
Proof.
  intros A B C. set (c := x * x' + y * y').
  assert (D : c * c = 1).
  { transitivity ((x * x + y * y) * (x' * x' + y' * y') - (x * y' - y * x') * (x * y' - y * x'));
      [unfold c; ring|rewrite A, B, C; ring]. }
  assert (X : x' = c * x).
  { transitivity (x' * (x * x + y * y)); [rewrite A; ring|].
    transitivity (c * x - y * (x * y' - y * x')); [unfold c; ring|rewrite C; ring]. }
  assert (Y : y' = c * y).
  { transitivity (y' * (x * x + y * y)); [rewrite A; ring|].
    transitivity (c * y + x * (x * y' - y * x')); [unfold c; ring|rewrite C; ring]. }
  assert (E : (c - 1) * (c + 1) = 0) by lra.
  clearbody c. destruct (Rmult_integral _ _ E) as [F|F].
  - left. replace c with 1 in X, Y by lra. lra.
  - right. replace c with (-1) in X, Y by lra. lra.
Qed.
Lemma same_tensor k s x y x' y' e v f :
  (x' = x /\ y' = y) \/ (x' = - x /\ y' = - y) ->
  of_parameter k s (dominant x' y' e v f) v (across x' y' e v f)
  = of_parameter k s (dominant x y e v f) v (across x y e v f).
Proof.
  intros [[A B]|[A B]]; rewrite A, B; [reflexivity|].
  unfold of_parameter, spectral, dominant, across, combine.
  generalize (k * (3 + s)) (k * (-2 * s)) (k * (s - 3)). intros p q r.
  f_equal; [tensor_ring|f_equal; tensor_ring].
Qed.

(* The dominant direction is the major eigenvector, so it is the same for multiples. *)
Lemma other_tensor s x y x' y' e v f k : orthonormal e v f -> 0 < s <= 1 ->
  x * x + y * y = 1 -> x' * x' + y' * y' = 1 -> 0 < k ->
  of_parameter 1 s (dominant x y e v f) v (across x y e v f)
  = scale k (of_parameter 1 s (dominant x' y' e v f) v (across x' y' e v f)) ->
  x * y' - y * x' = 0.
Proof.
  intros O S A B K E.
  assert (P := turned_orthonormal x y e v f O A). assert (Q := turned_orthonormal x' y' e v f O B).
  assert (K1 : k = 1).
  { assert (H := f_equal norm2 E). rewrite norm2_scale, !of_parameter_norm2 in H by assumption.
    assert (Z := square_nonneg s). assert ((1 - k) * (1 + k) * (6 * (3 + s * s)) = 0) by lra.
    destruct (Rmult_integral _ _ H0) as [H1|H1]; [|lra]. destruct (Rmult_integral _ _ H1); lra. }
  subst k. rewrite scale_one in E.
  assert (F := f_equal (fun t => form t (dominant x' y' e v f) (dominant x' y' e v f)) E).
  cbv beta in F. unfold of_parameter in F. rewrite !form_spectral in F.
  rewrite (unit_1 _ _ _ Q), (dot_sym _ (dominant x' y' e v f)), (dot_sym (across x' y' e v f)),
    (perp_13 _ _ _ Q), (dot_sym v (dominant x' y' e v f)), (perp_12 _ _ _ Q) in F.
  assert (D1 : dot (dominant x' y' e v f) (dominant x y e v f) = x' * x + y' * y).
  { unfold dominant. destruct O as [O1 O2 O3 O4 O5 O6].
    rewrite dot_combine, !(dot_sym _ (combine _ _ _ _ _ _)), !dot_combine, O1, O3, O4, (dot_sym f v), O5, (dot_sym f e), O6. ring. }
  assert (D2 : dot (across x y e v f) (dominant x' y' e v f) = x * y' - y * x').
  { unfold dominant, across. destruct O as [O1 O2 O3 O4 O5 O6].
    rewrite dot_combine, !(dot_sym _ (combine _ _ _ _ _ _)), !dot_combine, O1, O3, O4, (dot_sym f v), O5, (dot_sym f e), O6. ring. }
  rewrite D1, D2 in F. apply square_zero.
  assert (L : (x' * x + y' * y) * (x' * x + y' * y) + (x * y' - y * x') * (x * y' - y * x') = 1).
  { transitivity ((x * x + y * y) * (x' * x' + y' * y')); [ring|rewrite A, B; ring]. }
  set (g := (x * y' - y * x') * (x * y' - y * x')) in *.
  set (h := (x' * x + y' * y) * (x' * x + y' * y)) in *. replace h with (1 - g) in F by lra. lra.
Qed.

Theorem none_if_negative N s v : trace N = 0 -> dot v v = 1 -> 0 < s <= 1 ->
  boundary_function N s v < 0 -> forall t, ~ has_medium N s v t.
Proof.
  intros T V S B t H. apply has_medium_iff in H; [|lra]. destruct H as [k [u [w [K [O [E I]]]]]].
  assert (F := boundary_in_frame N s u v w O T).
  assert (C := orthogonality_inner N s k 1 0 u v w O T ltac:(ring)).
  replace (dominant 1 0 u v w) with u in C by (unfold dominant, combine; vector_ring).
  replace (across 1 0 u v w) with w in C by (unfold across, combine; vector_ring).
  rewrite <- E, I in C. symmetry in C.
  destruct (Rmult_integral _ _ C) as [X|X]; [lra|].
  destruct (binary_no_root (coef_ee N s u w) (coef_ef N u w) (coef_ff N s u w) 1 0); [lra|exact X|lra].
Qed.

Section Counts.
Variables (N : tensor) (s : R) (v : vector).
Hypothesis T : trace N = 0.
Hypothesis V : dot v v = 1.
Hypothesis S : 0 < s <= 1.

Lemma frame_across : exists e f, orthonormal e v f.
Proof. destruct (frame_from_unit v V) as [f [e O]]. exists e, f. permuted_frame O. Qed.

Lemma admissible e f x y : orthonormal e v f -> x * x + y * y = 1 ->
  orthogonality N s e f x y = 0 ->
  has_medium N s v (of_parameter 1 s (dominant x y e v f) v (across x y e v f)).
Proof.
  intros O H Z. apply has_medium_iff; [lra|]. exists 1, (dominant x y e v f), (across x y e v f).
  split; [lra|]. split; [apply turned_orthonormal; assumption|]. split; [reflexivity|].
  rewrite (orthogonality_inner N s 1 x y e v f O T H), Z. ring.
Qed.
Lemma all_admissible e f t : orthonormal e v f -> has_medium N s v t -> exists x y,
  x * x + y * y = 1 /\ orthogonality N s e f x y = 0 /\
  multiples t (of_parameter 1 s (dominant x y e v f) v (across x y e v f)).
Proof.
  intros O H. apply has_medium_iff in H; [|lra]. destruct H as [k [u [w [K [P [E I]]]]]].
  destruct (from_direction k s u v w e f O P) as [x [y [U F]]]. exists x, y.
  split; [exact U|]. split.
  - rewrite E, F, (orthogonality_inner N s k x y e v f O T U) in I.
    destruct (Rmult_integral _ _ I); [lra|assumption].
  - rewrite E, F. apply of_parameter_multiple, K.
Qed.
Lemma vanishes_iff e f : orthonormal e v f ->
  coef_ee N s e f = 0 -> coef_ef N e f = 0 -> coef_ff N s e f = 0 -> vanishes_across N v.
Proof.
  unfold coef_ee, coef_ef, coef_ff. intros O A B C.
  assert (X : s * (form N e e + form N f f) = 0) by lra.
  assert (Y : form N e e - form N f f = 0) by lra.
  destruct (Rmult_integral _ _ X) as [Z|Z]; [lra|]. apply (vanishes_in_frame N e v f); auto; lra.
Qed.

Theorem one_on_boundary : boundary_function N s v = 0 -> ~ vanishes_across N v ->
  exists t, has_medium N s v t /\ forall t', has_medium N s v t' -> multiples t' t.
Proof.
  intros B W. destruct frame_across as [e [f O]]. assert (D := boundary_in_frame N s e v f O T).
  destruct (binary_one_root (coef_ee N s e f) (coef_ef N e f) (coef_ff N s e f)) as [x0 [y0 [X [Z U]]]].
  - lra.
  - destruct (Req_dec (coef_ee N s e f) 0); [|auto]. destruct (Req_dec (coef_ef N e f) 0); [|auto].
    destruct (Req_dec (coef_ff N s e f) 0); [|auto]. destruct W. apply (vanishes_iff e f); assumption.
  - destruct (unit_root _ _ _ x0 y0 X Z) as [x [y [k [Kx [Ky [K [Un Z']]]]]]].
    exists (of_parameter 1 s (dominant x y e v f) v (across x y e v f)).
    split; [apply admissible; assumption|]. intros t' H.
    destruct (all_admissible e f t' O H) as [x' [y' [Un' [Or M]]]].
    rewrite <- (same_tensor 1 s x y x' y'); [exact M|]. apply parallel_units; auto.
    assert (P := U x' y' Or). rewrite Kx, Ky. transitivity (- k * (x' * y0 - y' * x0)); [ring|rewrite P; ring].
Qed.

Theorem two_inside : 0 < boundary_function N s v -> exists t1 t2,
  has_medium N s v t1 /\ has_medium N s v t2 /\ ~ multiples t1 t2 /\
  forall t', has_medium N s v t' -> multiples t' t1 \/ multiples t' t2.
Proof.
  intros B. destruct frame_across as [e [f O]]. assert (D := boundary_in_frame N s e v f O T).
  destruct (binary_two_roots (coef_ee N s e f) (coef_ef N e f) (coef_ff N s e f))
    as [x1 [y1 [x2 [y2 [Z1 [Z2 [I U]]]]]]]; [lra|].
  assert (X1 : x1 <> 0 \/ y1 <> 0).
  { destruct (Req_dec x1 0) as [A|A]; [|auto]. destruct (Req_dec y1 0) as [A'|A']; [|auto].
    destruct I. rewrite A, A'. ring. }
  assert (X2 : x2 <> 0 \/ y2 <> 0).
  { destruct (Req_dec x2 0) as [A|A]; [|auto]. destruct (Req_dec y2 0) as [A'|A']; [|auto].
    destruct I. rewrite A, A'. ring. }
  destruct (unit_root _ _ _ x1 y1 X1 Z1) as [u1 [w1 [k1 [Kx1 [Ky1 [K1 [Un1 Q1]]]]]]].
  destruct (unit_root _ _ _ x2 y2 X2 Z2) as [u2 [w2 [k2 [Kx2 [Ky2 [K2 [Un2 Q2]]]]]]].
  exists (of_parameter 1 s (dominant u1 w1 e v f) v (across u1 w1 e v f)),
    (of_parameter 1 s (dominant u2 w2 e v f) v (across u2 w2 e v f)).
  split; [apply admissible; assumption|]. split; [apply admissible; assumption|]. split.
  - intros [k [K E]]. assert (H := other_tensor s u1 w1 u2 w2 e v f k O S Un1 Un2 K E).
    apply I. assert (F : k1 * (k2 * (x1 * y2 - y1 * x2)) = 0).
    { rewrite <- H, Kx1, Ky1, Kx2, Ky2. ring. }
    destruct (Rmult_integral _ _ F); [contradiction|]. destruct (Rmult_integral _ _ H0); [contradiction|assumption].
  - intros t' H. destruct (all_admissible e f t' O H) as [x' [y' [Un' [Or M]]]].
    destruct (U x' y' Or) as [P|P]; [left|right].
    + rewrite <- (same_tensor 1 s u1 w1 x' y'); [exact M|]. apply parallel_units; auto.
      rewrite Kx1, Ky1. transitivity (- k1 * (x' * y1 - y' * x1)); [ring|rewrite P; ring].
    + rewrite <- (same_tensor 1 s u2 w2 x' y'); [exact M|]. apply parallel_units; auto.
      rewrite Kx2, Ky2. transitivity (- k2 * (x' * y2 - y' * x2)); [ring|rewrite P; ring].
Qed.

Theorem all_if_vanishing : vanishes_across N v -> forall d, dot d d = 1 -> dot d v = 0 ->
  has_medium N s v (of_parameter 1 s d v (cross d v)).
Proof.
  intros W d D P. assert (O := frame_from_pair d v D V P).
  apply has_medium_iff; [lra|]. exists 1, d, (cross d v). split; [lra|]. split; [exact O|].
  split; [reflexivity|]. unfold of_parameter. rewrite inner_sym, inner_spectral.
  assert (A : form N d d = 0) by (apply W; exact P).
  assert (C : dot (cross d v) v = 0) by (rewrite dot_sym; apply (perp_23 _ _ _ O)).
  assert (B : form N (cross d v) (cross d v) = 0) by (apply W; exact C).
  rewrite <- (trace_in_frame d v (cross d v) N O) in T. unfold trace, in_frame in T. cbn in T.
  rewrite A, B in *. replace (form N v v) with 0 by lra. ring.
Qed.
End Counts.

(* A(v) = R(theta/2 + pi/4) T' R(theta/2 - pi/4), T' = [[p, q], [q, r]] the tensor N on the plane
   across v: (x, y) is an eigenvector of A exactly if it is a dominant direction for s = sin(theta). *)
Theorem eigenvectors_of_asymmetric_tensor p q r theta x y :
  let a := theta / 2 + PI / 4 in let b := theta / 2 - PI / 4 in
  let u := cos b * x - sin b * y in let w := sin b * x + cos b * y in
  let u' := p * u + q * w in let w' := q * u + r * w in
  let ax := cos a * u' - sin a * w' in let ay := sin a * u' + cos a * w' in
  let s := sin theta in
  x * ay - y * ax = 0 <->
  ((1 + s) * p - (1 - s) * r) * (x * x) + 4 * q * (x * y) + ((1 + s) * r - (1 - s) * p) * (y * y) = 0.
Proof.
  intros a b u w u' w' ax ay s.
  set (C := cos (theta / 2)). set (D := sin (theta / 2)).
  assert (One : C * C + D * D = 1).
  { assert (H := sin2_cos2 (theta / 2)). unfold Rsqr in H. unfold C, D. lra. }
  assert (Th : s = 2 * D * C).
  { unfold s. replace theta with (2 * (theta / 2)) by field. rewrite sin_2a. reflexivity. }
  set (h := / sqrt 2).
  assert (Hh : h * h = / 2).
  { unfold h. rewrite <- Rinv_mult. f_equal. apply sqrt_sqrt. lra. }
  assert (C4 : cos (PI / 4) = h) by (rewrite cos_PI4; unfold h; field; apply Rgt_not_eq, sqrt_lt_R0; lra).
  assert (S4 : sin (PI / 4) = h) by (rewrite sin_PI4; unfold h; field; apply Rgt_not_eq, sqrt_lt_R0; lra).
  assert (Ca : cos a = h * (C - D)) by (unfold a; rewrite cos_plus, C4, S4; fold C D; ring).
  assert (Sa : sin a = h * (C + D)) by (unfold a; rewrite sin_plus, C4, S4; fold C D; ring).
  assert (Cb : cos b = h * (C + D)) by (unfold b; rewrite cos_minus, C4, S4; fold C D; ring).
  assert (Sb : sin b = h * (D - C)) by (unfold b; rewrite sin_minus, C4, S4; fold C D; ring).
  assert (E : 2 * (x * ay - y * ax) =
    ((1 + s) * p - (1 - s) * r) * (x * x) + 4 * q * (x * y) + ((1 + s) * r - (1 - s) * p) * (y * y)).
  { unfold ax, ay, u', w', u, w. rewrite Ca, Sa, Cb, Sb, Th.
    replace 1 with (C * C + D * D) at 1 2 3 4 by exact One.
    transitivity (2 * (h * h) * (((C * C + D * D + 2 * D * C) * p - (C * C + D * D - 2 * D * C) * r) * (x * x)
      + 4 * (C * C + D * D) * q * (x * y)
      + ((C * C + D * D + 2 * D * C) * r - (C * C + D * D - 2 * D * C) * p) * (y * y))); [ring|].
    rewrite Hh, One. field. }
  rewrite <- E. split; intros H; lra.
Qed.
