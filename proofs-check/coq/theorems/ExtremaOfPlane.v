(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   All degenerate points of a plane are extrema of the mode, and at most one other point is. The
   plane is what is orthogonal to the pencil of N1 and N2. At a critical point t that is not
   degenerate, let n be the dual of t, of norm 1, and m the tensor of the pencil orthogonal to it, of
   norm 1. Then det(x n + y m) = p x^3 + r x y^2 + s y^3, and the second-order test says: if t is an
   extremum then p (2 r - 3 p) >= 0. Along the circle of tensors of norm 1 in the pencil, that is,
   |det| has a minimum at n that is not 0. A cubic form has at most one such minimum. *)
From TensorTopo Require Import Tensors Frames DegenerateTensors SpectralTheorem Mode ModeRange
  Dual SecondOrder Saddle NoIsolatedExtremum ComplementPencil.
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

Definition local_extremum (V : tensor -> Prop) t := local_maximum V t \/ local_minimum V t.

Theorem degenerate_points_are_extrema (V : tensor -> Prop) t : (forall u, V u -> trace u = 0) ->
  t <> zero -> trace t = 0 -> degenerate t -> local_extremum V t.
Proof.
  intros Tr Z T D. assert (R : mode t = 1 \/ mode t = -1) by (apply mode_range_ends; auto).
  assert (Near : forall u, exists eps, 0 < eps /\ forall x, Rabs x < eps -> add t (scale x u) <> zero).
  { intros u. assert (P := norm2_positive t Z). assert (U := norm2_nonneg u).
    set (m := norm2 t + 2 * Rabs (inner t u) + 1). assert (A := Rabs_pos (inner t u)).
    exists (norm2 t / m). split; [apply Rdiv_lt_0_compat; unfold m; lra|]. intros x X H.
    assert (E := norm2_line t u x). rewrite H in E.
    replace (norm2 zero) with 0 in E by (unfold norm2, inner, zero; cbn; ring).
    assert (Xm : Rabs x * m < norm2 t).
    { assert (Y := Rmult_lt_compat_r m (Rabs x) (norm2 t / m) ltac:(unfold m; lra) X).
      replace (norm2 t / m * m) with (norm2 t) in Y by (field; unfold m; lra). exact Y. }
    assert (B : Rabs (inner t u * x) = Rabs (inner t u) * Rabs x) by apply Rabs_mult.
    assert (L := Rle_abs (- (inner t u * x))). rewrite Rabs_Ropp, B in L.
    assert (X0 := Rabs_pos x). assert (0 <= norm2 u * (x * x)) by (apply Rmult_le_pos; [exact U|apply square_nonneg]).
    assert (0 <= Rabs x * (norm2 t + 1)) by (apply Rmult_le_pos; lra).
    unfold m in Xm. lra. }
  assert (Range : forall u x, V u -> add t (scale x u) <> zero -> -1 <= mode (add t (scale x u)) <= 1).
  { intros u x U N. apply mode_range; [exact N|]. rewrite trace_add, trace_scale, T, (Tr u U). ring. }
  destruct R as [R|R]; [left|right]; intros u U; destruct (Near u) as [e [P Q]]; exists e; (split; [exact P|]);
    intros x X; assert (W := Range u x U (Q x X)); lra.
Qed.

Lemma extremum_is_critical n1 n2 t : t <> zero -> trace t = 0 ->
  local_extremum (in_plane n1 n2) t -> critical_in_plane n1 n2 t.
Proof.
  intros Z T X u U. destruct (mode_directional t u Z T (proj2 (proj2 U))) as [k [K D]].
  assert (Z0 : add t (scale 0 u) = t) by (clear; tensor_ring).
  assert (H : k * inner (dual t) u = 0).
  { destruct X as [X|X]; destruct (X u U) as [eps [P Q]].
    - apply (maximum_derivative (fun x => mode (add t (scale x u))) _ eps P); [|exact D].
      intros x Hx. rewrite Z0. apply Q, Hx.
    - assert (Y : - (k * inner (dual t) u) = 0); [|lra].
      apply (maximum_derivative (fun x => - mode (add t (scale x u))) _ eps P);
        [|exact (derivable_pt_lim_opp _ _ _ D)].
      intros x Hx. rewrite Z0. assert (W := Q x Hx). lra. }
  rewrite H in D. exact D.
Qed.

(* A quadratic form that does not change its sign. *)
Lemma semidefinite a b c e : e <> 0 ->
  (forall x y, 0 <= e * (a * (x * x) + 2 * b * (x * y) + c * (y * y))) -> b * b <= a * c.
Proof.
  intros E H. assert (H1 := H 1 0). assert (H2 := H 0 1). assert (H3 := H c (- b)). assert (H4 := H b (- a)).
  assert (H5 := H 1 1). assert (H6 := H 1 (-1)).
  assert (A : 0 <= e * a) by lra. assert (C : 0 <= e * c) by lra.
  apply Rnot_lt_le. intros L. set (d := b * b - a * c) in *. assert (D : 0 < d) by (unfold d; lra).
  assert (K3 : 0 <= - (e * c) * d) by (unfold d; lra). assert (K4 : 0 <= - (e * a) * d) by (unfold d; lra).
  assert (A0 : e * a = 0) by nra. assert (C0 : e * c = 0) by nra.
  assert (B0 : e * b = 0) by lra.
  assert (Z : e * (e * d) = 0).
  { transitivity (e * b * (e * b) - e * a * (e * c)); [unfold d; ring|rewrite A0, B0; ring]. }
  destruct (Rmult_integral _ _ Z) as [|Z']; [contradiction|]. destruct (Rmult_integral _ _ Z'); [contradiction|lra].
Qed.

(* The pencil on an orthonormal basis n, m. *)
Definition pencil_basis n1 n2 n m := norm2 n = 1 /\ norm2 m = 1 /\ inner n m = 0 /\
  (exists a b, n = pencil a b n1 n2) /\ (exists a b, m = pencil a b n1 n2) /\
  forall a b, let k := pencil a b n1 n2 in k = pencil (inner k n) (inner k m) n m.

Lemma basis_from n1 n2 a b : independent n1 n2 -> norm2 (pencil a b n1 n2) = 1 ->
  exists m, pencil_basis n1 n2 (pencil a b n1 n2) m.
Proof.
  intros I U. set (n := pencil a b n1 n2) in *.
  set (y1 := inner n n1). set (y2 := inner n n2). set (m0 := pencil (- y2) y1 n1 n2).
  assert (Lin : forall c d k, inner (pencil c d n1 n2) k = c * inner n1 k + d * inner n2 k)
    by (intros; unfold pencil; rewrite inner_add, !inner_scale; reflexivity).
  assert (Y : a * y1 + b * y2 = 1).
  { rewrite <- U. unfold norm2. unfold n at 1. rewrite Lin, (inner_sym n1), (inner_sym n2). reflexivity. }
  assert (M0 : m0 <> zero).
  { intros H. destruct (I _ _ H) as [H1 H2]. unfold y1, y2 in *. nra. }
  assert (P := norm_positive m0 M0). assert (Q := norm_squared m0).
  set (l := / norm m0). assert (Lp : 0 < l) by (apply Rinv_0_lt_compat; exact P).
  set (m := pencil (l * - y2) (l * y1) n1 n2).
  assert (Em : m = scale l m0) by (unfold m, m0, pencil; clear; tensor_ring).
  assert (Um : norm2 m = 1) by (rewrite Em, norm2_scale, <- Q; unfold l; field; lra).
  assert (Onm : inner n m = 0).
  { rewrite inner_sym, Em, inner_scale. unfold m0. rewrite Lin, (inner_sym n1), (inner_sym n2). fold y1 y2. ring. }
  exists m. split; [exact U|]. split; [exact Um|]. split; [exact Onm|].
  split; [exists a, b; reflexivity|]. split; [exists (l * - y2), (l * y1); reflexivity|].
  intros c d k. set (x := inner k n). set (y := inner k m).
  (* the remainder is in the pencil and orthogonal to it *)
  set (rest := pencil (c - x * a - y * (l * - y2)) (d - x * b - y * (l * y1)) n1 n2).
  assert (Er : k = add (pencil x y n m) rest) by (unfold k, rest, n, m, pencil; clear; tensor_ring).
  assert (Rn : inner rest n = 0).
  { assert (E : inner k n = x * norm2 n + y * inner m n + inner rest n)
      by (rewrite Er at 1; unfold pencil; rewrite !inner_add, !inner_scale; reflexivity).
    fold x in E. rewrite U, (inner_sym m n), Onm in E. lra. }
  assert (Rm : inner rest m = 0).
  { assert (E : inner k m = x * inner n m + y * norm2 m + inner rest m)
      by (rewrite Er at 1; unfold pencil; rewrite !inner_add, !inner_scale; reflexivity).
    fold y in E. rewrite Um, Onm in E. lra. }
  set (z1 := inner n1 rest). set (z2 := inner n2 rest).
  assert (E1 : a * z1 + b * z2 = 0) by (rewrite <- Rn, (inner_sym rest); unfold n; rewrite Lin; reflexivity).
  assert (E2 : - y2 * z1 + y1 * z2 = 0).
  { apply (Rmult_eq_reg_l l); [|lra]. rewrite Rmult_0_r, <- Rm, (inner_sym rest). unfold m. rewrite Lin. fold z1 z2. ring. }
  assert (Z1 : z1 = 0) by (transitivity (y1 * (a * z1 + b * z2) - b * (- y2 * z1 + y1 * z2) + (1 - (a * y1 + b * y2)) * z1); [ring|rewrite E1, E2, Y; ring]).
  assert (Z2 : z2 = 0) by (transitivity (y2 * (a * z1 + b * z2) + a * (- y2 * z1 + y1 * z2) + (1 - (a * y1 + b * y2)) * z2); [ring|rewrite E1, E2, Y; ring]).
  assert (Zr : rest = zero).
  { apply norm2_zero. unfold norm2. unfold rest at 1. rewrite Lin. fold z1 z2. rewrite Z1, Z2. ring. }
  rewrite Er at 1. rewrite Zr. generalize (pencil x y n m). clear. intros. tensor_ring.
Qed.

(* What the second-order test says of the determinant on the pencil. *)
Lemma minimum_of_determinant n1 n2 t : trace n1 = 0 -> trace n2 = 0 -> independent n1 n2 ->
  t <> zero -> in_plane n1 n2 t -> ~ degenerate t -> local_extremum (in_plane n1 n2) t ->
  exists n m k p r s, pencil_basis n1 n2 n m /\ k <> 0 /\ dual t = scale k n /\
    p <> 0 /\ 0 <= p * (2 * r - 3 * p) /\
    forall x y, det (pencil x y n m) = p * (x * x * x) + r * (x * (y * y)) + s * (y * y * y).
Proof.
  intros T1 T2 I Z [P1 [P2 T]] D X. assert (C := extremum_is_critical n1 n2 t Z T X).
  apply (lagrange_plane n1 n2 t T1 T2 I Z T) in C. destruct C as [k1 [k2 E]].
  assert (DZ : dual t <> zero) by (intros H; apply D, dual_zero; assumption).
  assert (NP := norm_positive _ DZ). assert (NS := norm_squared (dual t)).
  set (l := / norm (dual t)). assert (Lp : 0 < l) by (apply Rinv_0_lt_compat; exact NP).
  assert (En : pencil (l * k1) (l * k2) n1 n2 = scale l (dual t)) by (rewrite E; unfold pencil; clear; tensor_ring).
  destruct (basis_from n1 n2 (l * k1) (l * k2) I) as [m B].
  { rewrite En, norm2_scale, <- NS. unfold l. field. lra. }
  set (n := pencil (l * k1) (l * k2) n1 n2) in *. assert (B' := B). destruct B' as [Un [Um [Onm [_ [[c1 [c2 Em]] _]]]]].
  destruct (spectral_theorem t) as [t1 [t2 [t3 [u [v [w [A1 [A2 [O F]]]]]]]]].
  assert (Sum : t1 + t2 + t3 = 0) by (rewrite <- T, F; symmetry; apply trace_spectral, O).
  set (d := (t1 - t2) * (t2 - t3) * (t1 - t3) / 3).
  assert (Dt : dual t = spectral (d * (t2 - t3)) (d * (t3 - t1)) (d * (t1 - t2)) u v w)
    by (rewrite F; apply dual_spectral; assumption).
  assert (Dz : d <> 0).
  { intros H. apply DZ. rewrite Dt, H, !Rmult_0_l. apply spectral_zero. }
  assert (Ne : t1 <> t2 /\ t2 <> t3 /\ t1 <> t3) by (repeat split; intros H; apply Dz; unfold d; rewrite H; field).
  set (e := l * d). assert (E0 : e <> 0) by (unfold e; apply Rmult_integral_contrapositive_currified; lra).
  assert (Fn : n = from_frame u v w (Tensor (e * (t2 - t3)) (e * (t3 - t1)) (e * (t1 - t2)) 0 0 0)).
  { rewrite En, Dt, scale_spectral, <- spectral_from_frame. unfold e. f_equal; ring. }
  (* m has no diagonal in the frame of t *)
  set (g := in_frame u v w m). assert (Gm : m = from_frame u v w g) by (symmetry; apply from_in_frame, O).
  assert (Tm : trace m = 0) by (rewrite Em; unfold pencil; rewrite trace_add, !trace_scale, T1, T2; ring).
  assert (M1 : xx g + yy g + zz g = 0) by (rewrite <- Tm, <- (trace_in_frame u v w m O); reflexivity).
  assert (M2 : t1 * xx g + t2 * yy g + t3 * zz g = 0).
  { transitivity (inner t m).
    - rewrite F, inner_spectral. reflexivity.
    - rewrite Em, inner_sym. unfold pencil. rewrite inner_add, !inner_scale, P1, P2. ring. }
  assert (M3 : (t2 - t3) * xx g + (t3 - t1) * yy g + (t1 - t2) * zz g = 0).
  { apply (Rmult_eq_reg_l e); [|exact E0]. transitivity (inner n m).
    - rewrite Fn, <- spectral_from_frame, inner_spectral. unfold g, in_frame. cbn [xx yy zz]. ring.
    - rewrite Onm. ring. }
  assert (Q3 : 0 < (t1 - t2) * (t1 - t2) + (t2 - t3) * (t2 - t3) + (t3 - t1) * (t3 - t1)).
  { assert (S1 := square_pos (t1 - t2) ltac:(lra)). assert (S2 := square_nonneg (t2 - t3)). assert (S3 := square_nonneg (t3 - t1)). lra. }
  set (q3 := (t1 - t2) * (t1 - t2) + (t2 - t3) * (t2 - t3) + (t3 - t1) * (t3 - t1)) in *.
  assert (G1 : xx g = 0).
  { apply (Rmult_eq_reg_l q3); [|lra]. transitivity ((t2 - t3) * ((t2 - t3) * xx g + (t3 - t1) * yy g + (t1 - t2) * zz g)
      + (2 * t1 - t2 - t3) * (t1 * xx g + t2 * yy g + t3 * zz g)
      + (t2 * t2 + t3 * t3 - t1 * t2 - t1 * t3) * (xx g + yy g + zz g)); [unfold q3; ring|rewrite M1, M2, M3; ring]. }
  assert (G2 : yy g = 0).
  { apply (Rmult_eq_reg_l (t2 - t3)); [|lra]. transitivity (t1 * xx g + t2 * yy g + t3 * zz g - t3 * (xx g + yy g + zz g) - (t1 - t3) * xx g);
      [ring|rewrite M1, M2, G1; ring]. }
  assert (G3 : zz g = 0) by lra.
  set (a1 := xy g) in *. set (a2 := yz g) in *. set (a3 := xz g) in *.
  assert (Eg : g = Tensor 0 0 0 a1 a2 a3) by (apply tensor_eq; auto).
  assert (Ua : 2 * (a1 * a1 + a2 * a2 + a3 * a3) = 1).
  { rewrite <- Um, <- (norm2_in_frame u v w m O). fold g. rewrite Eg. unfold norm2, inner. cbn [xx yy zz xy yz xz]. ring. }
  assert (Ub : e * e * q3 = 1).
  { rewrite <- Un, Fn, <- spectral_from_frame, (norm2_spectral _ _ _ _ _ _ O). unfold q3. ring. }
  (* the second-order test *)
  set (q1 := - t3 * (t1 - t3) * (t2 - t3)). set (q2 := - t1 * (t1 - t2) * (t1 - t3)). set (q4 := t2 * (t1 - t2) * (t2 - t3)).
  assert (Test : exists o, o <> 0 /\ forall x y z, a1 * x + a2 * y + a3 * z = 0 -> 0 <= o * (q1 * (x * x) + q2 * (y * y) + q4 * (z * z))).
  { assert (Sf : forall x y z, second_form t1 t2 t3 x y z = q1 * (x * x) + q2 * (y * y) + q4 * (z * z))
      by (intros; unfold second_form, q1, q2, q4; ring).
    assert (Inp : forall x y z, a1 * x + a2 * y + a3 * z = 0 -> in_plane n1 n2 (displacement x y z u v w)).
    { intros x y z H. set (dsp := displacement x y z u v w).
      assert (N0 : inner n dsp = 0) by (rewrite Fn, <- spectral_from_frame; apply (displacement_across _ _ _ _ _ _ _ _ _ O)).
      assert (N1 : inner m dsp = 0).
      { rewrite <- (inner_in_frame u v w m dsp O). fold g. rewrite Eg.
        assert (Ed : in_frame u v w dsp = Tensor 0 0 0 x y z).
        { rewrite <- (in_from_frame u v w (Tensor 0 0 0 x y z) O). f_equal. unfold dsp, displacement, from_frame. cbn [xx yy zz xy yz xz].
          rewrite spectral_zero. generalize (sym_dyad u v) (sym_dyad v w) (sym_dyad u w). clear. intros. tensor_ring. }
        rewrite Ed. unfold inner. cbn [xx yy zz xy yz xz]. lra. }
      destruct B as [_ [_ [_ [_ [_ Span]]]]].
      assert (All : forall a b, inner (pencil a b n1 n2) dsp = 0).
      { intros a b. rewrite (Span a b). unfold pencil at 1. rewrite inner_add, !inner_scale, N0, N1. ring. }
      split; [|split].
      - rewrite <- (All 1 0). f_equal. unfold pencil. clear. tensor_ring.
      - rewrite <- (All 0 1). f_equal. unfold pencil. clear. tensor_ring.
      - apply (displacement_across 0 0 0 u v w x y z O). }
    assert (Tn : t1 <> 0 \/ t3 <> 0) by (destruct (Req_dec t1 0); [right; lra|left; assumption]).
    destruct X as [X|X]; [exists (-1)|exists 1]; (split; [lra|]); intros x y z H;
      rewrite <- Sf; apply Rnot_lt_le; intros L;
      destruct (second_order_in_frame t1 t2 t3 u v w x y z O Sum Tn ltac:(lra)) as [eps [Ep Q]];
      destruct (X _ (Inp x y z H)) as [eps' [Ep' Q']];
      set (f := Rmin eps eps' / 2); assert (Fp := Rmin_glb_lt _ _ _ Ep Ep');
      assert (Fl := Rmin_l eps eps'); assert (Fr := Rmin_r eps eps');
      assert (R1 := Q f ltac:(unfold f; lra) ltac:(unfold f; rewrite Rabs_pos_eq; lra));
      assert (R2 := Q' f ltac:(unfold f; rewrite Rabs_pos_eq; lra));
      cbv zeta in R1; rewrite <- F in R1; destruct (rises _ _ _ R1) as [Falls Grows];
      [apply Falls in R2|apply Grows in R2]; lra. }
  assert (Sigma : 0 <= a1 * a1 * (q2 * q4) + a2 * a2 * (q1 * q4) + a3 * a3 * (q1 * q2)).
  { destruct Test as [o [Oz Test]].
    set (sg := a1 * a1 * (q2 * q4) + a2 * a2 * (q1 * q4) + a3 * a3 * (q1 * q2)).
    assert (Cases : 0 < a1 * a1 \/ 0 < a2 * a2 \/ 0 < a3 * a3).
    { destruct (Rlt_dec 0 (a1 * a1)); [auto|]. destruct (Rlt_dec 0 (a2 * a2)); [auto|]. right. right. lra. }
    destruct Cases as [K|[K|K]].
    - assert (W := semidefinite (q1 * (a2 * a2) + q2 * (a1 * a1)) (q1 * a2 * a3) (q1 * (a3 * a3) + q4 * (a1 * a1)) o Oz).
      apply (nonneg_factor _ _ K).
      apply Rle_trans with ((q1 * (a2 * a2) + q2 * (a1 * a1)) * (q1 * (a3 * a3) + q4 * (a1 * a1)) - q1 * a2 * a3 * (q1 * a2 * a3)); [|right; unfold sg; ring].
      apply Rge_le, Rge_minus, Rle_ge, W. intros x y. assert (H := Test (a2 * x + a3 * y) (- a1 * x) (- a1 * y) ltac:(ring)). lra.
    - assert (W := semidefinite (q1 * (a2 * a2) + q2 * (a1 * a1)) (q2 * a1 * a3) (q2 * (a3 * a3) + q4 * (a2 * a2)) o Oz).
      apply (nonneg_factor _ _ K).
      apply Rle_trans with ((q1 * (a2 * a2) + q2 * (a1 * a1)) * (q2 * (a3 * a3) + q4 * (a2 * a2)) - q2 * a1 * a3 * (q2 * a1 * a3)); [|right; unfold sg; ring].
      apply Rge_le, Rge_minus, Rle_ge, W. intros x y. assert (H := Test (- a2 * x) (a1 * x + a3 * y) (- a2 * y) ltac:(ring)). lra.
    - assert (W := semidefinite (q1 * (a3 * a3) + q4 * (a1 * a1)) (q4 * a1 * a2) (q2 * (a3 * a3) + q4 * (a2 * a2)) o Oz).
      apply (nonneg_factor _ _ K).
      apply Rle_trans with ((q1 * (a3 * a3) + q4 * (a1 * a1)) * (q2 * (a3 * a3) + q4 * (a2 * a2)) - q4 * a1 * a2 * (q4 * a1 * a2)); [|right; unfold sg; ring].
      apply Rge_le, Rge_minus, Rle_ge, W. intros x y. assert (H := Test (- a3 * x) (- a3 * y) (a1 * x + a2 * y) ltac:(ring)). lra. }
  set (b1 := e * (t2 - t3)) in *. set (b2 := e * (t3 - t1)) in *. set (b3 := e * (t1 - t2)) in *.
  set (p := b1 * b2 * b3). set (r := - (b1 * (a2 * a2) + b2 * (a3 * a3) + b3 * (a1 * a1))).
  exists n, m, (norm (dual t)), p, r, (2 * (a1 * a2 * a3)). split; [exact B|]. split; [lra|]. split; [|split; [|split]].
  - rewrite En, scale_scale. unfold l. rewrite Rinv_r by lra. symmetry. apply scale_one.
  - unfold p, b1, b2, b3. repeat apply Rmult_integral_contrapositive_currified; lra.
  - apply Rle_trans with (18 * (e * e * e * (e * e * e)) * (a1 * a1 * (q2 * q4) + a2 * a2 * (q1 * q4) + a3 * a3 * (q1 * q2))).
    + apply Rmult_le_pos; [|exact Sigma]. assert (W := square_nonneg (e * e * e)). lra.
    + right. transitivity (p * (2 * r * (e * e * q3) - 3 * p * (2 * (a1 * a1 + a2 * a2 + a3 * a3)))); [|rewrite Ua, Ub; ring].
      unfold p, r, b1, b2, b3, q1, q2, q4, q3. replace t2 with (- t1 - t3) by lra. ring.
  - intros x y. assert (Ep : pencil x y n m = from_frame u v w (Tensor (x * b1) (x * b2) (x * b3) (y * a1) (y * a2) (y * a3))).
    { rewrite Fn, Gm, Eg. apply tensor_by_form. intros a b.
      unfold pencil. rewrite form_add, !form_scale, !form_from_frame. cbn [xx yy zz xy yz xz]. ring. }
    rewrite Ep, <- (det_in_frame u v w _ O), (in_from_frame u v w _ O). unfold det, p, r. cbn [xx yy zz xy yz xz]. ring.
Qed.

(* A cubic form has at most one minimum of its size on the unit circle that is not 0. *)
Lemma one_minimum p r s x y p' r' : p <> 0 -> 0 <= p * (2 * r - 3 * p) -> p' <> 0 -> 0 <= p' * (2 * r' - 3 * p') ->
  p' = p * (x * x * x) + r * (x * (y * y)) + s * (y * y * y) ->
  r' = 3 * p * x * (y * y) + r * (x * x * x - 2 * x * (y * y)) + 3 * s * (x * x) * y ->
  y * ((2 * r - 3 * p) * (x * x) - r * (y * y) + 3 * s * (x * y)) = 0 -> y = 0.
Proof.
  intros P M P' M' Ep Er Root. destruct (Req_dec y 0) as [Y|Y]; [exact Y|exfalso].
  destruct (Rmult_integral _ _ Root) as [|R]; [contradiction|]. clear Root.
  assert (S : 3 * s * (x * y) = r * (y * y) - (2 * r - 3 * p) * (x * x)) by lra.
  assert (PP := square_pos p P). assert (PR : 0 < p * r) by nra. assert (YY := square_pos y Y).
  assert (X0 := square_nonneg x).
  set (X := x * x) in *. set (W := y * y) in *.
  assert (W2 : 0 < p * r * (W * W)) by (apply Rmult_lt_0_compat; [exact PR|apply Rmult_lt_0_compat; assumption]).
  assert (XX : 0 <= X * X) by apply square_nonneg. assert (XW : 0 <= X * W) by (apply Rmult_le_pos; lra).
  assert (A : 3 * (x * (p * p')) = 3 * (p * p) * (X * X) + (p * r + 3 * (p * p)) * (X * W) + p * r * (W * W)).
  { rewrite Ep. transitivity (3 * (p * p) * (X * X) + 3 * (p * r) * (X * W) + p * (3 * s * (x * y)) * W); [unfold X, W; ring|].
    rewrite S. ring. }
  assert (B : p * (x * (2 * r' - 3 * p')) = - (p * (2 * r - 3 * p)) * (X * X) + (3 * (p * p) - 3 * (p * r)) * (X * W) - p * r * (W * W)).
  { rewrite Ep, Er. transitivity (p * ((2 * r - 3 * p) * (X * X) + (6 * p - 7 * r) * (X * W) + (3 * s * (x * y)) * (2 * X - W))); [unfold X, W; ring|].
    rewrite S. ring. }
  assert (A' : 0 < 3 * (x * (p * p'))).
  { rewrite A. assert (0 <= 3 * (p * p) * (X * X)) by (apply Rmult_le_pos; lra).
    assert (0 <= (p * r + 3 * (p * p)) * (X * W)) by (apply Rmult_le_pos; lra). lra. }
  assert (B' : p * (x * (2 * r' - 3 * p')) < 0).
  { rewrite B. assert (0 <= p * (2 * r - 3 * p) * (X * X)) by (apply Rmult_le_pos; lra).
    assert (0 <= (3 * (p * r) - 3 * (p * p)) * (X * W)) by (apply Rmult_le_pos; lra). lra. }
  assert (Neg : 3 * (x * (p * p')) * (p * (x * (2 * r' - 3 * p'))) < 0) by nra.
  assert (Eq : 3 * (x * (p * p')) * (p * (x * (2 * r' - 3 * p'))) = 3 * (X * (p * p)) * (p' * (2 * r' - 3 * p'))) by (unfold X; ring).
  assert (0 <= 3 * (X * (p * p)) * (p' * (2 * r' - 3 * p'))); [|lra].
  apply Rmult_le_pos; [|exact M']. assert (0 <= X * (p * p)) by (apply Rmult_le_pos; lra). lra.
Qed.

Theorem at_most_one_other_extremum n1 n2 s t : trace n1 = 0 -> trace n2 = 0 -> independent n1 n2 ->
  t <> zero -> in_plane n1 n2 t -> ~ degenerate t -> local_extremum (in_plane n1 n2) t ->
  s <> zero -> in_plane n1 n2 s -> ~ degenerate s -> local_extremum (in_plane n1 n2) s ->
  det t <> 0 -> exists k, s = scale k t.
Proof.
  intros T1 T2 I Zt It Dt Xt Zs Is Ds Xs Nt.
  destruct (minimum_of_determinant n1 n2 t T1 T2 I Zt It Dt Xt) as [n [m [k [p [r [c [B [K [E [P [M F]]]]]]]]]]].
  destruct (minimum_of_determinant n1 n2 s T1 T2 I Zs Is Ds Xs) as [n' [m' [k' [p' [r' [c' [B' [K' [E' [P' [M' F']]]]]]]]]]].
  destruct B as [Un [Um [Onm [_ [_ Span]]]]]. destruct B' as [Un' [Um' [Onm' [[a1 [a2 A]] [[b1 [b2 B]] _]]]]].
  assert (Sn := Span a1 a2). assert (Sm := Span b1 b2). cbv zeta in Sn, Sm. rewrite <- A in Sn. rewrite <- B in Sm.
  set (x := inner n' n) in *. set (y := inner n' m) in *. set (z := inner m' n) in *. set (w := inner m' m) in *.
  assert (In : forall a b c d, inner (pencil a b n m) (pencil c d n m) = a * c + b * d).
  { intros a0 b0 c0 d0. unfold pencil. rewrite inner_add, !inner_scale, !(inner_sym _ (add _ _)), !inner_add, !inner_scale.
    fold (norm2 n) (norm2 m). rewrite (inner_sym m n), Un, Um, Onm. ring. }
  assert (U1 : x * x + y * y = 1) by (rewrite <- (In x y x y), <- Sn; exact Un').
  assert (U2 : z * z + w * w = 1) by (rewrite <- (In z w z w), <- Sm; exact Um').
  assert (U3 : x * z + y * w = 0) by (rewrite <- (In x y z w), <- Sn, <- Sm; exact Onm').
  (* (z, w) is (-y, x) or (y, -x) *)
  set (o := x * w - y * z). assert (Oo : o * o = 1).
  { transitivity ((x * x + y * y) * (z * z + w * w) - (x * z + y * w) * (x * z + y * w)); [unfold o; ring|rewrite U1, U2, U3; ring]. }
  assert (Ez : z = - o * y).
  { transitivity (z * (x * x + y * y)); [rewrite U1; ring|]. transitivity (x * (x * z + y * w) - o * y); [unfold o; ring|rewrite U3; ring]. }
  assert (Ew : w = o * x).
  { transitivity (w * (x * x + y * y)); [rewrite U1; ring|]. transitivity (y * (x * z + y * w) + o * x); [unfold o; ring|rewrite U3; ring]. }
  assert (G : forall a b, p' * (a * a * a) + r' * (a * (b * b)) + c' * (b * b * b)
    = p * ((a * x - b * o * y) * (a * x - b * o * y) * (a * x - b * o * y))
      + r * ((a * x - b * o * y) * ((a * y + b * o * x) * (a * y + b * o * x)))
      + c * ((a * y + b * o * x) * (a * y + b * o * x) * (a * y + b * o * x))).
  { intros a b. rewrite <- F', <- F. f_equal. rewrite Sn, Sm, Ez, Ew. unfold pencil. clear. tensor_ring. }
  assert (G0 := G 1 0). assert (G1 := G 1 1). assert (G2 := G 1 (-1)). assert (G3 := G 0 1).
  assert (Ep : p' = p * (x * x * x) + r * (x * (y * y)) + c * (y * y * y)) by lra.
  assert (Er : r' = o * o * (3 * p * x * (y * y) + r * (x * x * x - 2 * x * (y * y)) + 3 * c * (x * x) * y)) by lra.
  assert (Root : o * (y * ((2 * r - 3 * p) * (x * x) - r * (y * y) + 3 * c * (x * y))) = 0) by lra.
  rewrite Oo, Rmult_1_l in Er. destruct (Rmult_integral _ _ Root) as [Z|Root']; [rewrite Z in Oo; lra|].
  assert (Y := one_minimum p r c x y p' r' P M P' M' Ep Er Root').
  (* so the duals are multiples of each other, and t is the dual of its dual *)
  assert (Ed : dual s = scale (k' * x / k) (dual t)).
  { rewrite E', E, Sn, Y, scale_scale. unfold pencil. replace (k' * x / k * k) with (k' * x) by (field; exact K). clear. tensor_ring. }
  destruct (spectral_theorem t) as [t1 [t2 [t3 [u [v [q [_ [_ [O Ft]]]]]]]]].
  assert (St : t1 + t2 + t3 = 0) by (rewrite <- (proj2 (proj2 It)), Ft; symmetry; apply trace_spectral, O).
  assert (DD := dual_dual t1 t2 t3 u v q O St). rewrite <- Ft in DD.
  destruct (spectral_theorem s) as [s1 [s2 [s3 [u' [v' [q' [_ [_ [O' Fs]]]]]]]]].
  assert (Ss : s1 + s2 + s3 = 0) by (rewrite <- (proj2 (proj2 Is)), Fs; symmetry; apply trace_spectral, O').
  assert (DS := dual_dual s1 s2 s3 u' v' q' O' Ss). rewrite <- Fs in DS.
  set (f := dual_factor t1 t2 t3) in *. set (h := dual_factor s1 s2 s3) in *. set (j := k' * x / k) in *.
  assert (J : j <> 0).
  { intros H. apply Ds, dual_zero; [apply Is|]. rewrite Ed, H. generalize (dual t). clear. intros. tensor_ring. }
  assert (Fz : f <> 0).
  { intros H. assert (Z : dual (dual t) = zero) by (rewrite DD, H; clear; tensor_ring).
    assert (Dd : (t1 - t2) * (t2 - t3) * (t1 - t3) <> 0).
    { intros H'. apply Dt, dual_zero; [apply It|]. rewrite Ft, (dual_spectral _ _ _ _ _ _ O St), H'.
      rewrite <- (spectral_zero u v q). f_equal; field. }
    rewrite Ft, (det_spectral _ _ _ _ _ _ O) in Nt. unfold f, dual_factor in H.
    set (g := (t1 - t2) * (t2 - t3) * (t1 - t3) / 3) in *. assert (Gz : g <> 0) by (unfold g; lra).
    assert (0 < g * g) by (apply square_pos; exact Gz). assert (0 < g * g * (g * g)) by (apply Rmult_lt_0_compat; assumption).
    destruct (Rmult_integral _ _ H) as [V1|V1]; [destruct (Rmult_integral _ _ V1); [lra|contradiction]|lra]. }
  assert (Rel : scale h s = scale (j * j * (j * j) * f) t) by (rewrite <- DS, Ed, dual_scale, DD, scale_scale; reflexivity).
  assert (Cz : j * j * (j * j) * f <> 0).
  { assert (0 < j * j) by (apply square_pos; exact J). assert (0 < j * j * (j * j)) by (apply Rmult_lt_0_compat; assumption).
    apply Rmult_integral_contrapositive_currified; lra. }
  assert (Hz : h <> 0).
  { intros H. rewrite H in Rel. replace (scale 0 s) with zero in Rel by (clear; tensor_ring).
    destruct (scale_zero _ _ (eq_sym Rel)); contradiction. }
  exists (/ h * (j * j * (j * j) * f)). rewrite <- scale_scale, <- Rel, scale_scale, Rinv_l, scale_one by exact Hz. reflexivity.
Qed.
