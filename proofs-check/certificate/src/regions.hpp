// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "refinement.hpp"
#include "union_find.hpp"

namespace certificate {

/// The sign of the turn from a to b to c, of points by their three weights (or more: the first).
template <class A, class B, class C>
int side_of(const A& a, const B& b, const C& c) {
  return sgn(mpz_class(a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
                       a[2] * (b[0] * c[1] - b[1] * c[0])));
}

/// The regions into which the level cuts a face, as its refinement shows
/// them. A closed curve is told by the two regions at its sides: all curves together
/// cut the face like the edges of a tree.
class FaceRegions {
 public:
  /// @pre the refinement is of a face
  explicit FaceRegions(const Refinement& refinement);

  /// The region of a point given by its weights at the three roots, and its side.
  std::optional<std::size_t> find(const std::array<mpz_class, 3>& weights, bool above);
  std::size_t find(Refinement::Id point) { return regions_.find(point); }

 private:
  const Refinement& refinement_;
  UnionFind regions_;
};

}  // namespace certificate
