// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "extract/patch/patch.hpp"

namespace tensortopo {

/// Triangles between the boundary loops of a sheet alone, joined by bridges and cut, for sheets
/// that no other way can spread out: two that nearly touch along a line, tubes too thin for the
/// leaves of a proof. No vertex lies inside, so the triangles follow the level no better than
/// chords of its boundary loops.
/// @return false if the sheet has handles, or if no bridges or no cut are found: so if all its
/// boundary loops
///         are on one face
template <class Scalar>
bool fill_loops(const CellTopology<Scalar>& proved, const SheetTopology& sheet,
                const FaceArcVertices& vertices, Patch<Scalar>& out);

/// Like `fill_loops`, with a collar along each boundary loop: for each of its vertices one next to
/// it inside the tetrahedron, on the level. Between these no diagonal can lie in a face, so that
/// cuts are found where most of the boundary loops is on one face: half tubes along a plane of
/// symmetry, tubes that come and go through one face.
/// @return false if the sheet has handles, or if a vertex has none next to it
template <class Scalar>
bool fill_with_collars(const TetWithCurves<Scalar>& tet, const CellTopology<Scalar>& proved,
                       const SheetTopology& sheet, const FaceArcVertices& vertices,
                       const Level<Scalar>& level, Patch<Scalar>& out);

}  // namespace tensortopo
