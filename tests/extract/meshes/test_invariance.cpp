// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "extract/cases/extract_case.hpp"

namespace tensortopo::test {
namespace {

using Tensor = SymmetricTensor<double>;
using Matrix = std::array<std::array<double, 3>, 3>;

// A mesh whose tensors have few enough bits for sums and small products to be exact.
TetMesh short_field(std::uint64_t seed, int cubes = 2) {
  TetMesh mesh = cube_mesh(cubes);
  fill_with_normal_tensors(mesh, seed);
  for (auto& t : mesh.tensors) t = rounded(t, 16);
  return mesh;
}

// Extracts a field and a changed one, and expects the same topology at the same mode.
void expect_same_topology(std::uint64_t seed, const std::function<void(TetMesh&)>& change,
                          int fields = 1) {
  SCOPED_TRACE(announce(seed));
  for (int field = 0; field < trials(fields); ++field)
    for (const char* mode : {"1/10", "-1/2", "9/10"}) {
      SCOPED_TRACE(std::string("mode ") + mode + ", field " + std::to_string(field));
      const TetMesh mesh = short_field(seed + static_cast<std::uint64_t>(field));
      TetMesh other = mesh;
      change(other);
      const Extraction before = extract(mesh, mode), after = extract(other, mode);
      EXPECT_EQ(unresolved_text(before), "");
      EXPECT_EQ(unresolved_text(after), "");
      EXPECT_EQ(summary(after.surface), summary(before.surface));
    }
}

// R T R^t for a matrix of small integers: exact, and a multiple of the rotated tensor.
Tensor congruent(const Matrix& r, const Tensor& t) {
  const Matrix m{{{t.xx, t.xy, t.xz}, {t.xy, t.yy, t.yz}, {t.xz, t.yz, t.zz}}};
  Matrix result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t l = 0; l < 3; ++l) result[i][j] += r[i][k] * m[k][l] * r[j][l];
  return {result[0][0], result[1][1], result[2][2], result[0][1], result[1][2], result[0][2]};
}

// |q|^2 times the rotation of an integer quaternion.
Matrix rotation(double w, double x, double y, double z) {
  return {{{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
           {2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
           {2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}}};
}

void scale_exactly(TetMesh& mesh, int exponent) {
  for (auto& t : mesh.tensors)
    for (double* entry : {&t.xx, &t.yy, &t.zz, &t.xy, &t.yz, &t.xz})
      *entry = std::ldexp(*entry, exponent);
}

TEST(Invariance, ScalingAllTensorsMovesNoVertex) {
  const std::uint64_t seed = 20240901;
  SCOPED_TRACE(announce(seed));
  const TetMesh mesh = short_field(seed);
  for (const char* mode : {"1/10", "-1/2", "9/10"}) {
    const SurfaceMesh unit = extract(mesh, mode).surface;
    for (const int exponent : {-900, -300, 300, 900}) {
      SCOPED_TRACE(exponent);
      TetMesh scaled = mesh;
      scale_exactly(scaled, exponent);
      const Extraction extraction = extract(scaled, mode);
      EXPECT_EQ(unresolved_text(extraction), "");
      const SurfaceMesh& surface = extraction.surface;
      EXPECT_EQ(surface.triangles, unit.triangles);
      ASSERT_EQ(surface.points.size(), unit.points.size());
      bool same = true;
      for (std::size_t v = 0; v < surface.points.size(); ++v) {
        const auto &p = surface.points[v], &q = unit.points[v];
        same = same && p.x == q.x && p.y == q.y && p.z == q.z;
        EXPECT_LT(std::abs(surface.residual[v]), 1e-9);
        EXPECT_NEAR(dot(surface.normal[v], unit.normal[v]), 1, 1e-6);
      }
      EXPECT_TRUE(same);
    }
  }
}

// Scaling each vertex by its own positive factor is a projective map of every tetrahedron.
TEST(Invariance, ScalingEachTensorByItsOwnPowerOfTwoKeepsTheTopology) {
  for (const int range : full_or_short<std::vector<int>>({20, 900}, {900})) {
    SCOPED_TRACE(range);
    expect_same_topology(20240902, [range](TetMesh& mesh) {
      Random random(7);
      for (auto& t : mesh.tensors) t = std::ldexp(1.0, random.integer(-range, range)) * t;
    });
  }
}

TEST(Invariance, MixedMagnitudesGiveFiniteSurfacesOnTheLevel) {
  TetMesh mesh = short_field(20240903);
  Random random(8);
  for (auto& t : mesh.tensors) t = std::ldexp(1.0, random.integer(-6, 6)) * t;
  Share share(2);
  for (const char* mode : kLevels) {
    if (!share.has("mode")) continue;
    EXPECT_EQ(flaws(extract(mesh, mode), mesh), "") << mode;
  }
}

TEST(Invariance, PermutingAndReflectingAxesKeepsTheTopology) {
  constexpr std::array<std::array<std::size_t, 3>, 3> permutations{
      {{1, 2, 0}, {0, 2, 1}, {2, 1, 0}}};
  for (std::size_t k = 0; k < permutations.size(); ++k) {
    Matrix r{};
    for (std::size_t i = 0; i < 3; ++i) r[i][permutations[k][i]] = (i + k) % 2 ? -1 : 1;
    expect_same_topology(20240904 + k, [&](TetMesh& mesh) {
      for (auto& t : mesh.tensors) t = congruent(r, t);
    });
  }
}

TEST(Invariance, RotatingTensorsKeepsTheTopology) {
  const std::array<Matrix, 3> rotations{rotation(1, 1, 1, 0), rotation(3, -1, 2, 1),
                                        rotation(0, 2, -3, 5)};
  for (const Matrix& r : rotations)
    expect_same_topology(20240907, [&](TetMesh& mesh) {
      for (auto& t : mesh.tensors) t = congruent(r, t);
    });
}

TEST(Invariance, AddingMultiplesOfTheIdentityKeepsTheTopology) {
  expect_same_topology(
      20240908,
      [](TetMesh& mesh) {
        Random random(9);
        for (auto& t : mesh.tensors) {
          const double pressure = random.integer(-1000000, 1000000);
          t = t + pressure * Tensor{1, 1, 1, 0, 0, 0};
        }
      },
      2);
}

TEST(Invariance, MovingThePointsKeepsTheTopology) {
  expect_same_topology(20240909, [](TetMesh& mesh) {
    for (auto& p : mesh.points)
      p = {3 * p.x + p.y, 0.25 * p.y - 0.125 * p.z, 1000 + p.z + 0.5 * p.x};
  });
}

TEST(Invariance, RenumberingVerticesAndTetrahedraKeepsTheTopology) {
  expect_same_topology(
      20240910,
      [](TetMesh& mesh) {
        Random random(10);
        const std::size_t n = mesh.points.size();
        std::vector<TetMesh::Index> to(n);
        std::iota(to.begin(), to.end(), 0);
        for (std::size_t i = n - 1; i > 0; --i)
          std::swap(to[i], to[static_cast<std::size_t>(random.integer(0, static_cast<int>(i)))]);
        TetMesh old = mesh;
        for (std::size_t i = 0; i < n; ++i) {
          mesh.points[static_cast<std::size_t>(to[i])] = old.points[i];
          mesh.tensors[static_cast<std::size_t>(to[i])] = old.tensors[i];
        }
        std::reverse(mesh.tets.begin(), mesh.tets.end());
        for (auto& tet : mesh.tets) {
          for (auto& v : tet) v = to[static_cast<std::size_t>(v)];
          std::rotate(tet.begin(), tet.begin() + 1, tet.begin() + 3);  // an even permutation
        }
      },
      2);
}

// Of one tetrahedron, too, where the numbering decides how faces are traced.
TEST(Invariance, RenumberingOneTetrahedronKeepsComponentsAndCrossings) {
  const std::uint64_t seed = 20240911;
  SCOPED_TRACE(announce(seed));
  Random random(seed);
  for (int trial = 0; trial < trials(40); ++trial) {
    const TetTensors tensors = random.tet_tensors();
    const char* mode = kLevels[static_cast<std::size_t>(trial) % 8];
    const LocalTopology before = topology_in_tet(extract(reference_tet_mesh(tensors), mode));
    TetMesh mesh = reference_tet_mesh(tensors);
    std::array<TetMesh::Index, 4> order{0, 1, 2, 3};
    for (int turn = trial % 24; turn >= 0; --turn)
      std::next_permutation(order.begin(), order.end());
    const TetMesh old = mesh;
    for (std::size_t i = 0; i < 4; ++i) {
      mesh.points[i] = old.points[static_cast<std::size_t>(order[i])];
      mesh.tensors[i] = old.tensors[static_cast<std::size_t>(order[i])];
    }
    const auto& p = mesh.points;
    mesh.tets = {{0, 1, 2, 3}};
    if (dot(p[1] - p[0], cross(p[2] - p[0], p[3] - p[0])) < 0) mesh.tets = {{0, 2, 1, 3}};
    const LocalTopology after = topology_in_tet(extract(mesh, mode));
    EXPECT_EQ(after.components, before.components) << exact_text(tensors);
    constexpr auto edge = [](TetMesh::Index i, TetMesh::Index j) {
      return static_cast<std::size_t>(i == 0 ? j - 1 : i + j);
    };
    for (TetMesh::Index i = 0; i < 4; ++i)
      for (TetMesh::Index j = i + 1; j < 4; ++j) {
        const auto [u, v] =
            std::minmax(order[static_cast<std::size_t>(i)], order[static_cast<std::size_t>(j)]);
        EXPECT_EQ(after.edge_crossings[edge(i, j)], before.edge_crossings[edge(u, v)]);
      }
  }
}

TEST(Invariance, NegatingTensorsAndModeTurnsTheSurfaceOver) {
  const std::uint64_t seed = 20240912;
  SCOPED_TRACE(announce(seed));
  const TetMesh mesh = short_field(seed);
  TetMesh negated = mesh;
  for (auto& t : negated.tensors) t = -1.0 * t;
  for (const char* mode : {"1/10", "-1/2", "9/10"}) {
    SCOPED_TRACE(mode);
    const Extraction before = extract(mesh, mode),
                     after = extract(negated, ModeValue::parse(mode).opposite().text());
    EXPECT_EQ(unresolved_text(after), "");
    EXPECT_EQ(summary(after.surface), summary(before.surface));
    EXPECT_EQ(flaws(after, negated), "");
    // Crossings are the same points, and the mode increases the other way.
    std::size_t compared = 0;
    for (std::size_t v = 0; v < before.surface.points.size() && v < after.surface.points.size();
         ++v) {
      if (before.surface.carrier[v] != Carrier::edge) continue;
      const auto d = after.surface.points[v] - before.surface.points[v];
      EXPECT_LT(std::sqrt(dot(d, d)), 1e-9);
      EXPECT_LT(dot(after.surface.normal[v], before.surface.normal[v]), -0.5);
      ++compared;
    }
    EXPECT_GT(compared, 20u);
  }
}

}  // namespace
}  // namespace tensortopo::test
