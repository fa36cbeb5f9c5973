// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "files/crowded_face.hpp"

#include <algorithm>
#include <cstddef>

#include "run/parallel.hpp"

namespace certificate {

std::optional<std::array<std::uint32_t, 3>> crowded_face(
    const std::vector<std::array<std::uint32_t, 4>>& tets, std::size_t points) {
  using Rest = std::array<std::uint32_t, 2>;
  // Faces by their first point, as rows: three of a tetrahedron have its first one, one its second.
  std::vector<std::size_t> first(points + 1, 0);
  for (const auto& tet : tets) first[tet[0] + 1] += 3, ++first[tet[1] + 1];
  for (std::size_t p = 0; p < points; ++p) first[p + 1] += first[p];
  std::vector<Rest> rests(4 * tets.size());
  std::vector<std::size_t> next(first.begin(), first.end() - 1);
  for (const auto& [a, b, c, d] : tets) {
    for (const Rest& rest : {Rest{b, c}, Rest{b, d}, Rest{c, d}}) rests[next[a]++] = rest;
    rests[next[b]++] = {c, d};
  }
  std::vector<std::uint8_t> is_crowded(points, 0);
  parallel_for<256>(points, [&](std::size_t p) {
    const auto begin = rests.begin() + static_cast<std::ptrdiff_t>(first[p]),
               end = rests.begin() + static_cast<std::ptrdiff_t>(first[p + 1]);
    std::sort(begin, end);
    for (auto at = begin; end - at > 2; ++at) is_crowded[p] |= at[0] == at[2];
  });
  const auto found = std::find(is_crowded.begin(), is_crowded.end(), 1);
  if (found == is_crowded.end()) return std::nullopt;
  const auto p = static_cast<std::size_t>(found - is_crowded.begin());
  std::size_t at = first[p];
  while (rests[at] != rests[at + 2]) ++at;
  return std::array<std::uint32_t, 3>{static_cast<std::uint32_t>(p), rests[at][0], rests[at][1]};
}

}  // namespace certificate
