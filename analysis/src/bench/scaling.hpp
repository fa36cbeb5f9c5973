// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "tensortopo/analysis/progress.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// What the time of an extraction is plotted over.
enum class ScalingOver {
  size,     ///< tetrahedra of Kelvin's field, made in memory: powers of 10 from 10^4
  mode,     ///< M and -M, from 0 to 0.9999
  threads,  ///< 1, 2, 4, .. up to all that may be used
  modes,    ///< number of modes in one run: 1, 2, 4, 8, 16, evenly spread
};

struct ScalingCommand {
  ScalingOver over = ScalingOver::size;
  std::filesystem::path input;    ///< but for `size`
  ReadOptions read;
  std::vector<ModeValue> modes;   ///< of `size` and `threads`; each with its opposite
  std::size_t largest = 1'000'000;  ///< tetrahedra, of `size`
  int repeat = 5;                 ///< at least 5
  /// Seconds after which no further repetition begins.
  double longest = std::numeric_limits<double>::infinity();
};

struct ScalingPoint {
  double x = 0;
  std::size_t tetrahedra = 0, triangles = 0;
  double seconds = 0;      ///< ours, median
  double vtk_seconds = 0;  ///< of vtkContourGrid beside it; 0 if it was not run
};

struct ScalingReport {
  ScalingOver over = ScalingOver::size;
  std::string field;
  std::vector<std::string> notes;  ///< of reading
  std::size_t threads = 0;
  std::vector<ScalingPoint> points;
  /// The exponent of the power law that fits best (see power_law_exponent); NaN where x is no
  /// amount (`mode`).
  double exponent = 0, vtk_exponent = 0;
  /// Of `threads`, see `serial_share`; else NaN.
  double serial_share = 0;
};

std::string_view name_of(ScalingOver over);

/// Times extractions in turn (one mesh after the other for `size`, which do not fit into memory
/// together; VTK's contours in turn with ours there and for `mode`). Throws UsageError, IoError.
ScalingReport run_scaling(const ScalingCommand& command, const Progress& progress = {});

/// One JSON object. Ends without newline.
std::string to_json(const ScalingReport& report);
/// A table for people. Ends with a newline.
std::string to_text(const ScalingReport& report);
/// The bytes of a PNG.
std::string scaling_chart(const ScalingReport& report);

}  // namespace tensortopo
