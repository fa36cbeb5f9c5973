(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   A continuous function on a simplex that increases strictly along a direction d: the sets where
   it has one value are graphs over the lines along d. Each line meets such a set once or not at all,
   as the function's values at the ends of the line's part in the simplex say; the crossing moves
   continuously with the line; and both sides reach the boundary. *)
From TensorTopo Require Import Polynomials ModeOnSimplex.
Require Import Reals Psatz Ring Field ZArith List Lia.
Import ListNotations.
Open Scope R_scope.

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

(* The weights of a line depend continuously on its parameter. *)
Lemma entries_bounded d : exists k, 0 < k /\ forall i, Rabs (IZR (nth i d 0%Z)) <= k.
Proof.
  induction d as [|z d [k [K B]]].
  - exists 1. split; [lra|]. intros i. destruct i; cbn [nth]; rewrite Rabs_R0; lra.
  - exists (Rmax k (Rabs (IZR z))). split; [apply Rlt_le_trans with k; [exact K|apply Rmax_l]|].
    intros [|i]; [apply Rmax_r|]. apply Rle_trans with k; [apply B|apply Rmax_l].
Qed.
Lemma close_on_line w d t r : 0 < r -> exists e, 0 < e /\ forall s, Rabs (s - t) < e ->
  close r (move w t d) (move w s d).
Proof.
  intros P. destruct (entries_bounded d) as [k [K B]]. exists (r / k).
  split; [apply Rdiv_lt_0_compat; assumption|]. intros s S i. rewrite !move_nth.
  replace (_ - _) with ((s - t) * IZR (nth i d 0%Z)) by ring. rewrite Rabs_mult.
  apply Rle_lt_trans with (Rabs (s - t) * k).
  - apply Rmult_le_compat_l; [apply Rabs_pos|apply B].
  - replace r with (r / k * k) by (field; lra). apply Rmult_lt_compat_r; assumption.
Qed.
Lemma close_lines w w' d t r : close r w w' -> close r (move w t d) (move w' t d).
Proof.
  intros H i. rewrite !move_nth. replace (_ - _) with (nth i w' 0 - nth i w 0) by ring. apply H.
Qed.
Lemma value_at_start f w d : continuous_at f w -> f (move w 0 d) = f w.
Proof.
  intros C. destruct (Req_dec (f (move w 0 d)) (f w)) as [E|E]; [exact E|exfalso].
  assert (P : 0 < Rabs (f (move w 0 d) - f w)) by (apply Rabs_pos_lt; lra).
  destruct (C _ P) as [r [R H]]. assert (X := H (move w 0 d)). apply Rlt_irrefl in X; [exact X|].
  intros i. rewrite move_nth, Rmult_0_l, Rplus_0_r, Rminus_diag_eq, Rabs_R0; auto.
Qed.

Definition increases_along V d (f : list R -> R) := forall w a b, a < b ->
  in_cone V (move w a d) -> in_cone V (move w b d) -> f (move w a d) < f (move w b d).

Section Increasing.
Variables (V : nat) (d : list Z) (f : list R -> R).
Hypothesis Increases : increases_along V d f.
Hypothesis Continuous : forall w, in_cone V w -> continuous_at f w.

(* On the part a..b of a line: one crossing if c is between the values at the ends. *)
Lemma increasing_one_crossing w a b c : a <= b ->
  in_cone V (move w a d) -> in_cone V (move w b d) -> f (move w a d) <= c <= f (move w b d) ->
  exists! t, a <= t <= b /\ f (move w t d) = c.
Proof.
  intros L A B [C1 C2]. set (g := fun t => f (move w t d)).
  assert (In : forall t, a <= t <= b -> in_cone V (move w t d))
    by (intros t T; apply (between_in_cone V w d a t b); assumption).
  assert (U : forall s t, a <= s <= b -> a <= t <= b -> g s = g t -> s = t).
  { intros s t S T E. destruct (Rtotal_order s t) as [H|[H|H]]; [|exact H|].
    - assert (X := Increases w s t H (In s S) (In t T)). fold (g s) (g t) in X. lra.
    - assert (X := Increases w t s H (In t T) (In s S)). fold (g s) (g t) in X. lra. }
  assert (X : exists t, a <= t <= b /\ g t = c).
  { destruct C1 as [C1|C1]; [|exists a; split; [lra|exact C1]].
    destruct C2 as [C2|C2]; [|exists b; split; [lra|symmetry; exact C2]].
    assert (AB : a < b) by (destruct L; [assumption|subst; lra]).
    destruct (Ranalysis5.IVT_interv (fun t => g t - c) a b) as [t [T E]]; try (unfold g; lra).
    - intros t T eps E. destruct (Continuous _ (In t T) eps E) as [r [R1 R2]].
      destruct (close_on_line w d t r R1) as [e [E1 E2]]. exists e. split; [exact E1|].
      intros s [_ S]. cbn. unfold R_dist, g. replace (_ - _) with (f (move w s d) - f (move w t d)) by ring.
      apply R2, E2, S.
    - exists t. split; [exact T|]. cbv beta in E. lra. }
  destruct X as [t [T E]]. exists t. split; [split; assumption|].
  intros s [S F]. apply U; auto. unfold g. rewrite F. exact E.
Qed.

(* And none otherwise. *)
Lemma increasing_no_crossing w a b c : a <= b -> in_cone V (move w a d) -> in_cone V (move w b d) ->
  c < f (move w a d) \/ f (move w b d) < c -> forall t, a <= t <= b -> f (move w t d) <> c.
Proof.
  intros L A B C t T E.
  assert (K : in_cone V (move w t d)) by (apply (between_in_cone V w d a t b); assumption).
  destruct C as [C|C].
  - destruct T as [[T|T] T2]; [|subst; lra]. assert (H := Increases w a t T A K). lra.
  - destruct T as [T1 [T|T]]; [|subst; lra]. assert (H := Increases w t b T K B). lra.
Qed.

(* The part of a line in the simplex is a segment a..b from boundary to boundary, with one crossing
   or none. *)
Lemma increasing_graph w : length d = V ->
  (exists i, (0 < nth i d 0)%Z) -> (exists i, (nth i d 0 < 0)%Z) -> in_cone V w ->
  exists a b, a <= 0 <= b /\ on_boundary V (move w a d) /\ on_boundary V (move w b d) /\
    (forall t, a <= t <= b -> in_cone V (move w t d)) /\
    forall c,
      (f (move w a d) <= c <= f (move w b d) -> exists! t, a <= t <= b /\ f (move w t d) = c) /\
      (c < f (move w a d) \/ f (move w b d) < c -> forall t, a <= t <= b -> f (move w t d) <> c).
Proof.
  intros D P N C. destruct (segment V d w D P N C) as [a [b [O [A [A' [B B']]]]]].
  exists a, b. split; [exact O|]. split; [exact A'|]. split; [exact B'|].
  split; [intros t T; apply (between_in_cone V w d a t b); assumption|].
  intros c. split; [apply increasing_one_crossing|apply increasing_no_crossing]; auto; lra.
Qed.

(* From a point below, the line against d leads to the boundary through points below; from a point
   above, the line along d through points above. *)
Lemma increasing_sides w c : length d = V ->
  (exists i, (0 < nth i d 0)%Z) -> (exists i, (nth i d 0 < 0)%Z) -> in_cone V w ->
  (f w < c -> exists a, a <= 0 /\ on_boundary V (move w a d) /\ forall t, a <= t <= 0 ->
    in_cone V (move w t d) /\ f (move w t d) < c) /\
  (c < f w -> exists b, 0 <= b /\ on_boundary V (move w b d) /\ forall t, 0 <= t <= b ->
    in_cone V (move w t d) /\ c < f (move w t d)).
Proof.
  intros D P N C. destruct (segment V d w D P N C) as [a [b [O [A [A' [B B']]]]]].
  assert (I : forall t, a <= t <= b -> in_cone V (move w t d))
    by (intros t T; apply (between_in_cone V w d a t b); assumption).
  rewrite <- (value_at_start f w d) by (apply Continuous, C). split; intros H.
  - exists a. split; [lra|]. split; [exact A'|]. intros t T. split; [apply I; lra|].
    destruct T as [T1 [T|T]]; [|subst; exact H].
    assert (L := Increases w t 0 T (I t ltac:(lra)) (I 0 ltac:(lra))). lra.
  - exists b. split; [lra|]. split; [exact B'|]. intros t T. split; [apply I; lra|].
    destruct T as [[T|T] T2]; [|subst; exact H].
    assert (L := Increases w 0 t T (I 0 ltac:(lra)) (I t ltac:(lra))). lra.
Qed.

(* If f is c at w and the line goes on by eps on both sides, then lines close to it have a point of
   the value c within eps of their points close to w, and one only. *)
Lemma increasing_continuous_crossing w c eps : 0 < eps -> in_cone V w ->
  f (move w 0 d) = c -> in_cone V (move w (- eps) d) -> in_cone V (move w eps d) ->
  exists delta, 0 < delta /\ forall w', close delta w w' ->
    in_cone V (move w' (- eps) d) -> in_cone V (move w' eps d) ->
    exists! t, - eps <= t <= eps /\ f (move w' t d) = c.
Proof.
  intros E C Z A B.
  assert (C0 : in_cone V (move w 0 d)) by (rewrite move_zero; exact C).
  assert (LA := Increases w (- eps) 0 ltac:(lra) A C0).
  assert (LB := Increases w 0 eps ltac:(lra) C0 B).
  rewrite Z in LA, LB.
  destruct (Continuous _ A (c - f (move w (- eps) d)) ltac:(lra)) as [d1 [D1 H1]].
  destruct (Continuous _ B (f (move w eps d) - c) ltac:(lra)) as [d2 [D2 H2]].
  exists (Rmin d1 d2). split; [apply Rmin_glb_lt; assumption|]. intros w' H A1 B1.
  assert (Y1 : Rabs (f (move w' (- eps) d) - f (move w (- eps) d)) < c - f (move w (- eps) d)).
  { apply H1, close_lines. intros i. assert (T := H i). assert (U := Rmin_l d1 d2). lra. }
  assert (Y2 : Rabs (f (move w' eps d) - f (move w eps d)) < f (move w eps d) - c).
  { apply H2, close_lines. intros i. assert (T := H i). assert (U := Rmin_r d1 d2). lra. }
  apply Rabs_def2 in Y1. apply Rabs_def2 in Y2.
  apply increasing_one_crossing; auto; lra.
Qed.
End Increasing.
