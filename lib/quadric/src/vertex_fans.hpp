// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/mesh/surface_mesh.hpp"

namespace tensortopo {

/// Where a surface is cut in two around a vertex, by tetrahedra left out, gives each fan of
/// triangles but the first a vertex of its own, after all others.
/// @pre oriented; each edge has at most two triangles
void separate_fans(SurfaceMesh& surface);

}  // namespace tensortopo
