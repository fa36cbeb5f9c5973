// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::detail {

/// Takes components of less than `least` as zero, and then tensors whose deviator's norm is less as
/// isotropic.
/// @return how many tensors have changed
std::size_t take_as_zero(TetMesh& mesh, double least);

/// A note about vertices whose deviator is not zero, but less than 1e-9 of a neighbour's: mostly it
/// is rounding, and the mode has all its values next to such a vertex. Empty if there are none.
std::string note_of_nearly_isotropic(const TetMesh& mesh);

/// The first vertex with a component that is no finite number, and how many there are; of vertices
/// of tetrahedra. Those of no tetrahedron become zero.
struct NotFinite {
  std::size_t vertex = 0, count = 0;
};
NotFinite find_not_finite(TetMesh& mesh);

}  // namespace tensortopo::detail
