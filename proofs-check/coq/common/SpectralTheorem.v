(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   The spectral theorem for symmetric 3x3 tensors.
   The characteristic polynomial is a cubic, so it has a real root. There the tensor less the root
   times the identity is singular, so some unit vector is an eigenvector. In the plane across it a
   symmetric 2x2 matrix is left, whose discriminant is a sum of two squares. *)
From TensorTopo Require Import Tensors Frames.
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

(* A cubic x^3 + a x^2 + b x + c has a real root: it changes its sign far out. *)
Lemma cubic_root a b c : exists x, x * x * x + a * (x * x) + b * x + c = 0.
Proof.
  set (f := fun x => x * x * x + a * (x * x) + b * x + c).
  set (m := 1 + Rabs a + Rabs b + Rabs c).
  assert (A := Rabs_pos a). assert (B := Rabs_pos b). assert (C := Rabs_pos c).
  assert (A1 := Rle_abs a). assert (B1 := Rle_abs b). assert (C1 := Rle_abs c).
  assert (A2 := Rle_abs (- a)). assert (B2 := Rle_abs (- b)). assert (C2 := Rle_abs (- c)).
  rewrite Rabs_Ropp in A2, B2, C2.
  assert (M : 1 <= m) by (unfold m; lra).
  assert (MM : m <= m * m) by nra.
  assert (E : m * m * m = m * m + Rabs a * (m * m) + Rabs b * (m * m) + Rabs c * (m * m))
    by (unfold m; ring).
  assert (P1 : 0 <= (Rabs a - a) * (m * m)) by (apply Rmult_le_pos; nra).
  assert (P2 : 0 <= (Rabs a + a) * (m * m)) by (apply Rmult_le_pos; nra).
  assert (Q1 : 0 <= (Rabs b - b) * m) by (apply Rmult_le_pos; lra).
  assert (Q2 : 0 <= (Rabs b + b) * m) by (apply Rmult_le_pos; lra).
  assert (Q3 : 0 <= Rabs b * (m * m - m)) by (apply Rmult_le_pos; lra).
  assert (R3 : 0 <= Rabs c * (m * m - 1)) by (apply Rmult_le_pos; lra).
  assert (F1 : 0 < f m) by (unfold f; lra).
  assert (F2 : f (- m) < 0).
  { unfold f. replace (- m * - m * - m) with (- (m * m * m)) by ring.
    replace (- m * - m) with (m * m) by ring. lra. }
  destruct (IVT f (- m) m) as [x [_ X]]; auto; [unfold f; reg|lra|].
  exists x. exact X.
Qed.

Lemma unit_multiple y : y <> zero_vector -> exists k, k <> 0 /\ dot (scale_vector k y) (scale_vector k y) = 1.
Proof.
  intros N. assert (Q := dot_positive y N).
  assert (S : 0 < sqrt (dot y y)) by (apply sqrt_lt_R0; exact Q).
  assert (SS : sqrt (dot y y) * sqrt (dot y y) = dot y y) by (apply sqrt_sqrt; lra).
  exists (/ sqrt (dot y y)). split; [apply Rinv_neq_0_compat; lra|].
  set (r := sqrt (dot y y)) in *.
  transitivity (/ r * / r * dot y y); [clear; coordinates; ring|]. rewrite <- SS. field. lra.
Qed.

(* A singular tensor maps a unit vector to zero: a cross product of two rows, or, if all of these
   are zero, a vector perpendicular to the one row that is left. *)
Lemma kernel t : det t = 0 -> exists v, dot v v = 1 /\ apply t v = zero_vector.
Proof.
  intros D.
  assert (K : exists y, y <> zero_vector /\ apply t y = zero_vector).
  { set (r1 := Vector (xx t) (xy t) (xz t)). set (r2 := Vector (xy t) (yy t) (yz t)).
    set (r3 := Vector (xz t) (yz t) (zz t)).
    assert (AP : forall y, apply t y = Vector (dot r1 y) (dot r2 y) (dot r3 y)) by
      (intros; unfold r1, r2, r3; clear; coordinates; reflexivity).
    assert (V1 : dot r1 (cross r2 r3) = 0) by (rewrite <- D; unfold r1, r2, r3; clear; coordinates; ring).
    assert (V2 : dot r2 (cross r3 r1) = 0) by (rewrite <- D; unfold r1, r2, r3; clear; coordinates; ring).
    assert (V3 : dot r3 (cross r1 r2) = 0) by (rewrite <- D; unfold r1, r2, r3; clear; coordinates; ring).
    assert (X : forall a b, dot a (cross a b) = 0) by (intros; clear; coordinates; ring).
    assert (Y : forall a b, dot b (cross a b) = 0) by (intros; clear; coordinates; ring).
    destruct (Req_dec (dot (cross r2 r3) (cross r2 r3)) 0) as [A|A].
    2:{ exists (cross r2 r3). split; [intros Z; rewrite Z in A; apply A; unfold dot; cbn; ring|].
        rewrite AP, V1, X, Y. reflexivity. }
    destruct (Req_dec (dot (cross r3 r1) (cross r3 r1)) 0) as [B|B].
    2:{ exists (cross r3 r1). split; [intros Z; rewrite Z in B; apply B; unfold dot; cbn; ring|].
        rewrite AP, V2, X, Y. reflexivity. }
    destruct (Req_dec (dot (cross r1 r2) (cross r1 r2)) 0) as [C|C].
    2:{ exists (cross r1 r2). split; [intros Z; rewrite Z in C; apply C; unfold dot; cbn; ring|].
        rewrite AP, V3, X, Y. reflexivity. }
    apply dot_zero in A. apply dot_zero in B. apply dot_zero in C.
    (* Rows parallel: what is perpendicular to one that is not zero is so to all. *)
    assert (P : forall a b y, dot a a <> 0 -> cross a b = zero_vector -> dot a y = 0 -> dot b y = 0).
    { intros a b y N Z H. assert (I : dot a a * dot b y = dot a b * dot a y + dot (cross (cross a b) a) y)
        by (clear; coordinates; ring).
      rewrite Z, H in I. replace (dot (cross zero_vector a) y) with 0 in I by (clear; coordinates; ring).
      assert (W : dot a a * dot b y = 0) by lra. destruct (Rmult_integral _ _ W); [contradiction|assumption]. }
    assert (AC : forall a b, cross a b = zero_vector -> cross b a = zero_vector).
    { intros a b Z. assert (Z1 := f_equal vx Z). assert (Z2 := f_equal vy Z). assert (Z3 := f_equal vz Z).
      cbn in *. apply vector_eq; cbn; lra. }
    assert (PU : forall a, dot a a <> 0 -> exists y, y <> zero_vector /\ dot a y = 0).
    { intros a N. destruct (unit_multiple a) as [k [K1 K2]].
      { intros Z. apply N. rewrite Z. unfold dot; cbn; ring. }
      destruct (perpendicular_unit _ K2) as [y [Y1 Y2]]. exists y. split.
      - intros Z. rewrite Z in Y1. unfold dot in Y1; cbn in Y1. lra.
      - assert (k * dot a y = 0) by (rewrite <- Y2; clear; coordinates; ring).
        destruct (Rmult_integral _ _ H); [contradiction|assumption]. }
    destruct (Req_dec (dot r1 r1) 0) as [N1|N1].
    2:{ destruct (PU r1 N1) as [y [Y1 Y2]]. exists y. split; auto.
        rewrite AP, Y2, (P r1 r2 y), (P r1 r3 y); auto. }
    destruct (Req_dec (dot r2 r2) 0) as [N2|N2].
    2:{ destruct (PU r2 N2) as [y [Y1 Y2]]. exists y. split; auto.
        rewrite AP, Y2, (P r2 r3 y), (P r2 r1 y); auto. }
    destruct (Req_dec (dot r3 r3) 0) as [N3|N3].
    2:{ destruct (PU r3 N3) as [y [Y1 Y2]]. exists y. split; auto.
        rewrite AP, Y2, (P r3 r1 y), (P r3 r2 y); auto. }
    apply dot_zero in N1. apply dot_zero in N2. apply dot_zero in N3.
    exists (Vector 1 0 0). split; [intros Z; apply (f_equal vx) in Z; cbn in Z; lra|].
    rewrite AP, N1, N2, N3. apply vector_eq; unfold dot; cbn; ring. }
  destruct K as [y [N K]]. destruct (unit_multiple y N) as [k [_ U]].
  exists (scale_vector k y). split; auto.
  assert (S : apply t (scale_vector k y) = scale_vector k (apply t y)) by (clear; vector_ring).
  rewrite S, K. vector_ring.
Qed.

Lemma eigenvector t : exists l v, dot v v = 1 /\ apply t v = scale_vector l v.
Proof.
  set (m2 := xx t * yy t - xy t * xy t + yy t * zz t - yz t * yz t + xx t * zz t - xz t * xz t).
  destruct (cubic_root (- trace t) m2 (- det t)) as [l L].
  assert (Z : det (sub t (scale l identity)) = 0).
  { transitivity (- (l * l * l + - trace t * (l * l) + m2 * l + - det t));
      [unfold m2; clear; coordinates; ring|rewrite L; ring]. }
  destruct (kernel _ Z) as [v [V K]]. exists l, v. split; auto.
  assert (S : apply t v = add_vectors (apply (sub t (scale l identity)) v) (scale_vector l v))
    by (clear; vector_ring).
  rewrite S, K. vector_ring.
Qed.

(* A symmetric 2x2 matrix [[p, q], [q, r]] is diagonal after a turn. *)
Lemma turn_diagonal p q r : exists c s, c * c + s * s = 1 /\ (r - p) * (c * s) + q * (c * c - s * s) = 0.
Proof.
  set (f := fun t => (r - p) * (cos t * sin t) + q * (cos t * cos t - sin t * sin t)).
  assert (C : continuity f) by
    (unfold f; apply derivable_continuous; reg).
  destruct (IVT_cor f 0 (PI / 2)) as [t [_ T]]; auto.
  - assert (P := PI_RGT_0). lra.
  - unfold f. rewrite cos_0, sin_0, cos_PI2, sin_PI2.
    replace (_ * _) with (- (q * q)) by ring. assert (S := square_nonneg q). lra.
  - exists (cos t), (sin t). split; [|exact T].
    assert (S := sin2_cos2 t). unfold Rsqr in S. lra.
Qed.

Lemma spectral_some_order t : exists l1 l2 l3 u v w, orthonormal u v w /\ t = spectral l1 l2 l3 u v w.
Proof.
  destruct (eigenvector t) as [l [w [W A]]].
  destruct (frame_from_unit w W) as [u [v O]].
  assert (O' : orthonormal u v w) by (apply orthonormal_rotate; exact O).
  assert (F1 : form t u w = 0).
  { unfold form. rewrite A. transitivity (l * dot w u); [clear; coordinates; ring|].
    rewrite (perp_12 _ _ _ O). ring. }
  assert (F2 : form t v w = 0).
  { unfold form. rewrite A. transitivity (l * dot w v); [clear; coordinates; ring|].
    rewrite (perp_13 _ _ _ O). ring. }
  destruct (turn_diagonal (form t u u) (form t u v) (form t v v)) as [c [s [H D]]].
  set (a := combine c s 0 u v w). set (b := combine (- s) c 0 u v w).
  assert (N := turned_frame u v w c s O' H). fold a b in N.
  exists (form t a a), (form t b b), (form t w w), a, b, w. split; [exact N|].
  rewrite <- (from_in_frame a b w t N) at 1.
  assert (Z1 : form t b w = 0).
  { unfold b. rewrite form_combine, F1, F2. ring. }
  assert (Z2 : form t a w = 0).
  { unfold a. rewrite form_combine, F1, F2. ring. }
  assert (Z3 : form t a b = 0).
  { unfold a. rewrite form_combine, !(form_sym t _ b). unfold b.
    rewrite !form_combine, (form_sym t v u).
    transitivity ((form t v v - form t u u) * (c * s) + form t u v * (c * c - s * s));
      [ring|exact D]. }
  unfold from_frame, in_frame. cbn [xx yy zz xy yz xz]. rewrite Z1, Z2, Z3. tensor_ring.
Qed.

(* Three numbers can be put in order. *)
Theorem spectral_theorem t : exists l1 l2 l3 u v w,
  l1 >= l2 /\ l2 >= l3 /\ orthonormal u v w /\ t = spectral l1 l2 l3 u v w.
Proof.
  destruct (spectral_some_order t) as [a [b [c [u [v [w [O E]]]]]]].
  destruct (Rle_dec b a) as [AB|AB]; destruct (Rle_dec c b) as [BC|BC];
    destruct (Rle_dec c a) as [AC|AC]; try lra;
    [exists a, b, c, u, v, w | exists a, c, b, u, w, v | exists c, a, b, w, u, v
    |exists b, a, c, v, u, w | exists b, c, a, v, w, u | exists c, b, a, w, v, u];
    (split; [lra|split; [lra|split; [permuted_frame O|rewrite E; unfold spectral; tensor_ring]]]).
Qed.
