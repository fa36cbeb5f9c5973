(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   The maximum principle behind the absence of closed components: in a field of rank 4 every local
   extremum of the mode is a degenerate point, if the characteristic tensor N is not degenerate. A
   bounded region between levels would hold an extremum, hence a degenerate point. (That the
   degenerate points form a connected set that reaches infinity is not proved here; that each plane,
   the one at infinity included, has one, is.)
   V are the differences between points of the field in space: with a point's tensor t they span the
   field. *)
From TensorTopo Require Import Tensors Frames DegenerateTensors SpectralTheorem Mode ModeRange
  ModeOnSimplex Dual Saddle.
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

Definition spans_field N (V : tensor -> Prop) t := (forall u, V u -> in_field N u) /\
  (forall u k, V u -> V (scale k u)) /\
  (forall w, in_field N w -> exists c u, V u /\ w = add u (scale c t)).
Definition local_maximum (V : tensor -> Prop) t := forall u, V u ->
  exists eps, 0 < eps /\ forall x, Rabs x < eps -> mode (add t (scale x u)) <= mode t.
Definition local_minimum (V : tensor -> Prop) t := forall u, V u ->
  exists eps, 0 < eps /\ forall x, Rabs x < eps -> mode t <= mode (add t (scale x u)).

(* Fermat: the derivative at a local maximum is zero. *)
Lemma maximum_derivative f l eps : 0 < eps -> (forall x, Rabs x < eps -> f x <= f 0) ->
  derivable_pt_lim f 0 l -> l = 0.
Proof.
  intros E M D. set (pr := exist (fun l => derivable_pt_abs f 0 l) l D : derivable_pt f 0).
  assert (H := deriv_maximum f (- eps) eps 0 pr).
  assert (K : derive_pt f 0 pr = l) by reflexivity.
  rewrite K in H. apply H; try lra. intros x A B. apply M. apply Rabs_def1; lra.
Qed.

Lemma maximum_is_critical N V t : t <> zero -> in_field N t -> spans_field N V t ->
  local_maximum V t -> critical_in_field N t.
Proof.
  intros Z [I T] [S1 [S2 S3]] M w W. destruct (S3 w W) as [c [u [U E]]].
  destruct (mode_directional t u Z T (proj2 (S1 u U))) as [k [K D]].
  destruct (M u U) as [eps [P Q]].
  assert (Z0 : add t (scale 0 u) = t) by (clear; tensor_ring).
  assert (H : k * inner (dual t) u = 0).
  { apply (maximum_derivative (fun x => mode (add t (scale x u))) _ eps P); [|exact D].
    intros x X. rewrite Z0. apply Q, X. }
  destruct (mode_directional t w Z T (proj2 W)) as [k' [K' D']].
  assert (H' : inner (dual t) u = 0) by (destruct (Rmult_integral _ _ H); [lra|assumption]).
  replace (k' * inner (dual t) w) with 0 in D'; [exact D'|].
  rewrite E, inner_sym, inner_add, inner_scale, (inner_sym u), H', (inner_sym t), (inner_dual t T). ring.
Qed.

(* The directions of the saddle are in the field. *)
Lemma displacement_in_field b1 b2 b3 u v w x y z : orthonormal u v w ->
  in_field (spectral b1 b2 b3 u v w) (displacement x y z u v w).
Proof.
  intros [A B C D E F]. unfold displacement. split.
  - rewrite inner_spectral, !form_add, !form_scale, !form_sym_dyad.
    rewrite ?(dot_sym v u), ?(dot_sym w v), ?(dot_sym w u), ?A, ?B, ?C, ?D, ?E, ?F. ring.
  - rewrite !trace_add, !trace_scale, !trace_sym_dyad, D, E, F. ring.
Qed.

(* A tensor t with an increase along a direction of the field is no local maximum. *)
Lemma increase_excludes N V t w : in_field N w -> spans_field N V t ->
  (exists eps, 0 < eps /\ forall x, x <> 0 -> Rabs x < eps -> mode t < mode (add t (scale x w))) ->
  ~ local_maximum V t.
Proof.
  intros W [S1 [S2 S3]] [e [E Inc]] M. destruct (S3 w W) as [c [u [U Ew]]].
  destruct (M u U) as [d [D Q]].
  (* x small: t + x w = (1 + c x) (t + x / (1 + c x) u) *)
  set (m := 2 * (Rabs c + 1)). assert (C0 := Rabs_pos c).
  set (x := Rmin (e / 2) (Rmin (/ m) (d / 4))).
  assert (Hm : 0 < / m) by (apply Rinv_0_lt_compat; unfold m; lra).
  assert (X0 : 0 < x) by (unfold x; repeat apply Rmin_glb_lt; lra).
  assert (X1 : x <= e / 2) by apply Rmin_l.
  assert (X2 : x <= / m) by (unfold x; apply Rle_trans with (1 := Rmin_r _ _), Rmin_l).
  assert (X3 : x <= d / 4) by (unfold x; apply Rle_trans with (1 := Rmin_r _ _), Rmin_r).
  assert (Xm : x * m <= 1).
  { apply Rle_trans with (/ m * m); [apply Rmult_le_compat_r; [unfold m; lra|exact X2]|]. right. apply Rinv_l. unfold m. lra. }
  assert (Cx : - / 2 <= c * x).
  { assert (Ca := Rle_abs (- c)). rewrite Rabs_Ropp in Ca. unfold m in Xm.
    assert (0 <= (Rabs c + c) * x) by (apply Rmult_le_pos; lra). lra. }
  set (s := 1 + c * x). assert (Sp : / 2 <= s) by (unfold s; lra).
  assert (L := Inc x ltac:(lra) ltac:(rewrite Rabs_pos_eq; lra)).
  assert (Eq : add t (scale x w) = scale s (add t (scale (x / s) u))).
  { rewrite Ew. assert (Ks : s * (x / s) = x) by (field; lra).
    transitivity (add (scale s t) (scale (s * (x / s)) u)).
    - rewrite Ks. unfold s. clear. tensor_ring.
    - generalize (x / s) s. clear. intros. tensor_ring. }
  rewrite Eq, mode_scale in L by lra.
  assert (Small : Rabs (x / s) < d).
  { rewrite Rabs_pos_eq by (apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra]).
    apply (Rmult_lt_reg_r s); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. nra. }
  assert (R := Q (x / s) Small). lra.
Qed.

Lemma in_field_opposite N t : in_field (scale (-1) N) t <-> in_field N t.
Proof. unfold in_field. rewrite inner_scale. split; intros [A B]; split; lra. Qed.

Lemma dual_opposite t : dual (scale (-1) t) = dual t.
Proof. rewrite dual_scale. transitivity (scale 1 (dual t)); [f_equal; ring|apply scale_one]. Qed.

(* With det N < 0. *)
Lemma maximum_is_degenerate_negative N V t : trace N = 0 -> ~ degenerate N -> det N < 0 ->
  t <> zero -> in_field N t -> spans_field N V t -> local_maximum V t -> degenerate t.
Proof.
  intros T DN Dn Z I S M. assert (C := maximum_is_critical N V t Z I S M).
  destruct (spectral_theorem N) as [b1 [b2 [b3 [u [v [w [A [B [O E]]]]]]]]].
  assert (Sum : b1 + b2 + b3 = 0) by (rewrite <- T, E; symmetry; apply trace_spectral, O).
  assert (Db : b1 * b2 * b3 < 0) by (rewrite <- (det_spectral b1 b2 b3 u v w O), <- E; exact Dn).
  assert (P : 0 < b2).
  { apply Rnot_le_lt. intros H. assert (0 <= b1) by lra. assert (b3 <= 0) by lra.
    assert (0 <= b1 * (- b2) * (- b3)) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra). lra. }
  assert (B12 : b1 > b2).
  { destruct (Req_dec b1 b2) as [H|H]; [|lra]. exfalso. apply DN. exists b2, (b3 - b2), w. split; [apply O|].
    rewrite E, H, spectral_rotate, spectral_rotate. apply equal_pair_degenerate. permuted_frame O. }
  assert (EM : degenerate t \/ ~ degenerate t).
  { (* decided by whether the dual is zero *)
    destruct (Req_dec (norm2 (dual t)) 0) as [H|H].
    - left. apply dual_zero; [apply I|apply norm2_zero, H].
    - right. intros D. apply H. apply dual_zero in D; [|apply I]. rewrite D. unfold norm2, inner, zero. cbn. ring. }
  destruct EM as [D|D]; [exact D|exfalso].
  destruct (one_critical_point N t T DN Z I C D) as [k [K F]].
  set (d := (b1 - b2) * (b2 - b3) * (b1 - b3) / 3).
  assert (Dp : 0 < d) by (unfold d; apply Rdiv_lt_0_compat; [repeat apply Rmult_lt_0_compat; lra|lra]).
  assert (Sd : dual N = scale d (saddle b1 b2 b3 u v w)).
  { rewrite E, (dual_spectral _ _ _ _ _ _ O Sum). unfold saddle. rewrite scale_spectral. reflexivity. }
  set (X := saddle b1 b2 b3 u v w) in *.
  assert (Ft : t = scale (k * d) X) by (rewrite F, Sd, scale_scale; reflexivity).
  destruct (signature b1 b2 b3 Sum B12 P) as [Up Down].
  assert (Mul : forall c y, c <> 0 -> add (scale c X) (scale y (scale c (displacement 1 0 0 u v w))) = scale c (add X (scale y (displacement 1 0 0 u v w))))
    by (intros; generalize X (displacement 1 0 0 u v w); clear; intros; tensor_ring).
  set (c := k * d) in *. assert (C0 : c <> 0) by (unfold c; apply Rmult_integral_contrapositive_currified; lra).
  assert (Dir : exists q, in_field N q /\ exists eps, 0 < eps /\
    forall x, x <> 0 -> Rabs x < eps -> 0 < c * (mode (add X (scale x q)) - mode X)).
  { destruct (Rtotal_order c 0) as [Neg|[Zero|Pos]]; [|contradiction|].
    - exists (displacement 0 1 0 u v w). split; [rewrite E; apply displacement_in_field, O|].
      assert (H := Down 1 ltac:(lra)).
      destruct (saddle_index b1 b2 b3 u v w 0 1 0 O Sum B12 ltac:(lra) ltac:(lra)) as [eps [Ep Q]].
      exists eps. split; [exact Ep|]. intros x X1 X2. assert (R := Q x X1 X2). cbv zeta in R. fold X in R.
      set (h := index_form b1 b2 b3 0 1 0) in *. set (y := mode _ - mode X) in *.
      assert (y < 0) by nra. nra.
    - exists (displacement 1 0 0 u v w). split; [rewrite E; apply displacement_in_field, O|].
      assert (H := Up 1 0 ltac:(left; lra)).
      destruct (saddle_index b1 b2 b3 u v w 1 0 0 O Sum B12 ltac:(lra) ltac:(lra)) as [eps [Ep Q]].
      exists eps. split; [exact Ep|]. intros x X1 X2. assert (R := Q x X1 X2). cbv zeta in R. fold X in R.
      set (h := index_form b1 b2 b3 1 0 0) in *. set (y := mode _ - mode X) in *.
      assert (0 < y) by nra. apply Rmult_lt_0_compat; assumption. }
  destruct Dir as [q [Iq [eps [Ep Q]]]].
  apply (increase_excludes N V t (scale c q)) in M; auto.
  - destruct Iq as [I1 I2]. split; [rewrite inner_sym, inner_scale, inner_sym, I1; ring|rewrite trace_scale, I2; ring].
  - exists eps. split; [exact Ep|]. intros x X1 X2. assert (R := Q x X1 X2). rewrite Ft.
    replace (add (scale c X) (scale x (scale c q))) with (scale c (add X (scale x q)))
      by (generalize X q; clear; intros; tensor_ring).
    destruct (Rtotal_order c 0) as [Neg|[Zero|Pos]]; [|contradiction|].
    + assert (Op : forall s, mode (scale c s) = - mode s).
      { intros s. replace (scale c s) with (scale (-1) (scale (- c) s)) by (generalize s; clear; intros; tensor_ring).
        rewrite mode_opposite, mode_scale by lra. reflexivity. }
      rewrite !Op. nra.
    + rewrite !mode_scale by exact Pos. nra.
Qed.

Lemma degenerate_opposite t : degenerate (scale (-1) t) <-> degenerate t.
Proof.
  split; intros H; [|apply degenerate_scale, H].
  replace t with (scale (-1) (scale (-1) t)) by (clear; tensor_ring). apply degenerate_scale, H.
Qed.

Theorem maximum_is_degenerate N V t : trace N = 0 -> ~ degenerate N -> t <> zero ->
  in_field N t -> spans_field N V t -> local_maximum V t -> degenerate t.
Proof.
  intros T DN Z I S M. destruct (Rtotal_order (det N) 0) as [H|[H|H]].
  - apply (maximum_is_degenerate_negative N V); auto.
  - (* the only other critical point is degenerate as well *)
    assert (C := maximum_is_critical N V t Z I S M).
    destruct (Req_dec (norm2 (dual t)) 0) as [Q|Q]; [apply dual_zero; [apply I|apply norm2_zero, Q]|].
    assert (D : ~ degenerate t).
    { intros D. apply Q. apply dual_zero in D; [|apply I]. rewrite D. unfold norm2, inner, zero. cbn. ring. }
    destruct (one_critical_point N t T DN Z I C D) as [k [_ F]]. rewrite F. apply degenerate_scale.
    apply dual_zero; [apply trace_dual, T|].
    destruct (spectral_theorem N) as [b1 [b2 [b3 [u [v [w [_ [_ [O E]]]]]]]]].
    assert (Sum : b1 + b2 + b3 = 0) by (rewrite <- T, E; symmetry; apply trace_spectral, O).
    rewrite E, (dual_dual _ _ _ _ _ _ O Sum). unfold dual_factor.
    rewrite E, (det_spectral _ _ _ _ _ _ O) in H. rewrite H.
    generalize (spectral b1 b2 b3 u v w). clear. intros. tensor_ring.
  - apply (maximum_is_degenerate_negative (scale (-1) N) V); auto.
    + rewrite trace_scale, T. ring.
    + rewrite degenerate_opposite. exact DN.
    + rewrite det_scale. lra.
    + apply in_field_opposite, I.
    + destruct S as [S1 [S2 S3]]. split; [intros u U; apply in_field_opposite, S1, U|]. split; [exact S2|].
      intros w W. apply S3, in_field_opposite, W.
Qed.

Theorem minimum_is_degenerate N V t : trace N = 0 -> ~ degenerate N -> t <> zero ->
  in_field N t -> spans_field N V t -> local_minimum V t -> degenerate t.
Proof.
  intros T DN Z I S M. apply degenerate_opposite.
  apply (maximum_is_degenerate N V); auto.
  - intros H. apply Z. replace t with (scale (-1) (scale (-1) t)) by (clear; tensor_ring).
    rewrite H. clear. tensor_ring.
  - destruct I as [I1 I2]. split; [rewrite inner_sym, inner_scale, inner_sym, I1; ring|rewrite trace_scale, I2; ring].
  - destruct S as [S1 [S2 S3]]. split; [exact S1|]. split; [exact S2|]. intros w W.
    destruct (S3 w W) as [c [u [U E]]]. exists (- c), u. split; [exact U|]. rewrite E. clear. tensor_ring.
  - intros u U. destruct (M (scale (-1) u)) as [eps [P Q]]; [apply S, U|]. exists eps. split; [exact P|].
    intros x X. assert (R := Q x X).
    replace (add (scale (-1) t) (scale x u)) with (scale (-1) (add t (scale x (scale (-1) u)))) by (clear; tensor_ring).
    rewrite !mode_opposite. lra.
Qed.
