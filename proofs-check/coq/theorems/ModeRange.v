(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   The mode of a traceless tensor lies in [-1, 1]. It is 1 or -1 exactly for degenerate tensors,
   those with two equal eigenvalues. The idea: 1 - mode^2 is the discriminant over |T|^6. *)
From TensorTopo Require Import Tensors Frames DegenerateTensors SpectralTheorem Mode Discriminant.
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

Lemma mode_complement t l1 l2 l3 : t <> zero ->
  norm2 t ^ 3 - 54 * det t ^ 2 = 2 * ((l1 - l2) * (l2 - l3) * (l1 - l3)) ^ 2 ->
  (1 - mode t * mode t) * norm2 t ^ 3 = 2 * ((l1 - l2) * (l2 - l3) * (l1 - l3)) ^ 2.
Proof.
  intros N H. assert (M := mode_squared t N). rewrite <- H.
  transitivity (norm2 t ^ 3 - mode t * mode t * (norm2 t * norm2 t * norm2 t)); [ring|].
  rewrite M. ring.
Qed.

Theorem mode_range t : t <> zero -> trace t = 0 -> -1 <= mode t <= 1.
Proof.
  intros N T. destruct (discriminant t T) as [l1 [l2 [l3 [u [v [w [_ [_ [_ [_ H]]]]]]]]]].
  assert (C := mode_complement t l1 l2 l3 N H).
  assert (S := pow2_ge_0 ((l1 - l2) * (l2 - l3) * (l1 - l3))).
  assert (P : 0 < norm2 t ^ 3) by (apply pow_lt, norm2_positive, N).
  set (m := mode t) in *.
  assert (Q : m * m <= 1).
  { apply Rnot_lt_le. intros K.
    assert (0 < (m * m - 1) * norm2 t ^ 3) by (apply Rmult_lt_0_compat; lra). lra. }
  split; nra.
Qed.

Theorem mode_range_ends t : t <> zero -> trace t = 0 ->
  (mode t = 1 \/ mode t = -1 <-> degenerate t).
Proof.
  intros N T. split.
  - intros M. destruct (discriminant t T) as [l1 [l2 [l3 [u [v [w [_ [_ [O [E H]]]]]]]]]].
    assert (C := mode_complement t l1 l2 l3 N H).
    assert (Z : ((l1 - l2) * (l2 - l3) * (l1 - l3)) ^ 2 = 0).
    { replace (mode t * mode t) with 1 in C by (destruct M as [M|M]; rewrite M; ring). lra. }
    assert (K : (l1 - l2) * (l2 - l3) * (l1 - l3) = 0).
    { apply square_zero. rewrite <- Z. ring. }
    destruct (Rmult_integral _ _ K) as [K'|K']; [destruct (Rmult_integral _ _ K') as [K''|K'']|].
    + exists l1, (l3 - l1), w. split; [apply O|]. rewrite E. replace l2 with l1 by lra.
      rewrite spectral_rotate, spectral_rotate. apply equal_pair_degenerate. permuted_frame O.
    + exists l3, (l1 - l3), u. split; [apply O|]. rewrite E. replace l2 with l3 by lra.
      apply equal_pair_degenerate, O.
    + exists l3, (l2 - l3), v. split; [apply O|]. rewrite E. replace l1 with l3 by lra.
      rewrite spectral_rotate. apply equal_pair_degenerate. permuted_frame O.
  - intros D. destruct (degenerate_spectral t D) as [a [b [u [v [w [O E]]]]]].
    assert (S : b + a + a = 0) by (rewrite <- T, E; symmetry; apply trace_spectral, O).
    assert (M := mode_squared t N).
    assert (P := norm2_positive t N).
    assert (I : norm2 t * norm2 t * norm2 t = 54 * (det t * det t)).
    { rewrite E, norm2_spectral, det_spectral by exact O. replace b with (- a - a) by lra. ring. }
    assert (P3 : 0 < norm2 t * norm2 t * norm2 t) by (repeat apply Rmult_lt_0_compat; exact P).
    set (m := mode t) in *.
    assert (Q : (m - 1) * (m + 1) = 0).
    { apply (Rmult_eq_reg_r (norm2 t * norm2 t * norm2 t)); [|lra].
      transitivity (m * m * (norm2 t * norm2 t * norm2 t) - norm2 t * norm2 t * norm2 t); [ring|].
      rewrite M, I. ring. }
    destruct (Rmult_integral _ _ Q); [left|right]; lra.
Qed.
