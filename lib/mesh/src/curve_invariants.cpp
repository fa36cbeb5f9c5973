// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "tensortopo/mesh/curve_mesh.hpp"
#include "tensortopo/scalar/elementary.hpp"

namespace tensortopo {

CurveInvariants curve_invariants(const CurveMesh& curves) {
  const std::size_t count = curves.points.size();
  std::vector<std::size_t> leader(count);
  std::iota(leader.begin(), leader.end(), std::size_t{0});
  const auto find = [&](std::size_t v) {
    while (leader[v] != v) v = leader[v] = leader[leader[v]];
    return v;
  };
  std::vector<std::size_t> degree(count, 0);
  CurveInvariants result;
  for (const auto& line : curves.lines)
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      if (std::min(line[i], line[i + 1]) < 0 ||
          static_cast<std::size_t>(std::max(line[i], line[i + 1])) >= count)
        throw std::invalid_argument("curve_invariants: a line names a point that does not exist");
      const auto u = static_cast<std::size_t>(line[i]), v = static_cast<std::size_t>(line[i + 1]);
      const auto d = curves.points[v] - curves.points[u];
      result.length += elementary::hypot(d.x, d.y, d.z);
      ++degree[u], ++degree[v];
      leader[find(u)] = find(v);
    }
  std::vector<char> has_end(count, 0);
  for (std::size_t v = 0; v < count; ++v)
    if (degree[v] == 1) has_end[find(v)] = 1;
  for (std::size_t v = 0; v < count; ++v) {
    if (degree[v] == 0) continue;
    ++result.vertices;
    if (find(v) != v) continue;
    ++result.components;
    if (!has_end[v]) ++result.closed_components;
  }
  return result;
}

}  // namespace tensortopo
