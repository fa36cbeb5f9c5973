(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   In space no level of the mode bounds a region. The points of a field of rank 4 are its tensors
   with c.t = 1, for a linear form c that is 0 at infinity. In a bounded open set with one mode k at
   its frontier, -1 < k < 1, the mode would have a largest value, at a point of the set if that is
   more than k. This point would be degenerate, of mode 1, and on an arc of such points that leaves
   every bounded set; so the arc would meet the frontier, where the mode is k. *)
From TensorTopo Require Import Tensors Frames DegenerateTensors SpectralTheorem Mode ModeRange
  Polynomials Kernel ModeOnSimplex Dual SecondOrder Saddle NoIsolatedExtremum CommonZeros
  DegeneratePointsOfPlane DegenerateCurve Calculus Compactness.
Require Import Reals Psatz Ring Field List ZArith.
Import ListNotations.
Open Scope R_scope.

Definition point N c t := in_field N t /\ inner c t = 1.
Record region N c (omega : tensor -> Prop) : Prop := {
  of_points : forall t, omega t -> point N c t;
  not_empty : exists t, omega t;
  bounded : exists r, forall t, omega t -> norm t <= r;
  open : forall t, omega t -> exists eps, 0 < eps /\ forall u, point N c u -> gap t u < eps -> omega u }.
(* Points that are not in the set, but not away from it either. *)
Definition frontier N c (omega : tensor -> Prop) t := point N c t /\ ~ omega t /\
  forall eps, 0 < eps -> ~ forall u, omega u -> eps <= gap t u.

Lemma point_not_zero N c t : point N c t -> t <> zero.
Proof. intros [_ C] Z. rewrite Z in C. unfold inner, zero in C. cbn in C. lra. Qed.

Lemma entries_within t r : norm t <= r -> Forall (fun x => - r <= x <= r) (to_list t).
Proof.
  intros H. assert (P := norm_nonneg t). assert (S := norm_squared t).
  assert (K : forall x, x * x <= norm2 t -> - r <= x <= r).
  { intros x X. rewrite <- S in X. split; apply Rnot_lt_le; intros L; nra. }
  assert (Q := fun x => square_nonneg x).
  unfold to_list. repeat apply Forall_cons; try apply Forall_nil; apply K; unfold norm2, inner;
    assert (A := Q (xx t)); assert (B := Q (yy t)); assert (C := Q (zz t)); assert (D := Q (xy t));
    assert (E := Q (yz t)); assert (F := Q (xz t)); lra.
Qed.

(* The mode and linear forms are continuous. *)
Definition six_corners := [Corner 1 0 0 0 0 0; Corner 0 1 0 0 0 0; Corner 0 0 1 0 0 0;
  Corner 0 0 0 0 0 1; Corner 0 0 0 1 0 0; Corner 0 0 0 0 1 0].
Lemma field_six t : field six_corners (to_list t) = t.
Proof. rewrite field_entries. destruct t. cbn. apply tensor_eq; cbn; ring. Qed.

Lemma entries_of_gap t u : let d := gap t u in
  Rabs (xx t - xx u) <= d /\ Rabs (yy t - yy u) <= d /\ Rabs (zz t - zz u) <= d /\
  Rabs (xy t - xy u) <= d /\ Rabs (yz t - yz u) <= d /\ Rabs (xz t - xz u) <= d.
Proof.
  unfold gap. assert (P := Rabs_pos). assert (A := P (xx t - xx u)). assert (B := P (yy t - yy u)).
  assert (C := P (zz t - zz u)). assert (D := P (xy t - xy u)). assert (E := P (yz t - yz u)).
  assert (F := P (xz t - xz u)). cbv zeta. repeat split; lra.
Qed.

Lemma mode_near t eps : t <> zero -> 0 < eps ->
  exists d, 0 < d /\ forall u, gap t u < d -> Rabs (mode u - mode t) < eps.
Proof.
  intros Z E. assert (C := continuous_mode six_corners (to_list t)). rewrite field_six in C.
  destruct (C Z eps E) as [d [D K]]. exists d. split; [exact D|]. intros u U.
  assert (H := K (to_list u)). cbv beta in H. rewrite !field_six in H. apply H.
  destruct (entries_of_gap t u) as [H1 [H2 [H3 [H4 [H5 H6]]]]].
  intros i. rewrite Rabs_minus_sym. destruct i as [|[|[|[|[|[|i]]]]]]; cbn; try lra.
  destruct i; rewrite Rminus_diag_eq, Rabs_R0 by reflexivity; exact D.
Qed.

Lemma inner_near a t : exists m, 0 < m /\ forall u, Rabs (inner a t - inner a u) <= m * gap t u.
Proof.
  set (s := Rabs (xx a) + Rabs (yy a) + Rabs (zz a) + Rabs (xy a) + Rabs (yz a) + Rabs (xz a)).
  assert (P := Rabs_pos). assert (A := P (xx a)). assert (B := P (yy a)). assert (C := P (zz a)).
  assert (D := P (xy a)). assert (E := P (yz a)). assert (F := P (xz a)).
  exists (2 * s + 1). split; [unfold s; lra|]. intros u.
  assert (One : forall x d, Rabs x <= s -> 0 <= s * Rabs d /\ - (s * Rabs d) <= x * d <= s * Rabs d).
  { intros x d X. assert (Y := P d). assert (Z := P x). split; [apply Rmult_le_pos; lra|].
    assert (Q : Rabs (x * d) <= s * Rabs d) by (rewrite Rabs_mult; apply Rmult_le_compat_r; lra).
    assert (L1 := Rle_abs (x * d)). assert (L2 := Rle_abs (- (x * d))). rewrite Rabs_Ropp in L2. lra. }
  assert (O1 := One (xx a) (xx t - xx u) ltac:(unfold s; lra)). assert (O2 := One (yy a) (yy t - yy u) ltac:(unfold s; lra)).
  assert (O3 := One (zz a) (zz t - zz u) ltac:(unfold s; lra)). assert (O4 := One (xy a) (xy t - xy u) ltac:(unfold s; lra)).
  assert (O5 := One (yz a) (yz t - yz u) ltac:(unfold s; lra)). assert (O6 := One (xz a) (xz t - xz u) ltac:(unfold s; lra)).
  assert (G := entries_of_gap t u). cbv zeta in G. assert (G1 := P (xx t - xx u)).
  assert (Sg : (2 * s + 1) * gap t u = 2 * (s * Rabs (xx t - xx u) + s * Rabs (yy t - yy u) + s * Rabs (zz t - zz u)
    + s * Rabs (xy t - xy u) + s * Rabs (yz t - yz u) + s * Rabs (xz t - xz u)) + gap t u) by (unfold gap; ring).
  rewrite Sg. apply Rabs_le. unfold inner. lra.
Qed.

Lemma gap_on_line t u : exists m, 0 < m /\ forall x, gap t (add t (scale x u)) <= Rabs x * m.
Proof.
  exists (gap zero u + 1). assert (P := Rabs_pos). split.
  - unfold gap. assert (A := P (xx zero - xx u)). assert (B := P (yy zero - yy u)). assert (C := P (zz zero - zz u)).
    assert (D := P (xy zero - xy u)). assert (E := P (yz zero - yz u)). assert (F := P (xz zero - xz u)). lra.
  - intros x. assert (X := P x). assert (K : forall a b, Rabs (a - (a + x * b)) = Rabs x * Rabs (0 - b)).
    { intros a b. rewrite <- Rabs_mult. replace (x * (0 - b)) with (a - (a + x * b)) by ring. reflexivity. }
    unfold gap, add, scale, zero. cbn [xx yy zz xy yz xz]. rewrite !K. lra.
Qed.
Lemma gap_opposite t u : gap (scale (-1) t) (scale (-1) u) = gap t u.
Proof.
  assert (K : forall a b, Rabs (-1 * a - -1 * b) = Rabs (a - b)).
  { intros a b. rewrite <- (Rabs_Ropp (a - b)). f_equal. ring. }
  unfold gap, scale. cbn [xx yy zz xy yz xz]. rewrite !K. reflexivity.
Qed.
Lemma twice_opposite t : scale (-1) (scale (-1) t) = t.
Proof. tensor_ring. Qed.

(* A place with points of the set as near as one likes is a point. *)
Lemma limit_is_point N c omega t : region N c omega ->
  (forall eps, 0 < eps -> ~ forall u, omega u -> eps <= gap t u) -> point N c t.
Proof.
  intros Rg L. assert (Lim : forall a v, (forall u, omega u -> inner a u = v) -> inner a t = v).
  { intros a v H. destruct (Req_dec (inner a t) v) as [E|E]; [exact E|exfalso].
    destruct (inner_near a t) as [m [M K]]. assert (D : 0 < Rabs (inner a t - v)) by (apply Rabs_pos_lt; lra).
    apply (L (Rabs (inner a t - v) / m)); [apply Rdiv_lt_0_compat; assumption|].
    intros u U. assert (Q := K u). rewrite (H u U) in Q.
    apply (Rmult_le_reg_l m); [exact M|]. replace (m * (Rabs (inner a t - v) / m)) with (Rabs (inner a t - v)) by (field; lra). exact Q. }
  assert (Tr : forall u, trace u = inner identity u) by (intros; unfold trace, inner, identity; cbn; ring).
  split; [split|].
  - apply Lim. intros u U. apply (of_points N c omega Rg u U).
  - rewrite Tr. apply Lim. intros u U. rewrite <- Tr. apply (of_points N c omega Rg u U).
  - apply Lim. intros u U. apply (of_points N c omega Rg u U).
Qed.

(* The largest value of the mode in the set, if taken in it, is taken at a degenerate point. *)
Lemma largest_is_degenerate N c omega t : trace N = 0 -> N <> zero -> region N c omega ->
  omega t -> (forall u, omega u -> mode u <= mode t) -> degenerate t.
Proof.
  intros TN ZN Rg Ot M. assert (Pt := of_points N c omega Rg t Ot). destruct Pt as [I C].
  apply (maximum_is_degenerate N (fun u => in_field N u /\ inner c u = 0)); auto.
  - apply (point_not_zero N c). split; assumption.
  - split; [intros u U; apply U|]. split.
    + intros u k [[U1 U2] U3]. split; [split|].
      * rewrite inner_sym, inner_scale, inner_sym, U1. ring.
      * rewrite trace_scale, U2. ring.
      * rewrite inner_sym, inner_scale, inner_sym, U3. ring.
    + intros w [W1 W2]. exists (inner c w), (add w (scale (- inner c w) t)).
      assert (In : forall a, inner a (add w (scale (- inner c w) t)) = inner a w - inner c w * inner a t).
      { intros a. rewrite inner_sym, inner_add, inner_scale, (inner_sym w), (inner_sym t). ring. }
      split; [split; [split|]|].
      * rewrite In, W1, (proj1 I). ring.
      * rewrite trace_add, trace_scale, W2, (proj2 I). ring.
      * rewrite In, C. ring.
      * generalize (inner c w). clear. intros. tensor_ring.
  - intros u [[U1 U2] U3]. destruct (open N c omega Rg t Ot) as [e [E K]].
    destruct (gap_on_line t u) as [m [Mp G]]. exists (e / m). split; [apply Rdiv_lt_0_compat; assumption|].
    intros x X. apply M, K.
    + split; [split|].
      * rewrite inner_sym, inner_add, inner_scale, !(inner_sym _ N), (proj1 I), U1. ring.
      * rewrite trace_add, trace_scale, (proj2 I), U2. ring.
      * rewrite inner_sym, inner_add, inner_scale, !(inner_sym _ c), C, U3. ring.
    + apply Rle_lt_trans with (1 := G x). apply (Rmult_lt_compat_r m) in X; [|exact Mp].
      replace (e / m * m) with e in X by (field; lra). exact X.
Qed.

(* The tensor of a dominant eigenvector is degenerate, of mode 1. *)
Lemma degenerate_of_mode q : 0 < dot q q -> degenerate (degenerate_of q) /\ 0 < det (degenerate_of q) /\
  mode (degenerate_of q) = 1.
Proof.
  intros Q. assert (D : det (degenerate_of q) = 2 / 27 * (dot q q * dot q q * dot q q)).
  { clear Q. destruct q. unfold degenerate_of, det, deviator, sub, add, scale, identity, dyad, trace, dot. cbn. field. }
  assert (P : 0 < det (degenerate_of q)) by (rewrite D; apply Rmult_lt_0_compat; [lra|repeat apply Rmult_lt_0_compat; exact Q]).
  assert (Nz : degenerate_of q <> zero) by (intros Z; rewrite Z in P; unfold det, zero in P; cbn in P; lra).
  assert (Dg : degenerate (degenerate_of q)).
  { assert (Qz : q <> zero_vector) by (intros Z; rewrite Z in Q; unfold dot, zero_vector in Q; cbn in Q; lra).
    destruct (unit_vector q Qz) as [k [K U]]. exists (- (dot q q / 3)), (/ (k * k)), (scale_vector k q). split; [exact U|].
    assert (E : scale (/ (k * k)) (dyad (scale_vector k q)) = dyad q).
    { clear - K. destruct q. unfold dyad, scale_vector, scale. cbn. apply tensor_eq; cbn; field; exact K. }
    rewrite E. clear. destruct q. unfold degenerate_of, deviator, sub, trace, dot. tensor_ring. }
  split; [exact Dg|]. split; [exact P|].
  assert (T : trace (degenerate_of q) = 0) by apply trace_deviator.
  assert (R := proj2 (mode_range_ends _ Nz T) Dg). destruct (mode_det _ Nz) as [k [K M]].
  assert (0 < k * det (degenerate_of q)) by (apply Rmult_lt_0_compat; assumption).
  destruct R as [R|R]; [exact R|lra].
Qed.

Lemma near_and (P Q : R -> Prop) m : (exists d, 0 < d /\ forall x, Rabs (x - m) < d -> P x) ->
  (exists d, 0 < d /\ forall x, Rabs (x - m) < d -> Q x) ->
  exists d, 0 < d /\ forall x, Rabs (x - m) < d -> P x /\ Q x.
Proof.
  intros [d [D K]] [e [E L]]. exists (Rmin d e). split; [apply Rmin_glb_lt; assumption|].
  intros x X. assert (A := Rmin_l d e). assert (B := Rmin_r d e). split; [apply K|apply L]; lra.
Qed.

Lemma deviator_traceless n : trace n = 0 -> deviator n = n.
Proof. intros T. unfold deviator. rewrite T. replace (0 / 3) with 0 by field. clear. tensor_ring. Qed.

(* The arc of degenerate points as points in space. *)
Section Arc.
Variables (b1 b2 b3 : R) (e1 e2 e3 : vector) (c : tensor).
Hypotheses (O : orthonormal e1 e2 e3) (S : b1 + b2 + b3 = 0) (A : b1 >= b2) (B : b2 > 0).
Let N := spectral b1 b2 b3 e1 e2 e3.
Let p := curve b1 b2 b3 e1 e2 e3.
Definition arc x := scale (/ weight c (p x)) (degenerate_of (p x)).

Lemma arc_is_point x : 0 < weight c (p x) -> point N c (arc x) /\ mode (arc x) = 1.
Proof.
  intros W. destruct (degenerate_curve b1 b2 b3 e1 e2 e3 O S A B) as [On _]. destruct (On x) as [Z D].
  fold p in Z, D. fold N in Z. assert (I : 0 < / weight c (p x)) by (apply Rinv_0_lt_compat; exact W).
  assert (TN : trace N = 0) by (unfold N; rewrite trace_spectral by exact O; exact S).
  unfold arc. split; [split; [split|]|].
  - rewrite inner_sym, inner_scale, inner_sym. fold (weight N (p x)). rewrite (weight_form N).
    rewrite (deviator_traceless N TN), Z. ring.
  - rewrite trace_scale. unfold degenerate_of. rewrite trace_deviator. ring.
  - rewrite inner_sym, inner_scale, inner_sym. fold (weight c (p x)). field. lra.
  - rewrite mode_scale by exact I. apply degenerate_of_mode. lra.
Qed.

Lemma arc_near m eps : 0 < weight c (p m) -> 0 < eps ->
  exists d, 0 < d /\ forall x, Rabs (x - m) < d -> gap (arc m) (arc x) < eps.
Proof.
  intros W E. assert (C : b3 < 0) by lra.
  assert (Entry : forall a, exists d, 0 < d /\ forall x, Rabs (x - m) < d ->
    Rabs (/ weight c (p x) * weight a (p x) - / weight c (p m) * weight a (p m)) < eps / 7).
  { intros a. apply (continuous_near (fun x => / weight c (p x) * weight a (p x))); [|lra].
    apply (continuity_pt_mult (fun x => / weight c (p x)) (fun x => weight a (p x))).
    - apply (continuity_pt_inv (fun x => weight c (p x))); [apply weight_continuous; assumption|lra].
    - apply weight_continuous; assumption. }
  assert (Six := near_and _ _ m (Entry (Tensor 1 0 0 0 0 0)) (near_and _ _ m (Entry (Tensor 0 1 0 0 0 0))
    (near_and _ _ m (Entry (Tensor 0 0 1 0 0 0)) (near_and _ _ m (Entry (Tensor 0 0 0 (/ 2) 0 0))
    (near_and _ _ m (Entry (Tensor 0 0 0 0 (/ 2) 0)) (Entry (Tensor 0 0 0 0 0 (/ 2)))))))).
  destruct Six as [d [D K]]. exists d. split; [exact D|]. intros x X. assert (Q := K x X). clear K. cbv beta in Q.
  assert (V : forall k t, k * inner (Tensor 1 0 0 0 0 0) t = xx (scale k t) /\ k * inner (Tensor 0 1 0 0 0 0) t = yy (scale k t) /\
    k * inner (Tensor 0 0 1 0 0 0) t = zz (scale k t) /\ k * inner (Tensor 0 0 0 (/ 2) 0 0) t = xy (scale k t) /\
    k * inner (Tensor 0 0 0 0 (/ 2) 0) t = yz (scale k t) /\ k * inner (Tensor 0 0 0 0 0 (/ 2)) t = xz (scale k t)).
  { intros k t. unfold inner, scale. cbn. repeat split; field. }
  unfold weight in Q at 2 4 6 8 10 12 14 16 18 20 22 24. fold (weight c (p x)) (weight c (p m)) in Q.
  destruct (V (/ weight c (p x)) (degenerate_of (p x))) as [V1 [V2 [V3 [V4 [V5 V6]]]]].
  destruct (V (/ weight c (p m)) (degenerate_of (p m))) as [U1 [U2 [U3 [U4 [U5 U6]]]]].
  rewrite V1, V2, V3, V4, V5, V6, U1, U2, U3, U4, U5, U6 in Q. fold (arc x) (arc m) in Q.
  unfold gap. rewrite (Rabs_minus_sym (xx _)), (Rabs_minus_sym (yy _)), (Rabs_minus_sym (zz _)),
    (Rabs_minus_sym (xy _)), (Rabs_minus_sym (yz _)), (Rabs_minus_sym (xz _)). lra.
Qed.
End Arc.

Lemma no_larger_mode N c omega k : trace N = 0 -> det N < 0 -> -1 < k < 1 -> region N c omega ->
  (forall t, frontier N c omega t -> mode t = k) -> (exists t, omega t /\ k < mode t) -> False.
Proof.
  intros TN DN Kr Rg Fr [t0 [O0 K0]].
  assert (ZN : N <> zero) by (intros H; rewrite H in DN; unfold det, zero in DN; cbn in DN; lra).
  destruct (bounded N c omega Rg) as [r Rb]. assert (R0 : 0 <= r) by (apply Rle_trans with (norm t0); [apply norm_nonneg|apply Rb, O0]).
  assert (Pz := fun u U => point_not_zero N c u (of_points N c omega Rg u U)).
  destruct (near_supremum omega mode r 1 R0) as [t [s [Up Near]]].
  { intros u U. apply entries_within, Rb, U. }
  { exists t0. exact O0. }
  { intros u U. apply mode_range; [apply Pz, U|apply (of_points N c omega Rg u U)]. }
  assert (Close : forall eps, 0 < eps -> ~ forall u, omega u -> eps <= gap t u).
  { intros eps E H. apply (Near eps E). intros u U G. assert (L := H u U). lra. }
  assert (Pt := limit_is_point N c omega t Rg Close). assert (Zt := point_not_zero N c t Pt).
  assert (Ms : mode t = s).
  { apply Rle_antisym; apply Rnot_lt_le; intros L.
    - destruct (mode_near t (mode t - s) Zt ltac:(lra)) as [d [D Q]]. apply (Near d D). intros u U G.
      assert (X := Q u G). apply Rabs_def2 in X. assert (Y := Up u U). lra.
    - destruct (mode_near t ((s - mode t) / 2) Zt ltac:(lra)) as [d [D Q]].
      apply (Near (Rmin d ((s - mode t) / 2))); [apply Rmin_glb_lt; lra|]. intros u U G.
      assert (M1 := Rmin_l d ((s - mode t) / 2)). assert (M2 := Rmin_r d ((s - mode t) / 2)).
      assert (X := Q u ltac:(lra)). apply Rabs_def2 in X. lra. }
  assert (Kt : k < mode t) by (rewrite Ms; apply Rlt_le_trans with (1 := K0), Up, O0).
  assert (In : ~ ~ omega t).
  { intros H. assert (X := Fr t (conj Pt (conj H Close))). lra. }
  apply In. clear In. intros Ot.
  assert (Dt := largest_is_degenerate N c omega t TN ZN Rg Ot ltac:(rewrite Ms; exact Up)).
  destruct Pt as [[It Tt] Ct].
  assert (M1 : mode t = 1) by (destruct (proj2 (mode_range_ends t Zt Tt) Dt); lra).
  (* t is on the arc *)
  assert (Dt' := Dt). apply (degenerate_iff t Zt Tt) in Dt'. destruct Dt' as [a [e [A0 [Ue Ee]]]].
  destruct (spectral_theorem N) as [b1 [b2 [b3 [u [v [w [A [B [O E]]]]]]]]].
  assert (Sum : b1 + b2 + b3 = 0) by (rewrite <- TN, E; symmetry; apply trace_spectral, O).
  assert (P2 : b2 > 0).
  { assert (Db : b1 * b2 * b3 < 0) by (rewrite <- (det_spectral b1 b2 b3 u v w O), <- E; exact DN).
    apply Rnot_le_lt. intros H. assert (0 <= b1) by lra. assert (b3 <= 0) by lra.
    assert (0 <= b1 * (- b2) * (- b3)) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra). lra. }
  destruct (degenerate_curve b1 b2 b3 u v w O Sum A P2) as [On [All _]]. rewrite <- E in On, All.
  set (p := curve b1 b2 b3 u v w) in *.
  assert (Ze : form N e e = 0).
  { rewrite Ee, inner_sym, inner_scale, inner_sym, (inner_degenerate_at N e TN) in It.
    destruct (Rmult_integral _ _ It); [contradiction|assumption]. }
  assert (Ne : e <> zero_vector) by (intros H; rewrite H in Ue; unfold dot, zero_vector in Ue; cbn in Ue; lra).
  destruct (All e Ne Ze) as [x0 [l [X0 [L0 El]]]].
  assert (De : degenerate_at e = scale (l * l) (degenerate_of (p x0))).
  { transitivity (degenerate_of e).
    - clear - Ue. unfold degenerate_at, degenerate_of, deviator, sub. rewrite trace_dyad, Ue. replace (1 / 3) with (/ 3) by field. clear. tensor_ring.
    - rewrite El. generalize (p x0). clear. intros q. destruct q.
      unfold degenerate_of, deviator, sub, trace, add, scale, identity, dyad, scale_vector. cbn. apply tensor_eq; cbn; field. }
  assert (Et : t = scale (a * (l * l)) (degenerate_of (p x0))) by (rewrite Ee, De; apply scale_scale).
  set (j := a * (l * l)) in *.
  assert (Jz : j <> 0) by (unfold j; repeat apply Rmult_integral_contrapositive_currified; assumption).
  assert (Q0 : 0 < dot (p x0) (p x0)) by (destruct (On x0); lra).
  assert (Dm := degenerate_of_mode (p x0) Q0).
  assert (Jp : 0 < j).
  { destruct (Rtotal_order j 0) as [H|[H|H]]; [exfalso|contradiction|exact H].
    assert (Eo : t = scale (-1) (scale (- j) (degenerate_of (p x0)))) by (rewrite Et at 1; generalize (degenerate_of (p x0)) j; clear; intros; tensor_ring).
    rewrite Eo, mode_opposite, mode_scale in M1 by lra. lra. }
  assert (Wj : j * weight c (p x0) = 1).
  { rewrite <- Ct, Et, inner_sym, inner_scale, inner_sym. reflexivity. }
  assert (W0 : 0 < weight c (p x0)) by nra.
  assert (E0 : arc b1 b2 b3 u v w c x0 = t).
  { unfold arc. fold p. rewrite Et. f_equal. apply (Rmult_eq_reg_r (weight c (p x0))); [|lra]. rewrite Rinv_l by lra. lra. }
  destruct (degenerate_points_reach_infinity b1 b2 b3 u v w c x0 O Sum A P2 X0 W0) as [x1 [X1 [_ [Pos Far]]]].
  fold p in Pos, Far. set (y := arc b1 b2 b3 u v w c) in *.
  assert (Py : forall x, x0 <= x < x1 -> point N c (y x) /\ mode (y x) = 1).
  { intros x X. assert (H := arc_is_point b1 b2 b3 u v w c O Sum A P2 x (Pos x X)). rewrite <- E in H. exact H. }
  assert (Cy : forall x eps, x0 <= x < x1 -> 0 < eps -> exists d, 0 < d /\ forall z, Rabs (z - x) < d -> gap (y x) (y z) < eps).
  { intros x eps X Ep. apply (arc_near b1 b2 b3 u v w c Sum A P2); [apply Pos, X|exact Ep]. }
  (* the last parameter up to which the arc is in the set *)
  set (In := fun x => x0 <= x < x1 /\ forall z, x0 <= z <= x -> ~ ~ omega (y z)).
  assert (In0 : In x0) by (split; [lra|intros z Z H; apply H; replace z with x0 by lra; rewrite E0; exact Ot]).
  destruct (completeness In) as [m [Um Lm]]; [exists x1; intros x [X _]; lra|exists x0; exact In0|].
  assert (Mx : x0 <= m) by (apply Um, In0).
  assert (Mx1 : m <= x1) by (apply Lm; intros x [X _]; lra).
  assert (Before : forall z, x0 <= z < m -> ~ ~ omega (y z)).
  { intros z Z H. assert (m <= z); [|lra]. apply Lm. intros x [X Q]. apply Rnot_lt_le. intros L. apply (Q z ltac:(lra) H). }
  destruct Mx1 as [Mx1|Mx1].
  - assert (Im : ~ ~ omega (y m)).
    { intros H. destruct Mx as [Mx|Mx]; [|apply H; rewrite <- Mx, E0; exact Ot].
      destruct (Py m ltac:(lra)) as [Pm Mm].
      assert (X : mode (y m) = k); [|lra]. apply Fr. split; [exact Pm|]. split; [exact H|].
      intros eps Ep L. destruct (Cy m eps ltac:(lra) Ep) as [d [D Q]]. set (z := Rmax x0 (m - d / 2)).
      assert (Z : x0 <= z < m) by (unfold z; split; [apply Rmax_l|apply Rmax_lub_lt; lra]).
      assert (Z2 := Rmax_r x0 (m - d / 2)). fold z in Z2. apply (Before z Z). intros Oz.
      assert (G := Q z ltac:(apply Rabs_def1; lra)). assert (G' := L (y z) Oz). lra. }
    apply Im. clear Im. intros Om. destruct (open N c omega Rg (y m) Om) as [eps [Ep Q]].
    destruct (Cy m eps ltac:(lra) Ep) as [d [D G]]. set (x := Rmin ((m + x1) / 2) (m + d / 2)).
    assert (X : m < x) by (unfold x; apply Rmin_glb_lt; lra).
    assert (X2 := Rmin_l ((m + x1) / 2) (m + d / 2)). assert (X3 := Rmin_r ((m + x1) / 2) (m + d / 2)). fold x in X2, X3.
    assert (Ix : In x).
    { split; [lra|]. intros z Z. destruct (Rlt_dec z m) as [H|H]; [apply Before; lra|]. intros Nz. apply Nz, Q.
      - apply Py. lra.
      - apply G. apply Rabs_def1; lra. }
    assert (H := Um x Ix). lra.
  - destruct (Far r) as [x [X L]]. apply (Before x ltac:(lra)). intros Ox.
    assert (H := Rb (y x) Ox). unfold y, arc in H. fold p in H. rewrite norm_scale in H.
    assert (Wx := Pos x X). rewrite Rabs_pos_eq in H by (left; apply Rinv_0_lt_compat; exact Wx).
    apply (Rmult_le_compat_l (weight c (p x))) in H; [|lra]. rewrite <- Rmult_assoc, Rinv_r, Rmult_1_l in H by lra. lra.
Qed.

Lemma opposite_region N c omega : region N c omega ->
  region N (scale (-1) c) (fun t => omega (scale (-1) t)).
Proof.
  assert (Po : forall t, point N (scale (-1) c) t <-> point N c (scale (-1) t)).
  { intros t. unfold point, in_field. rewrite trace_scale, inner_scale, !(inner_sym _ (scale (-1) t)), !inner_scale, !(inner_sym t).
    split; intros [[H1 H2] H3]; repeat split; lra. }
  intros [R1 [t0 R2] [r R3] R4]. split.
  - intros t T. apply Po, R1, T.
  - exists (scale (-1) t0). rewrite twice_opposite. exact R2.
  - exists r. intros t T. assert (H := R3 _ T). rewrite norm_scale in H. replace (Rabs (-1)) with 1 in H by (rewrite Rabs_left; lra). lra.
  - intros t T. destruct (R4 _ T) as [eps [E Q]]. exists eps. split; [exact E|]. intros u U G. apply Q; [apply Po, U|].
    rewrite gap_opposite. exact G.
Qed.

Lemma no_region_negative N c omega k : trace N = 0 -> det N < 0 -> -1 < k < 1 -> region N c omega ->
  ~ (forall t, frontier N c omega t -> mode t = k).
Proof.
  intros TN DN K Rg Fr.
  assert (ZN : N <> zero) by (intros H; rewrite H in DN; unfold det, zero in DN; cbn in DN; lra).
  assert (Le : forall t, omega t -> mode t <= k).
  { intros t T. apply Rnot_lt_le. intros L. apply (no_larger_mode N c omega k TN DN K Rg Fr). exists t. auto. }
  assert (Ge : forall t, omega t -> k <= mode t).
  { intros t T. apply Rnot_lt_le. intros L.
    apply (no_larger_mode N (scale (-1) c) (fun t => omega (scale (-1) t)) (- k) TN DN ltac:(lra) (opposite_region N c omega Rg)).
    - intros s [[[S1 S2] S3] [S4 S5]]. assert (M : mode (scale (-1) s) = k); [|rewrite mode_opposite in M; lra].
      apply Fr. split; [split; [split|]|split].
      + rewrite inner_sym, inner_scale, inner_sym, S1. ring.
      + rewrite trace_scale, S2. ring.
      + rewrite inner_scale in S3. rewrite inner_sym, inner_scale, inner_sym. exact S3.
      + exact S4.
      + intros eps E H. apply (S5 eps E). intros u U. assert (G := H _ U). rewrite gap_opposite in G. exact G.
    - exists (scale (-1) t). rewrite twice_opposite, mode_opposite. split; [exact T|lra]. }
  destruct (not_empty N c omega Rg) as [t T]. assert (Pt := of_points N c omega Rg t T).
  assert (D := largest_is_degenerate N c omega t TN ZN Rg T).
  assert (M : forall u, omega u -> mode u <= mode t) by (intros u U; assert (A := Le u U); assert (B := Ge t T); lra).
  assert (A := Le t T). assert (B := Ge t T).
  destruct (proj2 (mode_range_ends t (point_not_zero N c t Pt) (proj2 (proj1 Pt))) (D M)); lra.
Qed.

Theorem no_closed_component N c omega k : trace N = 0 -> det N <> 0 -> -1 < k < 1 ->
  region N c omega -> ~ (forall t, frontier N c omega t -> mode t = k).
Proof.
  intros TN DN K Rg Fr. destruct (Rtotal_order (det N) 0) as [H|[H|H]]; [|contradiction|].
  - apply (no_region_negative N c omega k TN H K Rg Fr).
  - assert (Po : forall t, point (scale (-1) N) c t <-> point N c t).
    { intros t. unfold point, in_field. rewrite inner_scale. split; intros [[P1 P2] P3]; repeat split; lra. }
    apply (no_region_negative (scale (-1) N) c omega k); [rewrite trace_scale, TN; ring|rewrite det_scale; lra|exact K| |].
    + destruct Rg as [R1 R2 R3 R4]. split; auto.
      * intros t T. apply Po, R1, T.
      * intros t T. destruct (R4 t T) as [eps [E Q]]. exists eps. split; [exact E|]. intros u U. apply Q, Po, U.
    + intros t [P Q]. apply Fr. split; [apply Po, P|exact Q].
Qed.
