// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <utility>
#include <vector>

#include "baselines/triangle_soup.hpp"

namespace tensortopo::baselines {

/// The triangles that separate the corners of a positively oriented tetrahedron which are above
/// from the others, their normals towards those above; `crossing(i, j)` is the place on the edge
/// from corner i to corner j.
template <class Crossing>
void march(const std::array<bool, 4>& above, SurfaceMesh::Index tet, const Crossing& crossing,
           std::vector<SoupTriangle>& out) {
  // Even permutations of the corners, one for each choice of those above (first) and below.
  const auto count = static_cast<int>(above[0]) + above[1] + above[2] + above[3];
  if (count == 0 || count == 4) return;
  if (count == 2) {
    constexpr std::array<std::array<std::size_t, 4>, 6> pairs{
        {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}}};
    for (const auto& [a, b, c, d] : pairs) {
      if (!above[a] || !above[b]) continue;
      const auto ac = crossing(a, c), ad = crossing(a, d), bc = crossing(b, c),
                 bd = crossing(b, d);
      out.push_back({{ac, bd, ad}, tet});
      out.push_back({{ac, bc, bd}, tet});
      return;
    }
  }
  const bool alone = count == 1;
  constexpr std::array<std::array<std::size_t, 4>, 4> apexes{
      {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 0, 1, 3}, {3, 0, 2, 1}}};
  for (const auto& [a, b, c, d] : apexes) {
    if (above[a] != alone) continue;
    auto first = crossing(a, b), second = crossing(a, c), third = crossing(a, d);
    // In these orders the corners b, c, d run counter-clockwise seen from outside, so the normal of
    // (ab, ac, ad) points away from a.
    if (alone) std::swap(second, third);
    out.push_back({{first, second, third}, tet});
    return;
  }
}

}  // namespace tensortopo::baselines
