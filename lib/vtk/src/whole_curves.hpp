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

/// What is counted of the whole degenerate curves of one kind.
struct WholeCurves {
  double mode = 0;                     ///< 1 or -1
  std::int64_t components = 0;         ///< connected ones
  std::int64_t closed_components = 0;  ///< those without an end
  std::int64_t vertices = 0;           ///< of all
  std::int64_t lines = 0;              ///< of all
};

/// Of curves that were extracted in one process.
std::vector<WholeCurves> counted(const DegenerateCurves& made);

/// Gives the lines of owned tetrahedra the components that they have in the whole curves, as if one
/// process had extracted them. All ranks call it, and it throws std::exception on all or none.
/// @param made  extracted from the rank's grid; without parts, if it has no cells
std::vector<WholeCurves> number_components(DegenerateCurves& made, const TensorGrid& grid,
                                           const Ranks& ranks, const WholeMesh& whole);

}  // namespace tensortopo::filters
