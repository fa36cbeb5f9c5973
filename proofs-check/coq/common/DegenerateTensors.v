(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   Degenerate tensors, those with two equal eigenvalues. *)
From TensorTopo Require Import Tensors Frames.
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

(* With two equal eigenvalues: T = a I + b u u^T for a unit vector u. *)
Definition degenerate t := exists a b u,
  dot u u = 1 /\ t = add (scale a identity) (scale b (dyad u)).

Lemma identity_spectral u v w : orthonormal u v w -> identity = spectral 1 1 1 u v w.
Proof.
  intros O. apply tensor_by_form. intros x y. rewrite form_spectral.
  transitivity (dot x y); [coordinates; ring|]. rewrite (dot_resolved u v w x y O).
  rewrite !(dot_sym u), !(dot_sym v), !(dot_sym w). ring.
Qed.

Lemma equal_pair_degenerate a b u v w : orthonormal u v w ->
  spectral b a a u v w = add (scale a identity) (scale (b - a) (dyad u)).
Proof.
  intros O. rewrite (identity_spectral u v w O). unfold spectral.
  generalize (dyad u) (dyad v) (dyad w). clear. intros. tensor_ring.
Qed.

Lemma degenerate_spectral t : degenerate t ->
  exists a b u v w, orthonormal u v w /\ t = spectral b a a u v w.
Proof.
  intros [a [b [u [U E]]]]. destruct (frame_from_unit u U) as [v [w O]].
  exists a, (a + b), u, v, w. split; [exact O|].
  rewrite (equal_pair_degenerate a (a + b) u v w O), E. f_equal. f_equal. ring.
Qed.
