(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   Vectors of three real numbers, symmetric 3x3 tensors as six real numbers, and their invariants.
   Identities between them are identities of polynomials in the numbers: [coordinates] exposes
   these, and [ring] decides. *)
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

Record vector := Vector { vx : R; vy : R; vz : R }.
Record tensor := Tensor { xx : R; yy : R; zz : R; xy : R; yz : R; xz : R }.

Definition zero_vector := Vector 0 0 0.
Definition add_vectors a b := Vector (vx a + vx b) (vy a + vy b) (vz a + vz b).
Definition scale_vector k a := Vector (k * vx a) (k * vy a) (k * vz a).
Definition dot a b := vx a * vx b + vy a * vy b + vz a * vz b.
Definition cross a b :=
  Vector (vy a * vz b - vz a * vy b) (vz a * vx b - vx a * vz b) (vx a * vy b - vy a * vx b).
Definition volume a b c := dot a (cross b c).

Definition zero := Tensor 0 0 0 0 0 0.
Definition identity := Tensor 1 1 1 0 0 0.
Definition add a b :=
  Tensor (xx a + xx b) (yy a + yy b) (zz a + zz b) (xy a + xy b) (yz a + yz b) (xz a + xz b).
Definition scale k a :=
  Tensor (k * xx a) (k * yy a) (k * zz a) (k * xy a) (k * yz a) (k * xz a).
Definition sub a b := add a (scale (-1) b).

(* The invariants: trace, inner product tr(A B), squared norm, determinant. *)
Definition trace a := xx a + yy a + zz a.
Definition inner a b :=
  xx a * xx b + yy a * yy b + zz a * zz b + 2 * (xy a * xy b + yz a * yz b + xz a * xz b).
Definition norm2 a := inner a a.
Definition norm a := sqrt (norm2 a).
Definition det a :=
  xx a * (yy a * zz a - yz a * yz a) - xy a * (xy a * zz a - yz a * xz a)
  + xz a * (xy a * yz a - yy a * xz a).

(* T v, and the bilinear form u.T v. *)
Definition apply t v :=
  Vector (xx t * vx v + xy t * vy v + xz t * vz v)
         (xy t * vx v + yy t * vy v + yz t * vz v)
         (xz t * vx v + yz t * vy v + zz t * vz v).
Definition form t u v := dot u (apply t v).

(* T^2, the deviator, and the dyads v v^T and u v^T + v u^T. *)
Definition square t :=
  Tensor (xx t * xx t + xy t * xy t + xz t * xz t) (xy t * xy t + yy t * yy t + yz t * yz t)
         (xz t * xz t + yz t * yz t + zz t * zz t) (xx t * xy t + xy t * yy t + xz t * yz t)
         (xy t * xz t + yy t * yz t + yz t * zz t) (xx t * xz t + xy t * yz t + xz t * zz t).
Definition deviator t := sub t (scale (trace t / 3) identity).
Definition dyad v :=
  Tensor (vx v * vx v) (vy v * vy v) (vz v * vz v) (vx v * vy v) (vy v * vz v) (vx v * vz v).
Definition sym_dyad u v :=
  Tensor (2 * (vx u * vx v)) (2 * (vy u * vy v)) (2 * (vz u * vz v))
         (vx u * vy v + vy u * vx v) (vy u * vz v + vz u * vy v) (vx u * vz v + vz u * vx v).

Ltac coordinates :=
  repeat match goal with t : tensor |- _ => destruct t | v : vector |- _ => destruct v end;
  unfold volume, norm2, deviator, sub, form, trace, inner, det, apply, square, dyad, sym_dyad,
    add, scale, identity, zero, dot, cross, add_vectors, scale_vector, zero_vector in *;
  cbn [xx yy zz xy yz xz vx vy vz] in *.

(* Equality of tensors and vectors, number by number. *)
Lemma tensor_eq a b : xx a = xx b -> yy a = yy b -> zz a = zz b ->
  xy a = xy b -> yz a = yz b -> xz a = xz b -> a = b.
Proof. destruct a, b; cbn; intros; subst; reflexivity. Qed.
Lemma vector_eq a b : vx a = vx b -> vy a = vy b -> vz a = vz b -> a = b.
Proof. destruct a, b; cbn; intros; subst; reflexivity. Qed.
(* What is assumed is of no use to ring, and coordinates would unfold it. *)
Ltac without_assumptions :=
  repeat match goal with H : ?P |- _ => match type of P with Prop => clear H end end.
Ltac tensor_ring := without_assumptions; coordinates; apply tensor_eq; cbn [xx yy zz xy yz xz]; ring.
Ltac vector_ring := without_assumptions; coordinates; apply vector_eq; cbn [vx vy vz]; ring.

Lemma square_pos x : x <> 0 -> 0 < x * x.
Proof. intros H. exact (Rsqr_pos_lt x H). Qed.
Lemma square_nonneg x : 0 <= x * x.
Proof. exact (Rle_0_sqr x). Qed.
Lemma nonneg_factor k x : 0 < k -> 0 <= k * x -> 0 <= x.
Proof. intros K H. apply (Rmult_le_reg_l k); [exact K|]. rewrite Rmult_0_r. exact H. Qed.
Lemma square_zero x : x * x = 0 -> x = 0.
Proof. intros H. destruct (Rmult_integral _ _ H); assumption. Qed.

Lemma dot_nonneg a : 0 <= dot a a.
Proof.
  unfold dot. assert (A := square_nonneg (vx a)). assert (B := square_nonneg (vy a)).
  assert (C := square_nonneg (vz a)). lra.
Qed.
Lemma dot_zero a : dot a a = 0 -> a = zero_vector.
Proof.
  unfold dot. intros H. assert (A := square_nonneg (vx a)). assert (B := square_nonneg (vy a)).
  assert (C := square_nonneg (vz a)). apply vector_eq; cbn; apply square_zero; lra.
Qed.
Lemma dot_positive a : a <> zero_vector -> 0 < dot a a.
Proof.
  intros H. assert (N := dot_nonneg a).
  destruct (Req_dec (dot a a) 0) as [Z|Z]; [destruct (H (dot_zero a Z))|lra].
Qed.

Lemma norm2_nonneg t : 0 <= norm2 t.
Proof.
  coordinates. assert (H := fun x => square_nonneg x).
  assert (A := H xx0). assert (B := H yy0). assert (C := H zz0). assert (D := H xy0).
  assert (E := H yz0). assert (F := H xz0). lra.
Qed.
Lemma norm2_zero t : norm2 t = 0 -> t = zero.
Proof.
  intros Z. coordinates. assert (H := fun x => square_nonneg x).
  assert (A := H xx0). assert (B := H yy0). assert (C := H zz0). assert (D := H xy0).
  assert (E := H yz0). assert (F := H xz0).
  apply tensor_eq; cbn; apply square_zero; lra.
Qed.
Lemma norm2_positive t : t <> zero -> 0 < norm2 t.
Proof.
  intros H. assert (N := norm2_nonneg t).
  destruct (Req_dec (norm2 t) 0) as [Z|Z]; [destruct (H (norm2_zero t Z))|lra].
Qed.
Lemma norm_nonneg t : 0 <= norm t.
Proof. apply sqrt_pos. Qed.
Lemma norm_squared t : norm t * norm t = norm2 t.
Proof. apply sqrt_sqrt, norm2_nonneg. Qed.
Lemma norm_positive t : t <> zero -> 0 < norm t.
Proof. intros H. apply sqrt_lt_R0, norm2_positive, H. Qed.

(* The inner product is bilinear and symmetric. *)
Lemma inner_sym a b : inner a b = inner b a.
Proof. unfold inner; ring. Qed.
Lemma inner_add a b c : inner (add a b) c = inner a c + inner b c.
Proof. unfold inner, add; cbn; ring. Qed.
Lemma inner_scale k a b : inner (scale k a) b = k * inner a b.
Proof. unfold inner, scale; cbn; ring. Qed.
Lemma norm2_scale k a : norm2 (scale k a) = k * k * norm2 a.
Proof. unfold norm2, inner, scale; cbn; ring. Qed.
Lemma det_scale k a : det (scale k a) = k * k * k * det a.
Proof. unfold det, scale; cbn; ring. Qed.
Lemma trace_scale k a : trace (scale k a) = k * trace a.
Proof. unfold trace, scale; cbn; ring. Qed.
Lemma trace_add a b : trace (add a b) = trace a + trace b.
Proof. unfold trace, add; cbn; ring. Qed.
Lemma trace_deviator a : trace (deviator a) = 0.
Proof. unfold trace, deviator, sub, scale, add, identity, trace; cbn; field. Qed.
Lemma scale_one a : scale 1 a = a.
Proof. tensor_ring. Qed.
Lemma scale_scale k l a : scale k (scale l a) = scale (k * l) a.
Proof. tensor_ring. Qed.

(* Cauchy's inequality, from the square of |b|^2 a - <a, b> b. *)
Lemma cauchy a b : inner a b * inner a b <= norm2 a * norm2 b.
Proof.
  destruct (Req_dec (norm2 b) 0) as [Z|Z].
  - apply norm2_zero in Z. subst. replace (inner a zero) with 0 by (unfold inner, zero; cbn; ring).
    assert (0 <= norm2 a * norm2 zero) by (apply Rmult_le_pos; apply norm2_nonneg). lra.
  - assert (P : 0 < norm2 b) by (assert (N := norm2_nonneg b); lra).
    assert (S := norm2_nonneg (sub (scale (norm2 b) a) (scale (inner a b) b))).
    assert (E : norm2 (sub (scale (norm2 b) a) (scale (inner a b) b))
      = norm2 b * (norm2 a * norm2 b - inner a b * inner a b)).
    { clear. coordinates; ring. }
    rewrite E in S.
    destruct (Rle_or_lt (inner a b * inner a b) (norm2 a * norm2 b)) as [H|H]; [exact H|].
    assert (0 < norm2 b * (inner a b * inner a b - norm2 a * norm2 b))
      by (apply Rmult_lt_0_compat; lra). lra.
Qed.
