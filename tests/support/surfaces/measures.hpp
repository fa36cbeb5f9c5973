// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>

#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::test {

inline double area(const SurfaceMesh& surface) {
  double sum = 0;
  for (const auto& t : surface.triangles) {
    const auto at = [&](std::size_t i) { return surface.points[static_cast<std::size_t>(t[i])]; };
    const auto n = cross(at(1) - at(0), at(2) - at(0));
    sum += std::sqrt(dot(n, n)) / 2;
  }
  return sum;
}

inline double volume(const TetMesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.tets) {
    const auto at = [&](std::size_t i) { return mesh.points[static_cast<std::size_t>(t[i])]; };
    sum += dot(at(1) - at(0), cross(at(2) - at(0), at(3) - at(0))) / 6;
  }
  return sum;
}

}  // namespace tensortopo::test
