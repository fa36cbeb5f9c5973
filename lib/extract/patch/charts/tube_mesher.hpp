// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "extract/patch/charts/manifold_mesher.hpp"

namespace tensortopo {

/// Triangles for the tubes of a proved topology, as strips between rings around the degenerate
/// curve.
///
/// A ring is made of the tensors whose medium eigenvector is orthogonal to one dominant eigenvector
/// of the curve; that vector turns by half a turn around the tube, and says which vertices of two
/// rings are neighbours. On the sphere of medium eigenvectors the two ends of a short thin tube
/// are nearly one curve; here they need not be separated.
///
/// @return false if a boundary loop does not run steadily around its tube, or no ring lies inside
/// that must
template <class Scalar>
bool mesh_tubes(const TetManifold& manifold, const TetWithCurves<Scalar>& tet,
                const CellTopology<Scalar>& proved, const FaceArcVertices& vertices,
                const Level<Scalar>& level, const Sampling& sampling, Patch<Scalar>& out);

/// Triangles for one annulus of a proved topology that is a tube around an arc of the degenerate
/// curve, in the same way, added to those there are. Nothing is checked.
///
/// @return false as above, or if no arc is known to join its loops
template <class Scalar>
bool mesh_tube(const TetManifold& manifold, const TetWithCurves<Scalar>& tet,
               const CellTopology<Scalar>& proved, const SheetTopology& sheet,
               const FaceArcVertices& vertices, const Level<Scalar>& level,
               const Sampling& sampling, Patch<Scalar>& out);

}  // namespace tensortopo
