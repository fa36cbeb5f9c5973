(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   Polynomials with real coefficients in the weights of a simplex's corners, made of those with
   integer coefficients and of real linear forms. Like monomials are merged, so that coefficients
   have the signs that matter. Positive ones bound the values from below. *)
From TensorTopo Require Import Polynomials.
Require Import Reals Psatz Ring ZArith List Bool Lia.
Import ListNotations.
Open Scope R_scope.

Definition real_polynomial := list (R * monomial).
Fixpoint real_value (p : real_polynomial) (w : list R) : R :=
  match p with [] => 0 | (c, e) :: p' => c * monomial_value e w + real_value p' w end.

Definition multiple (k : R) (p : polynomial) : real_polynomial :=
  map (fun t => (k * IZR (fst t), snd t)) p.
Fixpoint real_mul (p q : real_polynomial) : real_polynomial :=
  match p with
  | [] => []
  | (c, e) :: p' => map (fun t => (c * fst t, add_exponents e (snd t))) q ++ real_mul p' q
  end.
(* A linear form, by its value at each corner. *)
Fixpoint real_linear (s : list R) : real_polynomial :=
  match s with
  | [] => []
  | r :: s' => (r, 1%nat :: repeat 0%nat (length s'))
               :: map (fun t => (fst t, 0%nat :: snd t)) (real_linear s')
  end.
Fixpoint real_sum (s : list R) (w : list R) : R :=
  match s with [] => 0 | r :: s' => hd 0 w * r + real_sum s' (tl w) end.
Fixpoint merge_term (c : R) (e : monomial) (p : real_polynomial) : real_polynomial :=
  match p with
  | [] => [(c, e)]
  | (b, f) :: p' => if same e f then (b + c, f) :: p' else (b, f) :: merge_term c e p'
  end.
Fixpoint merge (p : real_polynomial) : real_polynomial :=
  match p with [] => [] | (c, e) :: p' => merge_term c e (merge p') end.

Lemma multiple_value k p w : real_value (multiple k p) w = k * value p w.
Proof. induction p as [|[c e] p IH]; cbn; [ring|]. cbn in IH. fold (multiple k p). rewrite IH. ring. Qed.
Lemma real_append_value p q w : real_value (p ++ q) w = real_value p w + real_value q w.
Proof. induction p as [|[c e] p IH]; cbn; [ring|]. rewrite IH. ring. Qed.
Lemma real_mul_value p q w : real_value (real_mul p q) w = real_value p w * real_value q w.
Proof.
  induction p as [|[c e] p IH]; cbn; [ring|]. rewrite real_append_value, IH.
  assert (E : real_value (map (fun t => (c * fst t, add_exponents e (snd t))) q) w
    = c * monomial_value e w * real_value q w).
  { clear. induction q as [|[b f] q IH]; cbn; [ring|]. cbn in IH.
    rewrite IH, add_exponents_value. ring. }
  rewrite E. ring.
Qed.
Lemma real_linear_value s w : real_value (real_linear s) w = real_sum s w.
Proof.
  revert w. induction s as [|r s IH]; intros w; cbn; [reflexivity|].
  assert (E : forall p, real_value (map (fun t => (fst t, 0%nat :: snd t)) p) w
    = real_value p (tl w)).
  { induction p as [|[c e] p J]; cbn; [reflexivity|]. cbn in J. rewrite J. ring. }
  rewrite E, IH, constant_value. ring.
Qed.
Lemma merge_term_value c e p w :
  real_value (merge_term c e p) w = c * monomial_value e w + real_value p w.
Proof.
  induction p as [|[b f] p IH]; cbn; [reflexivity|].
  destruct (same e f) eqn:S; cbn; [|rewrite IH; ring].
  apply same_eq in S. subst. ring.
Qed.
Lemma merge_value p w : real_value (merge p) w = real_value p w.
Proof. induction p as [|[c e] p IH]; cbn; [reflexivity|]. rewrite merge_term_value, IH. ring. Qed.

(* No coefficient is negative, and those of the pure powers of V weights are positive. *)
Definition positive_coefficients (V : nat) (p : real_polynomial) :=
  Forall (fun t => 0 <= fst t) p /\
  forall i, (i < V)%nat -> Exists (fun t => 0 < fst t /\ is_pure i (snd t) = true) p.

Lemma real_nonneg_value p w : Forall (fun x => 0 <= x) w -> Forall (fun t => 0 <= fst t) p ->
  0 <= real_value p w.
Proof.
  intros W H. induction H as [|[c e] p C H IH]; cbn in *; [lra|].
  assert (M := monomial_nonneg e w W).
  assert (0 <= c * monomial_value e w) by (apply Rmult_le_pos; assumption). lra.
Qed.
Lemma pure_lower_bound p i x : 0 < x -> Forall (fun t => 0 <= fst t) p ->
  Exists (fun t => 0 < fst t /\ is_pure i (snd t) = true) p ->
  exists c, 0 < c /\ forall w, Forall (fun x => 0 <= x) w -> x <= nth i w 0 -> c <= real_value p w.
Proof.
  intros X N E. induction E as [[c e] p [C U]|[c e] p E IH]; cbn in *;
    inversion N as [|? ? C' N']; subst; cbn in C'.
  - exists (c * x ^ nth i e 0%nat). split; [apply Rmult_lt_0_compat; [exact C|apply pow_lt, X]|].
    intros w W L. rewrite (pure_value i e w U). assert (S := real_nonneg_value p w W N').
    assert (c * x ^ nth i e 0%nat <= c * nth i w 0 ^ nth i e 0%nat)
      by (apply Rmult_le_compat_l; [lra|apply pow_incr; lra]).
    lra.
  - destruct (IH N') as [k [K H]]. exists k. split; [exact K|]. intros w W L.
    assert (M := monomial_nonneg e w W). assert (S := H w W L).
    assert (0 <= c * monomial_value e w) by (apply Rmult_le_pos; assumption). lra.
Qed.
Theorem positive_coefficients_value V p w :
  positive_coefficients V p -> in_cone V w -> 0 < real_value p w.
Proof.
  intros [N P] [W [i [I X]]]. destruct (pure_lower_bound p i _ X N (P i I)) as [c [C H]].
  assert (L := H w W (Rle_refl _)). lra.
Qed.

(* One bound from below for all points with a weight of at least 1. *)
Lemma uniform_lower_bound V p : positive_coefficients V p -> exists c, 0 < c /\
  forall w i, Forall (fun x => 0 <= x) w -> (i < V)%nat -> 1 <= nth i w 0 -> c <= real_value p w.
Proof.
  intros [N P]. induction V as [|n IH]; [exists 1; split; [lra|intros; lia]|].
  destruct IH as [b [B H]]; [intros i I; apply P; lia|].
  destruct (pure_lower_bound p n 1 Rlt_0_1 N (P n ltac:(lia))) as [c [C K]].
  exists (Rmin b c). split; [apply Rmin_glb_lt; assumption|]. intros w i W I L.
  destruct (Nat.eq_dec i n) as [->|E].
  - assert (X := K w W L). assert (Y := Rmin_r b c). lra.
  - assert (X := H w i W ltac:(lia) L). assert (Y := Rmin_l b c). lra.
Qed.
(* And one from above for all points with weights between 0 and 1. *)
Lemma uniform_upper_bound p : exists b, 0 <= b /\
  forall w, Forall (fun x => 0 <= x <= 1) w -> Rabs (real_value p w) <= b.
Proof.
  induction p as [|[c e] p [b [B H]]]; cbn.
  - exists 0. split; [lra|]. intros. rewrite Rabs_R0. lra.
  - exists (Rabs c + b). assert (A := Rabs_pos c). split; [lra|]. intros w W.
    assert (M : 0 <= monomial_value e w <= 1).
    { clear H. revert w W. induction e as [|n e IH]; intros w W; cbn; [lra|].
      assert (T : Forall (fun x => 0 <= x <= 1) (tl w)) by (destruct W; cbn; auto).
      assert (X : 0 <= hd 0 w <= 1) by (destruct W; cbn; lra).
      assert (Y := IH (tl w) T).
      assert (Z : 0 <= hd 0 w ^ n <= 1).
      { split; [apply pow_le; lra|]. rewrite <- (pow1 n). apply pow_incr. lra. }
      split; [apply Rmult_le_pos; lra|]. rewrite <- (Rmult_1_r 1). apply Rmult_le_compat; lra. }
    assert (T := Rabs_triang (c * monomial_value e w) (real_value p w)).
    rewrite Rabs_mult, (Rabs_pos_eq (monomial_value e w)) in T by lra.
    assert (X := H w W). assert (Rabs c * monomial_value e w <= Rabs c * 1) by (apply Rmult_le_compat_l; lra).
    lra.
Qed.
