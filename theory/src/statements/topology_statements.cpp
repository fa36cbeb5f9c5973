// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The topology of mode surfaces, counted on certified complexes.
#include "groups.hpp"
#include "topology/checks.hpp"

namespace tensortopo::theory {
namespace {

Statement neutral_topology() {
  return {.id = "neutral-surface-topology",
          .paper = "3D Linear Tensor Fields, last paragraph but one",
          .claim = "The neutral points of a linear field form a projective plane with a handle.",
          .hypotheses = "a field of rank 4 with three characteristic eigenvalues",
          .corrected =
              "Together with those at infinity, and if the characteristic tensor is not "
              "degenerate: then they are a connected closed surface of Euler characteristic -1.",
          .sharper = "Also where the characteristic determinant is 0.",
          .special =
              "Two equal characteristic eigenvalues: the surface crosses itself along a "
              "line.",
          .flaws = {Flaw::projective, Flaw::exceptional},
          .check = neutral_surface_topology,
          .paper_at_witness = singular_neutral_surface,
          .reader =
              "That a certified complex holds the surface up to isotopy (LevelComplex), the "
              "classification of closed surfaces, and that fields between those tried have the "
              "same topology: the neutral surface is regular as long as the characteristic tensor "
              "is not degenerate.",
          .most_fields = 30};
}

Statement degenerate_circle() {
  return {.id = "degenerate-curve-circle",
          .paper = "3D Linear Tensor Fields, last paragraph but one",
          .claim =
              "The points of mode 1 and -1 of a linear field together are homeomorphic to a "
              "circle.",
          .hypotheses = "a field of rank 4 of a characteristic determinant other than 0",
          .corrected =
              "Together with those at infinity, and if the characteristic determinant is not 0: "
              "dominant eigenvectors of degenerate tensors then form a conic with real points.",
          .special = "Characteristic determinant 0: two circles that meet in a point.",
          .flaws = {Flaw::projective, Flaw::exceptional},
          .check = degenerate_curve_circle,
          .paper_at_witness = two_degenerate_conics,
          .steps = {"degenerate-points"},
          .reader =
              "A conic of signature (2, 1) is a circle in the projective plane, and its points "
              "and the degenerate tensors of the span correspond continuously, one to one."};
}

Statement bifurcation() {
  return {
      .id = "bifurcation-topology",
      .paper = "Theorem 5",
      .claim =
          "The generalized mode mu surface of a linear field is a torus for mu > mu0 and "
          "a double torus for mu < mu0, where mu0^2 = 1 - mubar^2 and mubar is the mode "
          "of the characteristic tensor.",
      .hypotheses =
          "a field of rank 4; modes of rational parameters on either side of mu0, at "
          "some distance",
      .corrected =
          "In projective space, for 0 < mu < 1: every such surface has points at "
          "infinity, so that in space it is never closed.",
      .special =
          "mubar = 0: a double torus for every mu. mubar = -1: always a torus. At mu0 "
          "the surface is singular.",
      .flaws = {Flaw::projective},
      .check = bifurcation_topology,
      .paper_at_witness = torus_in_space,
      .steps = {"bifurcation", "edges-before-bifurcation", "edges-after-bifurcation",
                "gluing-before-bifurcation", "gluing-after-bifurcation", "saddle-in-space",
                "saddle-critical", "saddle-signature", "common-zero"},
      .reader =
          "The shape of the complex domain (arcs in octants close to loops that bound discs), "
          "the gluing along antipodes, determinant 0 and mode -1 of the characteristic tensor. "
          "Or, shorter, Morse theory on the 3-sphere of unit tensors of the span: the degenerate "
          "tensors of mode 1 and of mode -1 are a circle each (maximum and minimum, "
          "not degenerate across it); D and -D, of modes mu0 and -mu0, are the only other "
          "critical points, and at D the mode grows in one direction. So a level above mu0 is "
          "the torus around a circle, and passing D adds one handle.",
      .most_fields = 30};
}

Statement critical_surface() {
  return {.id = "bifurcation-surface",
          .paper = "Theorem 5, the surface at the bifurcation",
          .claim = "At mu0 the generalized mode surface has a point where it is no manifold.",
          .hypotheses = "a field of rank 4 with three characteristic eigenvalues other than 0",
          .sharper =
              "It is one point of projective space, at the tensor of eigenvalues l2 - l3, "
              "l3 - l1, l1 - l2 on the characteristic eigenvectors: the only critical point "
              "of the mode other than degenerate ones, and a saddle that is not "
              "degenerate. From where its mode is positive, the mode grows in one direction "
              "and falls in two.",
          .special =
              "Characteristic determinant 0: mu0 = 1. Two equal characteristic eigenvalues: "
              "mu0 = 0.",
          .check = bifurcation_surface,
          .steps = {"saddle-in-space", "saddle-critical", "commuting-critical",
                    "critical-multiplier", "saddle-signature"}};
}

Statement orientability() {
  return {.id = "neutral-surface-orientability",
          .paper = "Mode Surfaces Analysis, after Theorem 5",
          .claim = "Of all mode surfaces, neutral ones are those that are not orientable.",
          .hypotheses = "a field of rank 4 with three characteristic eigenvalues",
          .corrected =
              "In projective space. In space, and so in a mesh, all are orientable: a "
              "level of the mode separates larger modes from smaller ones.",
          .flaws = {Flaw::projective},
          .check = neutral_surface_orientability,
          .paper_at_witness = orientable_neutral_surface,
          .reader = "A surface with a side, in an orientable space, is orientable.",
          .most_fields = 24};
}

Statement closed_components() {
  return {.id = "no-closed-component",
          .paper = "Extraction of Mode Surfaces, surfaces from the curves in faces",
          .claim =
              "The mode surface in a tetrahedron is found from the mode curves in its faces: "
              "no component of it avoids all of them.",
          .hypotheses =
              "a field of rank 3 or 4 that does not vanish in the tetrahedron; mu = 0 at rank 4 "
              "only, with three characteristic eigenvalues",
          .sharper =
              "A tetrahedron with no mode curve in its faces has no mode surface. The paper's "
              "fields have rank 4; it is so at rank 3 as well.",
          .special =
              "Rank below 3, which the paper's linear independence excludes: antiplane shear is "
              "neutral everywhere, and no curves in faces bound that.",
          .check = no_closed_component,
          .needed = {{"rank 3 or 4", neutral_tetrahedron}},
          .reader =
              "That a closed surface bounds a region (Jordan and Brouwer); Coq says that a level "
              "is the frontier of none, if the characteristic determinant is not 0. Determinant "
              "0, where the degenerate points are two circles with a common point and one of them "
              "at least runs to infinity. Rank 3, where the mode is constant along lines.",
          .most_fields = 100};
}

Statement boundary_loop() {
  return {
      .id = "interior-boundary-loop",
      .paper = "Mode Surface Extraction inside a Tetrahedron, boundary of the complex domain",
      .claim =
          "Points of the complex domain's boundary that the surface in a tetrahedron has "
          "are found where mode curves in its faces cross that boundary.",
      .hypotheses =
          "characteristic eigenvalues that differ and are not 0, mu < mu0, and a tetrahedron "
          "drawn around one of the two loops and proved to hold it",
      .corrected =
          "For mu < mu0 a whole loop of it can lie inside and meet no face. The surface then "
          "has an Euler characteristic 2 less than that of the region which face curves bound on "
          "the "
          "sphere, glued along the arcs of the boundary between them: it has a handle more, or a "
          "tube joins two sheets that they show apart.",
      .sharper = "At most one of the two loops is inside, and for mu > mu0 the one loop never is.",
      .special =
          "More than one arc of the other loop is left out; so is what a budget of cells does not "
          "decide. The surface is a certified complex of discs, and whether the boundary crosses "
          "a side of a disc an odd number of times is decided by certified signs.",
      .flaws = {Flaw::substantive},
      .check = interior_boundary_loop,
      .paper_at_witness = loop_that_meets_no_face,
      .steps = {"boundary-tensor-entries", "boundary-tensor-average", "weights-of-loops",
                "loop-diagonal-sign", "loop-product-sign", "loop-in-one-sheet",
                "loop-between-sheets"},
      .reader =
          "The surface's points are the vectors of the real domain with positive weights, a "
          "part of the sphere, glued along the boundary by v -> -v (Theorem 1). A loop inside "
          "is a pair of antipodal closed curves of that part's boundary; they bound the two "
          "discs of the complex domain that face curves do not show. Without the two discs "
          "the Euler characteristic is 2 less, and gluing circles keeps it. In one sheet that "
          "is a handle, as the surface is orientable; in two it is a tube between them.",
      .most_fields = 30};
}

}  // namespace

std::vector<Statement> topology_statements() {
  return {degenerate_circle(), neutral_topology(),  bifurcation(),  critical_surface(),
          orientability(),     closed_components(), boundary_loop()};
}

}  // namespace tensortopo::theory
