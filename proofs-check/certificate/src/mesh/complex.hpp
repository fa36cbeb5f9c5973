// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace certificate {

/// What keeps tetrahedra from being a complex in space beside each face: one that is flat, a face of
/// three or more, or of two on the same side of it. One defect in words, if there is any.
/// Exact for the points' doubles. Overlap of tetrahedra without a common face is not looked for.
/// @param tets  of `points`, each ascending
std::optional<std::string> defect_of(const std::vector<std::array<std::uint32_t, 4>>& tets,
                                     const std::vector<std::array<double, 3>>& points);

/// Points of tetrahedra at the place of another one: what meets there is torn.
std::size_t count_doubled(const std::vector<std::array<std::uint32_t, 4>>& tets,
                          const std::vector<std::array<double, 3>>& points);

}  // namespace certificate
