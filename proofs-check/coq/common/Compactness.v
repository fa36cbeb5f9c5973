(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   A bounded function on a bounded set of tensors comes close to its supremum near one place, in
   the closure of the set. Without sequences and choice: the least function above it of slope 1 is
   continuous everywhere, and attains its maximum on a box, coordinate by coordinate. *)
From TensorTopo Require Import Tensors.
Require Import Reals Psatz Ring Field List.
Import ListNotations.
Open Scope R_scope.

Definition slope_one (f : list R -> R) :=
  forall p x y q, f (p ++ x :: q) <= f (p ++ y :: q) + Rabs (x - y).
Definition in_box b n (l : list R) := length l = n /\ Forall (fun x => - b <= x <= b) l.

(* The first place up to which f is not away from its supremum. *)
Lemma maximum_on_interval f b : 0 <= b -> (forall x y, f x <= f y + Rabs (x - y)) ->
  exists m, - b <= m <= b /\ forall x, - b <= x <= b -> f x <= f m.
Proof.
  intros B L.
  destruct (completeness (fun v => exists x, - b <= x <= b /\ v = f x)) as [s [Us Ls]].
  { exists (f 0 + b). intros v [x [X E]]. assert (H := L x 0). assert (Rabs (x - 0) <= b) by (apply Rabs_le; lra). lra. }
  { exists (f 0), 0. split; [lra|reflexivity]. }
  assert (Up : forall x, - b <= x <= b -> f x <= s) by (intros x X; apply Us; eauto).
  destruct (Req_dec (f (- b)) s) as [F|F]; [exists (- b); split; [lra|intros x X; rewrite F; apply Up, X]|].
  set (E := fun x => - b <= x <= b /\ exists d, 0 < d /\ forall y, - b <= y <= x -> f y <= s - d).
  assert (E0 : E (- b)).
  { split; [lra|]. assert (H := Up (- b) ltac:(lra)). exists (s - f (- b)). split; [lra|].
    intros y Y. replace y with (- b) by lra. lra. }
  destruct (completeness E) as [m [Um Lm]]; [exists b; intros x [X _]; lra|exists (- b); exact E0|].
  assert (M1 : - b <= m) by (apply Um, E0). assert (M2 : m <= b) by (apply Lm; intros x [X _]; lra).
  exists m. split; [lra|]. assert (Fm : f m = s).
  { apply Rle_antisym; [apply Up; lra|]. apply Rnot_lt_le. intros H. set (e := (s - f m) / 2).
    assert (Ep : 0 < e) by (unfold e; lra).
    assert (Around : forall y, m - e <= y <= m + e -> f y <= s - e).
    { intros y Y. assert (K := L y m). assert (Rabs (y - m) <= e) by (apply Rabs_le; lra). unfold e in *. lra. }
    assert (K : m <= m - e); [|lra]. apply Lm. intros x [X [d [D Q]]]. apply Rnot_lt_le. intros Xm.
    set (d' := Rmin d e). assert (Dp : 0 < d') by (apply Rmin_glb_lt; assumption).
    assert (D1 := Rmin_l d e). assert (D2 := Rmin_r d e). fold d' in D1, D2.
    assert (All : forall y, - b <= y <= m + e -> f y <= s - d').
    { intros y Y. destruct (Rle_dec y x) as [W|W]; [assert (Z := Q y ltac:(lra)); lra|assert (Z := Around y ltac:(lra)); lra]. }
    destruct (Rle_dec b (m + e)) as [W|W].
    - assert (s <= s - d'); [|lra]. apply Ls. intros v [y [Y V]]. rewrite V. apply All. lra.
    - assert (Em : E (m + e)) by (split; [lra|exists d'; split; [exact Dp|exact All]]). assert (Z := Um _ Em). lra. }
  intros x X. rewrite Fm. apply Up, X.
Qed.

Theorem maximum_on_box b n : 0 <= b -> forall f, slope_one f ->
  exists m, in_box b n m /\ forall l, in_box b n l -> f l <= f m.
Proof.
  intros B. induction n as [|n IH]; intros f L.
  - exists []. split; [split; constructor|]. intros l [E _]. destruct l; [lra|discriminate].
  - assert (Bd : forall t, bound (fun v => exists x, - b <= x <= b /\ v = f (x :: t))).
    { intros t. exists (f (0 :: t) + b). intros v [x [X E]]. assert (H := L [] x 0 t). cbn in H.
      assert (Rabs (x - 0) <= b) by (apply Rabs_le; lra). lra. }
    assert (In : forall t, exists v, exists x, - b <= x <= b /\ v = f (x :: t)).
    { intros t. exists (f (0 :: t)), 0. split; [lra|reflexivity]. }
    set (g := fun t => proj1_sig (completeness _ (Bd t) (In t))).
    assert (Up : forall t x, - b <= x <= b -> f (x :: t) <= g t).
    { intros t x X. unfold g. destruct (completeness _ (Bd t) (In t)) as [v [U M]]. cbn. apply U. eauto. }
    assert (Least : forall t v, (forall x, - b <= x <= b -> f (x :: t) <= v) -> g t <= v).
    { intros t v H. unfold g. destruct (completeness _ (Bd t) (In t)) as [w [U M]]. cbn. apply M.
      intros z [x [X E]]. rewrite E. apply H, X. }
    destruct (IH g) as [t [T M]].
    { intros p x y q. apply Least. intros z Z. assert (H := L (z :: p) x y q). cbn in H.
      assert (K := Up (p ++ y :: q) z Z). lra. }
    destruct (maximum_on_interval (fun x => f (x :: t)) b B (fun x y => L [] x y t)) as [x [X N]].
    exists (x :: t). split; [split; [cbn; rewrite (proj1 T); reflexivity|constructor; [exact X|apply T]]|].
    intros l [E F]. destruct l as [|z l]; [discriminate|]. inversion F as [|? ? Z F']. subst.
    apply Rle_trans with (g l); [apply Up, Z|].
    apply Rle_trans with (g t); [apply M; split; [cbn in E; injection E; auto|exact F']|].
    apply Least. exact N.
Qed.

Definition of_list l := Tensor (nth 0 l 0) (nth 1 l 0) (nth 2 l 0) (nth 3 l 0) (nth 4 l 0) (nth 5 l 0).
Definition to_list t := [xx t; yy t; zz t; xy t; yz t; xz t].
Lemma of_to_list t : of_list (to_list t) = t.
Proof. destruct t. reflexivity. Qed.

Definition gap s t := Rabs (xx s - xx t) + Rabs (yy s - yy t) + Rabs (zz s - zz t)
  + Rabs (xy s - xy t) + Rabs (yz s - yz t) + Rabs (xz s - xz t).
Lemma gap_self t : gap t t = 0.
Proof. unfold gap. rewrite !Rminus_diag_eq, Rabs_R0 by reflexivity. ring. Qed.

Lemma nth_changed i (p q : list R) x y : nth i (p ++ x :: q) 0 = nth i (p ++ y :: q) 0 \/
  (i = length p /\ nth i (p ++ x :: q) 0 = x /\ nth i (p ++ y :: q) 0 = y).
Proof.
  revert i. induction p as [|a p IH]; intros i; cbn.
  - destruct i; [right; auto|left; reflexivity].
  - destruct i; [left; reflexivity|]. cbn. destruct (IH i) as [H|[H1 H2]]; [left; exact H|right; auto].
Qed.
Lemma gap_changed p q x y t :
  gap (of_list (p ++ y :: q)) t <= gap (of_list (p ++ x :: q)) t + Rabs (x - y).
Proof.
  assert (One : forall i v, Rabs (nth i (p ++ y :: q) 0 - v) <= Rabs (nth i (p ++ x :: q) 0 - v)
    + (if Nat.eqb i (length p) then Rabs (x - y) else 0)).
  { intros i v. destruct (nth_changed i p q x y) as [H|[H1 [H2 H3]]].
    - rewrite H. assert (R := Rabs_pos (x - y)). destruct (Nat.eqb i (length p)); lra.
    - rewrite H2, H3, H1, PeanoNat.Nat.eqb_refl. replace (y - v) with ((x - v) + - (x - y)) by ring.
      assert (T := Rabs_triang (x - v) (- (x - y))). rewrite Rabs_Ropp in T. exact T. }
  unfold gap, of_list. cbn [xx yy zz xy yz xz].
  assert (A0 := One 0%nat (xx t)). assert (A1 := One 1%nat (yy t)). assert (A2 := One 2%nat (zz t)).
  assert (A3 := One 3%nat (xy t)). assert (A4 := One 4%nat (yz t)). assert (A5 := One 5%nat (xz t)).
  assert (R := Rabs_pos (x - y)).
  destruct (length p) as [|[|[|[|[|[|n]]]]]]; cbn [Nat.eqb] in *; lra.
Qed.

Theorem near_supremum (omega : tensor -> Prop) f b m : 0 <= b ->
  (forall t, omega t -> Forall (fun x => - b <= x <= b) (to_list t)) ->
  (exists t, omega t) -> (forall t, omega t -> f t <= m) ->
  exists t s, (forall u, omega u -> f u <= s) /\
    forall eps, 0 < eps -> ~ (forall u, omega u -> gap t u < eps -> f u <= s - eps).
Proof.
  intros B Box [t0 T0] Up.
  assert (G0 : forall s t, 0 <= gap s t).
  { intros s t. unfold gap. assert (P := Rabs_pos). assert (A := P (xx s - xx t)). assert (C := P (yy s - yy t)).
    assert (D := P (zz s - zz t)). assert (E := P (xy s - xy t)). assert (F := P (yz s - yz t)). assert (G := P (xz s - xz t)). lra. }
  assert (Bd : forall p, bound (fun v => exists u, omega u /\ v = f u - gap p u)).
  { intros p. exists m. intros v [u [U E]]. assert (H := Up u U). assert (K := G0 p u). lra. }
  assert (In : forall p, exists v, exists u, omega u /\ v = f u - gap p u) by (intros p; exists (f t0 - gap p t0), t0; auto).
  set (h := fun p => proj1_sig (completeness _ (Bd p) (In p))).
  assert (Hu : forall p u, omega u -> f u - gap p u <= h p).
  { intros p u U. unfold h. destruct (completeness _ (Bd p) (In p)) as [v [A M]]. cbn. apply A. eauto. }
  assert (Hl : forall p v, (forall u, omega u -> f u - gap p u <= v) -> h p <= v).
  { intros p v H. unfold h. destruct (completeness _ (Bd p) (In p)) as [w [A M]]. cbn. apply M.
    intros z [u [U E]]. rewrite E. apply H, U. }
  destruct (maximum_on_box b 6 B (fun l => h (of_list l))) as [l [L M]].
  { intros p x y q. apply Hl. intros u U. assert (H := Hu (of_list (p ++ y :: q)) u U).
    assert (K := gap_changed p q x y u). lra. }
  exists (of_list l), (h (of_list l)). split.
  - intros u U. apply Rle_trans with (h u).
    + assert (H := Hu u u U). rewrite gap_self in H. lra.
    + rewrite <- (of_to_list u) at 1. apply M. split; [reflexivity|apply Box, U].
  - intros eps E H. assert (K : h (of_list l) <= h (of_list l) - eps); [|lra].
    apply Hl. intros u U. destruct (Rlt_dec (gap (of_list l) u) eps) as [G|G].
    + assert (X := H u U G). assert (Y := G0 (of_list l) u). lra.
    + assert (X : f u <= h (of_list l)).
      { apply Rle_trans with (h u).
        - assert (X := Hu u u U). rewrite gap_self in X. lra.
        - rewrite <- (of_to_list u) at 1. apply M. split; [reflexivity|apply Box, U]. }
      lra.
Qed.
