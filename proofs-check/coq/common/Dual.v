(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   The derivative of the mode. At a traceless T it is, along a traceless U, a positive multiple of
   <dual T, U> with dual T = |T|^2 T^2 - 3 det(T) T - |T|^4/3 I, a traceless tensor with the
   eigenvectors of T. It is zero exactly for degenerate T. *)
From TensorTopo Require Import Tensors Frames DegenerateTensors SpectralTheorem Mode ModeOnSimplex.
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

Definition dual t := add (scale (norm2 t) (square t))
  (add (scale (- 3 * det t) t) (scale (- (norm2 t * norm2 t) / 3) identity)).

Lemma cubic_derivative a0 a1 a2 a3 x :
  derivable_pt_lim (fun x => a0 + a1 * x + a2 * (x * x) + a3 * (x * x * x)) x
    (a1 + 2 * a2 * x + 3 * a3 * (x * x)).
Proof.
  assert (I := derivable_pt_lim_id x).
  assert (C := fun a => derivable_pt_lim_const a x).
  assert (I2 := derivable_pt_lim_mult _ _ _ _ _ I I).
  assert (I3 := derivable_pt_lim_mult _ _ _ _ _ I2 I).
  assert (H := derivable_pt_lim_plus _ _ _ _ _
    (derivable_pt_lim_plus _ _ _ _ _
      (derivable_pt_lim_plus _ _ _ _ _ (C a0) (derivable_pt_lim_mult _ _ _ _ _ (C a1) I))
      (derivable_pt_lim_mult _ _ _ _ _ (C a2) I2))
    (derivable_pt_lim_mult _ _ _ _ _ (C a3) I3)).
  unfold plus_fct, mult_fct, fct_cte, id in H.
  replace (a1 + 2 * a2 * x + 3 * a3 * (x * x)) with
    (0 + (0 * x + a1 * 1) + (0 * (x * x) + a2 * (1 * x + x * 1))
      + (0 * (x * x * x) + a3 * ((1 * x + x * 1) * x + x * x * 1))) by ring.
  exact H.
Qed.

(* The determinant along a line: its linear and quadratic coefficients. *)
Definition det_linear t u := inner u (add (square t)
  (add (scale (- trace t) t) (scale ((trace t * trace t - norm2 t) / 2) identity))).
Lemma det_line t u x : det (add t (scale x u))
  = det t + det_linear t u * x + det_linear u t * (x * x) + det u * (x * x * x).
Proof. destruct t, u. unfold det_linear, det, norm2, inner, trace, square, add, scale, identity. cbn. field. Qed.
Lemma norm2_line t u x : norm2 (add t (scale x u))
  = norm2 t + 2 * inner t u * x + norm2 u * (x * x) + 0 * (x * x * x).
Proof. unfold norm2, inner, add, scale; cbn; ring. Qed.

Lemma mode_line_derivative t u x : add t (scale x u) <> zero ->
  derivable_pt_lim (fun x => mode (add t (scale x u))) x (3 * sqrt 6 *
    ((2 * norm2 (add t (scale x u)) * (det_linear t u + 2 * det_linear u t * x + 3 * det u * (x * x))
      - 3 * det (add t (scale x u)) * (2 * inner t u + 2 * norm2 u * x))
     / (2 * norm (add t (scale x u)) * (norm2 (add t (scale x u)) * norm2 (add t (scale x u)))))).
Proof.
  intros N. assert (P := norm2_positive _ N).
  assert (DP := cubic_derivative (norm2 t) (2 * inner t u) (norm2 u) 0 x).
  assert (DQ := cubic_derivative (det t) (det_linear t u) (det_linear u t) (det u) x).
  set (p := fun x => norm2 t + 2 * inner t u * x + norm2 u * (x * x) + 0 * (x * x * x)) in *.
  set (q := fun x => det t + det_linear t u * x + det_linear u t * (x * x) + det u * (x * x * x)) in *.
  assert (EP : forall y, norm2 (add t (scale y u)) = p y) by (intros; apply norm2_line).
  assert (EQ : forall y, det (add t (scale y u)) = q y) by (intros; apply det_line).
  assert (D := quotient_derivative p q _ _ x (eq_rect _ (fun z => 0 < z) P _ (EP x)) DP DQ).
  assert (E := derivable_pt_lim_scal _ (3 * sqrt 6) _ _ D).
  intros eps H. destruct (E eps H) as [delta K]. exists delta. intros h H1 H2.
  assert (L := K h H1 H2). clear K E D. unfold mult_real_fct in L. unfold mode, norm.
  rewrite !EP, !EQ. unfold Rdiv in *. rewrite !(Rmult_assoc (3 * sqrt 6)).
  replace (2 * inner t u + 2 * norm2 u * x) with (2 * inner t u + 2 * norm2 u * x + 3 * 0 * (x * x)) by ring.
  exact L.
Qed.

Lemma mode_gradient t : t <> zero -> trace t = 0 -> exists k, 0 < k /\ forall u, trace u = 0 ->
  derivable_pt_lim (fun x => mode (add t (scale x u))) 0 (k * inner (dual t) u).
Proof.
  intros N T.
  assert (P := norm_positive t N). assert (P2 := norm2_positive t N). assert (S := sqrt6_positive).
  exists (3 * sqrt 6 / (norm t * (norm2 t * norm2 t))). split.
  - apply Rdiv_lt_0_compat; [lra|]. repeat apply Rmult_lt_0_compat; lra.
  - intros u U. assert (Z : add t (scale 0 u) = t) by (clear; tensor_ring).
    assert (D := mode_line_derivative t u 0). rewrite Z in D. assert (E := D N). clear D.
    replace (_ * inner _ _) with (3 * sqrt 6 *
      ((2 * norm2 t * (det_linear t u + 2 * det_linear u t * 0 + 3 * det u * (0 * 0))
       - 3 * det t * (2 * inner t u + 2 * norm2 u * 0)) / (2 * norm t * (norm2 t * norm2 t)))); [exact E|].
    assert (I : inner (dual t) u = norm2 t * det_linear t u - 3 * det t * inner t u).
    { assert (L : det_linear t u = inner u (square t)).
      { unfold det_linear. rewrite T, inner_sym, !inner_add, !inner_scale.
        replace (inner identity u) with (trace u) by (unfold inner, identity, trace; cbn; ring).
        rewrite U, (inner_sym u). ring. }
      rewrite L. unfold dual. rewrite !inner_add, !inner_scale, (inner_sym u).
      replace (inner identity u) with (trace u) by (unfold inner, identity, trace; cbn; ring).
      rewrite U. ring. }
    rewrite I. field. lra.
Qed.

Lemma mode_directional t u : t <> zero -> trace t = 0 -> trace u = 0 -> exists k, 0 < k /\
  derivable_pt_lim (fun x => mode (add t (scale x u))) 0 (k * inner (dual t) u).
Proof. intros N T U. destruct (mode_gradient t N T) as [k [K D]]. exists k. auto. Qed.

Lemma square_spectral l1 l2 l3 u v w : orthonormal u v w ->
  square (spectral l1 l2 l3 u v w) = spectral (l1 * l1) (l2 * l2) (l3 * l3) u v w.
Proof.
  intros O. apply tensor_by_form. intros a b.
  assert (F : forall t, form (square t) a b = dot (apply t a) (apply t b)) by (intros; clear; coordinates; ring).
  assert (S : forall t x, dot (apply t a) x = form t x a /\ dot (apply t b) x = form t x b)
    by (intros; split; apply dot_sym).
  rewrite F, (dot_resolved u v w _ _ O).
  set (t := spectral l1 l2 l3 u v w).
  rewrite (proj1 (S t u)), (proj1 (S t v)), (proj1 (S t w)), (proj2 (S t u)), (proj2 (S t v)), (proj2 (S t w)).
  unfold t. rewrite !form_spectral. destruct O as [A B C D E G].
  rewrite ?(dot_sym v u), ?(dot_sym w v), ?(dot_sym w u), ?A, ?B, ?C, ?D, ?E, ?G. ring.
Qed.

Lemma add_spectral a b c d e f u v w :
  add (spectral a b c u v w) (spectral d e f u v w) = spectral (a + d) (b + e) (c + f) u v w.
Proof. unfold spectral. tensor_ring. Qed.

(* The dual of eigenvalues t1, t2, t3 of sum 0. *)
Lemma dual_spectral t1 t2 t3 u v w : orthonormal u v w -> t1 + t2 + t3 = 0 ->
  let d := (t1 - t2) * (t2 - t3) * (t1 - t3) / 3 in
  dual (spectral t1 t2 t3 u v w)
  = spectral (d * (t2 - t3)) (d * (t3 - t1)) (d * (t1 - t2)) u v w.
Proof.
  intros O S d. unfold dual.
  rewrite (square_spectral _ _ _ _ _ _ O), (norm2_spectral _ _ _ _ _ _ O), (det_spectral _ _ _ _ _ _ O).
  rewrite (identity_spectral u v w O), !scale_spectral, !add_spectral. unfold d.
  replace t3 with (- t1 - t2) by lra. f_equal; field.
Qed.

Lemma spectral_injective a b c d e f u v w : orthonormal u v w ->
  spectral a b c u v w = spectral d e f u v w -> a = d /\ b = e /\ c = f.
Proof.
  intros O E. assert (H := f_equal (in_frame u v w) E).
  rewrite !spectral_from_frame, !(in_from_frame u v w _ O) in H. inversion H. auto.
Qed.

(* The dual vanishes exactly at degenerate tensors. *)
Lemma dual_zero t : trace t = 0 -> (dual t = zero <-> degenerate t).
Proof.
  intros T. split.
  - intros Z. destruct (spectral_theorem t) as [t1 [t2 [t3 [u [v [w [A [B [O E]]]]]]]]].
    assert (S : t1 + t2 + t3 = 0) by (rewrite <- T, E; symmetry; apply trace_spectral, O).
    rewrite E, (dual_spectral _ _ _ _ _ _ O S), <- (spectral_zero u v w) in Z.
    apply spectral_injective in Z; [|exact O]. destruct Z as [Z1 [_ Z3]].
    assert (D : t2 = t3 \/ t1 = t2).
    { destruct (Rmult_integral _ _ Z1) as [H|H]; [|left; lra].
      assert (K : (t1 - t2) * (t2 - t3) * (t1 - t3) = 0) by lra.
      destruct (Rmult_integral _ _ K) as [K1|K1]; [destruct (Rmult_integral _ _ K1); [right|left]; lra|].
      left. lra. }
    destruct D as [D|D].
    + exists t3, (t1 - t3), u. split; [apply O|]. rewrite E, D. apply equal_pair_degenerate, O.
    + exists t1, (t3 - t1), w. split; [apply O|]. rewrite E, D.
      rewrite spectral_rotate, spectral_rotate. apply equal_pair_degenerate. permuted_frame O.
  - intros D. destruct (degenerate_spectral t D) as [a [b [u [v [w [O E]]]]]].
    assert (S : b + a + a = 0) by (rewrite <- T, E; symmetry; apply trace_spectral, O).
    rewrite E, (dual_spectral _ _ _ _ _ _ O S), <- (spectral_zero u v w). f_equal; field.
Qed.

(* The dual of the dual is a multiple of the tensor, not zero unless it is degenerate or neutral. *)
Definition dual_factor t1 t2 t3 :=
  let d := (t1 - t2) * (t2 - t3) * (t1 - t3) / 3 in - 27 * (t1 * t2 * t3) * (d * d * (d * d)).
Lemma dual_dual t1 t2 t3 u v w : orthonormal u v w -> t1 + t2 + t3 = 0 ->
  dual (dual (spectral t1 t2 t3 u v w)) = scale (dual_factor t1 t2 t3) (spectral t1 t2 t3 u v w).
Proof.
  intros O S. rewrite (dual_spectral _ _ _ _ _ _ O S), dual_spectral; [|exact O|ring].
  rewrite scale_spectral. unfold dual_factor.
  set (d := (t1 - t2) * (t2 - t3) * (t1 - t3) / 3).
  assert (E : (d * (t2 - t3) - d * (t3 - t1)) * (d * (t3 - t1) - d * (t1 - t2)) * (d * (t2 - t3) - d * (t1 - t2)) / 3
    = 9 * (t1 * t2 * t3) * (d * d * d)) by (clearbody d; replace t3 with (- t1 - t2) by lra; field).
  rewrite E. clearbody d. f_equal; replace t3 with (- t1 - t2) by lra; ring.
Qed.
Lemma dual_scale k t : dual (scale k t) = scale (k * k * (k * k)) (dual t).
Proof. destruct t. unfold dual, norm2, inner, det, square, add, scale, identity. cbn. apply tensor_eq; cbn; field. Qed.
Lemma trace_dual t : trace t = 0 -> trace (dual t) = 0.
Proof.
  intros T. unfold dual. rewrite !trace_add, !trace_scale, T.
  replace (trace (square t)) with (norm2 t) by (clear; coordinates; ring).
  replace (trace identity) with 3 by (unfold trace, identity; cbn; ring). field.
Qed.
Lemma inner_dual t : trace t = 0 -> inner (dual t) t = 0.
Proof.
  intros T. destruct (spectral_theorem t) as [t1 [t2 [t3 [u [v [w [A [B [O E]]]]]]]]].
  assert (S : t1 + t2 + t3 = 0) by (rewrite <- T, E; symmetry; apply trace_spectral, O).
  rewrite E, (dual_spectral _ _ _ _ _ _ O S), inner_spectral, !form_spectral.
  destruct O as [O1 O2 O3 O4 O5 O6].
  rewrite ?(dot_sym v u), ?(dot_sym w v), ?(dot_sym w u), ?O1, ?O2, ?O3, ?O4, ?O5, ?O6.
  replace t3 with (- t1 - t2) by lra. field.
Qed.

(* mode(t)^2 + mode(dual t)^2 = 1. *)
Lemma mode_dual t : trace t = 0 -> dual t <> zero ->
  mode t * mode t + mode (dual t) * mode (dual t) = 1.
Proof.
  intros T N. assert (Z : t <> zero).
  { intros Z. apply N. apply dual_zero; [exact T|]. exists 0, 0, (Vector 1 0 0). subst.
    split; [unfold dot; cbn; ring|tensor_ring]. }
  assert (M1 := mode_squared t Z). assert (M2 := mode_squared _ N).
  assert (P1 := norm2_positive t Z). assert (P2 := norm2_positive _ N).
  destruct (spectral_theorem t) as [t1 [t2 [t3 [u [v [w [A [B [O E]]]]]]]]].
  assert (S : t1 + t2 + t3 = 0) by (rewrite <- T, E; symmetry; apply trace_spectral, O).
  set (m := mode t * mode t) in *. set (n := mode (dual t) * mode (dual t)) in *. clearbody m n.
  rewrite E in *. rewrite (dual_spectral _ _ _ _ _ _ O S) in *. clear E.
  rewrite !(norm2_spectral _ _ _ _ _ _ O) in *. rewrite !(det_spectral _ _ _ _ _ _ O) in *.
  set (d := (t1 - t2) * (t2 - t3) * (t1 - t3) / 3) in *.
  set (p := t1 * t1 + t2 * t2 + t3 * t3) in *.
  replace (_ + _ + _) with (3 * (d * d) * p) in P2 by (unfold p; replace t3 with (- t1 - t2) by lra; ring).
  replace (d * (t2 - t3) * (d * (t2 - t3)) + d * (t3 - t1) * (d * (t3 - t1)) + d * (t1 - t2) * (d * (t1 - t2)))
    with (3 * (d * d) * p) in M2 by (unfold p; replace t3 with (- t1 - t2) by lra; ring).
  assert (D0 : d <> 0) by (intros H; rewrite H in P2; lra).
  assert (D : 0 < d * d) by (apply square_pos; exact D0).
  (* det(dual)^2 = d^6 ((t1-t2)(t2-t3)(t1-t3))^2, and the discriminant identity *)
  assert (N2 : n * (p * p * p) = p * p * p - 54 * ((t1 * t2 * t3) * (t1 * t2 * t3))).
  { apply (Rmult_eq_reg_l (27 * (d * d * (d * d) * (d * d)))).
    - transitivity (n * (3 * (d * d) * p * (3 * (d * d) * p) * (3 * (d * d) * p))); [ring|]. rewrite M2.
      unfold p. replace t3 with (- t1 - t2) by lra. ring.
    - assert (0 < d * d * (d * d) * (d * d)) by (apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; exact D|exact D]). lra. }
  apply (Rmult_eq_reg_r (p * p * p)); [|assert (0 < p * p * p) by (apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; exact P1|exact P1]); lra].
  transitivity (m * (p * p * p) + n * (p * p * p)); [ring|]. rewrite M1, N2. ring.
Qed.
