(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   Completeness of the pencil: all critical points of the mode on a plane. The plane is what is
   orthogonal to the independent tensors N1, N2. A nondegenerate T in it is critical exactly if its
   dual N is in the pencil of N1 and N2; then either N is not degenerate, T is a multiple of the dual
   of N, and N solves a binary cubic; or N is degenerate, T is neutral, and the dominant eigenvector
   of N is the kernel of T. *)
From TensorTopo Require Import Tensors Frames DegenerateTensors SpectralTheorem Mode ModeRange
  ModeOnSimplex Dual.
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

Definition in_plane n1 n2 t := inner n1 t = 0 /\ inner n2 t = 0 /\ trace t = 0.
Definition critical_in_plane n1 n2 t := forall u, in_plane n1 n2 u ->
  derivable_pt_lim (fun x => mode (add t (scale x u))) 0 0.
Definition independent n1 n2 := forall a b, add (scale a n1) (scale b n2) = zero -> a = 0 /\ b = 0.
Definition pencil k1 k2 n1 n2 := add (scale k1 n1) (scale k2 n2).

(* The Gram determinant of independent tensors is positive. *)
Lemma gram_positive n1 n2 : independent n1 n2 ->
  0 < norm2 n1 * norm2 n2 - inner n1 n2 * inner n1 n2.
Proof.
  intros I. assert (P : 0 < norm2 n1).
  { apply norm2_positive. intros Z. destruct (I 1 0); [rewrite Z; clear; tensor_ring|lra]. }
  set (c := inner n1 n2 / norm2 n1).
  assert (Z : pencil (- c) 1 n1 n2 <> zero) by (intros Z; destruct (I (- c) 1 Z); lra).
  assert (Q := norm2_positive _ Z).
  assert (E : norm2 n1 * norm2 (pencil (- c) 1 n1 n2) = norm2 n1 * norm2 n2 - inner n1 n2 * inner n1 n2).
  { transitivity (norm2 n1 * (c * c * norm2 n1 - 2 * c * inner n1 n2 + norm2 n2)).
    - f_equal. unfold pencil, norm2. rewrite !inner_add, !inner_scale, (inner_sym n1 (add _ _)), (inner_sym n2 (add _ _)).
      rewrite !inner_add, !inner_scale, (inner_sym n2 n1). ring.
    - unfold c. field. lra. }
  rewrite <- E. apply Rmult_lt_0_compat; assumption.
Qed.

(* Lagrange with two conditions. *)
Lemma lagrange_plane n1 n2 t : trace n1 = 0 -> trace n2 = 0 -> independent n1 n2 ->
  t <> zero -> trace t = 0 ->
  (critical_in_plane n1 n2 t <-> exists k1 k2, dual t = pencil k1 k2 n1 n2).
Proof.
  intros T1 T2 I Z T. assert (G := gram_positive n1 n2 I). split.
  - intros C. set (g := norm2 n1 * norm2 n2 - inner n1 n2 * inner n1 n2) in *.
    set (x1 := inner (dual t) n1). set (x2 := inner (dual t) n2).
    set (k1 := (x1 * norm2 n2 - x2 * inner n1 n2) / g). set (k2 := (x2 * norm2 n1 - x1 * inner n1 n2) / g).
    exists k1, k2. set (u := sub (dual t) (pencil k1 k2 n1 n2)).
    assert (U1 : inner n1 u = 0).
    { unfold u, sub, pencil. rewrite inner_sym, !inner_add, !inner_scale, !inner_add, !inner_scale.
      fold x1 (norm2 n1). rewrite (inner_sym n2 n1). unfold k1, k2. unfold g at 1 2. field. fold g. lra. }
    assert (U2 : inner n2 u = 0).
    { unfold u, sub, pencil. rewrite inner_sym, !inner_add, !inner_scale, !inner_add, !inner_scale.
      fold x2 (norm2 n2). unfold k1, k2. unfold g at 1 2. field. fold g. lra. }
    assert (U3 : trace u = 0).
    { unfold u, sub, pencil. rewrite !trace_add, !trace_scale, !trace_add, !trace_scale, (trace_dual t T), T1, T2. ring. }
    destruct (mode_directional t u Z T U3) as [k [K D]].
    assert (E := uniqueness_limite _ _ _ _ (C u (conj U1 (conj U2 U3))) D).
    assert (H : inner (dual t) u = 0) by (symmetry in E; destruct (Rmult_integral _ _ E); [lra|assumption]).
    assert (NU : norm2 u = 0).
    { transitivity (inner (dual t) u - (k1 * inner n1 u + k2 * inner n2 u)).
      - unfold norm2. unfold u at 1, sub, pencil. rewrite !inner_add, !inner_scale, !inner_add, !inner_scale. ring.
      - rewrite H, U1, U2. ring. }
    apply norm2_zero in NU. unfold u, sub in NU.
    transitivity (add (add (dual t) (scale (-1) (pencil k1 k2 n1 n2))) (pencil k1 k2 n1 n2)).
    + generalize (dual t) (pencil k1 k2 n1 n2). clear. intros. tensor_ring.
    + rewrite NU. generalize (pencil k1 k2 n1 n2). clear. intros. tensor_ring.
  - intros [k1 [k2 E]] u [U1 [U2 U3]]. destruct (mode_directional t u Z T U3) as [c [_ D]].
    rewrite E in D. unfold pencil in D. rewrite inner_add, !inner_scale, U1, U2 in D.
    replace (c * (k1 * 0 + k2 * 0)) with 0 in D by ring. exact D.
Qed.

(* The cubic for k1 : k2, and what it says: the dual of N is in the plane. *)
Definition cubic n n1 n2 := inner (square n) n1 * inner n n2 - inner (square n) n2 * inner n n1.

Lemma cubic_iff k1 k2 n1 n2 : trace n1 = 0 -> trace n2 = 0 ->
  let n := pencil k1 k2 n1 n2 in n <> zero ->
  (cubic n n1 n2 = 0 <-> in_plane n1 n2 (dual n)).
Proof.
  intros T1 T2 n Z. assert (P := norm2_positive n Z).
  assert (T : trace n = 0) by (unfold n, pencil; rewrite trace_add, !trace_scale, T1, T2; ring).
  assert (Tr : forall m, trace m = 0 -> inner (dual n) m = norm2 n * inner (square n) m - 3 * det n * inner n m).
  { intros m H. unfold dual. rewrite !inner_add, !inner_scale.
    replace (inner identity m) with (trace m) by (unfold inner, identity, trace; cbn; ring). rewrite H. ring. }
  set (x1 := inner (dual n) n1). set (x2 := inner (dual n) n2).
  set (y1 := inner n n1). set (y2 := inner n n2).
  assert (X : k1 * x1 + k2 * x2 = 0).
  { rewrite <- (inner_dual n T). unfold x1, x2. rewrite (inner_sym (dual n) n). unfold n at 3, pencil.
    rewrite inner_add, !inner_scale, (inner_sym n1), (inner_sym n2). reflexivity. }
  assert (Y : k1 * y1 + k2 * y2 = norm2 n).
  { unfold norm2. unfold n at 2, pencil. unfold y1, y2. rewrite (inner_sym n (add _ _)), inner_add, !inner_scale, (inner_sym n1), (inner_sym n2).
    reflexivity. }
  assert (C : norm2 n * cubic n n1 n2 = x1 * y2 - x2 * y1).
  { unfold cubic, x1, x2, y1, y2. rewrite (Tr n1 T1), (Tr n2 T2). ring. }
  split.
  - intros H. rewrite H, Rmult_0_r in C.
    assert (A1 : x1 * norm2 n = 0).
    { rewrite <- Y. transitivity (y1 * (k1 * x1 + k2 * x2) + k2 * (x1 * y2 - x2 * y1)); [ring|rewrite X, <- C; ring]. }
    assert (A2 : x2 * norm2 n = 0).
    { rewrite <- Y. transitivity (y2 * (k1 * x1 + k2 * x2) - k1 * (x1 * y2 - x2 * y1)); [ring|rewrite X, <- C; ring]. }
    destruct (Rmult_integral _ _ A1); [|lra]. destruct (Rmult_integral _ _ A2); [|lra].
    split; [rewrite inner_sym; assumption|]. split; [rewrite inner_sym; assumption|apply trace_dual, T].
  - intros [H1 [H2 _]]. rewrite inner_sym in H1. rewrite inner_sym in H2. fold x1 in H1. fold x2 in H2.
    rewrite H1, H2 in C. apply (Rmult_eq_reg_l (norm2 n)); lra.
Qed.

(* Roots of the cubic give critical points. *)
Theorem pencil_is_critical k1 k2 n1 n2 : trace n1 = 0 -> trace n2 = 0 -> independent n1 n2 ->
  let n := pencil k1 k2 n1 n2 in n <> zero -> ~ degenerate n -> cubic n n1 n2 = 0 ->
  in_plane n1 n2 (dual n) /\ critical_in_plane n1 n2 (dual n) /\
  mode (dual n) * mode (dual n) + mode n * mode n = 1.
Proof.
  intros T1 T2 I n Z D C.
  assert (T : trace n = 0) by (unfold n, pencil; rewrite trace_add, !trace_scale, T1, T2; ring).
  assert (DZ : dual n <> zero) by (intros H; apply D, dual_zero; assumption).
  split; [apply (cubic_iff k1 k2); assumption|]. split.
  - apply lagrange_plane; auto; [apply trace_dual, T|].
    destruct (spectral_theorem n) as [t1 [t2 [t3 [u [v [w [_ [_ [O F]]]]]]]]].
    assert (S : t1 + t2 + t3 = 0) by (rewrite <- T, F; symmetry; apply trace_spectral, O).
    exists (dual_factor t1 t2 t3 * k1), (dual_factor t1 t2 t3 * k2).
    assert (E := dual_dual t1 t2 t3 u v w O S). rewrite <- F in E. rewrite E. unfold n, pencil.
    generalize (dual_factor t1 t2 t3). clear. intros. tensor_ring.
  - assert (M := mode_dual n T DZ). lra.
Qed.

(* And there are no other nondegenerate critical points but neutral ones over a degenerate N. *)
Theorem pencil_is_complete n1 n2 t : trace n1 = 0 -> trace n2 = 0 -> independent n1 n2 ->
  t <> zero -> in_plane n1 n2 t -> ~ degenerate t -> critical_in_plane n1 n2 t ->
  exists k1 k2, let n := pencil k1 k2 n1 n2 in n <> zero /\
  ((~ degenerate n /\ cubic n n1 n2 = 0 /\ exists c, c <> 0 /\ t = scale c (dual n)) \/
   (det t = 0 /\ degenerate n /\ exists a e, dot e e = 1 /\ apply t e = zero_vector /\
      n = scale a (add (dyad e) (scale (- / 3) identity)))).
Proof.
  intros T1 T2 I Z [P1 [P2 T]] D C. apply (lagrange_plane n1 n2 t T1 T2 I Z T) in C.
  destruct C as [k1 [k2 E]]. exists k1, k2. set (n := pencil k1 k2 n1 n2) in *.
  assert (NZ : n <> zero) by (intros H; apply D, dual_zero; [exact T|rewrite E; exact H]).
  split; [exact NZ|].
  assert (Tn : trace n = 0) by (unfold n, pencil; rewrite trace_add, !trace_scale, T1, T2; ring).
  destruct (spectral_theorem t) as [a [b [c [u [v [w [A [B [O F]]]]]]]]].
  assert (S : a + b + c = 0) by (rewrite <- T, F; symmetry; apply trace_spectral, O).
  assert (DD := dual_dual a b c u v w O S). rewrite <- F, E in DD.
  set (f := dual_factor a b c) in *.
  destruct (Req_dec (det t) 0) as [Dt|Dt].
  - right. split; [exact Dt|]. assert (F0 : f = 0).
    { unfold f, dual_factor. rewrite F, (det_spectral _ _ _ _ _ _ O) in Dt. rewrite Dt. ring. }
    rewrite F0 in DD. replace (scale 0 t) with zero in DD by (generalize t; clear; intros; tensor_ring).
    split; [apply dual_zero; assumption|].
    (* b = 0, and the dual is a multiple of v v^T - I/3 *)
    assert (B0 : b = 0).
    { rewrite F, (det_spectral _ _ _ _ _ _ O) in Dt.
      destruct (Rmult_integral _ _ Dt) as [H|H]; [destruct (Rmult_integral _ _ H)|]; lra. }
    exists (- 2 * (a * a) * (a * a)), v. split; [apply O|]. split.
    + assert (Q : forall x, dot (apply t v) x = 0).
      { intros x. rewrite dot_sym. change (form t x v = 0). rewrite F, form_spectral, (unit_2 _ _ _ O), (perp_12 _ _ _ O).
        rewrite (dot_sym w v), (perp_23 _ _ _ O), B0. ring. }
      apply (perpendicular_to_frame u v w _ O); apply Q.
    + rewrite <- E, F, (dual_spectral _ _ _ _ _ _ O S), (identity_spectral u v w O), B0.
      replace c with (- a) by lra. apply tensor_by_form. intros x y.
      rewrite form_scale, form_add, form_scale, !form_spectral, form_dyad. field.
  - left. assert (F0 : f <> 0).
    { intros H. unfold f, dual_factor in H.
      assert (Ab : (a - b) * (b - c) * (a - c) <> 0).
      { intros K. apply D, dual_zero; [exact T|]. rewrite F, (dual_spectral _ _ _ _ _ _ O S), K.
        rewrite <- (spectral_zero u v w). f_equal; field. }
      rewrite F, (det_spectral _ _ _ _ _ _ O) in Dt.
      set (d := (a - b) * (b - c) * (a - c) / 3) in *.
      assert (Dz : d <> 0) by (unfold d; intros K; apply Ab; lra).
      assert (0 < d * d) by (apply square_pos; exact Dz).
      assert (0 < d * d * (d * d)) by (apply Rmult_lt_0_compat; assumption).
      destruct (Rmult_integral _ _ H) as [K|K]; [destruct (Rmult_integral _ _ K); [lra|contradiction]|lra]. }
    assert (Td : t = scale (/ f) (dual n)).
    { rewrite DD, scale_scale, Rinv_l, scale_one by exact F0. reflexivity. }
    assert (IF : / f <> 0) by (apply Rinv_neq_0_compat; exact F0).
    assert (In : in_plane n1 n2 (dual n)).
    { rewrite DD. split; [|split].
      - rewrite inner_sym, inner_scale, inner_sym, P1. ring.
      - rewrite inner_sym, inner_scale, inner_sym, P2. ring.
      - rewrite trace_scale, T. ring. }
    split; [|split].
    + intros H. apply dual_zero in H; [|exact Tn]. apply Z. rewrite Td, H. clear. tensor_ring.
    + apply (cubic_iff k1 k2); assumption.
    + exists (/ f). split; assumption.
Qed.
