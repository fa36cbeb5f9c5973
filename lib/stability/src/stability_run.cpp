// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/stability/stability_run.hpp"

#include <algorithm>
#include <iterator>
#include <limits>

namespace tensortopo {

namespace {

/// Of the components that are marked, ascending.
/// @param cells  triangles or lines, each of one of the `components`
template <class Cells>
std::vector<SurfaceMesh::Index> smallest_vertices(const Cells& cells,
                                                  const std::vector<SurfaceMesh::Index>& components,
                                                  const std::vector<char>& marked) {
  std::vector<SurfaceMesh::Index> smallest(marked.size(),
                                           std::numeric_limits<SurfaceMesh::Index>::max());
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (const auto v : cells[i]) {
      auto& least = smallest[as_size(components[i])];
      least = std::min(least, v);
    }
  std::vector<SurfaceMesh::Index> result;
  for (std::size_t c = 0; c < marked.size(); ++c)
    if (marked[c]) result.push_back(smallest[c]);
  std::sort(result.begin(), result.end());
  return result;
}

/// The components of a surface or of curves with these cells that are beside tetrahedra, by
/// smallest vertex.
template <class Output, class Cells>
std::vector<SurfaceMesh::Index> named_beside(const TetMesh& mesh, const Output& output,
                                             const Cells& cells,
                                             const std::vector<TetMesh::Index>& tets) {
  if (tets.empty()) return {};
  return smallest_vertices(cells, output.component,
                           components_beside(mesh, output.tet, output.component, tets));
}

/// Adds the numbers of cells that lie in these tetrahedra.
void add_cells(const std::vector<SurfaceMesh::Index>& tets, const LevelStability& level,
               std::vector<std::int32_t>& instability, std::vector<std::int32_t>& stable) {
  for (const auto t : tets) {
    const Stability stability = level.tets[as_size(t)];
    instability.push_back(static_cast<std::int32_t>(stability));
    stable.push_back(stability == Stability::stable);
  }
}

/// All but crossings and components.
StabilitySummary summary_of(const LevelStability& level, std::vector<SurfaceMesh::Index> crossed) {
  StabilitySummary summary;
  for (const Stability s : level.tets) {
    ++(s == Stability::stable ? summary.stable_tets : summary.unstable_tets);
    if (s != Stability::stable) ++summary.reasons[std::string(name_of(s))];
  }
  std::sort(crossed.begin(), crossed.end());
  crossed.erase(std::unique(crossed.begin(), crossed.end()), crossed.end());
  for (const auto t : crossed)
    summary.crossed_stable_tets += level.tets[as_size(t)] == Stability::stable;
  return summary;
}

/// Counts the vertices that simplices of one kind carry, and adds the numbers of all vertices.
template <std::size_t Vertices, class Output>
void add_crossings(const Output& output, Carrier kind, const LevelStability& level,
                   const std::vector<std::array<TetMesh::Index, Vertices>>& claimed,
                   StabilitySummary& summary, std::vector<std::int32_t>& instability,
                   std::vector<std::int32_t>& stable) {
  for (std::size_t v = 0; v < output.carrier.size(); ++v) {
    if (output.carrier[v] != kind) {
      instability.push_back(-1);
      stable.push_back(-1);
      continue;
    }
    std::array<TetMesh::Index, Vertices> simplex;
    std::copy_n(output.carrier_vertices[v].begin(), Vertices, simplex.begin());
    const Stability stability = crossing_stability(level, simplex);
    instability.push_back(static_cast<std::int32_t>(stability));
    stable.push_back(stability == Stability::stable);
    ++summary.crossings;
    if (stability == Stability::stable)
      ++summary.stable_crossings;
    else
      ++summary.crossing_reasons[std::string(name_of(stability))];
    if (!std::binary_search(claimed.begin(), claimed.end(), simplex)) continue;
    auto& added = summary.crossed_simplices.emplace_back();
    added.fill(-1);
    std::copy(simplex.begin(), simplex.end(), added.begin());
  }
  auto& simplices = summary.crossed_simplices;
  std::sort(simplices.begin(), simplices.end());
  simplices.erase(std::unique(simplices.begin(), simplices.end()), simplices.end());
}

}  // namespace

StabilityRun::StabilityRun(const TetMesh& mesh, const Uncertainty& uncertainty)
    : kind_(uncertainty.kind),
      value_(uncertainty.value),
      array_(uncertainty.array),
      radii_sha256_(uncertainty.radii_sha256),
      field_(mesh, vertex_radii(mesh, uncertainty)),
      arrays_{{"instability", {}, {}},
              {"stable", {}, {}},
              {"crossing_instability", {}, {}, true},
              {"crossing_stable", {}, {}, true}} {}

StabilitySummary StabilityRun::add(const ModeValue& mode, const ExtractOptions& options,
                                   const Extraction& extraction) {
  LevelStability level = level_stability(field_, mode, options);
  mark_unresolved(extraction.unresolved, level);
  const SurfaceMesh& surface = extraction.surface;
  add_cells(surface.tet, level, arrays_[0].values, arrays_[1].values);
  StabilitySummary summary = summary_of(level, surface.tet);
  add_crossings<2>(surface, Carrier::edge, level, level.claimed_edges, summary, arrays_[2].values,
                   arrays_[3].values);
  summary.components =
      smallest_vertices(surface.triangles, surface.component,
                        surface_stability(*field_.mesh, surface, level).components);
  return summary;
}

StabilitySummary StabilityRun::add(Degeneracy kind, const ExtractOptions& options,
                                   const CurveExtraction& extraction) {
  LevelStability level = curve_stability(field_, kind, options);
  mark_unresolved(extraction.unresolved, level);
  const CurveMesh& curves = extraction.curves;
  add_cells(curves.tet, level, arrays_[0].line_values, arrays_[1].line_values);
  StabilitySummary summary = summary_of(level, curves.tet);
  add_crossings<3>(curves, Carrier::face, level, level.claimed_faces, summary,
                   arrays_[2].line_values, arrays_[3].line_values);
  summary.components =
      smallest_vertices(curves.lines, curves.component, stable_curves(*field_.mesh, curves, level));
  return summary;
}

std::optional<StabilityClaim> StabilityRun::claim(
    const StabilitySummary& summary, const std::vector<SurfaceMesh::Index>& beside) const {
  if (kind_ == Uncertainty::Kind::per_vertex && array_.empty()) return std::nullopt;
  StabilityClaim claim{kind_ == Uncertainty::Kind::relative,
                       value_,
                       {},
                       array_,
                       radii_sha256_,
                       summary.crossed_simplices};
  std::set_difference(summary.components.begin(), summary.components.end(), beside.begin(),
                      beside.end(), std::back_inserter(claim.components));
  return claim;
}

std::optional<StabilityClaim> StabilityRun::claim(
    const StabilitySummary& summary, const SurfaceMesh& surface,
    const std::vector<TetMesh::Index>& undecided) const {
  return claim(summary, named_beside(*field_.mesh, surface, surface.triangles, undecided));
}

std::optional<StabilityClaim> StabilityRun::claim(
    const StabilitySummary& summary, const CurveMesh& curves,
    const std::vector<TetMesh::Index>& undecided) const {
  return claim(summary, named_beside(*field_.mesh, curves, curves.lines, undecided));
}

}  // namespace tensortopo
