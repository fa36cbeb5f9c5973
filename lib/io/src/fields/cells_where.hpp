// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "fields/tensor_array.hpp"
#include "grids/raw_grid.hpp"

namespace tensortopo::detail {

/// Of each piece's cells 1 for those that are taken, else 0.
using CellSelection = std::vector<std::vector<char>>;

/// The cells in which a condition holds at every node: `ReadOptions::where`. It is the name of an
/// array, or an expression as `vtkExprTkFunctionParser` takes it, of the file's arrays of one
/// component, of `x`, `y`, `z`, and of `magnitude`, `deviator_magnitude`, `anisotropy` and `mode`
/// of the tensors. An array of the file hides a quantity of the same name.
/// @param pieces  with their cells, as the file has them
/// @param choice, tensors  as read; null and none if no tensors are
/// Throws IoError (inapplicable) for what is no condition.
CellSelection cells_where(const std::vector<RawGrid>& pieces, const std::string& condition,
                          const TensorChoice* choice,
                          const std::vector<std::vector<SymmetricTensor<double>>>& tensors);

}  // namespace tensortopo::detail
