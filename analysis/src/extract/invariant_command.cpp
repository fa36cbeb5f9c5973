// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/analysis/invariant_command.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <set>
#include <utility>

#include "check/checkable.hpp"
#include "extract/certificate.hpp"
#include "extract/overall_progress.hpp"
#include "extract/read_field.hpp"
#include "require_folder.hpp"
#include "short_text.hpp"
#include "tensortopo/analysis/extract_command.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/certify/residual_bound.hpp"
#include "tensortopo/io/file_group.hpp"
#include "tensortopo/io/write_surface.hpp"
#include "tensortopo/mesh/append_surface.hpp"

namespace tensortopo {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

InvariantSurfaceReport surface_report(const TetMesh& mesh, const InvariantLevel& level,
                                      const InvariantExtraction& extraction) {
  InvariantSurfaceReport report{level,
                                extraction.surface.points.size(),
                                extraction.surface.triangles.size(),
                                surface_invariants(extraction.surface),
                                0,
                                extraction.zero_tensor.size(),
                                extraction.statistics};
  report.topology.component.clear();
  report.max_abs_residual = residual_bound(mesh, level, extraction.surface);
  return report;
}

}  // namespace

InvariantReport run_invariant_extract(const InvariantCommand& command, const Progress& progress) {
  using Clock = std::chrono::steady_clock;
  if (command.levels.empty()) throw UsageError("--value: no value given");
  require_surface_extension(command.output, false);
  require_folder(command.output);
  const bool certifying = !command.certificate.empty();
  if (certifying) {
    require_certifiable(command.read, command.output, command.certificate);
    require_folder(command.certificate);
  }
  InvariantReport report;
  report.input = command.input;
  report.output = command.output;
  if (progress) progress("reading", 0);
  const ReadResult read = read_field(command, report);
  std::optional<CheckableInput> checkable;
  if (certifying) checkable.emplace(command.input, read);

  SurfaceMesh surface;
  std::set<std::int64_t> unresolved;
  std::vector<CertifiedLevel> certified;
  double seconds_certify = 0;
  std::vector<InvariantLevel> done;
  OverallProgress overall(progress, command.levels.size());
  for (const InvariantLevel& level : command.levels) {
    if (std::find(done.begin(), done.end(), level) != done.end()) continue;
    done.push_back(level);
    if (checkable) checkable->look();
    InvariantOptions options;
    options.pieces = command.pieces;
    overall.begin(std::string(name_of(level.invariant())) + ' ' + short_text(level) + ": ");
    if (overall) options.progress = std::ref(overall);
    auto start = Clock::now();
    InvariantExtraction extraction = extract_invariant_surface(read.mesh, level, options);
    report.seconds_extract += seconds_since(start);
    for (const auto t : extraction.zero_tensor)
      unresolved.insert(read.mesh.cell_ids[static_cast<std::size_t>(t)]);
    report.surfaces.push_back(surface_report(read.mesh, level, extraction));
    if (certifying) {
      overall("certificate", 0);
      start = Clock::now();
      certified.push_back(certify(read.mesh, level, extraction));
      seconds_certify += seconds_since(start);
    }
    append_surface(surface, std::move(extraction.surface));
  }
  report.unresolved.assign(unresolved.begin(), unresolved.end());
  if (command.strict && !report.unresolved.empty()) return report;
  if (checkable) checkable->require();
  overall.finish("writing");
  FileGroup files;
  std::string levels;
  for (const InvariantLevel& level : done)
    levels += (levels.empty() ? "" : " ") + short_text(level);
  auto start = Clock::now();
  report.bytes = write_surface(surface, CurveMesh{}, read.mesh, command.output,
                               {.invariant_surfaces = true}, file_notes(report, levels))
                     .bytes;
  report.written = true;
  report.seconds_write = seconds_since(start);
  if (certifying) {
    start = Clock::now();
    report.certificate = write_certificate(command.certificate, checkable->subject(), read, surface, {},
                                           certified);
    report.certificate->seconds = seconds_certify + seconds_since(start);
  }
  files.commit();
  return report;
}

}  // namespace tensortopo
