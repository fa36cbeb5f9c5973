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
From TensorTopo Require Import Tensors Mode Polynomials Kernel ModeOnSimplex Calculus.
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

(* On the part a..b of a line: one crossing if the level is between the modes at the ends. *)
Theorem one_crossing V m d w a b c : monotone V m d -> a <= b ->
  in_cone V (move w a d) -> in_cone V (move w b d) ->
  mode_at m (move w a d) <= c <= mode_at m (move w b d) ->
  exists! t, a <= t <= b /\ mode_at m (move w t d) = c.
Proof.
  intros M L A B [C1 C2]. set (g := fun t => mode_at m (move w t d)).
  assert (U : forall s t, a <= s <= b -> a <= t <= b -> g s = g t -> s = t).
  { assert (W : forall s t, a <= s -> s < t -> t <= b -> g s < g t).
    { intros s t H1 H2 H3. apply (mode_increases V); auto;
        apply (between_in_cone V w d a _ b); auto; lra. }
    intros s t S T E. destruct (Rtotal_order s t) as [H|[H|H]]; [|exact H|].
    - assert (X := W s t). lra.
    - assert (X := W t s). lra. }
  assert (X : exists t, a <= t <= b /\ g t = c).
  { destruct C1 as [C1|C1]; [|exists a; split; [lra|exact C1]].
    destruct C2 as [C2|C2]; [|exists b; split; [lra|symmetry; exact C2]].
    assert (AB : a < b) by (destruct L; [assumption|subst; lra]).
    destruct (Ranalysis5.IVT_interv (fun t => g t - c) a b) as [t [T E]]; try (unfold g; lra).
    - intros t T. apply derivable_continuous_pt.
      assert (N : field m (move w t d) <> zero).
      { apply (field_not_zero V); [apply M|]. apply (between_in_cone V w d a t b); assumption. }
      exists (mode_derivative m d (move w t d) - 0). apply derivable_pt_lim_minus.
      + apply mode_derivative_value, N.
      + apply derivable_pt_lim_const.
    - exists t. split; [exact T|]. cbv beta in E. lra. }
  destruct X as [t [T E]]. exists t. split; [split; assumption|].
  intros s [S F]. apply U; auto. unfold g. rewrite F. exact E.
Qed.

(* And none otherwise. *)
Theorem no_crossing V m d w a b c : monotone V m d -> a <= b ->
  in_cone V (move w a d) -> in_cone V (move w b d) ->
  c < mode_at m (move w a d) \/ mode_at m (move w b d) < c ->
  forall t, a <= t <= b -> mode_at m (move w t d) <> c.
Proof.
  intros M L A B C t T E.
  assert (K : in_cone V (move w t d)) by (apply (between_in_cone V w d a t b); assumption).
  destruct C as [C|C].
  - destruct T as [[T|T] T2]; [|subst; lra]. assert (H := mode_increases V m d w a t M T A K). lra.
  - destruct T as [T1 [T|T]]; [|subst; lra]. assert (H := mode_increases V m d w t b M T K B). lra.
Qed.

(* A ray along a direction with a negative entry leaves the cone through its boundary. *)
Lemma exit w d : (forall i, 0 <= nth i w 0) -> (exists i, (nth i d 0 < 0)%Z) ->
  exists t, 0 <= t /\ (forall i, 0 <= nth i (move w t d) 0) /\
    exists i, (nth i d 0 < 0)%Z /\ nth i (move w t d) 0 = 0.
Proof.
  intros W [i0 I].
  (* The first exit among the first n entries, or none of these is negative. *)
  assert (H : forall n, (forall i, (i < n)%nat -> (0 <= nth i d 0)%Z) \/ exists t j, 0 <= t /\
    (nth j d 0 < 0)%Z /\ nth j w 0 + t * IZR (nth j d 0%Z) = 0 /\
    forall i, (i < n)%nat -> 0 <= nth i w 0 + t * IZR (nth i d 0%Z)).
  { induction n as [|n IH]; [left; intros; lia|].
    destruct (Z.lt_ge_cases (nth n d 0%Z) 0) as [N|N].
    - assert (N' : IZR (nth n d 0%Z) < 0) by (apply (IZR_lt _ 0); exact N).
      set (u := nth n w 0 / - IZR (nth n d 0%Z)).
      assert (U : 0 <= u).
      { unfold u, Rdiv. apply Rmult_le_pos; [apply W|].
        left. apply Rinv_0_lt_compat. lra. }
      assert (E : nth n w 0 + u * IZR (nth n d 0%Z) = 0) by (unfold u; field; lra).
      right. destruct IH as [IH|[t [j [T [J [Z K]]]]]].
      + exists u, n. repeat split; auto. intros i L. destruct (Nat.eq_dec i n) as [->|Ne]; [lra|].
        assert (0 <= IZR (nth i d 0%Z)) by (apply (IZR_le 0), IH; lia).
        assert (X := W i). assert (0 <= u * IZR (nth i d 0%Z)) by (apply Rmult_le_pos; assumption). lra.
      + destruct (Rle_dec t u) as [TU|TU].
        * exists t, j. repeat split; auto. intros i L. destruct (Nat.eq_dec i n) as [->|Ne]; [nra|].
          apply K. lia.
        * exists u, n. repeat split; auto. intros i L. destruct (Nat.eq_dec i n) as [->|Ne]; [lra|].
          assert (X := W i). assert (Y := K i ltac:(lia)).
          destruct (Rle_dec 0 (IZR (nth i d 0%Z))); nra.
    - destruct IH as [IH|[t [j [T [J [Z K]]]]]].
      + left. intros i L. destruct (Nat.eq_dec i n) as [->|Ne]; [exact N|apply IH; lia].
      + right. exists t, j. repeat split; auto. intros i L.
        destruct (Nat.eq_dec i n) as [->|Ne]; [|apply K; lia].
        apply (IZR_le 0) in N. assert (X := W n).
        assert (0 <= t * IZR (nth n d 0%Z)) by (apply Rmult_le_pos; assumption). lra. }
  destruct (H (S (max i0 (max (length w) (length d))))) as [B|[t [j [T [J [Z K]]]]]].
  - assert (X := B i0 ltac:(lia)). lia.
  - exists t. split; [exact T|]. split.
    + intros i. rewrite move_nth. destruct (Nat.lt_ge_cases i (S (max i0 (max (length w) (length d))))) as [L|L].
      * apply K, L.
      * rewrite nth_overflow, nth_overflow by lia. lra.
    + exists j. rewrite move_nth. auto.
Qed.

Definition on_boundary V w := exists i, (i < V)%nat /\ nth i w 0 = 0.

Lemma nth_opp i d : nth i (map Z.opp d) 0%Z = (- nth i d 0)%Z.
Proof. exact (map_nth Z.opp d 0%Z i). Qed.

(* The part of a line in the simplex is a segment, from boundary to boundary. *)
Lemma segment V d w : length d = V -> (exists i, (0 < nth i d 0)%Z) -> (exists i, (nth i d 0 < 0)%Z) ->
  in_cone V w -> exists a b, a <= 0 <= b /\
    in_cone V (move w a d) /\ on_boundary V (move w a d) /\
    in_cone V (move w b d) /\ on_boundary V (move w b d).
Proof.
  intros D [p P] [n N] C. assert (C' := C). rewrite cone_nth in C'. destruct C' as [W [i0 [I0 X0]]].
  assert (Len : forall j, nth j d 0%Z <> 0%Z -> (j < V)%nat).
  { intros j J. destruct (Nat.lt_ge_cases j V) as [L|L]; [exact L|]. destruct J.
    apply nth_overflow. lia. }
  destruct (exit w d W (ex_intro _ n N)) as [b [B1 [B2 [j [J1 J2]]]]].
  destruct (exit w (map Z.opp d) W) as [a [A1 [A2 [k [K1 K2]]]]].
  { exists p. rewrite nth_opp. lia. }
  exists (- a), b. split; [lra|].
  assert (E : forall i, nth i (move w a (map Z.opp d)) 0 = nth i (move w (- a) d) 0).
  { intros i. rewrite !move_nth, nth_opp, opp_IZR. ring. }
  assert (In : forall t, (forall i, 0 <= nth i (move w t d) 0) ->
    (t <> 0 -> exists i, (i < V)%nat /\ 0 < nth i (move w t d) 0) -> in_cone V (move w t d)).
  { intros t T1 T2. destruct (Req_dec t 0) as [Z|Z]; [subst t; rewrite move_zero; exact C|].
    rewrite cone_nth. auto. }
  split; [|split; [|split]].
  - apply In; [intros i; rewrite <- E; apply A2|]. intros Z. exists n. split; [apply Len; lia|].
    rewrite move_nth. apply IZR_lt in N. assert (X := W n).
    assert (0 < a * - IZR (nth n d 0%Z)) by (apply Rmult_lt_0_compat; lra). lra.
  - exists k. rewrite nth_opp in K1. rewrite <- E. split; [apply Len; lia|exact K2].
  - apply In; [exact B2|]. intros Z. exists p. split; [apply Len; lia|].
    rewrite move_nth. apply IZR_lt in P. assert (X := W p).
    assert (0 < b * IZR (nth p d 0%Z)) by (apply Rmult_lt_0_compat; lra). lra.
  - exists j. split; [apply Len; lia|exact J2].
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
  intros M D P N C. destruct (segment V d w D P N C) as [a [b [O [A [A' [B B']]]]]].
  exists a, b. split; [exact O|]. split; [exact A'|]. split; [exact B'|].
  split; [intros t T; apply (between_in_cone V w d a t b); assumption|].
  intros c. split.
  - apply one_crossing with V; auto. lra.
  - apply no_crossing with V; auto. lra.
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
  intros M D P N C. destruct (segment V d w D P N C) as [a [b [O [A [A' [B B']]]]]].
  assert (I : forall t, a <= t <= b -> in_cone V (move w t d))
    by (intros t T; apply (between_in_cone V w d a t b); assumption).
  assert (Z : mode_at m (move w 0 d) = mode_at m w).
  { unfold mode_at. f_equal. rewrite !field_entries.
    assert (S : forall cs, weighted_sum cs (move w 0 d) = weighted_sum cs w).
    { intros cs. clear. revert w d. induction cs as [|z cs IH]; intros w d; cbn; [reflexivity|].
      destruct d as [|y d]; cbn; [reflexivity|]. rewrite IH. ring. }
    rewrite !S. reflexivity. }
  split; intros H.
  - exists a. split; [lra|]. split; [exact A'|]. intros t T. split; [apply I; lra|].
    destruct T as [T1 [T|T]]; [|subst; lra].
    assert (L := mode_increases V m d w t 0 M T (I t ltac:(lra)) (I 0 ltac:(lra))). lra.
  - exists b. split; [lra|]. split; [exact B'|]. intros t T. split; [apply I; lra|].
    destruct T as [[T|T] T2]; [|subst; lra].
    assert (L := mode_increases V m d w 0 t M T (I 0 ltac:(lra)) (I t ltac:(lra))). lra.
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
  intros M E C Z A B.
  assert (C0 : in_cone V (move w 0 d)) by (rewrite move_zero; exact C).
  assert (LA := mode_increases V m d w (- eps) 0 M ltac:(lra) A C0).
  assert (LB := mode_increases V m d w 0 eps M ltac:(lra) C0 B).
  rewrite Z in LA, LB.
  assert (K : forall t, in_cone V (move w t d) -> continuous_at (mode_at m) (move w t d)).
  { intros t T. apply continuous_mode, (field_not_zero V); [apply M|exact T]. }
  destruct (K (- eps) A (c - mode_at m (move w (- eps) d)) ltac:(lra)) as [d1 [D1 H1]].
  destruct (K eps B (mode_at m (move w eps d) - c) ltac:(lra)) as [d2 [D2 H2]].
  assert (S : forall t w' r, close r w w' -> close r (move w t d) (move w' t d)).
  { intros t w' r H i. rewrite !move_nth. replace (_ - _) with (nth i w' 0 - nth i w 0) by ring.
    apply H. }
  exists (Rmin d1 d2). split; [apply Rmin_glb_lt; assumption|]. intros w' H A1 B1.
  assert (X1 := H1 (move w' (- eps) d)). assert (X2 := H2 (move w' eps d)).
  assert (Y1 : Rabs (mode_at m (move w' (- eps) d) - mode_at m (move w (- eps) d))
    < c - mode_at m (move w (- eps) d)).
  { apply X1, S. intros i. assert (T := H i). assert (U := Rmin_l d1 d2). lra. }
  assert (Y2 : Rabs (mode_at m (move w' eps d) - mode_at m (move w eps d))
    < mode_at m (move w eps d) - c).
  { apply X2, S. intros i. assert (T := H i). assert (U := Rmin_r d1 d2). lra. }
  apply Rabs_def2 in Y1. apply Rabs_def2 in Y2.
  apply one_crossing with V; auto; lra.
Qed.
