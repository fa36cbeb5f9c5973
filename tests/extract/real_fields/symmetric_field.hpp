// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::test {

/// A field made symmetric, bit by bit.
struct SymmetricField {
  TetMesh mesh;
  std::vector<TetMesh::Index> axis;  ///< vertices on the axis of symmetry, ascending in z
};

/// The field with each tensor replaced by the mean over the images of its vertex under the
/// symmetries of a square prism with axis along z, on a lattice with as many vertices in x as in y
/// and an odd number of them. Images agree exactly, and what symmetry makes zero is zero: on the
/// mirrors the shear across them, on the axis all shear, where xx = yy besides. So the axis is
/// degenerate all along. Throws std::invalid_argument if the vertices are no such lattice.
SymmetricField made_symmetric(TetMesh mesh);

}  // namespace tensortopo::test
