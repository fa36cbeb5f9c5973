// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "extract/cases/extract_case.hpp"
#include "extract/patch/quality/cell_patch.hpp"
#include "support/trials.hpp"

namespace tensortopo::test {
namespace {

using Id = CellPatch::Id;

/// The tensor with eigenvalues 1, z and -1 - z along the axes: its mode falls with z.
Deviator<double> tensor_at_height(double z) { return {1 - z, 1 + 2 * z, 0, 0, 0}; }

TetWithCurves<double> layered_tet() {
  TetWithCurves<double> tet{};
  tet.points = {Vector3<double>{-4, -4, -1}, {8, -4, -1}, {-4, 8, -1}, {0, 0, 3}};
  for (std::size_t i = 0; i < 4; ++i)
    tet.simplex.tensors[i] = tensor_at_height(0.1 * tet.points[i].z);
  return tet;
}

/// Two grids above each other, clockwise seen from above, whose vertices are moved at random: some
/// triangles are turned over, and some of the two grids intersect.
Patch<double> two_layers(const TetWithCurves<double>& tet, std::mt19937& random) {
  constexpr int kSide = 5;
  const TetGeometry geometry(tet.points, tet.simplex.exponents);
  std::uniform_real_distribution<double> shift(-1, 1);
  Patch<double> patch;
  for (const double z : {0.0, 0.05}) {
    const auto first = static_cast<Id>(patch.inner.size());
    for (int i = 0; i < kSide; ++i)
      for (int j = 0; j < kSide; ++j) {
        const Vector3<double> x{0.25 * i - 0.5 + 0.1 * shift(random),
                                0.25 * j - 0.5 + 0.1 * shift(random), z + 0.03 * shift(random)};
        InnerVertex<double> vertex;
        for (std::size_t k = 0; k < 4; ++k) vertex.weights[k] = geometry.weight(k, x);
        patch.inner.push_back(vertex);
      }
    const auto id = [&](int i, int j) { return -1 - (first + kSide * i + j); };
    for (int i = 0; i + 1 < kSide; ++i)
      for (int j = 0; j + 1 < kSide; ++j) {
        patch.triangles.push_back({id(i, j), id(i, j + 1), id(i + 1, j)});
        patch.triangles.push_back({id(i + 1, j), id(i, j + 1), id(i + 1, j + 1)});
      }
  }
  return patch;
}

TEST(CellPatch, AnswersAfterMovesAreThoseOfANewPatch) {
  std::mt19937 random(20261127);
  const auto tet = layered_tet();
  const auto level = make_level<double>(ModeValue::parse("0"));
  std::array<std::size_t, 2> answers{};
  std::size_t moves = 0;
  for (int trial = 0; trial < trials(12); ++trial) {
    const auto made = two_layers(tet, random);
    CellPatch patch(tet, level, {}, made);
    for (int round = 0; round < 8; ++round) {
      auto fresh_patch = made;
      fresh_patch.triangles = patch.triangles();
      CellPatch fresh(tet, level, {}, fresh_patch);
      std::vector<std::pair<Id, Id>> allowed;
      for (const auto& t : fresh_patch.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
          const Id from = t[k], to = t[(k + 1) % 3];
          const bool is_embedded = patch.is_embedded_after(from, to);
          EXPECT_EQ(is_embedded, fresh.is_embedded_after(from, to)) << trial << ' ' << round;
          EXPECT_EQ(is_embedded, patch.is_embedded_after(from, to));
          ++answers[is_embedded];
          if (is_embedded) allowed.emplace_back(from, to);
        }
      if (allowed.empty()) break;
      const auto [from, to] = allowed[random() % allowed.size()];
      patch.move(from, to);
      ++moves;
    }
  }
  EXPECT_GT(answers[0], 100u);
  EXPECT_GT(answers[1], 100u);
  EXPECT_GT(moves, 10u);
}

/// A fan in half of a disc, clockwise seen from above; the first vertex is its centre.
Patch<double> half_fan(const TetWithCurves<double>& tet, int triangles) {
  const TetGeometry geometry(tet.points, tet.simplex.exponents);
  Patch<double> patch;
  const auto add = [&](const Vector3<double>& x) {
    InnerVertex<double> vertex;
    for (std::size_t k = 0; k < 4; ++k) vertex.weights[k] = geometry.weight(k, x);
    patch.inner.push_back(vertex);
  };
  add({0, 0, 0});
  for (int k = 0; k <= triangles; ++k) {
    const double angle = std::numbers::pi * k / triangles;
    add({0.5 * std::cos(angle), 0.5 * std::sin(angle), 0});
  }
  for (int k = 0; k < triangles; ++k) patch.triangles.push_back({-1, -3 - k, -2 - k});
  return patch;
}

// Fans that move from vertex to vertex would grow, and all pairs of their triangles are tested.
TEST(CellPatch, OnlyVerticesOfFewTrianglesMove) {
  const auto tet = layered_tet();
  const auto level = make_level<double>(ModeValue::parse("0"));
  for (int triangles = 3; triangles < 40; ++triangles) {
    CellPatch patch(tet, level, {}, half_fan(tet, triangles));
    EXPECT_EQ(patch.least_sine_after(-1, -2, 0, 0.5) > 0, triangles <= 16) << triangles;
  }
}

TEST(CellPatch, AreaOfAPolygonIsThatWithoutACornerAndTheCorner) {
  std::mt19937 random(20261128);
  const auto tet = layered_tet();
  const auto made = two_layers(tet, random);
  const CellPatch patch(tet, make_level<double>(ModeValue::parse("0")), {}, made);
  std::vector<Id> polygon(made.inner.size());
  std::iota(polygon.begin(), polygon.end(), -static_cast<Id>(polygon.size()));
  for (std::size_t compared = 0; compared < 100; ++compared) {
    std::shuffle(polygon.begin(), polygon.end(), random);
    const std::vector<Id> without(polygon.begin(), polygon.end() - 1);
    const std::array corner{polygon[polygon.size() - 2], polygon.back(), polygon[0]};
    const auto rest = patch.area_of(polygon) - patch.area_of(without) - patch.area_of(corner);
    EXPECT_LT(dot(rest, rest), 1e-24);
    EXPECT_GT(dot(patch.area_of(corner), patch.area_of(corner)), 1e-12);
  }
}

}  // namespace
}  // namespace tensortopo::test
