(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   |T|^6 - 54 det(T)^2 = 2 (l1-l2)^2 (l2-l3)^2 (l1-l3)^2 for the eigenvalues of a traceless T,
   by its spectral form. *)
From TensorTopo Require Import Tensors Frames SpectralTheorem.
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

Theorem discriminant t : trace t = 0 -> exists l1 l2 l3 u v w,
  l1 >= l2 /\ l2 >= l3 /\ orthonormal u v w /\ t = spectral l1 l2 l3 u v w /\
  norm2 t ^ 3 - 54 * det t ^ 2 = 2 * ((l1 - l2) * (l2 - l3) * (l1 - l3)) ^ 2.
Proof.
  intros T. destruct (spectral_theorem t) as [l1 [l2 [l3 [u [v [w [A [B [O E]]]]]]]]].
  exists l1, l2, l3, u, v, w. repeat (split; [assumption|]).
  assert (S : l1 + l2 + l3 = 0) by (rewrite <- T, E; symmetry; apply trace_spectral, O).
  rewrite E, norm2_spectral, det_spectral by exact O.
  replace l3 with (- l1 - l2) by lra. ring.
Qed.
