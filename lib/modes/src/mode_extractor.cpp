// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/modes/mode_extractor.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <stdexcept>

#include "extraction.hpp"
#include "tensortopo/extract/embedded.hpp"
#include "tensortopo/hash/number_hash.hpp"
#include "tensortopo/mesh/append_surface.hpp"

namespace tensortopo {
namespace {

using Prepared = PreparedField<double>;

void require_resolution(double resolution) {
  constexpr double largest = 1000;
  if (!(resolution > 0) || resolution > largest)
    throw std::invalid_argument("resolution: must be a positive number, at most 1000");
}

std::vector<ModeValue> modes_of(const SurfaceRequest& request) {
  std::vector<ModeValue> modes;
  const auto add = [&](const ModeValue& mode) {
    if (std::find(modes.begin(), modes.end(), mode) == modes.end()) modes.push_back(mode);
  };
  for (const ModeValue& mode : request.modes) {
    if (std::abs(mode.approx()) == 1)
      throw std::invalid_argument(
          "mode " + mode.text() +
          ": where the mode is 1 or -1 there are degenerate curves, which are asked for apart");
    add(mode);
    if (request.generalized) add(mode.opposite());
  }
  if (modes.empty()) throw std::invalid_argument("no mode given");
  return modes;
}

void require_sense(const SurfaceRequest& request) {
  require_resolution(request.resolution);
  if (!(request.max_error >= 0) || std::isinf(request.max_error))
    throw std::invalid_argument("max_error: must be a finite number, at least 0");
  if (request.improve && request.max_error > 0)
    throw std::invalid_argument("improve: does not go with max_error");
}

ModeProgress labelled(const ModeProgress& progress, const ModeValue& mode) {
  if (!progress) return {};
  return
      [&progress, label = "mode " + mode.text() + ": "](std::string_view stage, double fraction) {
        progress(label + std::string(stage), fraction);
      };
}

CertificateSubject subject_of(const TetMesh& mesh, const CertificateNames& names) {
  CertificateSubject subject;
  subject.tensor = names.tensor;
  subject.components = names.components;
  subject.points = mesh.points.size();
  subject.tetrahedra = mesh.tets.size();
  subject.field_sha256 = field_sha256(mesh);
  return subject;
}

template <class Output, class Claims>
std::string certificate_of(const TetMesh& mesh, const CertificateNames& names,
                           CertificateSubject subject, const Output& output,
                           const std::vector<ArrayHash>& arrays,
                           const std::vector<Claims>& claims) {
  subject.vertices = output.points.size();
  for (const ArrayHash& array : arrays)
    subject.arrays.push_back({array.of, array.name, array.components, array.sha256});
  const auto encoding = names.cbor ? CertificateEncoding::cbor : CertificateEncoding::json;
  return certificate_bytes(subject, claims, mesh, encoding);
}

void tell(const ModeProgress& progress, std::string_view stage) {
  if (progress) progress(stage, 0);
}

}  // namespace

struct ModeExtractor::Shared {
  const TetMesh& mesh;
  std::mutex mutex;
  bool is_used = false;
  std::shared_ptr<const Prepared> prepared;

  /// What modes have in common. A single mode asked for first is quicker without most of it.
  std::shared_ptr<const Prepared> prepare(std::size_t modes) {
    const std::lock_guard lock(mutex);
    if (prepared) return prepared;
    if (!std::exchange(is_used, true) && modes == 1)
      return std::make_shared<const Prepared>(mesh, Prepared::Use::one_mode);
    return prepared = std::make_shared<const Prepared>(mesh, Prepared::Use::several_modes);
  }
};

ModeExtractor::ModeExtractor(const TetMesh& mesh) : shared_(new Shared{mesh, {}, false, {}}) {}
ModeExtractor::~ModeExtractor() = default;

ModeSurfaces ModeExtractor::surfaces(const SurfaceRequest& request) const {
  require_sense(request);
  const std::vector<ModeValue> modes = modes_of(request);
  const TetMesh& mesh = shared_->mesh;
  ModeSurfaces result;
  std::vector<CertifiedLevel> certified;
  std::optional<StabilityRun> stability;
  if (request.uncertainty) stability.emplace(mesh, *request.uncertainty);
  for (const ModeValue& mode : modes) {
    const ModeProgress progress = labelled(request.progress, mode);
    ExtractOptions options;
    options.sampling.resolution = request.resolution;
    options.meshing = request.meshing;
    options.keep_samples = request.all_samples;
    options.keep_topology = request.certify || request.show;
    options.progress = progress;
    std::shared_ptr<const Prepared> field;
    Extraction extraction;
    std::optional<CertifiedLevel> level;
    ModePart part;
    part.mode = mode;
    if (request.max_error > 0) {
      auto within = extract_within(mesh, mode, request.max_error, options);
      extraction = std::move(within.extraction);
      level = std::move(within.level);
      part.tets_farther = within.farther.size();
    } else {
      field = shared_->prepare(modes.size());
      extraction = extract_mode_surface(*field, mode, options);
      if (request.improve) {
        improve_triangles(mesh, mode, extraction.surface);
        extraction.not_embedded = tets_not_embedded(mesh, extraction.surface);
      }
    }
    if (request.show) request.show(mode, extraction);
    part.not_embedded = std::move(extraction.not_embedded);
    part.vertices = extraction.surface.points.size();
    part.cells = extraction.surface.triangles.size();
    part.invariants = surface_invariants(extraction.surface);
    part.invariants.component.clear();
    part.statistics = counted(extraction.statistics);
    for (const UnresolvedCell& cell : extraction.unresolved)
      result.unresolved.push_back({cell.tet, std::string(name_of(cell.reason)), mode});
    if (stability) part.stability = stability->add(mode, options, extraction);
    if (request.certify && !level) {
      tell(progress, "certificate");
      level = certify(*field, mode, extraction);
    }
    if (level) {
      if (stability)
        level->stability =
            stability->claim(*part.stability, extraction.surface, tets_of(level->undecided));
      const DistanceClaim& distance = level->distance;
      part.distance_bound = distance.coarse.empty()
                                ? distance.bound
                                : std::max(distance.bound, distance.coarse_bound);
      result.claims += level->claims();
      if (request.certify) result.undecided += level->undecided.size();
      if (request.certify) certified.push_back(std::move(*level));
    }
    result.parts.push_back(std::move(part));
    append_surface(result.surface, std::move(extraction.surface));
  }
  if (stability) result.more = stability->arrays();
  if (request.certify) {
    tell(request.progress, "certificate");
    CertificateSubject subject = subject_of(mesh, request.names);
    subject.cells = result.surface.triangles.size();
    subject.output_sha256 = surface_sha256(result.surface, mesh);
    result.certificate = certificate_of(mesh, request.names, std::move(subject), result.surface,
                                        array_hashes(result.surface, result.more), certified);
  } else {
    result.claims = 0;
  }
  return result;
}

DegenerateCurves ModeExtractor::curves(const CurveRequest& request) const {
  require_resolution(request.resolution);
  if (!request.linear && !request.planar) throw std::invalid_argument("no kind of curves given");
  const TetMesh& mesh = shared_->mesh;
  DegenerateCurves result;
  std::vector<CertifiedCurves> certified;
  std::optional<StabilityRun> stability;
  if (request.uncertainty) stability.emplace(mesh, *request.uncertainty);
  for (const Degeneracy kind : {Degeneracy::linear, Degeneracy::planar}) {
    if (!(kind == Degeneracy::linear ? request.linear : request.planar)) continue;
    const ModeValue mode = ModeValue::parse(kind == Degeneracy::linear ? "1" : "-1");
    const ModeProgress progress = labelled(request.progress, mode);
    ExtractOptions options;
    options.sampling.resolution = request.resolution;
    options.progress = progress;
    KeyedCurves made = extract_keyed_curves(mesh, kind, options);
    if (request.show) request.show(mode, made);
    auto& [extraction, keys] = made;
    ModePart part;
    part.mode = mode;
    part.vertices = extraction.curves.points.size();
    part.cells = extraction.curves.lines.size();
    part.curve_invariants = curve_invariants(extraction.curves);
    part.statistics = counted(extraction.statistics);
    for (const UnresolvedCurve& cell : extraction.unresolved)
      result.unresolved.push_back({cell.tet, std::string(name_of(cell.obstacle)), mode});
    if (stability) part.stability = stability->add(kind, options, extraction);
    if (request.certify) {
      tell(progress, "certificate");
      auto& claims = certified.emplace_back(certify(mesh, kind, extraction));
      if (stability)
        claims.stability =
            stability->claim(*part.stability, extraction.curves, tets_of(claims.undecided));
      result.claims += claims.claims();
      result.undecided += claims.undecided.size();
    }
    result.parts.push_back(std::move(part));
    result.keys.push_back(std::move(keys));
    append_curves(result.curves, std::move(extraction.curves));
  }
  if (stability) result.more = stability->arrays();
  if (request.certify) {
    CertificateSubject subject = subject_of(mesh, request.names);
    subject.cells = result.curves.lines.size();
    subject.output_sha256 = curves_sha256(result.curves, mesh);
    result.certificate = certificate_of(mesh, request.names, std::move(subject), result.curves,
                                        array_hashes(result.curves, result.more), certified);
  }
  return result;
}

ModeValue parse_surface_mode(std::string_view text) {
  const ModeValue mode = ModeValue::parse(text);
  if (std::abs(mode.approx()) == 1 && mode.text() != "1" && mode.text() != "-1")
    throw std::invalid_argument("mode value \"" + std::string(text) +
                                "\": no double tells it from 1 or -1");
  return mode;
}

}  // namespace tensortopo
