// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/mesh/curve_mesh.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"

namespace tensortopo {

/// Adds a surface of the same tetrahedral mesh to another one, as vertices, triangles and
/// components of its own.
///
/// Laws      (1) what was there keeps its numbers; (2) the vertices, triangles and components of
///           `part` follow in their order; (3) appending to nothing gives `part`.
/// Caveat    `carrier_id` counts within one extraction; across surfaces, compare
///           `carrier_vertices`.
/// Requires  the same arrays filled in both, unless one is empty; else throws
///           std::invalid_argument. More than 2^31 - 1 vertices: std::length_error.
void append_surface(SurfaceMesh& surface, SurfaceMesh part);

/// Adds curves in the same tetrahedral mesh to other ones; the same laws hold, with lines for
/// triangles.
void append_curves(CurveMesh& curves, CurveMesh part);

}  // namespace tensortopo
