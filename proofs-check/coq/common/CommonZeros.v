(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   Two traceless quadratic forms in three variables have a common zero. The first, in the frame of
   its eigenvectors, vanishes on a closed curve through the four vectors (+-1, +-1, 1) / sqrt(3);
   on these the second has the sum 0, so it changes its sign along the curve. *)
From TensorTopo Require Import Tensors Frames SpectralTheorem.
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

(* A polynomial in functions whose continuity is known is continuous. *)
Ltac continuous_polynomial :=
  repeat lazymatch goal with
  | |- continuity (fun x => @?f x + @?g x) => apply (continuity_plus f g)
  | |- continuity (fun x => @?f x * @?g x) => apply (continuity_mult f g)
  | _ => first [assumption|intros ?; apply continuity_pt_const; intros ? ?; reflexivity]
  end.

Lemma form_in_frame t x y z u v w :
  form t (combine x y z u v w) (combine x y z u v w)
  = form t u u * (x * x) + form t v v * (y * y) + form t w w * (z * z)
    + 2 * (form t u v * (x * y) + form t v w * (y * z) + form t u w * (x * z)).
Proof.
  rewrite form_combine, !(form_sym t _ (combine _ _ _ _ _ _)), !form_combine.
  rewrite (form_sym t v u), (form_sym t w v), (form_sym t w u). ring.
Qed.
Lemma dot_in_frame x y z u v w : orthonormal u v w ->
  dot (combine x y z u v w) (combine x y z u v w) = x * x + y * y + z * z.
Proof.
  intros [A B C D E F]. rewrite dot_combine, !(dot_sym _ (combine _ _ _ _ _ _)), !dot_combine.
  rewrite ?(dot_sym v u), ?(dot_sym w v), ?(dot_sym w u), ?A, ?B, ?C, ?D, ?E, ?F. ring.
Qed.
Lemma form_spectral_combine a b c x y z u v w : orthonormal u v w ->
  let p := combine x y z u v w in form (spectral a b c u v w) p p = a * (x * x) + b * (y * y) + c * (z * z).
Proof.
  intros O p. unfold p. rewrite form_in_frame, !form_spectral. destruct O as [A B C D E F].
  rewrite ?(dot_sym v u), ?(dot_sym w v), ?(dot_sym w u), ?A, ?B, ?C, ?D, ?E, ?F. ring.
Qed.

Lemma unit_vector p : p <> zero_vector -> exists k, k <> 0 /\ dot (scale_vector k p) (scale_vector k p) = 1.
Proof. exact (unit_multiple p). Qed.
Lemma form_scale_vector t k p : form t (scale_vector k p) (scale_vector k p) = k * k * form t p p.
Proof. coordinates; ring. Qed.

(* With eigenvalues a >= b >= 0 > c. *)
Lemma zero_on_curve a b c u v w n : orthonormal u v w -> 0 <= b -> 0 < a -> a + b + c = 0 ->
  trace n = 0 -> exists p, p <> zero_vector /\ form (spectral a b c u v w) p p = 0 /\ form n p p = 0.
Proof.
  intros O B A S T.
  set (g := fun t => (a * (cos t * cos t) + b * (sin t * sin t)) / (a + b)).
  assert (G : forall t, 0 <= g t).
  { intros t. apply Rmult_le_pos; [|left; apply Rinv_0_lt_compat; lra].
    assert (X := square_nonneg (cos t)). assert (Y := square_nonneg (sin t)). nra. }
  set (h := fun t => sqrt (g t)).
  assert (H : forall t, h t * h t = g t) by (intros; apply sqrt_sqrt, G).
  set (p := fun t => combine (cos t) (sin t) (h t) u v w).
  set (f := fun t => form n u u * (cos t * cos t) + form n v v * (sin t * sin t) + form n w w * (h t * h t)
      + 2 * (form n u v * (cos t * sin t) + form n v w * (sin t * h t) + form n u w * (cos t * h t))).
  assert (Fp : forall t, form n (p t) (p t) = f t) by (intros; apply form_in_frame).
  assert (One : forall t, cos t * cos t + sin t * sin t = 1).
  { intros t. assert (E := sin2_cos2 t). unfold Rsqr in E. lra. }
  assert (P1 : forall t, p t <> zero_vector).
  { intros t Z. assert (E := dot_in_frame (cos t) (sin t) (h t) u v w O). fold (p t) in E.
    rewrite Z in E. unfold dot, zero_vector in E. cbn in E. assert (X := One t).
    assert (Y := square_nonneg (h t)). lra. }
  assert (P2 : forall t, form (spectral a b c u v w) (p t) (p t) = 0).
  { intros t. unfold p. rewrite (form_spectral_combine a b c _ _ _ u v w O), H. unfold g.
    replace c with (- a - b) by lra. field. lra. }
  assert (C : continuity f).
  { assert (Cc := continuity_cos). assert (Cs := continuity_sin).
    assert (Ch : continuity h).
    { intros t. apply (continuity_pt_comp g sqrt); [|apply continuity_pt_sqrt, G].
      unfold g, Rdiv. apply (continuity_pt_mult _ (fun _ => / (a + b))); [|apply continuity_pt_const; intros ? ?; reflexivity].
      apply derivable_continuous_pt. reg. }
    unfold f. continuous_polynomial. }
  (* the four vectors *)
  set (r := / sqrt 2).
  assert (R2 : r * r = / 2) by (unfold r; rewrite <- Rinv_mult; f_equal; apply sqrt_sqrt; lra).
  assert (Q : forall t, cos t * cos t = / 2 -> sin t * sin t = / 2 -> h t = r).
  { intros t X Y. unfold h, g. rewrite X, Y. unfold r.
    replace ((a * / 2 + b * / 2) / (a + b)) with (/ 2) by (field; lra).
    rewrite sqrt_inv. reflexivity. }
  assert (C4 : cos (PI / 4) = r) by (rewrite cos_PI4; unfold r; field; apply Rgt_not_eq, sqrt_lt_R0; lra).
  assert (S4 : sin (PI / 4) = r) by (rewrite sin_PI4; unfold r; field; apply Rgt_not_eq, sqrt_lt_R0; lra).
  set (t1 := PI / 4). set (t2 := PI / 4 + PI / 2). set (t3 := PI / 4 + PI). set (t4 := PI / 4 + PI + PI / 2).
  assert (A1 : cos t1 = r /\ sin t1 = r) by (split; assumption).
  assert (A2 : cos t2 = - r /\ sin t2 = r).
  { unfold t2. rewrite cos_plus, sin_plus, cos_PI2, sin_PI2, C4, S4. split; ring. }
  assert (A3 : cos t3 = - r /\ sin t3 = - r) by (unfold t3; rewrite neg_cos, neg_sin, C4, S4; split; ring).
  assert (A4 : cos t4 = r /\ sin t4 = - r).
  { unfold t4. rewrite (cos_plus (PI / 4 + PI)), (sin_plus (PI / 4 + PI)), cos_PI2, sin_PI2, neg_cos, neg_sin, C4, S4. split; ring. }
  assert (V : forall t x y, cos t = x -> sin t = y -> x * x = / 2 -> y * y = / 2 ->
    f t = (form n u u + form n v v + form n w w) / 2 + 2 * (form n u v * (x * y) + form n v w * (y * r) + form n u w * (x * r))).
  { intros t x y X Y X2 Y2. unfold f.
    rewrite (Q t) by (rewrite ?X, ?Y; assumption). rewrite X, Y, X2, Y2, R2. field. }
  assert (Tr : form n u u + form n v v + form n w w = 0).
  { rewrite <- (trace_in_frame u v w n O) in T. exact T. }
  assert (N2 : - r * - r = / 2) by (rewrite <- R2; ring).
  assert (F1 := V t1 _ _ (proj1 A1) (proj2 A1) R2 R2). assert (F2 := V t2 _ _ (proj1 A2) (proj2 A2) N2 R2).
  assert (F3 := V t3 _ _ (proj1 A3) (proj2 A3) N2 N2). assert (F4 := V t4 _ _ (proj1 A4) (proj2 A4) R2 N2).
  assert (Sum : f t1 + f t2 + f t3 + f t4 = 0) by (rewrite F1, F2, F3, F4, Tr; field).
  clear F1 F2 F3 F4. assert (Pi := PI_RGT_0).
  assert (I : forall x y, x <= y -> f x * f y <= 0 -> exists t, f t = 0).
  { intros x y L D. destruct (IVT_cor f x y C L D) as [t [_ Z]]. exists t. exact Z. }
  assert (Z : exists t, f t = 0).
  { destruct (Rle_dec (f t1 * f t2) 0) as [D|D2]; [apply (I t1 t2); [unfold t1, t2; lra|exact D]|].
    destruct (Rle_dec (f t1 * f t3) 0) as [D|D3]; [apply (I t1 t3); [unfold t1, t3; lra|exact D]|].
    destruct (Rle_dec (f t1 * f t4) 0) as [D|D4]; [apply (I t1 t4); [unfold t1, t4; lra|exact D]|].
    exfalso. assert (E' : f t1 * (f t1 + f t2 + f t3 + f t4) = 0) by (rewrite Sum; ring).
    assert (W := square_nonneg (f t1)). lra. }
  destruct Z as [t Z]. exists (p t). rewrite Fp. auto.
Qed.

Theorem common_zero m n : trace m = 0 -> trace n = 0 ->
  exists e, dot e e = 1 /\ form m e e = 0 /\ form n e e = 0.
Proof.
  intros M N.
  assert (K : forall m n, trace m = 0 -> trace n = 0 -> m <> zero ->
    exists p, p <> zero_vector /\ form m p p = 0 /\ form n p p = 0).
  { clear. intros m n M N Z. destruct (spectral_theorem m) as [a [b [c [u [v [w [A [B [O E]]]]]]]]].
    assert (S : a + b + c = 0) by (rewrite <- M, E; symmetry; apply trace_spectral, O).
    assert (P : 0 < a).
    { apply Rnot_le_lt. intros H. apply Z. rewrite E. replace a with 0 by lra. replace b with 0 by lra.
      replace c with 0 by lra. unfold spectral. tensor_ring. }
    destruct (Rle_dec 0 b) as [H|H].
    - rewrite E. apply zero_on_curve; auto.
    - (* the opposite tensor, its eigenvalues in the opposite order *)
      destruct (zero_on_curve (- c) (- b) (- a) w v u n) as [p [P1 [P2 P3]]]; try lra; [permuted_frame O|].
      exists p. split; [exact P1|]. split; [|exact P3]. rewrite E.
      rewrite form_spectral in P2 |- *. lra. }
  assert (L : exists p, p <> zero_vector /\ form m p p = 0 /\ form n p p = 0).
  { destruct (Req_dec (norm2 m) 0) as [H|H].
    - apply norm2_zero in H. destruct (Req_dec (norm2 n) 0) as [H'|H'].
      + apply norm2_zero in H'. exists (Vector 1 0 0). rewrite H, H'. split.
        * intros Z. apply (f_equal vx) in Z. cbn in Z. lra.
        * split; unfold form, dot, apply, zero; cbn; ring.
      + destruct (K n m N M) as [p [P1 [P2 P3]]]; [intros Z; apply H'; rewrite Z; unfold norm2, inner, zero; cbn; ring|].
        exists p. auto.
    - apply K; auto. intros Z. apply H. rewrite Z. unfold norm2, inner, zero. cbn. ring. }
  destruct L as [p [P1 [P2 P3]]]. destruct (unit_vector p P1) as [k [_ U]].
  exists (scale_vector k p). rewrite !form_scale_vector, P2, P3. repeat split; auto; ring.
Qed.
