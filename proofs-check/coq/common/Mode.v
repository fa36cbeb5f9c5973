(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   The mode of a tensor, and the mode as a function of the parameter s of the eigenvalues
   (3 + s, -2 s, s - 3). *)
From TensorTopo Require Import Tensors Frames SpectralTheorem.
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

Definition mode t := 3 * sqrt 6 * det t / (norm t * norm t * norm t).
Definition parameter_mode s :=
  s * (9 - s * s) / (sqrt (3 + s * s) * sqrt (3 + s * s) * sqrt (3 + s * s)).

Lemma sqrt6 : sqrt 6 * sqrt 6 = 6.
Proof. apply sqrt_sqrt. lra. Qed.
Lemma sqrt6_positive : 0 < sqrt 6.
Proof. apply sqrt_lt_R0. lra. Qed.

(* The square of the mode is rational: mode^2 |T|^6 = 54 det^2. *)
Lemma mode_squared t : t <> zero ->
  mode t * mode t * (norm2 t * norm2 t * norm2 t) = 54 * (det t * det t).
Proof.
  intros H. assert (P := norm_positive t H). unfold mode. rewrite <- norm_squared.
  transitivity (9 * (sqrt 6 * sqrt 6) * (det t * det t)); [field; lra|rewrite sqrt6; ring].
Qed.

(* The sign of the mode is that of the determinant. *)
Lemma mode_det t : t <> zero -> exists k, 0 < k /\ mode t = k * det t.
Proof.
  intros H. assert (P := norm_positive t H). assert (S := sqrt6_positive).
  exists (3 * sqrt 6 / (norm t * norm t * norm t)). split; [|unfold mode; field; lra].
  apply Rdiv_lt_0_compat; [lra|]. repeat apply Rmult_lt_0_compat; assumption.
Qed.

Lemma norm_scale k t : norm (scale k t) = Rabs k * norm t.
Proof.
  unfold norm. rewrite norm2_scale.
  rewrite sqrt_mult by (try apply norm2_nonneg; apply square_nonneg).
  f_equal. exact (sqrt_Rsqr_abs k).
Qed.
Lemma mode_scale k t : 0 < k -> mode (scale k t) = mode t.
Proof.
  intros K. unfold mode. rewrite norm_scale, det_scale, (Rabs_pos_eq k) by lra.
  destruct (Req_dec (norm t) 0) as [Z|Z].
  - rewrite Z, !Rmult_0_r. unfold Rdiv. rewrite Rinv_0. ring.
  - field. lra.
Qed.
Lemma mode_opposite t : mode (scale (-1) t) = - mode t.
Proof.
  unfold mode. rewrite norm_scale, det_scale.
  replace (Rabs (-1)) with 1 by (rewrite Rabs_left; lra). rewrite Rmult_1_l.
  unfold Rdiv. ring.
Qed.

(* The tensor with eigenvalues k (3 + s, -2 s, s - 3), and its mode. *)
Definition of_parameter k s u v w := spectral (k * (3 + s)) (k * (-2 * s)) (k * (s - 3)) u v w.

Lemma sqrt_parameter s : 0 < sqrt (3 + s * s).
Proof. apply sqrt_lt_R0. assert (H := square_nonneg s). lra. Qed.

Lemma mode_of_parameter k s u v w : 0 < k -> orthonormal u v w ->
  mode (of_parameter k s u v w) = parameter_mode s.
Proof.
  intros K O. unfold mode, norm, of_parameter. rewrite norm2_spectral, det_spectral by exact O.
  replace (_ + _ + _) with (k * k * (6 * (3 + s * s))) by ring.
  assert (H := square_nonneg s).
  rewrite sqrt_mult, sqrt_square, sqrt_mult by (try apply square_nonneg; lra).
  unfold parameter_mode. assert (Q := sqrt_parameter s). assert (S := sqrt6_positive).
  set (r := sqrt (3 + s * s)) in *.
  transitivity (6 / (sqrt 6 * sqrt 6) * (s * (9 - s * s) / (r * r * r))).
  - field. lra.
  - rewrite sqrt6. field. lra.
Qed.

(* Every traceless tensor but zero has such a form, with k > 0 and -1 <= s <= 1. *)
Theorem parameter_of_eigenvalues l1 l2 l3 : l1 >= l2 -> l2 >= l3 -> l1 + l2 + l3 = 0 ->
  l1 > l3 -> exists k s, 0 < k /\ -1 <= s <= 1 /\
  l1 = k * (3 + s) /\ l2 = k * (-2 * s) /\ l3 = k * (s - 3).
Proof.
  intros A B T N. exists ((l1 - l3) / 6), (- 3 * l2 / (l1 - l3)).
  assert (D : l1 - l3 <> 0) by lra. assert (P : 0 < l1 - l3) by lra.
  assert (L2 : l2 = - l1 - l3) by lra.
  assert (E : - 3 * l2 / (l1 - l3) * (l1 - l3) = - 3 * l2) by (field; exact D).
  set (s := - 3 * l2 / (l1 - l3)) in *.
  split; [lra|]. split.
  - split.
    + apply Rnot_lt_le. intros C. assert (0 < (-1 - s) * (l1 - l3)) by (apply Rmult_lt_0_compat; lra). lra.
    + apply Rnot_lt_le. intros C. assert (0 < (s - 1) * (l1 - l3)) by (apply Rmult_lt_0_compat; lra). lra.
  - repeat split.
    + transitivity (((l1 - l3) * 3 + s * (l1 - l3)) / 6); [rewrite E; lra|field].
    + transitivity (- 2 * (s * (l1 - l3)) / 6); [rewrite E; lra|field].
    + transitivity ((s * (l1 - l3) - 3 * (l1 - l3)) / 6); [rewrite E; lra|field].
Qed.

(* v is a medium eigenvector of T. *)
Definition medium_eigenvector v t := exists l1 l2 l3 u w,
  l1 >= l2 /\ l2 >= l3 /\ orthonormal u v w /\ t = spectral l1 l2 l3 u v w.

Lemma spectral_zero u v w : spectral 0 0 0 u v w = zero.
Proof. unfold spectral. tensor_ring. Qed.

Theorem parameter_of_tensor t v : t <> zero -> trace t = 0 -> medium_eigenvector v t ->
  exists k s u w, 0 < k /\ -1 <= s <= 1 /\ orthonormal u v w /\ t = of_parameter k s u v w.
Proof.
  intros N T [l1 [l2 [l3 [u [w [A [B [O E]]]]]]]].
  assert (S : l1 + l2 + l3 = 0) by (rewrite <- T, E; symmetry; apply trace_spectral, O).
  assert (D : l1 > l3).
  { destruct (Rlt_dec l3 l1) as [H|H]; [exact H|]. exfalso. apply N. rewrite E.
    replace l1 with 0 by lra. replace l2 with 0 by lra. replace l3 with 0 by lra.
    apply spectral_zero. }
  destruct (parameter_of_eigenvalues l1 l2 l3 A B S D) as [k [s [K [I [E1 [E2 E3]]]]]].
  exists k, s, u, w. split; [exact K|]. split; [exact I|]. split; [exact O|].
  unfold of_parameter. rewrite <- E1, <- E2, <- E3. exact E.
Qed.

Lemma medium_exists t : exists v, medium_eigenvector v t.
Proof.
  destruct (spectral_theorem t) as [l1 [l2 [l3 [u [v [w [A [B [O E]]]]]]]]].
  exists v, l1, l2, l3, u, w. auto.
Qed.

(* 1 - mode^2 = 27 (1 - s^2)^2 / (3 + s^2)^3. *)
Lemma parameter_mode_squared s :
  parameter_mode s * parameter_mode s * ((3 + s * s) * (3 + s * s) * (3 + s * s))
  = (s * (9 - s * s)) * (s * (9 - s * s)).
Proof.
  unfold parameter_mode. assert (Q := sqrt_parameter s).
  assert (E : sqrt (3 + s * s) * sqrt (3 + s * s) = 3 + s * s)
    by (apply sqrt_sqrt; assert (H := square_nonneg s); lra).
  rewrite <- E at 7 8 9. set (r := sqrt (3 + s * s)) in *. field. lra.
Qed.
Lemma parameter_mode_complement s :
  (1 - parameter_mode s * parameter_mode s) * ((3 + s * s) * (3 + s * s) * (3 + s * s))
  = 27 * ((1 - s * s) * (1 - s * s)).
Proof.
  assert (H := parameter_mode_squared s). set (m := parameter_mode s * parameter_mode s) in *.
  transitivity ((3 + s * s) * (3 + s * s) * (3 + s * s) - (s * (9 - s * s)) * (s * (9 - s * s)));
    [rewrite <- H; ring|ring].
Qed.

Lemma parameter_mode_opposite s : parameter_mode (- s) = - parameter_mode s.
Proof.
  unfold parameter_mode. replace (- s * - s) with (s * s) by ring. unfold Rdiv. ring.
Qed.
Lemma parameter_mode_sign s : -1 <= s <= 1 -> exists k, 0 < k /\ parameter_mode s = k * s.
Proof.
  intros H. assert (Q := sqrt_parameter s).
  exists ((9 - s * s) / (sqrt (3 + s * s) * sqrt (3 + s * s) * sqrt (3 + s * s))).
  split; [|unfold parameter_mode, Rdiv; ring].
  apply Rdiv_lt_0_compat; [nra|]. repeat apply Rmult_lt_0_compat; assumption.
Qed.

(* Strictly increasing on [-1, 1]: the squares, y (9 - y)^2 / (3 + y)^3 with y = s^2, are, because
   the difference of the cross products has the factor y2 - y1. *)
Lemma squares_increase y1 y2 : 0 <= y1 -> y1 < y2 -> y2 <= 1 ->
  y1 * (9 - y1) * (9 - y1) * ((3 + y2) * (3 + y2) * (3 + y2))
  < y2 * (9 - y2) * (9 - y2) * ((3 + y1) * (3 + y1) * (3 + y1)).
Proof.
  intros A B C.
  (* 1 - mode^2 is 27 ((1 - y) / (3 + y))^2 / (3 + y), and both factors fall. *)
  assert (E : forall y, y * (9 - y) * (9 - y)
    = (3 + y) * (3 + y) * (3 + y) - 27 * ((1 - y) * (1 - y))) by (intros; ring).
  rewrite !E.
  assert (P : (1 - y2) * (3 + y1) < (1 - y1) * (3 + y2)) by nra.
  assert (Q : 0 <= (1 - y2) * (3 + y1)) by (apply Rmult_le_pos; lra).
  set (a := (1 - y2) * (3 + y1)) in *. set (b := (1 - y1) * (3 + y2)) in *.
  assert (AB : a * a < b * b) by nra.
  assert (F : a * a * (3 + y1) < b * b * (3 + y2)) by nra.
  unfold a, b in F. lra.
Qed.

Theorem parameter_mode_increases s1 s2 : -1 <= s1 -> s1 < s2 -> s2 <= 1 ->
  parameter_mode s1 < parameter_mode s2.
Proof.
  assert (M : forall s1 s2, 0 <= s1 -> s1 < s2 -> s2 <= 1 -> parameter_mode s1 < parameter_mode s2).
  { clear. intros s1 s2 A B C.
    destruct (parameter_mode_sign s1) as [k1 [K1 E1]]; [lra|].
    destruct (parameter_mode_sign s2) as [k2 [K2 E2]]; [lra|].
    assert (S1 := parameter_mode_squared s1). assert (S2 := parameter_mode_squared s2).
    assert (I := squares_increase (s1 * s1) (s2 * s2) ltac:(nra) ltac:(nra) ltac:(nra)).
    assert (P1 : 0 <= parameter_mode s1) by (rewrite E1; nra).
    assert (P2 : 0 < parameter_mode s2) by (rewrite E2; nra).
    set (c1 := (3 + s1 * s1) * (3 + s1 * s1) * (3 + s1 * s1)) in *.
    set (c2 := (3 + s2 * s2) * (3 + s2 * s2) * (3 + s2 * s2)) in *.
    assert (C1 : 0 < c1) by (unfold c1; repeat apply Rmult_lt_0_compat; nra).
    assert (C2 : 0 < c2) by (unfold c2; repeat apply Rmult_lt_0_compat; nra).
    set (m1 := parameter_mode s1) in *. set (m2 := parameter_mode s2) in *.
    assert (J : m1 * m1 * c1 * c2 < m2 * m2 * c2 * c1) by (rewrite S1, S2; lra).
    apply Rnot_le_lt. intros W. assert (0 <= (m1 * m1 - m2 * m2) * (c1 * c2)).
    { apply Rmult_le_pos; [nra|]. apply Rlt_le, Rmult_lt_0_compat; assumption. }
    lra. }
  intros A B C. destruct (Rle_or_lt 0 s1) as [H|H]; [apply M; lra|].
  destruct (Rle_or_lt s2 0) as [G|G].
  - assert (L := M (- s2) (- s1) ltac:(lra) ltac:(lra) ltac:(lra)).
    rewrite !parameter_mode_opposite in L. lra.
  - destruct (parameter_mode_sign s1) as [k1 [K1 E1]]; [lra|].
    destruct (parameter_mode_sign s2) as [k2 [K2 E2]]; [lra|].
    assert (0 < k1 * - s1) by (apply Rmult_lt_0_compat; lra).
    assert (0 < k2 * s2) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

Lemma parameter_mode_injective s1 s2 : -1 <= s1 <= 1 -> -1 <= s2 <= 1 ->
  parameter_mode s1 = parameter_mode s2 -> s1 = s2.
Proof.
  intros A B E. destruct (Rtotal_order s1 s2) as [H|[H|H]]; [|exact H|].
  - assert (L := parameter_mode_increases s1 s2). lra.
  - assert (L := parameter_mode_increases s2 s1). lra.
Qed.
