// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The level in an edge and in a face: of the mesh, or of a cell that is a part of a tetrahedron.
#pragma once

#include <compare>
#include <map>
#include <optional>

#include "refinement.hpp"

namespace certificate {

/// A point of the level on an edge between two roots: the how-manieth from the first.
struct Crossing {
  unsigned edge = 0;  ///< a bit for each of the two roots
  unsigned ordinal = 0;

  auto operator<=>(const Crossing&) const = default;
};

/// An edge of a refinement, as a point of the level on it.
using CrossedEdge = std::array<Refinement::Id, 2>;

/// The points of a refined simplex along the edges between its roots.
class RootEdges {
 public:
  explicit RootEdges(const Refinement& refinement);

  /// Those on one edge, from root to root.
  const std::vector<Refinement::Id>& along(unsigned edge) const { return along_.at(edge); }
  unsigned count(unsigned edge) const { return counts_.at(edge); }
  /// The crossing on an edge of the refinement; nothing if that lies on no edge between roots.
  std::optional<Crossing> at(const CrossedEdge& edge) const;

 private:
  std::map<std::uint64_t, Crossing> crossings_;
  std::map<unsigned, std::vector<Refinement::Id>> along_;
  std::map<unsigned, unsigned> counts_;
};

struct EdgeLevel {
  bool decided = false;
  Proof proof = Proof::open;  ///< of the edge as a whole
  unsigned crossings = 0;
};
EdgeLevel level_in_edge(const Level& level, const std::array<Corner, 2>& corners);

/// The curves in a face. An arc runs such that, seen from where the roots are counter-clockwise,
/// the larger modes are left of it.
struct FaceLevel {
  bool decided = false;
  std::vector<std::array<Crossing, 2>> arcs;
  std::vector<std::vector<CrossedEdge>> loops;  ///< of each closed curve the edges that it crosses
  std::shared_ptr<const Refinement> refinement;  ///< if there are closed curves
};
/// @param edges  of the corners 0 and 1, 0 and 2, 1 and 2
FaceLevel level_in_face(const Level& level, const std::array<Corner, 3>& corners,
                        const std::array<const EdgeLevel*, 3>& edges);

}  // namespace certificate
