// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "mesh_boundary.hpp"
#include "tensortopo/mesh/curve_mesh.hpp"

namespace tensortopo::persistence {

/// What a component of curves is, up to homotopy, together with the boundary of the mesh.
struct CurveShape {
  long loops = 0;  ///< its first Betti number
  /// The boundary surface of each place at which it meets the boundary: a point, or a piece that
  /// runs in it.
  std::vector<std::size_t> contacts;
};

/// One for each component.
std::vector<CurveShape> curve_shapes(const CurveMesh& curves, const MeshBoundary& boundary);

}  // namespace tensortopo::persistence
