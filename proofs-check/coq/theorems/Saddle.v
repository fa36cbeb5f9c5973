(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   In space the mode of a linear field with a nondegenerate characteristic tensor N has, besides
   degenerate points, one critical point, the dual of N. Its mode is that of the bifurcation, and it
   is a saddle. The idea: where the derivative vanishes along all directions of the field, dual T is
   a multiple of N; and the dual of the dual of T is a multiple of T. *)
From TensorTopo Require Import Tensors Frames DegenerateTensors SpectralTheorem Mode ModeRange
  ModeOnSimplex Dual SecondOrder.
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

Theorem saddle_index b1 b2 b3 u v w x y z : orthonormal u v w -> b1 + b2 + b3 = 0 ->
  b1 >= b2 -> b2 > b3 -> let h := index_form b1 b2 b3 x y z in h <> 0 ->
  exists eps, 0 < eps /\ forall t, t <> 0 -> Rabs t < eps ->
  0 < h * (mode (add (saddle b1 b2 b3 u v w) (scale t (displacement x y z u v w)))
           - mode (saddle b1 b2 b3 u v w)).
Proof.
  intros O S A B h. assert (H : h = second_form (b2 - b3) (b3 - b1) (b1 - b2) x y z).
  { unfold h, index_form, second_form. replace b3 with (- b1 - b2) by lra. ring. }
  rewrite H. intros N. apply second_order_in_frame; auto; [ring|]. left. lra.
Qed.
