// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "witness_fields.hpp"

namespace tensortopo::test {

namespace {

const std::array<Vector3<double>, 4> corner{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

StratumWitness on_corner(std::string name, std::string note, const LinearField& field, int rank) {
  StratumWitness witness;
  witness.name = std::move(name), witness.note = std::move(note);
  witness.points = corner;
  witness.tensors = field.at(corner);
  witness.rank = rank;
  return witness;
}

std::vector<StratumWitness> make_stratum_witnesses() {
  std::vector<StratumWitness> all;
  const SymmetricTensor<double> none{}, xy{0, 0, 0, 1, 0, 0}, yz{0, 0, 0, 0, 1, 0},
      xz{0, 0, 0, 0, 0, 1};

  all.push_back(on_corner("cylinders_oblique",
                          "Depends on x+z and y+2z only: constant along an oblique direction.",
                          {xy, xz, yz, {0, 0, 0, 0, 2, 1}}, 3));

  all.push_back(on_corner(
      "cone_apex_inside",
      "Zero at the point (1/4,1/4,1/4) inside (entries times four): every "
      "mode surface is a cone with that apex, and opposite points have "
      "opposite modes.",
      {{-1, -1, 2, -1, -1, -1}, {4, 4, -8, 0, 0, 0}, {0, 4, -4, 4, 4, 0}, {0, -4, 4, 0, 0, 4}}, 3));
  all.back().zero_point = Vector3<double>{0.25, 0.25, 0.25};

  all.push_back(on_corner("plane_strain",
                          "The components xz and yz vanish everywhere, as in plane strain: the "
                          "rank is at most three whatever the rest does.",
                          {{1, 1, -2, 0, 0, 0}, {1, -1, 0, 0, 0, 0}, xy, {1, 2, -3, 0, 0, 0}}, 3));

  all.push_back(on_corner("pencil",
                          "Two independent tensors: the mode is constant on each plane of a "
                          "pencil.",
                          {{1, 1, -2, 0, 0, 0}, xy, {1, 1, -2, 1, 0, 0}, {2, 2, -4, 3, 0, 0}}, 2));

  all.push_back(on_corner(
      "one_direction",
      "(1+2x-y+3z) diag(1,0,-1): neutral everywhere, and zero at the vertex "
      "(0,1,0).",
      {{1, 0, -1, 0, 0, 0}, {2, 0, -2, 0, 0, 0}, {-1, 0, 1, 0, 0, 0}, {3, 0, -3, 0, 0, 0}}, 1));
  all.back().constant_mode = Fraction{0, 1};
  all.back().zero_point = Vector3<double>{0, 1, 0};

  all.push_back(on_corner("zero", "No deviator anywhere: the mode is not defined.",
                          {none, none, none, none}, 0));
  all.back().zero_point = Vector3<double>{0, 0, 0};

  all.push_back(on_corner("constant", "Constant, with mode exactly -143/343.",
                          {{11, 2, -13, 0, 0, 0}, none, none, none}, 1));
  all.back().constant_mode = Fraction{-143, 343};
  all.back().first_vertex_mode = Fraction{-143, 343};

  all.push_back(on_corner("almost_deficient",
                          "Rank four, but the fourth direction is smaller than the others by "
                          "10^-9: after an affine change of coordinates it is offdiag3d.",
                          {1e9 * xy, 1e9 * xz, 1e9 * yz, {4, -5, 1, 0, 0, 1e9}}, 4));

  all.push_back(on_corner("antiplane_shear",
                          "Only xz = 1+x+z and yz = 2+y-z: determinant zero identically, so the "
                          "whole tetrahedron is neutral.",
                          {yz + yz + xz, xz, yz, xz - yz}, 2));
  all.back().constant_mode = Fraction{0, 1};

  StratumWitness vertex;
  vertex.name = "vertex_on_surface";
  vertex.note = "The first vertex has mode exactly -143/343, a level that no double equals.";
  vertex.points = corner;
  vertex.tensors = {
      {{11, 2, -13, 0, 0, 0}, {1, 0, -1, -1, 1, 2}, {0, -1, 1, 2, 1, 1}, {2, -1, -1, 1, -2, 0}}};
  vertex.first_vertex_mode = Fraction{-143, 343};
  all.push_back(vertex);

  vertex.name = "zero_vertex";
  vertex.note =
      "The first vertex is zero, as at an unloaded point: mode surfaces are cones from it over "
      "the curves in the opposite face.";
  vertex.tensors[0] = {};
  vertex.rank = 3;
  vertex.first_vertex_mode.reset();
  vertex.zero_point = Vector3<double>{0, 0, 0};
  all.push_back(vertex);
  return all;
}

}  // namespace

const std::vector<StratumWitness>& stratum_witnesses() {
  static const std::vector<StratumWitness> all = make_stratum_witnesses();
  return all;
}

}  // namespace tensortopo::test
