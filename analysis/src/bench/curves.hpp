// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "bench/judge.hpp"
#include "bench/timing.hpp"
#include "tensortopo/analysis/progress.hpp"

namespace tensortopo {

/// What one setting of a method costs, and how far its surfaces are from the level.
struct ErrorPoint {
  std::string setting;
  double seconds = 0;  ///< median
  double root_mean_square = 0, largest = 0;
  std::size_t triangles = 0;
};

struct ErrorCurve {
  std::string method;
  std::vector<ErrorPoint> points;  ///< from coarse to fine
  std::string note;                ///< why there are no points
};

/// Time against error for the surfaces of all modes together: ours over resolutions, A-patches over
/// samples of a patch, VTK's vtkContour3DLinearGrid over subdivisions (done, with the modes of
/// the vertices, in the time; up to 1,000,000 tetrahedra), and for mode 0 alone the hybrid method
/// over its flatness. All settings are timed in turn, `repeat` times.
/// @param modes  each that is wanted, opposites included
std::vector<ErrorCurve> error_curves(const TetMesh& mesh, const std::vector<ModeValue>& modes,
                                     int repeat, const Progress& progress = {});

/// Error against time, both logarithmic, as the bytes of a PNG.
std::string curves_chart(const std::vector<ErrorCurve>& curves, const std::string& title);

}  // namespace tensortopo
