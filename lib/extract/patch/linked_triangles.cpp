// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/linked_triangles.hpp"

#include <algorithm>
#include <utility>

namespace tensortopo {

LinkedTriangles::LinkedTriangles(std::vector<Triangle> triangles)
    : triangles_(std::move(triangles)), across_(triangles_.size(), {kNone, kNone, kNone}) {
  struct Side {
    std::uint64_t edge;  ///< smaller vertex first
    std::uint32_t triangle, corner;
  };
  std::vector<Side> sides;
  sides.reserve(3 * triangles_.size());
  for (std::uint32_t t = 0; t < triangles_.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(triangles_[t][k], triangles_[t][(k + 1) % 3]);
      sides.push_back({std::uint64_t{low} << 32 | high, t, k});
    }
  std::sort(sides.begin(), sides.end(),
            [](const Side& p, const Side& q) { return p.edge < q.edge; });
  for (std::size_t i = 0; i + 1 < sides.size(); ++i)
    if (sides[i].edge == sides[i + 1].edge) {
      across_[sides[i].triangle][sides[i].corner] = sides[i + 1].triangle;
      across_[sides[i + 1].triangle][sides[i + 1].corner] = sides[i].triangle;
    }
}

std::uint32_t LinkedTriangles::corner_of(std::size_t t, Vertex v) const {
  const auto& corners = triangles_[t];
  return static_cast<std::uint32_t>(std::find(corners.begin(), corners.end(), v) - corners.begin());
}

void LinkedTriangles::set_across(std::uint32_t t, std::uint32_t from, std::uint32_t to) {
  if (t != kNone) *std::find(across_[t].begin(), across_[t].end(), from) = to;
}

auto LinkedTriangles::pair_at(std::size_t t, std::size_t k) const -> Pair {
  Pair pair{across_[t][k],
            0,
            triangles_[t][k],
            triangles_[t][(k + 1) % 3],
            triangles_[t][(k + 2) % 3],
            0};
  pair.corner = corner_of(pair.other, pair.b);
  pair.d = triangles_[pair.other][(pair.corner + 2) % 3];
  return pair;
}

bool LinkedTriangles::has_edge(Vertex a, Vertex b) const {
  return std::any_of(triangles_.begin(), triangles_.end(), [&](const Triangle& t) {
    return std::find(t.begin(), t.end(), a) != t.end() &&
           std::find(t.begin(), t.end(), b) != t.end();
  });
}

void LinkedTriangles::bisect(std::uint32_t t, std::uint32_t k, Vertex middle) {
  const auto [u, at_b, a, b, c, d] = pair_at(t, k);
  const std::uint32_t bc = across_[t][(k + 1) % 3], ca = across_[t][(k + 2) % 3],
                      ad = across_[u][(at_b + 1) % 3], db = across_[u][(at_b + 2) % 3];
  const auto p = static_cast<std::uint32_t>(triangles_.size()), q = p + 1;
  triangles_[t] = {a, middle, c};
  triangles_[u] = {middle, a, d};
  triangles_.push_back({middle, b, c});
  triangles_.push_back({b, middle, d});
  across_[t] = {u, p, ca};
  across_[u] = {t, ad, q};
  across_.push_back({q, bc, t});
  across_.push_back({p, u, db});
  set_across(bc, t, p);
  set_across(db, u, q);
}

void LinkedTriangles::flip(std::uint32_t t, std::uint32_t k) {
  const auto [u, at_b, a, b, c, d] = pair_at(t, k);
  const std::uint32_t bc = across_[t][(k + 1) % 3], ca = across_[t][(k + 2) % 3],
                      ad = across_[u][(at_b + 1) % 3], db = across_[u][(at_b + 2) % 3];
  triangles_[t] = {a, d, c};
  triangles_[u] = {d, b, c};
  across_[t] = {ad, u, ca};
  across_[u] = {db, bc, t};
  set_across(ad, u, t);
  set_across(bc, t, u);
}

}  // namespace tensortopo
