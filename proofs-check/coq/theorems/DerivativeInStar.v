(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   The derivative of the mode at t towards u is a positive multiple of the inner product of the dual
   of t with u, so it is linear in u. In a mesh t is a point of a simplex, and the points of a simplex
   around it are combinations of its vertices and of others: at a point that is critical along the
   simplex only the others count. *)
From TensorTopo Require Import Tensors Mode Dual.
Require Import Reals Psatz List.
Import ListNotations.
Open Scope R_scope.

Definition derivative_towards t u l := derivable_pt_lim (fun x => mode (add t (scale x u))) 0 l.

(* The sum of weights times tensors, and of weights times numbers. *)
Fixpoint combination (l : list (R * tensor)) : tensor :=
  match l with [] => zero | (w, u) :: rest => add (scale w u) (combination rest) end.
Fixpoint weighted (f : tensor -> R) (l : list (R * tensor)) : R :=
  match l with [] => 0 | (w, u) :: rest => w * f u + weighted f rest end.

Definition traceless (p : R * tensor) := trace (snd p) = 0.

Lemma trace_of l u : Forall traceless l -> In u (map snd l) -> trace u = 0.
Proof.
  intros F H. apply in_map_iff in H. destruct H as [p [E H]]. rewrite <- E.
  exact (proj1 (Forall_forall _ _) F p H).
Qed.

Lemma trace_combination l : Forall traceless l -> trace (combination l) = 0.
Proof.
  induction 1 as [|[w u] l H _ I]; cbn [combination]; [unfold trace, zero; cbn; ring|].
  unfold traceless in H. cbn in H. rewrite trace_add, trace_scale, H, I. ring.
Qed.

Lemma inner_combination a l : inner a (combination l) = weighted (inner a) l.
Proof.
  induction l as [|[w u] l I]; cbn [combination weighted]; [unfold inner, zero; cbn; ring|].
  rewrite inner_sym, inner_add, inner_scale, (inner_sym u), (inner_sym (combination l)), I. ring.
Qed.

Lemma weighted_multiple f g k l : (forall u, In u (map snd l) -> g u = k * f u) ->
  weighted g l = k * weighted f l.
Proof.
  induction l as [|[w u] l I]; cbn; intros H; [ring|].
  rewrite (H u (or_introl eq_refl)), I by (intros v V; apply H; right; exact V). ring.
Qed.

(* A point of mode 1 or -1 has the dual zero: nothing is said of it. *)
Theorem derivative_is_inner_product t : t <> zero -> trace t = 0 ->
  exists k, 0 < k /\ forall u, trace u = 0 -> derivative_towards t u (k * inner (dual t) u).
Proof. exact (mode_gradient t). Qed.

Theorem derivative_in_star t simplex others (d : tensor -> R) : t <> zero -> trace t = 0 ->
  Forall traceless simplex -> Forall traceless others ->
  (forall u, In u (map snd simplex) -> derivative_towards t u 0) ->
  (forall u, In u (map snd others) -> derivative_towards t u (d u)) ->
  derivative_towards t (add (combination simplex) (combination others)) (weighted d others).
Proof.
  intros Z T S O Cs Co. destruct (mode_gradient t Z T) as [k [K D]].
  assert (A : weighted (inner (dual t)) simplex = 0).
  { rewrite (weighted_multiple (fun _ => 0) _ 1).
    - clear. induction simplex as [|[w u] l I]; cbn; [ring|]. assert (1 * weighted (fun _ => 0) l = 0) by exact I. lra.
    - intros u H. assert (E := uniqueness_limite _ _ _ _ (D u (trace_of _ u S H)) (Cs u H)).
      destruct (Rmult_integral _ _ E); lra. }
  assert (B : weighted d others = k * weighted (inner (dual t)) others).
  { apply weighted_multiple. intros u H. exact (uniqueness_limite _ _ _ _ (Co u H) (D u (trace_of _ u O H))). }
  assert (E := D (add (combination simplex) (combination others))).
  rewrite inner_sym, inner_add, !(inner_sym _ (dual t)), !inner_combination, A in E.
  rewrite trace_add, !trace_combination in E by assumption. rewrite B.
  replace (k * weighted (inner (dual t)) others) with (k * (0 + weighted (inner (dual t)) others)) by ring.
  apply E. ring.
Qed.
