(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   Corollary 3. The boundary function does not grow with s, so complex domains are nested. If the
   characteristic determinant is negative they are so properly: the unit vector across the second
   eigenvector with the eigenvalues b2 and b2 (1 - s1) / (1 + s1) of the projected tensor is on the
   boundary for s1 and in the complex domain for every s2 > s1. At determinant 0 all are empty. *)
From TensorTopo Require Import Tensors Frames SpectralTheorem Mode MediumEigenvector
  CharacteristicFrame.
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

Theorem nested N s1 s2 v : 0 <= s1 <= s2 ->
  boundary_function N s1 v < 0 -> boundary_function N s2 v < 0.
Proof.
  unfold boundary_function. intros S. assert (A := square_nonneg (form N v v)).
  assert (0 <= (s2 * s2 - s1 * s1) * (form N v v * form N v v)) by (apply Rmult_le_pos; nra). lra.
Qed.

Theorem properly_nested N s1 s2 : trace N = 0 -> det N < 0 -> 0 <= s1 -> s1 < s2 ->
  exists v, dot v v = 1 /\ boundary_function N s1 v = 0 /\ boundary_function N s2 v < 0.
Proof.
  intros T D S1 S2. destruct (spectral_theorem N) as [b1 [b2 [b3 [e1 [e2 [e3 [A [B [O E]]]]]]]]].
  assert (S : b1 + b2 + b3 = 0) by (rewrite <- T, E; symmetry; apply trace_spectral, O).
  rewrite E, (det_spectral _ _ _ _ _ _ O) in D.
  destruct (characteristic_order b1 b2 b3 A B S) as [C _]. destruct (C D) as [B2 B3].
  set (k := (1 - s1) / (1 + s1)).
  assert (K : k * (1 + s1) = 1 - s1) by (unfold k; field; lra).
  assert (K1 : k <= 1) by (apply (Rmult_le_reg_r (1 + s1)); lra).
  assert (K2 : -1 <= k) by (apply (Rmult_le_reg_r (1 + s1)); lra).
  set (m1 := (b1 - k * b2) / (b1 - b3)). set (m3 := (k * b2 - b3) / (b1 - b3)).
  assert (P : 0 < b1 - b3) by lra.
  assert (KB : - b2 <= k * b2 <= b2) by (split; nra).
  destruct (vector_of_squares e1 e2 e3 O m1 0 m3) as [v [V [V1 [V2 V3]]]].
  - apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; exact P].
  - lra.
  - apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; exact P].
  - unfold m1, m3. field. lra.
  - exists v. split; [exact V|].
    assert (G : forall s, boundary_function N s v
      = ((1 - k) * (1 - k) - s * s * ((1 + k) * (1 + k))) * (b2 * b2) / 4).
    { intros s. rewrite E, (boundary_spectral _ _ _ _ _ _ O), V1, V2, V3.
      unfold m1, m3. replace b3 with (- b1 - b2) by lra. field. lra. }
    assert (Z : (1 - k) = s1 * (1 + k)) by lra.
    rewrite !G, Z. split; [field|].
    assert (0 < 1 + k) by (assert (0 < (1 + k) * (1 + s1)) by lra; nra).
    assert (0 < (s2 * s2 - s1 * s1) * ((1 + k) * (1 + k)) * (b2 * b2)).
    { repeat apply Rmult_lt_0_compat; nra. }
    lra.
Qed.

Theorem empty_at_determinant_zero N s v : trace N = 0 -> det N = 0 -> dot v v = 1 -> 0 <= s <= 1 ->
  0 <= boundary_function N s v.
Proof.
  intros T D V S1. destruct (spectral_theorem N) as [b1 [b2 [b3 [e1 [e2 [e3 [A [B [O E]]]]]]]]].
  assert (S : b1 + b2 + b3 = 0) by (rewrite <- T, E; symmetry; apply trace_spectral, O).
  rewrite E, (det_spectral _ _ _ _ _ _ O) in D.
  destruct (characteristic_order b1 b2 b3 A B S) as [_ C]. assert (Z := C D).
  rewrite E, (boundary_spectral _ _ _ _ _ _ O).
  assert (W := along_sum e1 e2 e3 O v V). assert (N2 := along_nonneg e2 v).
  set (m1 := along e1 v) in *. set (m2 := along e2 v) in *. set (m3 := along e3 v) in *.
  replace b3 with (- b1) by lra. rewrite Z.
  assert (Q := square_nonneg (b1 * m1 + 0 * m2 + - b1 * m3)).
  set (q := (b1 * m1 + 0 * m2 + - b1 * m3) * (b1 * m1 + 0 * m2 + - b1 * m3)) in *.
  assert (0 <= (1 - s * s) * q) by (apply Rmult_le_pos; nra).
  assert (0 <= b1 * b1 * m2) by (apply Rmult_le_pos; [apply square_nonneg|exact N2]).
  replace m1 with (1 - m2 - m3) in * by lra. lra.
Qed.
