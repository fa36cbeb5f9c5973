(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   If a plane has two neutral extrema then the whole line through them is critical and neutral, so
   they are not isolated. At a neutral extremum s the determinant on a line through s begins with the
   quadratic form v -> tr(v^2 s), which therefore does not change its sign. It is zero at the other
   extremum t, as t is critical; so t is in its kernel: tr((t u + u t) s) = 0 for all u of the plane. *)
From TensorTopo Require Import Tensors Mode Dual Saddle NoIsolatedExtremum ComplementPencil ExtremaOfPlane.
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

Lemma det_linear_traceless t u : trace t = 0 -> trace u = 0 -> det_linear t u = inner (square t) u.
Proof.
  intros T U. unfold det_linear. rewrite inner_sym, !inner_add, !inner_scale, T.
  replace (inner identity u) with (trace u) by (unfold inner, identity, trace; cbn; ring). rewrite U. ring.
Qed.

Lemma det_traceless_line s v x : trace s = 0 -> trace v = 0 -> det (add s (scale x v)) =
  det s + inner (square s) v * x + inner (square v) s * (x * x) + det v * (x * x * x).
Proof. intros S V. rewrite det_line, !det_linear_traceless by assumption. ring. Qed.

Lemma det_sign t : (mode t <= 0 -> det t <= 0) /\ (0 <= mode t -> 0 <= det t).
Proof.
  destruct (Req_dec (norm2 t) 0) as [Z|Z].
  - rewrite (norm2_zero t Z). assert (D : det zero = 0) by (unfold det, zero; cbn; ring). rewrite D. split; intros; lra.
  - assert (N : t <> zero) by (intros H; apply Z; rewrite H; unfold norm2, inner, zero; cbn; ring).
    destruct (mode_det t N) as [k [K E]]. rewrite E. split; intros H.
    + assert (0 <= - det t); [|lra]. apply (nonneg_factor k); lra.
    + apply (nonneg_factor k); lra.
Qed.

(* tr((a b + b a) c). *)
Definition mixed a b c := inner (sub (square (add a b)) (add (square a) (square b))) c.
Lemma mixed_turned a b c : mixed a b c = mixed b c a.
Proof. unfold mixed, inner, sub, square, add, scale; cbn. ring. Qed.
Lemma square_combination a b x y c : inner (square (add (scale x a) (scale y b))) c =
  inner (square a) c * (x * x) + mixed a b c * (x * y) + inner (square b) c * (y * y).
Proof. unfold mixed, inner, sub, square, add, scale; cbn. ring. Qed.

Lemma in_plane_combination n1 n2 a b x y : in_plane n1 n2 a -> in_plane n1 n2 b ->
  in_plane n1 n2 (add (scale x a) (scale y b)).
Proof.
  intros [A1 [A2 A3]] [B1 [B2 B3]]. unfold in_plane.
  rewrite trace_add, !trace_scale, A3, B3, !(inner_sym _ (add _ _)), !inner_add, !inner_scale.
  rewrite !(inner_sym _ n1), !(inner_sym _ n2), A1, A2, B1, B2. repeat split; ring.
Qed.

Lemma neutral_critical n1 n2 s u : s <> zero -> in_plane n1 n2 s -> in_plane n1 n2 u -> det s = 0 ->
  critical_in_plane n1 n2 s -> inner (square s) u = 0.
Proof.
  intros Z S U D C. destruct (mode_directional s u Z (proj2 (proj2 S)) (proj2 (proj2 U))) as [k [K L]].
  assert (E := uniqueness_limite _ _ _ _ L (C u U)). assert (P := norm2_positive s Z).
  assert (H : inner (dual s) u = norm2 s * inner (square s) u).
  { unfold dual. rewrite !inner_add, !inner_scale, D.
    replace (inner identity u) with (trace u) by (unfold inner, identity, trace; cbn; ring).
    rewrite (proj2 (proj2 U)). ring. }
  rewrite H in E. destruct (Rmult_integral _ _ E) as [|E']; [lra|]. destruct (Rmult_integral _ _ E'); [lra|assumption].
Qed.

(* The sign of the determinant near a neutral extremum, and so of the quadratic form. *)
Lemma neutral_extremum n1 n2 s : s <> zero -> in_plane n1 n2 s -> det s = 0 ->
  local_extremum (in_plane n1 n2) s ->
  exists o, o <> 0 /\ forall v, in_plane n1 n2 v -> 0 <= o * inner (square v) s.
Proof.
  intros Z S D X. assert (C := extremum_is_critical n1 n2 s Z (proj2 (proj2 S)) X).
  assert (M : mode s = 0) by (destruct (mode_det s Z) as [k [_ E]]; rewrite E, D; ring).
  assert (Near : exists o, o <> 0 /\ forall v, in_plane n1 n2 v -> exists eps, 0 < eps /\
    forall x, Rabs x < eps -> 0 <= o * det (add s (scale x v))).
  { destruct X as [X|X]; [exists (-1)|exists 1]; (split; [lra|]); intros v V; destruct (X v V) as [eps [P Q]];
      exists eps; (split; [exact P|]); intros x Hx; assert (W := Q x Hx); rewrite M in W; apply det_sign in W; lra. }
  destruct Near as [o [Oz Near]]. exists o. split; [exact Oz|]. intros v V. destruct (Near v V) as [eps [P Q]].
  apply Rnot_lt_le. intros L. set (c := o * inner (square v) s) in *. set (d := o * det v).
  assert (A := Rabs_pos d). set (h := - c / (2 * (Rabs d + 1))).
  assert (Hp : 0 < h) by (unfold h; apply Rdiv_lt_0_compat; lra).
  assert (He : h * (Rabs d + 1) = - c / 2) by (unfold h; field; lra).
  set (x := Rmin h (eps / 2)). assert (Xp : 0 < x) by (apply Rmin_glb_lt; lra).
  assert (X1 : x <= h) by apply Rmin_l. assert (X2 : x <= eps / 2) by apply Rmin_r.
  assert (W := Q x ltac:(rewrite Rabs_pos_eq; lra)).
  rewrite (det_traceless_line s v x (proj2 (proj2 S)) (proj2 (proj2 V))), D, (neutral_critical n1 n2 s v Z S V D C) in W.
  assert (E : o * (0 + 0 * x + inner (square v) s * (x * x) + det v * (x * x * x)) = x * x * (c + x * d)) by (unfold c, d; ring).
  rewrite E in W. assert (XX : 0 < x * x) by (apply Rmult_lt_0_compat; lra). apply (nonneg_factor _ _ XX) in W.
  assert (Y : x * d <= x * Rabs d) by (apply Rmult_le_compat_l; [lra|apply Rle_abs]).
  assert (Y' : x * (Rabs d + 1) <= h * (Rabs d + 1)) by (apply Rmult_le_compat_r; lra). lra.
Qed.

Theorem two_neutral_extrema n1 n2 s t x y :
  s <> zero -> in_plane n1 n2 s -> det s = 0 -> local_extremum (in_plane n1 n2) s ->
  t <> zero -> in_plane n1 n2 t -> det t = 0 -> local_extremum (in_plane n1 n2) t ->
  let r := add (scale x s) (scale y t) in
  det r = 0 /\ (r <> zero -> critical_in_plane n1 n2 r).
Proof.
  intros Zs Is Ds Xs Zt It Dt Xt r.
  assert (Cs := extremum_is_critical n1 n2 s Zs (proj2 (proj2 Is)) Xs).
  assert (Ct := extremum_is_critical n1 n2 t Zt (proj2 (proj2 It)) Xt).
  assert (Ir : in_plane n1 n2 r) by (apply in_plane_combination; assumption).
  assert (Dr : det r = 0).
  { unfold r. rewrite det_traceless_line; [|rewrite trace_scale, (proj2 (proj2 Is)); ring|apply It].
    assert (E1 := neutral_critical n1 n2 s t Zs Is It Ds Cs). assert (E2 := neutral_critical n1 n2 t s Zt It Is Dt Ct).
    assert (F1 : inner (square (scale x s)) t = x * x * inner (square s) t) by (unfold inner, square, scale; cbn; ring).
    rewrite (inner_sym (square t)), inner_scale, (inner_sym s), F1, E1, E2, det_scale, Ds, Dt. ring. }
  split; [exact Dr|]. intros Zr u U.
  assert (K : mixed t u s = 0).
  { destruct (neutral_extremum n1 n2 s Zs Is Ds Xs) as [o [Oz Q]].
    assert (W := semidefinite (inner (square t) s) (mixed t u s / 2) (inner (square u) s) o Oz).
    rewrite (neutral_critical n1 n2 t s Zt It Is Dt Ct) in W.
    assert (V : mixed t u s / 2 * (mixed t u s / 2) <= 0 * inner (square u) s).
    { apply W. intros a b. assert (H := Q _ (in_plane_combination n1 n2 t u a b It U)).
      rewrite square_combination, (neutral_critical n1 n2 t s Zt It Is Dt Ct) in H.
      apply (Rle_trans _ _ _ H). right. field. }
    assert (N := square_nonneg (mixed t u s / 2)). assert (H : mixed t u s / 2 = 0) by (apply square_zero; lra). lra. }
  destruct (mode_directional r u Zr (proj2 (proj2 Ir)) (proj2 (proj2 U))) as [k [_ L]].
  assert (H : inner (dual r) u = 0).
  { unfold dual. rewrite !inner_add, !inner_scale, Dr.
    replace (inner identity u) with (trace u) by (unfold inner, identity, trace; cbn; ring).
    assert (E : inner (square r) u = 0).
    { unfold r. rewrite square_combination, (mixed_turned s t u), K.
      rewrite (neutral_critical n1 n2 s u Zs Is U Ds Cs), (neutral_critical n1 n2 t u Zt It U Dt Ct). ring. }
    rewrite E, (proj2 (proj2 U)). ring. }
  rewrite H, Rmult_0_r in L. exact L.
Qed.
