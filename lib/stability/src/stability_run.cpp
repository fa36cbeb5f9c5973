// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/stability/stability_run.hpp"

#include <algorithm>
#include <limits>

namespace tensortopo {

namespace {

/// Of the components that are marked, ascending.
std::vector<SurfaceMesh::Index> smallest_vertices(const SurfaceMesh& surface,
                                                  const std::vector<char>& marked) {
  std::vector<SurfaceMesh::Index> smallest(marked.size(),
                                           std::numeric_limits<SurfaceMesh::Index>::max());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    for (const auto v : surface.triangles[i]) {
      auto& least = smallest[as_size(surface.component[i])];
      least = std::min(least, v);
    }
  std::vector<SurfaceMesh::Index> result;
  for (std::size_t c = 0; c < marked.size(); ++c)
    if (marked[c]) result.push_back(smallest[c]);
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace

StabilityRun::StabilityRun(const TetMesh& mesh, const Uncertainty& uncertainty)
    : kind_(uncertainty.kind),
      value_(uncertainty.value),
      array_(uncertainty.array),
      radii_sha256_(uncertainty.radii_sha256),
      field_(mesh, vertex_radii(mesh, uncertainty)),
      arrays_{{"instability", {}}, {"stable", {}}} {}

StabilitySummary StabilityRun::add(const ModeValue& mode, const ExtractOptions& options,
                                   const Extraction& extraction) {
  LevelStability level = level_stability(field_, mode, options);
  mark_unresolved(extraction.unresolved, level);
  const SurfaceMesh& surface = extraction.surface;
  for (const auto t : surface.tet) {
    const Stability stability = level.tets[as_size(t)];
    arrays_[0].values.push_back(static_cast<std::int32_t>(stability));
    arrays_[1].values.push_back(stability == Stability::stable);
  }

  StabilitySummary summary;
  for (const Stability s : level.tets) {
    ++(s == Stability::stable ? summary.stable_tets : summary.unstable_tets);
    if (s != Stability::stable) ++summary.reasons[std::string(name_of(s))];
  }
  auto crossed = surface.tet;
  std::sort(crossed.begin(), crossed.end());
  crossed.erase(std::unique(crossed.begin(), crossed.end()), crossed.end());
  for (const auto t : crossed)
    summary.crossed_stable_tets += level.tets[as_size(t)] == Stability::stable;
  summary.components =
      smallest_vertices(surface, surface_stability(*field_.mesh, surface, level).components);
  return summary;
}

std::optional<StabilityClaim> StabilityRun::claim(const StabilitySummary& summary) const {
  if (kind_ == Uncertainty::Kind::per_vertex && array_.empty()) return std::nullopt;
  return StabilityClaim{kind_ == Uncertainty::Kind::relative, value_, summary.components, array_,
                        radii_sha256_};
}

}  // namespace tensortopo
