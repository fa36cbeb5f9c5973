// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "tensortopo/extract/tet_sheets.hpp"

namespace tensortopo {

/// Whether triangles are, as a complex, the sheets that were proved: every inner edge has two
/// triangles of opposite direction, the edges with one are exactly the rims in their direction,
/// and components, loops and Euler characteristics are the plan's. Beside the rims, no edge joins
/// two rim vertices on one face: the neighbour across it might have the same.
bool are_planned_sheets(std::span<const std::array<std::int32_t, 3>> triangles,
                        std::span<const std::vector<RimVertex>> rims,
                        std::span<const SheetTopology> sheets);

}  // namespace tensortopo
