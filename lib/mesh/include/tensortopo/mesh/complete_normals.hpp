// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/mesh/surface_mesh.hpp"

namespace tensortopo {

/// Gives each vertex whose normal is zero (gradients cancel there, or rounding hides them) the mean
/// of those of the triangles around, by their areas; and where these have no area either (a sheet
/// smaller than coordinates tell), the normal of a vertex next to it. It stays zero only if that is
/// so of its whole component.
void complete_normals(SurfaceMesh& surface);

}  // namespace tensortopo
