// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace tensortopo {

/// Triangles of sheets between numbered vertices, with their neighbours. Neighbours run one way.
class LinkedTriangles {
 public:
  using Vertex = std::uint32_t;
  using Triangle = std::array<Vertex, 3>;
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// Two triangles with a common edge from a to b: a, b, c and b, a, d.
  struct Pair {
    std::uint32_t other = kNone;  ///< the second one
    std::uint32_t corner = 0;     ///< of the second one, that is b
    Vertex a = 0, b = 0, c = 0, d = 0;
  };

  explicit LinkedTriangles(std::vector<Triangle> triangles);

  std::size_t size() const { return triangles_.size(); }
  const Triangle& operator[](std::size_t t) const { return triangles_[t]; }
  /// The triangle across the edge from corner k to the next; `kNone` on the boundary.
  std::uint32_t across(std::size_t t, std::size_t k) const { return across_[t][k]; }
  /// @pre that edge is inside
  Pair pair_at(std::size_t t, std::size_t k) const;
  bool has_edge(Vertex a, Vertex b) const;
  /// Which corner of a triangle a vertex is.
  std::uint32_t corner_of(std::size_t t, Vertex v) const;

  /// Puts a new vertex on the edge from corner k to the next, which is inside: two triangles become
  /// four, the new ones the last.
  void bisect(std::uint32_t t, std::uint32_t k, Vertex middle);
  /// Replaces that edge, which is inside, by the other diagonal: a, d, c and d, b, c.
  void flip(std::uint32_t t, std::uint32_t k);

 private:
  void set_across(std::uint32_t t, std::uint32_t from, std::uint32_t to);

  std::vector<Triangle> triangles_;
  std::vector<std::array<std::uint32_t, 3>> across_;
};

}  // namespace tensortopo
