// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/quadric/quadric_form.hpp"

namespace tensortopo {

/// Whether the level touches an edge, a face or the inside of a tetrahedron, exactly: its form on
/// one of these has a critical point there at which it vanishes. Then the level's topology changes
/// at this value, and no proof that the form increases along a direction can hold there.
///
/// Statement (ours; Gordan's theorem). The matrix A of the form on a simplex has a direction d with
/// A d > 0, so that the form increases along d everywhere, if and only if A b = 0 for no b >= 0 but
/// 0. Such a b is a critical point in the face of its positive entries.
/// @return "critical_value_on_edge", "..._on_face" or "..._in_cell"; empty if it does not
/// @param vertices  of a tetrahedron that the level meets
std::string critical_reason(const TetMesh& mesh, const QuadraticLevel& level,
                            const std::array<TetMesh::Index, 4>& vertices);

}  // namespace tensortopo
