// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "conformance/given_surface.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"

namespace tensortopo {

/// Gives each fan of triangles a vertex of its own where the true surface has several vertices at
/// one place, as around an isotropic vertex of the mesh: there merging points by place
/// pinches what is no pinch. Places are compared as float32 if the given ones may be rounded to it.
void split_fans(GivenSurface& given, const SurfaceMesh& truth);

}  // namespace tensortopo
