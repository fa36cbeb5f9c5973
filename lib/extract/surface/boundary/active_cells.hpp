// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "extract/surface/boundary/vertex_sides.hpp"

namespace tensortopo {

/// The tetrahedra that the level may meet, with their faces and edges.
struct ActiveCells {
  TetComplex complex;
  std::size_t screened_out = 0;   ///< tetrahedra proved empty
  std::size_t undefined = 0;      ///< isotropic at all four vertices
  std::size_t zero_vertices = 0;  ///< isotropic vertices of tetrahedra
};

template <class Scalar>
ActiveCells active_cells(const SurfaceInput<Scalar>& input, const VertexSides& sides);

}  // namespace tensortopo
