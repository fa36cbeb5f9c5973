// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "support/fields/random_fields.hpp"

namespace tensortopo::test {

/// Across e_z a symmetric tensor that vanishes on two linked circles, and small random tensors.
inline TetMesh linked_mesh(std::uint64_t seed) {
  constexpr int kCells = 14;
  TetMesh mesh = cube_mesh(kCells);
  Random random(seed);
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    auto& p = mesh.points[v];
    p = (6.0 / kCells) * p - Vector3<double>{3, 3, 3};
    const double square = dot(p, p) - 1;
    const double re = p.x * p.x - p.y * p.y + p.z * p.z - square * square / 4;
    const double im = 2 * p.x * p.y + p.z * square;
    mesh.tensors[v] =
        SymmetricTensor<double>{re - 50, -re - 50, 100, im, 0, 0} + 0.02 * random.tensor();
  }
  return mesh;
}

}  // namespace tensortopo::test
