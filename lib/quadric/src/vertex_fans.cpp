// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "vertex_fans.hpp"

#include <algorithm>
#include <map>

namespace tensortopo {
namespace {

using Index = SurfaceMesh::Index;

template <class T>
void append_copy(std::vector<T>& list, std::size_t i) {
  if (!list.empty()) list.push_back(T(list[i]));
}

}  // namespace

std::vector<std::array<Index, 2>> separate_fans(SurfaceMesh& surface) {
  std::map<std::array<Index, 2>, std::size_t> triangle_at;  // of directed edges
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      triangle_at[{surface.triangles[t][k], surface.triangles[t][(k + 1) % 3]}] = t;
  // A fan begins with an edge that only one triangle has, from the vertex on.
  std::map<Index, std::vector<std::vector<std::size_t>>> fans;
  for (const auto& [edge, first] : triangle_at) {
    if (triangle_at.contains({edge[1], edge[0]})) continue;
    auto& fan = fans[edge[0]].emplace_back();
    for (auto next = triangle_at.find(edge); next != triangle_at.end();) {
      const auto& corners = surface.triangles[next->second];
      fan.push_back(next->second);
      const auto k = std::find(corners.begin(), corners.end(), edge[0]) - corners.begin();
      next = triangle_at.find({edge[0], corners[static_cast<std::size_t>((k + 2) % 3)]});
    }
    std::sort(fan.begin(), fan.end());
  }
  std::vector<std::array<Index, 2>> copies;
  for (auto& [vertex, around] : fans) {
    std::sort(around.begin(), around.end());
    for (std::size_t f = 1; f < around.size(); ++f) {
      const auto i = static_cast<std::size_t>(vertex);
      const auto copy = static_cast<Index>(surface.points.size());
      append_copy(surface.points, i);
      append_copy(surface.carrier, i);
      append_copy(surface.carrier_id, i);
      append_copy(surface.carrier_vertices, i);
      append_copy(surface.residual, i);
      append_copy(surface.value, i);
      for (const std::size_t t : around[f])
        std::replace(surface.triangles[t].begin(), surface.triangles[t].end(), vertex, copy);
      copies.push_back({vertex, copy});
    }
  }
  return copies;
}

}  // namespace tensortopo
