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
          .strata =
              "Two equal characteristic eigenvalues: the surface crosses itself along a "
              "line.",
          .check = neutral_surface_topology,
          .paper_at_witness = singular_neutral_surface,
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
          .strata = "Characteristic determinant 0: two circles that meet in a point.",
          .check = degenerate_curve_circle,
          .paper_at_witness = two_degenerate_conics};
}

Statement bifurcation() {
  return {.id = "bifurcation-topology",
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
          .strata =
              "mubar = 0: a double torus for every mu. mubar = -1: always a torus. At mu0 "
              "the surface is singular.",
          .check = bifurcation_topology,
          .paper_at_witness = torus_in_space,
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
          .strata =
              "Characteristic determinant 0: mu0 = 1. Two equal characteristic eigenvalues: "
              "mu0 = 0.",
          .check = bifurcation_surface};
}

Statement orientability() {
  return {.id = "neutral-surface-orientability",
          .paper = "Mode Surfaces Analysis, after Theorem 5",
          .claim = "Of all mode surfaces, neutral ones are those that are not orientable.",
          .hypotheses = "a field of rank 4 with three characteristic eigenvalues",
          .corrected =
              "In projective space. In space, and so in a mesh, all are orientable: a "
              "level of the mode separates larger modes from smaller ones.",
          .check = neutral_surface_orientability,
          .paper_at_witness = orientable_neutral_surface,
          .most_fields = 15};
}

Statement closed_components() {
  return {.id = "no-closed-component",
          .paper = "Extraction of Mode Surfaces, surfaces from the curves in faces",
          .claim =
              "The mode surface in a tetrahedron is found from the mode curves in its faces: "
              "no component of it avoids all of them.",
          .hypotheses = "a field of rank 3 or 4 that does not vanish in the tetrahedron; mu != 0",
          .corrected =
              "At rank 3 or 4. At a lower rank the mode can be mu in all of the "
              "tetrahedron.",
          .sharper = "A tetrahedron with no mode curve in its faces has no mode surface.",
          .strata = "Rank below 3: antiplane shear is neutral everywhere.",
          .check = no_closed_component,
          .paper_at_witness = neutral_tetrahedron,
          .most_fields = 100};
}

Statement boundary_loop() {
  return {.id = "interior-boundary-loop",
          .paper = "Mode Surface Extraction inside a Tetrahedron, boundary of the complex domain",
          .claim =
              "Points of the complex domain's boundary that the surface in a tetrahedron has "
              "are found where mode curves in its faces cross that boundary.",
          .hypotheses =
              "a field made from the eigenvectors of the trial's frame and a fixed "
              "tetrahedron",
          .corrected =
              "For mu < mu0 a whole loop of it can lie inside and meet no face: the "
              "surface in the tetrahedron then has a handle.",
          .sharper = "For mu slightly above mu0 the same tetrahedron holds a cylinder.",
          .check = interior_boundary_loop,
          .paper_at_witness = handle_in_tetrahedron,
          .most_fields = 8};
}

}  // namespace

std::vector<Statement> topology_statements() {
  return {degenerate_circle(), neutral_topology(),  bifurcation(),  critical_surface(),
          orientability(),     closed_components(), boundary_loop()};
}

}  // namespace tensortopo::theory
