// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "claims/half_edges.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "union_find.hpp"

namespace certificate {

HalfEdges::HalfEdges(std::span<const Triangle> triangles)
    : triangles_(triangles), across_(triangles.size()) {
  for (const Triangle& triangle : triangles)
    for (const std::uint32_t v : triangle) vertices_ = std::max<std::size_t>(vertices_, v + 1UL);
  // The directed edges from each vertex, ascending by their ends and triangles.
  using Edge = std::pair<std::uint32_t, std::size_t>;
  std::vector<std::size_t> begin(vertices_ + 1);
  for (const Triangle& triangle : triangles)
    for (const std::uint32_t v : triangle) ++begin[v + 1UL];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Edge> edges(3 * triangles.size());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      edges[next[triangles[t][i]]++] = {triangles[t][(i + 1) % 3], t};
  const auto from = [&](std::size_t v) {
    return std::span(edges).subspan(begin[v], begin[v + 1] - begin[v]);
  };
  std::array second{kNone, kNone};  // the first triangle with an edge that is another's, and which
  for (std::uint32_t v = 0; v < vertices_; ++v) {
    const std::span<Edge> own = from(v);
    std::sort(own.begin(), own.end());
    for (std::size_t e = 1; e < own.size(); ++e) {
      const auto [to, t] = own[e];
      if (to != own[e - 1].first) continue;
      const auto i = std::find(triangles[t].begin(), triangles[t].end(), v) - triangles[t].begin();
      const std::array here{t, static_cast<std::size_t>(i)};
      if (!(here < second)) continue;
      second = here;
      double_edge_ = {v, to};
    }
  }
  const auto find = [&](std::uint32_t v, std::uint32_t to) {
    const std::span<Edge> own = from(v);
    const auto place = std::lower_bound(own.begin(), own.end(), Edge{to, 0});
    return place == own.end() || place->first != to ? kNone : place->second;
  };
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      across_[t][i] = find(triangles[t][(i + 1) % 3], triangles[t][i]);
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
  std::vector<std::size_t> fan_of(vertices_, kNone);
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      std::size_t& known = fan_of[triangles_[t][i]];
      const std::size_t fan = fans.find(3 * t + i);
      if (known != kNone && known != fan)
        throw Wrong("more than one fan of triangles around vertex " +
                    std::to_string(triangles_[t][i]));
      known = fan;
    }
}

std::vector<Piece> HalfEdges::pieces(
    std::span<const std::size_t> some,
    const std::function<bool(std::size_t, std::size_t, std::size_t)>& joined) const {
  UnionFind classes;  // of the triangles' places among these
  const bool are_all = some.size() == triangles_.size();
  std::vector<std::array<bool, 3>> is_inside(some.size());
  for (std::size_t n = 0; n < some.size(); ++n) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t other = across_[some[n]][i];
      is_inside[n][i] = other != kNone && joined(some[n], i, other);
      if (is_inside[n][i])
        classes.join(n, are_all ? other
                                : static_cast<std::size_t>(
                                      std::lower_bound(some.begin(), some.end(), other) -
                                      some.begin()));
    }
  }
  std::vector<Piece> result;                            // by their first triangles
  std::vector<std::size_t> place(some.size(), kNone);  // of classes
  struct Boundary {
    std::size_t piece;
    BoundaryEdge edge;
    bool is_taken;
  };
  std::vector<Boundary> boundary;
  for (std::size_t n = 0; n < some.size(); ++n) {
    const Triangle& corners = triangles_[some[n]];
    std::size_t& number = place[classes.find(n)];
    if (number == kNone) number = result.size(), result.emplace_back();
    Piece& piece = result[number];
    ++piece.triangles, ++piece.euler_characteristic;
    piece.members.push_back(some[n]);
    for (std::size_t i = 0; i < 3; ++i) {
      piece.vertices.push_back(corners[i]);
      const std::size_t other = across_[some[n]][i];
      if (!is_inside[n][i] || other > some[n]) --piece.euler_characteristic;
      if (!is_inside[n][i])
        boundary.push_back({number, {corners[i], corners[(i + 1) % 3], other}, false});
    }
  }
  const auto key = [](const Boundary& b) { return std::pair(b.piece, b.edge.from); };
  std::stable_sort(boundary.begin(), boundary.end(),
                   [&](const Boundary& a, const Boundary& b) { return key(a) < key(b); });
  for (std::size_t e = 1; e < boundary.size(); ++e)
    if (key(boundary[e]) == key(boundary[e - 1]))
      throw Wrong("the boundary passes vertex " + std::to_string(boundary[e].edge.from) + " twice");
  for (Boundary& first : boundary) {
    if (first.is_taken) continue;
    auto& loop = result[first.piece].loops.emplace_back();
    Boundary* at = &first;
    while (at != nullptr) {
      at->is_taken = true;
      loop.push_back(at->edge);
      const auto next = std::lower_bound(
          boundary.begin(), boundary.end(), std::pair(at->piece, at->edge.to),
          [&](const Boundary& b, const auto& wanted) { return key(b) < wanted; });
      at = next == boundary.end() || next->is_taken ||
                   key(*next) != std::pair(at->piece, at->edge.to)
               ? nullptr
               : &*next;
    }
    if (loop.back().to != loop.front().from)
      throw Wrong("a boundary loop that does not close at vertex " +
                  std::to_string(loop.back().to));
  }
  for (Piece& piece : result) {
    std::sort(piece.vertices.begin(), piece.vertices.end());
    piece.vertices.erase(std::unique(piece.vertices.begin(), piece.vertices.end()),
                         piece.vertices.end());
    piece.euler_characteristic += static_cast<long>(piece.vertices.size());
    if (!piece.loops.empty()) piece.members.clear();
  }
  std::sort(result.begin(), result.end(),
            [](const Piece& a, const Piece& b) { return a.vertices < b.vertices; });
  return result;
}

}  // namespace certificate
