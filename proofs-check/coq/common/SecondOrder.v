(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   The second-order test. At a critical point s, along a direction d that is orthogonal to s, the
   squared norm is p + 2 r t^2 and the determinant q + a t^2 + c t^3: then the mode grows or falls in
   both directions as p a - 3 q r is positive or negative. In the frame of s = diag(t1, t2, t3), along
   x E12 + y E23 + z E13, that is a sum of squares of x, y, z with the factors -t3 (t1 - t3)(t2 - t3),
   -t1 (t1 - t2)(t1 - t3), t2 (t1 - t2)(t2 - t3). *)
From TensorTopo Require Import Tensors Frames Mode ModeOnSimplex Dual Calculus.
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

Theorem second_order s d p q a c r : 0 < p -> 0 <= r ->
  (forall t, norm2 (add s (scale t d)) = p + 0 * t + 2 * r * (t * t) + 0 * (t * t * t) /\
    det (add s (scale t d)) = q + 0 * t + a * (t * t) + c * (t * t * t)) ->
  let h := p * a - 3 * q * r in h <> 0 ->
  exists eps, 0 < eps /\ forall t, t <> 0 -> Rabs t < eps ->
  0 < h * (mode (add s (scale t d)) - mode s).
Proof.
  intros P0 R0 Forms h H.
  set (np := fun t => p + 0 * t + 2 * r * (t * t) + 0 * (t * t * t)).
  set (nq := fun t => q + 0 * t + a * (t * t) + c * (t * t * t)).
  set (g := fun t => nq t / (sqrt (np t) * sqrt (np t) * sqrt (np t))).
  assert (G : forall t, mode (add s (scale t d)) = 3 * sqrt 6 * g t).
  { intros t. destruct (Forms t) as [E1 E2].
    unfold mode, norm. rewrite E1, E2. unfold g, np, nq, Rdiv. ring. }
  assert (G0 : mode s = 3 * sqrt 6 * g 0) by (rewrite <- G; f_equal; clear; tensor_ring).
  assert (NP : forall t, 0 < np t) by (intros t; unfold np; assert (T := square_nonneg t); nra).
  (* the derivative of g is a positive multiple of t times the rest *)
  set (rest := fun t => 4 * h + 6 * p * c * t - 4 * r * a * (t * t)).
  set (k := fun t => / (2 * sqrt (np t) * (np t * np t))).
  assert (K : forall t, 0 < k t).
  { intros t. apply Rinv_0_lt_compat. assert (W := NP t).
    assert (0 < sqrt (np t)) by (apply sqrt_lt_R0; exact W). repeat apply Rmult_lt_0_compat; lra. }
  assert (D : forall t, derivable_pt_lim g t (k t * (t * rest t))).
  { intros t. assert (Q := quotient_derivative np nq _ _ t (NP t) (cubic_derivative p 0 (2 * r) 0 t) (cubic_derivative q 0 a c t)).
    replace (k t * (t * rest t)) with ((2 * np t * (0 + 2 * a * t + 3 * c * (t * t)) - 3 * nq t * (0 + 2 * (2 * r) * t + 3 * 0 * (t * t)))
        / (2 * sqrt (np t) * (np t * np t))); [exact Q|].
    unfold k, Rdiv. rewrite (Rmult_comm (/ _)). f_equal. unfold rest, h, np, nq. ring. }
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
  replace (h * (3 * sqrt 6 * g t - 3 * sqrt 6 * g 0)) with (3 * sqrt 6 * (h * g t - h * g 0)) by ring.
  apply Rmult_lt_0_compat; [lra|]. apply Rlt_Rminus.
  apply Rabs_def2 in Te.
  assert (Near : forall x, Rabs x <= Rabs t -> 0 < h * rest x).
  { intros x X. apply Small. apply Rle_lt_trans with (1 := X), Rabs_def1; lra. }
  assert (Dh : forall e x, derivable_pt_lim (fun x => h * g (e * x)) x (e * (h * (k (e * x) * (e * x * rest (e * x)))))).
  { intros e x. assert (L := derivable_pt_lim_scal _ h _ _ (D (e * x))).
    assert (I := derivable_pt_lim_scal id e x 1 (derivable_pt_lim_id x)).
    assert (Co := derivable_pt_lim_comp (mult_real_fct e id) (mult_real_fct h g) x _ _ I L).
    replace (e * (h * (k (e * x) * (e * x * rest (e * x))))) with (h * (k (e * x) * (e * x * rest (e * x))) * (e * 1)) by ring.
    exact Co. }
  assert (Rise : forall e, e * e = 1 -> 0 < e * t -> h * g 0 < h * g t).
  { intros e E Et. assert (At : Rabs t = e * t).
    { destruct (Rle_dec 0 t) as [L|L]; [rewrite Rabs_pos_eq by exact L|rewrite Rabs_left by lra]; nra. }
    assert (W := derivative_increases (fun x => h * g (e * x)) _ 0 (e * t) Et (fun x _ => Dh e x)).
    cbv beta in W. replace (e * 0) with 0 in W by ring.
    replace (e * (e * t)) with t in W by (transitivity (e * e * t); [rewrite E|]; ring).
    assert (Form : forall x, e * (h * (k (e * x) * (e * x * rest (e * x)))) = k (e * x) * x * (h * rest (e * x))).
    { intros x. transitivity (e * e * (k (e * x) * x * (h * rest (e * x)))); [ring|rewrite E; ring]. }
    assert (Ab : forall x, 0 <= x <= e * t -> Rabs (e * x) <= Rabs t).
    { intros x X. rewrite At. apply Rabs_le. nra. }
    apply W; intros x X; rewrite Form; assert (Kx := K (e * x)); assert (N := Near (e * x) (Ab x ltac:(lra))).
    - apply Rmult_le_pos; [apply Rmult_le_pos|]; lra.
    - apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; lra. }
  destruct (Rtotal_order t 0) as [Neg|[Z|Pos]]; [apply (Rise (-1)); lra|contradiction|apply (Rise 1); lra].
Qed.

Definition displacement x y z u v w :=
  add (scale x (sym_dyad u v)) (add (scale y (sym_dyad v w)) (scale z (sym_dyad u w))).
Definition second_form t1 t2 t3 x y z := - t3 * (t1 - t3) * (t2 - t3) * (x * x)
  - t1 * (t1 - t2) * (t1 - t3) * (y * y) + t2 * (t1 - t2) * (t2 - t3) * (z * z).

Lemma displaced t1 t2 t3 u v w x y z t : orthonormal u v w ->
  let s := add (spectral t1 t2 t3 u v w) (scale t (displacement x y z u v w)) in
  norm2 s = (t1 * t1 + t2 * t2 + t3 * t3) + 0 * t + 2 * (x * x + y * y + z * z) * (t * t) + 0 * (t * t * t) /\
  det s = t1 * t2 * t3 + 0 * t + - (t3 * (x * x) + t1 * (y * y) + t2 * (z * z)) * (t * t)
    + 2 * x * y * z * (t * t * t).
Proof.
  intros O s. assert (E : s = from_frame u v w (Tensor t1 t2 t3 (t * x) (t * y) (t * z))).
  { unfold s, displacement, from_frame. cbn [xx yy zz xy yz xz].
    generalize (spectral t1 t2 t3 u v w) (sym_dyad u v) (sym_dyad v w) (sym_dyad u w).
    clear. intros. tensor_ring. }
  rewrite E. split.
  - rewrite <- (norm2_in_frame u v w _ O), (in_from_frame u v w _ O).
    unfold norm2, inner. cbn [xx yy zz xy yz xz]. ring.
  - rewrite <- (det_in_frame u v w _ O), (in_from_frame u v w _ O).
    unfold det. cbn [xx yy zz xy yz xz]. ring.
Qed.

(* What the sign of a second derivative h says of a value a beside the value b. *)
Lemma rises h a b : 0 < h * (a - b) -> (a <= b -> h <= 0) /\ (b <= a -> 0 <= h).
Proof.
  intros H. split; intros L; apply Rnot_lt_le; intros K.
  - assert (0 <= h * (b - a)) by (apply Rmult_le_pos; lra). lra.
  - assert (0 <= - h * (a - b)) by (apply Rmult_le_pos; lra). lra.
Qed.

Theorem second_order_in_frame t1 t2 t3 u v w x y z : orthonormal u v w -> t1 + t2 + t3 = 0 ->
  t1 <> 0 \/ t3 <> 0 -> let h := second_form t1 t2 t3 x y z in h <> 0 ->
  let s := spectral t1 t2 t3 u v w in
  exists eps, 0 < eps /\ forall t, t <> 0 -> Rabs t < eps ->
  0 < h * (mode (add s (scale t (displacement x y z u v w))) - mode s).
Proof.
  intros O S N h H s. set (r := x * x + y * y + z * z).
  assert (Hh : h = (t1 * t1 + t2 * t2 + t3 * t3) * - (t3 * (x * x) + t1 * (y * y) + t2 * (z * z))
    - 3 * (t1 * t2 * t3) * r) by (unfold h, second_form, r; replace t2 with (- t1 - t3) by lra; ring).
  rewrite Hh in *. apply (second_order s _ _ _ _ (2 * x * y * z) r); auto.
  - assert (A := square_nonneg t1). assert (B := square_nonneg t2). assert (C := square_nonneg t3).
    destruct N as [K|K]; assert (Q := square_pos _ K); lra.
  - assert (A := square_nonneg x). assert (B := square_nonneg y). assert (C := square_nonneg z). unfold r. lra.
  - intros t. apply displaced, O.
Qed.

(* Displacements are across all that commutes with s. *)
Lemma displacement_across a b c u v w x y z : orthonormal u v w ->
  inner (spectral a b c u v w) (displacement x y z u v w) = 0 /\ trace (displacement x y z u v w) = 0.
Proof.
  intros [A B C D E F]. unfold displacement. split.
  - rewrite inner_spectral, !form_add, !form_scale, !form_sym_dyad.
    rewrite ?(dot_sym v u), ?(dot_sym w v), ?(dot_sym w u), ?A, ?B, ?C, ?D, ?E, ?F. ring.
  - rewrite !trace_add, !trace_scale, !trace_sym_dyad, D, E, F. ring.
Qed.
