// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "tensortopo/mesh/surface_mesh.hpp"
#include "tensortopo/mesh/tet_mesh.hpp"
#include "tensortopo/tensor/mode_parameter.hpp"

namespace tensortopo {

/// VTK's contours of the modes at a mesh's vertices (0 where there is none): what one gets without
/// knowing that the mode is not linear. Construction is all that a benchmark does not time.
class VtkContours {
 public:
  VtkContours(const TetMesh& mesh, int threads);
  ~VtkContours();

  /// Triangles that vtkContourGrid makes for these values together.
  std::size_t contour_grid(std::span<const double> values);
  /// Triangles that vtkContour3DLinearGrid makes for these values together.
  std::size_t contour_3d_linear_grid(std::span<const double> values);

 private:
  struct Grid;
  std::unique_ptr<Grid> grid_;
};

enum class VtkFilter { contour_grid, contour_3d_linear_grid };

/// The triangles of one filter for one mode; only `points` and `triangles` are filled.
SurfaceMesh vtk_triangles(const TetMesh& mesh, const ModeValue& mode, VtkFilter filter);

/// The same with `points`, `triangles` (counter-clockwise seen from
/// the larger mode), `tet`, `component` and `mode` filled, the same whatever the number of threads.
SurfaceMesh vtk_contour(const TetMesh& mesh, const ModeValue& mode, VtkFilter filter);

}  // namespace tensortopo
