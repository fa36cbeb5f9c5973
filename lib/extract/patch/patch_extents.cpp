// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/patch_extents.hpp"

#include <algorithm>
#include <cmath>

namespace tensortopo {

namespace {

using detail::largest, detail::Side;

/// The longest of some differences between points and a place, as `part` sees them, with its
/// largest coordinate made 1; zero if all are.
template <class Part>
Vector3<double> longest(std::span<const Vector3<double>> points, const Vector3<double>& from,
                        const Part& part) {
  Vector3<double> result{};
  for (const auto& p : points)
    if (const auto d = part(p - from); largest(d) > largest(result)) result = d;
  const double size = largest(result);
  return size > 0 ? (1 / size) * result : result;
}

}  // namespace

PatchDirections::PatchDirections(std::span<const Vector3<double>> points) {
  if (points.empty()) return;
  from_ = points[0];
  Vector3<double> end = from_;
  for (const auto& p : points)
    if (largest(p - from_) > largest(end - from_)) end = p;
  const auto along = longest(points, end, [](const auto& d) { return d; });
  if (largest(along) == 0) return;
  const auto beside = longest(
      points, end, [&](const auto& d) { return d - (dot(along, d) / dot(along, along)) * along; });
  directions_ = {along, beside, cross(along, beside)};
}

/// Rounding is allowed for as in `kRoundings`.
AxisBox PatchDirections::extent(std::span<const Vector3<double>> points,
                                const PatchTriangle& triangle) const {
  AxisBox extent{{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
  for (const auto v : triangle) {
    const auto d = points[v] - from_;
    for (std::size_t k = 0; k < 3; ++k) {
      const double place = dot(directions_[k], d);
      const double error =
          detail::kRoundings * largest(directions_[k]) * largest(d) + detail::kUnderflow;
      extent.low[k] = std::min(extent.low[k], place - error);
      extent.high[k] = std::max(extent.high[k], place + error);
    }
  }
  return extent;
}

PatchExtents::PatchExtents(std::span<const Vector3<double>> points,
                           std::span<const PatchTriangle> triangles)
    : directions_(points) {
  extents_.reserve(triangles.size());
  sides_.reserve(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) set(t, points, triangles[t]);
}

void PatchExtents::set(std::size_t triangle, std::span<const Vector3<double>> points,
                       const PatchTriangle& corners) {
  if (triangle == extents_.size()) extents_.emplace_back(), sides_.emplace_back();
  extents_[triangle] = directions_.extent(points, corners);
  sides_[triangle] = detail::side_of(points, corners);
}

std::optional<std::size_t> PatchExtents::find_intersection(std::span<const Vector3<double>> points,
                                                           std::span<const PatchTriangle> triangles,
                                                           std::span<const std::uint32_t> replaced,
                                                           std::span<const PatchTriangle> fresh,
                                                           std::size_t& tested) const {
  if (fresh.empty()) return std::nullopt;
  thread_local std::vector<Side> sides;
  thread_local std::vector<AxisBox> extents;
  sides.clear(), extents.clear();
  for (const auto& t : fresh) {
    sides.push_back(detail::side_of(points, t));
    extents.push_back(directions_.extent(points, t));
  }
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = i + 1; j < sides.size(); ++j)
      if (++tested, are_in_conflict(sides[i], sides[j])) return triangles.size();
  AxisBox all = extents[0];
  for (const auto& e : extents) all = hull(all, e);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (!boxes_meet(extents_[t], all) || triangles[t][0] == triangles[t][1] ||
        std::find(replaced.begin(), replaced.end(), t) != replaced.end())
      continue;
    for (std::size_t i = 0; i < sides.size(); ++i)
      if (boxes_meet(extents_[t], extents[i]) && (++tested, are_in_conflict(sides[i], sides_[t])))
        return t;
  }
  return std::nullopt;
}

}  // namespace tensortopo
