// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "levels/renumber_level.hpp"

#include "tensortopo/mesh/renumber.hpp"
#include "topology/topology_parts.hpp"

namespace tensortopo {

void renumber_level(Extraction& level, std::span<const TetMesh::Index> vertices,
                    std::span<const TetMesh::Index> tets) {
  renumber(level.surface, vertices, tets);
  for (UnresolvedCell& cell : level.unresolved) cell.tet = tets[as_size(cell.tet)];
  for (TetMesh::Index& t : level.not_embedded) t = tets[as_size(t)];
  renumber_mesh(level.topology, vertices, tets);
}

void renumber_level(CurveExtraction& level, std::span<const TetMesh::Index> vertices,
                    std::span<const TetMesh::Index> tets) {
  renumber(level.curves, vertices, tets);
  for (auto* list : {&level.unresolved, &level.special})
    for (UnresolvedCurve& cell : *list) cell.tet = tets[as_size(cell.tet)];
}

}  // namespace tensortopo
