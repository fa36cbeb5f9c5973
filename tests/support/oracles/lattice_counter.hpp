// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "support/surfaces/topology.hpp"

namespace tensortopo::test {

/// Disjoint sets of small integers.
class UnionFind {
 public:
  int add() {
    parent_.push_back(static_cast<int>(parent_.size()));
    return parent_.back();
  }
  int find(int i) {
    while (parent_[index(i)] != i) {
      i = parent_[index(i)] = parent_[index(parent_[index(i)])];
    }
    return i;
  }
  void unite(int i, int j) {
    const int p = find(i), q = find(j);
    if (p < q) {
      parent_[index(q)] = p;
    } else {
      parent_[index(p)] = q;
    }
  }
  int size() const { return static_cast<int>(parent_.size()); }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  std::vector<int> parent_;
};

/// Counts a surface made of polygons whose vertices are crossed lattice edges.
///
/// Vertices are named by keys; polygons are joined where they share a vertex; the Euler
/// characteristic of each component is vertices - edges + polygons, and its boundary loops are the
/// cycles of the boundary segments. No geometry is involved.
class PolygonCounter {
 public:
  explicit PolygonCounter(std::size_t expected_vertices);

  /// The vertex on the lattice edge with this key.
  int vertex(std::uint32_t key);
  void add_polygon(const int* vertices, int count);
  /// A side of a polygon that lies on the boundary of the domain.
  void add_boundary_segment(int u, int v);

  /// Euler characteristic and loops of every component, sorted.
  std::vector<ComponentTopology> components();

 private:
  struct Tally {
    int polygons = 0, sides = 0, boundary_segments = 0;
  };
  void grow();

  std::vector<std::pair<std::uint32_t, int>> table_;  // open addressing; vertex -1 is free
  UnionFind surface_, boundary_;
  std::vector<Tally> tally_;  // of what was booked on each vertex
  std::vector<char> on_boundary_;
};

}  // namespace tensortopo::test
