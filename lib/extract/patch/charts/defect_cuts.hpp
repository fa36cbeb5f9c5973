// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
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
std::vector<ChartTriangulation::Cut> cuts_at_defects(
    std::span<const ChartTriangulation::Triangle> triangles,
    std::span<const Vector3<double>> points,
    std::span<const std::array<std::size_t, 2>> segments, const UpwardTest& test);

}  // namespace tensortopo
