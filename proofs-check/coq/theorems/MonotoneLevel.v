(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   A simplex in which one level of the mode, mu = num / den, is a graph, though others may not be.
   The function h = den Q - num P sqrt(P/54) of P = tr(M^2) and Q = det(M) has the sign of the mode
   less mu. Its derivative along d, den dQ - (3/2) num sqrt(P/54) dP, is affine in the root, so it is
   positive if it is with a number below and with one above in the place of the root. For both there
   are linear forms in the weights: above by convexity of the norm, below by Cauchy's inequality.
   With them the derivative is a quadratic form, positive by its coefficients. Then h increases along
   d in the simplex, and so do the functions of all levels close to mu. *)
From TensorTopo Require Import Tensors Mode Polynomials Kernel ModeOnSimplex IncreasingFunction
  RealForms LevelOnSimplex MonotoneSimplex.
Require Import Reals Psatz Ring Field ZArith List Lia.
Import ListNotations.
Open Scope R_scope.

(* A bound from above, by its values at the corners, and one from below, by a tensor. *)
Definition bounds_above m up :=
  Forall2 (fun c r => 0 <= r /\ norm2 (corner_tensor c) <= 54 * (r * r)) m up.
Definition inner_form m e := map (fun c => inner (corner_tensor c) e) m.

Theorem root_bound_above m up w : bounds_above m up -> Forall (fun x => 0 <= x) w ->
  sqrt (norm2 (field m w) / 54) <= real_sum up w.
Proof.
  intros B. revert w. induction B as [|c r m up [R C] B IH]; intros w W; cbn [field real_sum].
  - replace (norm2 zero / 54) with 0 by (unfold norm2, inner, zero; cbn; field). rewrite sqrt_0. lra.
  - assert (X := head_nonneg w W). assert (Y := IH (tl w) (tail_nonneg w W)).
    assert (T := root_triangle (scale (hd 0 w) (corner_tensor c)) (field m (tl w))).
    rewrite root_scale in T by exact X.
    assert (Q : root (corner_tensor c) <= r).
    { apply le_of_squares; [exact R|]. rewrite root_squared. lra. }
    assert (hd 0 w * root (corner_tensor c) <= hd 0 w * r) by (apply Rmult_le_compat_l; assumption).
    unfold root in *. lra.
Qed.

Lemma inner_form_value m e w : real_sum (inner_form m e) w = inner (field m w) e.
Proof.
  revert w. induction m as [|c m IH]; intros w; cbn [inner_form map real_sum field].
  - unfold inner, zero. cbn. ring.
  - unfold inner_form in IH. rewrite IH, inner_add, inner_scale. reflexivity.
Qed.
Theorem root_bound_below m e w : 54 * norm2 e <= 1 ->
  real_sum (inner_form m e) w = inner (field m w) e /\
  inner (field m w) e <= sqrt (norm2 (field m w) / 54).
Proof.
  intros H. split; [apply inner_form_value|]. assert (C := cauchy (field m w) e).
  apply le_of_squares; [apply sqrt_pos|]. fold (root (field m w)). rewrite root_squared.
  assert (N := norm2_nonneg (field m w)). assert (M := norm2_nonneg e). nra.
Qed.

Theorem level_form_side num den t : t <> zero -> 0 < den ->
  let h := den * det t - num * (norm2 t * sqrt (norm2 t / 54)) in
  (0 < h <-> num / den < mode t) /\ (h < 0 <-> mode t < num / den) /\ (h = 0 <-> mode t = num / den).
Proof.
  intros N D h. assert (E : h = den * level_value (num / den) t)
    by (unfold h, level_value, root; field; lra).
  destruct (level_value_side (num / den) t N) as [A [B C]]. rewrite E, <- A, <- B, <- C.
  repeat split; intros H; nra.
Qed.

(* What the checker has found: the forms with both bounds have positive coefficients. *)
Record monotone_level V m d num den e up := MonotoneLevel {
  corners_are : length m = V;
  den_positive : 0 < den;
  cauchy_bound : 54 * norm2 e <= 1;
  convex_bound : bounds_above m up;
  rises_below : positive_coefficients V (rise_form num den m d (inner_form m e));
  rises_above : positive_coefficients V (rise_form num den m d up)
}.

(* It can be met: diag(2, -1, -1) and diag(1, 1, -2), whose modes are 1 and -1, with the level 1/2. *)
Example condition_is_met :
  let m := [Corner 2 (-1) (-1) 0 0 0; Corner 1 1 (-2) 0 0 0] in
  monotone_level 2 m [1; -1]%Z 1 2 (Tensor (3 / 32) 0 (- 3 / 32) 0 0 0) [1 / 3; 1 / 3].
Proof.
  assert (Two : forall f : nat -> Prop, f 0%nat -> f 1%nat -> forall i, (i < 2)%nat -> f i)
    by (intros f A B [|[|i]] I; [exact A|exact B|lia]).
  intros m. split; [reflexivity|lra|unfold norm2, inner; cbn; lra| | |].
  1: unfold bounds_above, m, norm2, inner, corner_tensor; repeat constructor; cbn; lra.
  all: split; [cbn; repeat constructor; cbn; unfold inner; cbn; lra|].
  all: apply Two; cbn; repeat first
    [apply Exists_cons_hd; split; [cbn; unfold inner; cbn; lra|reflexivity]|apply Exists_cons_tl].
Qed.

Lemma root_between V m d num den e up w : monotone_level V m d num den e up -> in_cone V w ->
  real_sum (inner_form m e) w <= root (field m w) <= real_sum up w.
Proof.
  intros M C. destruct (root_bound_below m e w (cauchy_bound _ _ _ _ _ _ _ M)) as [E L]. rewrite E.
  split; [exact L|]. exact (root_bound_above m up w (convex_bound _ _ _ _ _ _ _ M) (proj1 C)).
Qed.
Lemma level_rises_if_monotone V m d num den e up : monotone_level V m d num den e up ->
  level_rises V m d (num / den).
Proof.
  intros M. apply rises_if_slopes with (low := real_sum (inner_form m e)) (up := real_sum up).
  intros w C. split; [apply (root_between V m d num den e up w M C)|].
  assert (D := den_positive _ _ _ _ _ _ _ M).
  assert (X := positive_coefficients_value V _ w (rises_below _ _ _ _ _ _ _ M) C).
  assert (Y := positive_coefficients_value V _ w (rises_above _ _ _ _ _ _ _ M) C).
  rewrite rise_form_value in X, Y by exact D. split; nra.
Qed.

Theorem level_form_increases V m d num den e up w a b : monotone_level V m d num den e up -> a < b ->
  in_cone V (move w a d) -> in_cone V (move w b d) ->
  let h w := den * det (field m w) - num * (norm2 (field m w) * sqrt (norm2 (field m w) / 54)) in
  h (move w a d) < h (move w b d).
Proof.
  intros M L A B h. assert (D := den_positive _ _ _ _ _ _ _ M).
  assert (E : forall v, h v = den * level_value (num / den) (field m v))
    by (intros v; unfold h, level_value, root; field; lra).
  rewrite !E. apply Rmult_lt_compat_l; [exact D|].
  apply (proj2 (level_rises_if_monotone _ _ _ _ _ _ _ M)); assumption.
Qed.

Theorem field_does_not_vanish V m d num den e up w : monotone_level V m d num den e up ->
  in_cone V w -> field m w <> zero.
Proof. intros M. apply (proj1 (level_rises_if_monotone _ _ _ _ _ _ _ M)). Qed.

(* What follows is said of `level_rises V m d mu`: the field is not zero in the cone, and the function
   Q - mu P sqrt(P/54) increases along d. The condition of the checker gives it for its level and for
   all levels close to this. For the forms are homogeneous, those of close levels differ little where
   the largest weight is 1, and there the checker's are at least some positive number. *)
Lemma largest_weight V w : in_cone V w -> exists i, (i < V)%nat /\ 0 < nth i w 0 /\
  forall j, (j < V)%nat -> nth j w 0 <= nth i w 0.
Proof.
  rewrite cone_nth. intros [W [i0 [I0 P0]]].
  assert (H : forall n, (0 < n)%nat -> exists i, (i < n)%nat /\
    forall j, (j < n)%nat -> nth j w 0 <= nth i w 0).
  { induction n as [|n IH]; intros Z; [lia|]. destruct (Nat.eq_dec n 0) as [->|N].
    - exists 0%nat. split; [lia|]. intros j J. replace j with 0%nat by lia. lra.
    - destruct (IH ltac:(lia)) as [i [I M]]. destruct (Rle_dec (nth n w 0) (nth i w 0)) as [L|L].
      + exists i. split; [lia|]. intros j J. destruct (Nat.eq_dec j n) as [->|Ne]; [exact L|apply M; lia].
      + exists n. split; [lia|]. intros j J. destruct (Nat.eq_dec j n) as [->|Ne]; [lra|].
        assert (X := M j ltac:(lia)). lra. }
  destruct (H V ltac:(lia)) as [i [I M]]. exists i. split; [exact I|]. split; [|exact M].
  assert (X := M i0 I0). lra.
Qed.
Lemma normal_weights V w : in_cone V w -> exists k v, 0 < k /\ Forall (fun x => 0 <= x <= 1) v /\
  (exists i, (i < V)%nat /\ 1 <= nth i v 0) /\ forall i, (i < V)%nat -> nth i w 0 = k * nth i v 0.
Proof.
  intros C. destruct (largest_weight V w C) as [i [I [P M]]]. rewrite cone_nth in C.
  exists (nth i w 0), (map (fun j => nth j w 0 / nth i w 0) (seq 0 V)).
  assert (E : forall j, (j < V)%nat ->
    nth j (map (fun j => nth j w 0 / nth i w 0) (seq 0 V)) 0 = nth j w 0 / nth i w 0).
  { intros j J. rewrite (nth_indep _ 0 (nth 0 w 0 / nth i w 0)) by (rewrite map_length, seq_length; exact J).
    rewrite (map_nth (fun j => nth j w 0 / nth i w 0)), seq_nth by exact J. reflexivity. }
  split; [exact P|]. split; [|split].
  - apply Forall_forall. intros x X. apply in_map_iff in X. destruct X as [j [<- J]].
    apply in_seq in J. assert (A := proj1 C j). assert (B := M j ltac:(lia)). split.
    + unfold Rdiv. apply Rmult_le_pos; [exact A|]. left. apply Rinv_0_lt_compat, P.
    + apply (Rmult_le_reg_r (nth i w 0)); [exact P|]. unfold Rdiv.
      rewrite Rmult_assoc, Rinv_l by lra. lra.
  - exists i. split; [exact I|]. rewrite E by exact I. right. field. lra.
  - intros j J. rewrite E by exact J. field. lra.
Qed.
Lemma shifted_weights k w v n :
  (forall i, (i < S n)%nat -> nth i w 0 = k * nth i v 0) ->
  hd 0 w = k * hd 0 v /\ forall i, (i < n)%nat -> nth i (tl w) 0 = k * nth i (tl v) 0.
Proof.
  intros H. split; [|intros i I; rewrite !nth_tail; apply H; lia].
  assert (E := H 0%nat ltac:(lia)). destruct w, v; exact E.
Qed.
Lemma field_multiple k m w v : (forall i, (i < length m)%nat -> nth i w 0 = k * nth i v 0) ->
  field m w = scale k (field m v).
Proof.
  revert w v. induction m as [|c m IH]; intros w v H; cbn [field]; [tensor_ring|].
  destruct (shifted_weights k w v _ H) as [A B]. rewrite A, (IH _ _ B).
  generalize (field m (tl v)) (corner_tensor c) (hd 0 v). intros a b x. tensor_ring.
Qed.
Lemma real_sum_multiple k s w v : (forall i, (i < length s)%nat -> nth i w 0 = k * nth i v 0) ->
  real_sum s w = k * real_sum s v.
Proof.
  revert w v. induction s as [|r s IH]; intros w v H; cbn [real_sum]; [ring|].
  destruct (shifted_weights k w v _ H) as [A B]. rewrite A, (IH _ _ B). ring.
Qed.
Lemma slope_multiple k mu m d s w v : length s = length m ->
  (forall i, (i < length m)%nat -> nth i w 0 = k * nth i v 0) ->
  level_slope mu m d (real_sum s w) w = k * k * level_slope mu m d (real_sum s v) v.
Proof.
  intros L H. unfold level_slope. destruct (slopes m d w) as [A B]. destruct (slopes m d v) as [A' B'].
  rewrite A, B, A', B', (field_multiple k m w v H).
  rewrite (real_sum_multiple k s w v) by (rewrite L; exact H).
  generalize (step m d) (field m v) (real_sum s v). intros u t x. clear.
  assert (Q : Dual.det_linear (scale k t) u = k * k * Dual.det_linear t u).
  { assert (S : square (scale k t) = scale (k * k) (square t))
      by (coordinates; apply tensor_eq; cbn; ring).
    assert (T : trace (scale k t) = k * trace t) by (coordinates; ring).
    unfold Dual.det_linear, norm2. rewrite S, T, !(inner_sym u), !inner_add, !inner_scale.
    rewrite (inner_sym t (scale k t)), inner_scale. field. }
  rewrite Q, inner_scale. field.
Qed.

Lemma close_slopes V m d num den s : length m = V -> length s = V -> 0 < den ->
  positive_coefficients V (rise_form num den m d s) ->
  exists eps, 0 < eps /\ forall mu, Rabs (mu - num / den) < eps -> forall w, in_cone V w ->
    0 < level_slope mu m d (real_sum s w) w.
Proof.
  intros Lm Ls D P. destruct (uniform_lower_bound V _ P) as [c [C Lower]].
  destruct (uniform_upper_bound (real_mul (real_linear s)
    (multiple (3 / 2) (poly_derivative (norm_form m) d)))) as [b [B Upper]].
  assert (Dc : 0 < den * (b + 1)) by (apply Rmult_lt_0_compat; lra).
  exists (c / (den * (b + 1))). split; [apply Rdiv_lt_0_compat; assumption|].
  intros mu Mu w W. destruct (normal_weights V w W) as [k [v [K [U [[i [I O]] E]]]]].
  rewrite (slope_multiple k mu m d s w v); [|rewrite Lm, Ls; reflexivity|rewrite Lm; exact E].
  apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; exact K|].
  assert (X := Lower v i ltac:(eapply Forall_impl; [|exact U]; cbn; intros; lra) I O).
  rewrite rise_form_value in X by exact D. assert (Y := Upper v U).
  rewrite real_mul_value, real_linear_value, multiple_value in Y. fold (norm_slope m d v) in Y.
  set (z := real_sum s v * (3 / 2 * norm_slope m d v)) in *.
  assert (S : level_slope mu m d (real_sum s v) v
    = level_slope (num / den) m d (real_sum s v) v - (mu - num / den) * z)
    by (unfold level_slope, z; field; lra).
  rewrite S. clear S. set (f := level_slope (num / den) m d (real_sum s v) v) in *.
  assert (T := Rle_abs ((mu - num / den) * z)). rewrite Rabs_mult in T.
  set (x := Rabs (mu - num / den)) in *. assert (X0 : 0 <= x) by apply Rabs_pos.
  assert (Q : x * (den * (b + 1)) < c).
  { apply (Rmult_lt_compat_r (den * (b + 1))) in Mu; [|exact Dc].
    replace (c / (den * (b + 1)) * (den * (b + 1))) with c in Mu by (field; lra). exact Mu. }
  assert (x * Rabs z <= x * b) by (apply Rmult_le_compat_l; assumption).
  assert (F : den * (x * b) < den * f) by nra.
  apply Rmult_lt_reg_l in F; lra.
Qed.

Theorem close_levels_rise V m d num den e up : monotone_level V m d num den e up ->
  exists eps, 0 < eps /\ forall mu, Rabs (mu - num / den) < eps -> level_rises V m d mu.
Proof.
  intros M. assert (L := corners_are _ _ _ _ _ _ _ M). assert (D := den_positive _ _ _ _ _ _ _ M).
  assert (Lu : length up = V).
  { rewrite <- L. assert (B := convex_bound _ _ _ _ _ _ _ M). clear - B.
    induction B; cbn; [reflexivity|]. f_equal. assumption. }
  destruct (close_slopes V m d num den (inner_form m e) L) as [e1 [E1 H1]];
    [unfold inner_form; rewrite map_length; exact L|exact D|apply M|].
  destruct (close_slopes V m d num den up L Lu D) as [e2 [E2 H2]]; [apply M|].
  exists (Rmin e1 e2). split; [apply Rmin_glb_lt; assumption|]. intros mu Mu.
  assert (A := Rmin_l e1 e2). assert (B := Rmin_r e1 e2).
  apply rises_if_slopes with (low := real_sum (inner_form m e)) (up := real_sum up). intros w C.
  split; [apply (root_between V m d num den e up w M C)|].
  split; [apply H1|apply H2]; try assumption; lra.
Qed.

Section Level.
Variables (V : nat) (m : list corner) (d : list Z) (mu : R).
Hypothesis Rises : level_rises V m d mu.

Let h w := level_value mu (field m w).
Lemma side w : in_cone V w -> (0 < h w <-> mu < mode_at m w) /\ (h w < 0 <-> mode_at m w < mu) /\
  (h w = 0 <-> mode_at m w = mu).
Proof. intros C. apply level_value_side, (proj1 Rises), C. Qed.
Lemma side_weak w : in_cone V w -> (0 <= h w <-> mu <= mode_at m w) /\ (h w <= 0 <-> mode_at m w <= mu).
Proof.
  intros C. destruct (side w C) as [A [B _]].
  split; split; intros H; apply Rnot_lt_le; intros L; (apply B in L || apply A in L); lra.
Qed.
Lemma level_continuous w : in_cone V w -> continuous_at h w.
Proof. intros _. apply continuous_level. Qed.
Lemma in_between w a b t : in_cone V (move w a d) -> in_cone V (move w b d) -> a <= t <= b ->
  in_cone V (move w t d).
Proof. intros A B T. apply (between_in_cone V w d a t b); assumption. Qed.
Lemma once_in_modes w a b : in_cone V (move w a d) -> in_cone V (move w b d) ->
  (exists! t, a <= t <= b /\ h (move w t d) = 0) ->
  exists! t, a <= t <= b /\ mode_at m (move w t d) = mu.
Proof.
  intros A B [t [[T E] U]].
  assert (S : forall s, a <= s <= b -> h (move w s d) = 0 <-> mode_at m (move w s d) = mu)
    by (intros s I; apply side, (in_between w a b); assumption).
  exists t. split; [split; [exact T|apply S; assumption]|].
  intros s [I F]. apply U. split; [exact I|apply S; assumption].
Qed.

(* A line along d comes from below and goes on above. *)
Theorem level_crossed_upwards w a b : a < b ->
  in_cone V (move w a d) -> in_cone V (move w b d) -> mu <= mode_at m (move w a d) ->
  mu < mode_at m (move w b d).
Proof.
  intros L A B H. apply (side_weak _ A) in H. apply (side _ B).
  assert (X := proj2 Rises w a b L A B). cbv beta in X. unfold h in *. lra.
Qed.

(* On the part a..b of a line: one crossing if the level is between the modes at the ends. *)
Theorem level_crossed_once w a b : a <= b -> in_cone V (move w a d) -> in_cone V (move w b d) ->
  mode_at m (move w a d) <= mu <= mode_at m (move w b d) ->
  exists! t, a <= t <= b /\ mode_at m (move w t d) = mu.
Proof.
  intros L A B [H K]. apply once_in_modes; try assumption.
  apply (increasing_one_crossing V d h (proj2 Rises) level_continuous); try assumption.
  split; [apply (side_weak _ A), H|apply (side_weak _ B), K].
Qed.

(* And none otherwise. *)
Theorem level_not_crossed w a b : a <= b -> in_cone V (move w a d) -> in_cone V (move w b d) ->
  mu < mode_at m (move w a d) \/ mode_at m (move w b d) < mu ->
  forall t, a <= t <= b -> mode_at m (move w t d) <> mu.
Proof.
  intros L A B H t T E. apply (side _ (in_between w a b t A B T)) in E. revert E.
  apply (increasing_no_crossing V d h (proj2 Rises) w a b 0 L A B); [|exact T].
  destruct H as [H|H]; [left; apply (side _ A), H|right; apply (side _ B), H].
Qed.

(* The level is a graph. On the line along d through any point of the simplex: its part in the simplex
   is a segment a..b from boundary to boundary, with one crossing or none. *)
Theorem one_level_is_a_graph w : length d = V ->
  (exists i, (0 < nth i d 0)%Z) -> (exists i, (nth i d 0 < 0)%Z) -> in_cone V w ->
  exists a b, a <= 0 <= b /\ on_boundary V (move w a d) /\ on_boundary V (move w b d) /\
    (forall t, a <= t <= b -> in_cone V (move w t d)) /\
    (mode_at m (move w a d) <= mu <= mode_at m (move w b d) ->
      exists! t, a <= t <= b /\ mode_at m (move w t d) = mu) /\
    (mu < mode_at m (move w a d) \/ mode_at m (move w b d) < mu ->
      forall t, a <= t <= b -> mode_at m (move w t d) <> mu).
Proof.
  intros D P N C. destruct (segment V d w D P N C) as [a [b [O [A [A' [B B']]]]]].
  exists a, b. split; [exact O|]. split; [exact A'|]. split; [exact B'|].
  split; [intros t; apply (in_between w a b); assumption|].
  split; [apply level_crossed_once|apply level_not_crossed]; try assumption; lra.
Qed.

(* The sides of the level reach the boundary: from a point below, the line against d leads to the
   boundary through points below; from a point above, the line along d through points above. *)
Theorem sides_of_level_reach_the_boundary w : length d = V ->
  (exists i, (0 < nth i d 0)%Z) -> (exists i, (nth i d 0 < 0)%Z) -> in_cone V w ->
  (mode_at m w < mu -> exists a, a <= 0 /\ on_boundary V (move w a d) /\ forall t, a <= t <= 0 ->
    in_cone V (move w t d) /\ mode_at m (move w t d) < mu) /\
  (mu < mode_at m w -> exists b, 0 <= b /\ on_boundary V (move w b d) /\ forall t, 0 <= t <= b ->
    in_cone V (move w t d) /\ mu < mode_at m (move w t d)).
Proof.
  intros D P N C.
  destruct (increasing_sides V d h (proj2 Rises) level_continuous w 0 D P N C) as [Below Above].
  split; intros H; apply (side _ C) in H.
  - destruct (Below H) as [a [A [O K]]]. exists a. split; [exact A|]. split; [exact O|].
    intros t T. destruct (K t T) as [I L]. split; [exact I|apply (side _ I), L].
  - destruct (Above H) as [b [B [O K]]]. exists b. split; [exact B|]. split; [exact O|].
    intros t T. destruct (K t T) as [I L]. split; [exact I|apply (side _ I), L].
Qed.

(* The crossing is a continuous function of the line: if w is on the level and the line goes on by eps
   on both sides, then lines close to it cross the level within eps of their points close to w, and
   once only. *)
Theorem crossing_of_level_is_continuous w eps : 0 < eps -> in_cone V w ->
  mode_at m (move w 0 d) = mu -> in_cone V (move w (- eps) d) -> in_cone V (move w eps d) ->
  exists delta, 0 < delta /\ forall w', close delta w w' ->
    in_cone V (move w' (- eps) d) -> in_cone V (move w' eps d) ->
    exists! t, - eps <= t <= eps /\ mode_at m (move w' t d) = mu.
Proof.
  intros E C Z A B. assert (C0 : in_cone V (move w 0 d)) by (rewrite move_zero; exact C).
  apply (side _ C0) in Z.
  destruct (increasing_continuous_crossing V d h (proj2 Rises) level_continuous w 0 eps E C Z A B)
    as [delta [D K]].
  exists delta. split; [exact D|]. intros w' N A1 B1. apply once_in_modes; try assumption.
  apply K; assumption.
Qed.
End Level.
