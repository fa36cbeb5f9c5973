(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   The mode of a linear field as a function of the weights of a simplex: its derivative along a
   direction, and its continuity. *)
From TensorTopo Require Import Tensors Mode Polynomials Kernel.
Require Import Reals Psatz Ring Field ZArith List Lia.
Import ListNotations.
Open Scope R_scope.

(* d(Q P^(-3/2)) = (2 P dQ - 3 Q dP) P^(-5/2) / 2. *)
Lemma quotient_derivative p q dp dq t : 0 < p t ->
  derivable_pt_lim p t dp -> derivable_pt_lim q t dq ->
  derivable_pt_lim (fun t => q t / (sqrt (p t) * sqrt (p t) * sqrt (p t))) t
    ((2 * p t * dq - 3 * q t * dp) / (2 * sqrt (p t) * (p t * p t))).
Proof.
  intros P DP DQ.
  assert (S := derivable_pt_lim_comp _ _ _ _ _ DP (derivable_pt_lim_sqrt (p t) P)).
  assert (S3 := derivable_pt_lim_mult _ _ _ _ _ (derivable_pt_lim_mult _ _ _ _ _ S S) S).
  assert (R : 0 < sqrt (p t)) by (apply sqrt_lt_R0; exact P).
  assert (N : mult_fct (mult_fct (comp sqrt p) (comp sqrt p)) (comp sqrt p) t <> 0).
  { unfold mult_fct, comp. repeat apply Rmult_integral_contrapositive_currified; lra. }
  assert (D := derivable_pt_lim_div _ _ _ _ _ DQ S3 N). clear S S3 N.
  unfold div_fct, mult_fct, comp, Rsqr in D.
  replace (_ / (2 * sqrt (p t) * (p t * p t))) with
   ((dq * (sqrt (p t) * sqrt (p t) * sqrt (p t)) -
      ((/ (2 * sqrt (p t)) * dp * sqrt (p t) + sqrt (p t) * (/ (2 * sqrt (p t)) * dp)) * sqrt (p t) +
       sqrt (p t) * sqrt (p t) * (/ (2 * sqrt (p t)) * dp)) * q t) /
     (sqrt (p t) * sqrt (p t) * sqrt (p t) * (sqrt (p t) * sqrt (p t) * sqrt (p t)))); [exact D|].
  assert (E : sqrt (p t) * sqrt (p t) = p t) by (apply sqrt_sqrt; lra).
  set (r := sqrt (p t)) in *. rewrite <- E. field. lra.
Qed.

Definition mode_derivative m d w :=
  3 * sqrt 6 * (value (increase_form m d) w
    / (2 * norm (field m w) * (norm2 (field m w) * norm2 (field m w)))).

Lemma mode_derivative_value m d w t : field m (move w t d) <> zero ->
  derivable_pt_lim (fun t => mode (field m (move w t d))) t (mode_derivative m d (move w t d)).
Proof.
  intros N. assert (P := norm2_positive _ N).
  assert (D := quotient_derivative (fun t => norm2 (field m (move w t d)))
    (fun t => det (field m (move w t d))) _ _ t P (norm_derivative m d w t) (det_derivative m d w t)).
  assert (E := derivable_pt_lim_scal _ (3 * sqrt 6) _ _ D).
  unfold mode_derivative. rewrite increase_form_value. unfold norm.
  intros eps H. destruct (E eps H) as [delta K]. exists delta. intros h H1 H2.
  assert (L := K h H1 H2). clear K. unfold mult_real_fct in L. unfold mode, norm.
  unfold Rdiv in *. rewrite !(Rmult_assoc (3 * sqrt 6)). exact L.
Qed.

(* Weights one by one. *)
Lemma nonneg_nth w : Forall (fun x => 0 <= x) w <-> forall i, 0 <= nth i w 0.
Proof.
  split.
  - intros H i. destruct (Nat.lt_ge_cases i (length w)) as [L|L].
    + rewrite Forall_forall in H. apply H, nth_In, L.
    + rewrite nth_overflow by exact L. lra.
  - intros H. rewrite Forall_forall. intros x I. destruct (In_nth w x 0 I) as [i [_ E]].
    rewrite <- E. apply H.
Qed.
Lemma move_nth i w t d : nth i (move w t d) 0 = nth i w 0 + t * IZR (nth i d 0%Z).
Proof.
  revert i w. induction d as [|a d IH]; intros i w; cbn [move].
  - replace (nth i [] 0%Z) with 0%Z by (destruct i; reflexivity). ring.
  - destruct i as [|i]; cbn [nth]; [destruct w; reflexivity|]. rewrite IH, nth_tail. reflexivity.
Qed.
Lemma cone_nth V w : in_cone V w <->
  (forall i, 0 <= nth i w 0) /\ exists i, (i < V)%nat /\ 0 < nth i w 0.
Proof. unfold in_cone. rewrite nonneg_nth. reflexivity. Qed.

(* The cone is convex. *)
Lemma between_in_cone V w d a b c : a <= b <= c ->
  in_cone V (move w a d) -> in_cone V (move w c d) -> in_cone V (move w b d).
Proof.
  rewrite !cone_nth. intros I [A [i [Vi P]]] [C [j [Vj Q]]].
  assert (N : forall k, 0 <= nth k (move w b d) 0).
  { intros k. assert (X := A k). assert (Y := C k). rewrite move_nth in X, Y |- *.
    destruct (Rle_dec 0 (IZR (nth k d 0%Z))); nra. }
  split; [exact N|].
  destruct (Req_dec b c) as [E|E]; [subst; eauto|].
  exists i. split; [exact Vi|]. assert (Y := C i). rewrite move_nth in P, Y |- *.
  destruct (Rle_dec 0 (IZR (nth i d 0%Z))); nra.
Qed.
Lemma move_zero V w d : in_cone V (move w 0 d) <-> in_cone V w.
Proof.
  rewrite !cone_nth. assert (E : forall i, nth i (move w 0 d) 0 = nth i w 0)
    by (intros; rewrite move_nth; ring).
  split; intros [A [i [B C]]]; (split; [intros k; assert (X := A k); rewrite E in *; exact X|]);
    exists i; rewrite E in *; auto.
Qed.

(* Functions of the weights that are continuous at w. *)
Definition close (delta : R) (w w' : list R) := forall i, Rabs (nth i w' 0 - nth i w 0) < delta.
Definition continuous_at (f : list R -> R) (w : list R) := forall eps, 0 < eps ->
  exists delta, 0 < delta /\ forall w', close delta w w' -> Rabs (f w' - f w) < eps.

Lemma continuous_constant k w : continuous_at (fun _ => k) w.
Proof.
  intros eps E. exists 1. split; [lra|]. intros w' _. rewrite Rminus_diag_eq, Rabs_R0 by reflexivity.
  exact E.
Qed.
Lemma continuous_compose2 f g h w :
  (forall eps, 0 < eps -> exists delta, 0 < delta /\ forall x y,
    Rabs (x - f w) < delta -> Rabs (y - g w) < delta -> Rabs (h x y - h (f w) (g w)) < eps) ->
  continuous_at f w -> continuous_at g w -> continuous_at (fun v => h (f v) (g v)) w.
Proof.
  intros H F G eps E. destruct (H eps E) as [d [D K]].
  destruct (F d D) as [d1 [D1 K1]]. destruct (G d D) as [d2 [D2 K2]].
  exists (Rmin d1 d2). split; [apply Rmin_glb_lt; assumption|].
  intros w' C. apply K; [apply K1|apply K2]; intros i; assert (X := C i).
  - assert (Y := Rmin_l d1 d2). lra.
  - assert (Y := Rmin_r d1 d2). lra.
Qed.
Lemma continuous_plus f g w :
  continuous_at f w -> continuous_at g w -> continuous_at (fun v => f v + g v) w.
Proof.
  apply (continuous_compose2 f g Rplus). intros eps E. exists (eps / 2). split; [lra|].
  intros x y X Y. replace (_ - _) with ((x - f w) + (y - g w)) by ring.
  assert (T := Rabs_triang (x - f w) (y - g w)). lra.
Qed.
Lemma continuous_mult f g w :
  continuous_at f w -> continuous_at g w -> continuous_at (fun v => f v * g v) w.
Proof.
  apply (continuous_compose2 f g Rmult). intros eps E.
  set (a := Rabs (f w)). set (b := Rabs (g w)).
  assert (A : 0 <= a) by apply Rabs_pos. assert (B : 0 <= b) by apply Rabs_pos.
  set (k := 1 + a + b). set (d := Rmin 1 (eps / k)).
  assert (K : 0 < k) by (unfold k; lra).
  assert (Q : 0 < eps / k) by (apply Rdiv_lt_0_compat; assumption).
  exists d. split; [apply Rmin_glb_lt; lra|]. intros x y X Y.
  assert (D1 := Rmin_l 1 (eps / k)). assert (D2 := Rmin_r 1 (eps / k)). fold d in D1, D2.
  replace (_ - _) with ((x - f w) * (y - g w) + (f w * (y - g w) + g w * (x - f w))) by ring.
  assert (T := Rabs_triang ((x - f w) * (y - g w)) (f w * (y - g w) + g w * (x - f w))).
  assert (T2 := Rabs_triang (f w * (y - g w)) (g w * (x - f w))).
  rewrite (Rabs_mult (x - f w)) in T. rewrite (Rabs_mult (f w)), (Rabs_mult (g w)) in T2.
  fold a b in T2.
  assert (X0 := Rabs_pos (x - f w)). assert (Y0 := Rabs_pos (y - g w)).
  set (u := Rabs (x - f w)) in *. set (v := Rabs (y - g w)) in *.
  assert (S : u * v + (a * v + b * u) <= d * k) by (unfold k; nra).
  assert (M : u * v + (a * v + b * u) < d * k).
  { assert (0 < d) by lra. destruct (Req_dec v 0) as [V|V].
    - rewrite V. unfold k. nra.
    - assert (u * v < d * v) by (apply Rmult_lt_compat_r; lra).
      assert (a * v <= a * d) by (apply Rmult_le_compat_l; lra).
      assert (b * u <= b * d) by (apply Rmult_le_compat_l; lra).
      unfold k. nra. }
  assert (d * k <= eps).
  { apply Rle_trans with (eps / k * k); [apply Rmult_le_compat_r; lra|]. right. field. lra. }
  lra.
Qed.
Lemma continuous_compose f g w :
  continuity_pt g (f w) -> continuous_at f w -> continuous_at (fun v => g (f v)) w.
Proof.
  intros C F eps E. destruct (C eps E) as [d [D K]]. destruct (F d D) as [e [E1 L]].
  exists e. split; [exact E1|]. intros w' H. assert (X := L w' H).
  destruct (Req_dec (f w') (f w)) as [Z|Z].
  - rewrite Z, Rminus_diag_eq, Rabs_R0 by reflexivity. exact E.
  - apply (K (f w')). split; [split; [exact I|auto]|exact X].
Qed.
Lemma continuous_tail f w : continuous_at f (tl w) -> continuous_at (fun v => f (tl v)) w.
Proof.
  intros F eps E. destruct (F eps E) as [d [D K]]. exists d. split; [exact D|].
  intros w' C. apply K. intros i. rewrite !nth_tail. apply C.
Qed.
Lemma continuous_head w : continuous_at (hd 0) w.
Proof.
  intros eps E. exists eps. split; [exact E|]. intros w' C. assert (X := C O).
  destruct w, w'; exact X.
Qed.
Lemma continuous_monomial e w : continuous_at (monomial_value e) w.
Proof.
  revert w. induction e as [|n e IH]; intros w; cbn.
  - apply continuous_constant.
  - apply continuous_mult.
    + apply (continuous_compose (hd 0) (fun x => x ^ n)); [|apply continuous_head].
      apply derivable_continuous_pt, derivable_pt_pow.
    + apply continuous_tail, IH.
Qed.
Lemma continuous_value p w : continuous_at (value p) w.
Proof.
  induction p as [|[c e] p IH]; cbn.
  - apply continuous_constant.
  - apply continuous_plus; [|exact IH].
    apply continuous_mult; [apply continuous_constant|apply continuous_monomial].
Qed.
Lemma continuous_extensional f g w : (forall v, f v = g v) -> continuous_at f w -> continuous_at g w.
Proof.
  intros H F eps E. destruct (F eps E) as [d [D K]]. exists d. split; [exact D|].
  intros w' C. rewrite <- !H. apply K, C.
Qed.
Lemma continuous_mode m w : field m w <> zero -> continuous_at (fun v => mode (field m v)) w.
Proof.
  intros N. assert (P := norm_positive _ N). assert (P2 := norm2_positive _ N).
  assert (S : continuous_at (fun v => norm (field m v)) w).
  { apply (continuous_extensional (fun v => sqrt (value (norm_form m) v))).
    - intros v. rewrite norm_form_value. reflexivity.
    - apply (continuous_compose (value (norm_form m)) sqrt); [|apply continuous_value].
      apply continuity_pt_sqrt. rewrite norm_form_value. lra. }
  unfold mode, Rdiv. apply continuous_mult; [apply continuous_mult; [apply continuous_constant|]|].
  - apply (continuous_extensional (value (det_form m))); [apply det_form_value|apply continuous_value].
  - apply (continuous_compose (fun v => norm (field m v) * norm (field m v) * norm (field m v)) Rinv).
    + apply continuity_pt_inv; [apply derivable_continuous_pt, derivable_pt_id|].
      repeat apply Rmult_integral_contrapositive_currified; lra.
    + repeat apply continuous_mult; exact S.
Qed.
