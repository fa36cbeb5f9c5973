// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/mesh/box_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <vector>

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

TEST(AxisBox, OfPointsIsTheHullOfTheirBoxesAndTheSmallestThatHoldsThem) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> place(-5, 5);
  EXPECT_FALSE(boxes_meet(box_of({}), AxisBox{{-1, -1, -1}, {1, 1, 1}}));
  for (std::size_t count = 1; count < 8; ++count) {
    std::vector<Vector3<double>> points;
    AxisBox around = box_of({});
    for (std::size_t i = 0; i < count; ++i) {
      points.push_back({1.0 * place(random), 1.0 * place(random), 1.0 * place(random)});
      around = hull(box_of(std::span(points).last(1)), around);
    }
    const AxisBox box = box_of(points);
    EXPECT_EQ(box.low, around.low);
    EXPECT_EQ(box.high, around.high);
    const auto by = [](double Vector3<double>::*axis) {
      return [axis](const auto& p, const auto& q) { return p.*axis < q.*axis; };
    };
    const auto [left, right] =
        std::minmax_element(points.begin(), points.end(), by(&Vector3<double>::y));
    EXPECT_EQ(box.low[1], left->y);
    EXPECT_EQ(box.high[1], right->y);
  }
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

}  // namespace
}  // namespace tensortopo::test
