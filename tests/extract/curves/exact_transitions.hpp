// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo::test {

/// In how many points inside a mesh of one tetrahedron, whose linear field has a rational
/// degenerate tensor, the tangent of the degenerate curves is across the dominant eigenvector,
/// exactly.
///
/// The separation of wedges and trisectors is the determinant of what the derivatives along the
/// plane across e have across e. The kernel of all derivatives is the tangent, so it vanishes
/// exactly there. The conic is parametrized by lines through its rational point, and Tarski's
/// queries count the zeros at which all four weights have one sign: no interval, no separation, no
/// subdivision.
/// @param known  e of the rational degenerate tensor e e^T, up to its trace
/// @return nothing in special positions
std::optional<int> exact_transitions(const TetMesh& mesh, const Vector3<double>& known);

}  // namespace tensortopo::test
