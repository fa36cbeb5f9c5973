// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "extract/patch/patch.hpp"

namespace tensortopo {

/// The edges of boundary loops, in their direction.
class BoundaryEdges {
 public:
  explicit BoundaryEdges(std::span<const std::vector<BoundaryVertex>> boundaries);

  bool contains(std::int32_t from, std::int32_t to) const;
  /// In either direction.
  bool joins(std::int32_t a, std::int32_t b) const { return contains(a, b) || contains(b, a); }

 private:
  std::vector<std::uint64_t> edges_;  ///< ascending
};

/// Gives triangles, which all run one way, the direction that their boundary loops have, and checks
/// them.
/// @return false if they have both directions or none, or are not the planned sheets
bool direct_as_proved(std::vector<std::array<std::int32_t, 3>>& triangles,
                      std::span<const std::vector<BoundaryVertex>> boundaries,
                      const Sheets& sheets);

/// Whether triangles are, as a complex, the sheets that were proved: every inner edge has two
/// triangles of opposite direction, the edges with one are exactly the boundary loops in their
/// direction, and components, loops and Euler characteristics are the proved. Beside the boundary
/// loops, no edge joins two boundary loop vertices on one face: the neighbour across it might have
/// the same.
bool are_proved_sheets(std::span<const std::array<std::int32_t, 3>> triangles,
                       std::span<const std::vector<BoundaryVertex>> boundaries,
                       const Sheets& sheets);

/// Takes away the inner vertices from the first on that no triangle has.
/// @param triangles  those before this one have none of these vertices
template <class Scalar>
void drop_unused_inner(Patch<Scalar>& meshed, std::size_t first_inner = 0,
                       std::size_t first_triangle = 0);

}  // namespace tensortopo
