// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/surface/cone_sheets.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace tensortopo {

namespace {

using Vertex = LevelTopology::Vertex;

/// What the triangles of one tetrahedron say, each turned so that it ends with an apex.
struct Fans {
  std::map<Vertex, Vertex> next, tip;  ///< along the boundary loops, and of the triangle there
  std::set<Vertex> ends;               ///< of the steps in `next`
  std::map<Vertex, LevelTopology::ConeSheet> joins;  ///< by crossing
};

std::vector<LevelTopology::ConeSheet> sheets_of(Fans fans) {
  std::vector<LevelTopology::ConeSheet> sheets;
  const auto follow = [&](Vertex from) {
    Vertex at = from, smallest = from;
    while (const auto step = fans.next.extract(at)) {
      at = step.mapped();
      smallest = std::min(smallest, at);
    }
    return std::array{at, smallest};
  };
  for (const auto& [from, tip] : fans.tip)
    if (!fans.ends.contains(from)) sheets.push_back({from, follow(from)[0], tip});
  while (!fans.next.empty()) {
    const Vertex tip = fans.tip.at(fans.next.begin()->first);
    sheets.push_back({follow(fans.next.begin()->first)[1], tip});
  }
  for (auto& [crossing, sheet] : fans.joins) sheets.push_back(std::move(sheet));
  std::sort(sheets.begin(), sheets.end());
  return sheets;
}

}  // namespace

std::vector<LevelTopology::Cone> cone_sheets(const SurfaceMesh& surface,
                                             const std::vector<char>& is_apex,
                                             std::span<const std::array<Vertex, 2>> copies) {
  std::map<Vertex, Vertex> original;
  for (const auto& [vertex, copy] : copies) original[copy] = vertex;
  std::map<LevelTopology::Index, Fans> by_tet;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    auto corners = surface.triangles[i];
    const auto apexes = std::count_if(corners.begin(), corners.end(),
                                      [&](Vertex v) { return is_apex[as_size(v)] != 0; });
    if (apexes == 0) continue;
    while (is_apex[as_size(corners[0])] || !is_apex[as_size(corners[2])])
      std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    for (Vertex& v : corners)
      if (const auto copy = original.find(v); copy != original.end()) v = copy->second;
    const auto& [from, to, tip] = corners;
    Fans& fans = by_tet[surface.tet[i]];
    if (apexes == 1) {
      fans.next[from] = to, fans.tip[from] = tip;
      fans.ends.insert(to);
      continue;
    }
    // Two triangles beside the vertex halfway, which is on an edge.
    auto& sheet = fans.joins.try_emplace(from, 4, from).first->second;
    const bool is_first = surface.carrier[as_size(tip)] == Carrier::edge;
    sheet[is_first ? 1 : 2] = to;
    sheet[is_first ? 2 : 3] = tip;
  }
  std::vector<LevelTopology::Cone> cones;
  for (auto& [tet, fans] : by_tet) cones.push_back({tet, sheets_of(std::move(fans))});
  return cones;
}

}  // namespace tensortopo
