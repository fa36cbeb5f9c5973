// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "half_edges.hpp"

#include <algorithm>
#include <map>
#include <unordered_map>

#include "union_find.hpp"

namespace certificate {

HalfEdges::HalfEdges(std::span<const Triangle> triangles)
    : triangles_(triangles), across_(triangles.size()) {
  std::unordered_map<std::uint64_t, std::size_t> by_edge;  // directed
  by_edge.reserve(3 * triangles.size());
  const auto key = [&](std::size_t t, std::size_t from, std::size_t to) {
    return static_cast<std::uint64_t>(triangles[t][from]) << 32 | triangles[t][to];
  };
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      if (!by_edge.emplace(key(t, i, (i + 1) % 3), t).second) has_double_edge_ = true;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto other = by_edge.find(key(t, (i + 1) % 3, i));
      across_[t][i] = other == by_edge.end() ? kNone : other->second;
    }
  }
}

void HalfEdges::require_manifold() const {
  if (has_double_edge_)
    throw Wrong("an edge that two triangles run along in the same direction");
  // Corners of one vertex that a common edge joins are in one fan.
  UnionFind fans;
  const auto corner_at = [&](std::size_t t, std::uint32_t vertex) {
    const auto& corners = triangles_[t];
    return 3 * t + static_cast<std::size_t>(
                       std::find(corners.begin(), corners.end(), vertex) - corners.begin());
  };
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      if (const std::size_t other = across_[t][i]; other != kNone)
        for (const std::size_t end : {i, (i + 1) % 3})
          fans.join(3 * t + end, corner_at(other, triangles_[t][end]));
  std::unordered_map<std::uint32_t, std::size_t> fan_of;
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      if (const std::size_t fan = fans.find(3 * t + i);
          fan_of.emplace(triangles_[t][i], fan).first->second != fan)
        throw Wrong("more than one fan of triangles around vertex " +
                    std::to_string(triangles_[t][i]));
}

std::vector<Piece> HalfEdges::pieces(std::span<const std::size_t> some,
                                     const std::function<bool(std::size_t)>& among) const {
  UnionFind joined;  // by the triangles' places among these
  std::map<std::uint32_t, RimEdge> rim;
  std::map<std::uint32_t, std::size_t> triangle_at;  // one of each vertex
  std::vector<long> edges(some.size());
  for (std::size_t n = 0; n < some.size(); ++n) {
    const Triangle& corners = triangles_[some[n]];
    for (std::size_t i = 0; i < 3; ++i) {
      triangle_at.emplace(corners[i], n);
      const std::size_t other = across_[some[n]][i];
      const bool is_inside = other != kNone && among(other);
      if (!is_inside || other > some[n]) ++edges[n];
      if (is_inside) {
        joined.join(n, static_cast<std::size_t>(std::lower_bound(some.begin(), some.end(), other) -
                                                some.begin()));
        continue;
      }
      if (!rim.emplace(corners[i], RimEdge{corners[i], corners[(i + 1) % 3], other}).second)
        throw Wrong("the rim passes vertex " + std::to_string(corners[i]) + " twice");
    }
  }
  std::map<std::size_t, std::size_t> numbers;  // of the pieces, by their first triangles
  std::vector<Piece> found;
  for (const auto& [v, n] : triangle_at) {
    const auto [place, is_new] = numbers.try_emplace(joined.find(n), found.size());
    if (is_new) found.emplace_back().first_vertex = v;
    ++found[place->second].euler_characteristic;
  }
  const auto piece_of = [&](std::size_t n) -> Piece& { return found[numbers.at(joined.find(n))]; };
  for (std::size_t n = 0; n < some.size(); ++n) {
    piece_of(n).euler_characteristic += 1 - edges[n];
    ++piece_of(n).triangles;
  }
  while (!rim.empty()) {
    std::uint32_t at = rim.begin()->first;
    auto& loop = piece_of(triangle_at.at(at)).loops.emplace_back();
    while (const auto next = rim.extract(at)) {
      loop.push_back(next.mapped());
      at = next.mapped().to;
    }
    if (at != loop.front().from)
      throw Wrong("a rim that does not close at vertex " + std::to_string(at));
  }
  return found;
}

}  // namespace certificate
