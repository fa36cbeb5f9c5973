(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   The tensors of a field, those orthogonal to its characteristic tensor N, that have a given medium
   eigenvector v and a given parameter s. In a frame e, v, f they are known by their dominant
   direction x e + y f, and orthogonality to N is a quadratic equation for x : y. *)
From TensorTopo Require Import Tensors Frames Mode.
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

(* The boundary function of Theorem 2; N need not have the norm 1. *)
Definition boundary_function N s v :=
  norm2 N / 2 - dot (apply N v) (apply N v) + (1 - s * s) * (form N v v * form N v v) / 4.

(* t is in the field, has the parameter s (so the mode that belongs to s), and v as medium
   eigenvector. *)
Definition has_medium N s v t :=
  inner N t = 0 /\ t <> zero /\ trace t = 0 /\ mode t = parameter_mode s /\ medium_eigenvector v t.

Lemma of_parameter_trace k s u v w : orthonormal u v w -> trace (of_parameter k s u v w) = 0.
Proof. intros O. unfold of_parameter. rewrite trace_spectral by exact O. ring. Qed.
Lemma of_parameter_norm2 k s u v w : orthonormal u v w ->
  norm2 (of_parameter k s u v w) = k * k * (6 * (3 + s * s)).
Proof. intros O. unfold of_parameter. rewrite norm2_spectral by exact O. ring. Qed.
Lemma of_parameter_not_zero k s u v w : 0 < k -> orthonormal u v w -> of_parameter k s u v w <> zero.
Proof.
  intros K O Z. assert (H := of_parameter_norm2 k s u v w O). rewrite Z in H.
  assert (S := square_nonneg s). assert (0 < k * k) by (apply square_pos; lra).
  assert (0 < k * k * (6 * (3 + s * s))) by (apply Rmult_lt_0_compat; lra).
  unfold norm2, inner, zero in H. cbn in H. lra.
Qed.
Lemma of_parameter_medium k s u v w : 0 < k -> -1 <= s <= 1 -> orthonormal u v w ->
  medium_eigenvector v (of_parameter k s u v w).
Proof.
  intros K S O. exists (k * (3 + s)), (k * (-2 * s)), (k * (s - 3)), u, w.
  split; [nra|]. split; [nra|]. split; [exact O|reflexivity].
Qed.

Lemma has_medium_iff N s v t : -1 <= s <= 1 -> has_medium N s v t <->
  exists k u w, 0 < k /\ orthonormal u v w /\ t = of_parameter k s u v w /\ inner N t = 0.
Proof.
  intros S. split.
  - intros [I [Z [T [M E]]]]. destruct (parameter_of_tensor t v Z T E) as [k [s' [u [w [K [S' [O F]]]]]]].
    assert (s' = s).
    { apply parameter_mode_injective; auto. rewrite <- M, F. symmetry. apply mode_of_parameter; auto. }
    subst s'. exists k, u, w. auto.
  - intros [k [u [w [K [O [E I]]]]]]. split; [exact I|]. rewrite E. repeat split.
    + apply of_parameter_not_zero; assumption.
    + apply of_parameter_trace, O.
    + apply mode_of_parameter; assumption.
    + apply of_parameter_medium; assumption.
Qed.

(* Orthogonality to N, for the dominant direction x e + y f: twice the form has the coefficients
   coef_ee, coef_ef, coef_ff, and the boundary function is its discriminant. *)
Section InFrame.
Variables (N : tensor) (s : R) (e v f : vector).
Definition coef_ee := 3 * ((1 + s) * form N e e - (1 - s) * form N f f).
Definition coef_ef := 6 * form N e f.
Definition coef_ff := 3 * ((1 + s) * form N f f - (1 - s) * form N e e).
Definition orthogonality x y := coef_ee * (x * x) + 2 * coef_ef * (x * y) + coef_ff * (y * y).
End InFrame.

Lemma boundary_in_frame N s e v f : orthonormal e v f -> trace N = 0 ->
  36 * boundary_function N s v = coef_ef N e f * coef_ef N e f - coef_ee N s e f * coef_ff N s e f.
Proof.
  intros O T. unfold boundary_function.
  rewrite <- (norm2_in_frame e v f N O), (dot_resolved e v f _ _ O).
  assert (A : form N v v = - form N e e - form N f f).
  { rewrite <- (trace_in_frame e v f N O) in T. unfold trace, in_frame in T. cbn in T. lra. }
  rewrite !(dot_sym (apply N v)). fold (form N e v) (form N v v) (form N f v).
  rewrite (form_sym N f v), A.
  unfold norm2, inner, in_frame, coef_ee, coef_ef, coef_ff. cbn [xx yy zz xy yz xz]. rewrite A. field.
Qed.

(* d = x e + y f, and w across it. *)
Definition dominant x y e v f := combine x 0 y e v f.
Definition across x y e v f := combine (- y) 0 x e v f.
Lemma turned_orthonormal x y e v f : orthonormal e v f -> x * x + y * y = 1 ->
  orthonormal (dominant x y e v f) v (across x y e v f).
Proof.
  intros O H. unfold dominant, across. destruct O as [A B C D E F].
  constructor; rewrite ?dot_combine; rewrite ?(dot_sym _ (combine _ _ _ _ _ _)), ?dot_combine;
  rewrite ?(dot_sym v e), ?(dot_sym f v), ?(dot_sym f e), ?A, ?B, ?C, ?D, ?E, ?F; try lra.
Qed.
Lemma orthogonality_inner N s k x y e v f : orthonormal e v f -> trace N = 0 -> x * x + y * y = 1 ->
  inner N (of_parameter k s (dominant x y e v f) v (across x y e v f)) = k * orthogonality N s e f x y.
Proof.
  intros O T H. rewrite inner_sym. unfold of_parameter. rewrite inner_spectral.
  unfold dominant, across. rewrite !form_combine, !(form_sym N _ (combine _ _ _ _ _ _)), !form_combine.
  assert (A : form N v v = - form N e e - form N f f).
  { rewrite <- (trace_in_frame e v f N O) in T. unfold trace, in_frame in T. cbn in T. lra. }
  rewrite A, (form_sym N f e). unfold orthogonality, coef_ee, coef_ef, coef_ff.
  transitivity (k * ((3 + s) * (form N e e * (x * x) + 2 * form N e f * (x * y) + form N f f * (y * y))
    + 2 * s * (form N e e + form N f f) * (x * x + y * y)
    + (s - 3) * (form N e e * (y * y) - 2 * form N e f * (x * y) + form N f f * (x * x)))).
  - rewrite H. ring.
  - ring.
Qed.

(* All such tensors come from a dominant direction in the plane of e and f. *)
Lemma from_direction k s u v w e f : orthonormal e v f -> orthonormal u v w -> exists x y,
  x * x + y * y = 1 /\ of_parameter k s u v w = of_parameter k s (dominant x y e v f) v (across x y e v f).
Proof.
  intros O P. exists (dot u e), (dot u f).
  assert (H : dot u e * dot u e + dot u f * dot u f = 1).
  { assert (U := unit_1 _ _ _ P). rewrite (dot_resolved e v f u u O), (perp_12 _ _ _ P) in U. lra. }
  split; [exact H|].
  assert (U : u = dominant (dot u e) (dot u f) e v f).
  { unfold dominant. rewrite (resolve e v f u O) at 1. rewrite (perp_12 _ _ _ P). reflexivity. }
  assert (Q := turned_orthonormal _ _ _ _ _ O H). rewrite <- U in Q |- *.
  set (w' := across (dot u e) (dot u f) e v f) in *.
  (* w and w' are the same up to their sign *)
  assert (W : w = scale_vector (dot w w') w').
  { rewrite (resolve u v w' w Q) at 1. rewrite (dot_sym w u), (dot_sym w v), (perp_13 _ _ _ P), (perp_23 _ _ _ P).
    unfold combine. vector_ring. }
  assert (S : dot w w' * dot w w' = 1).
  { assert (V := unit_3 _ _ _ P). rewrite W in V.
    transitivity (dot w w' * dot w w' * dot w' w'); [rewrite (unit_3 _ _ _ Q); ring|].
    rewrite <- V. generalize (dot w w'). intros c. clear. coordinates. ring. }
  unfold of_parameter, spectral. f_equal. f_equal. f_equal.
  rewrite W at 1. transitivity (scale (dot w w' * dot w w') (dyad w')).
  - generalize (dot w w'). intros c. clear. tensor_ring.
  - rewrite S. apply scale_one.
Qed.

(* The roots x : y of a binary quadratic form. *)
Definition binary a b c x y := a * (x * x) + 2 * b * (x * y) + c * (y * y).

Lemma binary_no_root a b c x y : b * b - a * c < 0 -> binary a b c x y = 0 -> x = 0 /\ y = 0.
Proof.
  unfold binary. intros D Z.
  assert (I : (a * x + b * y) * (a * x + b * y) = (b * b - a * c) * (y * y)).
  { transitivity (a * (a * (x * x) + 2 * b * (x * y) + c * (y * y)) + (b * b - a * c) * (y * y));
      [ring|rewrite Z; ring]. }
  assert (J : (c * y + b * x) * (c * y + b * x) = (b * b - a * c) * (x * x)).
  { transitivity (c * (a * (x * x) + 2 * b * (x * y) + c * (y * y)) + (b * b - a * c) * (x * x));
      [ring|rewrite Z; ring]. }
  assert (K1 := square_nonneg (a * x + b * y)). assert (K2 := square_nonneg (c * y + b * x)).
  split; [destruct (Req_dec x 0) as [X|X]|destruct (Req_dec y 0) as [X|X]]; auto; exfalso;
    assert (Q := square_pos _ X).
  - assert (0 < - (b * b - a * c) * (x * x)) by (apply Rmult_lt_0_compat; lra). lra.
  - assert (0 < - (b * b - a * c) * (y * y)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
Lemma binary_one_root a b c : b * b - a * c = 0 -> a <> 0 \/ b <> 0 \/ c <> 0 ->
  exists x0 y0, (x0 <> 0 \/ y0 <> 0) /\ binary a b c x0 y0 = 0 /\
    forall x y, binary a b c x y = 0 -> x * y0 - y * x0 = 0.
Proof.
  unfold binary. intros D N. destruct (Req_dec a 0) as [A|A].
  - assert (B : b = 0) by (apply square_zero; rewrite A in D; lra).
    assert (C : c <> 0) by (destruct N as [N|[N|N]]; [contradiction|contradiction|exact N]).
    exists 1, 0. split; [left; lra|]. rewrite A, B. split; [ring|]. intros x y Z.
    assert (E : c * (y * y) = 0) by lra. destruct (Rmult_integral _ _ E) as [|E']; [contradiction|].
    rewrite (square_zero _ E'). ring.
  - exists (- b), a. split; [right; exact A|]. split; [transitivity (- a * (b * b - a * c)); [ring|rewrite D; ring]|].
    intros x y Z. apply square_zero.
    transitivity (a * (a * (x * x) + 2 * b * (x * y) + c * (y * y)) + (b * b - a * c) * (y * y));
      [ring|rewrite Z, D; ring].
Qed.
Lemma binary_two_roots a b c : 0 < b * b - a * c ->
  exists x1 y1 x2 y2, binary a b c x1 y1 = 0 /\ binary a b c x2 y2 = 0 /\ x1 * y2 - y1 * x2 <> 0 /\
    forall x y, binary a b c x y = 0 -> x * y1 - y * x1 = 0 \/ x * y2 - y * x2 = 0.
Proof.
  unfold binary. intros D. destruct (Req_dec a 0) as [A|A].
  - assert (B : b <> 0) by (intros B; subst; lra).
    exists 1, 0, (- c), (2 * b). rewrite A. split; [ring|]. split; [ring|]. split; [lra|]. intros x y Z.
    assert (E : y * (2 * b * x + c * y) = 0) by (rewrite <- Z; ring).
    destruct (Rmult_integral _ _ E); [left|right]; lra.
  - set (h := sqrt (b * b - a * c)).
    assert (H : h * h = b * b - a * c) by (apply sqrt_sqrt; lra).
    assert (P : 0 < h) by (apply sqrt_lt_R0; exact D).
    exists (- b + h), a, (- b - h), a.
    split; [transitivity (a * (h * h - (b * b - a * c))); [ring|rewrite H; ring]|].
    split; [transitivity (a * (h * h - (b * b - a * c))); [ring|rewrite H; ring]|].
    split.
    + replace (_ - _) with (2 * (h * a)) by ring. apply Rmult_integral_contrapositive_currified; [lra|].
      apply Rmult_integral_contrapositive_currified; lra.
    + intros x y Z. assert (E : (x * a - y * (- b + h)) * (x * a - y * (- b - h)) = 0).
      { transitivity (a * (a * (x * x) + 2 * b * (x * y) + c * (y * y))
          + (b * b - a * c - h * h) * (y * y)); [ring|rewrite Z, H; ring]. }
      destruct (Rmult_integral _ _ E); [left|right]; assumption.
Qed.
Lemma unit_root a b c x y : (x <> 0 \/ y <> 0) -> binary a b c x y = 0 ->
  exists x' y' k, x' = k * x /\ y' = k * y /\ k <> 0 /\ x' * x' + y' * y' = 1 /\ binary a b c x' y' = 0.
Proof.
  intros N Z. assert (P : 0 < x * x + y * y).
  { assert (X := square_nonneg x). assert (Y := square_nonneg y).
    destruct N as [N|N]; assert (S := square_pos _ N); lra. }
  set (r := sqrt (x * x + y * y)). assert (R : 0 < r) by (apply sqrt_lt_R0; exact P).
  assert (RR : r * r = x * x + y * y) by (apply sqrt_sqrt; lra).
  exists (/ r * x), (/ r * y), (/ r). repeat split.
  - apply Rinv_neq_0_compat. lra.
  - transitivity (/ r * / r * (x * x + y * y)); [ring|rewrite <- RR; field; lra].
  - unfold binary in *. transitivity (/ r * / r * (a * (x * x) + 2 * b * (x * y) + c * (y * y)));
      [ring|rewrite Z; ring].
Qed.
