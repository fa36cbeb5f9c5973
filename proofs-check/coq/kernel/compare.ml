(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   compare COUNT: reads COUNT lines of kernel_values, computes the same forms with the program that
   Coq extracted, and fails if a coefficient differs or is missing.
   A line: V, the 6 entries of each of V corners, V entries of a direction, num, den, the
   coefficients of the four forms in the order of the checker's table of monomials, and whether the
   checker's rule says that all of the simplex is above the level num / den, and that it is below.
   (The extracted rule may say so where the checker, which wants more coefficients to be positive,
   does not.) *)
let rec times n f = if n = 0 then [] else let x = f () in x :: times (n - 1) f

(* Monomials of degree d in v variables by the number with the exponents as digits, least first. *)
let table v d =
  let rec digits n k = if k = 0 then [] else (n mod (d + 1)) :: digits (n / (d + 1)) (k - 1) in
  let rec power n = if n = 0 then 1 else (d + 1) * power (n - 1) in
  List.filter (fun e -> List.fold_left ( + ) 0 e = d) (List.init (power v) (fun n -> digits n v))

let tables = Hashtbl.create 16
let table v d =
  try Hashtbl.find tables (v, d)
  with Not_found -> let t = table v d in Hashtbl.add tables (v, d) t; t

let compared = ref 0 and nonzero = ref 0 and sides = ref 0

let check next v name d form =
  let monomials = table v d in
  let known = List.filter (fun (c, _) -> c <> 0) form in
  let used = ref 0 in
  List.iter (fun e ->
    let ours = try fst (List.find (fun (_, f) -> f = e) known) with Not_found -> 0 in
    let theirs = next () in
    incr compared;
    if ours <> 0 then (incr nonzero; incr used);
    if ours <> theirs then (Printf.printf "%s of V = %d: Coq %d, checker %d\n" name v ours theirs; exit 1))
    monomials;
  if !used <> List.length known then (Printf.printf "%s of V = %d: other monomials\n" name v; exit 1)

let () =
  let wanted = int_of_string Sys.argv.(1) and lines = ref 0 in
  (try
    while true do
      let words = ref (String.split_on_char ' ' (input_line stdin)) in
      let next () = match !words with
        | w :: rest -> words := rest; int_of_string w
        | [] -> failwith "a line is too short" in
      let v = next () in
      let corners = times v (fun () ->
        match times 6 next with
        | [ c11; c22; c33; c23; c13; c12 ] -> { Kernel.c11; c22; c33; c23; c13; c12 }
        | _ -> assert false) in
      let d = times v next in
      let num = next () in
      let den = next () in
      check next v "norm" 2 (Kernel.norm_form corners);
      check next v "determinant" 3 (Kernel.det_form corners);
      check next v "increase" 4 (Kernel.increase_form corners d);
      check next v "level" 6 (Kernel.level_form num den corners);
      let says name theirs ours =
        if theirs = 1 then (
          incr sides;
          if not ours then (Printf.printf "%s of V = %d: the checker says so only\n" name v; exit 1)) in
      let above = next () in
      let below = next () in
      says "above" above (Kernel.lies_above v num den corners);
      says "below" below (Kernel.lies_below v num den corners);
      if !words <> [] then failwith "a line is too long";
      incr lines
    done
  with End_of_file -> ());
  Printf.printf "%d simplices, %d coefficients, %d of them not 0: all equal; %d sides: all right\n"
    !lines !compared !nonzero !sides;
  if !lines <> wanted || !nonzero * 2 < !compared || !sides * 50 < wanted then exit 1
