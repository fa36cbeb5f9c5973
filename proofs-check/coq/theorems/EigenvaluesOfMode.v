(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   The eigenvalues of a unit tensor by its mode: sines of thirds of the arc sine of minus the mode.
   These three numbers are in order, have the sum 0 and the squared norm 1, and this mode; and a
   deviator's eigenvalues are known from its norm and its mode. *)
From TensorTopo Require Import Tensors Frames DegenerateTensors SpectralTheorem Mode ModeRange Calculus.
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

Definition root k mu := sqrt (2 / 3) * sin (arc_sine (- mu) / 3 + k * (2 * (PI / 3))).

Lemma sin_triple x : sin (3 * x) = 3 * sin x - 4 * (sin x * sin x * sin x).
Proof.
  replace (3 * x) with (2 * x + x) by ring. rewrite sin_plus, cos_2a, sin_2a.
  assert (H := sin2_cos2 x). unfold Rsqr in H.
  transitivity (3 * sin x * (cos x * cos x) - sin x * sin x * sin x); [ring|].
  replace (cos x * cos x) with (1 - sin x * sin x) by lra. ring.
Qed.

Lemma sines mu : -1 <= mu <= 1 -> let a := root 1 mu in let b := root 0 mu in let c := root (-1) mu in
  a >= b /\ b >= c /\ a + b + c = 0 /\ a * a + b * b + c * c = 1 /\ 3 * sqrt 6 * (a * b * c) = mu.
Proof.
  intros M a b c. unfold a, b, c, root. set (x := arc_sine (- mu) / 3).
  assert (B := arc_sine_bound (- mu)). assert (Pi := PI_RGT_0).
  assert (X : - (PI / 6) <= x <= PI / 6) by (unfold x; lra).
  assert (X3 : sin (3 * x) = - mu).
  { unfold x. replace (3 * (arc_sine (- mu) / 3)) with (arc_sine (- mu)) by field. apply sin_arc_sine. lra. }
  rewrite sin_triple in X3.
  set (r := sqrt (2 / 3)). assert (R : r * r = 2 / 3) by (apply sqrt_sqrt; lra).
  assert (Rp : 0 < r) by (apply sqrt_lt_R0; lra).
  set (q := sqrt 3). assert (Q : q * q = 3) by (apply sqrt_sqrt; lra).
  assert (Qp : 0 < q) by (apply sqrt_lt_R0; lra).
  assert (C : cos x * cos x = 1 - sin x * sin x) by (assert (H := sin2_cos2 x); unfold Rsqr in H; lra).
  assert (E0 : sin (x + 0 * (2 * (PI / 3))) = sin x) by (f_equal; ring).
  assert (S3 : sin (2 * (PI / 3)) = q / 2) by apply sin_2PI3.
  assert (C3 : cos (2 * (PI / 3)) = -1 / 2) by apply cos_2PI3.
  assert (E1 : sin (x + 1 * (2 * (PI / 3))) = - sin x / 2 + q / 2 * cos x).
  { replace (1 * (2 * (PI / 3))) with (2 * (PI / 3)) by ring. rewrite sin_plus, S3, C3. field. }
  assert (E2 : sin (x + -1 * (2 * (PI / 3))) = - sin x / 2 - q / 2 * cos x).
  { replace (x + -1 * (2 * (PI / 3))) with (x - 2 * (PI / 3)) by ring. rewrite sin_minus, S3, C3. field. }
  rewrite E0, E1, E2.
  assert (P1 : 0 <= cos (x + PI / 3)) by (apply cos_ge_0; lra).
  assert (P2 : 0 <= cos (x - PI / 3)) by (apply cos_ge_0; lra).
  rewrite cos_plus, cos_PI3, sin_PI3 in P1. rewrite cos_minus, cos_PI3, sin_PI3 in P2. fold q in P1, P2.
  set (s := sin x) in *. set (k := cos x) in *.
  assert (G1 : 0 <= r * (q * (k * (1 / 2) - s * (q / 2)))) by (repeat apply Rmult_le_pos; lra).
  assert (G2 : 0 <= r * (q * (k * (1 / 2) + s * (q / 2)))) by (repeat apply Rmult_le_pos; lra).
  assert (H1 : r * (q * (k * (1 / 2) - s * (q / 2))) = r * (- s / 2 + q / 2 * k) - r * s).
  { transitivity (r * (q * k / 2 - (q * q) * s / 2)); [field|rewrite Q; field]. }
  assert (H2 : r * (q * (k * (1 / 2) + s * (q / 2))) = r * s - r * (- s / 2 - q / 2 * k)).
  { transitivity (r * (q * k / 2 + (q * q) * s / 2)); [field|rewrite Q; field]. }
  split; [lra|]. split; [lra|]. split; [field|]. split.
  - transitivity (r * r * (3 / 2 * (s * s) + (q * q) / 2 * (k * k))); [field|]. rewrite R, Q, C. field.
  - transitivity (3 * (sqrt 6 * r) * (r * r) * (s * (s * s / 4 - (q * q) / 4 * (k * k)))); [field|].
    assert (SR : sqrt 6 * r = 2).
    { unfold r. rewrite <- sqrt_mult by lra. replace (6 * (2 / 3)) with (2 * 2) by field. apply sqrt_square. lra. }
    rewrite R, Q, C, SR. lra.
Qed.

Theorem eigenvalues_of_mode t : t <> zero -> trace t = 0 -> exists u v w, orthonormal u v w /\
  t = scale (norm t) (spectral (root 1 (mode t)) (root 0 (mode t)) (root (-1) (mode t)) u v w).
Proof.
  intros N T. assert (Mr := mode_range t N T). assert (P := norm_positive t N).
  destruct (medium_exists t) as [v Mv].
  destruct (parameter_of_tensor t v N T Mv) as [k [s [u [w [K [I [O E]]]]]]].
  exists u, v, w. split; [exact O|].
  destruct (sines (mode t) Mr) as [A [B [S [Q M]]]]. cbv zeta in *.
  set (a := root 1 (mode t)) in *. set (b := root 0 (mode t)) in *. set (c := root (-1) (mode t)) in *.
  assert (D : a > c) by (destruct (Rlt_dec c a) as [H|H]; [exact H|exfalso; assert (a = 0) by lra;
    assert (b = 0) by lra; assert (c = 0) by lra; rewrite H0, H1, H2 in Q; lra]).
  destruct (parameter_of_eigenvalues a b c A B S D) as [k' [s' [K' [I' [E1 [E2 E3]]]]]].
  assert (Mo : mode (spectral a b c u v w) = mode t).
  { unfold mode at 1, norm. rewrite norm2_spectral, det_spectral, Q, sqrt_1 by exact O.
    rewrite M. field. }
  assert (Ss : s' = s).
  { apply parameter_mode_injective; auto.
    transitivity (mode (spectral a b c u v w)).
    - rewrite E1, E2, E3. symmetry. apply mode_of_parameter; assumption.
    - rewrite Mo, E. apply mode_of_parameter; assumption. }
  subst s'.
  assert (Kk : norm t * k' = k).
  { assert (H1 : k' * k' * (6 * (3 + s * s)) = 1) by (rewrite <- Q, E1, E2, E3; ring).
    assert (H2 : norm t * norm t = k * k * (6 * (3 + s * s))).
    { rewrite norm_squared, E. unfold of_parameter. rewrite norm2_spectral by exact O. ring. }
    set (n := norm t) in *.
    assert (H3 : (n * k' - k) * (n * k' + k) * (6 * (3 + s * s)) = 0).
    { transitivity (n * n * (k' * k' * (6 * (3 + s * s))) - k * k * (6 * (3 + s * s))); [ring|]. rewrite H1, <- H2. ring. }
    assert (Z := square_nonneg s). assert (0 < n * k') by (apply Rmult_lt_0_compat; assumption).
    destruct (Rmult_integral _ _ H3) as [H4|H4]; [destruct (Rmult_integral _ _ H4); lra|lra]. }
  rewrite scale_spectral, E1, E2, E3. rewrite E at 1. unfold of_parameter. rewrite <- Kk. f_equal; ring.
Qed.
