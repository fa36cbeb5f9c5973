// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "refinement.hpp"
#include "union_find.hpp"

namespace certificate {

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
