// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "extract/patch/quality/split_triangles.hpp"

#include <algorithm>

namespace tensortopo {

std::vector<std::array<std::size_t, 3>> split_triangles(
    const std::vector<std::array<std::size_t, 3>>& triangles,
    const std::map<UndirectedEdge, std::size_t>& middle) {
  std::vector<std::array<std::size_t, 3>> result;
  for (const auto& t : triangles) {
    std::array<std::size_t, 3> m{};
    std::array<bool, 3> has{};
    int count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto found = middle.find(std::minmax(t[i], t[(i + 1) % 3]));
      has[i] = found != middle.end();
      if (has[i]) m[i] = found->second, ++count;
    }
    // Turn it so that the split sides come first.
    std::size_t turn = 0;
    if (count == 1)
      while (!has[turn]) ++turn;
    else if (count == 2)
      while (!(has[turn] && has[(turn + 1) % 3])) ++turn;
    const auto a = t[turn], b = t[(turn + 1) % 3], c = t[(turn + 2) % 3];
    const auto ab = m[turn], bc = m[(turn + 1) % 3], ca = m[(turn + 2) % 3];
    switch (count) {
      case 0:
        result.push_back(t);
        break;
      case 1:
        result.insert(result.end(), {{a, ab, c}, {ab, b, c}});
        break;
      case 2:
        result.insert(result.end(), {{ab, b, bc}, {a, ab, bc}, {a, bc, c}});
        break;
      default:
        result.insert(result.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
  }
  return result;
}

}  // namespace tensortopo
