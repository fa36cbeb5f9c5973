// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "tensortopo/mesh/tet_mesh.hpp"

namespace tensortopo {

/// VTK's contours of the modes at a mesh's vertices. Construction is all that is not timed.
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

}  // namespace tensortopo
