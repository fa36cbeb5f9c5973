// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "simplex_maxima.hpp"

#include <algorithm>

#include "tensortopo/field/critical_points.hpp"
#include "tensortopo/field/exact_critical_points.hpp"

namespace tensortopo::persistence {

const std::vector<SimplexMaximum>& SimplexMaxima::along(const Simplex& simplex) {
  const auto [found, is_new] = maxima_.try_emplace(simplex);
  if (!is_new) return found->second;
  const auto tensor = [&](std::size_t i) { return mesh_.tensors[as_size(simplex[i])]; };
  // Inside a tetrahedron there is none.
  if (simplex[0] >= 0) return found->second;
  const bool is_edge = simplex[1] < 0;
  std::vector<CriticalPoint> points;
  if (is_edge) {
    const std::array edge{tensor(2), tensor(3)};
    points = critical_points_on_edge(edge, {});
    if (std::any_of(points.begin(), points.end(),
                    [](const CriticalPoint& p) { return p.gap_low == 0; }))
      points = exact_critical_points_on_edge(edge, {});
  } else {
    points = critical_points_on_face({tensor(1), tensor(2), tensor(3)}, {});
  }
  const int dimension = is_edge ? 1 : 2;
  for (const CriticalPoint& p : points) {
    if (p.is_certain && p.index != dimension) continue;
    SimplexMaximum maximum{{p.high, p.gap_low}, {}};
    std::copy_n(p.weights.begin(), dimension + 1, maximum.weights.end() - (dimension + 1));
    found->second.push_back(maximum);
  }
  return found->second;
}

std::array<SimplexMaxima::Simplex, 11> simplices_of(const TetMesh& mesh, TetMesh::Index tet) {
  std::array<SimplexMaxima::Simplex, 11> simplices;
  std::size_t n = 0;
  for (int used = 1; used < 16; ++used) {
    SimplexMaxima::Simplex simplex{-1, -1, -1, -1};
    int count = 0;
    for (std::size_t i = 0; i < 4; ++i)
      if ((used >> i & 1) != 0) simplex[i] = mesh.tets[as_size(tet)][i], ++count;
    if (count < 2) continue;
    std::sort(simplex.begin(), simplex.end());
    simplices[n++] = simplex;
  }
  return simplices;
}

}  // namespace tensortopo::persistence
