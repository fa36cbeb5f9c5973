// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// The faces that belong to one tetrahedron only, turned outwards. Points at one place count as one:
/// where nodes are duplicated there is no boundary.
vtkSmartPointer<vtkPolyData> domain_boundary(const TetMesh& mesh);

}  // namespace tensortopo
