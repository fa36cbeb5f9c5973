(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   In space the mode of a linear field with a nondegenerate characteristic tensor N has, besides
   degenerate points, one critical point, the dual of N. Its mode is that of the bifurcation, and it
   is a saddle. The idea: where the derivative vanishes along all directions of the field, dual T is
   a multiple of N; and the dual of the dual of T is a multiple of T. *)
From TensorTopo Require Import Tensors Frames DegenerateTensors SpectralTheorem Mode ModeRange
  ModeOnSimplex Dual.
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

Definition in_field N t := inner N t = 0 /\ trace t = 0.
Definition critical_in_field N t := forall u, in_field N u ->
  derivable_pt_lim (fun x => mode (add t (scale x u))) 0 0.

(* Lagrange: the derivative vanishes along the field exactly if dual T is a multiple of N. *)
Lemma lagrange N t : trace N = 0 -> N <> zero -> t <> zero -> trace t = 0 ->
  (critical_in_field N t <-> exists k, dual t = scale k N).
Proof.
  intros TN ZN Z T. assert (P := norm2_positive N ZN). split.
  - intros C. exists (inner (dual t) N / norm2 N). set (c := inner (dual t) N / norm2 N).
    set (u := sub (dual t) (scale c N)).
    assert (U : in_field N u).
    { split; unfold u, sub.
      - rewrite inner_sym, !inner_add, !inner_scale. fold (norm2 N). unfold c. field. lra.
      - rewrite !trace_add, !trace_scale, (trace_dual t T), TN. ring. }
    destruct (mode_directional t u Z T (proj2 U)) as [k [K D]].
    assert (E := uniqueness_limite _ _ _ _ (C u U) D).
    assert (H : inner (dual t) u = 0) by (symmetry in E; destruct (Rmult_integral _ _ E); [lra|assumption]).
    assert (NU : norm2 u = 0).
    { transitivity (inner (dual t) u - c * inner N u).
      - unfold norm2. unfold u at 1, sub. rewrite !inner_add, !inner_scale. ring.
      - rewrite H, (proj1 U). ring. }
    apply norm2_zero in NU. unfold u, sub in NU.
    transitivity (add (add (dual t) (scale (-1) (scale c N))) (scale c N)).
    + generalize (dual t). intros d. clear. tensor_ring.
    + rewrite NU. clear. tensor_ring.
  - intros [k E] u [I U]. destruct (mode_directional t u Z T U) as [c [_ D]].
    rewrite E, inner_scale, I in D. replace (c * (k * 0)) with 0 in D by ring. exact D.
Qed.

Lemma scale_zero k t : scale k t = zero -> k = 0 \/ t = zero.
Proof.
  intros H. destruct (Req_dec k 0) as [K|K]; [left; exact K|right].
  transitivity (scale (/ k * k) t); [rewrite Rinv_l by exact K; symmetry; apply scale_one|].
  rewrite <- scale_scale, H. clear. tensor_ring.
Qed.
Lemma degenerate_scale k t : degenerate t -> degenerate (scale k t).
Proof.
  intros [a [b [u [U E]]]]. exists (k * a), (k * b), u. split; [exact U|]. rewrite E. tensor_ring.
Qed.

Theorem one_critical_point N t : trace N = 0 -> ~ degenerate N ->
  t <> zero -> in_field N t -> critical_in_field N t -> ~ degenerate t ->
  exists k, k <> 0 /\ t = scale k (dual N).
Proof.
  intros TN DN Z [I T] C DT.
  assert (ZN : N <> zero).
  { intros H. apply DN. exists 0, 0, (Vector 1 0 0). rewrite H. split; [unfold dot; cbn; ring|tensor_ring]. }
  apply (lagrange N t TN ZN Z T) in C. destruct C as [k E].
  assert (K : k <> 0).
  { intros H. apply DT, dual_zero; [exact T|]. rewrite E, H. clear. tensor_ring. }
  destruct (spectral_theorem t) as [t1 [t2 [t3 [u [v [w [_ [_ [O F]]]]]]]]].
  assert (S : t1 + t2 + t3 = 0) by (rewrite <- T, F; symmetry; apply trace_spectral, O).
  assert (DD := dual_dual t1 t2 t3 u v w O S). rewrite <- F, E, dual_scale in DD.
  set (f := dual_factor t1 t2 t3) in *. set (c := k * k * (k * k)) in *.
  assert (C0 : c <> 0) by (unfold c; assert (0 < k * k) by (apply square_pos; exact K);
    assert (0 < k * k * (k * k)) by (apply Rmult_lt_0_compat; assumption); lra).
  assert (F0 : f <> 0).
  { intros H. apply DN, dual_zero; [exact TN|]. rewrite H in DD.
    replace (scale 0 t) with zero in DD by (clear; tensor_ring).
    destruct (scale_zero _ _ DD); [contradiction|assumption]. }
  exists (/ f * c). split; [apply Rmult_integral_contrapositive_currified; [apply Rinv_neq_0_compat; exact F0|exact C0]|].
  rewrite <- scale_scale, DD, scale_scale, Rinv_l, scale_one by exact F0. reflexivity.
Qed.

Theorem saddle_is_critical N : trace N = 0 -> ~ degenerate N ->
  in_field N (dual N) /\ dual N <> zero /\ critical_in_field N (dual N) /\
  mode (dual N) * mode (dual N) = 1 - mode N * mode N.
Proof.
  intros TN DN. assert (Z : dual N <> zero) by (intros H; apply DN, dual_zero; assumption).
  assert (ZN : N <> zero).
  { intros H. apply DN. exists 0, 0, (Vector 1 0 0). rewrite H. split; [unfold dot; cbn; ring|tensor_ring]. }
  split; [split; [rewrite inner_sym; apply inner_dual, TN|apply trace_dual, TN]|].
  split; [exact Z|]. split.
  - apply lagrange; auto; [apply trace_dual, TN|].
    destruct (spectral_theorem N) as [b1 [b2 [b3 [u [v [w [_ [_ [O F]]]]]]]]].
    assert (S : b1 + b2 + b3 = 0) by (rewrite <- TN, F; symmetry; apply trace_spectral, O).
    exists (dual_factor b1 b2 b3). rewrite F. apply dual_dual; assumption.
  - assert (M := mode_dual N TN Z). lra.
Qed.

(* Near the saddle, in the frame of N: along x E12 + y E23 + z E13 the mode grows or falls with the
   sign of a quadratic form, negative for E23 and positive for E12 and E13. *)
Definition saddle b1 b2 b3 u v w := spectral (b2 - b3) (b3 - b1) (b1 - b2) u v w.
Definition displacement x y z u v w :=
  add (scale x (sym_dyad u v)) (add (scale y (sym_dyad v w)) (scale z (sym_dyad u w))).
Definition index_form b1 b2 b3 x y z :=
  9 * (b1 * b2 * (b1 - b2) * (x * x) - b2 * (b1 + b2) * (b2 - b3) * (y * y)
       + b1 * (b1 + b2) * (b1 - b3) * (z * z)).

Theorem signature b1 b2 b3 : b1 + b2 + b3 = 0 -> b1 > b2 -> b2 > 0 ->
  (forall x z, x <> 0 \/ z <> 0 -> 0 < index_form b1 b2 b3 x 0 z) /\
  (forall y, y <> 0 -> index_form b1 b2 b3 0 y 0 < 0).
Proof.
  intros S A B.
  assert (C1 : 0 < b1 * b2 * (b1 - b2)) by (repeat apply Rmult_lt_0_compat; lra).
  assert (C2 : 0 < b2 * (b1 + b2) * (b2 - b3)) by (repeat apply Rmult_lt_0_compat; lra).
  assert (C3 : 0 < b1 * (b1 + b2) * (b1 - b3)) by (repeat apply Rmult_lt_0_compat; lra).
  unfold index_form. split.
  - intros x z N. assert (X := square_nonneg x). assert (Z := square_nonneg z).
    assert (0 <= b1 * b2 * (b1 - b2) * (x * x)) by (apply Rmult_le_pos; lra).
    assert (0 <= b1 * (b1 + b2) * (b1 - b3) * (z * z)) by (apply Rmult_le_pos; lra).
    destruct N as [N|N]; assert (Q := square_pos _ N).
    + assert (0 < b1 * b2 * (b1 - b2) * (x * x)) by (apply Rmult_lt_0_compat; lra). lra.
    + assert (0 < b1 * (b1 + b2) * (b1 - b3) * (z * z)) by (apply Rmult_lt_0_compat; lra). lra.
  - intros y N. assert (Q := square_pos _ N).
    assert (0 < b2 * (b1 + b2) * (b2 - b3) * (y * y)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

Lemma displaced b1 b2 b3 x y z u v w t : orthonormal u v w -> b1 + b2 + b3 = 0 ->
  let s := add (saddle b1 b2 b3 u v w) (scale t (displacement x y z u v w)) in
  let p := 3 * (b1 * b1 + b2 * b2 + b3 * b3) in
  let q := (b2 - b3) * (b3 - b1) * (b1 - b2) in
  let a := - (b1 - b2) * (x * x) - (b2 - b3) * (y * y) - (b3 - b1) * (z * z) in
  norm2 s = p + 0 * t + 2 * (x * x + y * y + z * z) * (t * t) + 0 * (t * t * t) /\
  det s = q + 0 * t + a * (t * t) + 2 * x * y * z * (t * t * t).
Proof.
  intros O S s p q a.
  assert (E : s = from_frame u v w (Tensor (b2 - b3) (b3 - b1) (b1 - b2) (t * x) (t * y) (t * z))).
  { unfold s, saddle, displacement, from_frame. cbn [xx yy zz xy yz xz].
    generalize (spectral (b2 - b3) (b3 - b1) (b1 - b2) u v w) (sym_dyad u v) (sym_dyad v w) (sym_dyad u w).
    clear. intros. tensor_ring. }
  rewrite E. split.
  - rewrite <- (norm2_in_frame u v w _ O), (in_from_frame u v w _ O).
    unfold norm2, inner, p. cbn [xx yy zz xy yz xz]. replace b3 with (- b1 - b2) by lra. ring.
  - rewrite <- (det_in_frame u v w _ O), (in_from_frame u v w _ O).
    unfold det, q, a. cbn [xx yy zz xy yz xz]. ring.
Qed.

Theorem saddle_index b1 b2 b3 u v w x y z : orthonormal u v w -> b1 + b2 + b3 = 0 ->
  b1 > b2 -> b2 > b3 -> let h := index_form b1 b2 b3 x y z in h <> 0 ->
  exists eps, 0 < eps /\ forall t, t <> 0 -> Rabs t < eps ->
  0 < h * (mode (add (saddle b1 b2 b3 u v w) (scale t (displacement x y z u v w)))
           - mode (saddle b1 b2 b3 u v w)).
Proof.
  intros O S A B h H.
  set (p := 3 * (b1 * b1 + b2 * b2 + b3 * b3)). set (q := (b2 - b3) * (b3 - b1) * (b1 - b2)).
  set (a := - (b1 - b2) * (x * x) - (b2 - b3) * (y * y) - (b3 - b1) * (z * z)).
  set (r := x * x + y * y + z * z). set (c := 2 * x * y * z).
  assert (Hh : h = p * a - 3 * q * r).
  { unfold h, index_form, p, a, q, r. replace b3 with (- b1 - b2) by lra. ring. }
  assert (P0 : 0 < p) by (unfold p; assert (0 < (b1 - b2) * (b1 - b2)) by (apply square_pos; lra); nra).
  assert (R0 : 0 <= r) by (unfold r; assert (X := square_nonneg x); assert (Y := square_nonneg y); assert (Z := square_nonneg z); lra).
  set (np := fun t => p + 0 * t + 2 * r * (t * t) + 0 * (t * t * t)).
  set (nq := fun t => q + 0 * t + a * (t * t) + c * (t * t * t)).
  set (g := fun t => nq t / (sqrt (np t) * sqrt (np t) * sqrt (np t))).
  assert (G : forall t, mode (add (saddle b1 b2 b3 u v w) (scale t (displacement x y z u v w))) = 3 * sqrt 6 * g t).
  { intros t. destruct (displaced b1 b2 b3 x y z u v w t O S) as [E1 E2].
    unfold mode, norm. rewrite E1, E2. unfold g, np, nq, p, q, a, r, c, Rdiv. ring. }
  assert (G0 : mode (saddle b1 b2 b3 u v w) = 3 * sqrt 6 * g 0).
  { rewrite <- G. f_equal. generalize (saddle b1 b2 b3 u v w) (displacement x y z u v w). clear. intros. tensor_ring. }
  assert (NP : forall t, 0 < np t) by (intros t; unfold np; assert (T := square_nonneg t); nra).
  set (rest := fun t => 4 * h + 6 * p * c * t - 4 * r * a * (t * t)).
  assert (D : forall t, exists k, 0 < k /\ derivable_pt_lim g t (k * (t * rest t))).
  { intros t. assert (Q := quotient_derivative np nq _ _ t (NP t) (cubic_derivative p 0 (2 * r) 0 t) (cubic_derivative q 0 a c t)).
    exists (/ (2 * sqrt (np t) * (np t * np t))). split.
    - apply Rinv_0_lt_compat. assert (W := NP t). assert (0 < sqrt (np t)) by (apply sqrt_lt_R0; exact W).
      repeat apply Rmult_lt_0_compat; lra.
    - replace (_ * (t * rest t)) with ((2 * np t * (0 + 2 * a * t + 3 * c * (t * t)) - 3 * nq t * (0 + 2 * (2 * r) * t + 3 * 0 * (t * t)))
        / (2 * sqrt (np t) * (np t * np t))); [exact Q|].
      unfold Rdiv. rewrite (Rmult_comm (/ _)). f_equal. unfold rest. rewrite Hh. unfold np, nq. ring. }
  (* h and the rest have the same sign near 0 *)
  set (m := 6 * p * Rabs c + 4 * r * Rabs a).
  assert (M0 : 0 <= m) by (unfold m; assert (C := Rabs_pos c); assert (Aa := Rabs_pos a); nra).
  assert (H0 : 0 < Rabs h) by (apply Rabs_pos_lt; exact H).
  set (eps := Rmin 1 (Rabs h / (m + 1))).
  assert (E0 : 0 < Rabs h / (m + 1)) by (apply Rdiv_lt_0_compat; lra).
  assert (Small : forall t, Rabs t < eps -> 0 < h * rest t).
  { intros t T. assert (T1 := Rmin_l 1 (Rabs h / (m + 1))). assert (T2 := Rmin_r 1 (Rabs h / (m + 1))).
    fold eps in T1, T2. assert (T0 := Rabs_pos t).
    assert (TM : Rabs t * (m + 1) < Rabs h).
    { assert (T' := Rmult_lt_compat_r (m + 1) (Rabs t) (Rabs h / (m + 1)) ltac:(lra) ltac:(lra)).
      replace (Rabs h / (m + 1) * (m + 1)) with (Rabs h) in T' by (field; lra). exact T'. }
    assert (Err : Rabs (6 * p * c * t - 4 * r * a * (t * t)) <= m * Rabs t).
    { unfold m. assert (Tr := Rabs_triang (6 * p * c * t) (- (4 * r * a * (t * t)))).
      rewrite Rabs_Ropp in Tr. rewrite !Rabs_mult in Tr.
      rewrite (Rabs_pos_eq p), (Rabs_pos_eq r) in Tr by lra.
      replace (Rabs 6) with 6 in Tr by (rewrite Rabs_pos_eq; lra).
      replace (Rabs 4) with 4 in Tr by (rewrite Rabs_pos_eq; lra).
      assert (Aa := Rabs_pos a). assert (Rabs t * Rabs t <= Rabs t) by nra.
      assert (4 * r * Rabs a * (Rabs t * Rabs t) <= 4 * r * Rabs a * Rabs t) by (apply Rmult_le_compat_l; [nra|lra]).
      unfold Rminus. lra. }
    unfold rest. set (e := 6 * p * c * t - 4 * r * a * (t * t)) in *.
    replace (4 * h + 6 * p * c * t - 4 * r * a * (t * t)) with (4 * h + e) by (unfold e; ring).
    assert (Es : Rabs e < Rabs h) by nra. apply Rabs_def2 in Es.
    destruct (Rle_dec 0 h) as [Hs|Hs].
    - rewrite Rabs_pos_eq in Es by exact Hs. nra.
    - rewrite Rabs_left in Es by lra. nra. }
  exists eps. split; [unfold eps; apply Rmin_glb_lt; lra|]. intros t T Te. rewrite G, G0.
  assert (S6 := sqrt6_positive).
  assert (K : exists k d, 0 < k /\ Rabs d < eps /\ 0 < d * t /\ g t - g 0 = k * (d * rest d) * t).
  { destruct (Rtotal_order t 0) as [Neg|[Z|Pos]]; [|contradiction|].
    - destruct (MVT_cor2 g (fun l => (2 * np l * (0 + 2 * a * l + 3 * c * (l * l)) - 3 * nq l * (0 + 2 * (2 * r) * l + 3 * 0 * (l * l)))
        / (2 * sqrt (np l) * (np l * np l))) t 0 Neg) as [d [E I]].
      { intros l _. apply quotient_derivative; [apply NP|apply cubic_derivative|apply cubic_derivative]. }
      destruct (D d) as [k [K Dd]].
      assert (U := uniqueness_limite _ _ _ _ (quotient_derivative np nq _ _ d (NP d) (cubic_derivative p 0 (2 * r) 0 d) (cubic_derivative q 0 a c d)) Dd).
      cbv beta in E. rewrite U in E. exists k, d. split; [exact K|]. split; [|split; [nra|lra]].
      replace (Rabs d) with (- d) by (rewrite Rabs_left; lra).
      replace (Rabs t) with (- t) in Te by (rewrite Rabs_left; lra). lra.
    - destruct (MVT_cor2 g (fun l => (2 * np l * (0 + 2 * a * l + 3 * c * (l * l)) - 3 * nq l * (0 + 2 * (2 * r) * l + 3 * 0 * (l * l)))
        / (2 * sqrt (np l) * (np l * np l))) 0 t Pos) as [d [E I]].
      { intros l _. apply quotient_derivative; [apply NP|apply cubic_derivative|apply cubic_derivative]. }
      destruct (D d) as [k [K Dd]].
      assert (U := uniqueness_limite _ _ _ _ (quotient_derivative np nq _ _ d (NP d) (cubic_derivative p 0 (2 * r) 0 d) (cubic_derivative q 0 a c d)) Dd).
      cbv beta in E. rewrite U in E. exists k, d. split; [exact K|]. split; [|split; [nra|lra]].
      replace (Rabs d) with d by (rewrite Rabs_pos_eq; lra).
      replace (Rabs t) with t in Te by (rewrite Rabs_pos_eq; lra). lra. }
  destruct K as [k [d [K [Dd [Dt E]]]]].
  assert (W := Small d Dd).
  replace (h * (3 * sqrt 6 * g t - 3 * sqrt 6 * g 0)) with (3 * sqrt 6 * (h * (g t - g 0))) by ring.
  rewrite E. replace (h * (k * (d * rest d) * t)) with (k * ((h * rest d) * (d * t))) by ring.
  assert (0 < k * ((h * rest d) * (d * t))) by (apply Rmult_lt_0_compat; [exact K|apply Rmult_lt_0_compat; assumption]).
  apply Rmult_lt_0_compat; lra.
Qed.
