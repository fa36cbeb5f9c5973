// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// The triangles of vtkContourGrid for the modes at the vertices (0 where there is none): what one
/// gets without knowing that the mode is not linear. Only `points` and `triangles` are filled.
SurfaceMesh linear_contour(const TetMesh& mesh, const ModeValue& mode);

}  // namespace tensortopo
