// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// What the arithmetic alone of some surfaces takes on one thread: the kernels that most simplices
/// pass, on arrays that are there already, with nothing found out that has to be kept.
struct Arithmetic {
  std::size_t crossed = 0;  ///< tetrahedra with vertices on both sides of a level
  double edges = 0;         ///< seconds: a crossing of each edge with ends on both sides
  double faces = 0;         ///< seconds: a proof for each face with vertices on both sides
  double tets = 0;          ///< seconds: a proof for each tetrahedron with vertices on both sides
};

/// Of all these levels together; a field's vanishing tensors are on no side.
Arithmetic measure_arithmetic(const TetMesh& mesh, std::span<const ModeValue> modes);

}  // namespace tensortopo
