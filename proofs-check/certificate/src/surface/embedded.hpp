// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
// Whether triangles cut each other.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace certificate {

/// What keeps triangles from being embedded: the first two in conflict (or one without area, twice).
struct Conflict {
  std::size_t first = 0, second = 0;
};
struct EmbeddingResult {
  bool decided = false;  ///< false: more pairs of boxes meet than the budget allows
  std::optional<Conflict> conflict;
};

/// Are triangles with these corners embedded: has each an area, and do any two of them meet only in
/// the vertices and edges that they share? Exact for the points' doubles: signs of determinants come
/// from doubles with a running error bound, else from rational numbers. All pairs whose boxes meet
/// are compared, whatever tetrahedra they belong to.
EmbeddingResult find_conflict(const std::vector<std::array<double, 3>>& points,
                              std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace certificate
