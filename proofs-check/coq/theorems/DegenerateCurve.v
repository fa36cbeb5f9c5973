(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   The degenerate points of a field of rank 4, with those at infinity, are one closed curve if the
   characteristic determinant is negative: dominant eigenvectors are the zeros of the quadratic form
   of N, a cone with one sheet above each direction of the plane of e1 and e2. Each degenerate point
   is on an arc of degenerate points of its mode that goes to infinity, because some degenerate point
   is at infinity. *)
From TensorTopo Require Import Tensors Frames SpectralTheorem CommonZeros DegeneratePointsOfPlane
  Calculus.
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

Definition height b1 b2 b3 t := sqrt ((b1 * (cos t * cos t) + b2 * (sin t * sin t)) / - b3).
Definition curve b1 b2 b3 e1 e2 e3 t := combine (cos t) (sin t) (height b1 b2 b3 t) e1 e2 e3.

Lemma unit_circle t : cos t * cos t + sin t * sin t = 1.
Proof. assert (E := sin2_cos2 t). unfold Rsqr in E. lra. Qed.
Lemma height_squared b1 b2 b3 t : 0 < b2 -> b2 <= b1 -> b3 < 0 ->
  0 < height b1 b2 b3 t /\ b1 * (cos t * cos t) + b2 * (sin t * sin t)
    + b3 * (height b1 b2 b3 t * height b1 b2 b3 t) = 0.
Proof.
  intros A B C. assert (U := unit_circle t). assert (X := square_nonneg (cos t)). assert (Y := square_nonneg (sin t)).
  assert (P : 0 < (b1 * (cos t * cos t) + b2 * (sin t * sin t)) / - b3) by (apply Rdiv_lt_0_compat; nra).
  unfold height. split; [apply sqrt_lt_R0; exact P|]. rewrite sqrt_sqrt by lra. field. lra.
Qed.
Lemma angle_exists x y : x * x + y * y = 1 -> exists t, - PI <= t <= PI /\ cos t = x /\ sin t = y.
Proof.
  intros H. assert (X : -1 <= x <= 1) by (assert (Y := square_nonneg y); split; nra).
  assert (B := arc_cosine_bound x). assert (Pi := PI_RGT_0).
  assert (S : sin (arc_cosine x) * sin (arc_cosine x) = y * y).
  { assert (U := unit_circle (arc_cosine x)). rewrite cos_arc_cosine in U by exact X. lra. }
  assert (S0 : 0 <= sin (arc_cosine x)) by (apply sin_ge_0; lra).
  destruct (Rle_dec 0 y) as [Y|Y].
  - exists (arc_cosine x). split; [lra|]. split; [apply cos_arc_cosine, X|nra].
  - exists (- arc_cosine x). split; [lra|]. rewrite cos_neg, sin_neg. split; [apply cos_arc_cosine, X|nra].
Qed.

Theorem degenerate_curve b1 b2 b3 e1 e2 e3 : orthonormal e1 e2 e3 -> b1 + b2 + b3 = 0 ->
  b1 >= b2 -> b2 > 0 -> let N := spectral b1 b2 b3 e1 e2 e3 in let p := curve b1 b2 b3 e1 e2 e3 in
  (forall t, form N (p t) (p t) = 0 /\ 1 <= dot (p t) (p t)) /\
  (forall x, x <> zero_vector -> form N x x = 0 ->
    exists t k, - PI <= t <= PI /\ k <> 0 /\ x = scale_vector k (p t)) /\
  (forall t t' k, p t = scale_vector k (p t') -> cos t = cos t' /\ sin t = sin t').
Proof.
  intros O S A B N p. assert (C : b3 < 0) by lra.
  assert (H := fun t => height_squared b1 b2 b3 t B ltac:(lra) C).
  split; [|split].
  - intros t. unfold p, curve, N. rewrite (form_spectral_combine b1 b2 b3 _ _ _ e1 e2 e3 O), (dot_in_frame _ _ _ _ _ _ O).
    split; [apply H|]. assert (U := unit_circle t). assert (Q := square_nonneg (height b1 b2 b3 t)). lra.
  - intros x Nz Z. set (X := dot x e1). set (Y := dot x e2). set (W := dot x e3).
    assert (R : x = combine X Y W e1 e2 e3) by (apply resolve; exact O).
    assert (F : b1 * (X * X) + b2 * (Y * Y) + b3 * (W * W) = 0).
    { rewrite <- Z. unfold N. rewrite R. symmetry. apply (form_spectral_combine b1 b2 b3 X Y W e1 e2 e3 O). }
    assert (X0 := square_nonneg X). assert (Y0 := square_nonneg Y). assert (W0 := square_nonneg W).
    assert (D : 0 < X * X + Y * Y).
    { apply Rnot_le_lt. intros K. assert (X * X = 0) by lra. assert (Y * Y = 0) by lra.
      assert (W * W = 0) by nra. apply Nz. rewrite R, (square_zero X), (square_zero Y), (square_zero W) by assumption.
      unfold combine. clear. vector_ring. }
    set (r := sqrt (X * X + Y * Y)). assert (Rp : 0 < r) by (apply sqrt_lt_R0; exact D).
    assert (RR : r * r = X * X + Y * Y) by (apply sqrt_sqrt; lra).
    assert (K : exists k, k <> 0 /\ k * k = r * r /\ 0 <= k * W).
    { destruct (Rle_dec 0 W) as [P|P]; [exists r|exists (- r)]; repeat split; try lra; nra. }
    destruct K as [k [K0 [KK KW]]].
    destruct (angle_exists (X / k) (Y / k)) as [t [T [Ct St]]].
    { transitivity ((X * X + Y * Y) / (k * k)); [field; exact K0|rewrite KK, RR; field; lra]. }
    exists t, k. split; [exact T|]. split; [exact K0|].
    assert (Cx : X = k * cos t) by (rewrite Ct; field; exact K0).
    assert (Sx : Y = k * sin t) by (rewrite St; field; exact K0).
    destruct (H t) as [Hp He]. set (h := height b1 b2 b3 t) in *.
    assert (Wx : W = k * h).
    { assert (E : b3 * ((W - k * h) * (W + k * h)) = 0).
      { transitivity ((b1 * (X * X) + b2 * (Y * Y) + b3 * (W * W))
          - k * k * (b1 * (cos t * cos t) + b2 * (sin t * sin t) + b3 * (h * h))); [rewrite Cx, Sx; ring|].
        rewrite F, He. ring. }
      destruct (Rmult_integral _ _ E) as [|E']; [lra|]. destruct (Rmult_integral _ _ E') as [G|G]; [lra|].
      assert (Q : k * W = - (k * k * h)) by (replace W with (- (k * h)) by lra; ring).
      assert (0 < k * k) by (apply square_pos; exact K0).
      assert (0 < k * k * h) by (apply Rmult_lt_0_compat; assumption). lra. }
    rewrite R, Cx, Sx, Wx. unfold p, curve. fold h. unfold combine. generalize (cos t) (sin t) h.
    clear. intros. vector_ring.
  - intros t t' k E. destruct (H t) as [Hp _]. destruct (H t') as [Hp' _].
    assert (E1 := f_equal (fun x => dot x e1) E). assert (E2 := f_equal (fun x => dot x e2) E).
    assert (E3 := f_equal (fun x => dot x e3) E). cbv beta in E1, E2, E3.
    assert (Sc : forall x y, dot (scale_vector k x) y = k * dot x y) by (intros; clear; coordinates; ring).
    unfold p, curve in E1, E2, E3. destruct O as [O1 O2 O3 O4 O5 O6].
    assert (O4' := O4). assert (O5' := O5). assert (O6' := O6).
    rewrite dot_sym in O4', O5', O6'.
    rewrite Sc, !dot_combine, O1, O4', O6' in E1.
    rewrite Sc, !dot_combine, O2, O4, O5' in E2.
    rewrite Sc, !dot_combine, O3, O5, O6 in E3.
    assert (U := unit_circle t). assert (U' := unit_circle t').
    assert (C1 : cos t = k * cos t') by lra. assert (S1 : sin t = k * sin t') by lra.
    assert (H1 : height b1 b2 b3 t = k * height b1 b2 b3 t') by lra.
    assert (K2 : (k - 1) * (k + 1) = 0).
    { transitivity (k * k * (cos t' * cos t' + sin t' * sin t') - 1); [rewrite U'; ring|].
      rewrite <- U, C1, S1. ring. }
    assert (K1 : k = 1) by (destruct (Rmult_integral _ _ K2); [lra|nra]).
    rewrite K1 in C1, S1. lra.
Qed.

(* The first zero of a continuous function after a place where it is positive. *)
Lemma first_zero f a b : continuity f -> a < b -> 0 < f a -> f b = 0 ->
  exists c, a < c <= b /\ f c = 0 /\ forall x, a <= x < c -> 0 < f x.
Proof.
  intros C L A B. set (E := fun x => a <= x <= b /\ forall y, a <= y <= x -> 0 < f y).
  assert (Ea : E a) by (split; [lra|intros y Y; replace y with a by lra; exact A]).
  destruct (completeness E) as [m [Up Least]]; [exists b; intros x [X _]; lra|exists a; exact Ea|].
  assert (Am : a <= m) by (apply Up, Ea).
  assert (Mb : m <= b) by (apply Least; intros x [X _]; lra).
  assert (Before : forall y, a <= y < m -> 0 < f y).
  { intros y Y. destruct (Rlt_dec 0 (f y)) as [P|P]; [exact P|exfalso].
    assert (m <= y); [|lra]. apply Least. intros x [X Q]. apply Rnot_lt_le. intros K. apply P, Q. lra. }
  assert (Z : f m = 0).
  { destruct (Rtotal_order (f m) 0) as [N|[Z|P]]; [exfalso|exact Z|exfalso].
    - destruct (continuous_near f m (- f m) (C m) ltac:(lra)) as [d [D K]].
      assert (M : a < m) by (destruct Am as [H|H]; [exact H|subst m; lra]).
      set (x := Rmax a (m - d / 2)).
      assert (X : a <= x < m) by (unfold x; split; [apply Rmax_l|apply Rmax_lub_lt; lra]).
      assert (X2 := Rmax_r a (m - d / 2)). fold x in X2.
      assert (Q := K x ltac:(apply Rabs_def1; lra)). apply Rabs_def2 in Q. assert (W := Before x X). lra.
    - destruct (continuous_near f m (f m) (C m) P) as [d [D K]].
      assert (M : m < b) by (destruct Mb as [H|H]; [exact H|subst m; lra]).
      set (x := Rmin b (m + d / 2)).
      assert (X : m < x) by (unfold x; apply Rmin_glb_lt; lra).
      assert (X1 := Rmin_l b (m + d / 2)). assert (X2 := Rmin_r b (m + d / 2)). fold x in X1, X2.
      assert (Ex : E x).
      { split; [lra|]. intros y Y. destruct (Rlt_dec y m) as [H|H]; [apply Before; lra|].
        assert (Q := K y ltac:(apply Rabs_def1; lra)). apply Rabs_def2 in Q. lra. }
      assert (W := Up x Ex). lra. }
  exists m. split; [split; [destruct Am as [H|H]; [exact H|subst m; lra]|exact Mb]|]. split; [exact Z|exact Before].
Qed.

(* The tensors e e^T - |e|^2/3 I, of mode 1, for e on the curve; c is the linear form that vanishes
   at infinity: the point in space is the tensor over its value, of mode 1 where that is positive. *)
Definition degenerate_of e := deviator (dyad e).
Definition weight c e := inner c (degenerate_of e).

Lemma weight_form c e : weight c e = form (deviator c) e e.
Proof. unfold weight, degenerate_of. destruct c, e. unfold form, dot, apply, inner, deviator, dyad, sub, add, scale, identity, trace. cbn. field. Qed.

Lemma weight_continuous b1 b2 b3 e1 e2 e3 c : b1 >= b2 -> b2 > 0 -> b3 < 0 ->
  continuity (fun t => weight c (curve b1 b2 b3 e1 e2 e3 t)).
Proof.
  intros A B N. set (p := curve b1 b2 b3 e1 e2 e3).
  set (g := fun t => weight c (p t)).
  set (d := deviator c).
  assert (G : forall t, form d e1 e1 * (cos t * cos t) + form d e2 e2 * (sin t * sin t) + form d e3 e3 * (height b1 b2 b3 t * height b1 b2 b3 t)
      + 2 * (form d e1 e2 * (cos t * sin t) + form d e2 e3 * (sin t * height b1 b2 b3 t) + form d e1 e3 * (cos t * height b1 b2 b3 t)) = g t).
  { intros t. unfold g. rewrite weight_form. symmetry. apply form_in_frame. }
  assert (Cc := continuity_cos). assert (Cs := continuity_sin).
  assert (Ch : continuity (height b1 b2 b3)).
  { intros t. apply (continuity_pt_comp (fun t => (b1 * (cos t * cos t) + b2 * (sin t * sin t)) / - b3) sqrt).
    - unfold Rdiv. apply (continuity_pt_mult _ (fun _ => / - b3)); [|apply continuity_pt_const; intros ? ?; reflexivity].
      apply derivable_continuous_pt. reg.
    - apply continuity_pt_sqrt. assert (X := square_nonneg (cos t)). assert (Y := square_nonneg (sin t)).
      apply Rmult_le_pos; [nra|left; apply Rinv_0_lt_compat; lra]. }
  assert (F : continuity (fun t => form d e1 e1 * (cos t * cos t) + form d e2 e2 * (sin t * sin t) + form d e3 e3 * (height b1 b2 b3 t * height b1 b2 b3 t)
    + 2 * (form d e1 e2 * (cos t * sin t) + form d e2 e3 * (sin t * height b1 b2 b3 t) + form d e1 e3 * (cos t * height b1 b2 b3 t)))).
  { continuous_polynomial. }
  intros t eps Ep. destruct (F t eps Ep) as [al [Al Q]]. exists al. split; [exact Al|].
  intros x X. assert (Y := Q x X). rewrite !G in Y. exact Y.
Qed.

Theorem degenerate_points_reach_infinity b1 b2 b3 e1 e2 e3 c t0 : orthonormal e1 e2 e3 ->
  b1 + b2 + b3 = 0 -> b1 >= b2 -> b2 > 0 -> let p := curve b1 b2 b3 e1 e2 e3 in
  - PI <= t0 <= PI -> 0 < weight c (p t0) ->
  exists t1, t0 < t1 /\ weight c (p t1) = 0 /\
    (forall t, t0 <= t < t1 -> 0 < weight c (p t)) /\
    (forall r, exists t, t0 <= t < t1 /\ r * weight c (p t) < norm (degenerate_of (p t))).
Proof.
  intros O S A B p T0 W0. assert (Pi := PI_RGT_0).
  destruct (degenerate_curve b1 b2 b3 e1 e2 e3 O S A B) as [On [All _]]. fold p in On, All.
  set (N := spectral b1 b2 b3 e1 e2 e3) in *.
  assert (TN : trace N = 0) by (unfold N; rewrite trace_spectral by exact O; exact S).
  destruct (common_zero N (deviator c) TN (trace_deviator c)) as [e [U [Z1 Z2]]].
  assert (Ne : e <> zero_vector) by (intros H; rewrite H in U; unfold dot, zero_vector in U; cbn in U; lra).
  destruct (All e Ne Z1) as [s [k [Sr [K E]]]].
  assert (Per : p (s + 2 * PI) = p s).
  { unfold p, curve, height. rewrite !cos_plus, !sin_plus, cos_2PI, sin_2PI.
    replace (cos s * 1 - sin s * 0) with (cos s) by ring. replace (sin s * 1 + cos s * 0) with (sin s) by ring. reflexivity. }
  assert (Zs : weight c (p (s + 2 * PI)) = 0).
  { rewrite Per, weight_form. rewrite E, form_scale_vector in Z2.
    destruct (Rmult_integral _ _ Z2) as [H|H]; [destruct K; apply square_zero, H|exact H]. }
  set (g := fun t => weight c (p t)).
  assert (C : continuity g) by (apply weight_continuous; lra).
  assert (Lt : t0 < s + 2 * PI).
  { destruct (Rle_dec (s + 2 * PI) t0) as [H|H]; [|lra]. exfalso.
    assert (H0 : t0 = s + 2 * PI) by lra. rewrite H0, Zs in W0. lra. }
  destruct (first_zero g t0 (s + 2 * PI) C Lt W0 Zs) as [t1 [T1 [Z Pos]]].
  exists t1. split; [lra|]. split; [exact Z|]. split; [exact Pos|]. intros r.
  (* the norm is at least 4/5, and the weight is as small as one likes *)
  assert (Big : forall t, 4 / 5 < norm (degenerate_of (p t))).
  { intros t. destruct (On t) as [_ L].
    assert (Q : norm2 (degenerate_of (p t)) = 2 / 3 * (dot (p t) (p t) * dot (p t) (p t))).
    { generalize (p t). clear. intros q. destruct q. unfold degenerate_of, norm2, inner, deviator, dyad, sub, add, scale, identity, trace, dot. cbn. field. }
    assert (Nn := norm_nonneg (degenerate_of (p t))). assert (Ns := norm_squared (degenerate_of (p t))).
    apply Rnot_le_lt. intros H. nra. }
  set (eps := / (2 * (Rabs r + 1))). assert (Rr := Rabs_pos r).
  assert (Ep : 0 < eps) by (apply Rinv_0_lt_compat; lra).
  destruct (continuous_near g t1 eps (C t1) Ep) as [dl [Dl Q]].
  set (t := Rmax t0 (t1 - dl / 2)).
  assert (T : t0 <= t < t1) by (unfold t; split; [apply Rmax_l|apply Rmax_lub_lt; lra]).
  assert (T2 := Rmax_r t0 (t1 - dl / 2)). fold t in T2.
  exists t. split; [exact T|]. assert (V := Q t ltac:(apply Rabs_def1; lra)). rewrite Z in V.
  apply Rabs_def2 in V. assert (Pt := Pos t T). change (r * g t < norm (degenerate_of (p t))).
  assert (Ra := Rle_abs r). assert (r * g t <= Rabs r * g t) by (apply Rmult_le_compat_r; lra).
  assert (Rabs r * g t <= (Rabs r + 1) * eps) by nra.
  assert ((Rabs r + 1) * eps = / 2) by (unfold eps; field; lra).
  assert (Bt := Big t). lra.
Qed.
