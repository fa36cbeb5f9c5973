// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "extract/patch/triangle_pair.hpp"

namespace tensortopo {

/// Three directions of a patch: that in which it is longest, the next one, and one across both.
/// Boxes along the axes overlap wherever triangles around a thin tube are oblique to these.
class PatchDirections {
 public:
  /// The directions of no points: all extents are one.
  PatchDirections() = default;
  explicit PatchDirections(std::span<const Vector3<double>> points);

  /// Intervals that hold the products of a triangle's points with the directions.
  AxisBox extent(std::span<const Vector3<double>> points, const PatchTriangle& triangle) const;

 private:
  Vector3<double> from_{};
  std::array<Vector3<double>, 3> directions_{};  ///< about orthogonal, and exact as they are
};

/// The extents and planes of the triangles of a patch, which change one by one.
class PatchExtents {
 public:
  PatchExtents(std::span<const Vector3<double>> points, std::span<const PatchTriangle> triangles);

  /// Sets those of a triangle, or adds one more. It has to be called for all triangles whose corners
  /// have moved before others are compared with them.
  /// @pre `triangle` is at most the number of extents
  void set(std::size_t triangle, std::span<const Vector3<double>> points,
           const PatchTriangle& corners);

  /// Whether new triangles would be a pair, as those of `intersecting_pairs`, with a triangle of
  /// the patch, or two of them with each other.
  ///
  /// @param triangles of the patch, as many as extents; one with equal corners is not there
  /// @param replaced  of the patch, which the new ones replace
  /// @param tested    grows by the number of pairs that are compared by more than their boxes
  /// @return nothing if they are not; else the first such triangle of the patch, or the number of
  ///         these if two of the new ones are
  std::optional<std::size_t> find_intersection(std::span<const Vector3<double>> points,
                                               std::span<const PatchTriangle> triangles,
                                               std::span<const std::uint32_t> replaced,
                                               std::span<const PatchTriangle> fresh,
                                               std::size_t& tested) const;

 private:
  PatchDirections directions_;
  std::vector<AxisBox> extents_;
  std::vector<detail::Side> sides_;
};

}  // namespace tensortopo
