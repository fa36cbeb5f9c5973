// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "claims/half_edges.hpp"

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
      if (!by_edge.emplace(key(t, i, (i + 1) % 3), t).second && !double_edge_)
        double_edge_ = {triangles[t][i], triangles[t][(i + 1) % 3]};
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto other = by_edge.find(key(t, (i + 1) % 3, i));
      across_[t][i] = other == by_edge.end() ? kNone : other->second;
    }
  }
}

void HalfEdges::require_manifold() const {
  if (double_edge_)
    throw Wrong("two triangles that run along the edge from vertex " +
                std::to_string((*double_edge_)[0]) + " to " + std::to_string((*double_edge_)[1]) +
                " in the same direction");
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

std::vector<Piece> HalfEdges::pieces(
    std::span<const std::size_t> some,
    const std::function<bool(std::size_t, std::size_t, std::size_t)>& joined) const {
  UnionFind classes;  // of the triangles' places among these
  std::vector<std::array<bool, 3>> is_inside(some.size());
  for (std::size_t n = 0; n < some.size(); ++n) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t other = across_[some[n]][i];
      is_inside[n][i] = other != kNone && joined(some[n], i, other);
      if (is_inside[n][i])
        classes.join(n, static_cast<std::size_t>(
                            std::lower_bound(some.begin(), some.end(), other) - some.begin()));
    }
  }
  std::map<std::size_t, Piece> found;  // by their first triangles
  std::map<std::pair<std::size_t, std::uint32_t>, BoundaryEdge> boundary;
  for (std::size_t n = 0; n < some.size(); ++n) {
    const Triangle& corners = triangles_[some[n]];
    const std::size_t number = classes.find(n);
    Piece& piece = found[number];
    ++piece.triangles, ++piece.euler_characteristic;
    piece.members.push_back(some[n]);
    for (std::size_t i = 0; i < 3; ++i) {
      piece.vertices.push_back(corners[i]);
      const std::size_t other = across_[some[n]][i];
      if (!is_inside[n][i] || other > some[n]) --piece.euler_characteristic;
      const BoundaryEdge edge{corners[i], corners[(i + 1) % 3], other};
      if (!is_inside[n][i] && !boundary.try_emplace({number, corners[i]}, edge).second)
        throw Wrong("the boundary passes vertex " + std::to_string(corners[i]) + " twice");
    }
  }
  while (!boundary.empty()) {
    auto [number, at] = boundary.begin()->first;
    auto& loop = found[number].loops.emplace_back();
    while (const auto next = boundary.extract({number, at})) {
      loop.push_back(next.mapped());
      at = next.mapped().to;
    }
    if (at != loop.front().from)
      throw Wrong("a boundary loop that does not close at vertex " + std::to_string(at));
  }
  std::vector<Piece> result;
  for (auto& [number, piece] : found) {
    std::sort(piece.vertices.begin(), piece.vertices.end());
    piece.vertices.erase(std::unique(piece.vertices.begin(), piece.vertices.end()),
                         piece.vertices.end());
    piece.euler_characteristic += static_cast<long>(piece.vertices.size());
    if (!piece.loops.empty()) piece.members.clear();
    result.push_back(std::move(piece));
  }
  std::sort(result.begin(), result.end(),
            [](const Piece& a, const Piece& b) { return a.vertices < b.vertices; });
  return result;
}

}  // namespace certificate
