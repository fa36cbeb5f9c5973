// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// The level around isotropic vertices: cones, and where they are joined.
#pragma once

#include "claims/compare_level.hpp"

namespace certificate {

/// A claimed cone with its sheets written like those of other tetrahedra: discs, each with one loop
/// through crossings, tips and faces, with null for the edge between two tips. Throws Wrong if it
/// names no crossings or no vertices of the level.
Json with_loops(const LevelCase& c, const CrossingVertices& vertices, const ConeTopology& cone,
                const Json& claim);

/// A sheet that ends at an edge between two tips.
struct Fold {
  const ConeTopology* cone = nullptr;
  std::size_t sheet = 0;
};

/// The tetrahedra with two tips around the edges between these.
class Folds {
 public:
  /// Throws Wrong if three of them have a face in common.
  explicit Folds(const LevelCase& c);

  /// The sheet at the other end of the stretch of larger modes beside one, to which that is
  /// joined; or the first tetrahedron that is not decided, there. If the stretch ends before, no
  /// cone; then `last` is the face that it came to.
  Fold beyond(const Fold& fold, std::array<Vertex, 3>& last) const;

 private:
  const LevelCase& c_;
  std::map<std::array<Vertex, 3>, std::vector<const ConeTopology*>> at_;  ///< by tips, base
};

}  // namespace certificate
