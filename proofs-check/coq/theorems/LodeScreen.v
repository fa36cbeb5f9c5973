(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   The screen: a third of the arc cosine of the mode (the Lode angle) changes by no more than the
   angle between two tensors. The eigenvalues of two tensors in descending order have at least the
   inner product of the tensors (Hoffman and Wielandt for 3x3; the squares of the cosines between
   the eigenvectors are doubly stochastic), and the eigenvalues of unit deviators are vectors whose
   angle is the difference of the Lode angles. *)
From TensorTopo Require Import Tensors Frames SpectralTheorem Mode Calculus.
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

(* Moving weight of a doubly stochastic matrix onto the diagonal does not reduce the sum. *)
Lemma rearrangement a1 a2 a3 b1 b2 b3 s11 s12 s13 s21 s22 s23 s31 s32 s33 :
  a1 >= a2 -> a2 >= a3 -> b1 >= b2 -> b2 >= b3 ->
  0 <= s12 -> 0 <= s13 -> 0 <= s21 -> 0 <= s23 -> 0 <= s31 -> 0 <= s32 ->
  s11 + s12 + s13 = 1 -> s21 + s22 + s23 = 1 -> s31 + s32 + s33 = 1 ->
  s11 + s21 + s31 = 1 -> s12 + s22 + s32 = 1 -> s13 + s23 + s33 = 1 ->
  a1 * (s11 * b1 + s12 * b2 + s13 * b3) + a2 * (s21 * b1 + s22 * b2 + s23 * b3)
  + a3 * (s31 * b1 + s32 * b2 + s33 * b3) <= a1 * b1 + a2 * b2 + a3 * b3.
Proof.
  intros.
  assert (s11 = 1 - s12 - s13) by lra. assert (s22 = 1 - s21 - s23) by lra.
  assert (s33 = 1 - s31 - s32) by lra. assert (s12 = s21 + s31 - s13) by lra.
  assert (s32 = s13 + s23 - s31) by lra. subst.
  set (p := a1 - a2). set (q := a2 - a3). set (x := b1 - b2). set (y := b2 - b3).
  assert (P : forall i j k, 0 <= i -> 0 <= j -> 0 <= k -> 0 <= i * j * k)
    by (intros; repeat apply Rmult_le_pos; assumption).
  assert (0 <= p * x * (s21 + s31)) by (apply P; unfold p, x; lra).
  assert (0 <= p * y * s13) by (apply P; unfold p, y; lra).
  assert (0 <= q * x * s31) by (apply P; unfold q, x; lra).
  assert (0 <= q * y * (s13 + s23)) by (apply P; unfold q, y; lra).
  unfold p, q, x, y in *. lra.
Qed.

Theorem trace_inequality a1 a2 a3 u v w b1 b2 b3 u' v' w' :
  a1 >= a2 -> a2 >= a3 -> b1 >= b2 -> b2 >= b3 -> orthonormal u v w -> orthonormal u' v' w' ->
  inner (spectral a1 a2 a3 u v w) (spectral b1 b2 b3 u' v' w') <= a1 * b1 + a2 * b2 + a3 * b3.
Proof.
  intros A1 A2 B1 B2 O O'. rewrite inner_spectral, !form_spectral.
  set (s11 := dot u' u * dot u' u). set (s12 := dot v' u * dot v' u). set (s13 := dot w' u * dot w' u).
  set (s21 := dot u' v * dot u' v). set (s22 := dot v' v * dot v' v). set (s23 := dot w' v * dot w' v).
  set (s31 := dot u' w * dot u' w). set (s32 := dot v' w * dot v' w). set (s33 := dot w' w * dot w' w).
  assert (R : forall x, dot x x = 1 ->
    dot u' x * dot u' x + dot v' x * dot v' x + dot w' x * dot w' x = 1).
  { intros x X. rewrite <- X. rewrite (dot_resolved u' v' w' x x O').
    rewrite (dot_sym x u'), (dot_sym x v'), (dot_sym x w'). reflexivity. }
  assert (C : forall x, dot x x = 1 -> dot x u * dot x u + dot x v * dot x v + dot x w * dot x w = 1).
  { intros x X. rewrite <- X. symmetry. apply (dot_resolved u v w x x O). }
  assert (N : forall x y, 0 <= dot x y * dot x y) by (intros; apply square_nonneg).
  assert (K := rearrangement a1 a2 a3 b1 b2 b3 s11 s12 s13 s21 s22 s23 s31 s32 s33 A1 A2 B1 B2
    (N _ _) (N _ _) (N _ _) (N _ _) (N _ _) (N _ _)
    (R u (unit_1 _ _ _ O)) (R v (unit_2 _ _ _ O)) (R w (unit_3 _ _ _ O))
    (C u' (unit_1 _ _ _ O')) (C v' (unit_2 _ _ _ O')) (C w' (unit_3 _ _ _ O'))).
  lra.
Qed.

(* Ordered eigenvalues are no farther apart than the tensors. *)
Theorem hoffman_wielandt a1 a2 a3 u v w b1 b2 b3 u' v' w' :
  a1 >= a2 -> a2 >= a3 -> b1 >= b2 -> b2 >= b3 -> orthonormal u v w -> orthonormal u' v' w' ->
  (a1 - b1) ^ 2 + (a2 - b2) ^ 2 + (a3 - b3) ^ 2
  <= norm2 (sub (spectral a1 a2 a3 u v w) (spectral b1 b2 b3 u' v' w')).
Proof.
  intros A1 A2 B1 B2 O O'.
  assert (T := trace_inequality a1 a2 a3 u v w b1 b2 b3 u' v' w' A1 A2 B1 B2 O O').
  assert (E : forall a b, norm2 (sub a b) = norm2 a + norm2 b - 2 * inner a b)
    by (intros; coordinates; ring).
  rewrite E, !norm2_spectral by assumption. lra.
Qed.

Definition lode t := arc_cosine (mode t) / 3.
Definition angle a b := arc_cosine (inner a b / (norm a * norm b)).

Lemma cos_triple x : cos (3 * x) = 4 * (cos x * cos x * cos x) - 3 * cos x.
Proof.
  replace (3 * x) with (2 * x + x) by ring. rewrite cos_plus, cos_2a, sin_2a.
  assert (H := sin2_cos2 x). unfold Rsqr in H.
  transitivity (cos x * cos x * cos x - 3 * (sin x * sin x) * cos x); [ring|].
  replace (sin x * sin x) with (1 - cos x * cos x) by lra. ring.
Qed.

(* The eigenvalues of a unit deviator by its Lode angle. *)
Lemma lode_form l1 l2 l3 : l1 >= l2 -> l2 >= l3 -> l1 + l2 + l3 = 0 ->
  l1 * l1 + l2 * l2 + l3 * l3 = 1 -> exists phi, 0 <= phi <= PI / 3 /\
  cos phi = sqrt 6 / 2 * l1 /\ sin phi = sqrt 2 / 2 * (l2 - l3) /\
  3 * sqrt 6 * (l1 * l2 * l3) = cos (3 * phi).
Proof.
  intros A B S Q. assert (L3 : l3 = - l1 - l2) by lra. subst l3.
  assert (P : 0 <= l1) by lra.
  assert (Q' : l1 * l1 + l1 * l2 + l2 * l2 = / 2) by lra.
  assert (S6 := sqrt6). assert (S6p := sqrt6_positive).
  assert (S2 : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra).
  assert (S2p : 0 < sqrt 2) by (apply sqrt_lt_R0; lra).
  set (c := sqrt 6 / 2 * l1).
  assert (CC : c * c = 3 / 2 * (l1 * l1)) by (unfold c; transitivity (sqrt 6 * sqrt 6 / 4 * (l1 * l1)); [field|rewrite S6; field]).
  assert (C0 : 0 <= c) by (unfold c; apply Rmult_le_pos; lra).
  assert (Low : / 4 <= c * c) by (rewrite CC; nra).
  assert (High : c * c <= 1) by (rewrite CC; nra).
  assert (C1 : / 2 <= c) by nra. assert (C2 : c <= 1) by nra.
  set (phi := arc_cosine c).
  assert (Cp : cos phi = c) by (apply cos_arc_cosine; lra).
  assert (B1 := arc_cosine_bound c). fold phi in B1.
  assert (Pi := PI_RGT_0).
  assert (Top : phi <= PI / 3).
  { apply Rnot_lt_le. intros H. assert (K := cos_decreasing_1 (PI / 3) phi ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) H).
    rewrite Cp, cos_PI3 in K. lra. }
  exists phi. split; [lra|]. split; [exact Cp|].
  assert (Sp : 0 <= sin phi) by (apply sin_ge_0; lra).
  assert (SS : sin phi * sin phi = 1 - c * c).
  { assert (H := sin2_cos2 phi). unfold Rsqr in H. rewrite Cp in H. lra. }
  split.
  - set (d := sqrt 2 / 2 * (l2 - (- l1 - l2))).
    assert (D0 : 0 <= d) by (unfold d; apply Rmult_le_pos; lra).
    assert (DD : d * d = 1 - c * c).
    { rewrite CC. unfold d. transitivity (sqrt 2 * sqrt 2 / 4 * ((l1 + 2 * l2) * (l1 + 2 * l2))); [field|].
      rewrite S2. nra. }
    nra.
  - rewrite cos_triple, Cp. unfold c.
    transitivity (3 * sqrt 6 * (l1 * (l1 * l1 - / 2))).
    + f_equal. rewrite <- Q'. ring.
    + transitivity ((sqrt 6 * sqrt 6) * sqrt 6 / 2 * (l1 * l1 * l1) - 3 / 2 * sqrt 6 * l1);
        [rewrite S6; field|field].
Qed.

(* Every nonzero deviator is its norm times a unit one with ordered eigenvalues. *)
Lemma unit_form t : t <> zero -> trace t = 0 -> exists l1 l2 l3 u v w phi,
  l1 >= l2 /\ l2 >= l3 /\ l1 + l2 + l3 = 0 /\ orthonormal u v w /\
  t = scale (norm t) (spectral l1 l2 l3 u v w) /\ 0 <= phi <= PI / 3 /\
  cos phi = sqrt 6 / 2 * l1 /\ sin phi = sqrt 2 / 2 * (l2 - l3) /\ lode t = phi.
Proof.
  intros N T. destruct (spectral_theorem t) as [a [b [c [u [v [w [A [B [O E]]]]]]]]].
  assert (P := norm_positive t N). assert (NS := norm_squared t).
  set (n := norm t) in *.
  assert (I : forall x, n * (x / n) = x) by (intros; field; lra).
  assert (Ge : forall x y, x >= y -> x / n >= y / n).
  { intros x y H. apply Rle_ge. unfold Rdiv. apply Rmult_le_compat_r; [left; apply Rinv_0_lt_compat; exact P|lra]. }
  assert (S : a / n + b / n + c / n = 0).
  { assert (H : a + b + c = 0) by (rewrite <- T, E; symmetry; apply trace_spectral, O).
    transitivity ((a + b + c) / n); [field; lra|rewrite H; field; lra]. }
  assert (Q : (a / n) * (a / n) + (b / n) * (b / n) + (c / n) * (c / n) = 1).
  { assert (H : n * n = a * a + b * b + c * c) by (rewrite NS, E at 1; apply norm2_spectral, O).
    transitivity ((a * a + b * b + c * c) / (n * n)); [field; lra|rewrite <- H; field; lra]. }
  destruct (lode_form (a / n) (b / n) (c / n) (Ge _ _ A) (Ge _ _ B) S Q) as [phi [R [C [D M]]]].
  assert (F : t = scale n (spectral (a / n) (b / n) (c / n) u v w)).
  { rewrite scale_spectral, !I. exact E. }
  exists (a / n), (b / n), (c / n), u, v, w, phi.
  split; [auto|split; [auto|split; [exact S|split; [exact O|split; [exact F|]]]]].
  split; [exact R|split; [exact C|split; [exact D|]]].
  unfold lode. assert (Mo : mode t = cos (3 * phi)).
  { rewrite <- M, F. rewrite mode_scale by exact P. unfold mode.
    assert (N1 : norm (spectral (a / n) (b / n) (c / n) u v w) = 1).
    { unfold norm. rewrite (norm2_spectral _ _ _ u v w O), Q. apply sqrt_1. }
    rewrite N1, (det_spectral _ _ _ u v w O). field. lra. }
  rewrite Mo, arc_cosine_cos by (assert (Pi := PI_RGT_0); lra). field.
Qed.

Theorem lode_screen a b : a <> zero -> b <> zero -> trace a = 0 -> trace b = 0 ->
  Rabs (lode a - lode b) <= angle a b.
Proof.
  intros A B Ta Tb.
  destruct (unit_form a A Ta) as [a1 [a2 [a3 [u [v [w [f [A1 [A2 [A3 [O [E [R [C [D L]]]]]]]]]]]]]]].
  destruct (unit_form b B Tb) as [b1 [b2 [b3 [u' [v' [w' [g [B1 [B2 [B3 [O' [E' [R' [C' [D' L']]]]]]]]]]]]]]].
  rewrite L, L'. unfold angle. assert (Na := norm_positive a A). assert (Nb := norm_positive b B).
  set (x := inner a b / (norm a * norm b)).
  assert (X : x <= cos (f - g)).
  { assert (T := trace_inequality a1 a2 a3 u v w b1 b2 b3 u' v' w' A1 A2 B1 B2 O O').
    assert (I : inner a b = norm a * (norm b * inner (spectral a1 a2 a3 u v w) (spectral b1 b2 b3 u' v' w'))).
    { rewrite E, E' at 1. rewrite inner_scale, inner_sym, inner_scale, inner_sym. reflexivity. }
    unfold x. rewrite I.
    replace (_ / _) with (inner (spectral a1 a2 a3 u v w) (spectral b1 b2 b3 u' v' w')) by (field; lra).
    apply Rle_trans with (1 := T). right. rewrite cos_minus, C, C', D, D'.
    assert (S6 := sqrt6). assert (S2 : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra).
    transitivity (sqrt 6 * sqrt 6 / 4 * (a1 * b1) + sqrt 2 * sqrt 2 / 4 * ((a2 - a3) * (b2 - b3)));
      [|field]. rewrite S6, S2. replace a3 with (- a1 - a2) by lra. replace b3 with (- b1 - b2) by lra. field. }
  assert (Range : -1 <= x <= 1).
  { assert (Ca := cauchy a b). assert (Sa := norm_squared a). assert (Sb := norm_squared b).
    assert (K : inner a b = x * (norm a * norm b)) by (unfold x; field; lra).
    rewrite <- Sa, <- Sb, K in Ca. assert (P : 0 < norm a * norm b) by (apply Rmult_lt_0_compat; assumption).
    set (n := norm a * norm b) in *.
    assert (H : 0 <= (1 - x * x) * (n * n)) by (unfold n in *; lra).
    assert (n * n > 0) by (apply square_pos; lra).
    assert (x * x <= 1) by (apply Rnot_lt_le; intros W; assert (0 < (x * x - 1) * (n * n)) by (apply Rmult_lt_0_compat; lra); lra).
    split; nra. }
  assert (Pi := PI_RGT_0). assert (Bx := arc_cosine_bound x).
  apply Rnot_lt_le. intros H.
  assert (G : 0 <= Rabs (f - g) <= PI) by (split; [apply Rabs_pos|apply Rabs_le; lra]).
  assert (K := cos_decreasing_1 (arc_cosine x) (Rabs (f - g)) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) H).
  rewrite cos_arc_cosine in K by exact Range.
  assert (W : cos (Rabs (f - g)) = cos (f - g)).
  { unfold Rabs. destruct (Rcase_abs (f - g)); [apply cos_neg|reflexivity]. }
  rewrite W in K. lra.
Qed.

Lemma deviator_add s t : deviator (add s t) = add (deviator s) (deviator t).
Proof. destruct s, t. unfold deviator, sub, add, scale, identity, trace. cbn. apply tensor_eq; cbn; field. Qed.
Lemma norm2_deviator t : norm2 (deviator t) = norm2 t - trace t * trace t / 3.
Proof. destruct t. unfold norm2, inner, deviator, sub, add, scale, identity, trace. cbn. field. Qed.

(* A change e of a tensor turns its deviator by at most arcsin(|e| / |deviator|). *)
Theorem stability t e : norm e < norm (deviator t) ->
  Rabs (lode (deviator (add t e)) - lode (deviator t)) <= arc_sine (norm e / norm (deviator t)).
Proof.
  intros H. set (a := deviator t) in *. set (d := deviator e).
  assert (S : deviator (add t e) = add a d) by apply deviator_add.
  assert (D : norm2 d <= norm2 e).
  { assert (Q := square_nonneg (trace e)). assert (N := norm2_deviator e). fold d in N. lra. }
  assert (Na : 0 < norm a) by (assert (Q := norm_nonneg e); lra).
  assert (Sa := norm_squared a). assert (Se := norm_squared e). assert (Ne := norm_nonneg e).
  assert (A : a <> zero).
  { intros Z. rewrite Z in Na. unfold norm, norm2, inner, zero in Na. cbn in Na.
    replace (_ + _) with 0 in Na by ring. rewrite sqrt_0 in Na. lra. }
  assert (Ea : norm2 e < norm2 a) by (rewrite <- Sa, <- Se; nra).
  (* <a, a + d> is at least sqrt(|a|^2 - |d|^2) |a + d|. *)
  set (x := inner a a + inner a d). assert (X1 : inner (add a d) a = x) by (rewrite inner_add, (inner_sym d a); reflexivity).
  assert (X2 : norm2 (add a d) = norm2 a + 2 * inner a d + norm2 d) by (clear; coordinates; ring).
  assert (C := cauchy a d).
  set (p := norm2 a) in *. set (q := norm2 d) in *. set (i := inner a d) in *.
  assert (Q0 : 0 <= q) by apply norm2_nonneg.
  assert (Xp : 0 < x).
  { unfold x. change (inner a a) with p. apply Rnot_le_lt. intros W. nra. }
  assert (Z : add a d <> zero).
  { intros Z. rewrite Z in X1. unfold inner, zero in X1. cbn in X1. lra. }
  rewrite S. apply Rle_trans with (angle (add a d) a).
  - apply lode_screen; auto; [rewrite trace_add; unfold a, d; rewrite !trace_deviator; ring|apply trace_deviator].
  - unfold angle. rewrite X1. assert (Nb := norm_positive _ Z). assert (Sb := norm_squared (add a d)).
    set (nb := norm (add a d)) in *. set (na := norm a) in *. set (ne := norm e) in *.
    set (r := ne / na). assert (R : 0 <= r < 1).
    { unfold r. split; [apply Rmult_le_pos; [exact Ne|left; apply Rinv_0_lt_compat; exact Na]|].
      apply (Rmult_lt_reg_r na); [exact Na|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra. }
    set (y := x / (nb * na)). assert (Pn : 0 < nb * na) by (apply Rmult_lt_0_compat; assumption).
    assert (Yp : 0 < y) by (apply Rdiv_lt_0_compat; assumption).
    assert (YE : y * y * ((nb * nb) * (na * na)) = x * x) by (unfold y; field; lra).
    assert (RE : r * r * (na * na) = ne * ne) by (unfold r; field; lra).
    assert (Main : 1 - r * r <= y * y).
    { apply Rnot_lt_le. intros W.
      assert (M : y * y * ((nb * nb) * (na * na)) < (1 - r * r) * ((nb * nb) * (na * na))).
      { apply Rmult_lt_compat_r; [repeat apply Rmult_lt_0_compat; assumption|exact W]. }
      rewrite YE in M.
      assert (M2 : (1 - r * r) * ((nb * nb) * (na * na)) = (na * na - ne * ne) * (nb * nb)) by (rewrite <- RE; ring).
      rewrite M2, Sa, Se, Sb, X2 in M. unfold x in M. change (inner a a) with p in M.
      (* (p + i)^2 - (p - q)(p + 2 i + q) = (i + q)^2, and |e| is at least |d| *)
      assert (0 <= (i + q) * (i + q)) by apply square_nonneg.
      assert (0 <= (norm2 e - q) * (p + 2 * i + q)) by (apply Rmult_le_pos; [lra|rewrite <- X2; apply norm2_nonneg]).
      lra. }
    assert (Y1 : y <= 1).
    { apply Rnot_lt_le. intros W. assert (Ca := cauchy (add a d) a). rewrite X1 in Ca.
      fold p in Ca. rewrite <- Sa, <- Sb in Ca. rewrite <- YE in Ca.
      assert (0 < (nb * nb) * (na * na)) by (repeat apply Rmult_lt_0_compat; assumption).
      assert (0 < (y * y - 1) * ((nb * nb) * (na * na))) by (apply Rmult_lt_0_compat; nra). lra. }
    assert (Pi := PI_RGT_0). assert (By := arc_cosine_bound y). assert (Br := arc_sine_bound r).
    apply Rnot_lt_le. intros W.
    assert (Ar : 0 <= arc_sine r).
    { apply Rnot_lt_le. intros G. assert (K := sin_lt_0_var (arc_sine r) ltac:(lra) G).
      rewrite sin_arc_sine in K by lra. lra. }
    assert (K := cos_decreasing_1 (arc_sine r) (arc_cosine y) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) W).
    rewrite cos_arc_cosine, cos_arc_sine in K by lra.
    assert (T : sqrt (1 - r * r) * sqrt (1 - r * r) = 1 - r * r) by (rewrite sqrt_sqrt; nra).
    assert (T0 := sqrt_pos (1 - r * r)). nra.
Qed.
