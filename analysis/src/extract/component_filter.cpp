// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/component_filter.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "tensortopo/analysis/usage_error.hpp"
#include "tensortopo/mesh/canonical_mesh.hpp"
#include "tensortopo/mesh/surface_invariants.hpp"

namespace tensortopo {
namespace {

/// A number for each component that it must reach.
using Measures = std::vector<std::optional<double>>;

/// Leaves out the components below `least`.
template <class Mesh>
FilterReport::Limit keep_at_least(Mesh& mesh, const Measures& measures, double least) {
  FilterReport::Limit limit;
  limit.least = least;
  std::vector<char> keep;
  for (const auto& value : measures) {
    keep.push_back(!value || *value >= least);
    limit.not_known += !value;
    limit.left_out += keep.back() == 0;
    if (keep.back() == 0) limit.largest_left_out = std::max(limit.largest_left_out, *value);
  }
  if (limit.left_out > 0) mesh = kept_components(mesh, keep);
  return limit;
}

std::size_t components_of(const std::vector<std::int32_t>& component) {
  return component.empty() ? 0 : as_size(*std::max_element(component.begin(), component.end())) + 1;
}

Measures areas(const SurfaceMesh& surface) {
  Measures areas;
  for (const auto& part : surface_invariants(surface).parts) areas.push_back(part.area);
  return areas;
}

Measures lengths(const CurveMesh& curves) {
  std::vector<double> lengths(components_of(curves.component), 0.0);
  for (std::size_t l = 0; l < curves.lines.size(); ++l) {
    const auto& line = curves.lines[l];
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const auto step = curves.points[as_size(line[i + 1])] - curves.points[as_size(line[i])];
      lengths[as_size(curves.component[l])] += std::hypot(step.x, step.y, step.z);
    }
  }
  return Measures(lengths.begin(), lengths.end());
}

void require_positive(double value, const std::string& option) {
  if (value != 0 && (!(value > 0) || !std::isfinite(value)))
    throw UsageError(option + ": must be a positive number");
}

}  // namespace

ComponentFilter::ComponentFilter(const ExtractCommand& command, std::span<const ModeValue> modes)
    : persistence_(command.min_persistence), area_(command.min_area), length_(command.min_length) {
  require_positive(persistence_, "--min-persistence");
  require_positive(area_, "--min-area");
  require_positive(length_, "--min-length");
  const std::string option = persistence_ != 0 ? "--min-persistence"
                             : area_ != 0      ? "--min-area"
                             : length_ != 0    ? "--min-length"
                                               : "";
  if (option.empty()) return;
  if (area_ != 0 && std::all_of(modes.begin(), modes.end(), is_degenerate))
    throw UsageError("--min-area: degenerate curves (--mode 1 or -1) have none; --min-length");
  if (length_ != 0 && std::none_of(modes.begin(), modes.end(), is_degenerate))
    throw UsageError(
        "--min-length: is of degenerate curves (--mode 1 or -1); for surfaces there is --min-area");
  if (command.other)
    throw UsageError(option +
                     ": only for surfaces of the methods `bisection` and `manifold`, and curves");
  if (!command.certificate.empty())
    throw UsageError(option +
                     ": a certificate is of all components; extract them without --certify");
  if (!command.uncertainty.empty())
    throw UsageError(option + " and --uncertainty exclude each other");
}

void ComponentFilter::prepare(const TetMesh& mesh) {
  if (input_) return;
  CanonicalMesh canonical = canonical_mesh(mesh);
  numbers_ = inverse_permutation(canonical.vertices);
  mesh_ = std::move(canonical.mesh);
  input_ = persistence_input(mesh_);
  mode_persistence_ = mode_persistence(mesh_, *input_);
}

std::optional<FilterReport> ComponentFilter::apply(const TetMesh& mesh, const ModeValue& mode,
                                                   SurfaceMesh& surface) {
  FilterReport report;
  if (area_ > 0) report.size = keep_at_least(surface, areas(surface), area_);
  if (persistence_ > 0) {
    prepare(mesh);
    report.persistence = keep_at_least(
        surface, component_persistence(mesh_, *input_, surface, mode.approx(), numbers_),
        persistence_);
  }
  return report.of_filters();
}

std::optional<FilterReport> ComponentFilter::apply(const TetMesh& mesh, const ModeValue& mode,
                                                   CurveMesh& curves) {
  FilterReport report;
  // The persistence is known by the number of the component: it comes first.
  if (persistence_ > 0) {
    prepare(mesh);
    report.persistence = keep_at_least(
        curves, curve_persistence(mode_persistence_, mode.sign(), components_of(curves.component)),
        persistence_);
  }
  if (length_ > 0) report.size = keep_at_least(curves, lengths(curves), length_);
  return report.of_filters();
}

}  // namespace tensortopo
