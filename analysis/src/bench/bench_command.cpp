// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "bench/bench_command.hpp"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <functional>

#include "bench/vtk_contours.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/extract/extract_mode_surface.hpp"
#include "tensortopo/io/read_mesh.hpp"

namespace tensortopo {
namespace {

constexpr int kFewest = 5;

std::size_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
}

std::size_t threads_in_use() {
  const std::size_t allowed =
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return std::min(allowed, static_cast<std::size_t>(tbb::info::default_concurrency()));
}

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Where the median stands among the values (the upper one of two).
std::size_t median_place(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  return order[order.size() / 2];
}

// Our surfaces of all modes: the number of triangles, and the stages' seconds.
std::size_t extract_all(const TetMesh& mesh, const std::vector<ModeValue>& modes,
                        std::map<std::string, double>& stages) {
  std::size_t triangles = 0;
  stages.clear();
  using Use = PreparedField<double>::Use;
  const PreparedField<double> field(mesh, modes.size() > 1 ? Use::several_modes : Use::one_mode);
  for (const ModeValue& mode : modes) {
    const Extraction extraction = extract_mode_surface(field, mode);
    triangles += extraction.surface.triangles.size();
    stages["edges"] += extraction.statistics.seconds_edges;
    stages["faces"] += extraction.statistics.seconds_faces;
    stages["tets"] += extraction.statistics.seconds_tets;
    stages["stitch"] += extraction.statistics.seconds_stitch;
  }
  return triangles;
}

}  // namespace

double BenchSeries::median() const { return seconds.at(median_place(seconds)); }

BenchReport run_bench(const BenchCommand& command, const Progress& progress) {
  if (command.repeat < kFewest) throw UsageError("--repeat: must be at least 5");
  if (command.modes.empty()) throw UsageError("no mode given");
  const auto tell = [&](double fraction) {
    if (progress) progress("timing", fraction);
  };
  tell(0);
  const ReadResult read = read_mesh(command.input);
  std::vector<ModeValue> modes;
  std::vector<double> values;
  for (const ModeValue& mode : command.modes) {
    for (const ModeValue& either : {mode, mode.opposite()}) {
      if (std::find(modes.begin(), modes.end(), either) != modes.end()) continue;
      modes.push_back(either);
      values.push_back(either.approx());
    }
  }

  BenchReport report;
  report.input = command.input;
  report.modes = command.modes;
  report.tetrahedra = read.mesh.tets.size();
  report.threads = threads_in_use();
  report.series = {
      {"extract", {}, 0}, {"vtk_contour", {}, 0}, {"vtk_contour_3d_linear_grid", {}, 0}};

  std::map<std::string, double> stages;
  extract_all(read.mesh, modes, stages);
  report.peak_memory_bytes = peak_memory_bytes();
  VtkContours vtk(read.mesh, static_cast<int>(report.threads));
  vtk.contour_grid(values);
  vtk.contour_3d_linear_grid(values);

  std::vector<std::map<std::string, double>> stages_of_runs;
  const std::vector<std::function<std::size_t()>> contenders{
      [&] { return extract_all(read.mesh, modes, stages); },
      [&] { return vtk.contour_grid(values); }, [&] { return vtk.contour_3d_linear_grid(values); }};
  for (int run = 0; run < command.repeat; ++run) {
    tell(static_cast<double>(run) / command.repeat);
    for (std::size_t i = 0; i < contenders.size(); ++i) {
      BenchSeries& series = report.series[i];
      series.seconds.push_back(seconds_of([&] { series.triangles = contenders[i](); }));
    }
    stages_of_runs.push_back(stages);
  }
  report.stages = stages_of_runs[median_place(report.series.front().seconds)];
  return report;
}

}  // namespace tensortopo
