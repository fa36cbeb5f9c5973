// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "random_fields.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::test {

/// A mesh with its vertices in another order, its tetrahedra too, and the corners of each
/// tetrahedron permuted evenly.
struct RenumberedMesh {
  TetMesh mesh;
  std::vector<TetMesh::Index> vertices;  ///< of each vertex its number in the mesh given
  std::vector<TetMesh::Index> tets;      ///< of each tetrahedron the same
};

RenumberedMesh renumbered_mesh(const TetMesh& mesh, Random& random);

}  // namespace tensortopo::test
