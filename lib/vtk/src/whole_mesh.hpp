// SPDX-FileCopyrightText: the tensortopo authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ranks.hpp"
#include "tensor_grid.hpp"

namespace tensortopo::filters {

/// What all ranks know of the mesh whose pieces they have.
struct WholeMesh {
  std::int64_t tets = 0;  ///< that they own
  /// Of each rank, as `owned_ids_of`.
  std::vector<std::vector<std::array<std::int64_t, 2>>> owned_ids;
};

/// Requires that the ranks own each tetrahedron once and have the ghosts around those that they
/// own. All ranks call it, and it throws std::exception on all or none.
/// @param expected  how many tetrahedra the whole mesh has, or 0 if that is not known
WholeMesh require_whole_mesh(const TensorGrid& grid, const Ranks& ranks, std::int64_t expected);

}  // namespace tensortopo::filters
