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

#include "check/checkable.hpp"
#include "extract/certificate.hpp"
#include "extract/component_filter.hpp"
#include "extract/extract_checks.hpp"
#include "extract/memory_plan.hpp"
#include "extract/other_method.hpp"
#include "extract/overall_progress.hpp"
#include "extract/read_field.hpp"
#include "extract/report/reports_of.hpp"
#include "extract/stability.hpp"
#include "extract/streamed_field.hpp"
#include "peak_memory.hpp"
#include "short_text.hpp"
#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/certify/extract_within.hpp"
#include "tensortopo/extract/embedded.hpp"
#include "tensortopo/extract/improve_triangles.hpp"
#include "tensortopo/io/file_group.hpp"
#include "tensortopo/io/surface_formats.hpp"
#include "tensortopo/io/write_surface.hpp"
#include "tensortopo/mesh/append_surface.hpp"
#include "tensortopo/mesh/as_size.hpp"
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

/// Keeps, of these tetrahedra, those that hold triangles.
void keep_crossed(const SurfaceMesh& surface, std::vector<TetMesh::Index>& tets) {
  std::vector<TetMesh::Index> crossed = surface.tet;
  std::sort(crossed.begin(), crossed.end());
  std::erase_if(tets, [&](TetMesh::Index t) {
    return !std::binary_search(crossed.begin(), crossed.end(), t);
  });
}

/// One run of the command, mode after mode.
class ExtractRun {
 public:
  ExtractRun(const ExtractCommand& command, std::vector<ModeValue> modes, const Progress& progress)
      : command_(command),
        modes_(std::move(modes)),
        progress_(progress),
        uncertainty_(requested_uncertainty(command.uncertainty)),
        filter_(command, modes_),
        overall_(progress, modes_.size()),
        other_(command) {
    report_.input = command.input;
    report_.output = command.output;
    options_.sampling = command.sampling;
    options_.meshing = command.meshing;
    options_.keep_samples = command.all_samples;
    options_.keep_topology = is_certifying();
    if (overall_) options_.progress = std::ref(overall_);
  }

  ExtractReport run() {
    const PredicateCounts before = predicate_counts();
    read();
    surfaces_left_ = std::count_if(modes_.begin(), modes_.end(),
                                   [](const auto& mode) { return !is_degenerate(mode); });
    for (const ModeValue& mode : modes_) {
      if (!streamed_) begin(mode);
      if (checkable_) checkable_->look();
      if (is_degenerate(mode))
        add_curves(mode);
      else
        add_surface(mode);
    }
    report_.predicates = predicate_counts() - before;
    for (auto& [key, which] : unresolved_)
      report_.unresolved.push_back({key.first, key.second, std::move(which)});
    if (!command_.strict || is_flawless(report_)) write();
    return std::move(report_);
  }

 private:
  void begin(const ModeValue& mode) { overall_.begin("mode " + short_text(mode) + ": "); }

  bool is_certifying() const { return !command_.certificate.empty(); }

  void read() {
    if (command_.stream) {
      const Clock clock;
      streamed_ = stream_field(
          command_, modes_, options_, [&](const ModeValue& mode) { begin(mode); }, report_);
      report_.seconds_extract += clock.seconds();
      read_ = std::move(streamed_->read);
    } else {
      tell(progress_, "reading", 0);
      read_ = read_field(command_, report_);
      if (is_certifying()) checkable_.emplace(command_.input, read_);
    }
    plan_pieces(command_, read_.mesh, modes_, report_);
    if (!uncertainty_) return;
    read_radii(command_.input, command_.read, read_, *uncertainty_);
    stability_.emplace(read_.mesh, *uncertainty_);
  }

  void leave_out(TetMesh::Index tet, std::string_view reason, const ModeValue& mode) {
    const std::int64_t id = read_.mesh.cell_ids[as_size(tet)];
    unresolved_[{id, std::string(reason)}].push_back(mode);
  }

  /// Of the mode that comes next, a surface or curves.
  template <class Level>
  Level streamed() {
    return std::get<Level>(std::move(streamed_->extractions[next_streamed_++]));
  }

  void add_curves(const ModeValue& mode) {
    const Clock clock;
    const Degeneracy kind = degeneracy_of(mode);
    CurveExtraction extraction =
        streamed_             ? streamed<CurveExtraction>()
        : report_.pieces > 1 ? extract_in_pieces(read_.mesh, kind, report_.pieces, options_)
                              : extract_degenerate_curves(read_.mesh, kind, options_);
    report_.seconds_extract += clock.seconds();
    for (const UnresolvedCurve& cell : extraction.unresolved)
      leave_out(cell.tet, name_of(cell.obstacle), mode);
    const auto filtered = filter_.apply(read_.mesh, mode, extraction.curves);
    CurveReport& known = report_.curves.emplace_back(curve_report(mode, extraction));
    known.filter = filtered;
    if (stability_)
      known.stability =
          report_stability(*stability_, command_.uncertainty, kind, options_, extraction);
    if (is_certifying()) {
      overall_("certificate", 0);
      const Clock certify_clock;
      auto& claims = certified_curves_.emplace_back(certify(read_.mesh, kind, extraction));
      if (streamed_) claims.vertex_ids = streamed_->vertex_ids;
      if (stability_) claims.stability = stability_->claim(known.stability->summary, extraction.curves, tets_of(claims.undecided));
      seconds_certify_ += certify_clock.seconds();
    }
    append_curves(curves_, std::move(extraction.curves));
  }

  /// The surface of a mode by the method asked for. With a bound on its distance also what is proved
  /// of it, and the tetrahedra that are farther.
  Extraction extract(const ModeValue& mode, std::optional<CertifiedLevel>& level,
                     std::vector<TetMesh::Index>& farther) {
    if (streamed_) return streamed<Extraction>();
    if (command_.other) return other_(read_.mesh, mode);
    if (command_.max_error > 0) {
      auto within = extract_within(read_.mesh, mode, command_.max_error, options_);
      level = std::move(within.level);
      farther = std::move(within.farther);
      return std::move(within.extraction);
    }
    if (report_.pieces > 1)
      return extract_in_pieces(read_.mesh, mode, report_.pieces, options_);
    using Use = PreparedField<double>::Use;
    if (!prepared_)
      prepared_.emplace(read_.mesh, surfaces_left_ > 1 ? Use::several_modes : Use::one_mode);
    return --surfaces_left_ > 0 || is_certifying()
               ? extract_mode_surface(*prepared_, mode, options_)
               : extract_mode_surface(std::move(*prepared_), mode, options_);
  }

  void add_surface(const ModeValue& mode) {
    const Clock clock;
    std::optional<CertifiedLevel> level;
    std::vector<TetMesh::Index> farther;
    Extraction extraction = extract(mode, level, farther);
    std::optional<ImprovementCounts> improvement;
    if (command_.improve) {
      improvement = improve_triangles(read_.mesh, mode, extraction.surface);
      extraction.not_embedded = tets_not_embedded(read_.mesh, extraction.surface);
    }
    report_.seconds_extract += clock.seconds();
    for (const UnresolvedCell& cell : extraction.unresolved)
      leave_out(cell.tet, name_of(cell.reason), mode);
    const auto filtered = filter_.apply(read_.mesh, mode, extraction.surface);
    if (filtered) keep_crossed(extraction.surface, extraction.not_embedded);
    const Clock invariants_clock;
    SurfaceReport& known =
        report_.surfaces.emplace_back(surface_report(read_.mesh, mode, extraction));
    known.filter = filtered;
    known.improvement = improvement;
    if (!command_.other) known.not_embedded = extraction.not_embedded.size();
    report_.seconds_invariants += invariants_clock.seconds();
    if (stability_)
      known.stability =
          report_stability(*stability_, command_.uncertainty, mode, options_, extraction);
    if (is_certifying() && !level) {
      overall_("certificate", 0);
      const Clock certify_clock;
      level = prepared_ ? certify(*prepared_, mode, extraction)
                        : certify(read_.mesh, mode, extraction);
      seconds_certify_ += certify_clock.seconds();
    }
    if (level || (command_.strict && !command_.other))
      known.embedded = level ? level->embedded : is_embedded(extraction.surface);
    if (level) tell_distance(known, level->distance, extraction.surface, farther);
    if (is_certifying()) {
      if (streamed_) level->vertex_ids = streamed_->vertex_ids;
      if (stability_)
        level->stability = stability_->claim(known.stability->summary, extraction.surface, tets_of(level->undecided));
      certified_.push_back(std::move(*level));
    }
    append_surface(surface_, std::move(extraction.surface));
    require_below_limit(command_, report_);
  }

  void tell_distance(SurfaceReport& known, const DistanceClaim& distance,
                     const SurfaceMesh& surface, const std::vector<TetMesh::Index>& farther) {
    known.distance_bound = distance.coarse.empty()
                               ? distance.bound
                               : std::max(distance.bound, distance.coarse_bound);
    known.tets_farther = farther.size();
    known.area_within = share_outside(surface, farther);
    if (!farther.empty()) known.first_farther = read_.mesh.cell_ids[as_size(farther.front())];
  }

  void write() {
    if (checkable_) checkable_->require();
    overall_.finish("writing");
    prepared_.reset();
    FileGroup files;
    const Clock clock;
    OutputKinds kinds;
    for (const ModeValue& mode : modes_)
      (is_degenerate(mode) ? kinds.degenerate_curves : kinds.mode_surfaces) = true;
    auto notes = file_notes(report_, texts_of(modes_));
    if (stability_) notes.push_back({"instability_names", stability_names()});
    const auto more = stability_ ? stability_->arrays() : std::vector<CellArray>{};
    report_.bytes =
        write_surface(surface_, curves_, read_.mesh, command_.output, kinds, notes, more).bytes;
    report_.written = true;
    report_.seconds_write = clock.seconds();
    if (is_certifying()) write_claims(more);
    require_below_limit(command_, report_);
    if (report_.memory) report_.memory->peak = peak_memory();
    files.commit();
  }

  void write_claims(const std::vector<CellArray>& more) {
    const Clock clock;
    const CertificateSubject& field = streamed_ ? streamed_->subject : checkable_->subject();
    report_.certificate =
        certified_curves_.empty()
            ? write_certificate(command_.certificate, field, read_, surface_, more, certified_)
            : write_certificate(command_.certificate, field, read_, curves_, more,
                                certified_curves_);
    report_.certificate->seconds = seconds_certify_ + clock.seconds();
    report_.certificate->counts_beyond_checker = report_.pieces == 1 && !streamed_;
    for (const SurfaceReport& s : report_.surfaces) {
      report_.certificate->tubes += s.statistics.sheets_tubes;
      report_.certificate->at_critical += s.statistics.tets_nearby;
    }
  }

  const ExtractCommand& command_;
  const std::vector<ModeValue> modes_;
  const Progress& progress_;
  std::optional<Uncertainty> uncertainty_;
  ComponentFilter filter_;
  OverallProgress overall_;
  OtherMethod other_;
  ExtractOptions options_;
  std::optional<StreamedField> streamed_;
  std::size_t next_streamed_ = 0;
  ReadResult read_;
  std::optional<CheckableInput> checkable_;  ///< if a certificate is asked for
  std::optional<StabilityRun> stability_;
  std::optional<PreparedField<double>> prepared_;  ///< what the modes have in common
  std::ptrdiff_t surfaces_left_ = 0;
  SurfaceMesh surface_;
  CurveMesh curves_;
  std::vector<CertifiedLevel> certified_;
  std::vector<CertifiedCurves> certified_curves_;
  double seconds_certify_ = 0;
  UnresolvedModes unresolved_;
  ExtractReport report_;
};

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

Degeneracy degeneracy_of(const ModeValue& mode) {
  return mode.sign() > 0 ? Degeneracy::linear : Degeneracy::planar;
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
  if (std::error_code error; std::filesystem::is_directory(output, error))
    throw IoError(IoError::Kind::unwritable, output, "is a folder");
  if (format == nullptr)
    throw UsageError(fmt::format("{}: the name must end in {} (no format for '{}')",
                                 output.string(), surface_extensions(),
                                 output.extension().string()));
  if (curves && !format->holds_curves)
    throw UsageError(fmt::format("{}: degenerate curves (--mode 1 or -1) need a name in {}",
                                 output.string(), surface_extensions(true)));
}

ExtractReport run_extract(const ExtractCommand& command, const Progress& progress) {
  std::vector<ModeValue> modes = modes_to_extract(command.modes, command.generalized);
  require_sense(command, modes);
  return ExtractRun(command, std::move(modes), progress).run();
}

}  // namespace tensortopo
