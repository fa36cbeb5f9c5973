// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/analysis/extract_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "certificate.hpp"
#include "component_filter.hpp"
#include "overall_progress.hpp"
#include "read_field.hpp"
#include "reports_of.hpp"
#include "require_folder.hpp"
#include "short_text.hpp"
#include "spare_memory.hpp"
#include "stability.hpp"
#include "streamed_field.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/certify/extract_within.hpp"
#include "tensortopo/extract/embedded.hpp"
#include "tensortopo/extract/improve_triangles.hpp"
#include "tensortopo/io/file_group.hpp"
#include "tensortopo/io/surface_formats.hpp"
#include "tensortopo/io/write_surface.hpp"
#include "tensortopo/mesh/append_surface.hpp"
#include "tensortopo/mesh/subdivide.hpp"
#include "tensortopo/partition/extract_in_pieces.hpp"

namespace tensortopo {
namespace {

class Clock {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::string texts_of(const std::vector<ModeValue>& modes) {
  std::string text;
  for (const ModeValue& mode : modes) text += (text.empty() ? "" : " ") + mode.text();
  return text;
}

void tell(const Progress& progress, std::string_view stage, double fraction) {
  if (progress) progress(stage, fraction);
}

using UnresolvedModes = std::map<std::pair<std::int64_t, std::string>, std::vector<ModeValue>>;

/// Throws UsageError for surfaces that no proof is about, and for surfaces and curves in one file.
void require_proofs(const ExtractCommand& command, const std::vector<ModeValue>& modes) {
  if (command.other)
    throw UsageError(
        "--certify: only surfaces of the methods `manifold` and `graph` come with proofs");
  if (std::any_of(modes.begin(), modes.end(), is_degenerate) &&
      !std::all_of(modes.begin(), modes.end(), is_degenerate))
    throw UsageError(
        "--certify: a certificate is of surfaces or of degenerate curves (--mode 1 or "
        "-1); extract them to files of their own");
}

/// Throws UsageError for options that do nothing for degenerate curves.
void require_no_surface_options(const ExtractCommand& command) {
  const char* const option = command.improve                           ? "--improve"
                             : command.all_samples                     ? "--all-samples"
                             : command.max_error > 0                   ? "--max-error"
                             : command.drawing == MeshingMethod::graph ? "--method graph"
                             : command.pieces > 1                      ? "--pieces"
                                                                       : nullptr;
  if (option != nullptr)
    throw UsageError(std::string(option) + ": has no effect on degenerate curves (--mode 1 or -1)");
}

constexpr std::size_t kMostTetrahedra = 100'000'000;

/// Another method's surface as if extracted: it leaves nothing out, and counts nothing.
class OtherMethod {
 public:
  explicit OtherMethod(const ExtractCommand& command) : command_(command) {}

  Extraction operator()(const TetMesh& mesh, const ModeValue& mode) {
    if (!fine_ && command_.subdivisions > 0) {
      if (mesh.tets.size() > kMostTetrahedra >> (3 * command_.subdivisions))
        throw UsageError(fmt::format("--subdivide: more than {} tetrahedra", kMostTetrahedra));
      fine_ = subdivide(mesh);
      for (int i = 1; i < command_.subdivisions; ++i) fine_ = subdivide(*fine_);
    }
    Extraction extraction;
    extraction.surface = command_.other(fine_ ? *fine_ : mesh, mode);
    // The parts of a tetrahedron follow each other.
    auto& tets = extraction.surface.tet;
    for (auto& t : tets) t >>= 3 * command_.subdivisions;
    auto crossed = tets;
    std::sort(crossed.begin(), crossed.end());
    const auto end = std::unique(crossed.begin(), crossed.end());
    extraction.statistics.tets_crossed = static_cast<std::size_t>(end - crossed.begin());
    return extraction;
  }

 private:
  const ExtractCommand& command_;
  std::optional<TetMesh> fine_;
};

/// Keeps, of these tetrahedra, those that hold triangles.
void keep_crossed(const SurfaceMesh& surface, std::vector<TetMesh::Index>& tets) {
  std::vector<TetMesh::Index> crossed = surface.tet;
  std::sort(crossed.begin(), crossed.end());
  std::erase_if(tets, [&](TetMesh::Index t) {
    return !std::binary_search(crossed.begin(), crossed.end(), t);
  });
}

}  // namespace

ModeValue parse_mode(std::string_view text) {
  const ModeValue mode = ModeValue::parse(text);
  if (std::abs(mode.approx()) == 1 && !is_degenerate(mode))
    throw std::invalid_argument("mode value \"" + std::string(text) +
                                "\": no double tells it from 1 or -1");
  return mode;
}

bool is_degenerate(const ModeValue& mode) {
  const std::string text = mode.text();
  return text == "1" || text == "-1";
}

std::vector<ModeValue> modes_to_extract(std::span<const ModeValue> modes, bool generalized) {
  std::vector<ModeValue> result;
  const auto add = [&](const ModeValue& mode) {
    if (std::find(result.begin(), result.end(), mode) == result.end()) result.push_back(mode);
  };
  for (const ModeValue& mode : modes) {
    add(mode);
    if (generalized) add(mode.opposite());
  }
  if (result.empty()) throw UsageError("no mode given (--mode)");
  return result;
}

void require_surface_extension(const std::filesystem::path& output, bool curves) {
  const SurfaceFormat* const format = surface_format_of(output);
  if (format == nullptr)
    throw UsageError(fmt::format("{}: the name must end in {} (no format for '{}')",
                                 output.string(), surface_extensions(),
                                 output.extension().string()));
  if (curves && !format->holds_curves)
    throw UsageError(fmt::format("{}: degenerate curves (--mode 1 or -1) need a name in {}",
                                 output.string(), surface_extensions(true)));
}

ExtractReport run_extract(const ExtractCommand& command, const Progress& progress) {
  const std::vector<ModeValue> modes = modes_to_extract(command.modes, command.generalized);
  require_surface_extension(command.output, std::any_of(modes.begin(), modes.end(), is_degenerate));
  if (!(command.sampling.resolution > 0) || command.sampling.resolution > kLargestResolution) {
    throw UsageError(
        fmt::format("--resolution: must be a positive number, at most {}", kLargestResolution));
  }
  if (std::all_of(modes.begin(), modes.end(), is_degenerate)) require_no_surface_options(command);
  if (command.other && std::any_of(modes.begin(), modes.end(), is_degenerate)) {
    throw UsageError("--method: degenerate curves (--mode 1 or -1) have no other method");
  }
  if (command.only_neutral &&
      std::any_of(modes.begin(), modes.end(), [](const auto& mode) { return mode.sign() != 0; })) {
    throw UsageError("--method hybrid: extracts neutral surfaces (--mode 0) only");
  }
  if (command.other && command.max_error > 0) {
    throw UsageError("--max-error: only surfaces of the method `manifold` come with proofs");
  }
  if (command.improve && (command.other || command.max_error > 0)) {
    throw UsageError("--improve: only for surfaces of the method `manifold`, without --max-error");
  }
  auto uncertainty = requested_uncertainty(command);
  ComponentFilter filter(command, modes);
  require_folder(command.output);
  const bool certifying = !command.certificate.empty();
  if (certifying) {
    require_certifiable(command.read, command.output, command.certificate);
    require_proofs(command, modes);
    require_folder(command.certificate);
  }

  ExtractReport report;
  report.input = command.input;
  report.output = command.output;

  const PredicateCounts before = predicate_counts();
  OverallProgress overall(progress, modes.size());
  ExtractOptions options;
  options.sampling = command.sampling;
  options.meshing = command.drawing;
  options.keep_samples = command.all_samples;
  options.keep_topology = certifying;
  if (overall) options.progress = std::ref(overall);
  std::optional<StreamedField> streamed;
  if (command.stream) {
    const Clock stream_clock;
    overall.begin("mode " + short_text(modes[0]) + ": ");
    streamed = stream_field(command, modes, options, report);
    report.seconds_extract += stream_clock.seconds();
  } else {
    tell(progress, "reading", 0);
  }
  const ReadResult read = streamed ? std::move(streamed->read) : read_field(command, report);

  SurfaceMesh surface;
  CurveMesh curves;
  UnresolvedModes unresolved;
  std::vector<CertifiedLevel> certified;
  std::vector<CertifiedCurves> certified_curves;
  double seconds_certify = 0;
  OtherMethod other(command);
  std::optional<StabilityRun> stability;
  if (uncertainty) read_radii(command, read, *uncertainty);
  if (uncertainty) stability.emplace(read.mesh, *uncertainty);
  const auto more = [&] { return stability ? stability->arrays() : std::vector<CellArray>{}; };
  // What the modes have in common.
  std::optional<PreparedField<double>> prepared;
  auto surfaces_left = std::count_if(modes.begin(), modes.end(),
                                     [](const auto& mode) { return !is_degenerate(mode); });
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (!streamed) overall.begin("mode " + short_text(modes[i]) + ": ");
    const Clock extract_clock;
    if (is_degenerate(modes[i])) {
      const auto kind = modes[i].approx() > 0 ? Degeneracy::linear : Degeneracy::planar;
      CurveExtraction extraction = extract_degenerate_curves(read.mesh, kind, options);
      report.seconds_extract += extract_clock.seconds();
      for (const UnresolvedCurve& cell : extraction.unresolved) {
        const std::int64_t id = read.mesh.cell_ids[static_cast<std::size_t>(cell.tet)];
        unresolved[{id, std::string(name_of(cell.obstacle))}].push_back(modes[i]);
      }
      const auto filtered = filter.apply(read.mesh, modes[i], extraction.curves);
      CurveReport& known = report.curves.emplace_back(curve_report(modes[i], extraction));
      known.filter = filtered;
      if (stability)
        known.stability =
            report_stability(*stability, command.uncertainty, kind, options, extraction);
      if (certifying) {
        overall("certificate", 0);
        const Clock certify_clock;
        auto& claims = certified_curves.emplace_back(certify(read.mesh, kind, extraction));
        if (stability) claims.stability = stability->claim(known.stability->summary);
        seconds_certify += certify_clock.seconds();
      }
      append_curves(curves, std::move(extraction.curves));
      continue;
    }
    Extraction extraction;
    std::optional<CertifiedLevel> level;
    std::vector<TetMesh::Index> farther;
    if (streamed) {
      extraction = std::move(streamed->extraction);
    } else if (command.other) {
      extraction = other(read.mesh, modes[i]);
    } else if (command.max_error > 0) {
      auto within = extract_within(read.mesh, modes[i], command.max_error, options);
      extraction = std::move(within.extraction);
      level = std::move(within.level);
      farther = std::move(within.farther);
    } else if (command.pieces > 1) {
      extraction = extract_in_pieces(read.mesh, modes[i], command.pieces, options);
    } else {
      using Use = PreparedField<double>::Use;
      if (!prepared)
        prepared.emplace(read.mesh, surfaces_left > 1 ? Use::several_modes : Use::one_mode);
      extraction = --surfaces_left > 0 || certifying
                       ? extract_mode_surface(*prepared, modes[i], options)
                       : extract_mode_surface(std::move(*prepared), modes[i], options);
    }
    if (command.improve) {
      improve_triangles(read.mesh, modes[i], extraction.surface);
      extraction.not_embedded = tets_not_embedded(read.mesh, extraction.surface);
    }
    report.seconds_extract += extract_clock.seconds();
    for (const UnresolvedCell& cell : extraction.unresolved) {
      const std::int64_t id = read.mesh.cell_ids[static_cast<std::size_t>(cell.tet)];
      unresolved[{id, std::string(name_of(cell.reason))}].push_back(modes[i]);
    }
    const auto filtered = filter.apply(read.mesh, modes[i], extraction.surface);
    if (filtered) keep_crossed(extraction.surface, extraction.not_embedded);
    const Clock invariants_clock;
    report.surfaces.push_back(surface_report(read.mesh, modes[i], extraction));
    report.surfaces.back().filter = filtered;
    if (!command.other) report.surfaces.back().not_embedded = extraction.not_embedded.size();
    report.seconds_invariants += invariants_clock.seconds();
    if (stability)
      report.surfaces.back().stability =
          report_stability(*stability, command.uncertainty, modes[i], options, extraction);
    if (certifying) {
      overall("certificate", 0);
      const Clock certify_clock;
      if (!level)
        level = prepared ? certify(*prepared, modes[i], extraction)
                         : certify(read.mesh, modes[i], extraction);
      seconds_certify += certify_clock.seconds();
    }
    if (level) {
      const DistanceClaim& distance = level->distance;
      report.surfaces.back().distance_bound = distance.coarse.empty()
                                                  ? distance.bound
                                                  : std::max(distance.bound, distance.coarse_bound);
      report.surfaces.back().tets_farther = farther.size();
      report.surfaces.back().area_within = share_outside(extraction.surface, farther);
      if (!farther.empty())
        report.surfaces.back().first_farther =
            read.mesh.cell_ids[static_cast<std::size_t>(farther.front())];
    }
    if (certifying) {
      if (streamed) level->vertex_ids = streamed->vertex_ids;
      if (stability) level->stability = stability->claim(report.surfaces.back().stability->summary);
      certified.push_back(std::move(*level));
    }
    append_surface(surface, std::move(extraction.surface));
  }
  report.predicates = predicate_counts() - before;
  for (auto& [key, which] : unresolved) {
    report.unresolved.push_back({key.first, key.second, std::move(which)});
  }

  if (command.strict && !report.unresolved.empty()) return report;
  overall.finish("writing");
  // The writer needs half as much again, in large arrays that do not fit between what is left.
  prepared.reset();
  give_back_memory();
  FileGroup files;
  const Clock write_clock;
  OutputKinds kinds;
  for (const ModeValue& mode : modes)
    (is_degenerate(mode) ? kinds.degenerate_curves : kinds.mode_surfaces) = true;
  auto notes = file_notes(report, texts_of(modes));
  if (stability) notes.push_back({"instability_names", stability_names()});
  report.bytes =
      write_surface(surface, curves, read.mesh, command.output, kinds, notes, more()).bytes;
  report.written = true;
  report.seconds_write = write_clock.seconds();
  if (certifying) {
    const Clock certify_clock;
    report.certificate =
        certified_curves.empty()
            ? write_certificate(command.certificate, read, surface, more(), certified,
                                streamed ? &streamed->subject : nullptr)
            : write_certificate(command.certificate, read, curves, more(), certified_curves);
    report.certificate->seconds = seconds_certify + certify_clock.seconds();
    report.certificate->counts_beyond_checker = command.pieces == 1 && !streamed;
    for (const SurfaceReport& s : report.surfaces) {
      report.certificate->tubes += s.statistics.sheets_tubes;
      report.certificate->at_critical += s.statistics.tets_nearby;
    }
  }
  files.commit();
  return report;
}

}  // namespace tensortopo
