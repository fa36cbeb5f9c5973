(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   Lemma 4. Let b1 > b2 > 0 > b3 be the eigenvalues of the characteristic tensor, on e1, e2, e3. On
   the boundary alpha = v.N v determines the squares of v's coordinates, so v in each octant; and it
   takes the values of one closed interval. If b1 = b2 it has one value. *)
From TensorTopo Require Import Tensors Frames Mode MediumEigenvector CharacteristicFrame.
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

(* The square along the eigenvector of b, where the other eigenvalues are c and d. *)
Definition square_at s alpha b c d :=
  ((1 - s) * alpha + 2 * b) * ((1 + s) * alpha + 2 * b) / (4 * ((b - c) * (b - d))).

Theorem squares_of_alpha b1 b2 b3 e1 e2 e3 s v : orthonormal e1 e2 e3 -> b1 + b2 + b3 = 0 ->
  b1 > b2 -> b2 > b3 -> dot v v = 1 -> let N := spectral b1 b2 b3 e1 e2 e3 in
  boundary_function N s v = 0 -> let alpha := form N v v in
  along e1 v = square_at s alpha b1 b2 b3 /\ along e2 v = square_at s alpha b2 b1 b3 /\
  along e3 v = square_at s alpha b3 b1 b2.
Proof.
  intros O S B12 B23 V N Z alpha. unfold alpha, N in *.
  rewrite (boundary_spectral _ _ _ _ _ _ O) in Z. rewrite (alpha_spectral _ _ _ _ _ _).
  assert (W := along_sum e1 e2 e3 O v V).
  set (m1 := along e1 v) in *. set (m2 := along e2 v) in *. set (m3 := along e3 v) in *.
  set (a := b1 * m1 + b2 * m2 + b3 * m3) in *.
  (* three linear equations: sum m = 1, sum b m = a, sum b^2 m = beta *)
  assert (Beta : b1 * b1 * m1 + b2 * b2 * m2 + b3 * b3 * m3
    = (b1 * b1 + b2 * b2 + b3 * b3) / 2 + (1 - s * s) * (a * a) / 4) by lra.
  assert (L : forall b c d m n k, b + c + d = 0 -> m + n + k = 1 -> b * m + c * n + d * k = a ->
    b * b * m + c * c * n + d * d * k = (b * b + c * c + d * d) / 2 + (1 - s * s) * (a * a) / 4 ->
    b - c <> 0 -> b - d <> 0 -> m = square_at s a b c d).
  { intros b c d m n k H1 H2 H3 H4 N1 N2. unfold square_at.
    assert (E : 4 * ((b - c) * (b - d)) * m = ((1 - s) * a + 2 * b) * ((1 + s) * a + 2 * b)).
    { transitivity (4 * ((b * b * m + c * c * n + d * d * k) - (c + d) * (b * m + c * n + d * k) + c * d * (m + n + k)));
        [ring|]. rewrite H2, H3, H4. replace d with (- b - c) by lra. field. }
    rewrite <- E. field. auto. }
  split; [|split].
  - apply (L b1 b2 b3 m1 m2 m3); (lra || (unfold a; lra)).
  - apply (L b2 b1 b3 m2 m1 m3); (lra || (unfold a; lra)).
  - apply (L b3 b1 b2 m3 m1 m2); (lra || (unfold a; lra)).
Qed.

Theorem range_of_alpha b1 b2 b3 e1 e2 e3 s alpha : orthonormal e1 e2 e3 -> b1 + b2 + b3 = 0 ->
  b1 > b2 -> b2 > 0 -> 0 <= s <= 1 -> let N := spectral b1 b2 b3 e1 e2 e3 in
  (exists v, dot v v = 1 /\ boundary_function N s v = 0 /\ form N v v = alpha) <->
  - 2 * b1 / (1 + s) <= alpha <= - 2 * b2 / (1 + s) /\ - 2 * b2 <= (1 - s) * alpha.
Proof.
  intros O S B12 B2 Sr N.
  assert (D1 : 0 < (b1 - b2) * (b1 - b3)) by (apply Rmult_lt_0_compat; lra).
  assert (D2 : 0 < (b1 - b2) * (b2 - b3)) by (apply Rmult_lt_0_compat; lra).
  assert (D3 : 0 < (b1 - b3) * (b2 - b3)) by (apply Rmult_lt_0_compat; lra).
  assert (Up : forall b, alpha <= - 2 * b / (1 + s) <-> (1 + s) * alpha + 2 * b <= 0).
  { intros b. assert (E : (1 + s) * (- 2 * b / (1 + s)) = - 2 * b) by (field; lra). split; intros H.
    - assert ((1 + s) * alpha <= (1 + s) * (- 2 * b / (1 + s))) by (apply Rmult_le_compat_l; lra). lra.
    - apply (Rmult_le_reg_l (1 + s)); lra. }
  assert (Lo : forall b, - 2 * b / (1 + s) <= alpha <-> 0 <= (1 + s) * alpha + 2 * b).
  { intros b. assert (E : (1 + s) * (- 2 * b / (1 + s)) = - 2 * b) by (field; lra). split; intros H.
    - assert ((1 + s) * (- 2 * b / (1 + s)) <= (1 + s) * alpha) by (apply Rmult_le_compat_l; lra). lra.
    - apply (Rmult_le_reg_l (1 + s)); lra. }
  rewrite (Up b2), (Lo b1). split.
  - intros [v [V [Z A]]].
    destruct (squares_of_alpha b1 b2 b3 e1 e2 e3 s v O S B12 ltac:(lra) V Z) as [M1 [M2 _]].
    fold N in M1, M2. rewrite A in M1, M2.
    assert (P1 := along_nonneg e1 v). assert (P2 := along_nonneg e2 v). rewrite M1 in P1. rewrite M2 in P2.
    unfold square_at in P1, P2.
    assert (Q1 : 0 <= ((1 - s) * alpha + 2 * b1) * ((1 + s) * alpha + 2 * b1)).
    { replace (_ * _) with (((1 - s) * alpha + 2 * b1) * ((1 + s) * alpha + 2 * b1) / (4 * ((b1 - b2) * (b1 - b3))) * (4 * ((b1 - b2) * (b1 - b3)))) by (field; split; lra).
      apply Rmult_le_pos; lra. }
    assert (Q2 : ((1 - s) * alpha + 2 * b2) * ((1 + s) * alpha + 2 * b2) <= 0).
    { assert (0 <= ((1 - s) * alpha + 2 * b2) * ((1 + s) * alpha + 2 * b2) / (4 * ((b2 - b1) * (b2 - b3))) * (4 * ((b1 - b2) * (b2 - b3)))) by (apply Rmult_le_pos; lra).
      replace (_ / _ * _) with (- (((1 - s) * alpha + 2 * b2) * ((1 + s) * alpha + 2 * b2))) in H by (field; split; lra).
      lra. }
    assert (Neg : alpha < 0).
    { apply Rnot_le_lt. intros H. assert (0 <= (1 - s) * alpha) by (apply Rmult_le_pos; lra).
      assert (0 <= (1 + s) * alpha) by (apply Rmult_le_pos; lra).
      assert (0 < ((1 - s) * alpha + 2 * b2) * ((1 + s) * alpha + 2 * b2)) by (apply Rmult_lt_0_compat; lra). lra. }
    assert (Or : (1 + s) * alpha <= (1 - s) * alpha) by nra.
    assert (C1 : (1 + s) * alpha + 2 * b2 <= 0) by (apply Rnot_lt_le; intros H; assert (0 < ((1 - s) * alpha + 2 * b2) * ((1 + s) * alpha + 2 * b2)) by (apply Rmult_lt_0_compat; lra); lra).
    assert (C2 : 0 <= (1 - s) * alpha + 2 * b2).
    { apply Rnot_lt_le. intros H.
      assert (0 < (- ((1 - s) * alpha + 2 * b2)) * (- ((1 + s) * alpha + 2 * b2))) by (apply Rmult_lt_0_compat; lra). lra. }
    assert (C3 : 0 <= (1 + s) * alpha + 2 * b1).
    { apply Rnot_lt_le. intros H.
      assert (0 < ((1 - s) * alpha + 2 * b1) * (- ((1 + s) * alpha + 2 * b1))) by (apply Rmult_lt_0_compat; lra). lra. }
    lra.
  - intros [[C3 C1] C2].
    assert (Neg : alpha < 0) by (apply Rnot_le_lt; intros H; assert (0 <= (1 + s) * alpha) by (apply Rmult_le_pos; lra); lra).
    assert (X : forall x d, 0 <= x -> 0 < d -> 0 <= x / (4 * d)).
    { intros x d Hx Hd. apply Rmult_le_pos; [exact Hx|left; apply Rinv_0_lt_compat; lra]. }
    destruct (vector_of_squares e1 e2 e3 O (square_at s alpha b1 b2 b3) (square_at s alpha b2 b1 b3) (square_at s alpha b3 b1 b2))
      as [v [V [V1 [V2 V3]]]].
    + apply X; [apply Rmult_le_pos; lra|exact D1].
    + unfold square_at. replace (_ / _) with (((1 - s) * alpha + 2 * b2) * (- ((1 + s) * alpha + 2 * b2)) / (4 * ((b1 - b2) * (b2 - b3)))) by (field; split; lra).
      apply X; [apply Rmult_le_pos; lra|exact D2].
    + unfold square_at. replace (_ / _) with ((- ((1 - s) * alpha + 2 * b3)) * (- ((1 + s) * alpha + 2 * b3)) / (4 * ((b1 - b3) * (b2 - b3)))) by (field; split; lra).
      apply X; [apply Rmult_le_pos|exact D3].
      * assert ((1 - s) * alpha <= 0) by nra. lra.
      * assert ((1 + s) * alpha <= 0) by nra. lra.
    + unfold square_at. replace b3 with (- b1 - b2) in * by lra. field. repeat split; lra.
    + exists v. split; [exact V|]. unfold N. rewrite (boundary_spectral _ _ _ _ _ _ O), alpha_spectral, V1, V2, V3.
      unfold square_at. replace b3 with (- b1 - b2) in * by lra. split; field; repeat split; lra.
Qed.

Theorem alpha_is_constant b e1 e2 e3 s v : orthonormal e1 e2 e3 -> 0 < b -> 0 <= s <= 1 ->
  dot v v = 1 -> let N := spectral b b (- 2 * b) e1 e2 e3 in
  boundary_function N s v = 0 -> form N v v = - 2 * b / (1 + s).
Proof.
  intros O B S V N Z. unfold N in *. rewrite (boundary_spectral _ _ _ _ _ _ O) in Z.
  rewrite alpha_spectral. assert (W := along_sum e1 e2 e3 O v V).
  assert (P1 := along_nonneg e1 v). assert (P2 := along_nonneg e2 v). assert (P3 := along_nonneg e3 v).
  set (m1 := along e1 v) in *. set (m2 := along e2 v) in *. set (m3 := along e3 v) in *.
  set (a := 1 - 3 * m3).
  assert (A : b * m1 + b * m2 + - 2 * b * m3 = b * a) by (unfold a; replace m1 with (1 - m2 - m3) by lra; ring).
  rewrite A in *.
  assert (Q : b * b * (((1 - s) * a + 2) * ((1 + s) * a + 2)) = 0).
  { transitivity (4 * ((b * b + b * b + - 2 * b * (- 2 * b)) / 2 - (b * b * m1 + b * b * m2 + - 2 * b * (- 2 * b) * m3) + (1 - s * s) * (b * a * (b * a)) / 4)).
    - replace m1 with (1 - m2 - m3) by lra. unfold a. field.
    - rewrite Z. ring. }
  destruct (Rmult_integral _ _ Q) as [Q1|Q1]; [assert (0 < b * b) by nra; lra|].
  assert (R : (1 + s) * a + 2 = 0).
  { destruct (Rmult_integral _ _ Q1) as [Q2|Q2]; [|exact Q2].
    assert (Low : -2 <= a) by (unfold a; lra).
    assert (sa : s * a = a + 2) by lra. nra. }
  assert (E : a = - 2 / (1 + s)) by (apply (Rmult_eq_reg_l (1 + s)); [transitivity (-2); [lra|field; lra]|lra]).
  rewrite E. field. lra.
Qed.
