// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/curves.hpp"
#include "bench/judge.hpp"
#include "bench/timing.hpp"
#include "tensortopo/analysis/progress.hpp"
#include "tensortopo/io/read_mesh.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// Timings of ours and of other methods, side by side in one process.
struct BenchCommand {
  std::filesystem::path input;
  ReadOptions read;
  std::vector<ModeValue> modes;  ///< of each, the surfaces of M and -M
  int repeat = 5;                ///< at least 5
  /// Seconds after which no further repetition begins, and no further setting is tried for an equal
  /// error.
  double longest = std::numeric_limits<double>::infinity();
  /// Which of `comparisons` to run beside the plain ones; if not given, "certified" alone, since
  /// the others take a hundred times as long.
  std::optional<std::vector<std::string>> only;
  bool all = false;     ///< all of these
  bool curves = false;  ///< time against error as well

  /// "certified", "manifold", "a_patches", "hybrid", "vtk_subdivided", "errors".
  static const std::vector<std::string>& comparisons();
};

/// A quotient of medians, or why there is none.
struct BenchRatio {
  std::string name;
  std::optional<double> value;
  std::string note;  ///< what was compared, or why not
};

struct BenchReport {
  std::filesystem::path input;
  std::vector<ModeValue> modes;
  std::vector<std::string> notes;  ///< of reading
  std::size_t tetrahedra = 0;
  std::size_t threads = 0;
  std::vector<BenchSeries> series;  ///< the first is ours
  std::vector<BenchRatio> ratios;
  std::map<std::string, double> stages;  ///< of our median repetition: edges, faces, tets, stitch
  std::size_t peak_memory_bytes = 0;     ///< after our first run, before others'; the mesh included
  std::vector<MethodErrors> errors;      ///< empty if none was measured
  std::size_t undecided = 0;             ///< tetrahedra without truth, if there are errors
  std::vector<ErrorCurve> curves;        ///< if asked for

  /// The note of a ratio for which `BenchCommand::longest` does not suffice.
  static std::string no_time() { return "not run: no time left, see --budget"; }
  /// The note of a ratio that was not asked for.
  static std::string not_asked() { return "not run: see --only and --all"; }
};

/// Threads that a contender may use.
std::size_t threads_in_use();

/// Reads the mesh, then times, in turn and `repeat` times:
///   extract                       extract_mode_surface for each M and -M
///   vtk_contour                   vtkContourGrid on the modes of the vertices, values M and -M,
///                                 no normals
///   vtk_contour_3d_linear_grid    vtkContour3DLinearGrid, the same, with shared vertices as ours
/// and if asked for:
///   certified                     extraction with everything that a certificate claims
///   manifold                      extraction, meshed on the manifold (`MeshingMethod::manifold`)
///   a_patches                     the baseline at its defaults, or coarser where our error does
///                                 not come down to its
///   extract_for_a_patches         ours at the lowest resolution of 1, 2, 4, 8, 16 at which our
///                                 error is at most its
///   hybrid, extract_for_hybrid    the same for neutral surfaces (whatever the modes are)
///   vtk_subdivided                vtkContour3DLinearGrid on the mesh subdivided as often as its
///                                 error takes to be ours at most
///   vtk_subdivided_whole          the same, with the subdivision and the modes of its vertices
/// No reading, no writing, and (but for the last) no computing of the vertices' modes is timed;
/// each contender may use all threads. One run of each of the plain ones beforehand is not counted.
/// Errors are two-sided root mean squares of distances (see LevelDistance). Throws UsageError,
/// IoError.
BenchReport run_bench(const BenchCommand& command, const Progress& progress = {});

/// One JSON object. Ends without newline.
std::string to_json(const BenchReport& report);
/// A table for people. Ends with a newline.
std::string to_text(const BenchReport& report);

}  // namespace tensortopo
