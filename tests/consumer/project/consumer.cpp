// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "tensortopo/extract/extract_mode_surface.hpp"

/// One tetrahedron whose vertices have modes of about 1, 0, -1 and 1: the surface of mode 1/2
/// crosses it.
int main() {
  tensortopo::TetMesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  // xx, yy, zz, xy, yz, xz
  mesh.tensors = {{2, -1, -1, 0, 0, 0}, {1, 0, -1, 0.25, 0, 0}, {1, 1, -2, 0, 0.125, 0},
                  {3, -1, -1, 0, 0, 0.25}};
  mesh.tets = {{0, 1, 2, 3}};
  mesh.cell_ids = {0};

  const auto level = tensortopo::ModeValue::parse("1/2");
  const auto extraction = tensortopo::extract_mode_surface<double>(mesh, level);
  std::printf("%zu triangles\n", extraction.surface.triangles.size());
  return extraction.surface.triangles.empty() ? 1 : 0;
}
