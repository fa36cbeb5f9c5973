// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "conformance/split_fans.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "tensortopo/mesh/union_find.hpp"

namespace tensortopo {

namespace {

using Index = SurfaceMesh::Index;
using Place = std::array<double, 3>;

// Zeros of both signs are one place.
Place place_of(const Vector3<double>& p, bool single) {
  const auto rounded = [&](double x) {
    return (single ? static_cast<double>(static_cast<float>(x)) : x) + 0.0;
  };
  return {rounded(p.x), rounded(p.y), rounded(p.z)};
}

}  // namespace

void split_fans(GivenSurface& given, const SurfaceMesh& truth) {
  const bool single = given.is_single_precision;
  std::set<Place> seen, several;
  for (const auto& p : truth.points)
    if (!seen.insert(place_of(p, single)).second) several.insert(place_of(p, single));
  if (several.empty()) return;
  SurfaceMesh& surface = given.surface;
  std::vector<std::vector<std::size_t>> around(surface.points.size());
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    for (const Index v : surface.triangles[i]) around[as_size(v)].push_back(i);
  for (std::size_t v = 0; v < around.size(); ++v) {
    if (!several.contains(place_of(surface.points[v], single))) continue;
    // Triangles of one fan share edges from here.
    UnionFind fans(around[v].size());
    std::map<Index, std::uint32_t> first;
    for (std::uint32_t i = 0; i < around[v].size(); ++i)
      for (const Index w : surface.triangles[around[v][i]])
        if (as_size(w) != v) fans.unite(i, first.try_emplace(w, i).first->second);
    std::map<std::uint32_t, Index> vertex{{0u, static_cast<Index>(v)}};
    for (std::uint32_t i = 0; i < around[v].size(); ++i) {
      const auto [found, fresh] =
          vertex.try_emplace(fans.find(i), static_cast<Index>(surface.points.size()));
      if (fresh) surface.points.push_back(Vector3<double>(surface.points[v]));
      for (Index& w : surface.triangles[around[v][i]])
        if (as_size(w) == v) w = found->second;
    }
  }
}

}  // namespace tensortopo
