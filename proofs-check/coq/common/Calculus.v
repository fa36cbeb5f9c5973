(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   What is needed of real analysis, without excluded middle: the library's mean value theorem and
   its arc cosine use it. A function with a positive derivative increases, by the least upper bound
   of where it has not yet fallen below its first value. The arc cosine is the number between 0 and
   pi that the intermediate value theorem finds. *)
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

Lemma continuous_near f m eps : continuity_pt f m -> 0 < eps ->
  exists delta, 0 < delta /\ forall x, Rabs (x - m) < delta -> Rabs (f x - f m) < eps.
Proof.
  intros C E. destruct (C eps E) as [d [D K]]. exists d. split; [exact D|]. intros x X.
  destruct (Req_dec x m) as [Z|Z]; [rewrite Z, Rminus_diag_eq, Rabs_R0 by reflexivity; exact E|].
  apply (K x). split; [split; [exact I|auto]|exact X].
Qed.

(* Close to a place of positive derivative, f is smaller before it and larger after it. *)
Lemma rises_at f l m : derivable_pt_lim f m l -> 0 < l -> exists delta, 0 < delta /\
  forall x, Rabs (x - m) < delta -> 0 <= (f x - f m) * (x - m).
Proof.
  intros D L. destruct (D l L) as [[d Dp] K]. exists d. split; [exact Dp|]. intros x X.
  destruct (Req_dec x m) as [Z|Z]; [subst; lra|].
  assert (H := K (x - m) ltac:(lra) X). replace (m + (x - m)) with x in H by ring.
  apply Rabs_def2 in H. assert (Q : 0 < (f x - f m) / (x - m)) by lra.
  assert (E : (f x - f m) * (x - m) = (f x - f m) / (x - m) * ((x - m) * (x - m))) by (field; lra).
  rewrite E. apply Rmult_le_pos; [lra|]. exact (Rle_0_sqr (x - m)).
Qed.

Lemma not_below_first f df a b : a < b -> (forall c, a <= c <= b -> derivable_pt_lim f c (df c)) ->
  (forall c, a <= c <= b -> 0 < df c) -> f a <= f b.
Proof.
  intros L D P. set (E := fun x => a <= x <= b /\ forall y, a <= y <= x -> f a <= f y).
  assert (Ea : E a) by (split; [lra|intros y Y; replace y with a by lra; lra]).
  destruct (completeness E) as [m [Up Least]]; [exists b; intros x [X _]; lra|exists a; exact Ea|].
  assert (Am : a <= m) by (apply Up, Ea).
  assert (Mb : m <= b) by (apply Least; intros x [X _]; lra).
  assert (Before : forall y, a <= y < m -> f a <= f y).
  { intros y Y. apply Rnot_lt_le. intros H. assert (m <= y); [|lra]. apply Least. intros x [X Q].
    apply Rnot_lt_le. intros K. assert (W := Q y ltac:(lra)). lra. }
  destruct (rises_at f (df m) m (D m ltac:(lra)) (P m ltac:(lra))) as [d [Dp K]].
  assert (At : f a <= f m).
  { destruct Am as [Am|Am]; [|subst; lra]. set (x := Rmax a (m - d / 2)).
    assert (X : a <= x < m) by (unfold x; split; [apply Rmax_l|apply Rmax_lub_lt; lra]).
    assert (X2 := Rmax_r a (m - d / 2)). fold x in X2.
    assert (Q := K x ltac:(apply Rabs_def1; lra)). assert (W := Before x X). nra. }
  destruct Mb as [Mb|Mb]; [exfalso|subst; exact At].
  set (x := Rmin b (m + d / 2)). assert (X : m < x) by (unfold x; apply Rmin_glb_lt; lra).
  assert (X1 := Rmin_l b (m + d / 2)). assert (X2 := Rmin_r b (m + d / 2)). fold x in X1, X2.
  assert (Ex : E x).
  { split; [lra|]. intros y Y. destruct (Rlt_dec y m) as [H|H]; [apply Before; lra|].
    assert (Q := K y ltac:(apply Rabs_def1; lra)). destruct (Req_dec y m) as [Z|Z]; [subst; exact At|nra]. }
  assert (W := Up x Ex). lra.
Qed.

Lemma not_negative_derivative f df a b : a <= b ->
  (forall c, a <= c <= b -> derivable_pt_lim f c (df c)) ->
  (forall c, a <= c <= b -> 0 <= df c) -> f a <= f b.
Proof.
  intros L D P. destruct L as [L|L]; [|subst; lra]. apply Rnot_lt_le. intros H.
  set (e := (f a - f b) / (2 * (b - a))). assert (Ep : 0 < e) by (apply Rdiv_lt_0_compat; lra).
  assert (Q := not_below_first (fun x => f x + e * x) (fun x => df x + e) a b L).
  assert (W : f a + e * a <= f b + e * b).
  { apply Q; intros c C; [|assert (X := P c C); lra].
    apply (derivable_pt_lim_plus f (fun x => e * x)); [apply D, C|].
    assert (S := derivable_pt_lim_scal id e c 1 (derivable_pt_lim_id c)).
    rewrite Rmult_1_r in S. exact S. }
  assert (X : e * (b - a) = (f a - f b) / 2) by (unfold e; field; lra). lra.
Qed.

Theorem derivative_increases f df a b : a < b ->
  (forall c, a <= c <= b -> derivable_pt_lim f c (df c)) ->
  (forall c, a <= c <= b -> 0 <= df c) -> (forall c, a < c <= b -> 0 < df c) -> f a < f b.
Proof.
  intros L D N P.
  assert (Strict : exists c, a < c < b /\ f c < f b).
  { destruct (D b ltac:(lra) (df b) (P b ltac:(lra))) as [[e Ep] Q].
    set (x := Rmax ((a + b) / 2) (b - e / 2)). exists x.
    assert (X : (a + b) / 2 <= x < b) by (unfold x; split; [apply Rmax_l|apply Rmax_lub_lt; lra]).
    assert (X2 := Rmax_r ((a + b) / 2) (b - e / 2)). fold x in X2. split; [lra|].
    assert (H := Q (x - b) ltac:(lra) ltac:(cbn; apply Rabs_def1; lra)).
    replace (b + (x - b)) with x in H by ring. apply Rabs_def2 in H.
    assert (Pos : 0 < (f x - f b) / (x - b)) by lra.
    assert (E : f x - f b = (f x - f b) / (x - b) * (x - b)) by (field; lra). nra. }
  destruct Strict as [c [C S]].
  assert (W : f a <= f c) by (apply (not_negative_derivative f df); [lra|intros; apply D; lra|intros; apply N; lra]).
  lra.
Qed.

(* The arc cosine and the arc sine; 0 outside of [-1, 1]. *)
Lemma angle_of_cosine c : -1 <= c <= 1 -> {x : R | 0 <= x <= PI /\ cos x - c = 0}.
Proof.
  intros C. apply (IVT_cor (fun x => cos x - c)).
  - apply continuity_minus; [apply continuity_cos|]. apply continuity_const. intros ? ?. reflexivity.
  - left. apply PI_RGT_0.
  - rewrite cos_0, cos_PI. assert (0 <= (1 - c) * (1 + c)) by (apply Rmult_le_pos; lra). lra.
Qed.
Definition arc_cosine c := match Rle_dec (-1) c with
  | left A => match Rle_dec c 1 with left B => proj1_sig (angle_of_cosine c (conj A B)) | right _ => 0 end
  | right _ => 0 end.
Definition arc_sine c := PI / 2 - arc_cosine c.

Lemma arc_cosine_bound c : 0 <= arc_cosine c <= PI.
Proof.
  assert (Pi := PI_RGT_0). unfold arc_cosine. destruct (Rle_dec (-1) c); [|lra].
  destruct (Rle_dec c 1); [|lra]. apply (proj2_sig (angle_of_cosine c _)).
Qed.
Lemma cos_arc_cosine c : -1 <= c <= 1 -> cos (arc_cosine c) = c.
Proof.
  intros C. unfold arc_cosine. destruct (Rle_dec (-1) c); [|lra]. destruct (Rle_dec c 1); [|lra].
  destruct (angle_of_cosine c _) as [x [X E]]. cbn. lra.
Qed.
Lemma cos_injective x y : 0 <= x <= PI -> 0 <= y <= PI -> cos x = cos y -> x = y.
Proof.
  intros X Y E. destruct (Rtotal_order x y) as [H|[H|H]]; [|exact H|].
  - assert (K := cos_decreasing_1 x y ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) H). lra.
  - assert (K := cos_decreasing_1 y x ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra) H). lra.
Qed.
Lemma arc_cosine_cos x : 0 <= x <= PI -> arc_cosine (cos x) = x.
Proof.
  intros X. apply cos_injective; [apply arc_cosine_bound|exact X|apply cos_arc_cosine, COS_bound].
Qed.
Lemma arc_sine_bound c : - (PI / 2) <= arc_sine c <= PI / 2.
Proof. assert (B := arc_cosine_bound c). unfold arc_sine. lra. Qed.
Lemma sin_arc_sine c : -1 <= c <= 1 -> sin (arc_sine c) = c.
Proof. intros C. unfold arc_sine. rewrite <- cos_shift. replace (_ - _) with (arc_cosine c) by ring. apply cos_arc_cosine, C. Qed.
Lemma cos_arc_sine c : -1 <= c <= 1 -> cos (arc_sine c) = sqrt (1 - c * c).
Proof.
  intros C. assert (B := arc_sine_bound c). assert (Pi := PI_RGT_0).
  assert (P : 0 <= cos (arc_sine c)) by (apply cos_ge_0; lra).
  assert (U := sin2_cos2 (arc_sine c)). unfold Rsqr in U. rewrite (sin_arc_sine c C) in U.
  replace (1 - c * c) with (cos (arc_sine c) * cos (arc_sine c)) by lra.
  symmetry. apply sqrt_square, P.
Qed.
