// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "witness_fields.hpp"

#include <stdexcept>

namespace tensortopo::test {

namespace {

using Points = std::array<Vector3<double>, 4>;

// Four alternate vertices of a box.
Points box(double x, double y, double z) {
  return {{{x, y, z}, {x, -y, -z}, {-x, y, -z}, {-x, -y, z}}};
}

const Points unit_corner{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

std::vector<FieldWitness> make_field_witnesses() {
  std::vector<FieldWitness> all;

  all.push_back(
      {"saddle_origin",
       "[[4,x,y],[x,-5,z],[y,z,1]]: the saddle of the mode is the origin, at -10/sqrt(343). A "
       "tube through the small tetrahedron pinches off into two discs as the level passes it.",
       {{4, -5, 1, 0, 0, 0}, {0, 0, 0, 1, 0, 0}, {0, 0, 0, 0, 0, 1}, {0, 0, 0, 0, 1, 0}},
       4,
       Saddle{{0, 0, 0}, -0.5399492471560389},
       {{box(1, 1, 1), {-5, 10}, {disc, disc}, 8},
        {box(1, 1, 1), {-53, 100}, {annulus}, 4},
        {box(1, 1, 1), {-539, 1000}, {annulus}, 4},
        {box(1, 1, 1), {-541, 1000}, {disc, disc}, 4},
        {box(1, 1, 1), {-55, 100}, {disc, disc}, 4},
        {box(6, 6, 6), {-5, 10}, {annulus}, 4},
        {box(6, 6, 6), {-4, 10}, {annulus}, 4}}});

  all.push_back(
      {"saddle_origin_rational",
       "[[11,x,y],[x,-13,z],[y,z,2]]: as saddle_origin, with a rational saddle value, -143/343; "
       "at exactly that level the surface has a cone point at the origin.",
       {{11, -13, 2, 0, 0, 0}, {0, 0, 0, 1, 0, 0}, {0, 0, 0, 0, 0, 1}, {0, 0, 0, 0, 1, 0}},
       4,
       Saddle{{0, 0, 0}, -143.0 / 343},
       {{box(1, 1, 1), {-83, 200}, {disc, disc}, 8},
        {box(1, 1, 1), {-416, 1000}, {annulus}, 4},
        {box(1, 1, 1), {-418, 1000}, {disc, disc}, 4},
        {box(1, 1, 1), {-42, 100}, {disc, disc}, 4},
        {box(2, 2, 2), {-83, 200}, {annulus}, 4},
        {box(2, 2, 2), {-416, 1000}, {annulus}, 4},
        {box(2, 2, 2), {-418, 1000}, {disc, disc}, 4},
        {box(2, 2, 2), {-42, 100}, {disc, disc}, 4}}});

  all.push_back(
      {"inner_loop",
       "[[4x,y,-1-2x],[y,-5x,z],[-1-2x,z,x]]: below the saddle value the surface has a handle "
       "inside the one tetrahedron, and a loop of the boundary of its parameter domain touches "
       "no face, so that what happens on the faces does not reveal it.",
       {{0, 0, 0, 0, 0, -1}, {4, -5, 1, 0, 0, -2}, {0, 0, 0, 1, 0, 0}, {0, 0, 0, 0, 1, 0}},
       4,
       Saddle{{-0.5, 0, 0}, 0.5399492471560389},
       {{box(4, 12, 8), {5, 10}, {handled_annulus}, 4},
        {box(4, 12, 8), {53, 100}, {handled_annulus}, 4},
        {box(4, 12, 8), {55, 100}, {annulus}, 4},
        {box(4, 12, 8), {-5, 10}, {annulus}, 8}}});

  all.push_back(
      {"inner_loop_rational",
       "[[11x,y,-1-5x],[y,-13x,z],[-1-5x,z,2x]]: as inner_loop, with the rational saddle value "
       "143/343 at (-1/5,0,0).",
       {{0, 0, 0, 0, 0, -1}, {11, -13, 2, 0, 0, -5}, {0, 0, 0, 1, 0, 0}, {0, 0, 0, 0, 1, 0}},
       4,
       Saddle{{-0.2, 0, 0}, 143.0 / 343},
       {{box(3, 24, 11), {632269, 2685619}, {handled_annulus}, 4},
        {box(3, 24, 11), {2, 5}, {handled_annulus}, 4},
        {box(3, 24, 11), {43, 100}, {annulus}, 4}}});

  all.push_back(
      {"offdiag3d",
       "[[4z,1,x],[1,-5z,y],[x,y,z]]: at mode 0.99 two thin tubes run between faces and no edge "
       "of the tetrahedron is crossed at all.",
       {{0, 0, 0, 1, 0, 0}, {0, 0, 0, 0, 0, 1}, {0, 0, 0, 0, 1, 0}, {4, -5, 1, 0, 0, 0}},
       4,
       std::nullopt,
       {{box(3, 3, 3), {9, 10}, {disc, disc}, 4},
        {box(3, 3, 3), {-9, 10}, {disc, disc}, 4},
        {box(3, 3, 3), {5, 10}, {disc}, 10},
        {box(3, 3, 3), {2, 10}, {disc}, 8},
        {box(3, 3, 3), {99, 100}, {annulus, annulus}, 0, true},
        {box(3, 3, 3), {-99, 100}, {annulus, annulus}, 0, true}}});

  all.push_back(
      {"uniaxial_complement",
       "[[x,1,y],[1,-x,z],[y,z,0]]: the tensor orthogonal to all values of the field is uniaxial, "
       "diag(1,1,-2), so the neutral surface is singular along the line y = z = 0 and the usual "
       "parameter along the boundary of the parameter domain is constant.",
       {{0, 0, 0, 1, 0, 0}, {1, -1, 0, 0, 0, 0}, {0, 0, 0, 0, 0, 1}, {0, 0, 0, 0, 1, 0}},
       4,
       std::nullopt,
       {{box(2, 2, 2), {5, 10}, {disc, disc}, 4}, {box(2, 2, 2), {-5, 10}, {disc, disc}, 4}}});

  all.push_back(
      {"neutral_complement",
       "[[z,1,x],[1,-2z,y],[x,y,z]]: the tensor orthogonal to all values, diag(1,0,-1), has "
       "determinant zero, so its sign is arbitrary, and every direction of the parameter sphere is "
       "real at every level.",
       {{0, 0, 0, 1, 0, 0}, {0, 0, 0, 0, 0, 1}, {0, 0, 0, 0, 1, 0}, {1, -2, 1, 0, 0, 0}},
       4,
       std::nullopt,
       {{box(2, 2, 2), {5, 10}, {disc}, 6}, {box(2, 2, 2), {-5, 10}, {disc}, 6}}});

  all.push_back(
      {"generic_integer",
       "Small integers without any symmetry.",
       {{1, 0, -1, -1, 1, 2}, {0, -1, 1, 2, 1, 1}, {2, -1, -1, 1, -2, 0}, {-1, 2, -1, 0, 1, 1}},
       4,
       std::nullopt,
       {{box(1, 1, 1), {3, 10}, {disc, disc}, 7},
        {box(1, 1, 1), {-3, 10}, {disc}, 4},
        {box(1, 1, 1), {8, 10}, {annulus}, 2},
        {box(1, 1, 1), {-8, 10}, {annulus}, 2},
        {unit_corner, {2, 10}, {disc}, 4},
        {unit_corner, {5, 10}, {disc}, 5},
        {unit_corner, {-4, 10}, {disc}, 4}}});

  const Points pyramid{{{-4, -2, -1}, {4, -2, -1}, {0, 5, -1}, {0, 0, 4}}};
  all.push_back(
      {"cylinders",
       "[[0,1,x],[1,0,y],[x,y,0]]: constant along z, so mode surfaces are cylinders over curves "
       "in a plane, and no single tensor is orthogonal to all values.",
       {{0, 0, 0, 1, 0, 0}, {0, 0, 0, 0, 0, 1}, {0, 0, 0, 0, 1, 0}, {0, 0, 0, 0, 0, 0}},
       3,
       std::nullopt,
       {{pyramid, {9, 10}, {annulus, annulus}, 0}, {pyramid, {5, 10}, {disc, disc}, 6}}});
  return all;
}

template <class Witness>
const Witness& named(const std::vector<Witness>& all, const std::string& name) {
  for (const auto& witness : all) {
    if (witness.name == name) return witness;
  }
  throw std::out_of_range("no witness named " + name);
}

}  // namespace

const std::vector<FieldWitness>& field_witnesses() {
  static const std::vector<FieldWitness> all = make_field_witnesses();
  return all;
}

const FieldWitness& field_witness(const std::string& name) {
  return named(field_witnesses(), name);
}
const PlanarWitness& planar_witness(const std::string& name) {
  return named(planar_witnesses(), name);
}
const StratumWitness& stratum_witness(const std::string& name) {
  return named(stratum_witnesses(), name);
}

}  // namespace tensortopo::test
