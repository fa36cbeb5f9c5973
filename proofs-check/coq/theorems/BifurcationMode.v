(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   Where the boundary of the complex domain touches itself. With the characteristic eigenvalues
   b1 > b2 > 0 > b3 on e1, e2, e3: it passes through e3 exactly for s0 = (b1 - b2) / (b1 + b2), whose
   mode is sqrt(1 - mode(N)^2); and in an octant it meets the edges as Theorem 5 says. *)
From TensorTopo Require Import Tensors Frames Mode MediumEigenvector CharacteristicFrame
  BoundaryParameter.
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

Theorem touches_at_corner b1 b2 b3 e1 e2 e3 s : orthonormal e1 e2 e3 -> b1 + b2 + b3 = 0 ->
  b1 >= b2 -> 0 < b2 -> 0 <= s -> let N := spectral b1 b2 b3 e1 e2 e3 in
  (boundary_function N s e3 = 0 <-> s = (b1 - b2) / (b1 + b2)) /\
  (s <= 1 -> 0 < boundary_function N s e1 /\ 0 < boundary_function N s e2).
Proof.
  intros O S A B P N. assert (O' := O). destruct O' as [U1 U2 U3 P12 P23 P13].
  assert (Z : forall a b, dot a b = 0 -> along a b = 0).
  { intros a b H. unfold along. rewrite (dot_sym b a), H. ring. }
  assert (Y : forall a, dot a a = 1 -> along a a = 1) by (intros a H; unfold along; rewrite H; ring).
  assert (Z' : forall a b, dot b a = 0 -> along a b = 0) by (intros a b H; apply Z; rewrite dot_sym; exact H).
  unfold N. rewrite !(boundary_spectral _ _ _ _ _ _ O).
  rewrite (Z e1 e3 P13), (Z e2 e3 P23), (Y e3 U3), (Y e1 U1), (Y e2 U2), (Z e1 e2 P12),
    (Z' e2 e1 P12), (Z' e3 e1 P13), (Z' e3 e2 P23).
  replace b3 with (- b1 - b2) by lra. split.
  - assert (E : s = (b1 - b2) / (b1 + b2) <-> s * (b1 + b2) = b1 - b2).
    { split; intros H; [rewrite H; field; lra|]. apply (Rmult_eq_reg_r (b1 + b2)); [|lra].
      rewrite H. field. lra. }
    rewrite E. split; intros H.
    + assert (K : (b1 - b2 - s * (b1 + b2)) * (b1 - b2 + s * (b1 + b2)) = 0) by lra.
      assert (0 <= s * (b1 + b2)) by (apply Rmult_le_pos; lra).
      destruct (Rmult_integral _ _ K); lra.
    + transitivity ((b1 - b2 - s * (b1 + b2)) * (b1 - b2 + s * (b1 + b2)) / 4); [field|rewrite H; field].
  - intros L. assert (0 <= (1 - s * s) * (b1 * b1)) by (apply Rmult_le_pos; nra).
    assert (0 <= (1 - s * s) * (b2 * b2)) by (apply Rmult_le_pos; nra).
    assert (0 < b2 * (b1 + b2)) by (apply Rmult_lt_0_compat; lra).
    assert (0 < b1 * (b1 + b2)) by (apply Rmult_lt_0_compat; lra).
    split; lra.
Qed.

(* The mode there, and the Moebius form: r is the parameter of the mode -mode(N). *)
Theorem bifurcation_mode b1 b2 b3 e1 e2 e3 : orthonormal e1 e2 e3 -> b1 + b2 + b3 = 0 ->
  b1 >= b2 -> 0 < b2 -> let N := spectral b1 b2 b3 e1 e2 e3 in
  let s0 := (b1 - b2) / (b1 + b2) in let r := 3 * b2 / (b1 - b3) in
  parameter_mode s0 = sqrt (1 - mode N * mode N) /\
  parameter_mode r = - mode N /\ s0 = 3 * (1 - r) / (3 + r).
Proof.
  intros O S A B N s0 r.
  assert (B3 : b3 = - b1 - b2) by lra.
  assert (R : parameter_mode r = - mode N).
  { rewrite <- mode_opposite. unfold N. rewrite scale_spectral.
    assert (E : spectral (-1 * b1) (-1 * b2) (-1 * b3) e1 e2 e3 = of_parameter ((b1 - b3) / 6) r e3 e2 e1).
    { unfold of_parameter. rewrite (spectral_swap (-1 * b1)), spectral_rotate, spectral_swap, spectral_rotate.
      rewrite spectral_rotate. rewrite spectral_swap. unfold r. rewrite spectral_rotate.
      rewrite spectral_swap.
      replace (-1 * b3) with ((b1 - b3) / 6 * (3 + 3 * b2 / (b1 - b3))) by (rewrite B3; field; lra).
      replace (-1 * b2) with ((b1 - b3) / 6 * (-2 * (3 * b2 / (b1 - b3)))) by (rewrite B3; field; lra).
      replace (-1 * b1) with ((b1 - b3) / 6 * (3 * b2 / (b1 - b3) - 3)) by (rewrite B3; field; lra).
      unfold spectral. tensor_ring. }
    rewrite E. symmetry. apply mode_of_parameter; [lra|]. permuted_frame O. }
  split; [|split; [exact R|unfold s0, r; rewrite B3; field; split; lra]].
  assert (Sr : 0 <= s0 <= 1).
  { unfold s0. split; [apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra]|].
    apply (Rmult_le_reg_r (b1 + b2)); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  destruct (parameter_mode_sign s0 ltac:(lra)) as [k [K E]].
  assert (Pos : 0 <= parameter_mode s0) by (rewrite E; apply Rmult_le_pos; lra).
  assert (Q1 := parameter_mode_squared s0). assert (Q2 := parameter_mode_squared r).
  replace (parameter_mode r * parameter_mode r) with (mode N * mode N) in Q2 by (rewrite R; ring).
  assert (Sum : parameter_mode s0 * parameter_mode s0 = 1 - mode N * mode N).
  { set (x := parameter_mode s0 * parameter_mode s0) in *. set (y := mode N * mode N) in *.
    assert (D : 0 < b1 + b2) by lra. assert (D' : 0 < 2 * b1 + b2) by lra.
    assert (X : x = (s0 * (9 - s0 * s0)) * (s0 * (9 - s0 * s0)) / ((3 + s0 * s0) * (3 + s0 * s0) * (3 + s0 * s0))).
    { rewrite <- Q1. field. assert (H := square_nonneg s0). lra. }
    assert (Y : y = (r * (9 - r * r)) * (r * (9 - r * r)) / ((3 + r * r) * (3 + r * r) * (3 + r * r))).
    { rewrite <- Q2. field. assert (H := square_nonneg r). lra. }
    rewrite X, Y. unfold s0, r. rewrite B3. field.
    assert (0 < b1 * b1) by nra. assert (0 < b1 * b2) by nra. assert (0 < b2 * b2) by nra.
    repeat split; nra. }
  rewrite <- Sum. symmetry. apply sqrt_square, Pos.
Qed.

(* Edges: a boundary vector is across e1, e2 or e3 as alpha says; it is never across e3. *)
Theorem boundary_on_edges b1 b2 b3 e1 e2 e3 s v : orthonormal e1 e2 e3 -> b1 + b2 + b3 = 0 ->
  b1 > b2 -> b2 > 0 -> 0 <= s <= 1 -> dot v v = 1 -> let N := spectral b1 b2 b3 e1 e2 e3 in
  boundary_function N s v = 0 -> let alpha := form N v v in
  (dot v e1 = 0 <-> (1 + s) * alpha = - 2 * b1) /\
  (dot v e2 = 0 <-> (1 + s) * alpha = - 2 * b2 \/ (1 - s) * alpha = - 2 * b2) /\
  dot v e3 <> 0.
Proof.
  intros O S B12 B2 Sr V N Z alpha.
  destruct (squares_of_alpha b1 b2 b3 e1 e2 e3 s v O S B12 ltac:(lra) V Z) as [M1 [M2 M3]].
  fold N alpha in M1, M2, M3.
  assert (R : - 2 * b1 / (1 + s) <= alpha <= - 2 * b2 / (1 + s) /\ - 2 * b2 <= (1 - s) * alpha).
  { apply (range_of_alpha b1 b2 b3 e1 e2 e3 s alpha O S B12 B2 Sr). exists v. auto. }
  destruct R as [[R1 R2] R3].
  assert (C2 : (1 + s) * alpha <= - 2 * b2).
  { assert (H := Rmult_le_compat_l (1 + s) _ _ ltac:(lra) R2).
    replace ((1 + s) * (- 2 * b2 / (1 + s))) with (- 2 * b2) in H by (field; lra). exact H. }
  assert (Neg : alpha < 0).
  { apply Rnot_le_lt. intros H. assert (0 <= (1 + s) * alpha) by (apply Rmult_le_pos; lra). lra. }
  assert (Sq : forall x b c d, x * x = square_at s alpha b c d -> b - c <> 0 -> b - d <> 0 ->
    (x = 0 <-> ((1 - s) * alpha + 2 * b) * ((1 + s) * alpha + 2 * b) = 0)).
  { intros x b c d E H1 H2. assert (P : 4 * ((b - c) * (b - d)) <> 0)
      by (repeat apply Rmult_integral_contrapositive_currified; lra).
    assert (F : x * x * (4 * ((b - c) * (b - d))) = ((1 - s) * alpha + 2 * b) * ((1 + s) * alpha + 2 * b)).
    { rewrite E. unfold square_at. field. auto. }
    rewrite <- F. split; intros H; [rewrite H; ring|].
    destruct (Rmult_integral _ _ H); [apply square_zero; assumption|contradiction]. }
  unfold along in M1, M2, M3. split; [|split].
  - rewrite (Sq _ b1 b2 b3 M1) by lra. split; intros H.
    + destruct (Rmult_integral _ _ H); lra.
    + replace ((1 + s) * alpha + 2 * b1) with 0 by lra. ring.
  - rewrite (Sq _ b2 b1 b3 M2) by lra. split; intros H.
    + destruct (Rmult_integral _ _ H); [right|left]; lra.
    + destruct H; [replace ((1 + s) * alpha + 2 * b2) with 0 by lra|replace ((1 - s) * alpha + 2 * b2) with 0 by lra]; ring.
  - rewrite (Sq _ b3 b1 b2 M3) by lra. intros H.
    assert ((1 - s) * alpha <= 0) by nra. assert ((1 + s) * alpha <= 0) by nra.
    destruct (Rmult_integral _ _ H); lra.
Qed.

(* The point across e1 exists for s >= s0 only, the second one across e2 for s <= s0 only; the first
   one across e2 always does. By alpha each is one vector in an octant. *)
Theorem edges_by_mode b1 b2 b3 e1 e2 e3 s : orthonormal e1 e2 e3 -> b1 + b2 + b3 = 0 ->
  b1 > b2 -> b2 > 0 -> 0 <= s < 1 -> let N := spectral b1 b2 b3 e1 e2 e3 in
  let s0 := (b1 - b2) / (b1 + b2) in
  let at_alpha a := exists v, dot v v = 1 /\ boundary_function N s v = 0 /\ form N v v = a in
  (at_alpha (- 2 * b1 / (1 + s)) <-> s0 <= s) /\ at_alpha (- 2 * b2 / (1 + s)) /\
  (at_alpha (- 2 * b2 / (1 - s)) <-> s <= s0).
Proof.
  intros O S B12 B2 Sr N s0 at_alpha.
  assert (R := fun a => range_of_alpha b1 b2 b3 e1 e2 e3 s a O S B12 B2 ltac:(lra)). cbv zeta in R. fold N in R.
  assert (I : 0 < / (1 + s)) by (apply Rinv_0_lt_compat; lra).
  assert (I' : 0 < / (1 - s)) by (apply Rinv_0_lt_compat; lra).
  assert (S0 : s0 * (b1 + b2) = b1 - b2) by (unfold s0; field; lra).
  assert (Cmp : forall a b, a <= b -> a / (1 + s) <= b / (1 + s)).
  { intros a b H. apply Rmult_le_compat_r; lra. }
  assert (K : forall x y, x * (1 + s) <= y -> x <= y / (1 + s)).
  { intros x y H. apply (Rmult_le_reg_r (1 + s)); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  assert (K' : forall x y, x <= y * (1 + s) -> x / (1 + s) <= y).
  { intros x y H. apply (Rmult_le_reg_r (1 + s)); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
  unfold at_alpha. rewrite !R. clear R. split; [|split].
  - split; intros H.
    + destruct H as [_ H]. assert (H' := Rmult_le_compat_r (1 + s) _ _ ltac:(lra) H).
      replace ((1 - s) * (- 2 * b1 / (1 + s)) * (1 + s)) with (- 2 * b1 * (1 - s)) in H' by (field; lra).
      apply (Rmult_le_reg_r (b1 + b2)); lra.
    + split; [split; [lra|apply Cmp; lra]|].
      assert (H' := Rmult_le_compat_r (b1 + b2) _ _ ltac:(lra) H).
      replace ((1 - s) * (- 2 * b1 / (1 + s))) with (- 2 * b1 * (1 - s) / (1 + s)) by (field; lra).
      apply K. lra.
  - split; [split; [apply Cmp; lra|lra]|].
    replace ((1 - s) * (- 2 * b2 / (1 + s))) with (- 2 * b2 * (1 - s) / (1 + s)) by (field; lra).
    apply K. nra.
  - replace ((1 - s) * (- 2 * b2 / (1 - s))) with (- 2 * b2) by (field; lra).
    assert (E : - 2 * b2 / (1 - s) * (1 - s) = - 2 * b2) by (field; lra).
    set (a := - 2 * b2 / (1 - s)) in *. split; intros H.
    + destruct H as [[H _] _]. assert (H' := Rmult_le_compat_r (1 + s) _ _ ltac:(lra) H).
      replace (- 2 * b1 / (1 + s) * (1 + s)) with (- 2 * b1) in H' by (field; lra).
      assert (H2 := Rmult_le_compat_r (1 - s) _ _ ltac:(lra) H').
      assert (a * (1 + s) * (1 - s) = - 2 * b2 * (1 + s)) by (rewrite <- E; ring).
      apply (Rmult_le_reg_r (b1 + b2)); lra.
    + assert (H' := Rmult_le_compat_r (b1 + b2) _ _ ltac:(lra) H).
      assert (a < 0) by (apply Rnot_le_lt; intros G; assert (0 <= a * (1 - s)) by (apply Rmult_le_pos; lra); lra).
      split; [split|lra].
      * apply K'. apply (Rmult_le_reg_r (1 - s)); [lra|].
        replace (a * (1 + s) * (1 - s)) with (a * (1 - s) * (1 + s)) by ring. rewrite E. lra.
      * apply K. nra.
Qed.
