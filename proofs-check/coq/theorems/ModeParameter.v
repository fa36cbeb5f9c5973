(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   Every nonzero traceless tensor has the eigenvalues k (3 + s), -2 k s, k (s - 3) for one k > 0 and
   one s in [-1, 1]; its mode is s (9 - s^2) / (3 + s^2)^(3/2), which increases strictly with s. *)
From TensorTopo Require Import Tensors Frames SpectralTheorem Mode.
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

Theorem mode_parameter t : t <> zero -> trace t = 0 -> exists k s u v w,
  0 < k /\ -1 <= s <= 1 /\ orthonormal u v w /\ t = of_parameter k s u v w /\
  mode t = s * (9 - s * s) / sqrt (3 + s * s) ^ 3 /\
  (forall k' s' u' v' w', 0 < k' -> -1 <= s' <= 1 -> orthonormal u' v' w' ->
     t = of_parameter k' s' u' v' w' -> s' = s).
Proof.
  intros N T. destruct (medium_exists t) as [v M].
  destruct (parameter_of_tensor t v N T M) as [k [s [u [w [K [I [O E]]]]]]].
  assert (F : mode t = parameter_mode s) by (rewrite E; apply mode_of_parameter; assumption).
  exists k, s, u, v, w. repeat (split; [assumption|]). split.
  - rewrite F. unfold parameter_mode. f_equal. ring.
  - intros k' s' u' v' w' K' I' O' E'. apply parameter_mode_injective; auto.
    rewrite <- F, E'. symmetry. apply mode_of_parameter; assumption.
Qed.

Theorem mode_increases_with_parameter s1 s2 : -1 <= s1 -> s1 < s2 -> s2 <= 1 ->
  s1 * (9 - s1 * s1) / sqrt (3 + s1 * s1) ^ 3 < s2 * (9 - s2 * s2) / sqrt (3 + s2 * s2) ^ 3.
Proof.
  intros A B C. assert (H := parameter_mode_increases s1 s2 A B C).
  unfold parameter_mode in H. cbn [pow]. rewrite !Rmult_1_r, <- !Rmult_assoc. exact H.
Qed.
