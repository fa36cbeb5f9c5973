// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "refinement.hpp"
#include "union_find.hpp"

namespace certificate {

/// The regions into which the level cuts a face, as a refinement of it or of a tetrahedron
/// around shows them. A closed curve is told by the two regions at its sides: all curves together
/// cut the face like the edges of a tree.
class FaceRegions {
 public:
  /// @param face the bits of three roots, ascending
  FaceRegions(const Refinement& refinement, unsigned face);

  /// The region of a point given by its weights at the three roots, and its side.
  std::optional<std::size_t> find(const std::array<mpz_class, 3>& weights, bool above);
  std::size_t find(Refinement::Id point) { return regions_.find(point); }

 private:
  const Refinement& refinement_;
  unsigned face_;
  std::vector<std::array<Refinement::Id, 3>> tiles_;
  UnionFind regions_;
};

/// The weights of a point at the roots of the face, in their order.
std::array<mpz_class, 3> weights_in(const Refinement::Point& point, unsigned face);

}  // namespace certificate
