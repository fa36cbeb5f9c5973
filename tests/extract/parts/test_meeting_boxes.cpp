// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "extract/patch/patch_intersections.hpp"

namespace tensortopo::test {
namespace {

using Pairs = std::vector<std::array<std::uint32_t, 2>>;

bool have_a_common_point(const AxisBox& a, const AxisBox& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (std::max(a.low[k], b.low[k]) > std::min(a.high[k], b.high[k])) return false;
  return true;
}

/// The pairs with their members and themselves in ascending order.
Pairs ascending(Pairs pairs) {
  for (auto& pair : pairs) std::sort(pair.begin(), pair.end());
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// Corners are whole numbers, so that many boxes only touch, and many are the same or are points.
std::vector<AxisBox> random_boxes(std::size_t count, int largest, std::mt19937& random) {
  std::uniform_int_distribution<int> place(0, largest), size(0, 2);
  std::vector<AxisBox> boxes(count);
  for (auto& box : boxes)
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = place(random);
      box.high[k] = box.low[k] + size(random);
    }
  return boxes;
}

TEST(MeetingBoxes, AreThePairsWithACommonPointEachOnce) {
  std::mt19937 random(20241124);
  std::size_t compared = 0;
  for (const std::size_t count : {0U, 1U, 2U, 8U, 9U, 17U, 100U, 1500U})
    for (const int largest : {0, 3, 40}) {
      if (count > 100 && largest == 0) continue;  // a million pairs
      const auto boxes = random_boxes(count, largest, random);
      Pairs expected;
      for (std::uint32_t i = 0; i < count; ++i)
        for (std::uint32_t j = i + 1; j < count; ++j)
          if (have_a_common_point(boxes[i], boxes[j])) expected.push_back({i, j});
      EXPECT_EQ(ascending(meeting_boxes(boxes)), expected) << count << ' ' << largest;
      EXPECT_EQ(meeting_boxes(boxes), meeting_boxes(boxes)) << count << ' ' << largest;
      compared += expected.size();
    }
  EXPECT_GT(compared, 10000u);
}

TEST(MeetingBoxes, AStripOfTrianglesIsEmbeddedUntilOneOfThemCrossesAnother) {
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
