// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>
#include <map>

#include "extract/run/extractor_scalars.hpp"
#include "extract/surface/pipeline.hpp"
#include "tensortopo/mesh/union_find.hpp"

namespace tensortopo {

/// In each tetrahedron around an edge the triangles at a crossing reach from one face to the next,
/// so fans of triangles are sets of tetrahedra that faces join.
template <class Scalar>
typename Pipeline<Scalar>::CrossingCopies Pipeline<Scalar>::crossing_copies() const {
  // Classes of the places that tetrahedra have at their edges.
  UnionFind fans(6 * tets_.size());
  const auto place = [&](std::size_t t, Index edge) {
    const auto& edges = complex_.tet_edges[t];
    return static_cast<std::uint32_t>(
        6 * t + as_size(std::find(edges.begin(), edges.end(), edge) - edges.begin()));
  };
  const auto is_meshed = [&](std::size_t t) { return !tets_[t].patch.triangles.empty(); };
  const auto crossings = [&](Index e) -> std::size_t {
    return crossings_[as_size(e)] ? crossings_[as_size(e)]->size() : 0;
  };
  for (std::size_t f = 0; f < complex_.faces.size(); ++f) {
    const auto& [t, other] = complex_.face_tets[f];
    if (other < 0 || !is_meshed(as_size(t)) || !is_meshed(as_size(other))) continue;
    for (const Index e : complex_.face_edges[f]) {
      if (crossings(e) == 0) continue;
      fans.unite(place(as_size(t), e), place(as_size(other), e));
    }
  }
  CrossingCopies result;
  constexpr auto kNone = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> first(complex_.edges.size(), kNone);
  std::map<std::uint32_t, std::size_t> copies;  // of other classes
  for (std::size_t t = 0; t < tets_.size(); ++t) {
    if (!is_meshed(t)) continue;
    for (std::size_t i = 0; i < 6; ++i) {
      const Index e = complex_.tet_edges[t][i];
      if (crossings(e) == 0) continue;
      const auto fan = fans.find(static_cast<std::uint32_t>(6 * t + i));
      if (first[as_size(e)] == kNone) first[as_size(e)] = fan;
      if (first[as_size(e)] == fan) continue;
      const auto [copy, is_new] = copies.try_emplace(fan, result.original.size());
      for (std::size_t k = 0; k < crossings(e); ++k) {
        const Index vertex = edge_vertex_[as_size(e)] + static_cast<Index>(k);
        if (is_new) result.original.push_back(vertex);
        result.of[{t, vertex}] = copy->second + k;
      }
    }
  }
  return result;
}

#define TENSORTOPO_INSTANTIATE(Scalar) \
  template Pipeline<Scalar>::CrossingCopies Pipeline<Scalar>::crossing_copies() const;
TENSORTOPO_FOR_EACH_EXTRACTOR(TENSORTOPO_INSTANTIATE)
#undef TENSORTOPO_INSTANTIATE

}  // namespace tensortopo
