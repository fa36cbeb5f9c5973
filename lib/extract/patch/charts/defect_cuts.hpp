// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "extract/patch/charts/chart_triangulation.hpp"
#include "extract/patch/patch_defects.hpp"

namespace tensortopo {

/// Where triangles of a chart are to be made finer so that they become free of `PatchDefects`: on
/// the longest edge, seen in space, of each that is not, or amid it if that edge is a segment.
///
/// @param points   the places of the chart's points in space
/// @param segments of the boundary loops, with the sheet on the left
class DefectCuts {
 public:
  template <class Scalar>
  explicit DefectCuts(const TetWithCurves<Scalar>& tet) : test_(tet) {}

  /// For one triangulation after the other; no cuts once they do not help any more.
  std::vector<ChartTriangulation::Cut> operator()(
      std::span<const ChartTriangulation::Triangle> triangles,
      std::span<const Vector3<double>> points,
      std::span<const std::array<std::size_t, 2>> segments);

 private:
  UpwardTest test_;
  std::size_t fewest_ = SIZE_MAX;  ///< triangles with defects so far
  int since_ = 0;                  ///< how many triangulations ago
};

}  // namespace tensortopo
