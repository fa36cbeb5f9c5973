// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>

#include "support/generators.hpp"

namespace tensortopo::test {
namespace {

TEST(Random, IsTheSameEverywhere) {
  Random random(2024);
  EXPECT_EQ(exact_text(random.uniform()), "0x1.39b1c9e957cb2p-1");
  EXPECT_EQ(exact_text(random.normal()), "-0x1.65f40d535cp-3");
}

TEST(Random, NormalVariatesHaveMeanZeroAndVarianceOne) {
  Random random(1);
  constexpr int count = 100000;
  double sum = 0, squares = 0, fourths = 0;
  for (int i = 0; i < count; ++i) {
    const double x = random.normal();
    sum += x, squares += x * x, fourths += x * x * x * x;
  }
  EXPECT_NEAR(sum / count, 0, 0.015);
  EXPECT_NEAR(squares / count, 1, 0.02);
  EXPECT_NEAR(fourths / count, 3, 0.15);
}

TEST(Random, IntegersCoverTheirRange) {
  Random random(3);
  std::map<int, int> seen;
  for (int i = 0; i < 1000; ++i) ++seen[random.integer(-2, 2)];
  EXPECT_EQ(seen.size(), 5u);
  EXPECT_EQ(seen.begin()->first, -2);
}

TEST(RandomFields, TextReadsBackBitForBit) {
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    const double x = random.normal() * std::ldexp(1, random.integer(-300, 300));
    EXPECT_EQ(std::strtod(exact_text(x).c_str(), nullptr), x);
  }
  EXPECT_EQ(exact_text(SymmetricTensor<double>{1, 0, -2, 0, 0, 0.5}),
            "{0x1p+0, 0x0p+0, -0x1p+1, 0x0p+0, 0x0p+0, 0x1p-1}");
}

TEST(RandomFields, CubesAreCutInPositiveConformingTetrahedra) {
  for (const int n : {1, 2, 3}) {
    const TetMesh mesh = cube_mesh(n);
    ASSERT_EQ(mesh.tets.size(), static_cast<std::size_t>(6 * n * n * n));
    double volume = 0;
    std::map<std::array<TetMesh::Index, 3>, int> faces;
    for (const auto& tet : mesh.tets) {
      std::array<Vector3<double>, 4> p;
      for (std::size_t i = 0; i < 4; ++i) p[i] = mesh.points[static_cast<std::size_t>(tet[i])];
      const double six = dot(p[1] - p[0], cross(p[2] - p[0], p[3] - p[0]));
      EXPECT_EQ(six, 1);
      volume += six / 6;
      for (std::size_t i = 0; i < 4; ++i) {
        std::array<TetMesh::Index, 3> face{tet[(i + 1) % 4], tet[(i + 2) % 4], tet[(i + 3) % 4]};
        std::sort(face.begin(), face.end());
        ++faces[face];
      }
    }
    EXPECT_NEAR(volume, n * n * n, 1e-12);
    int boundary = 0;
    for (const auto& [face, count] : faces) {
      EXPECT_LE(count, 2);
      boundary += count == 1;
    }
    EXPECT_EQ(boundary, 12 * n * n);
  }
}

TEST(RandomFields, SingleTetrahedraAreMadePositive) {
  Random random(5);
  const TetMesh mesh =
      single_tet_mesh({{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}}}, random.tet_tensors());
  const auto& tet = mesh.tets[0];
  const auto point = [&](std::size_t i) { return mesh.points[static_cast<std::size_t>(tet[i])]; };
  EXPECT_GT(dot(point(1) - point(0), cross(point(2) - point(0), point(3) - point(0))), 0);
}

TEST(RandomFields, SmoothFieldsChangeLittleBetweenNeighbours) {
  TetMesh mesh = cube_mesh(4);
  fill_with_smooth_tensors(mesh, 12, 3, 16);
  ASSERT_EQ(mesh.tensors.size(), mesh.points.size());
  const auto difference = mesh.tensors[1] - mesh.tensors[0];
  EXPECT_LT(inner(difference, difference), inner(mesh.tensors[0], mesh.tensors[0]));
  fill_with_normal_tensors(mesh, 12);
  EXPECT_FALSE(mesh.tensors[0] == mesh.tensors[1]);
}

RC_GTEST_PROP(Generators, SmallIntegerTensorsStayInRange, ()) {
  const auto t = *small_integer_tensor(9);
  for (const double entry : {t.xx, t.yy, t.zz, t.xy, t.yz, t.xz}) {
    RC_ASSERT(entry == std::round(entry));
    RC_ASSERT(std::abs(entry) <= 9);
  }
}

RC_GTEST_PROP(Generators, ModesStayInRange, ()) {
  const double mode = *mode_value(0.95);
  RC_ASSERT(std::abs(mode) > 0);
  RC_ASSERT(std::abs(mode) <= 0.95);
}

// The smallest counterexample to "every entry is less than 2" has one entry 2 and is otherwise 0.
TEST(Generators, FailuresShrinkToReadableTensors) {
  const auto worst = [](const TetTensors& tensors) {
    double largest = 0;
    for (const auto& t : tensors) {
      for (const double entry : {t.xx, t.yy, t.zz, t.xy, t.yz, t.xz}) {
        largest = std::max(largest, entry);
      }
    }
    return largest;
  };
  const auto shrink_fully = [&](rc::Shrinkable<TetSample> current) {
    for (bool moved = true; moved;) {
      moved = false;
      auto candidates = current.shrinks();
      for (auto next = candidates.next(); next; next = candidates.next()) {
        if (worst(next->value().tensors) < 2) continue;
        current = *next;
        moved = true;
        break;
      }
    }
    return current.value();
  };
  const auto first_failure = [&](const rc::Gen<TetSample>& gen) {
    for (std::uint64_t seed = 0;; ++seed) {
      auto drawn = gen(rc::Random(seed), 100);
      if (worst(drawn.value().tensors) >= 2) return drawn;
    }
  };
  const TetSample integers = shrink_fully(first_failure(small_integer_tet()));
  double sum = 0;
  for (const auto& t : integers.tensors) sum += t.xx + t.yy + t.zz + t.xy + t.yz + t.xz;
  EXPECT_EQ(worst(integers.tensors), 2);
  EXPECT_EQ(sum, 2);
  const TetSample normals = shrink_fully(first_failure(normal_tet()));
  for (const auto& t : normals.tensors) EXPECT_EQ(t, rounded(t, 0));
}

}  // namespace
}  // namespace tensortopo::test
