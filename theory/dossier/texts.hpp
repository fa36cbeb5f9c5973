// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

// The parts of the page on the statements that are the same whatever the statements are.
namespace tensortopo::theory {

inline constexpr std::string_view kIntroduction = R"(# theory

What a paper says about mode surfaces, whether it is true, under which hypotheses, what is true instead where it is not, and an exact
witness where it fails. *The paper* is Qu, Roy, Zhang and Zhang, "Mode Surfaces of Symmetric Tensor Fields: Topological Analysis and
Seamless Extraction" (2020). Its main results stand.

This page is written by a program from the statements in `src`. A build fails if the two differ; `cmake --build BUILD --target theory_readme`
writes it again.

**Words.** *T* is a symmetric 3 x 3 tensor without trace. Its *mode* is 3 sqrt(6) det(T) / |T|^3, a number from -1 to 1. A *linear field* gives each point
(x, y, z) of space the tensor T0 + x Tx + y Ty + z Tz. Its *span* is the set of all combinations of these four tensors; its *rank* is the dimension of
the span. At rank 4 one tensor of norm one, up to its sign, is orthogonal to the span: the *characteristic tensor*, of eigenvalues *l1 >= l2 >= l3*. Its sign is chosen so
that its determinant is not positive. The *generalized mode mu surface* holds the points of mode mu and of mode -mu. A mode has a *parameter* s: mu = s (9 - s^2) / (3 + s^2)^(3/2). It
runs from 0 to 1 as mu does, and often is rational where mu is not. *In projective space* means with the points at infinity. Tensors are listed as
[xx, yy, zz, xy, yz, xz]. `notation.md` has every symbol and its name in code.

## How a statement is established

Four ways, of different weight. Each statement says which of them it has.

1. **Coq.** A theorem that Coq 8.16 has checked, for all real numbers (`proofs-check/coq`).
2. **Exact steps.** Identities, inequalities and counts over the rational numbers, proved by normal forms of polynomials, sums of squares and Sturm sequences
   (`proofs-check/STEPS.md`). They hold for all values of their variables. Between steps there can be inferences in words.
3. **Tried.** The statement is a program. `tensortopo verify` runs it on linear fields with rational entries, random and special ones, or on the tetrahedra of a mesh
   (`--input MESH`). Over `rational`, the default, every sign is certain: exact, or of a number with an error bound that it exceeds.
   Passing is evidence, not proof.
4. **A reader.** An inference in words that no program has checked. These are listed, statement by statement.

*Holds*: every field tried that meets the hypotheses has passed. *Corrected*: the paper's wording is violated at a witness, which each run checks again, and ours has passed.
`verify` counts *configurations*: fields that differ by more than a rotation and a scaling in what the check looks at. A statement tried in fewer than 20 says so in its row.

**Would a wrong claim be noticed?** The tests change each number of each claim by one, up and down, and want a violation. Where a hypothesis is listed as *needed*,
they drop it, and want a violation at the field given. Every statement has one, or says what its hypotheses are for. `tests/theory` also keeps fields that a search found (`theory/search`): it looks for violations of
each corrected statement among special fields, and found none.
)";

inline constexpr std::string_view kErrata = R"(
## What to know when you build on the paper

- **Degree-six equation.** As printed it has the mode *at the point*, so every tensor satisfies it. The constant mode is meant. The mode itself is no polynomial: its square is a
  quotient of two of degree six.
- **Characteristic tensor.** It exists always. It is unique if the four tensors are independent and its determinant is not 0.
- **Theorem 1.** As many points as A(v) has real eigenvalues: with points at infinity, and unless A(v) is a multiple of the identity. In the proof A(-v) is the
  adjugate of A(v), not its transpose; the conclusion stands.
- **Theorem 2** is printed with the projected tensor, which maps v to zero. With the characteristic tensor itself, as in the proof, it is true. The boundary has degree four in v, not six.
- **The grey region.** Its vectors are the medium eigenvectors of no tensor of mode mu or -mu, as the paper says, but they can be those of tensors closer to neutral.
- **Corollary 3.** The complex domains are nested, and properly unless the characteristic determinant is 0.
- **Lemma 4.** Alpha is a parameter on one closed interval, if l1 and l2 differ.
- **Theorem 5.** Torus and double torus exist in projective space. In space no component of a mode surface of a linear field of rank 4 is closed: each runs to infinity. The same holds for the circle
  of degenerate points. The neutral surface is one-sided in projective space only: every surface that one can extract is orientable.
- **Theorem 6.** At most four extrema in a plane, if the critical points are isolated. If moreover they are simple, also over the complex numbers, then there are, with the points at infinity, two
  extrema and one saddle, three and two, or four and three; two or four of the extrema are degenerate points. Every plane has a degenerate point, and two different ones
  unless the two tensors orthogonal to it map a common vector to 0. If they are not simple there can be one or three; in a plane of symmetry they can fill a conic. In the chart w = 1 the equations have seven solutions, not nine, and true critical points with w = 0 are lost.
- **Loops inside.** The boundary of the complex domain can run inside a tetrahedron without meeting a face. The surface then has an Euler characteristic 2 less than face curves show: a handle more, or a
  tube that joins two sheets. At most one of the two loops can be inside.
- **Crossings of the boundary.** The product of medium eigenvectors shows them only where these turn by less than a right angle. On neutral surfaces the lift to the sphere jumps too, at the singular lines.
- **Shared faces.** Two fields that share a face have different boundary points on it, so both must be put on the shared curve.
- **Quad parameterization.** One letter of the print and a normalization repair it. Sphero-conal coordinates are unit vectors as they stand, and in them the boundary is a straight segment.
- **Stereographic projection** keeps all Delaunay triangles but those with the pole in their empty circle.
)";

inline constexpr std::string_view kExtraction = R"(
### Extraction

What the extractor and the checker of certificates rest on beyond the statements, for a reader:

- *Coefficients.* Where all Bernstein coefficients of a form have one strict sign, so has the form on the simplex. The coefficients are exact or enclosed. In Coq: `checker-kernel`, for the checker's integers.
- *A monotone simplex.* The mode's derivative along a constant direction d of weights has coefficients of one strict sign; or, for one level mu, that of Q - mu P sqrt(P/54) has, both with a linear form below
  the root and with one above it in the root's place. Then the level is a graph across d: each line along d meets it once or not at all, as
  the modes of its ends on the boundary say, and the point depends continuously on the line. In Coq: `monotone-simplex`. Left to a reader: so nothing closed fits in, and the level is known from the boundary.
- *From simplices to the tetrahedron.* A level that is a graph, with known arcs on its faces, is a disc or nothing; and discs glued along arcs have the Euler characteristic, components and boundary loops that are counted.
- *Isotopy.* A vertex on the level counts as below it. The proofs hold for all levels close by, so the level an infinitesimal above is isotopic to what is counted.
- *A surface is known by its numbers.* A connected compact orientable surface is determined by its Euler characteristic and its boundary loops.
)";

inline constexpr std::string_view kClosing = R"(
## How it is made

- `random.hpp`: a generator of its own, so that a seed means the same numbers everywhere.
- `trial.hpp`: the fields. A part of them is made from a rational eigen-frame of the characteristic tensor, which makes statements
  about its eigenvalues decidable; others are neutral, planar degenerate or of a rank below 4.
- `facts.hpp`, `check.hpp`: a check states facts about numbers; the arithmetic decides them as far as it can. Numbers that belong to
  the claim are asked for one by one, so that a test can make any of them wrong.
- `statement.hpp`, `verify.hpp`: the list `statements()`, and what trying one gives.
- `search`: a program that looks for fields at which a statement fails.

To add a statement: a check in the group of `src` that it belongs to, and an entry in that group's list. If the paper's wording
fails, the entry says what is true instead and carries a function that tries the paper's wording at a witness.
)";

}  // namespace tensortopo::theory
