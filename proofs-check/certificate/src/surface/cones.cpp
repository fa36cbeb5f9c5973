// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "surface/cones.hpp"

#include <algorithm>

#include "claims/half_edges.hpp"

namespace certificate {
namespace {

/// The vertex of a cone's base that is not on the edge of a crossing.
Vertex off_edge(const ConeTopology& cone, const CrossingVertices& vertices, const Json& crossing) {
  const auto place = vertices.crossing.find(crossing.get<Number>());
  for (const Vertex v : cone.base)
    if (place != vertices.crossing.end() && v != place->second.edge[0] &&
        v != place->second.edge[1])
      return v;
  throw Wrong("a cone over no arc at vertex " + crossing.dump());
}

}  // namespace

Json with_loops(const LevelCase& c, const CrossingVertices& vertices, const ConeTopology& cone,
                const Json& claim) {
  Json result = Json::array({claim[0]});
  for (std::size_t i = 1; i < claim.size(); ++i) {
    const Json& s = claim[i];
    for (const Json& v : s)
      if (v.get<Number>() - c.vertices.first >= c.vertices.count)
        throw Wrong("a cone with vertex " + v.dump() + " of another level");
    if (s.size() != (cone.tips.size() == 2 ? 4 : std::min<std::size_t>(s.size(), 3)))
      throw Wrong("a cone with " + std::to_string(s.size()) + " vertices, " +
                  std::to_string(cone.tips.size()) + " of them tips");
    Json loop;
    if (s.size() == 2) {
      loop = {s[0], cone.tips[0]};
    } else if (s.size() == 3) {
      loop = {s[0], cone.tips[0], s[1], off_edge(cone, vertices, s[1]), s[2],
              off_edge(cone, vertices, s[0])};
    } else {
      const bool ascends = is_at(c, s[1], cone.tips[0]);
      loop = {s[0], cone.tips[ascends ? 1 : 0], s[1], nullptr, s[2], nullptr, s[3],
              cone.tips[ascends ? 0 : 1]};
    }
    result.push_back({1, loop});
  }
  return result;
}

Folds::Folds(const LevelCase& c) : c_(c) {
  for (const ConeTopology& cone : c.topology.cones)
    for (const Vertex end : cone.base)
      if (cone.tips.size() == 2) at_[{cone.tips[0], cone.tips[1], end}].push_back(&cone);
}

Fold Folds::beyond(const Fold& fold, std::array<Vertex, 3>& last) const {
  const ConeTopology* at = fold.cone;
  bool forwards = c_.topology.above[at->base[0]] != (fold.sheet % 2 == 0);
  std::size_t next = forwards ? fold.sheet + 1 : fold.sheet - 1;
  while (next >= at->sheets.size()) {  // so are numbers below zero
    last = {at->tips[0], at->tips[1], at->base[forwards ? 1 : 0]};
    const ConeTopology* neighbour = nullptr;
    for (const ConeTopology* other : at_.at(last))
      if (other != at) neighbour = other;
    if (neighbour == nullptr) return {};
    at = neighbour;
    if (!at->is_decided()) return {at, 0};
    forwards = at->base[0] == last[2];
    next = forwards ? 0 : at->sheets.size() - 1;
  }
  return {at, next};
}

}  // namespace certificate
