// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "extract/patch/patch_extents.hpp"
#include "extract/patch/patch_intersections.hpp"
#include "support/trials.hpp"

namespace tensortopo::test {
namespace {

struct RandomTriangles {
  std::vector<Vector3<double>> points;
  std::vector<PatchTriangle> triangles;
};

/// Coordinates are whole numbers, so that many triangles share vertices, touch, or have no area.
RandomTriangles random_triangles(std::size_t count, int largest, std::mt19937& random) {
  std::uniform_int_distribution<int> place(0, largest);
  RandomTriangles result;
  for (std::size_t i = 0; i < count; ++i)
    result.points.push_back({static_cast<double>(place(random)), static_cast<double>(place(random)),
                             static_cast<double>(place(random))});
  std::uniform_int_distribution<std::uint32_t> corner(0, static_cast<std::uint32_t>(count - 1));
  while (result.triangles.size() < count) {
    const PatchTriangle t{corner(random), corner(random), corner(random)};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) result.triangles.push_back(t);
  }
  return result;
}

TEST(PatchIntersections, AWitnessIsFoundIfAndOnlyIfThereIsAPair) {
  std::mt19937 random(20261127);
  std::size_t with_other = 0, with_itself = 0, without = 0;
  for (int trial = 0; trial < trials(2000); ++trial) {
    const auto [points, triangles] = random_triangles(6, 9, random);
    const auto all = intersecting_pairs(points, triangles).pairs;
    const std::vector<PatchTriangle> fresh(triangles.begin(), triangles.begin() + 2),
        rest(triangles.begin() + 2, triangles.end());
    // The patch begins as the fresh triangles, and becomes the rest one by one; the first of them
    // is replaced.
    const std::vector<std::uint32_t> replaced{0};
    std::vector<PatchTriangle> patch = fresh;
    PatchExtents extents(points, patch);
    for (std::size_t i = 0; i < rest.size(); ++i) {
      patch.resize(std::max(patch.size(), i + 1));
      patch[i] = rest[i];
      extents.set(i, points, rest[i]);
    }
    const auto is_pair = [&](std::uint32_t a, std::uint32_t b) {
      return std::find(all.begin(), all.end(), std::array{a, b}) != all.end();
    };
    std::size_t expected = rest.size() + 1;
    for (std::uint32_t other = 1; other < rest.size() && expected > rest.size(); ++other)
      if (is_pair(0, other + 2) || is_pair(1, other + 2)) expected = other;
    if (is_pair(0, 1)) expected = rest.size();
    std::size_t tested = 0;
    const auto found = extents.find_intersection(points, patch, replaced, fresh, tested);
    EXPECT_LE(tested, fresh.size() * (rest.size() - 1) + 1);
    EXPECT_EQ(found.value_or(rest.size() + 1), expected);
    without += expected > rest.size();
    with_itself += expected == rest.size();
    with_other += expected < rest.size();
  }
  EXPECT_GT(std::min({with_other, with_itself, without}), 20u);
}

TEST(PatchIntersections, FewerTestsFindAPairIfThereIsOne) {
  std::mt19937 random(7);
  std::size_t cut_short = 0, without = 0;
  for (int trial = 0; trial < trials(400); ++trial) {
    const bool is_dense = trial % 2 == 0;
    const auto [points, triangles] =
        is_dense ? random_triangles(12, 7, random) : random_triangles(4, 60, random);
    const auto all = intersecting_pairs(points, triangles);
    ASSERT_TRUE(all.are_all);
    for (const std::size_t most : {0u, 1u, 5u, 1000u}) {
      const auto some = intersecting_pairs(points, triangles, most);
      EXPECT_EQ(some.pairs.empty(), all.pairs.empty());
      EXPECT_TRUE(
          std::includes(all.pairs.begin(), all.pairs.end(), some.pairs.begin(), some.pairs.end()));
      if (some.are_all) {
        EXPECT_EQ(some.pairs, all.pairs);
        EXPECT_EQ(some.tested, all.tested);
      }
      cut_short += !some.are_all;
    }
    without += all.pairs.empty();
  }
  EXPECT_GT(cut_short, 100u);
  EXPECT_GT(without, 0u);
}

// Triangles that share one corner meet elsewhere if and only if their angles there have a ray in
// common, whatever the sizes. Of the small ones the normal has no accurate double.
TEST(PatchIntersections, AreDecidedExactlyNextToTrianglesWithTinyNormals) {
  std::mt19937 random(20261128);
  std::uniform_int_distribution<int> whole(-9, 9), far_exponent(60, 330), tiny_exponent(-545, -530);
  const auto times = [](int exponent, const Vector3<double>& v) {
    return Vector3<double>{std::ldexp(v.x, exponent), std::ldexp(v.y, exponent),
                           std::ldexp(v.z, exponent)};
  };
  const auto vector = [&] {
    return Vector3<double>{1.0 * whole(random), 1.0 * whole(random), 1.0 * whole(random)};
  };
  std::size_t with = 0, without = 0;
  for (int trial = 0; trial < trials(20000); ++trial) {
    std::vector<Vector3<double>> points{{}, vector(), vector(), vector(), vector()};
    const std::vector<PatchTriangle> triangles{{0, 1, 2}, {0, 3, 4}};
    // Far enough that no two corners are at one place.
    const int far = far_exponent(random), tiny = tiny_exponent(random);
    for (std::size_t i = 3; i < 5; ++i) points[i] = times(40, points[i]);
    const bool expected = !intersecting_pairs(points, triangles).pairs.empty();
    for (std::size_t i = 1; i < 3; ++i) points[i] = times(tiny, points[i]);
    for (std::size_t i = 3; i < 5; ++i) points[i] = times(far - 40, points[i]);
    EXPECT_EQ(!intersecting_pairs(points, triangles).pairs.empty(), expected)
        << tiny << ' ' << far << ' ' << trial;
    (expected ? with : without)++;
  }
  EXPECT_GT(std::min(with, without), 50u);
}

TEST(PatchIntersections, AStripOfTrianglesIsEmbeddedUntilOneOfThemCrossesAnother) {
  constexpr std::uint32_t kLength = 5000;
  std::vector<Vector3<double>> points;
  std::vector<PatchTriangle> triangles;
  for (std::uint32_t i = 0; i < kLength; ++i)
    points.push_back({0.5 * i, i % 2 == 0 ? 0.0 : 1.0, 0.125 * (i % 3)});
  for (std::uint32_t i = 0; i + 2 < kLength; ++i) triangles.push_back({i, i + 1, i + 2});
  EXPECT_TRUE(are_embedded(points, triangles));
  const auto n = static_cast<std::uint32_t>(points.size());
  points.push_back({1200.25, 0.5, -1});
  points.push_back({1200.25, 0.5, 1});
  points.push_back({1200.5, 5, 0});
  triangles.push_back({n, n + 1, n + 2});
  EXPECT_FALSE(are_embedded(points, triangles));
}

}  // namespace
}  // namespace tensortopo::test
