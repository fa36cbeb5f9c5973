// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "bench/scaling.hpp"

#include <oneapi/tbb/global_control.h>

#include <cmath>
#include <memory>

#include "bench/bench_command.hpp"
#include "bench/methods.hpp"
#include "bench/timing.hpp"
#include "contours/vtk_contours.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/extract/extract_options.hpp"
#include "tensortopo/families/field_family.hpp"
#include "tensortopo/io/read_mesh.hpp"

namespace tensortopo {
namespace {

const double kResolution = Sampling().resolution;

/// One for each point, VTK's after ours if it takes part.
void add_times(const std::vector<Contender>& contenders, bool with_vtk,
               const ScalingCommand& command, std::vector<ScalingPoint>& points,
               const Progress& progress) {
  const auto series = time_in_turn(
      contenders, command.repeat,
      [&](std::size_t, double fraction) {
        if (progress) progress("timing", fraction);
      },
      command.longest);
  const std::size_t step = with_vtk ? 2 : 1, first = points.size() - series.size() / step;
  for (std::size_t i = 0; i < series.size(); i += step) {
    ScalingPoint& point = points[first + i / step];
    point.seconds = series[i].median();
    point.triangles = series[i].triangles;
    if (with_vtk) point.vtk_seconds = series[i + 1].median();
  }
}

std::vector<Contender> ours_and_vtk(const TetMesh& mesh, const std::vector<ModeValue>& modes,
                                    VtkContours& vtk) {
  return {
      {"extract", [&mesh, modes] { return triangles_of(our_surfaces(mesh, modes, kResolution)); }},
      {"vtk_contour", [&vtk, values = approximations(modes)] { return vtk.contour_grid(values); }}};
}

void over_sizes(const ScalingCommand& command, ScalingReport& report, const Progress& progress) {
  const auto modes = with_opposites(command.modes);
  report.field = "kelvin";
  for (std::size_t n = 10'000; n <= command.largest; n *= 10) {
    if (progress) progress("making " + std::to_string(n) + " tetrahedra", 0);
    const TetMesh mesh = family_member(FieldKind::kelvin, {1, 0, 1, n}).mesh;
    VtkContours vtk(mesh, static_cast<int>(report.threads));
    const auto tetrahedra = mesh.tets.size();
    report.points.push_back({static_cast<double>(tetrahedra), tetrahedra});
    add_times(ours_and_vtk(mesh, modes, vtk), true, command, report.points, progress);
  }
}

void over_mode(const TetMesh& mesh, const ScalingCommand& command, ScalingReport& report,
               const Progress& progress) {
  VtkContours vtk(mesh, static_cast<int>(report.threads));
  std::vector<Contender> contenders;
  for (const char* text : {"0", "0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7", "0.8", "0.9",
                           "0.95", "0.99", "0.999", "0.9999"}) {
    const std::vector<ModeValue> one{ModeValue::parse(text)};
    for (auto& contender : ours_and_vtk(mesh, with_opposites(one), vtk))
      contenders.push_back(std::move(contender));
    report.points.push_back({one.front().approx(), mesh.tets.size()});
  }
  add_times(contenders, true, command, report.points, progress);
}

void over_threads(const TetMesh& mesh, const ScalingCommand& command, ScalingReport& report,
                  const Progress& progress) {
  const auto modes = with_opposites(command.modes);
  std::vector<Contender> contenders;
  const auto add = [&](std::size_t threads) {
    contenders.push_back({std::to_string(threads), [&mesh, modes, threads] {
                            const oneapi::tbb::global_control limit(
                                oneapi::tbb::global_control::max_allowed_parallelism, threads);
                            return triangles_of(our_surfaces(mesh, modes, kResolution));
                          }});
    report.points.push_back({static_cast<double>(threads), mesh.tets.size()});
  };
  for (std::size_t threads = 1; threads < report.threads; threads *= 2) add(threads);
  add(report.threads);
  add_times(contenders, false, command, report.points, progress);
}

void over_modes(const TetMesh& mesh, const ScalingCommand& command, ScalingReport& report,
                const Progress& progress) {
  std::vector<Contender> contenders;
  for (const int count : {1, 2, 4, 8, 16}) {
    std::vector<ModeValue> modes;
    // Odd multiples of 19/20 over `count`, off 0.
    for (int k = 0; k < count; ++k)
      modes.push_back(ModeValue::parse(std::to_string(19 * (2 * k + 1) - 19 * count + 3) + "/" +
                                       std::to_string(20 * count + 4)));
    contenders.push_back({std::to_string(count), [&mesh, modes] {
                            return triangles_of(our_surfaces(mesh, modes, kResolution));
                          }});
    report.points.push_back({static_cast<double>(count), mesh.tets.size()});
  }
  add_times(contenders, false, command, report.points, progress);
}

}  // namespace

ScalingReport run_scaling(const ScalingCommand& command, const Progress& progress) {
  if (command.repeat < 5) throw UsageError("--repeat: must be at least 5");
  const bool over_size = command.over == ScalingOver::size;
  if (command.modes.empty() && (over_size || command.over == ScalingOver::threads))
    throw UsageError("no mode given (--mode)");
  if (over_size && command.largest < 10'000) throw UsageError("--largest: must be at least 10000");
  if (!over_size && command.input.empty()) throw UsageError("--input is required");
  ScalingReport report;
  report.over = command.over;
  report.threads = threads_in_use();
  if (over_size) {
    over_sizes(command, report, progress);
  } else {
    const ReadResult read = read_mesh(command.input, command.read);
    report.field = command.input.string();
    report.notes = read.report.all_notes();
    if (command.over == ScalingOver::mode) over_mode(read.mesh, command, report, progress);
    if (command.over == ScalingOver::threads) over_threads(read.mesh, command, report, progress);
    if (command.over == ScalingOver::modes) over_modes(read.mesh, command, report, progress);
  }
  std::vector<double> x, ours, vtk;
  for (const ScalingPoint& point : report.points) {
    x.push_back(point.x);
    ours.push_back(point.seconds);
    vtk.push_back(point.vtk_seconds);
  }
  const bool is_amount = command.over != ScalingOver::mode;
  report.exponent = is_amount ? power_law_exponent(x, ours) : std::nan("");
  report.vtk_exponent = over_size ? power_law_exponent(x, vtk) : std::nan("");
  report.serial_share = command.over == ScalingOver::threads ? serial_share(x, ours) : std::nan("");
  return report;
}

}  // namespace tensortopo
