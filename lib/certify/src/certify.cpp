// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "claims.hpp"
#include "crossing_brackets.hpp"
#include "distance_proof.hpp"
#include "for_each.hpp"
#include "extract/level/level.hpp"
#include "tensortopo/certify/certified_level.hpp"

namespace tensortopo {

namespace {

using Index = TetMesh::Index;

Brackets brackets_of(const LevelTopology& topology, const ScaledField<double>& field,
                     const Level<double>& level) {
  Brackets brackets(topology.edges.size());
  detail::for_each(brackets.size(), [&](std::size_t e) {
    brackets[e] = crossing_brackets(topology.edges[e], field, level);
  });
  return brackets;
}

}  // namespace

CertifiedLevel certify(const TetMesh& mesh, const ModeValue& mode, Extraction& extraction) {
  const SurfaceMesh& surface = extraction.surface;
  const ScaledField<double> field(mesh);
  const auto level = make_level<double>(mode);
  CertifiedLevel result;
  result.value = mode;
  result.vertices = surface.points.size();
  result.triangles = surface.triangles.size();
  result.on_level = extraction.statistics.vertices_on_level;
  result.topology = std::move(extraction.topology);

  for (const auto& cell : extraction.unresolved)
    result.undecided.push_back({cell.tet, std::string(name_of(cell.reason))});
  drop_cells(mesh, result, brackets_of(result.topology, field, level),
             [](Index) { return std::string(); });
  result.components = components_of(surface);
  result.distance = prove_distance(mesh, surface, decided_triangles(mesh, surface, result),
                                   result.topology, field, level);
  return result;
}

}  // namespace tensortopo
