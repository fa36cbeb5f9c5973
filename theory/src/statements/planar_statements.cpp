// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Critical points and closed curves of the mode in a plane.
#include "groups.hpp"
#include "plane/checks.hpp"

namespace tensortopo::theory {

std::vector<Statement> planar_statements() {
  const std::string theorem = "Theorem 6", section = "Mode Curve Extraction inside a Face";
  const std::string apart =
      "three independent tensors; the critical points, complex ones and those at infinity "
      "included, are apart from each other";
  return {
      {.id = "planar-extrema",
       .paper = theorem,
       .claim = "The mode has at most four extrema in a plane.",
       .hypotheses = apart,
       .corrected = "If its critical points are isolated.",
       .sharper =
           "With the points at infinity there are two extrema and one saddle, three and two, "
           "or four and three. All degenerate points are among the extrema, and at most one "
           "other point.",
       .special = "Tensors with a common eigenvector: the degenerate points fill a conic, and the "
                  "mode is extremal all along it.",
       .flaws = {Flaw::exceptional},
       .check = check_planar_extrema(),
       .paper_at_witness = extrema_along_a_circle,
       .steps = {"at-most-four", "numbers-of-extrema", "solutions-on-sphere"},
       .reader = "Bezout's theorem and Morse theory on the projective plane, for the numbers; that "
                 "simple solutions are critical points that are not degenerate.",
       .most_fields = 200},
      {.id = "planar-critical-pairs",
       .paper = theorem + ", proof; " + section,
       .claim =
           "On the sphere of unit tensors of a plane the mode has at most seven antipodal pairs "
           "of critical points; four are degenerate, and a cubic gives the others.",
       .hypotheses = apart + "; tr N^2 is not 0 at a complex zero of the cubic",
       .corrected = "Exactly seven, four of them degenerate, counted over the complex numbers, if "
                    "the critical points are isolated.",
       .sharper =
           "Two or four of the degenerate ones are real; with two of them one or three of the "
           "others, with four all three.",
       .special = "Tensors with a common eigenvector: a conic of critical points.",
       .flaws = {Flaw::exceptional},
       .check = check_planar_pairs(),
       .paper_at_witness = critical_points_along_a_circle,
       .steps = {"solutions-on-sphere", "solutions-in-chart", "degenerate-solutions",
                 "complement-pencil"},
       .reader = "Bezout's theorem; that four and three, counted in an example, are the numbers "
                 "wherever the points are apart.",
       .most_fields = 200},
      {.id = "plane-meets-degenerate-curve",
       .paper = "none (the extrema that Theorem 6 counts exist)",
       .claim = "Every plane contains a degenerate point, at infinity perhaps.",
       .hypotheses = "three independent tensors; the degenerate points, complex ones included, are "
                     "apart from each other",
       .sharper = "Two different ones, unless the two tensors orthogonal to the plane map a common "
                  "vector to 0: then there is exactly one. Two or four if they are simple, that "
                  "is apart over the complex numbers: four if three neutral tensors are orthogonal "
                  "to the plane, two if one is. If they are not simple there can be three.",
       .special = "Tensors with a common eigenvector: a conic of degenerate points.",
       .check = check_degenerate_points(),
       .needed = {{"simple degenerate points, for two or four", three_degenerate_points},
                  {"no common kernel of the tensors orthogonal to the plane, for two",
                   one_degenerate_point}},
       .steps = {"common-zero", "degenerate-points", "numbers-of-extrema"}},
      {.id = "complement-pencil",
       .paper = "none (a cubic instead of the equations of Theorem 6)",
       .claim =
           "Let N be orthogonal to a plane. If T = N^2 - (|N|^2 / 3) I - (tr N^3 / |N|^2) N is "
           "in the plane then it is critical there, and mode(T)^2 + mode(N)^2 = 1. All "
           "non-degenerate critical points are such tensors T, or neutral with the dominant "
           "eigenvector of a degenerate N as their kernel.",
       .hypotheses = "N and T rational; a plane that contains T",
       .special = "Degenerate N: T is 0, and N is a zero of the cubic whatever the plane is.",
       .check = check_complement_pencil(),
       .steps = {"critical-in-plane", "critical-multiplier", "complement-pencil"}},
      {.id = "planar-redundancy",
       .paper = theorem + ", proof: the third equation",
       .claim = "Where w and h are not 0, the third equation follows from the other two.",
       .hypotheses = "any three tensors",
       .sharper = "Wherever w is not 0: w times the third is a combination of the other two.",
       .special = "At w = 0 the two say that h = 0, and the third need not hold.",
       .check = check_redundancy(),
       .steps = {"third-equation", "solutions-without-w"}},
      {.id = "planar-spurious-solutions",
       .paper = section + ", equations in u / w and v / w",
       .claim = "With w = 1 the system has nine solutions, two of which are spurious; the gradient "
                "of the determinant is cubic there.",
       .hypotheses = apart + "; an orthogonal basis, and no critical point with w = 0",
       .corrected = "Seven solutions, all of them critical: the spurious two are at w = 0. The "
                    "gradient is quadratic.",
       .special = "A critical point with w = 0 is lost in the chart, and cannot be told from the "
                  "spurious solutions by w and h: six solutions are left, or five. If h is 0 along "
                  "w = 0, all points there solve the two equations.",
       .flaws = {Flaw::wording, Flaw::substantive},
       .check = check_spurious_solutions(),
       .paper_at_witness = fewer_than_nine_solutions,
       .steps = {"chart-degree", "solutions-in-chart", "solutions-without-w"},
       .most_fields = 500},
      {.id = "planar-points-at-infinity",
       .paper = theorem + ", proof: one-to-one correspondence",
       .claim = "Pairs of critical points on the sphere of unit tensors are in one-to-one "
                "correspondence with the critical points in the plane.",
       .hypotheses = apart,
       .corrected = "All but those whose weights have the sum 0: these are at infinity.",
       .flaws = {Flaw::projective},
       .check = check_points_at_infinity(),
       .paper_at_witness = saddles_at_infinity,
       .steps = {"critical-at-infinity"},
       .most_fields = 500},
      {.id = "loop-encloses-extremum",
       .paper = section + ", vertices inserted at extrema",
       .claim = "A closed mode curve in a triangle encloses an extremum in the triangle, so that "
                "edges from the corners to all extrema meet every closed curve.",
       .hypotheses = apart + "; a rational mode parameter s, 0 < s < 1",
       .sharper = "It encloses one extremum more than saddles.",
       .special = "Dependent tensors: the mode is constant along lines. Curves around the same "
                  "extremum can be nested.",
       .check = check_enclosed_extremum(),
       .reader = "A continuous function on a disc that is constant on its boundary has an extremum "
                 "inside; the count is Morse theory on the disc.",
       .most_fields = 60},
      {.id = "edge-roots",
       .paper = section + ", intersections with edges",
       .claim = "Mode curves are traced from their intersection points with edges; those of a "
                "neutral curve are the zeros of a cubic.",
       .hypotheses = "three independent tensors, edges of no constant mode; 0 < mu < 1 of a "
                     "rational parameter",
       .sharper = "For mu > 0 all of them are among the zeros of one polynomial of degree six, "
                  "those of mode -mu too. Between at most three critical points, zeros of a cubic, "
                  "the mode is monotone. Zeros can be double, without a change of sign.",
       .special = "An edge that touches the curve; an edge of constant mode.",
       .check = check_edge_roots(),
       .needed = {{"zeros without a change of sign counted", root_without_change_of_sign}},
       .steps = {"critical-on-edge", "degree-six-form"}},
  };
}

}  // namespace tensortopo::theory
