(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   The maximum principle behind the absence of closed components: in a field of rank 4 every local
   extremum of the mode is a degenerate point. At a critical point t that is not degenerate the
   characteristic tensor N is a multiple of the dual of t, so the field has E12 and E23 of the frame
   of t, along which the mode grows and falls.
   V are the differences between points of the field in space: with a point's tensor t they span the
   field. *)
From TensorTopo Require Import Tensors Frames DegenerateTensors SpectralTheorem Mode ModeRange
  ModeOnSimplex Dual SecondOrder Saddle.
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

Lemma degenerate_opposite t : degenerate (scale (-1) t) <-> degenerate t.
Proof.
  split; intros H; [|apply degenerate_scale, H].
  replace t with (scale (-1) (scale (-1) t)) by (clear; tensor_ring). apply degenerate_scale, H.
Qed.

Theorem maximum_is_degenerate N V t : trace N = 0 -> N <> zero -> t <> zero ->
  in_field N t -> spans_field N V t -> local_maximum V t -> degenerate t.
Proof.
  intros TN ZN Z I S M. assert (T := proj2 I). assert (C := maximum_is_critical N V t Z I S M).
  apply (lagrange N t TN ZN Z T) in C. destruct C as [k E].
  destruct (Req_dec (norm2 (dual t)) 0) as [D|D]; [apply dual_zero; [exact T|apply norm2_zero, D]|exfalso].
  destruct (spectral_theorem t) as [t1 [t2 [t3 [u [v [w [A [B [O F]]]]]]]]].
  assert (Sum : t1 + t2 + t3 = 0) by (rewrite <- T, F; symmetry; apply trace_spectral, O).
  rewrite F, (dual_spectral _ _ _ _ _ _ O Sum) in E, D.
  set (d := (t1 - t2) * (t2 - t3) * (t1 - t3) / 3) in *.
  assert (Dz : d <> 0).
  { intros H. apply D. rewrite H, (norm2_spectral _ _ _ _ _ _ O). ring. }
  assert (Ne : t1 <> t2 /\ t2 <> t3 /\ t1 <> t3).
  { repeat split; intros H; apply Dz; unfold d; rewrite H; field. }
  assert (K : k <> 0).
  { intros H. rewrite H in E. apply D. rewrite E. replace (scale 0 N) with zero by (clear; tensor_ring).
    unfold norm2, inner, zero. cbn. ring. }
  assert (Across : in_field N (displacement 1 0 0 u v w)).
  { destruct (displacement_across (d * (t2 - t3)) (d * (t3 - t1)) (d * (t1 - t2)) u v w 1 0 0 O) as [P Q].
    split; [|exact Q]. rewrite E, inner_scale in P. destruct (Rmult_integral _ _ P); [contradiction|assumption]. }
  (* along E12 the mode grows *)
  assert (H : 0 < second_form t1 t2 t3 1 0 0).
  { unfold second_form. assert (0 < - t3 * (t1 - t3) * (t2 - t3)) by (repeat apply Rmult_lt_0_compat; lra). lra. }
  apply (increase_excludes N V t (displacement 1 0 0 u v w)) in M; auto.
  destruct (second_order_in_frame t1 t2 t3 u v w 1 0 0 O Sum ltac:(left; lra) ltac:(lra)) as [eps [P Q]].
  exists eps. split; [exact P|]. intros x X1 X2. assert (R := Q x X1 X2). cbv zeta in R. rewrite <- F in R.
  set (h := second_form t1 t2 t3 1 0 0) in *. set (y := mode _ - mode t) in *. assert (0 < y) by nra. unfold y in *. lra.
Qed.

Theorem minimum_is_degenerate N V t : trace N = 0 -> N <> zero -> t <> zero ->
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
