// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include "tensortopo/field/cell_critical_points.hpp"

#include <cstddef>
#include <span>

#include "tensortopo/field/characteristic_tensor.hpp"

namespace tensortopo {
namespace {

void append(std::vector<CriticalPoint>& all, std::vector<CriticalPoint> some) {
  for (CriticalPoint& point : some) all.push_back(std::move(point));
}

}  // namespace

CellCriticalPoints cell_critical_points(const std::array<SymmetricTensor<double>, 4>& t) {
  CellCriticalPoints points;
  auto& [at_vertices, on_edges, on_faces, inside] = points.of_dimension;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::array others{t[(i + 1) % 4], t[(i + 2) % 4], t[(i + 3) % 4]};
    at_vertices.push_back(critical_vertex(t[i], others));
    append(on_faces, critical_points_on_face(others, std::array{t[i]}));
    for (std::size_t j = i + 1; j < 4; ++j) {
      std::array<SymmetricTensor<double>, 2> around;
      for (std::size_t k = 0, n = 0; k < 4; ++k)
        if (k != i && k != j) around[n++] = t[k];
      append(on_edges, critical_points_on_edge({t[i], t[j]}, around));
    }
  }
  inside = critical_points_in_tet(t);
  points.are_independent = exact_rank(std::span<const SymmetricTensor<double>>(t)) == 4;
  return points;
}

}  // namespace tensortopo
