(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   Polynomials with integer coefficients in the weights of a simplex's corners, as lists of
   coefficients and exponents. All operations compute; each is proved to do to the values of
   polynomials at real weights what its name says. Weights that a list does not have are 0. *)
Require Import Reals Psatz Ring ZArith List Bool Lia.
Import ListNotations.
Open Scope R_scope.

Definition monomial := list nat.
Definition polynomial := list (Z * monomial).

Fixpoint monomial_value (e : monomial) (w : list R) : R :=
  match e with [] => 1 | n :: e' => hd 0 w ^ n * monomial_value e' (tl w) end.
Fixpoint value (p : polynomial) (w : list R) : R :=
  match p with [] => 0 | (c, e) :: p' => IZR c * monomial_value e w + value p' w end.

(* Sums: like monomials are merged, so that coefficients have the signs that matter. *)
Fixpoint same (e f : monomial) : bool :=
  match e, f with
  | [], [] => true
  | m :: e', n :: f' => Nat.eqb m n && same e' f'
  | _, _ => false
  end.
Fixpoint add_term (c : Z) (e : monomial) (p : polynomial) : polynomial :=
  match p with
  | [] => [(c, e)]
  | (b, f) :: p' => if same e f then ((b + c)%Z, f) :: p' else (b, f) :: add_term c e p'
  end.
Fixpoint poly_add (p q : polynomial) : polynomial :=
  match p with
  | [] => q
  | (c, e) :: p' => if Z.eqb c 0 then poly_add p' q else add_term c e (poly_add p' q)
  end.
Definition poly_scale (k : Z) (p : polynomial) : polynomial :=
  map (fun t => ((k * fst t)%Z, snd t)) p.

Lemma same_eq e f : same e f = true -> e = f.
Proof.
  revert f. induction e as [|m e IH]; intros [|n f] H; cbn in H; try discriminate; auto.
  apply andb_prop in H. destruct H as [A B]. apply Nat.eqb_eq in A. subst. f_equal. auto.
Qed.
Lemma add_term_value c e p w : value (add_term c e p) w = IZR c * monomial_value e w + value p w.
Proof.
  induction p as [|[b f] p IH]; cbn; [reflexivity|].
  destruct (same e f) eqn:S; cbn; [|rewrite IH; ring].
  apply same_eq in S. subst. rewrite plus_IZR. ring.
Qed.
Lemma poly_add_value p q w : value (poly_add p q) w = value p w + value q w.
Proof.
  induction p as [|[c e] p IH]; cbn; [ring|]. destruct (Z.eqb c 0) eqn:C.
  - apply Z.eqb_eq in C. subst. rewrite IH. ring.
  - rewrite add_term_value, IH. ring.
Qed.
Lemma poly_scale_value k p w : value (poly_scale k p) w = IZR k * value p w.
Proof.
  unfold poly_scale. induction p as [|[c e] p IH]; cbn; [ring|]. rewrite IH, mult_IZR. ring.
Qed.

(* Products. *)
Fixpoint add_exponents (e f : monomial) : monomial :=
  match e, f with
  | [], _ => f
  | _, [] => e
  | m :: e', n :: f' => (m + n)%nat :: add_exponents e' f'
  end.
Fixpoint poly_mul (p q : polynomial) : polynomial :=
  match p with
  | [] => []
  | (c, e) :: p' =>
      poly_add (map (fun t => ((c * fst t)%Z, add_exponents e (snd t))) q) (poly_mul p' q)
  end.
Lemma add_exponents_value e f w :
  monomial_value (add_exponents e f) w = monomial_value e w * monomial_value f w.
Proof.
  revert f w. induction e as [|m e IH]; intros f w; cbn; [ring|].
  destruct f as [|n f]; cbn; [ring|]. rewrite IH, pow_add. ring.
Qed.
Lemma poly_mul_value p q w : value (poly_mul p q) w = value p w * value q w.
Proof.
  induction p as [|[c e] p IH]; cbn; [ring|]. rewrite poly_add_value, IH.
  assert (E : value (map (fun t => ((c * fst t)%Z, add_exponents e (snd t))) q) w
    = IZR c * monomial_value e w * value q w).
  { clear. induction q as [|[b f] q IH]; cbn; [ring|].
    rewrite IH, mult_IZR, add_exponents_value. ring. }
  rewrite E. ring.
Qed.

(* A linear form, by its value at each corner. *)
Fixpoint linear_form (cs : list Z) : polynomial :=
  match cs with
  | [] => []
  | c :: cs' => (c, 1%nat :: repeat 0%nat (length cs'))
                :: map (fun t => (fst t, 0%nat :: snd t)) (linear_form cs')
  end.
Fixpoint weighted_sum (cs : list Z) (w : list R) : R :=
  match cs with [] => 0 | c :: cs' => hd 0 w * IZR c + weighted_sum cs' (tl w) end.
Lemma shifted_value n p w :
  value (map (fun t => (fst t, n :: snd t)) p) w = hd 0 w ^ n * value p (tl w).
Proof. induction p as [|[c e] p IH]; cbn; [ring|]. cbn in IH. rewrite IH. ring. Qed.
Lemma constant_value k w : monomial_value (repeat 0%nat k) w = 1.
Proof. revert w. induction k as [|k IH]; intros w; cbn; [reflexivity|]. rewrite IH. ring. Qed.
Lemma linear_form_value cs w : value (linear_form cs) w = weighted_sum cs w.
Proof.
  revert w. induction cs as [|c cs IH]; intros w; cbn; [reflexivity|].
  rewrite (shifted_value 0), IH, constant_value. cbn. ring.
Qed.

(* The weights w + t d, and the derivative along d. *)
Fixpoint move (w : list R) (t : R) (d : list Z) : list R :=
  match d with [] => w | a :: d' => (hd 0 w + t * IZR a) :: move (tl w) t d' end.
Fixpoint monomial_derivative (e : monomial) (d : list Z) : polynomial :=
  match e, d with
  | n :: e', a :: d' => ((Z.of_nat n * a)%Z, pred n :: e')
                        :: map (fun t => (fst t, n :: snd t)) (monomial_derivative e' d')
  | _, _ => []
  end.
Fixpoint poly_derivative (p : polynomial) (d : list Z) : polynomial :=
  match p with
  | [] => []
  | (c, e) :: p' => poly_add (poly_scale c (monomial_derivative e d)) (poly_derivative p' d)
  end.
Lemma affine_derivative x a t : derivable_pt_lim (fun t => x + t * a) t a.
Proof.
  intros eps H. exists (mkposreal 1 Rlt_0_1). intros h N _.
  replace (_ - a) with 0 by (field; exact N). rewrite Rabs_R0. exact H.
Qed.
Lemma monomial_derivative_value e d w t :
  derivable_pt_lim (fun t => monomial_value e (move w t d)) t
    (value (monomial_derivative e d) (move w t d)).
Proof.
  revert d w. induction e as [|n e IH]; intros d w; cbn.
  - apply derivable_pt_lim_const.
  - destruct d as [|a d]; cbn.
    + apply derivable_pt_lim_const.
    + rewrite shifted_value. cbn [hd tl].
      assert (L := affine_derivative (hd 0 w) (IZR a) t).
      assert (P := derivable_pt_lim_comp _ _ _ _ _ L (derivable_pt_lim_pow (hd 0 w + t * IZR a) n)).
      assert (Q := derivable_pt_lim_mult _ _ _ _ _ P (IH d (tl w))).
      replace (_ + _) with
        (INR n * (hd 0 w + t * IZR a) ^ Init.Nat.pred n * IZR a * monomial_value e (move (tl w) t d)
         + comp (fun y => y ^ n) (fun t => hd 0 w + t * IZR a) t
           * value (monomial_derivative e d) (move (tl w) t d)); [exact Q|].
      unfold comp. rewrite mult_IZR, <- INR_IZR_INZ. ring.
Qed.
Lemma poly_derivative_value p d w t :
  derivable_pt_lim (fun t => value p (move w t d)) t (value (poly_derivative p d) (move w t d)).
Proof.
  induction p as [|[c e] p IH]; cbn.
  - apply derivable_pt_lim_const.
  - rewrite poly_add_value, poly_scale_value. apply derivable_pt_lim_plus; [|exact IH].
    apply (derivable_pt_lim_scal (fun t => monomial_value e (move w t d))),
      monomial_derivative_value.
Qed.

(* Signs. No coefficient is negative, and those of the pure powers of V weights are positive:
   then so is the polynomial wherever no weight is negative and one of the V is positive. *)
Fixpoint is_pure (i : nat) (e : monomial) {struct e} : bool :=
  match e, i with
  | [], _ => false
  | _ :: e', O => forallb (Nat.eqb 0) e'
  | n :: e', S i' => Nat.eqb 0 n && is_pure i' e'
  end.
Definition nonnegative (p : polynomial) : bool := forallb (fun t => Z.leb 0 (fst t)) p.
Definition all_positive (V : nat) (p : polynomial) : bool :=
  nonnegative p &&
  forallb (fun i => existsb (fun t => Z.ltb 0 (fst t) && is_pure i (snd t)) p) (seq 0 V).

Definition in_cone (V : nat) (w : list R) : Prop :=
  Forall (fun x => 0 <= x) w /\ exists i, (i < V)%nat /\ 0 < nth i w 0.

Lemma head_nonneg w : Forall (fun x => 0 <= x) w -> 0 <= hd 0 w.
Proof. intros [|x w' X W]; cbn; lra. Qed.
Lemma tail_nonneg w : Forall (fun x => 0 <= x) w -> Forall (fun x => 0 <= x) (tl w).
Proof. intros [|x w' X W]; cbn; auto. Qed.
Lemma monomial_nonneg e w : Forall (fun x => 0 <= x) w -> 0 <= monomial_value e w.
Proof.
  revert w. induction e as [|n e IH]; intros w W; cbn; [lra|].
  apply Rmult_le_pos; [apply pow_le, head_nonneg, W|apply IH, tail_nonneg, W].
Qed.
Lemma nonnegative_value p w : Forall (fun x => 0 <= x) w -> nonnegative p = true -> 0 <= value p w.
Proof.
  intros W. induction p as [|[c e] p IH]; cbn; intros H; [lra|].
  apply andb_prop in H. destruct H as [A B]. apply Z.leb_le, IZR_le in A.
  assert (M := monomial_nonneg e w W). assert (N := IH B). nra.
Qed.
Lemma nth_tail i (w : list R) : nth i (tl w) 0 = nth (S i) w 0.
Proof. destruct w; cbn; [destruct i; reflexivity|reflexivity]. Qed.
Lemma pure_value i e w : is_pure i e = true -> monomial_value e w = nth i w 0 ^ nth i e 0%nat.
Proof.
  revert i w. induction e as [|n e IH]; intros i w H; cbn in H; [discriminate|].
  destruct i as [|i]; cbn.
  - assert (E : monomial_value e (tl w) = 1).
    { generalize (tl w). clear IH. induction e as [|m e IH]; intros v; cbn; [reflexivity|].
      cbn in H. apply andb_prop in H. destruct H as [A B]. destruct m as [|m]; [|discriminate].
      rewrite IH by exact B. cbn. ring. }
    rewrite E. destruct w; cbn; ring.
  - apply andb_prop in H. destruct H as [A B]. destruct n as [|n]; [|discriminate].
    rewrite (IH i (tl w) B), nth_tail. cbn. destruct w; cbn; ring.
Qed.
Theorem all_positive_value V p w : all_positive V p = true -> in_cone V w -> 0 < value p w.
Proof.
  unfold all_positive. intros H [W [i [I X]]]. apply andb_prop in H. destruct H as [N P].
  rewrite forallb_forall in P. assert (Q := P i). cbv beta in Q. clear P.
  assert (E : existsb (fun t => Z.ltb 0 (fst t) && is_pure i (snd t)) p = true).
  { apply Q. apply in_seq. lia. }
  clear Q. induction p as [|[c e] p IH]; cbn in *; [discriminate|].
  apply andb_prop in N. destruct N as [A B]. apply Z.leb_le, IZR_le in A.
  assert (M := monomial_nonneg e w W). assert (S := nonnegative_value p w W B).
  apply orb_prop in E. destruct E as [E|E].
  - apply andb_prop in E. destruct E as [C U]. apply Z.ltb_lt, IZR_lt in C.
    rewrite (pure_value i e w U). assert (0 < IZR c * nth i w 0 ^ nth i e 0%nat).
    { apply Rmult_lt_0_compat; [exact C|apply pow_lt, X]. }
    lra.
  - assert (T := IH B E). assert (0 <= IZR c * monomial_value e w) by (apply Rmult_le_pos; assumption).
    lra.
Qed.
