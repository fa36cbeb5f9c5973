// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "tensortopo/extract/tet_sheets.hpp"

namespace tensortopo {

/// The edges of rims, in their direction.
class RimEdges {
 public:
  explicit RimEdges(std::span<const std::vector<RimVertex>> rims);

  bool contains(std::int32_t from, std::int32_t to) const;
  /// In either direction.
  bool joins(std::int32_t a, std::int32_t b) const { return contains(a, b) || contains(b, a); }

 private:
  std::vector<std::uint64_t> edges_;  ///< ascending
};

/// Gives triangles, which all run one way, the direction that their rims have, and checks them.
/// @return false if they have both directions or none, or are not the planned sheets
bool direct_as_planned(std::vector<std::array<std::int32_t, 3>>& triangles,
                       std::span<const std::vector<RimVertex>> rims,
                       std::span<const SheetTopology> sheets);

/// Whether triangles are, as a complex, the sheets that were proved: every inner edge has two
/// triangles of opposite direction, the edges with one are exactly the rims in their direction,
/// and components, loops and Euler characteristics are the plan's. Beside the rims, no edge joins
/// two rim vertices on one face: the neighbour across it might have the same.
bool are_planned_sheets(std::span<const std::array<std::int32_t, 3>> triangles,
                        std::span<const std::vector<RimVertex>> rims,
                        std::span<const SheetTopology> sheets);

}  // namespace tensortopo
