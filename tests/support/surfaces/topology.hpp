// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <compare>
#include <ostream>
#include <vector>

namespace tensortopo::test {

/// Topological type of one connected oriented surface with boundary: these two numbers name it.
struct ComponentTopology {
  int euler = 0;  ///< Euler characteristic
  int loops = 0;  ///< boundary loops

  friend auto operator<=>(const ComponentTopology&, const ComponentTopology&) = default;
};

/// A disc, an annulus, and an annulus with one handle: the pieces met most often.
inline constexpr ComponentTopology disc{1, 1}, annulus{0, 2}, handled_annulus{-2, 2};

/// Topology of {mode = m} inside one tetrahedron.
struct LocalTopology {
  std::vector<ComponentTopology> components;  ///< sorted
  std::array<int, 6> edge_crossings{};        ///< on the edges 01, 02, 03, 12, 13, 23

  friend bool operator==(const LocalTopology&, const LocalTopology&) = default;

  /// Crossings on all six edges.
  int crossings() const {
    int sum = 0;
    for (const int c : edge_crossings) sum += c;
    return sum;
  }
};

/// Topology of {mode = m} inside one triangle.
struct FaceTopology {
  int open_arcs = 0;
  int closed_loops = 0;
  std::array<int, 3> edge_crossings{};  ///< on the edges 01, 02, 12

  friend bool operator==(const FaceTopology&, const FaceTopology&) = default;
};

inline std::ostream& operator<<(std::ostream& out, const ComponentTopology& c) {
  return out << "(chi " << c.euler << ", loops " << c.loops << ")";
}

inline std::ostream& operator<<(std::ostream& out, const LocalTopology& t) {
  out << t.components.size() << " components:";
  for (const auto& c : t.components) out << ' ' << c;
  out << "; edge crossings";
  for (const int c : t.edge_crossings) out << ' ' << c;
  return out;
}

inline std::ostream& operator<<(std::ostream& out, const FaceTopology& t) {
  out << t.open_arcs << " arcs, " << t.closed_loops << " loops; edge crossings";
  for (const int c : t.edge_crossings) out << ' ' << c;
  return out;
}

}  // namespace tensortopo::test
