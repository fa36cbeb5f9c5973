// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <rapidcheck/gtest.h>
#include <utility>
#include <vector>

#include "extract/patch/linked_triangles.hpp"

namespace tensortopo::test {
namespace {

using Edges = std::map<std::pair<LinkedTriangles::Vertex, LinkedTriangles::Vertex>, std::uint32_t>;

/// The directed edges, with their triangles; fails if one is there twice.
Edges edges_of(const LinkedTriangles& disc) {
  Edges edges;
  for (std::uint32_t t = 0; t < disc.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      RC_ASSERT((edges.try_emplace({disc[t][k], disc[t][(k + 1) % 3]}, t).second));
  return edges;
}

/// @return how many edges have two triangles
std::size_t require_disc(const LinkedTriangles& disc, std::size_t boundary, std::size_t vertices) {
  const Edges edges = edges_of(disc);
  std::size_t inner = 0;
  for (std::uint32_t t = 0; t < disc.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto a = disc[t][k], b = disc[t][(k + 1) % 3];
      const auto other = edges.find({b, a});
      RC_ASSERT(disc.across(t, k) == (other == edges.end() ? LinkedTriangles::kNone : other->second));
      if (other == edges.end()) {
        RC_ASSERT(b == (a + 1) % boundary);
        continue;
      }
      ++inner;
      const auto& u = disc[other->second];
      const auto tip = disc.pair_at(t, k).d;
      RC_ASSERT(tip != a && tip != b && std::find(u.begin(), u.end(), tip) != u.end());
      RC_ASSERT(disc.has_edge(a, b) && disc.has_edge(b, a));
    }
  RC_ASSERT(edges.size() == inner + boundary);
  RC_ASSERT(vertices + disc.size() == inner / 2 + boundary + 1);
  return inner / 2;
}

// A fan of a polygon; then edges inside are bisected or flipped at random.
RC_GTEST_PROP(LinkedTrianglesLaw, StayADiscWithItsBoundary, ()) {
  const auto corners = *rc::gen::inRange<std::uint32_t>(4, 20);
  std::vector<LinkedTriangles::Triangle> fan;
  for (std::uint32_t i = 1; i + 1 < corners; ++i) fan.push_back({0, i, i + 1});
  LinkedTriangles disc(fan);
  std::size_t vertices = corners;
  const auto boundary = vertices;
  std::size_t flips = 0, bisections = 0;
  for (int step = 0; step < 40; ++step) {
    RC_ASSERT(require_disc(disc, boundary, vertices) > 0);
    const auto t = *rc::gen::inRange<std::uint32_t>(0, static_cast<std::uint32_t>(disc.size()));
    const auto k = *rc::gen::inRange<std::uint32_t>(0, 3);
    if (disc.across(t, k) == LinkedTriangles::kNone) continue;
    const auto a = disc[t][(k + 2) % 3], b = disc.pair_at(t, k).d;
    if (*rc::gen::arbitrary<bool>()) {
      disc.bisect(t, k, static_cast<LinkedTriangles::Vertex>(vertices++));
      ++bisections;
    } else if (!disc.has_edge(a, b)) {
      disc.flip(t, k);
      RC_ASSERT(disc.has_edge(a, b));
      ++flips;
    }
  }
  require_disc(disc, boundary, vertices);
  RC_CLASSIFY(flips > 0 && bisections > 0, "both");
}

}  // namespace
}  // namespace tensortopo::test
