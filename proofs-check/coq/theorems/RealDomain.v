(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   Theorem 2, in space: v is the medium eigenvector of some tensor of the field of the given mode
   exactly if the boundary function is not negative there. The field is what is orthogonal to the
   characteristic tensor N. The idea: orthogonality is a quadratic equation for the dominant
   direction across v, and the boundary function is its discriminant. *)
From TensorTopo Require Import Tensors Frames Mode MediumEigenvector.
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

(* At a tensor of the field with dominant direction d, the boundary function is the square of
   d.N (v x d); w is v x d or its opposite. *)
Theorem signed_root N s k d v w : trace N = 0 -> orthonormal d v w -> k <> 0 ->
  inner N (of_parameter k s d v w) = 0 ->
  boundary_function N s v = form N d w * form N d w.
Proof.
  intros T O K I. assert (B := boundary_in_frame N s d v w O T).
  assert (C := orthogonality_inner N s k 1 0 d v w O T ltac:(ring)).
  assert (E1 : dominant 1 0 d v w = d) by (unfold dominant, combine; vector_ring).
  assert (E2 : across 1 0 d v w = w) by (unfold across, combine; vector_ring).
  rewrite E1, E2, I in C. symmetry in C. destruct (Rmult_integral _ _ C) as [X|Z]; [contradiction|].
  assert (F : coef_ee N s d w = 0) by (unfold orthogonality in Z; lra).
  rewrite F in B. unfold coef_ef in B. lra.
Qed.

Theorem real_domain N s v : trace N = 0 -> dot v v = 1 -> -1 <= s <= 1 ->
  ((exists t, has_medium N s v t) <-> 0 <= boundary_function N s v).
Proof.
  intros T V S. split.
  - intros [t H]. apply has_medium_iff in H; [|exact S].
    destruct H as [k [u [w [K [O [E I]]]]]]. rewrite E in I.
    rewrite (signed_root N s k u v w T O ltac:(lra) I). apply square_nonneg.
  - intros H. destruct (frame_from_unit v V) as [f [e O']].
    assert (O : orthonormal e v f) by (permuted_frame O').
    assert (B := boundary_in_frame N s e v f O T).
    assert (R : exists x y, (x <> 0 \/ y <> 0) /\ orthogonality N s e f x y = 0).
    { unfold orthogonality. set (a := coef_ee N s e f) in *. set (b := coef_ef N e f) in *.
      set (c := coef_ff N s e f) in *. destruct (Req_dec (b * b - a * c) 0) as [Z|Z].
      - destruct (Req_dec a 0) as [A|A]; [exists 1, 0; split; [left; lra|rewrite A; ring]|].
        destruct (binary_one_root a b c Z ltac:(auto)) as [x [y [N1 [N2 _]]]]. exists x, y. auto.
      - destruct (binary_two_roots a b c ltac:(lra)) as [x [y [x2 [y2 [N1 [_ [N2 _]]]]]]].
        exists x, y. split; [|exact N1].
        destruct (Req_dec x 0) as [X|X]; [|auto]. destruct (Req_dec y 0) as [Y|Y]; [|auto].
        exfalso. apply N2. rewrite X, Y. ring. }
    destruct R as [x [y [N1 N2]]].
    destruct (unit_root (coef_ee N s e f) (coef_ef N e f) (coef_ff N s e f) x y N1 N2) as [x' [y' [_ [_ [_ [_ [U Z]]]]]]].
    exists (of_parameter 1 s (dominant x' y' e v f) v (across x' y' e v f)).
    apply has_medium_iff; [exact S|]. exists 1, (dominant x' y' e v f), (across x' y' e v f).
    split; [lra|]. split; [apply turned_orthonormal; assumption|]. split; [reflexivity|].
    rewrite (orthogonality_inner N s 1 x' y' e v f O T U). unfold orthogonality. unfold binary in Z. rewrite Z. ring.
Qed.

(* So vectors of the complex domain belong to no tensor of this mode or of the opposite one. *)
Theorem complex_domain N s v t : trace N = 0 -> dot v v = 1 -> 0 <= s <= 1 ->
  boundary_function N s v < 0 -> inner N t = 0 -> t <> zero -> trace t = 0 ->
  medium_eigenvector v t -> mode t <> parameter_mode s /\ mode t <> - parameter_mode s.
Proof.
  intros T V S B I Z Tr M.
  assert (K : forall r, -1 <= r <= 1 -> boundary_function N r v < 0 -> mode t <> parameter_mode r).
  { intros r R Br E. assert (H : 0 <= boundary_function N r v); [|lra].
    apply real_domain; auto. exists t. unfold has_medium. auto. }
  split; [apply K; [lra|exact B]|]. rewrite <- parameter_mode_opposite. apply K; [lra|].
  unfold boundary_function in *. replace (- s * - s) with (s * s) by ring. exact B.
Qed.
