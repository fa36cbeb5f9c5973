// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/extract/tet_sheets.hpp"

namespace tensortopo {

/// Like `mesh_from_rims`, with a collar along each rim: for each of its vertices one next to it
/// inside the tetrahedron, on the level. Between these no diagonal can lie in a face, so that cuts
/// are found where most of the rims is on one face: half tubes along a plane of symmetry, tubes
/// that come and go through one face.
/// @return false if the sheet has handles, or if a vertex has none next to it
template <class Scalar>
bool mesh_with_collars(const TetWithCurves<Scalar>& tet, const TetPlan<Scalar>& plan,
                       const SheetTopology& sheet, const FaceArcVertices& vertices,
                       const Level<Scalar>& level, TetTriangles<Scalar>& out);

}  // namespace tensortopo
