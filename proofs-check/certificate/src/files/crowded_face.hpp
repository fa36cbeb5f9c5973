// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace certificate {

/// A face of three tetrahedra or more, if there is one: the first by its points in ascending order.
/// A mesh with one is no domain, as the inside of the third is nobody's neighbour.
/// @param tets  of points below `points`, ascending
std::optional<std::array<std::uint32_t, 3>> crowded_face(
    const std::vector<std::array<std::uint32_t, 4>>& tets, std::size_t points);

}  // namespace certificate
