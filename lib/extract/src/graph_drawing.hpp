// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/extract/tet_sheets.hpp"

namespace tensortopo {

/// Triangles for all sheets of a tetrahedron in which the level is a graph (`TetPlan::direction`):
/// each line of the direction meets it at most once. Seen along these lines, parallel after a
/// projective map of the tetrahedron, the sheets are plane regions that the rims bound. They are
/// triangulated, with inner vertices put on the level along their lines until the eigenvectors turn
/// no more within a triangle than `sampling` says.
///
/// @return false if lines come together at a corner, the rims cross seen along them, or the
///         result's topology is not the plan's
template <class Scalar>
bool mesh_as_graph(const TetWithCurves<Scalar>& tet, const TetPlan<Scalar>& plan,
                   const FaceArcVertices& vertices, const Level<Scalar>& level,
                   const Sampling& sampling, TetTriangles<Scalar>& out);

}  // namespace tensortopo
