(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   With ordered eigenvalues l1 >= l2 >= l3 of sum 0: mode 1 is l2 = l3 (linear degenerate),
   mode -1 is l1 = l2 (planar degenerate), mode 0 is l2 = 0, the mean of the others (neutral). *)
From TensorTopo Require Import Tensors Frames DegenerateTensors SpectralTheorem Mode Discriminant
  ModeRange.
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

Theorem mode_extremes l1 l2 l3 u v w : orthonormal u v w -> l1 >= l2 -> l2 >= l3 ->
  l1 + l2 + l3 = 0 -> l1 > l3 -> let t := spectral l1 l2 l3 u v w in
  (mode t = 1 <-> l2 = l3) /\ (mode t = -1 <-> l1 = l2) /\
  (mode t = 0 <-> l2 = (l1 + l3) / 2).
Proof.
  intros O A B S N t.
  destruct (parameter_of_eigenvalues l1 l2 l3 A B S N) as [k [s [K [I [E1 [E2 E3]]]]]].
  assert (M : mode t = parameter_mode s).
  { unfold t. rewrite E1, E2, E3. apply mode_of_parameter; assumption. }
  assert (P1 : parameter_mode 1 = 1).
  { unfold parameter_mode. replace (3 + 1 * 1) with (2 * 2) by ring.
    rewrite sqrt_square by lra. field. }
  assert (P2 : parameter_mode (-1) = -1).
  { replace (-1) with (- (1)) by ring. rewrite parameter_mode_opposite, P1. ring. }
  assert (P3 : parameter_mode 0 = 0) by (unfold parameter_mode; unfold Rdiv; ring).
  assert (J : forall r, -1 <= r <= 1 -> (mode t = parameter_mode r <-> s = r)).
  { intros r R. rewrite M. split; [apply parameter_mode_injective; assumption|intros; subst; reflexivity]. }
  assert (Z : forall r, k * r = 0 <-> r = 0).
  { intros r. split; [intros H; destruct (Rmult_integral _ _ H); lra|intros; subst; ring]. }
  rewrite <- P1 at 1. rewrite <- P2 at 1. rewrite <- P3 at 1.
  rewrite (J 1), (J (-1)), (J 0) by lra. rewrite E1, E2, E3.
  repeat split; intros H.
  - subst. ring.
  - assert (s - 1 = 0) by (apply Z; lra). lra.
  - subst. ring.
  - assert (s + 1 = 0) by (apply Z; lra). lra.
  - subst. field.
  - apply Z. lra.
Qed.
