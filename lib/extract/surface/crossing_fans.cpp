// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/surface/crossing_fans.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include "extract/run/extractor_scalars.hpp"
#include "extract/run/parallel_stage.hpp"
#include "extract/surface/concurrent_union_find.hpp"

namespace tensortopo {

/// In each tetrahedron around an edge the triangles at a crossing reach from one face to the next,
/// so fans of triangles are sets of tetrahedra that faces join.
template <class Scalar>
CrossingCopies crossing_copies(const ExtractOptions& options, const TetComplex& cells,
                               const CellMeshes<Scalar>& meshes) {
  using Index = TetMesh::Index;
  const auto& rows = meshes.boundary.crossings.rows;
  const std::size_t count = meshes.cells.size();
  // Classes of the places that tetrahedra have at their edges.
  ConcurrentUnionFind fans(6 * count);
  const auto place = [&](std::size_t t, Index edge) {
    const auto& edges = cells.tet_edges[t];
    return static_cast<std::uint32_t>(
        6 * t + as_size(std::find(edges.begin(), edges.end(), edge) - edges.begin()));
  };
  const auto is_meshed = [&](std::size_t t) { return !meshes.cells[t].patch.triangles.empty(); };
  const auto crossings = [&](Index e) { return rows[as_size(e)].size(); };
  parallel_stage(options, "stitch", cells.faces.size(), 1024, [&](std::size_t f) {
    const auto& [t, other] = cells.face_tets[f];
    if (other < 0 || !is_meshed(as_size(t)) || !is_meshed(as_size(other))) return;
    for (const Index e : cells.face_edges[f])
      if (crossings(e) != 0) fans.unite(place(as_size(t), e), place(as_size(other), e));
  });
  // The first fan of an edge is that of its first tetrahedron, whose class has the least name.
  std::vector<std::uint32_t> first(cells.edges.size(), std::numeric_limits<std::uint32_t>::max());
  const auto fan_of = [&](std::size_t t, std::size_t i) {
    return fans.find(static_cast<std::uint32_t>(6 * t + i));
  };
  parallel_stage(options, "stitch", count, 1024, [&](std::size_t t) {
    if (!is_meshed(t)) return;
    for (std::size_t i = 0; i < 6; ++i) {
      const Index e = cells.tet_edges[t][i];
      if (crossings(e) == 0) continue;
      const std::atomic_ref least(first[as_size(e)]);
      const auto fan = fan_of(t, i);
      for (auto known = least.load(std::memory_order_relaxed);
           fan < known && !least.compare_exchange_weak(known, fan, std::memory_order_relaxed);) {
      }
    }
  });
  std::vector<char> has_copies(count, 0);
  const auto is_copied = [&](std::size_t t, std::size_t i) {
    const Index e = cells.tet_edges[t][i];
    return crossings(e) != 0 && first[as_size(e)] != fan_of(t, i);
  };
  parallel_stage(options, "stitch", count, 1024, [&](std::size_t t) {
    for (std::size_t i = 0; i < 6 && is_meshed(t); ++i)
      if (is_copied(t, i)) has_copies[t] = 1;
  });
  CrossingCopies result;
  std::map<std::uint32_t, std::size_t> copies;  // of other classes
  for (std::size_t t = 0; t < count; ++t) {
    if (!has_copies[t]) continue;
    for (std::size_t i = 0; i < 6; ++i) {
      if (!is_copied(t, i)) continue;
      const Index e = cells.tet_edges[t][i];
      const auto [copy, is_new] = copies.try_emplace(fan_of(t, i), result.original.size());
      for (std::size_t k = 0; k < crossings(e); ++k) {
        const auto vertex = static_cast<Index>(rows.first(as_size(e)) + k);
        if (is_new) result.original.push_back(vertex);
        result.of[{t, vertex}] = copy->second + k;
      }
    }
  }
  return result;
}

#define TENSORTOPO_INSTANTIATE(Scalar)                                              \
  template CrossingCopies crossing_copies(const ExtractOptions&, const TetComplex&, \
                                          const CellMeshes<Scalar>&);
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
