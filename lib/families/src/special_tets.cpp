// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/families/special_tets.hpp"

#include <array>
#include <utility>

#include "tensortopo/families/single_tets.hpp"

namespace tensortopo {

namespace {

using Tensor = SymmetricTensor<double>;
using Tensors = std::array<Tensor, 4>;

constexpr Tensor kXy{0, 0, 0, 1, 0, 0}, kYz{0, 0, 0, 0, 1, 0}, kXz{0, 0, 0, 0, 0, 1};
constexpr Tensor kOnLevel{11, 2, -13, 0, 0, 0};  // of mode -143/343

constexpr std::array<std::pair<Speciality, std::string_view>, 20> kNames{
    {{Speciality::zero_deviator_vertex, "zero_deviator_vertex"},
     {Speciality::two_zero_vertices, "two_zero_vertices"},
     {Speciality::zero_deviator_on_edge, "zero_deviator_on_edge"},
     {Speciality::zero_deviator_inside, "zero_deviator_inside"},
     {Speciality::cylinder, "cylinder"},
     {Speciality::cone, "cone"},
     {Speciality::plane_strain, "plane_strain"},
     {Speciality::neutral_characteristic, "neutral_characteristic"},
     {Speciality::degenerate_characteristic, "degenerate_characteristic"},
     {Speciality::vertex_on_level, "vertex_on_level"},
     {Speciality::edge_tangent, "edge_tangent"},
     {Speciality::level_constant_on_edge, "level_constant_on_edge"},
     {Speciality::level_constant_on_face, "level_constant_on_face"},
     {Speciality::level_constant_in_cell, "level_constant_in_cell"},
     {Speciality::critical_value_on_face, "critical_value_on_face"},
     {Speciality::critical_value_in_cell, "critical_value_in_cell"},
     {Speciality::antiplane_shear, "antiplane_shear"},
     {Speciality::rank_two, "rank_two"},
     {Speciality::rank_one, "rank_one"},
     {Speciality::rank_zero, "rank_zero"}}};

Tensor small(RandomSource& random) {
  const auto entry = [&] { return static_cast<double>(random.integer(-5, 5)); };
  const double a = entry(), b = random.integer(1, 5);
  return {a, b, -(a + b), entry(), entry(), entry()};
}

// Each corner a combination of the four, of which one outweighs the others.
Tensors combinations(const Tensors& basis, RandomSource& random) {
  Tensors t;
  for (std::size_t i = 0; i < 4; ++i) {
    t[i] = 8.0 * basis[i];
    for (const Tensor& b : basis) t[i] = t[i] + static_cast<double>(random.integer(-2, 2)) * b;
  }
  return t;
}

Tensors tensors_of(Speciality speciality, RandomSource& random) {
  Tensors t{small(random), small(random), small(random), small(random)};
  std::array<double, 4> w{};  // drawn here: the order of a sum's operands is the compiler's choice
  for (double& weight : w) weight = random.integer(1, 3);
  switch (speciality) {
    case Speciality::zero_deviator_vertex:
      t[0] = {2, 2, 2, 0, 0, 0};
      break;
    case Speciality::two_zero_vertices:
      t[0] = t[2] = {};
      break;
    case Speciality::zero_deviator_on_edge:
      t[3] = -w[0] * t[0];
      break;
    case Speciality::zero_deviator_inside:
      t[3] = -1.0 * (w[0] * t[0] + w[1] * t[1] + w[2] * t[2]);
      break;
    case Speciality::cylinder:
      t[3] = t[1] + t[2] - t[0];
      break;
    case Speciality::cone:
      t[3] = w[0] * t[0] + w[1] * t[1] - w[2] * t[2];
      break;
    case Speciality::plane_strain:
      for (auto& corner : t) corner.xz = corner.yz = 0;
      break;
    case Speciality::neutral_characteristic:
      t = combinations({{{1, -2, 1, 0, 0, 0}, kXy, kYz, kXz}}, random);
      break;
    case Speciality::degenerate_characteristic:
      t = combinations({{{1, -1, 0, 0, 0, 0}, kXy, kYz, kXz}}, random);
      break;
    case Speciality::vertex_on_level:
      t[0] = kOnLevel;
      break;
    case Speciality::edge_tangent:
      // On the edge from 0 to 1 the largest mode, at x = sqrt(5/2) of xy + x xz + 2 yz, is 4/5.
      t[0] = kXy + kXz + 2.0 * kYz;
      t[1] = kXy + 2.0 * kXz + 2.0 * kYz;
      break;
    case Speciality::level_constant_on_edge:
      t[0] = kOnLevel, t[1] = w[1] * kOnLevel;
      break;
    case Speciality::level_constant_on_face:
      for (std::size_t i = 0; i < 3; ++i) t[i] = w[i] * kOnLevel;
      break;
    case Speciality::level_constant_in_cell:
      for (std::size_t i = 0; i < 4; ++i) t[i] = w[i] * kOnLevel;
      break;
    case Speciality::critical_value_on_face:
      t[0] = kXy - 4.0 * kXz - 2.0 * kYz;
      t[1] = kXy + 4.0 * kXz - 2.0 * kYz;
      t[2] = kXy + 5.0 * kYz;
      break;
    case Speciality::critical_value_in_cell: {
      const double s = random.integer(1, 4);
      const double p[4][3] = {{s, s, s}, {s, -s, -s}, {-s, s, -s}, {-s, -s, s}};
      for (std::size_t i = 0; i < 4; ++i)
        t[i] = Tensor{11, -13, 2, 0, 0, 0} + p[i][0] * kXy + p[i][1] * kXz + p[i][2] * kYz;
      break;
    }
    case Speciality::antiplane_shear:
      t[0] = w[0] * kXz, t[1] = w[1] * kYz;
      t[2] = w[2] * kXz + kYz, t[3] = kYz - w[3] * kXz;
      break;
    case Speciality::rank_two:
      // All in one half of the plane of combinations, so that no deviator vanishes.
      t[2] = w[0] * t[0] + w[1] * t[1];
      t[3] = w[2] * t[0] - w[3] * t[1];
      break;
    case Speciality::rank_one:
      for (std::size_t i = 1; i < 4; ++i) t[i] = w[i] * t[0];
      break;
    case Speciality::rank_zero:
      for (std::size_t i = 0; i < 4; ++i) t[i] = {w[i], w[i], w[i], 0, 0, 0};
      break;
  }
  return t;
}

}  // namespace

const std::vector<Speciality>& all_specialities() {
  static const std::vector<Speciality> all = [] {
    std::vector<Speciality> list;
    for (const auto& [speciality, name] : kNames) list.push_back(speciality);
    return list;
  }();
  return all;
}

std::string_view name_of(Speciality speciality) {
  return kNames[static_cast<std::size_t>(speciality)].second;
}

std::optional<ModeValue> special_level(Speciality speciality) {
  switch (speciality) {
    case Speciality::vertex_on_level:
    case Speciality::level_constant_on_edge:
    case Speciality::level_constant_on_face:
    case Speciality::level_constant_in_cell:
    case Speciality::critical_value_in_cell:
      return ModeValue::parse("-143/343");
    case Speciality::edge_tangent:
      return ModeValue::parse("4/5");
    case Speciality::degenerate_characteristic:
    case Speciality::critical_value_on_face:
    case Speciality::antiplane_shear:
      return ModeValue();
    default:
      return std::nullopt;
  }
}

TetMesh special_tet(Speciality speciality, RandomSource& random) {
  Tensors t = tensors_of(speciality, random);
  const auto q = random.quaternion();
  for (auto& corner : t) corner = turned(corner, q);
  // Any vertex may be the special one.
  for (std::size_t i = 3; i > 0; --i)
    std::swap(t[i], t[static_cast<std::size_t>(random.integer(0, static_cast<int>(i)))]);
  return single_tet({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, t);
}

}  // namespace tensortopo
