(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   What every certificate rests on. If no coefficient of the form `increase` is negative, and those
   of pure powers are positive, then the mode increases strictly along the direction d in the whole
   simplex, and a level of it is a graph over the lines along d: each line that meets the simplex
   meets the level once or not at all, as the modes at the two ends of the line's part in the
   simplex say, and the crossing moves continuously with the line. From each point beside the level
   the line along d leads to the boundary of the simplex without meeting the level; so no part of
   either side, and no part of the level, is away from the boundary.

   A simplex of V corners is the cone of weights that are not negative and not all zero; multiples
   of weights are the same point, with the same mode. *)
From TensorTopo Require Import Tensors Mode Polynomials Kernel ModeOnSimplex Calculus
  IncreasingFunction.
Require Import Reals Psatz Ring Field ZArith List Lia.
Import ListNotations.
Open Scope R_scope.

Definition monotone V m d :=
  all_positive V (norm_form m) = true /\ all_positive V (increase_form m d) = true.
Definition mode_at m w := mode (field m w).

Lemma field_not_zero V m w : all_positive V (norm_form m) = true -> in_cone V w -> field m w <> zero.
Proof.
  intros P C Z. assert (H := all_positive_value V _ w P C). rewrite norm_form_value, Z in H.
  unfold norm2, inner, zero in H. cbn in H. lra.
Qed.

Theorem mode_increases V m d w a b : monotone V m d -> a < b ->
  in_cone V (move w a d) -> in_cone V (move w b d) ->
  mode_at m (move w a d) < mode_at m (move w b d).
Proof.
  intros [P I] L A B.
  assert (Pos : forall c, a <= c <= b -> 0 < mode_derivative m d (move w c d)).
  { intros c C. assert (K : in_cone V (move w c d)) by (apply (between_in_cone V w d a c b); assumption).
    assert (N := field_not_zero V m _ P K). assert (S := sqrt6_positive).
    unfold mode_derivative. apply Rmult_lt_0_compat; [lra|]. apply Rdiv_lt_0_compat.
    - apply (all_positive_value V); assumption.
    - assert (0 < norm (field m (move w c d))) by (apply norm_positive; exact N).
      assert (0 < norm2 (field m (move w c d))) by (apply norm2_positive; exact N).
      repeat apply Rmult_lt_0_compat; lra. }
  apply (derivative_increases (fun t => mode_at m (move w t d))
    (fun t => mode_derivative m d (move w t d)) a b L).
  - intros c C. apply mode_derivative_value, (field_not_zero V); [exact P|].
    apply (between_in_cone V w d a c b); assumption.
  - intros c C. left. apply Pos, C.
  - intros c C. apply Pos. lra.
Qed.

(* What follows is so of all continuous functions that increase. *)
Lemma mode_increases_along V m d : monotone V m d -> increases_along V d (mode_at m).
Proof. intros M w a b. apply mode_increases, M. Qed.
Lemma mode_continuous V m d : monotone V m d ->
  forall w, in_cone V w -> continuous_at (mode_at m) w.
Proof. intros M w C. apply continuous_mode, (field_not_zero V); [apply M|exact C]. Qed.

(* On the part a..b of a line: one crossing if the level is between the modes at the ends. *)
Theorem one_crossing V m d w a b c : monotone V m d -> a <= b ->
  in_cone V (move w a d) -> in_cone V (move w b d) ->
  mode_at m (move w a d) <= c <= mode_at m (move w b d) ->
  exists! t, a <= t <= b /\ mode_at m (move w t d) = c.
Proof.
  intros M. exact (increasing_one_crossing V d _
    (mode_increases_along V m d M) (mode_continuous V m d M) w a b c).
Qed.

(* And none otherwise. *)
Theorem no_crossing V m d w a b c : monotone V m d -> a <= b ->
  in_cone V (move w a d) -> in_cone V (move w b d) ->
  c < mode_at m (move w a d) \/ mode_at m (move w b d) < c ->
  forall t, a <= t <= b -> mode_at m (move w t d) <> c.
Proof.
  intros M. exact (increasing_no_crossing V d _ (mode_increases_along V m d M) w a b c).
Qed.

(* A level is a graph. On the line along d through any point of the simplex: its part in the simplex
   is a segment a..b from boundary to boundary, with one crossing or none. *)
Theorem level_is_a_graph V m d w : monotone V m d -> length d = V ->
  (exists i, (0 < nth i d 0)%Z) -> (exists i, (nth i d 0 < 0)%Z) -> in_cone V w ->
  exists a b, a <= 0 <= b /\ on_boundary V (move w a d) /\ on_boundary V (move w b d) /\
    (forall t, a <= t <= b -> in_cone V (move w t d)) /\
    forall c,
      (mode_at m (move w a d) <= c <= mode_at m (move w b d) ->
        exists! t, a <= t <= b /\ mode_at m (move w t d) = c) /\
      (c < mode_at m (move w a d) \/ mode_at m (move w b d) < c ->
        forall t, a <= t <= b -> mode_at m (move w t d) <> c).
Proof.
  intros M. exact (increasing_graph V d _
    (mode_increases_along V m d M) (mode_continuous V m d M) w).
Qed.

(* The sides of the level reach the boundary: from a point below, the line against d leads to the
   boundary through points below; from a point above, the line along d through points above. *)
Theorem sides_reach_the_boundary V m d w c : monotone V m d -> length d = V ->
  (exists i, (0 < nth i d 0)%Z) -> (exists i, (nth i d 0 < 0)%Z) -> in_cone V w ->
  (mode_at m w < c -> exists a, a <= 0 /\ on_boundary V (move w a d) /\ forall t, a <= t <= 0 ->
    in_cone V (move w t d) /\ mode_at m (move w t d) < c) /\
  (c < mode_at m w -> exists b, 0 <= b /\ on_boundary V (move w b d) /\ forall t, 0 <= t <= b ->
    in_cone V (move w t d) /\ c < mode_at m (move w t d)).
Proof.
  intros M. exact (increasing_sides V d _
    (mode_increases_along V m d M) (mode_continuous V m d M) w c).
Qed.

(* The crossing is a continuous function of the line: if w is on the level c and the line goes on by
   eps on both sides, then lines close to it cross the level within eps of their points close to w,
   and once only. *)
Theorem crossing_is_continuous V m d w c eps : monotone V m d -> 0 < eps -> in_cone V w ->
  mode_at m (move w 0 d) = c -> in_cone V (move w (- eps) d) -> in_cone V (move w eps d) ->
  exists delta, 0 < delta /\ forall w', close delta w w' ->
    in_cone V (move w' (- eps) d) -> in_cone V (move w' eps d) ->
    exists! t, - eps <= t <= eps /\ mode_at m (move w' t d) = c.
Proof.
  intros M. exact (increasing_continuous_crossing V d _
    (mode_increases_along V m d M) (mode_continuous V m d M) w c eps).
Qed.
