// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tensortopo/analysis/progress.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// Timings of ours and of VTK's contours, side by side in one process.
struct BenchCommand {
  std::filesystem::path input;
  std::vector<ModeValue> modes;  ///< of each, the surfaces of M and -M
  int repeat = 5;                ///< at least 5
};

/// A contender's times, one for each repetition, for all modes together.
struct BenchSeries {
  std::string name;
  std::vector<double> seconds;
  std::size_t triangles = 0;
  double median() const;
};

struct BenchReport {
  std::filesystem::path input;
  std::vector<ModeValue> modes;
  std::size_t tetrahedra = 0;
  std::size_t threads = 0;
  std::vector<BenchSeries> series;       ///< the first is ours
  std::map<std::string, double> stages;  ///< of our median repetition: edges, faces, tets, stitch
  std::size_t peak_memory_bytes = 0;     ///< after our first run, before VTK's; the mesh included
};

/// Reads the mesh, then times, in turn and `repeat` times:
///   extract                       extract_mode_surface for each M and -M
///   vtk_contour                   vtkContourGrid on the modes of the vertices, values M and -M,
///                                 no normals
///   vtk_contour_3d_linear_grid    vtkContour3DLinearGrid, the same, with shared vertices as ours
/// No reading, no writing, and no computing of the vertices' modes is timed; each contender may
/// use all threads. One run of each beforehand is not counted. Throws UsageError, IoError.
BenchReport run_bench(const BenchCommand& command, const Progress& progress = {});

/// One JSON object. Ends without newline.
std::string to_json(const BenchReport& report);
/// A table for people. Ends with a newline.
std::string to_text(const BenchReport& report);

}  // namespace tensortopo
