// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "persistence_filter.hpp"

#include <algorithm>
#include <cmath>

#include "tensortopo/analysis/usage_error.hpp"

namespace tensortopo {
namespace {

template <class Mesh>
FilterReport keep_persistent(Mesh& mesh, const std::vector<std::optional<double>>& persistence,
                             double least) {
  FilterReport report;
  report.least = least;
  std::vector<char> keep;
  for (const auto& value : persistence) {
    keep.push_back(!value || *value >= least);
    report.not_known += !value;
    report.left_out += keep.back() == 0;
    if (keep.back() == 0) report.largest_left_out = std::max(report.largest_left_out, *value);
  }
  if (report.left_out > 0) mesh = kept_components(mesh, keep);
  return report;
}

std::size_t components_of(const std::vector<std::int32_t>& component) {
  return component.empty() ? 0 : as_size(*std::max_element(component.begin(), component.end())) + 1;
}

}  // namespace

PersistenceFilter::PersistenceFilter(const ExtractCommand& command)
    : least_(command.min_persistence) {
  if (least_ == 0) return;
  if (!(least_ > 0) || !std::isfinite(least_))
    throw UsageError("--min-persistence: must be a positive angle in radians");
  if (command.other)
    throw UsageError(
        "--min-persistence: only for surfaces of the methods `manifold` and `graph`, and curves");
  if (!command.certificate.empty())
    throw UsageError(
        "--min-persistence: a certificate is of all components; extract them without --certify");
  if (!command.uncertainty.empty())
    throw UsageError("--min-persistence and --uncertainty exclude each other");
}

void PersistenceFilter::prepare(const TetMesh& mesh) {
  if (input_) return;
  input_ = persistence_input(mesh);
  persistence_ = mode_persistence(mesh, *input_);
}

std::optional<FilterReport> PersistenceFilter::apply(const TetMesh& mesh, const ModeValue& mode,
                                                     SurfaceMesh& surface) {
  if (is_off()) return std::nullopt;
  prepare(mesh);
  return keep_persistent(surface, component_persistence(mesh, *input_, surface, mode.approx()),
                         least_);
}

std::optional<FilterReport> PersistenceFilter::apply(const TetMesh& mesh, const ModeValue& mode,
                                                     CurveMesh& curves) {
  if (is_off()) return std::nullopt;
  prepare(mesh);
  return keep_persistent(
      curves, curve_persistence(persistence_, mode.sign(), components_of(curves.component)),
      least_);
}

}  // namespace tensortopo
