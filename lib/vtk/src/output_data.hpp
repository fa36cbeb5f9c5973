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
#include "whole_curves.hpp"
#include "whole_surface.hpp"

namespace tensortopo::filters {

/// What a filter's text says; nothing if it is empty. Throws std::invalid_argument.
inline std::optional<Uncertainty> uncertainty_of(const std::string& text) {
  if (text.empty()) return std::nullopt;
  return parse_uncertainty(text);
}

/// Triangles of other pieces' tetrahedra are left out, with the vertices that only they use.
/// @param more  other cell arrays
void fill(vtkPolyData* output, const SurfaceMesh& surface, const TensorGrid& grid,
          const std::vector<CellArray>& more);
/// Field arrays, one number for each mode: `surface_mode`, `components`, `euler_characteristic` and
/// `boundary_loops`.
void fill(vtkPolyData* output, const std::vector<WholeSurface>& surfaces);
/// Field arrays, one number for each kind: `curve_mode`, `components` and `closed_components`.
void fill(vtkPolyData* output, const std::vector<WholeCurves>& curves);
/// Lines, as triangles.
void fill(vtkPolyData* output, const CurveMesh& curves, const TensorGrid& grid,
          const std::vector<CellArray>& more);
/// The cells that are left out, with the arrays `tet`, `mode` and `reason`.
void fill(vtkUnstructuredGrid* output, const std::vector<LeftOut>& cells, const TensorGrid& grid);

}  // namespace tensortopo::filters
