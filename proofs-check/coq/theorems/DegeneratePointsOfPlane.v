(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   Every plane, the one at infinity included, holds a degenerate tensor; at least two different
   ones unless the two tensors N1, N2 across the plane map a common vector to zero; and then, if
   they are independent, exactly one. The degenerate tensors across N1 and N2 are the multiples of
   e e^T - I/3 for the common zeros e of the two quadratic forms. From one zero e a second one is
   found by eliminating the coordinate along e, which leaves a cubic. *)
From TensorTopo Require Import Tensors Frames DegenerateTensors SpectralTheorem ModeRange
  CommonZeros.
Require Import Reals Psatz Ring Field.
Open Scope R_scope.

Definition degenerate_at e := add (dyad e) (scale (- / 3) identity).

Lemma inner_degenerate_at n e : trace n = 0 -> inner n (degenerate_at e) = form n e e.
Proof.
  intros T. unfold degenerate_at. rewrite inner_sym, inner_add, inner_scale, inner_dyad.
  replace (inner identity n) with (trace n) by (unfold inner, identity, trace; cbn; ring).
  rewrite T. ring.
Qed.

(* Degenerate traceless tensors are multiples of e e^T - I/3. *)
Lemma degenerate_iff t : t <> zero -> trace t = 0 ->
  (degenerate t <-> exists k e, k <> 0 /\ dot e e = 1 /\ t = scale k (degenerate_at e)).
Proof.
  intros Z T. split.
  - intros [a [b [u [U E]]]]. exists b, u.
    assert (S : 3 * a + b = 0).
    { rewrite E, trace_add, !trace_scale, trace_dyad, U in T. unfold trace, identity in T. cbn in T. lra. }
    assert (A : a = b * - / 3) by lra.
    assert (F : t = scale b (degenerate_at u)) by (rewrite E, A; unfold degenerate_at; clear; tensor_ring).
    split; [|auto]. intros B. apply Z. rewrite F, B. clear. tensor_ring.
  - intros [k [e [_ [U E]]]]. exists (k * - / 3), k, e. split; [exact U|]. rewrite E.
    unfold degenerate_at. clear. tensor_ring.
Qed.

Definition in_plane n1 n2 t := inner n1 t = 0 /\ inner n2 t = 0 /\ trace t = 0.

Theorem plane_has_degenerate_point n1 n2 : trace n1 = 0 -> trace n2 = 0 ->
  exists t, t <> zero /\ in_plane n1 n2 t /\ degenerate t.
Proof.
  intros T1 T2. destruct (common_zero n1 n2 T1 T2) as [e [U [Z1 Z2]]].
  assert (Tr : trace (degenerate_at e) = 0).
  { unfold degenerate_at. rewrite trace_add, trace_scale, trace_dyad, U. unfold trace, identity. cbn. field. }
  assert (Nz : degenerate_at e <> zero).
  { intros H. assert (F := f_equal (fun t => form t e e) H). cbv beta in F. unfold degenerate_at in F.
    rewrite form_add, form_scale, form_dyad, U in F.
    replace (form identity e e) with (dot e e) in F by (clear; coordinates; ring).
    replace (form zero e e) with 0 in F by (clear; coordinates; ring). rewrite U in F. lra. }
  exists (degenerate_at e). split; [exact Nz|]. split; [split; [|split]|].
  - rewrite inner_degenerate_at; assumption.
  - rewrite inner_degenerate_at; assumption.
  - exact Tr.
  - apply degenerate_iff; auto. exists 1, e. split; [lra|]. split; [exact U|]. symmetry. apply scale_one.
Qed.

(* A binary cubic form has a root. *)
Lemma binary_cubic_root a b c d : exists y z, (y <> 0 \/ z <> 0) /\
  a * (y * y * y) + b * (y * y * z) + c * (y * z * z) + d * (z * z * z) = 0.
Proof.
  destruct (Req_dec a 0) as [A|A].
  - exists 1, 0. split; [left; lra|]. rewrite A. ring.
  - destruct (cubic_root (b / a) (c / a) (d / a)) as [x X]. exists x, 1. split; [right; lra|].
    transitivity (a * (x * x * x + b / a * (x * x) + c / a * x + d / a)); [field; exact A|rewrite X; ring].
Qed.

(* The form of a traceless tensor in a frame whose first vector is a zero. *)
Lemma form_at_zero n e f g x y z : orthonormal e f g -> trace n = 0 -> form n e e = 0 ->
  let p := combine x y z e f g in form n p p
  = 2 * x * (form n e f * y + form n e g * z) + (form n f f * (y * y - z * z) + 2 * form n f g * (y * z)).
Proof.
  intros O T Z p. unfold p. rewrite form_in_frame, Z.
  rewrite <- (trace_in_frame e f g n O) in T. unfold trace, in_frame in T. cbn in T. rewrite Z in T.
  replace (form n g g) with (- form n f f) by lra. ring.
Qed.

(* A zero that is not a multiple of e, in coordinates. *)
Lemma second_zero l1 m1 b1 c1 l2 m2 b2 c2 :
  l1 <> 0 \/ m1 <> 0 \/ l2 <> 0 \/ m2 <> 0 -> exists x y z, (y <> 0 \/ z <> 0) /\
  2 * x * (l1 * y + m1 * z) + (b1 * (y * y - z * z) + 2 * c1 * (y * z)) = 0 /\
  2 * x * (l2 * y + m2 * z) + (b2 * (y * y - z * z) + 2 * c2 * (y * z)) = 0.
Proof.
  intros N.
  (* solving one equation for x, the other follows where the eliminant vanishes *)
  assert (Solve : forall L1 Q1 L2 Q2, L1 <> 0 \/ L2 <> 0 -> L2 * Q1 - L1 * Q2 = 0 ->
    exists x, 2 * x * L1 + Q1 = 0 /\ 2 * x * L2 + Q2 = 0).
  { intros L1 Q1 L2 Q2 [H|H] E.
    - exists (- Q1 / (2 * L1)). split; [field; exact H|].
      apply (Rmult_eq_reg_l L1); [|exact H]. transitivity (- (L2 * Q1 - L1 * Q2)); [field; exact H|rewrite E; ring].
    - exists (- Q2 / (2 * L2)). split; [|field; exact H].
      apply (Rmult_eq_reg_l L2); [|exact H]. transitivity (L2 * Q1 - L1 * Q2); [field; exact H|rewrite E; ring]. }
  destruct (binary_cubic_root (l2 * b1 - l1 * b2) (m2 * b1 - m1 * b2 + 2 * (l2 * c1 - l1 * c2))
    (- (l2 * b1 - l1 * b2) + 2 * (m2 * c1 - m1 * c2)) (- (m2 * b1 - m1 * b2))) as [y [z [YZ R]]].
  destruct (Req_dec (l1 * y + m1 * z) 0) as [Z1|Z1]; [destruct (Req_dec (l2 * y + m2 * z) 0) as [Z2|Z2]|].
  2,3: destruct (Solve (l1 * y + m1 * z) (b1 * (y * y - z * z) + 2 * c1 * (y * z))
      (l2 * y + m2 * z) (b2 * (y * y - z * z) + 2 * c2 * (y * z))) as [x [X1 X2]];
    [auto|rewrite <- R; ring|exists x, y, z; auto].
  (* both linear forms vanish at (y, z), so they are multiples k1, k2 of (-z, y); a zero of
     k2 q1 - k1 q2, which is traceless, that is not parallel to (y, z): one of two orthogonal ones *)
  assert (D : 0 < y * y + z * z).
  { assert (Y := square_nonneg y). assert (W := square_nonneg z).
    destruct YZ as [H|H]; assert (Q := square_pos _ H); lra. }
  set (s := y * y + z * z) in *.
  set (k1 := (m1 * y - l1 * z) / s). set (k2 := (m2 * y - l2 * z) / s).
  assert (E1 : l1 = - k1 * z /\ m1 = k1 * y).
  { unfold k1. split; apply (Rmult_eq_reg_r s); try lra.
    - transitivity (y * (l1 * y + m1 * z) - (m1 * y - l1 * z) * z); [unfold s; ring|rewrite Z1; field; lra].
    - transitivity (z * (l1 * y + m1 * z) + (m1 * y - l1 * z) * y); [unfold s; ring|rewrite Z1; field; lra]. }
  assert (E2 : l2 = - k2 * z /\ m2 = k2 * y).
  { unfold k2. split; apply (Rmult_eq_reg_r s); try lra.
    - transitivity (y * (l2 * y + m2 * z) - (m2 * y - l2 * z) * z); [unfold s; ring|rewrite Z2; field; lra].
    - transitivity (z * (l2 * y + m2 * z) + (m2 * y - l2 * z) * y); [unfold s; ring|rewrite Z2; field; lra]. }
  destruct E1 as [A1 B1]. destruct E2 as [A2 B2]. clearbody k1 k2.
  assert (K : k1 <> 0 \/ k2 <> 0).
  { destruct (Req_dec k1 0) as [H|H]; [|auto]. destruct (Req_dec k2 0) as [H'|H']; [|auto]. exfalso.
    rewrite H in *. rewrite H' in *. destruct N as [N|[N|[N|N]]]; apply N; [rewrite A1|rewrite B1|rewrite A2|rewrite B2]; ring. }
  set (b := k2 * b1 - k1 * b2). set (c := k2 * c1 - k1 * c2).
  (* a zero (y', z') of b (y^2 - z^2) + 2 c y z with z' y - y' z <> 0 *)
  assert (W : exists y' z', y * z' - z * y' <> 0 /\ b * (y' * y' - z' * z') + 2 * c * (y' * z') = 0).
  { assert (V : exists p q, (p <> 0 \/ q <> 0) /\ b * (p * p - q * q) + 2 * c * (p * q) = 0).
    { destruct (Req_dec b 0) as [B|B]; [exists 1, 0; split; [left; lra|rewrite B; ring]|].
      set (h := sqrt (c * c + b * b)). assert (CC := square_nonneg c). assert (BB := square_nonneg b).
      assert (H : h * h = c * c + b * b) by (apply sqrt_sqrt; lra).
      exists (h - c), b. split; [right; exact B|]. transitivity (b * (h * h - (c * c + b * b))); [ring|rewrite H; ring]. }
    destruct V as [p [q [PQ V]]]. destruct (Req_dec (y * q - z * p) 0) as [H|H]; [|exists p, q; auto].
    exists (- q), p. split.
    - intros G. assert (P : s * (p * p + q * q) = 0).
      { transitivity ((y * q - z * p) * (y * q - z * p) + (y * p - z * - q) * (y * p - z * - q)); [unfold s; ring|rewrite H, G; ring]. }
      assert (X := square_nonneg p). assert (Y := square_nonneg q).
      assert (0 < p * p + q * q) by (destruct PQ as [J|J]; assert (U := square_pos _ J); lra).
      assert (0 < s * (p * p + q * q)) by (apply Rmult_lt_0_compat; assumption). lra.
    - transitivity (- (b * (p * p - q * q) + 2 * c * (p * q))); [ring|rewrite V; ring]. }
  destruct W as [y' [z' [T V]]].
  destruct (Solve (l1 * y' + m1 * z') (b1 * (y' * y' - z' * z') + 2 * c1 * (y' * z'))
    (l2 * y' + m2 * z') (b2 * (y' * y' - z' * z') + 2 * c2 * (y' * z'))) as [x [X1 X2]].
  - rewrite A1, B1, A2, B2. destruct K as [K|K]; [left|right].
    + replace (- k1 * z * y' + k1 * y * z') with (k1 * (y * z' - z * y')) by ring.
      apply Rmult_integral_contrapositive_currified; assumption.
    + replace (- k2 * z * y' + k2 * y * z') with (k2 * (y * z' - z * y')) by ring.
      apply Rmult_integral_contrapositive_currified; assumption.
  - rewrite A1, B1, A2, B2. unfold b, c in V.
    transitivity ((y * z' - z * y') * ((k2 * b1 - k1 * b2) * (y' * y' - z' * z') + 2 * (k2 * c1 - k1 * c2) * (y' * z'))); [ring|rewrite V; ring].
  - exists x, y', z'. split; [|auto]. destruct (Req_dec y' 0) as [H|H]; [|auto].
    destruct (Req_dec z' 0) as [H'|H']; [|auto]. exfalso. apply T. rewrite H, H'. ring.
Qed.

Definition parallel a b := cross a b = zero_vector.

(* N1 and N2 map a vector to zero together. *)
Definition common_kernel n1 n2 :=
  exists e, dot e e = 1 /\ apply n1 e = zero_vector /\ apply n2 e = zero_vector.

Lemma apply_zero n e f g : orthonormal e f g ->
  form n e e = 0 -> form n e f = 0 -> form n e g = 0 -> apply n e = zero_vector.
Proof.
  intros O A B C. apply (perpendicular_to_frame e f g _ O); rewrite dot_sym.
  - exact A.
  - rewrite <- B. apply form_sym.
  - rewrite <- C. apply form_sym.
Qed.

Theorem two_degenerate_points n1 n2 : trace n1 = 0 -> trace n2 = 0 -> ~ common_kernel n1 n2 ->
  exists e e', dot e e = 1 /\ dot e' e' = 1 /\ ~ parallel e e' /\
    in_plane n1 n2 (degenerate_at e) /\ in_plane n1 n2 (degenerate_at e').
Proof.
  intros T1 T2 NK. destruct (common_zero n1 n2 T1 T2) as [e [U [Z1 Z2]]].
  destruct (frame_from_unit e U) as [f [g O]].
  assert (N : form n1 e f <> 0 \/ form n1 e g <> 0 \/ form n2 e f <> 0 \/ form n2 e g <> 0).
  { destruct (Req_dec (form n1 e f) 0) as [A|A]; [|auto]. destruct (Req_dec (form n1 e g) 0) as [B|B]; [|auto].
    destruct (Req_dec (form n2 e f) 0) as [C|C]; [|auto]. destruct (Req_dec (form n2 e g) 0) as [D|D]; [|auto].
    exfalso. apply NK. exists e. split; [exact U|]. split; apply (apply_zero _ e f g O); assumption. }
  destruct (second_zero _ _ (form n1 f f) (form n1 f g) _ _ (form n2 f f) (form n2 f g) N) as [x [y [z [YZ [E1 E2]]]]].
  set (p := combine x y z e f g).
  assert (P1 : form n1 p p = 0) by (unfold p; rewrite (form_at_zero n1 e f g x y z O T1 Z1); exact E1).
  assert (P2 : form n2 p p = 0) by (unfold p; rewrite (form_at_zero n2 e f g x y z O T2 Z2); exact E2).
  assert (CR : cross e p <> zero_vector).
  { intros H. assert (L : dot (cross e p) (cross e p) = dot e e * dot p p - dot e p * dot e p) by (generalize p; clear; intros p; coordinates; ring).
    rewrite H, U in L. unfold p in L. rewrite (dot_in_frame x y z e f g O), (dot_sym e), dot_combine in L.
    rewrite U, (dot_sym f e), (dot_sym g e), (perp_12 _ _ _ O), (perp_13 _ _ _ O) in L.
    unfold dot, zero_vector in L. cbn in L. assert (Y := square_nonneg y). assert (W := square_nonneg z).
    destruct YZ as [K|K]; assert (Q := square_pos _ K); lra. }
  assert (PN : p <> zero_vector) by (intros H; apply CR; rewrite H; clear; vector_ring).
  destruct (unit_vector p PN) as [k [K Uk]].
  assert (Tr : forall a, dot a a = 1 -> trace (degenerate_at a) = 0).
  { intros a A. unfold degenerate_at. rewrite trace_add, trace_scale, trace_dyad, A. unfold trace, identity. cbn. field. }
  assert (In : forall a, dot a a = 1 -> form n1 a a = 0 -> form n2 a a = 0 -> in_plane n1 n2 (degenerate_at a)).
  { intros a A B C. split; [|split]; [rewrite inner_degenerate_at; assumption|rewrite inner_degenerate_at; assumption|apply Tr, A]. }
  exists e, (scale_vector k p). split; [exact U|]. split; [exact Uk|]. split; [|split].
  - intros H. apply CR. assert (S : cross e (scale_vector k p) = scale_vector k (cross e p)) by (generalize p; clear; intros p; vector_ring).
    unfold parallel in H. rewrite S in H. generalize (cross e p), H. clear - K. intros c H.
    assert (X := f_equal vx H). assert (Y := f_equal vy H). assert (Z := f_equal vz H). cbn in X, Y, Z.
    apply vector_eq; cbn; [destruct (Rmult_integral _ _ X)|destruct (Rmult_integral _ _ Y)|destruct (Rmult_integral _ _ Z)]; auto; contradiction.
  - apply In; assumption.
  - apply In; [exact Uk|rewrite form_scale_vector, P1; ring|rewrite form_scale_vector, P2; ring].
Qed.

Lemma combined a b p1 q1 p2 q2 e f g :
  add (scale a (add (spectral 0 p1 (- p1) e f g) (add (scale 0 (sym_dyad e f))
        (add (scale q1 (sym_dyad f g)) (scale 0 (sym_dyad e g))))))
      (scale b (add (spectral 0 p2 (- p2) e f g) (add (scale 0 (sym_dyad e f))
        (add (scale q2 (sym_dyad f g)) (scale 0 (sym_dyad e g))))))
  = add (spectral 0 (a * p1 + b * p2) (- (a * p1 + b * p2)) e f g)
      (scale (a * q1 + b * q2) (sym_dyad f g)).
Proof.
  apply tensor_by_form. intros x y.
  repeat rewrite ?form_add, ?form_scale, ?form_spectral. ring.
Qed.

(* With a common kernel, independent tensors leave one degenerate point only. *)
Theorem one_degenerate_point n1 n2 e : trace n1 = 0 -> trace n2 = 0 -> dot e e = 1 ->
  apply n1 e = zero_vector -> apply n2 e = zero_vector ->
  (forall a b, add (scale a n1) (scale b n2) = zero -> a = 0 /\ b = 0) ->
  forall t, t <> zero -> in_plane n1 n2 t -> degenerate t -> exists k, t = scale k (degenerate_at e).
Proof.
  intros T1 T2 U K1 K2 I t Z [P1 [P2 T]] D. apply degenerate_iff in D; [|exact Z|exact T].
  destruct D as [k [p [K [Up E]]]]. exists k. rewrite E in *. f_equal.
  assert (F : forall n, trace n = 0 -> inner n (scale k (degenerate_at p)) = 0 -> form n p p = 0).
  { intros n Tn H. rewrite inner_sym, inner_scale, inner_sym, (inner_degenerate_at n p Tn) in H.
    destruct (Rmult_integral _ _ H); [contradiction|assumption]. }
  assert (F1 := F n1 T1 P1). assert (F2 := F n2 T2 P2).
  destruct (frame_from_unit e U) as [f [g O]].
  assert (Y : forall n a, apply n e = zero_vector -> form n e a = 0).
  { intros n a H. rewrite form_sym. unfold form. rewrite H. unfold dot, zero_vector. cbn. ring. }
  set (x := dot p e). set (y := dot p f). set (z := dot p g).
  assert (R : p = combine x y z e f g) by (apply resolve; exact O).
  rewrite R in F1, F2.
  rewrite (form_at_zero n1 e f g x y z O T1 (Y n1 e K1)), !(Y n1 _ K1) in F1.
  rewrite (form_at_zero n2 e f g x y z O T2 (Y n2 e K2)), !(Y n2 _ K2) in F2.
  set (b1 := form n1 f f) in *. set (c1 := form n1 f g) in *. set (b2 := form n2 f f) in *. set (c2 := form n2 f g) in *.
  assert (W : forall n, trace n = 0 -> apply n e = zero_vector ->
    in_frame e f g n = Tensor 0 (form n f f) (- form n f f) 0 (form n f g) 0).
  { intros n Tn H. unfold in_frame. rewrite !(Y n _ H).
    rewrite <- (trace_in_frame e f g n O) in Tn. unfold trace, in_frame in Tn. cbn in Tn. rewrite (Y n e H) in Tn.
    f_equal. lra. }
  assert (Det : b1 * c2 - b2 * c1 <> 0).
  { intros H.
    assert (V : forall a b, a * b1 + b * b2 = 0 -> a * c1 + b * c2 = 0 -> a = 0 /\ b = 0).
    { intros a b A B. apply I. rewrite <- (from_in_frame e f g n1 O), <- (from_in_frame e f g n2 O).
      rewrite (W n1 T1 K1), (W n2 T2 K2). fold b1 c1 b2 c2. unfold from_frame. cbn [xx yy zz xy yz xz].
      transitivity (add (spectral 0 (a * b1 + b * b2) (- (a * b1 + b * b2)) e f g) (scale (a * c1 + b * c2) (sym_dyad f g))).
      - apply combined.
      - rewrite A, B. apply tensor_by_form. intros p' q'.
        rewrite form_add, form_scale, form_spectral. unfold form, dot, apply, zero. cbn. ring. }
    destruct (V b2 (- b1)) as [A1 A2]; [ring|lra|]. destruct (V c2 (- c1)) as [B1 B2]; [lra|ring|].
    destruct (V 1 0); [lra|lra|]. lra. }
  set (A := y * y - z * z) in *. set (B := y * z) in *.
  assert (GA : (b1 * c2 - b2 * c1) * A = 0).
  { transitivity (c2 * (2 * x * (0 * y + 0 * z) + (b1 * A + 2 * c1 * B)) - c1 * (2 * x * (0 * y + 0 * z) + (b2 * A + 2 * c2 * B))); [ring|].
    rewrite F1, F2. ring. }
  assert (GB : (b1 * c2 - b2 * c1) * (2 * B) = 0).
  { transitivity (b1 * (2 * x * (0 * y + 0 * z) + (b2 * A + 2 * c2 * B)) - b2 * (2 * x * (0 * y + 0 * z) + (b1 * A + 2 * c1 * B))); [ring|].
    rewrite F1, F2. ring. }
  destruct (Rmult_integral _ _ GA) as [|A0]; [contradiction|]. destruct (Rmult_integral _ _ GB) as [|B0]; [contradiction|].
  assert (B1 : y * z = 0) by (unfold B in B0; lra). unfold A in A0.
  assert (YZ : y = 0 /\ z = 0).
  { destruct (Rmult_integral _ _ B1) as [H|H]; rewrite H in A0; split; auto; apply square_zero; lra. }
  destruct YZ as [Y0 Z0]. rewrite Y0, Z0 in R.
  assert (X1 : x * x = 1) by (rewrite R, (dot_in_frame x 0 0 e f g O) in Up; lra).
  unfold degenerate_at. f_equal. rewrite R.
  rewrite <- (scale_one (dyad e)), <- X1. apply tensor_by_form. intros p' q'.
  rewrite form_scale, !form_dyad, !dot_combine. ring.
Qed.
