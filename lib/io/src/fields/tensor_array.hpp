// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "grids/raw_grid.hpp"
#include "tensortopo/io/read_mesh.hpp"

namespace tensortopo::detail {

/// Which array of a file is the tensor.
struct TensorChoice {
  std::string name;
  std::size_t components;  ///< 6 or 9
  bool on_cells;
  TensorComponents taken;
  CellValues values = CellValues::one;  ///< if on cells
  std::size_t per_cell = 1;             ///< tensors, one after the other
  std::string note = "";                ///< of tensors that were not taken, or empty
};

/// The array asked for, or the only candidate. Throws IoError with the arrays that there are.
/// Arrays that `options.tensor` joins are added to the grids.
TensorChoice choose_tensor(std::vector<RawGrid>& grids, const ReadOptions& options);

/// The tensors of one grid, finite, in our order: of each point, or `per_cell` of each cell. Counts
/// those that were not symmetric.
/// Throws IoError.
std::vector<SymmetricTensor<double>> read_tensors(const RawGrid& grid, const TensorChoice& choice,
                                                  const ReadOptions& options,
                                                  std::size_t& symmetrized);

}  // namespace tensortopo::detail
