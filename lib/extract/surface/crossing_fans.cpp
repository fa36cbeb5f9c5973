// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/surface/crossing_fans.hpp"

#include <algorithm>
#include <cstdint>
#include <map>

#include "extract/run/extractor_scalars.hpp"
#include "tensortopo/mesh/union_find.hpp"

namespace tensortopo {

/// In each tetrahedron around an edge the triangles at a crossing reach from one face to the next,
/// so fans of triangles are sets of tetrahedra that faces join.
template <class Scalar>
CrossingCopies crossing_copies(const TetComplex& cells, const CellMeshes<Scalar>& meshes) {
  using Index = TetMesh::Index;
  const auto& rows = meshes.boundary.crossings.rows;
  const std::size_t count = meshes.cells.size();
  // Classes of the places that tetrahedra have at their edges.
  UnionFind fans(6 * count);
  const auto place = [&](std::size_t t, Index edge) {
    const auto& edges = cells.tet_edges[t];
    return static_cast<std::uint32_t>(
        6 * t + as_size(std::find(edges.begin(), edges.end(), edge) - edges.begin()));
  };
  const auto is_meshed = [&](std::size_t t) { return !meshes.cells[t].patch.triangles.empty(); };
  const auto crossings = [&](Index e) { return rows[as_size(e)].size(); };
  for (std::size_t f = 0; f < cells.faces.size(); ++f) {
    const auto& [t, other] = cells.face_tets[f];
    if (other < 0 || !is_meshed(as_size(t)) || !is_meshed(as_size(other))) continue;
    for (const Index e : cells.face_edges[f]) {
      if (crossings(e) == 0) continue;
      fans.unite(place(as_size(t), e), place(as_size(other), e));
    }
  }
  CrossingCopies result;
  constexpr auto kNone = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> first(cells.edges.size(), kNone);
  std::map<std::uint32_t, std::size_t> copies;  // of other classes
  for (std::size_t t = 0; t < count; ++t) {
    if (!is_meshed(t)) continue;
    for (std::size_t i = 0; i < 6; ++i) {
      const Index e = cells.tet_edges[t][i];
      if (crossings(e) == 0) continue;
      const auto fan = fans.find(static_cast<std::uint32_t>(6 * t + i));
      if (first[as_size(e)] == kNone) first[as_size(e)] = fan;
      if (first[as_size(e)] == fan) continue;
      const auto [copy, is_new] = copies.try_emplace(fan, result.original.size());
      for (std::size_t k = 0; k < crossings(e); ++k) {
        const auto vertex = static_cast<Index>(rows.first(as_size(e)) + k);
        if (is_new) result.original.push_back(vertex);
        result.of[{t, vertex}] = copy->second + k;
      }
    }
  }
  return result;
}

#define TENSORTOPO_INSTANTIATE(Scalar) \
  template CrossingCopies crossing_copies(const TetComplex&, const CellMeshes<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
