// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "extract/patch/patch.hpp"

namespace tensortopo {

/// Triangles for all sheets of a tetrahedron in which the level is a graph
/// (`CellTopology::direction`): each line of the direction meets it at most once. Seen along these
/// lines, parallel after a projective map of the tetrahedron, the sheets are plane regions that the
/// boundary loops bound. They are triangulated, with inner vertices put on the level along their
/// lines until the eigenvectors turn no more within a triangle than `sampling` says.
///
/// @return false if lines come together at a corner, the boundary loops cross seen along them, or
/// the
///         result's topology is not the proved
template <class Scalar>
bool mesh_as_graph(const TetWithCurves<Scalar>& tet, const CellTopology<Scalar>& proved,
                   const FaceArcVertices& vertices, const Level<Scalar>& level,
                   const Sampling& sampling, int defect_rounds, Patch<Scalar>& out);

}  // namespace tensortopo
