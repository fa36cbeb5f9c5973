(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   The boundary function in the frame of the characteristic tensor's eigenvectors: it depends on the
   squares of a unit vector's coordinates only, through alpha = v.N v. *)
From TensorTopo Require Import Tensors Frames Mode MediumEigenvector.
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

Definition along a v := dot v a * dot v a.

Section CharacteristicFrame.
Variables (b1 b2 b3 : R) (e1 e2 e3 : vector).
Hypothesis O : orthonormal e1 e2 e3.

Lemma along_sum v : dot v v = 1 -> along e1 v + along e2 v + along e3 v = 1.
Proof. intros V. unfold along. rewrite <- (dot_resolved e1 e2 e3 v v O). exact V. Qed.
Lemma along_nonneg a v : 0 <= along a v.
Proof. apply square_nonneg. Qed.
Lemma alpha_spectral v : form (spectral b1 b2 b3 e1 e2 e3) v v
  = b1 * along e1 v + b2 * along e2 v + b3 * along e3 v.
Proof.
  rewrite form_spectral, (dot_sym e1), (dot_sym e2), (dot_sym e3). unfold along. ring.
Qed.
Lemma apply_spectral v x : dot (apply (spectral b1 b2 b3 e1 e2 e3) v) x
  = b1 * (dot v e1 * dot x e1) + b2 * (dot v e2 * dot x e2) + b3 * (dot v e3 * dot x e3).
Proof.
  rewrite dot_sym. change (form (spectral b1 b2 b3 e1 e2 e3) x v = b1 * (dot v e1 * dot x e1) + b2 * (dot v e2 * dot x e2) + b3 * (dot v e3 * dot x e3)).
  rewrite form_spectral, !(dot_sym e1), !(dot_sym e2), !(dot_sym e3). ring.
Qed.
Lemma beta_spectral v : let n := spectral b1 b2 b3 e1 e2 e3 in dot (apply n v) (apply n v)
  = b1 * b1 * along e1 v + b2 * b2 * along e2 v + b3 * b3 * along e3 v.
Proof.
  intros n. rewrite (dot_resolved e1 e2 e3 _ _ O). unfold n. rewrite !apply_spectral.
  destruct O as [A B C D E F].
  rewrite ?(dot_sym e2 e1), ?(dot_sym e3 e2), ?(dot_sym e3 e1), ?A, ?B, ?C, ?D, ?E, ?F.
  unfold along. ring.
Qed.
Lemma boundary_spectral s v : boundary_function (spectral b1 b2 b3 e1 e2 e3) s v
  = (b1 * b1 + b2 * b2 + b3 * b3) / 2
    - (b1 * b1 * along e1 v + b2 * b2 * along e2 v + b3 * b3 * along e3 v)
    + (1 - s * s) * ((b1 * along e1 v + b2 * along e2 v + b3 * along e3 v)
                   * (b1 * along e1 v + b2 * along e2 v + b3 * along e3 v)) / 4.
Proof.
  unfold boundary_function. rewrite (norm2_spectral _ _ _ _ _ _ O), beta_spectral, alpha_spectral.
  reflexivity.
Qed.

(* Any three numbers that are not negative and have the sum 1 are the squares of a unit vector. *)
Lemma vector_of_squares m1 m2 m3 : 0 <= m1 -> 0 <= m2 -> 0 <= m3 -> m1 + m2 + m3 = 1 ->
  exists v, dot v v = 1 /\ along e1 v = m1 /\ along e2 v = m2 /\ along e3 v = m3.
Proof.
  intros A B C S. exists (combine (sqrt m1) (sqrt m2) (sqrt m3) e1 e2 e3).
  destruct O as [O1 O2 O3 O4 O5 O6].
  assert (H : forall x, 0 <= x -> sqrt x * sqrt x = x) by (intros; apply sqrt_sqrt; assumption).
  unfold along. rewrite !dot_combine, !(dot_sym _ (combine _ _ _ _ _ _)), !dot_combine.
  rewrite ?(dot_sym e2 e1), ?(dot_sym e3 e2), ?(dot_sym e3 e1), ?O1, ?O2, ?O3, ?O4, ?O5, ?O6.
  repeat split; ring_simplify; rewrite <- ?Rsqr_pow2, ?Rsqr_sqrt by assumption; try reflexivity.
  lra.
Qed.
End CharacteristicFrame.

(* The eigenvalues of a characteristic tensor: of sum 0 and with a product that is not positive. *)
Lemma characteristic_order b1 b2 b3 : b1 >= b2 -> b2 >= b3 -> b1 + b2 + b3 = 0 ->
  (b1 * b2 * b3 < 0 -> 0 < b2 /\ b3 < 0) /\ (b1 * b2 * b3 = 0 -> b2 = 0).
Proof.
  intros A B S. split; intros D.
  - assert (K : 0 < b2).
    { apply Rnot_le_lt. intros H. assert (0 <= b1) by lra. assert (b3 <= 0) by lra.
      assert (0 <= b1 * (- b2) * (- b3)) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra). lra. }
    split; lra.
  - destruct (Rmult_integral _ _ D) as [E|E]; [destruct (Rmult_integral _ _ E)|]; lra.
Qed.
