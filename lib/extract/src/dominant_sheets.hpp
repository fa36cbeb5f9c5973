// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/extract/manifold_sheets.hpp"

namespace tensortopo {

/// Triangles for all sheets of a tetrahedron, as `mesh_on_manifold`, in a `DominantChart`: for
/// sheets that the medium eigenvector alone does not spread out, as long thin tubes cut along by a
/// face, or what is beside a plane of symmetry.
///
/// @return false if the chart does not show them: rims cross in it, a step along a rim is
///         ambiguous, or the result's topology is not the plan's
template <class Scalar>
bool mesh_by_dominant(const TetManifold& manifold, const TetWithCurves<Scalar>& tet,
                      const TetPlan<Scalar>& plan, const FaceArcVertices& vertices,
                      const Level<Scalar>& level, const Sampling& sampling,
                      TetTriangles<Scalar>& out);

}  // namespace tensortopo
