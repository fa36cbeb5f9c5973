// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "support/fields/random_fields.hpp"

namespace tensortopo::test {

/// A field on a cube of so many cubes in each direction: of independent or smooth tensors, of few
/// bits, or with isotropic vertices.
/// @param every  in fields with isotropic vertices, about one in so many is one
inline TetMesh field_of_any_kind(Random& random, int cubes, int every = 20) {
  TetMesh mesh = cube_mesh(cubes);
  const auto seed = static_cast<std::uint64_t>(random.integer(0, 1 << 30));
  const int kind = random.integer(0, 3);
  if (kind == 0)
    fill_with_normal_tensors(mesh, seed);
  else
    fill_with_smooth_tensors(mesh, seed);
  if (kind == 2)
    for (auto& t : mesh.tensors) t = rounded(t, 1);
  if (kind == 3)
    for (auto& t : mesh.tensors)
      if (random.integer(0, every - 1) == 0) t = {2, 2, 2, 0, 0, 0};
  return mesh;
}

}  // namespace tensortopo::test
