// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/extract/manifold_sheets.hpp"

namespace tensortopo {

/// Triangles for the tubes of a plan, as strips between rings around the degenerate curve.
///
/// A ring is made of the tensors whose medium eigenvector is orthogonal to one dominant eigenvector
/// of the curve; that vector turns by half a turn around the tube, and says which vertices of two
/// rings are neighbours. On the sphere of medium eigenvectors the two ends of a short thin tube
/// are nearly one curve; here they need not be told apart.
///
/// @return false if a rim does not run steadily around its tube, or no ring lies inside that must
template <class Scalar>
bool mesh_tubes(const TetManifold& manifold, const TetWithCurves<Scalar>& tet,
                const TetPlan<Scalar>& plan, const FaceArcVertices& vertices,
                const Level<Scalar>& level, const Sampling& sampling, TetTriangles<Scalar>& out);

/// Triangles for one annulus of a plan that is a tube around an arc of the degenerate curve, in the
/// same way, added to those there are. Nothing is checked.
///
/// @return false as above, or if no arc is known to join its loops
template <class Scalar>
bool mesh_tube(const TetManifold& manifold, const TetWithCurves<Scalar>& tet,
               const TetPlan<Scalar>& plan, const SheetTopology& sheet,
               const FaceArcVertices& vertices, const Level<Scalar>& level,
               const Sampling& sampling, TetTriangles<Scalar>& out);

}  // namespace tensortopo
