// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/patch_intersections.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <numeric>
#include <utility>

#include "extract/patch/patch_extents.hpp"
#include "tensortopo/mesh/box_tree.hpp"
#include "tensortopo/scalar/floating_point_environment.hpp"

namespace tensortopo {

namespace {

using detail::Same, detail::Side;

constexpr std::size_t kPart = 1024;  ///< boxes that one thread takes at a time

void make_sides(std::span<const Vector3<double>> points, std::span<const PatchTriangle> triangles,
                std::vector<Side>& sides) {
  sides.clear();
  sides.reserve(triangles.size());
  for (const auto& t : triangles) sides.push_back(detail::side_of(points, t));
}

/// Calls the body for the parts of 0 to count - 1, in parallel, with the rounding that predicates
/// need.
template <class Body>
void for_parts(std::size_t count, const Body& body) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, kPart), [&](const auto& range) {
    const FloatingPointEnvironment environment;
    body(range.begin(), range.end());
  });
}

}  // namespace

IntersectingPairs intersecting_pairs(std::span<const Vector3<double>> points,
                                     std::span<const PatchTriangle> triangles,
                                     std::size_t most_tested) {
  // Nearly all patches are small: no memory for each of them.
  thread_local std::vector<Side> sides;
  make_sides(points, triangles, sides);
  thread_local std::vector<Vector3<double>> corners;
  corners.clear();
  for (const auto& side : sides)
    corners.insert(corners.end(), side.corners.begin(), side.corners.end());
  const PatchDirections directions(corners);
  thread_local std::vector<AxisBox> extents;
  extents.clear();
  for (const auto& t : triangles) extents.push_back(directions.extent(points, t));
  thread_local std::vector<std::uint32_t> order;
  order.resize(sides.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return std::pair(extents[i].low[0], i) < std::pair(extents[j].low[0], j);
  });
  IntersectingPairs result;
  for (std::size_t i = 0; i < order.size() && result.are_all; ++i)
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      if (extents[order[j]].low[0] > extents[order[i]].high[0]) break;
      if (!boxes_meet(extents[order[i]], extents[order[j]])) continue;
      if (result.tested >= most_tested && !result.pairs.empty()) {
        result.are_all = false;
        break;
      }
      ++result.tested;
      if (!are_in_conflict(sides[order[i]], sides[order[j]])) continue;
      const auto [a, b] = std::minmax(order[i], order[j]);
      result.pairs.push_back({a, b});
    }
  std::sort(result.pairs.begin(), result.pairs.end());
  return result;
}

bool are_embedded(std::span<const Vector3<double>> points,
                  std::span<const PatchTriangle> triangles) {
  std::vector<Side> sides(triangles.size());
  std::vector<AxisBox> boxes(triangles.size());
  std::atomic<bool> is_embedded{true};
  for_parts(sides.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      sides[i] = detail::side_of(points, triangles[i]);
      boxes[i] = {sides[i].low, sides[i].high};
      if (!sides[i].has_area) is_embedded = false;
    }
  });
  if (!is_embedded) return false;
  const BoxTree tree(boxes);
  for_parts(tree.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t rank = begin; rank < end && is_embedded; ++rank)
      if (tree.any_meeting(rank, [&](std::uint32_t i, std::uint32_t j) {
            return detail::intersect<Same::number>(sides[i], sides[j]);
          }))
        is_embedded = false;
  });
  return is_embedded;
}

}  // namespace tensortopo
