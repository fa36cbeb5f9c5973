(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   Orthonormal frames, tensors by eigenvalues and eigenvectors, and tensors as seen in a frame. *)
From TensorTopo Require Import Tensors.
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

Record orthonormal (u v w : vector) : Prop := {
  unit_1 : dot u u = 1; unit_2 : dot v v = 1; unit_3 : dot w w = 1;
  perp_12 : dot u v = 0; perp_23 : dot v w = 0; perp_13 : dot u w = 0 }.

Lemma dot_sym a b : dot a b = dot b a.
Proof. unfold dot; ring. Qed.

Lemma orthonormal_rotate u v w : orthonormal u v w -> orthonormal v w u.
Proof. intros [A B C D E F]. constructor; auto; rewrite dot_sym; auto. Qed.
Lemma orthonormal_swap u v w : orthonormal u v w -> orthonormal v u w.
Proof. intros [A B C D E F]. constructor; auto; rewrite dot_sym; auto. Qed.

Ltac permuted_frame O := constructor; try apply O; rewrite dot_sym; apply O.

Lemma axes_orthonormal : orthonormal (Vector 1 0 0) (Vector 0 1 0) (Vector 0 0 1).
Proof. constructor; unfold dot; cbn; ring. Qed.

(* The square of the volume is the determinant of the inner products, so 1. *)
Lemma volume_squared u v w : orthonormal u v w -> volume u v w * volume u v w = 1.
Proof.
  intros [A B C D E F].
  transitivity (dot u u * (dot v v * dot w w - dot v w * dot v w)
    - dot u v * (dot u v * dot w w - dot v w * dot u w)
    + dot u w * (dot u v * dot v w - dot v v * dot u w)).
  - coordinates; ring.
  - rewrite A, B, C, D, E, F. ring.
Qed.

(* A vector that is perpendicular to all three of a frame is zero. *)
Lemma perpendicular_to_frame u v w y : orthonormal u v w ->
  dot y u = 0 -> dot y v = 0 -> dot y w = 0 -> y = zero_vector.
Proof.
  intros O A B C. assert (V := volume_squared u v w O).
  assert (E : forall f : vector -> R, f (add_vectors (scale_vector (dot y u) (cross v w))
      (add_vectors (scale_vector (dot y v) (cross w u)) (scale_vector (dot y w) (cross u v))))
    = f (scale_vector (volume u v w) y)).
  { intros f. f_equal. vector_ring. }
  rewrite A, B, C in E.
  assert (K : volume u v w <> 0) by (intros Z; rewrite Z in V; lra).
  assert (X := E vx). assert (Y := E vy). assert (Z := E vz).
  cbn in X, Y, Z. rewrite !Rmult_0_l, !Rplus_0_l in X, Y, Z.
  apply vector_eq; cbn.
  - destruct (Rmult_integral _ _ (eq_sym X)); [contradiction|assumption].
  - destruct (Rmult_integral _ _ (eq_sym Y)); [contradiction|assumption].
  - destruct (Rmult_integral _ _ (eq_sym Z)); [contradiction|assumption].
Qed.

(* Every vector is the sum of its parts along a frame. *)
Definition combine a b c u v w :=
  add_vectors (scale_vector a u) (add_vectors (scale_vector b v) (scale_vector c w)).

Lemma dot_combine a b c u v w y :
  dot (combine a b c u v w) y = a * dot u y + b * dot v y + c * dot w y.
Proof. unfold combine; coordinates; ring. Qed.

Lemma resolve u v w y : orthonormal u v w ->
  y = combine (dot y u) (dot y v) (dot y w) u v w.
Proof.
  intros O. assert (O' := O). destruct O' as [A B C D E F].
  set (z := add_vectors y (scale_vector (-1) (combine (dot y u) (dot y v) (dot y w) u v w))).
  assert (Z : z = zero_vector).
  { assert (S : forall t, dot z t = dot y t - dot (combine (dot y u) (dot y v) (dot y w) u v w) t)
      by (intros; unfold z; generalize (combine (dot y u) (dot y v) (dot y w) u v w); intros; coordinates; ring).
    apply (perpendicular_to_frame u v w); auto; rewrite S, dot_combine;
      rewrite ?(dot_sym v u), ?(dot_sym w v), ?(dot_sym w u), ?A, ?B, ?C, ?D, ?E, ?F; ring. }
  assert (X := f_equal vx Z). assert (Y := f_equal vy Z). assert (W := f_equal vz Z).
  unfold z in X, Y, W. cbn [add_vectors scale_vector zero_vector vx vy vz] in X, Y, W.
  apply vector_eq; lra.
Qed.

Lemma dot_resolved u v w a b : orthonormal u v w ->
  dot a b = dot a u * dot b u + dot a v * dot b v + dot a w * dot b w.
Proof.
  intros O. rewrite (resolve u v w a O) at 1. rewrite dot_combine.
  rewrite (dot_sym u b), (dot_sym v b), (dot_sym w b). ring.
Qed.

(* The tensor of eigenvalues l1, l2, l3 on u, v, w. *)
Definition spectral l1 l2 l3 u v w :=
  add (scale l1 (dyad u)) (add (scale l2 (dyad v)) (scale l3 (dyad w))).

Lemma inner_dyad t v : inner (dyad v) t = form t v v.
Proof. coordinates; ring. Qed.
Lemma inner_spectral l1 l2 l3 u v w t :
  inner (spectral l1 l2 l3 u v w) t = l1 * form t u u + l2 * form t v v + l3 * form t w w.
Proof. unfold spectral. rewrite !inner_add, !inner_scale, !inner_dyad. ring. Qed.
Lemma form_add s t a b : form (add s t) a b = form s a b + form t a b.
Proof. coordinates; ring. Qed.
Lemma form_scale k t a b : form (scale k t) a b = k * form t a b.
Proof. coordinates; ring. Qed.
Lemma form_dyad u a b : form (dyad u) a b = dot u a * dot u b.
Proof. coordinates; ring. Qed.
Lemma form_sym_dyad u v a b :
  form (sym_dyad u v) a b = dot u a * dot v b + dot v a * dot u b.
Proof. coordinates; ring. Qed.
Lemma form_spectral l1 l2 l3 u v w x y : form (spectral l1 l2 l3 u v w) x y
  = l1 * (dot u x * dot u y) + l2 * (dot v x * dot v y) + l3 * (dot w x * dot w y).
Proof. unfold spectral. rewrite !form_add, !form_scale, !form_dyad. ring. Qed.
Lemma trace_dyad u : trace (dyad u) = dot u u.
Proof. coordinates; ring. Qed.
Lemma trace_sym_dyad u v : trace (sym_dyad u v) = 2 * dot u v.
Proof. coordinates; ring. Qed.

Lemma trace_spectral l1 l2 l3 u v w : orthonormal u v w ->
  trace (spectral l1 l2 l3 u v w) = l1 + l2 + l3.
Proof.
  intros [A B C D E F].
  unfold spectral. rewrite !trace_add, !trace_scale, !trace_dyad, A, B, C. ring.
Qed.
Lemma norm2_spectral l1 l2 l3 u v w : orthonormal u v w ->
  norm2 (spectral l1 l2 l3 u v w) = l1 * l1 + l2 * l2 + l3 * l3.
Proof.
  intros [A B C D E F].
  unfold norm2. rewrite inner_spectral, !form_spectral.
  rewrite ?(dot_sym v u), ?(dot_sym w v), ?(dot_sym w u), ?A, ?B, ?C, ?D, ?E, ?F. ring.
Qed.
Lemma scale_spectral k l1 l2 l3 u v w :
  scale k (spectral l1 l2 l3 u v w) = spectral (k * l1) (k * l2) (k * l3) u v w.
Proof. unfold spectral. tensor_ring. Qed.
Lemma spectral_rotate l1 l2 l3 u v w : spectral l1 l2 l3 u v w = spectral l2 l3 l1 v w u.
Proof. unfold spectral. tensor_ring. Qed.
Lemma spectral_swap l1 l2 l3 u v w : spectral l1 l2 l3 u v w = spectral l2 l1 l3 v u w.
Proof. unfold spectral. tensor_ring. Qed.

(* The numbers of a tensor in a frame, and the way back. *)
Definition in_frame u v w t :=
  Tensor (form t u u) (form t v v) (form t w w) (form t u v) (form t v w) (form t u w).
Definition from_frame u v w s :=
  add (spectral (xx s) (yy s) (zz s) u v w)
    (add (scale (xy s) (sym_dyad u v)) (add (scale (yz s) (sym_dyad v w)) (scale (xz s) (sym_dyad u w)))).

Lemma form_sym t a b : form t a b = form t b a.
Proof. coordinates; ring. Qed.

Lemma form_combine t a b c u v w y :
  form t (combine a b c u v w) y = a * form t u y + b * form t v y + c * form t w y.
Proof. unfold form. apply dot_combine. Qed.

Lemma form_from_frame s u v w a b : form (from_frame u v w s) a b
  = xx s * (dot u a * dot u b) + yy s * (dot v a * dot v b) + zz s * (dot w a * dot w b)
    + xy s * (dot u a * dot v b + dot v a * dot u b)
    + yz s * (dot v a * dot w b + dot w a * dot v b)
    + xz s * (dot u a * dot w b + dot w a * dot u b).
Proof.
  unfold from_frame. rewrite !form_add, !form_scale, form_spectral, !form_sym_dyad. ring.
Qed.

(* A tensor is known by its bilinear form. *)
Lemma tensor_by_form a b : (forall x y, form a x y = form b x y) -> a = b.
Proof.
  intros H.
  assert (A := H (Vector 1 0 0) (Vector 1 0 0)). assert (B := H (Vector 0 1 0) (Vector 0 1 0)).
  assert (C := H (Vector 0 0 1) (Vector 0 0 1)). assert (D := H (Vector 1 0 0) (Vector 0 1 0)).
  assert (E := H (Vector 0 1 0) (Vector 0 0 1)). assert (F := H (Vector 1 0 0) (Vector 0 0 1)).
  clear H. coordinates. apply tensor_eq; cbn; lra.
Qed.

Lemma from_in_frame u v w t : orthonormal u v w -> from_frame u v w (in_frame u v w t) = t.
Proof.
  intros O. apply tensor_by_form. intros a b. rewrite form_from_frame. cbn [in_frame xx yy zz xy yz xz].
  assert (K : form t a b = dot a u * form t u b + dot a v * form t v b + dot a w * form t w b).
  { rewrite (resolve u v w a O) at 1. apply form_combine. }
  rewrite K.
  assert (L : forall c, form t c b = dot b u * form t c u + dot b v * form t c v + dot b w * form t c w).
  { intros c. rewrite (form_sym t c b). rewrite (resolve u v w b O) at 1. rewrite form_combine.
    rewrite !(form_sym t c). ring. }
  rewrite !L, (dot_sym u a), (dot_sym v a), (dot_sym w a), (dot_sym u b), (dot_sym v b), (dot_sym w b).
  rewrite (form_sym t v u), (form_sym t w v), (form_sym t w u). ring.
Qed.

Lemma in_from_frame u v w s : orthonormal u v w -> in_frame u v w (from_frame u v w s) = s.
Proof.
  intros [A B C D E F]. apply tensor_eq; unfold in_frame; cbn [xx yy zz xy yz xz];
  rewrite form_from_frame;
  rewrite ?(dot_sym v u), ?(dot_sym w v), ?(dot_sym w u), ?A, ?B, ?C, ?D, ?E, ?F; ring.
Qed.

(* Invariants are the same in every frame. *)
Lemma inner_in_frame u v w a b : orthonormal u v w ->
  inner (in_frame u v w a) (in_frame u v w b) = inner a b.
Proof.
  intros O. rewrite <- (from_in_frame u v w a O) at 2.
  generalize (in_frame u v w a). intros s. unfold from_frame.
  rewrite !inner_add, !inner_scale, inner_spectral.
  assert (S : forall x y, inner (sym_dyad x y) b = 2 * form b x y) by (intros; coordinates; ring).
  rewrite !S. unfold inner, in_frame; cbn [xx yy zz xy yz xz]. ring.
Qed.
Lemma norm2_in_frame u v w a : orthonormal u v w -> norm2 (in_frame u v w a) = norm2 a.
Proof. intros O. apply inner_in_frame, O. Qed.
Lemma trace_in_frame u v w a : orthonormal u v w -> trace (in_frame u v w a) = trace a.
Proof.
  intros O. rewrite <- (from_in_frame u v w a O) at 2.
  generalize (in_frame u v w a). intros s. destruct O as [A B C D E F].
  unfold from_frame, spectral. rewrite !trace_add, !trace_scale, !trace_dyad, !trace_sym_dyad.
  rewrite A, B, C, D, E, F. unfold trace. ring.
Qed.
(* The determinant of the numbers u_i.a_j is the product of two volumes. *)
Lemma product_of_volumes u v w a b c :
  volume u v w * volume a b c
  = dot u a * (dot v b * dot w c - dot w b * dot v c)
    - dot u b * (dot v a * dot w c - dot w a * dot v c)
    + dot u c * (dot v a * dot w b - dot w a * dot v b).
Proof. coordinates; ring. Qed.
Lemma volume_apply t u v w : volume (apply t u) (apply t v) (apply t w) = det t * volume u v w.
Proof. coordinates; ring. Qed.
Lemma det_in_frame u v w a : orthonormal u v w -> det (in_frame u v w a) = det a.
Proof.
  intros O. transitivity (volume u v w * volume (apply a u) (apply a v) (apply a w)).
  - rewrite product_of_volumes.
    change (det (in_frame u v w a)
      = form a u u * (form a v v * form a w w - form a w v * form a v w)
        - form a u v * (form a v u * form a w w - form a w u * form a v w)
        + form a u w * (form a v u * form a w v - form a w u * form a v v)).
    rewrite (form_sym a v u), (form_sym a w v), (form_sym a w u).
    unfold det, in_frame; cbn [xx yy zz xy yz xz]. ring.
  - rewrite volume_apply. transitivity (det a * (volume u v w * volume u v w)); [ring|].
    rewrite (volume_squared u v w O). ring.
Qed.
Lemma spectral_from_frame l1 l2 l3 u v w :
  spectral l1 l2 l3 u v w = from_frame u v w (Tensor l1 l2 l3 0 0 0).
Proof. unfold from_frame. cbn [xx yy zz xy yz xz]. generalize (spectral l1 l2 l3 u v w). intros. tensor_ring. Qed.
Lemma det_spectral l1 l2 l3 u v w : orthonormal u v w ->
  det (spectral l1 l2 l3 u v w) = l1 * l2 * l3.
Proof.
  intros O. rewrite <- (det_in_frame u v w _ O), spectral_from_frame, (in_from_frame u v w _ O).
  unfold det; cbn [xx yy zz xy yz xz]. ring.
Qed.

(* A unit vector is part of a frame. *)
Lemma perpendicular_unit u : dot u u = 1 -> exists v, dot v v = 1 /\ dot u v = 0.
Proof.
  intros U. assert (P : exists v, v <> zero_vector /\ dot u v = 0).
  { destruct (Req_dec (vx u) 0) as [X|X].
    - exists (Vector 1 0 0). split; [intros H; apply (f_equal vx) in H; cbn in H; lra|].
      coordinates. rewrite X. ring.
    - exists (Vector (- vy u) (vx u) 0). split; [intros H; apply (f_equal vy) in H; cbn in H; auto|].
      coordinates. ring. }
  destruct P as [v [N P]]. assert (Q := dot_positive v N).
  assert (S : 0 < sqrt (dot v v)) by (apply sqrt_lt_R0; exact Q).
  assert (SS : sqrt (dot v v) * sqrt (dot v v) = dot v v) by (apply sqrt_sqrt; lra).
  exists (scale_vector (/ sqrt (dot v v)) v). set (r := sqrt (dot v v)) in *. split.
  - transitivity (/ r * / r * dot v v); [clear; coordinates; ring|]. rewrite <- SS. field. lra.
  - transitivity (/ r * dot u v); [clear; coordinates; ring|]. rewrite P. ring.
Qed.
Lemma frame_from_pair u v : dot u u = 1 -> dot v v = 1 -> dot u v = 0 ->
  orthonormal u v (cross u v).
Proof.
  intros A B C. constructor; auto; try (clear; coordinates; ring).
  transitivity (dot u u * dot v v - dot u v * dot u v); [clear; coordinates; ring|].
  rewrite A, B, C. ring.
Qed.
Lemma frame_from_unit u : dot u u = 1 -> exists v w, orthonormal u v w.
Proof.
  intros U. destruct (perpendicular_unit u U) as [v [V P]].
  exists v, (cross u v). apply frame_from_pair; auto.
Qed.

(* A frame turned in the plane of its first two vectors. *)
Lemma turned_frame u v w c s : orthonormal u v w -> c * c + s * s = 1 ->
  orthonormal (combine c s 0 u v w) (combine (- s) c 0 u v w) w.
Proof.
  intros [A B C D E F] H.
  constructor; rewrite ?dot_combine; rewrite ?(dot_sym _ (combine _ _ _ _ _ _)), ?dot_combine;
  rewrite ?(dot_sym v u), ?(dot_sym w v), ?(dot_sym w u), ?A, ?B, ?C, ?D, ?E, ?F; try lra.
Qed.
