// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/stability/level_stability.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "stable_cells.hpp"
#include "stable_simplex.hpp"
#include "tensortopo/scalar/elementary.hpp"

namespace tensortopo {

using stability::CellTests;

std::string_view name_of(Stability stability) {
  switch (stability) {
    case Stability::stable:
      return "stable";
    case Stability::isotropic_within_radius:
      return "isotropic_within_radius";
    case Stability::side_of_vertex:
      return "side_of_vertex";
    case Stability::crossings_of_edge:
      return "crossings_of_edge";
    case Stability::curves_of_face:
      return "curves_of_face";
    case Stability::sheets_of_tet:
      return "sheets_of_tet";
    case Stability::unresolved:
      return "unresolved";
    case Stability::degenerate_vertex:
      return "degenerate_vertex";
    case Stability::degenerate_edge:
      return "degenerate_edge";
    case Stability::points_of_face:
      return "points_of_face";
    case Stability::arcs_of_tet:
      return "arcs_of_tet";
  }
  return "?";
}

std::string stability_names() {
  std::string names;
  for (int i = 0; i <= static_cast<int>(Stability::arcs_of_tet); ++i) {
    names += (i == 0 ? "" : ", ") + std::to_string(i) + ' ';
    names += name_of(static_cast<Stability>(i));
  }
  return names;
}

LevelStability level_stability(const UncertainField& field, const ModeValue& mu,
                               const ExtractOptions& options) {
  const double mode = mu.approx();
  if (!(std::abs(mode) < 1))
    throw std::invalid_argument("stability of a level: the mode must be between -1 and 1, not " +
                                mu.text());
  CellTests tests;
  tests.lode_angle = elementary::acos(mode) / 3;
  tests.vertex = [&](const stability::Traceless& tensor, std::size_t v) {
    return stability::side_is_stable(tensor, field.radii[v], mode);
  };
  const auto is_free = [mode](const auto& simplex, int parts) {
    return stability::has_no_critical_point(simplex, mode, parts);
  };
  tests.edge = is_free, tests.face = is_free, tests.tet = is_free;
  tests.reasons = {Stability::side_of_vertex, Stability::crossings_of_edge,
                   Stability::curves_of_face, Stability::sheets_of_tet};
  return stability::stable_cells(field, tests, options);
}

void mark_unresolved(std::span<const UnresolvedCell> unresolved, LevelStability& stability) {
  for (const UnresolvedCell& cell : unresolved)
    stability.tets[as_size(cell.tet)] = Stability::unresolved;
}

void mark_unresolved(std::span<const UnresolvedCurve> unresolved, LevelStability& stability) {
  for (const UnresolvedCurve& cell : unresolved)
    stability.tets[as_size(cell.tet)] = Stability::unresolved;
}

namespace {

template <std::size_t Vertices>
Stability stability_of(const std::array<TetMesh::Index, Vertices>& vertices,
                       const std::vector<std::array<TetMesh::Index, Vertices>>& stable,
                       const std::vector<UnstableSimplex<Vertices>>& unstable) {
  if (std::binary_search(stable.begin(), stable.end(), vertices)) return Stability::stable;
  const auto found = std::lower_bound(
      unstable.begin(), unstable.end(), vertices,
      [](const UnstableSimplex<Vertices>& a, const auto& b) { return a.vertices < b; });
  return found != unstable.end() && found->vertices == vertices ? found->reason
                                                                : Stability::unresolved;
}

}  // namespace

Stability crossing_stability(const LevelStability& stability,
                             const std::array<TetMesh::Index, 2>& vertices) {
  return stability_of(vertices, stability.stable_edges, stability.unstable_edges);
}

Stability crossing_stability(const LevelStability& stability,
                             const std::array<TetMesh::Index, 3>& vertices) {
  return stability_of(vertices, stability.stable_faces, stability.unstable_faces);
}

}  // namespace tensortopo
