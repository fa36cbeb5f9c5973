// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace tensortopo {

/// Triangles of a disc between numbered vertices, with their neighbours. All run one way.
class DiscTriangles {
 public:
  using Vertex = std::uint32_t;
  using Triangle = std::array<Vertex, 3>;
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// @param triangles  of a disc
  explicit DiscTriangles(std::span<const std::array<int, 3>> triangles);

  std::size_t size() const { return triangles_.size(); }
  const Triangle& operator[](std::size_t t) const { return triangles_[t]; }
  /// The triangle across the edge from corner k to the next; `kNone` on the boundary.
  std::uint32_t across(std::size_t t, std::size_t k) const { return across_[t][k]; }
  /// The corner of the triangle across that edge that is not on it.
  Vertex opposite(std::size_t t, std::size_t k) const;
  bool has_edge(Vertex a, Vertex b) const;

  /// Puts a new vertex on the edge from corner k to the next, which is inside: two triangles become
  /// four, the new ones the last.
  void bisect(std::uint32_t t, std::uint32_t k, Vertex middle);
  /// Replaces that edge, which is inside, by the other diagonal.
  void flip(std::uint32_t t, std::uint32_t k);

 private:
  std::uint32_t corner_of(std::uint32_t t, Vertex v) const;
  void set_across(std::uint32_t t, std::uint32_t from, std::uint32_t to);

  std::vector<Triangle> triangles_;
  std::vector<std::array<std::uint32_t, 3>> across_;
};

}  // namespace tensortopo
