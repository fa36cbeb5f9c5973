// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "cases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>

#include "support/fields/special_meshes.hpp"
#include "support/fields/strata_fields.hpp"
#include "tensortopo/quadric/invariant_level.hpp"
#include "tensortopo/tensor/mode.hpp"

namespace tensortopo::test {
namespace {

using Tensor = SymmetricTensor<double>;

constexpr std::array kModes{"0",    "1/2",     "-1/2",    "1/10",   "-1/10",      "9/10",
                            "-9/10", "99/100", "-99/100", "1/1000", "-999/1000", "143/343"};

std::array<double*, 6> entries(Tensor& t) {
  return {&t.xx, &t.yy, &t.zz, &t.xy, &t.yz, &t.xz};
}

TetTensors integers(int bound, bool sparse, Random& random) {
  TetTensors result;
  for (Tensor& t : result)
    for (double* entry : entries(t))
      *entry = sparse && random.integer(0, 1) ? 0 : random.integer(-bound, bound);
  return result;
}

using Rotation = std::array<std::array<double, 3>, 3>;

/// The rotation of a unit quaternion.
Rotation rotation_of(const std::array<double, 4>& q) {
  const auto [w, x, y, z] = q;
  return {{{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}}};
}

/// R T R^T.
Tensor rotated(const Tensor& t, const Rotation& r) {
  const double m[3][3]{{t.xx, t.xy, t.xz}, {t.xy, t.yy, t.yz}, {t.xz, t.yz, t.zz}};
  double s[3][3]{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t l = 0; l < 3; ++l) s[i][j] += r[i][k] * m[k][l] * r[j][l];
  return {s[0][0], s[1][1], s[2][2], s[0][1], s[1][2], s[0][2]};
}

std::array<double, 4> unit_quaternion(Random& random) {
  std::array<double, 4> q{random.normal(), random.normal(), random.normal(), random.normal()};
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (double& entry : q) entry /= length;
  return q;
}

/// Combinations of `rank` tensors, and 1e-6 of others.
TetTensors nearly_of_rank(int rank, Random& random) {
  const std::array<Tensor, 2> base{random.tensor(), random.tensor()};
  TetTensors result;
  for (Tensor& t : result) {
    t = 1e-6 * random.tensor();
    for (int k = 0; k < rank; ++k) t = t + random.normal() * base[static_cast<std::size_t>(k)];
  }
  return result;
}

TetMesh flat_tet(const TetTensors& tensors, Random& random) {
  const double height = std::ldexp(1.0, -random.integer(10, 40));
  return single_tet_mesh({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.25, 0.5, height}}}, tensors);
}

TetMesh long_tet(const TetTensors& tensors, Random& random) {
  const double width = std::ldexp(1.0, -random.integer(10, 30));
  return single_tet_mesh({{{0, 0, 0}, {1, width, 0}, {0, width, 0}, {0.5, 0, width}}}, tensors);
}

TetMesh turned_flat_tet(const TetTensors& tensors, Random& random) {
  TetMesh mesh = flat_tet(tensors, random);
  const Rotation r = rotation_of(unit_quaternion(random));
  const double far = random.integer(0, 1) ? 0 : std::ldexp(1.0, random.integer(0, 8));
  const auto row = [&](std::size_t i, const Vector3<double>& p) {
    return far + r[i][0] * p.x + r[i][1] * p.y + r[i][2] * p.z;
  };
  for (auto& p : mesh.points) p = {row(0, p), row(1, p), row(2, p)};
  return mesh;
}

/// 17 digits of a number.
std::string digits_of(double x) {
  char text[40];
  std::snprintf(text, sizeof(text), "%.17g", x);
  return text;
}

/// A tensor and rests, and its mode.
FieldCase nearly_uniform(Random& random) {
  const Tensor base = random.tensor();
  const double rest = std::ldexp(1.0, -random.integer(20, 50));
  TetTensors tensors;
  for (Tensor& t : tensors) t = base + rest * random.tensor();
  return {reference_tet_mesh(tensors), digits_of(mode(deviator(base))), ""};
}

/// The level of an invariant that is between its values at the mesh's vertices, if there is one.
std::string any_level(const TetMesh& mesh, Random& random) {
  constexpr std::array kInvariants{Invariant::magnitude, Invariant::deviator_magnitude,
                                   Invariant::anisotropy};
  const Invariant invariant = kInvariants[static_cast<std::size_t>(random.integer(0, 2))];
  double low = HUGE_VAL, high = 0;
  for (const Tensor& t : mesh.tensors) {
    low = std::min(low, invariant_of(invariant, t));
    high = std::max(high, invariant_of(invariant, t));
  }
  const double share = random.uniform();
  const double value = std::max(low + share * (high - low), 1e-300);
  const bool is_in_range = invariant != Invariant::anisotropy || value < 1;
  return std::string(name_of(invariant)) + ' ' + digits_of(is_in_range ? value : 0.5);
}

TetTensors tensors_of(Family family, Random& random) {
  TetTensors result = random.tet_tensors();
  switch (family) {
    case Family::small_integers:
      return integers(2, false, random);
    case Family::sparse_integers:
      return integers(9, true, random);
    case Family::powers_of_two:
      for (Tensor& t : result) t = std::ldexp(1.0, random.integer(-27, 27)) * t;
      return result;
    case Family::scales:
      for (Tensor& t : result) t = std::pow(10.0, 16 * random.uniform() - 8) * t;
      return result;
    case Family::large_trace:
      result = short_tensors(random);
      for (Tensor& t : result) {
        const double trace = std::ldexp(random.integer(-1 << 16, 1 << 16), random.integer(0, 18));
        t = t + trace * Tensor{1, 1, 1, 0, 0, 0};
      }
      return result;
    case Family::rotated: {
      result = integers(2, false, random);
      const Rotation r = rotation_of(unit_quaternion(random));
      for (Tensor& t : result) t = rotated(t, r);
      return result;
    }
    case Family::nearly_rank_one:
      return nearly_of_rank(1, random);
    case Family::nearly_rank_two:
      return nearly_of_rank(2, random);
    default:
      return result;
  }
}

}  // namespace

const std::vector<Family>& all_families() {
  static const std::vector<Family> all{
      Family::general,         Family::small_integers, Family::sparse_integers,
      Family::powers_of_two,   Family::scales,         Family::large_trace,
      Family::rotated,         Family::nearly_rank_one, Family::nearly_rank_two,
      Family::nearly_special,  Family::slivers,        Family::needles,
      Family::cut,             Family::cut_integers,   Family::meshes,
      Family::special_meshes,  Family::turned_slivers, Family::nearly_uniform};
  return all;
}

std::string name_of(Family family) {
  constexpr std::array kNames{
      "general",         "small_integers",  "sparse_integers", "powers_of_two",
      "scales",          "large_trace",     "rotated",         "nearly_rank_one",
      "nearly_rank_two", "nearly_special",  "slivers",         "needles",
      "cut",             "cut_integers",    "meshes",          "special_meshes",
      "turned_slivers",  "nearly_uniform"};
  return kNames.at(static_cast<std::size_t>(family));
}

TetTensors short_tensors(Random& random) {
  TetTensors result = random.tet_tensors();
  for (Tensor& t : result) t = rounded(t, 16);
  return result;
}

std::vector<Cut> cut(TetMesh& mesh, int steps, Random& random) {
  std::vector<Cut> result;
  for (int step = 0; step < steps; ++step) {
    auto simplex = mesh.tets[static_cast<std::size_t>(
        random.integer(0, static_cast<int>(mesh.tets.size()) - 1))];
    for (std::size_t i = 3; i > 0; --i)
      std::swap(simplex[i], simplex[static_cast<std::size_t>(random.integer(0, static_cast<int>(i)))]);
    const int count = random.integer(2, 4);
    Cut& here = result.emplace_back();
    here.simplex.assign(simplex.begin(), simplex.begin() + count);
    std::sort(here.simplex.begin(), here.simplex.end());
    Vector3<double> point{0, 0, 0};
    Tensor tensor{};
    int left = 8;
    for (int k = 0; k < count; ++k) {
      const int others = count - 1 - k;
      const int weight = others == 0 ? left : random.integer(1, left - others);
      left -= weight;
      const auto v = static_cast<std::size_t>(here.simplex[static_cast<std::size_t>(k)]);
      point = point + (weight / 8.0) * mesh.points[v];
      tensor = tensor + (weight / 8.0) * mesh.tensors[v];
    }
    const auto middle = static_cast<TetMesh::Index>(mesh.points.size());
    mesh.points.push_back(point);
    mesh.tensors.push_back(tensor);
    std::vector<std::array<TetMesh::Index, 4>> tets;
    for (const auto& tet : mesh.tets) {
      const bool is_around = std::ranges::all_of(here.simplex, [&](TetMesh::Index v) {
        return std::ranges::find(tet, v) != tet.end();
      });
      if (!is_around) {
        tets.push_back(tet);
        continue;
      }
      for (const TetMesh::Index v : here.simplex) {
        auto part = tet;
        std::ranges::replace(part, v, middle);
        tets.push_back(part);
      }
    }
    mesh.tets = std::move(tets);
  }
  mesh.cell_ids.clear();
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    mesh.cell_ids.push_back(static_cast<std::int64_t>(t));
  return result;
}

FieldCase field_case(Family family, int number) {
  Random random(1'000'003u * static_cast<std::uint64_t>(number) + static_cast<std::uint64_t>(family));
  FieldCase result;
  result.mode = kModes[static_cast<std::size_t>(random.integer(0, kModes.size() - 1))];
  switch (family) {
    case Family::slivers:
      result.mesh = flat_tet(random.tet_tensors(), random);
      break;
    case Family::needles:
      result.mesh = long_tet(random.tet_tensors(), random);
      break;
    case Family::turned_slivers:
      result.mesh = turned_flat_tet(random.tet_tensors(), random);
      break;
    case Family::nearly_uniform:
      result = nearly_uniform(random);
      break;
    case Family::cut:
    case Family::cut_integers:
      result.mesh = reference_tet_mesh(family == Family::cut ? short_tensors(random)
                                                             : integers(2, false, random));
      cut(result.mesh, random.integer(1, 6), random);
      break;
    case Family::meshes:
      result.mesh = cube_mesh(1);
      fill_with_normal_tensors(result.mesh, static_cast<std::uint64_t>(random.integer(0, 1 << 30)));
      break;
    case Family::special_meshes: {
      const auto& kinds = all_mesh_kinds();
      result.mesh = special_mesh(
          kinds[static_cast<std::size_t>(random.integer(0, static_cast<int>(kinds.size()) - 1))],
          random);
      break;
    }
    case Family::nearly_special: {
      const auto& strata = all_strata();
      const Stratum stratum = strata[static_cast<std::size_t>(
          random.integer(0, static_cast<int>(strata.size()) - 1))];
      const double rest = random.integer(0, 1) ? 0x1p-20 : 0x1p-36;
      result.mesh = reference_tet_mesh(
          nearly_in_stratum(stratum, rest, static_cast<std::uint64_t>(random.integer(0, 1 << 30))));
      if (const std::string mode = special_mode(stratum); !mode.empty() && random.integer(0, 1))
        result.mode = mode;
      break;
    }
    default:
      result.mesh = reference_tet_mesh(tensors_of(family, random));
      // Closed curves of a face, around two degenerate points next to each other.
      if (family == Family::nearly_rank_one && random.integer(0, 3))
        result.mode = random.integer(0, 1) ? "97/100" : "-97/100";
  }
  result.invariant = any_level(result.mesh, random);
  return result;
}

}  // namespace tensortopo::test
