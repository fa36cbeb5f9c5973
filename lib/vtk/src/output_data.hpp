// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <vector>

#include "tensor_grid.hpp"
#include "tensortopo/mesh/cell_array.hpp"
#include "tensortopo/mesh/curve_mesh.hpp"
#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/modes/mode_extractor.hpp"

namespace tensortopo::filters {

/// Triangles of other pieces' tetrahedra are left out, with the vertices that only they use.
/// @param more  other cell arrays
void fill(vtkPolyData* output, const SurfaceMesh& surface, const TensorGrid& grid,
          const std::vector<CellArray>& more);
/// The same with lines.
void fill(vtkPolyData* output, const CurveMesh& curves, const TensorGrid& grid);
/// The cells that are left out, with the arrays `tet`, `mode` and `reason`.
void fill(vtkUnstructuredGrid* output, const std::vector<LeftOut>& cells, const TensorGrid& grid);

}  // namespace tensortopo::filters
