// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// A mesh in its canonical order, which depends on where its points are and not on their numbers.
///
/// Vertices are in the lexicographic order of x, y, z (-0 is 0). The corners of a tetrahedron are
/// in the order of the vertices, the last two exchanged where that keeps its orientation. The
/// tetrahedra are in the lexicographic order of their sorted corners. What is computed in this
/// order is the same, bit for bit, however vertices and tetrahedra are numbered and corners
/// rotated.
///
/// Vertices at one place (along a crack, or where parts of a mesh are not joined) are ordered by
/// the bits of their tensors, and if these are equal too, by their numbers in the mesh given. No
/// simplex of a valid mesh has two of them.
struct CanonicalMesh {
  using Index = TetMesh::Index;  ///< of a vertex or a tetrahedron

  TetMesh mesh;                 ///< without `cell_ids`
  std::vector<Index> vertices;  ///< of each of its vertices the number in the mesh given
  std::vector<Index> tets;      ///< of each of its tetrahedra the position in the mesh given
};

/// @pre the mesh is valid (see `validate`)
/// The result does not depend on the number of threads.
CanonicalMesh canonical_mesh(const TetMesh& mesh);

/// The mesh in its canonical order, each tetrahedron with its id.
/// @pre the mesh is valid, and has `cell_ids` or none
TetMesh in_canonical_order(const TetMesh& mesh);

/// The inverse of a permutation: result[permutation[i]] = i.
std::vector<TetMesh::Index> inverse_permutation(const std::vector<TetMesh::Index>& permutation);

}  // namespace tensortopo
