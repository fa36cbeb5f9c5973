(* SPDX-FileCopyrightText: the tensortopo authors
   SPDX-License-Identifier: Apache-2.0

   The kernel of `common/Kernel.v` as an OCaml program. Integers become machine integers: those of
   the comparison are so small that nothing overflows. *)
From TensorTopo Require Import Polynomials Kernel SideOfLevel.
From Coq Require Extraction ExtrOcamlBasic ExtrOcamlNatInt ExtrOcamlZInt.
Extraction "kernel.ml" norm_form det_form increase_form level_form lies_above lies_below.
