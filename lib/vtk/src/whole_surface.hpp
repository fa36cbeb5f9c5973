// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "ranks.hpp"
#include "tensor_grid.hpp"
#include "tensortopo/modes/mode_extractor.hpp"
#include "whole_mesh.hpp"

namespace tensortopo::filters {

/// What is counted of the whole surface of one mode.
struct WholeSurface {
  double mode = 0;                        ///< of the surface
  std::int64_t components = 0;            ///< connected ones
  std::int64_t euler_characteristic = 0;  ///< of all
  std::int64_t boundary_loops = 0;        ///< of all
  std::int64_t vertices = 0;              ///< of all
  std::int64_t triangles = 0;             ///< of all
};

/// Of a surface that was extracted in one process.
std::vector<WholeSurface> counted(const ModeSurfaces& made);

/// Gives the triangles of owned tetrahedra the components that they have in the whole surface, as
/// if one process had extracted it. All ranks call it, and it throws std::exception on all or none.
/// @param made  extracted from the rank's grid; without parts, if it has no cells
std::vector<WholeSurface> number_components(ModeSurfaces& made, const TensorGrid& grid,
                                            const Ranks& ranks, const WholeMesh& whole);

}  // namespace tensortopo::filters
