// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/scalar/power_of_two.hpp"

namespace tensortopo {

/// A property of the linear field of each triangle's tetrahedron, at each corner of the triangle.
/// @param property of the corners' points and tensors of a tetrahedron, and a point; the same for
/// multiples of the tensors: it gets them times a power of two that takes the largest near to 1
template <class Property>
auto at_each_corner(const SurfaceMesh& surface, const TetMesh& mesh, const Property& property) {
  using Points = std::array<Vector3<double>, 4>;
  using Tensors = std::array<SymmetricTensor<double>, 4>;
  const auto at = [](auto i) { return static_cast<std::size_t>(i); };
  std::vector<decltype(property(Points{}, Tensors{}, Vector3<double>{}))> corners(
      3 * surface.triangles.size());
  tbb::parallel_for(std::size_t{0}, surface.triangles.size(), [&](std::size_t i) {
    const auto& tet = mesh.tets[at(surface.tet[i])];
    Points points;
    Tensors tensors;
    double largest = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      points[k] = mesh.points[at(tet[k])];
      tensors[k] = mesh.tensors[at(tet[k])];
      largest = std::max(largest, max_norm(tensors[k]));
    }
    for (auto& tensor : tensors) tensor = inverse_power(largest) * tensor;
    for (std::size_t k = 0; k < 3; ++k)
      corners[3 * i + k] = property(points, tensors, surface.points[at(surface.triangles[i][k])]);
  });
  return corners;
}

}  // namespace tensortopo
