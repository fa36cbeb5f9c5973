// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "conformance/score.hpp"

namespace tensortopo {

/// Fills in holes, seams and non-manifold places. An edge with one triangle is no hole where the
/// level may end: on the domain's boundary, beside tetrahedra about which there is no truth, and in
/// isotropic faces.
void score_connectivity(const TetMesh& mesh, const Standard& standard, const GivenSurface& given,
                        double touch, SurfaceScore& score);

/// A crossing of a mesh edge by a component.
struct ComponentCrossing {
  SurfaceMesh::Index truth = -1, given = -1;  ///< components
};

/// Fills in crossings.
/// @return pairs of components that cross an edge at one place
std::vector<ComponentCrossing> score_crossings(
    const TetMesh& mesh, const Standard& standard, const GivenSurface& given,
    const std::vector<SurfaceMesh::Index>& truth_component,
    const std::vector<SurfaceMesh::Index>& given_component, double touch, SurfaceScore& score);

/// What counts as one place on a mesh edge of this length: `touch` of it, and what rounding the
/// coordinates may have moved.
double touch_distance(const TetMesh& mesh, const GivenSurface& given, double length, double touch);

}  // namespace tensortopo
