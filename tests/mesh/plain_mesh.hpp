// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <numeric>
#include <utility>
#include <vector>

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// A mesh with zero tensors and cell ids 100, 101, ...
inline TetMesh plain_mesh(std::vector<Vector3<double>> points,
                          std::vector<std::array<int, 4>> tets) {
  TetMesh mesh;
  mesh.points = std::move(points);
  mesh.tensors.resize(mesh.points.size());
  mesh.tets = std::move(tets);
  mesh.cell_ids.resize(mesh.tets.size());
  std::iota(mesh.cell_ids.begin(), mesh.cell_ids.end(), 100);
  return mesh;
}

}  // namespace tensortopo
