// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "strata_fields.hpp"

#include <map>
#include <utility>

namespace tensortopo::test {

namespace {

using Tensor = SymmetricTensor<double>;

constexpr Tensor unit_xy{0, 0, 0, 1, 0, 0}, unit_yz{0, 0, 0, 0, 1, 0}, unit_xz{0, 0, 0, 0, 0, 1};
constexpr Tensor on_level{11, 2, -13, 0, 0, 0};  // of mode -143/343
constexpr Tensor uniaxial{2, -1, -1, 0, 0, 0};   // of mode 1

Tensor small(Random& random) {
  const auto entry = [&] { return static_cast<double>(random.integer(-5, 5)); };
  const double a = entry(), b = entry();
  // No trace, and not zero.
  return {a, b == 0 ? 1.0 : b, -(a + (b == 0 ? 1.0 : b)), entry(), entry(), entry()};
}

double weight(Random& random, int low, int high) {
  const int w = random.integer(low, high);
  return w == 0 ? 1 : w;
}

// Values at four points around the origin of constant + x dx + y dy + z dz.
TetTensors around_origin(const Tensor& constant, const Tensor& dx, const Tensor& dy,
                         const Tensor& dz, Random& random) {
  const double s = random.integer(1, 4);
  const double p[4][3] = {{s, s, s}, {s, -s, -s}, {-s, s, -s}, {-s, -s, s}};
  TetTensors t;
  for (std::size_t i = 0; i < 4; ++i) t[i] = constant + p[i][0] * dx + p[i][1] * dy + p[i][2] * dz;
  return t;
}

TetTensors combinations(const std::array<Tensor, 4>& basis, Random& random) {
  TetTensors t;
  for (auto& corner : t) {
    corner = {};
    for (const auto& b : basis) corner = corner + static_cast<double>(random.integer(-3, 3)) * b;
    corner = corner + 8.0 * basis[static_cast<std::size_t>(random.integer(0, 3))];
  }
  return t;
}

// The mode at T is critical along a tensor A if A is orthogonal to T^2 - k T with the k that makes
// this orthogonal to T, for T = on_level k = -143/49: so it is along xy and xz. There it grows to
// second order, as its eigenvalues do: by a positive multiple of -(t + k) for the eigenvalue t that
// A leaves alone, and both -13 and 2 are less than -k.
void around_extremum(TetTensors& t, Random& random) {
  constexpr std::array<std::array<int, 6>, 3> triangles{
      {{3, 0, -1, 2, -2, -3}, {5, -1, -2, 4, -4, -3}, {1, 4, -4, 0, 2, -3}}};
  const auto& p = triangles[static_cast<std::size_t>(random.integer(0, 2))];
  const int size = random.integer(1, 3);
  for (std::size_t i = 0; i < 3; ++i)
    t[i] = on_level + static_cast<double>(size * p[2 * i]) * unit_xy +
           static_cast<double>(size * p[2 * i + 1]) * unit_xz;
}

TetTensors upright(Stratum stratum, Random& random) {
  TetTensors t{small(random), small(random), small(random), small(random)};
  switch (stratum) {
    case Stratum::general:
      return t;
    case Stratum::cylinder:
      t[3] = t[1] + t[2] - t[0];
      return t;
    case Stratum::cone_apex_outside:
      t[3] =
          weight(random, 1, 3) * t[0] + weight(random, 1, 3) * t[1] - weight(random, 1, 2) * t[2];
      return t;
    case Stratum::cone_apex_inside:
      t[3] = -1.0 * (weight(random, 1, 3) * t[0] + weight(random, 1, 3) * t[1] +
                     weight(random, 1, 3) * t[2]);
      return t;
    case Stratum::zero_on_face:
      t[3] = -1.0 * (weight(random, 1, 3) * t[0] + weight(random, 1, 3) * t[1]);
      return t;
    case Stratum::zero_on_edge:
      t[3] = -weight(random, 1, 4) * t[0];
      return t;
    case Stratum::rank_two:
      t[2] = weight(random, -3, 3) * t[0] + weight(random, -3, 3) * t[1];
      t[3] = weight(random, -3, 3) * t[0] + weight(random, -3, 3) * t[1];
      return t;
    case Stratum::rank_one:
      for (std::size_t i = 1; i < 4; ++i) t[i] = weight(random, -3, 3) * t[0];
      return t;
    case Stratum::rank_zero:
      t.fill({4, 4, 4, 0, 0, 0});
      return t;
    case Stratum::zero_vertex:
      t[0] = {};
      return t;
    case Stratum::two_zero_vertices:
      t[0] = t[2] = {};
      return t;
    case Stratum::three_zero_vertices:
      t[0] = t[1] = t[3] = {};
      return t;
    case Stratum::neutral_complement:
      return combinations({{{1, -2, 1, 0, 0, 0}, unit_xy, unit_yz, unit_xz}}, random);
    case Stratum::uniaxial_complement:
      return combinations({{{1, -1, 0, 0, 0, 0}, unit_xy, unit_yz, unit_xz}}, random);
    case Stratum::plane_strain:
      for (auto& corner : t) corner.xz = corner.yz = 0;
      return t;
    case Stratum::antiplane_shear:
      for (auto& corner : t) corner = {0, 0, 0, 0, weight(random, -5, 5), weight(random, -5, 5)};
      return t;
    case Stratum::vertex_on_level:
      t[0] = on_level;
      return t;
    case Stratum::tangent_edge:
      // On the edge from 0 to 1 the largest mode, at sqrt(5/2), is 4/5.
      t[0] = unit_xy + unit_xz + 2.0 * unit_yz;
      t[1] = unit_xy + 2.0 * unit_xz + 2.0 * unit_yz;
      return t;
    case Stratum::face_saddle:
      t[0] = unit_xy - 4.0 * unit_xz - 2.0 * unit_yz;
      t[1] = unit_xy + 4.0 * unit_xz - 2.0 * unit_yz;
      t[2] = unit_xy + 5.0 * unit_yz;
      return t;
    case Stratum::tet_saddle:
      return around_origin({11, -13, 2, 0, 0, 0}, unit_xy, unit_xz, unit_yz, random);
    case Stratum::constant_edge:
      t[0] = on_level, t[1] = weight(random, 1, 3) * on_level;
      return t;
    case Stratum::constant_face:
      for (std::size_t i = 0; i < 3; ++i) t[i] = weight(random, 1, 3) * on_level;
      return t;
    case Stratum::constant_cell:
      for (auto& corner : t) corner = weight(random, 1, 3) * on_level;
      return t;
    case Stratum::symmetric_face: {
      // Eigenvalues zz of one sign, so that no deviator vanishes on the face.
      const double sign = random.integer(0, 1) == 0 ? 1 : -1;
      for (std::size_t i = 0; i < 3; ++i) {
        t[i].xz = t[i].yz = 0;
        if (t[i].zz == 0) ++t[i].zz, --t[i].xx;
        if (sign * t[i].zz < 0) t[i] = -1.0 * t[i];
      }
      if (t[3].xz == 0) t[3].xz = 1;  // not a symmetric cell
      return t;
    }
    case Stratum::plane_strain_face:
      // Of mode -1 at the origin of (x, y), and of mode 1 on the circle of radius 3 around it.
      for (std::size_t i = 0; i < 3; ++i) {
        const double x = random.integer(-6, 6), y = random.integer(-6, 6);
        t[i] = {1 + x, 1 - x, -2, y, 0, 0};
      }
      if (t[3].xz == 0) t[3].xz = 1;
      return t;
    case Stratum::face_minimum:
    case Stratum::face_maximum:
      around_extremum(t, random);
      if (stratum == Stratum::face_maximum)
        for (auto& corner : t) corner = -1.0 * corner;
      return t;
    case Stratum::degenerate_edge: {
      const double sign = random.integer(0, 1) == 0 ? 1 : -1;
      for (std::size_t i = 0; i < 2; ++i) t[i] = sign * weight(random, 1, 3) * uniaxial;
      return t;
    }
  }
  return t;
}

}  // namespace

const std::vector<Stratum>& all_strata() {
  static const std::vector<Stratum> all = [] {
    std::vector<Stratum> list;
    for (int i = 0; i <= static_cast<int>(Stratum::degenerate_edge); ++i)
      list.push_back(static_cast<Stratum>(i));
    return list;
  }();
  return all;
}

std::string name_of(Stratum stratum) {
  static const std::map<Stratum, const char*> names{
      {Stratum::general, "general"},
      {Stratum::cylinder, "cylinder"},
      {Stratum::cone_apex_outside, "cone_apex_outside"},
      {Stratum::cone_apex_inside, "cone_apex_inside"},
      {Stratum::zero_on_face, "zero_on_face"},
      {Stratum::zero_on_edge, "zero_on_edge"},
      {Stratum::rank_two, "rank_two"},
      {Stratum::rank_one, "rank_one"},
      {Stratum::rank_zero, "rank_zero"},
      {Stratum::zero_vertex, "zero_vertex"},
      {Stratum::two_zero_vertices, "two_zero_vertices"},
      {Stratum::three_zero_vertices, "three_zero_vertices"},
      {Stratum::neutral_complement, "neutral_complement"},
      {Stratum::uniaxial_complement, "uniaxial_complement"},
      {Stratum::plane_strain, "plane_strain"},
      {Stratum::antiplane_shear, "antiplane_shear"},
      {Stratum::vertex_on_level, "vertex_on_level"},
      {Stratum::tangent_edge, "tangent_edge"},
      {Stratum::face_saddle, "face_saddle"},
      {Stratum::tet_saddle, "tet_saddle"},
      {Stratum::constant_edge, "constant_edge"},
      {Stratum::constant_face, "constant_face"},
      {Stratum::constant_cell, "constant_cell"},
      {Stratum::symmetric_face, "symmetric_face"},
      {Stratum::plane_strain_face, "plane_strain_face"},
      {Stratum::face_minimum, "face_minimum"},
      {Stratum::face_maximum, "face_maximum"},
      {Stratum::degenerate_edge, "degenerate_edge"}};
  return names.at(stratum);
}

std::string special_mode(Stratum stratum) {
  switch (stratum) {
    case Stratum::vertex_on_level:
    case Stratum::tet_saddle:
    case Stratum::constant_edge:
    case Stratum::constant_face:
    case Stratum::constant_cell:
    case Stratum::face_minimum:
      return "-143/343";
    case Stratum::face_maximum:
      return "143/343";
    case Stratum::tangent_edge:
      return "4/5";
    case Stratum::face_saddle:
    case Stratum::uniaxial_complement:
    case Stratum::antiplane_shear:
      return "0";
    default:
      return "";
  }
}

TetTensors stratum_tensors(Stratum stratum, Random& random) {
  TetTensors t = upright(stratum, random);
  const auto q = random.quaternion();
  for (auto& corner : t) corner = turned(corner, q);
  // Any vertex may be the special one.
  for (std::size_t i = 3; i > 0; --i)
    std::swap(t[i], t[static_cast<std::size_t>(random.integer(0, static_cast<int>(i)))]);
  return t;
}

TetTensors nearly_in_stratum(Stratum stratum, double rest, std::uint64_t seed) {
  Random random(seed);
  TetTensors tensors = stratum_tensors(stratum, random);
  for (auto& t : tensors)
    for (double* entry : {&t.xx, &t.yy, &t.zz, &t.xy, &t.yz, &t.xz})
      *entry += rest * random.integer(-8, 8);
  return tensors;
}

}  // namespace tensortopo::test
