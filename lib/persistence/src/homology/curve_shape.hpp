// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "homology/mesh_boundary.hpp"
#include "tensortopo/extract/extract_degenerate_curves.hpp"

namespace tensortopo::persistence {

/// What a component of curves is, up to homotopy, together with the boundary of the mesh.
struct CurveShape {
  long loops = 0;  ///< its first Betti number
  /// The boundary surface of each place at which it meets the boundary: a point, or a piece that
  /// runs in it.
  std::vector<std::size_t> contacts;
};

/// The shapes of all components of curves.
struct CurveShapes {
  std::vector<CurveShape> shapes;  ///< one for each component
  /// Not so if a line without vertices inside may run in the boundary, or bulge from it.
  bool are_known = true;
};

CurveShapes curve_shapes(const CurveExtraction& extraction, const MeshBoundary& boundary);

}  // namespace tensortopo::persistence
