// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "extract/subdivision/refinement.hpp"
#include "tensortopo/mesh/union_find.hpp"

namespace tensortopo {

/// The connected parts of a triangle in which the mode lies beyond a level: above a positive one,
/// below a negative one.
///
/// In a simple cell these places are connected and hold a corner, and so is a side with both ends
/// among them: the parts are those of the graph of such corners and sides.
template <class Scalar>
class FaceParts {
 public:
  using Weights = std::array<double, 3>;

  /// @return false if the cells cannot be proved simple, or their corners are not exact in doubles
  bool build(const LevelSimplex<Scalar, 3>& triangle, const Level<Scalar>& level);

  /// The part that a place in the superlevel set belongs to. Decided exactly.
  std::optional<std::uint32_t> part_of(const Weights& place);

 private:
  Refinement<Scalar, 3> refinement_;
  bool superlevel_is_above_ = true;
  UnionFind parts_;  // of vertices
};

}  // namespace tensortopo
